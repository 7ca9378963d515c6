//! The position of the origin relative to the sum of two shapes: inside, before a side or before a
//! corner.

use super::boxes::Parallelogram;
use super::short_sides::shortly;
use super::walk::{Core, Corner, PolygonSide, SideWalk, turn};
use crate::num::{Raw, SPLIT, Vec2, div_sqrt, isqrt64, less128, mul64, sqr64, usqr};
use crate::query::meet::{circle_circle, circle_segment, segment_segment};
use crate::shape::Aabb;

/// The part of the sum's border that is nearest to the origin, the radii left aside.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    /// Inside; not on the border.
    Inside,
    /// Before a side, or on it: at this distance times the side's length.
    Side(PolygonSide, u64),
    /// Before a corner, or on it where the sum is a point.
    Corner(Corner),
}

impl Place {
    pub(super) fn of(a: Core<'_>, b: Core<'_>) -> Self {
        let mut walk = SideWalk::new(a, b);
        let start = walk.corner();
        let mut nearest: Option<(u64, Corner)> = None;
        let mut flat = true;
        while let Some(side) = walk.next() {
            flat = false;
            let height = side.height();
            if height > 0 {
                continue;
            }
            // Outside this side's line, or on it. The foot is on the side, or one of the side's
            // ends is the nearest point.
            let along = side.along();
            let corner = if along < 0 {
                Corner { at: side.from, a: side.a, b: side.b }
            } else if along as u64 > side.len2() {
                walk.corner()
            } else {
                return Self::Side(side, height.unsigned_abs());
            };
            let square = corner.at.len2();
            if nearest.is_none_or(|(least, _)| square < least) {
                nearest = Some((square, corner));
            }
        }
        match nearest {
            Some((_, corner)) => Self::Corner(corner),
            None if flat => Self::Corner(start),
            None => Self::Inside,
        }
    }

    /// Whether the origin is nearer than `radius` (or as near, for closed sets); radii are below
    /// 2^30.
    ///
    /// A height is below 2^62 and a square length below 2^63: both sides are below 2^124.
    pub(super) fn within<const CLOSED: bool>(&self, radius: i32) -> bool {
        let (square, limit) = match self {
            Self::Inside => return true,
            Self::Side(side, height) => (sqr64(*height), mul64(usqr(radius as u32), side.len2())),
            Self::Corner(corner) => ((0, corner.at.len2()), (0, usqr(radius as u32))),
        };
        if CLOSED { !less128(limit, square) } else { less128(square, limit) }
    }

    /// The distance of the origin, rounded down.
    pub(super) fn distance(&self) -> u32 {
        match self {
            Self::Inside => 0,
            Self::Side(side, height) => div_sqrt(*height, side.len2()),
            Self::Corner(corner) => isqrt64(corner.at.len2()),
        }
    }
}

/// Whether two shapes overlap, or touch: exact.
pub(crate) fn meets<const CLOSED: bool>(a: Core<'_>, b: Core<'_>) -> bool {
    meets_in::<CLOSED>(a, b, None)
}

/// The same. A caller that knows the bounding boxes, and that they meet, passes them.
pub(super) fn meets_in<const CLOSED: bool>(a: Core<'_>, b: Core<'_>, boxes: Option<&(Aabb, Aabb)>) -> bool {
    let radius = a.radius.wrapping_add(b.radius);
    if radius == 0 {
        if let (Some(p), Some(q)) = (Parallelogram::of(a), Parallelogram::of(b)) {
            return p.meets::<CLOSED>(&q);
        }
    }
    if radius != 0 {
        return corners_meet::<CLOSED>(a, b, radius) || Place::of(a, b).within::<CLOSED>(radius);
    }
    let settled = if SPLIT { boxes.and_then(|boxes| shortly(a, b, boxes)) } else { None };
    settled.unwrap_or_else(|| sharp::<CLOSED>(a, b).is_ok())
}

/// Whether two of the corners are near enough: so it is for most that overlap and have few of them.
pub(super) fn corners_meet<const CLOSED: bool>(a: Core<'_>, b: Core<'_>, radius: i32) -> bool {
    let near = |p: &Vec2, q: &Vec2| circle_circle::<CLOSED>(Raw::of(*p), Raw::of(*q), radius);
    a.corners.len().wrapping_add(b.corners.len()) <= 4 && a.corners.iter().any(|p| b.corners.iter().any(|q| near(p, q)))
}

/// Whether two segments are nearer than the radius, or as near. Where they do not cross, an end of
/// one is the nearest point to the other: for most that overlap, to an end of it.
pub(super) fn capsules_meet<const CLOSED: bool>([p, q]: [Raw; 2], [s, t]: [Raw; 2], radius: i32) -> bool {
    let near_end = |p: Raw, q: Raw| circle_circle::<CLOSED>(p, q, radius);
    let near = |end: Raw, a: Raw, b: Raw| circle_segment::<CLOSED>(end, radius, a, b);
    near_end(p, s)
        || near_end(p, t)
        || near_end(q, s)
        || near_end(q, t)
        || near(p, s, t)
        || near(q, s, t)
        || near(s, p, q)
        || near(t, p, q)
        || segment_segment::<false>(p, q, s, t)
}

/// Whether two shapes without radii overlap, or touch: the first side that the origin is not inside
/// of settles it, and is the error. A point has none.
pub(super) fn sharp<const CLOSED: bool>(a: Core<'_>, b: Core<'_>) -> Result<(), Option<PolygonSide>> {
    let walk = SideWalk::new(a, b);
    let mut inside = CLOSED && walk.corner().at.is_zero();
    for side in walk {
        let height = turn(side.edge, side.from.reversed());
        if height < 0 {
            return Err(Some(side));
        }
        // On the line of a side: a closed sum contains the points between its ends. A flat sum has
        // no other sides that would exclude the rest.
        if height == 0 && (!CLOSED || side.along() < 0 || side.along() as u64 > side.len2()) {
            return Err(Some(side));
        }
        inside = true;
    }
    if inside { Ok(()) } else { Err(None) }
}
