//! The position of the origin relative to the sum of two shapes: inside, before a side or before a
//! corner.

use super::walk::{Core, Corner, PolygonSide, SideWalk, turn};
use crate::num::{div_sqrt, isqrt64, less128, mul64, sqr64, usqr};

/// The part of the sum's border that is nearest to the origin, the radii left aside.
#[derive(Clone, Copy, Debug)]
pub(super) enum NearestPart {
    /// Inside; not on the border.
    Inside,
    /// Before a side, or on it: at this distance times the side's length.
    Side(PolygonSide, u64),
    /// Before a corner, or on it where the sum is a point.
    Corner(Corner),
}

impl NearestPart {
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

/// The nearest corner so far, at the ends of sides that the origin is before but not beside.
pub(super) struct NearestCorner(Option<(u64, Corner)>);

impl NearestCorner {
    pub(super) const fn none() -> Self {
        Self(None)
    }

    /// Adds a side that the origin is before, at this height. Returns the place if the side has the
    /// foot of the origin.
    pub(super) fn add(&mut self, side: &PolygonSide, height: u64, end: (usize, usize)) -> Option<NearestPart> {
        let along = side.along();
        let corner = if along < 0 {
            Corner { at: side.from, a: side.a, b: side.b }
        } else if along as u64 > side.len2() {
            Corner { at: side.from.add(side.edge), a: end.0, b: end.1 }
        } else {
            return Some(NearestPart::Side(*side, height));
        };
        let square = corner.at.len2();
        if self.0.is_none_or(|(least, _)| square < least) {
            self.0 = Some((square, corner));
        }
        None
    }

    pub(super) fn place(self) -> NearestPart {
        self.0.map_or(NearestPart::Inside, |(_, corner)| NearestPart::Corner(corner))
    }
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
