//! Whether two boxes in any direction overlap, and by which side they are nearest to apart.

use super::across::across;
use super::margins::{all_meet, exact_margins};
use super::nearness::{Least, Nearness, Unsure};
use super::place::{NearestCorner, NearestPart};
use super::short_boxes;
use super::walk::{Core, PolygonSide};
use crate::num::{LONG, Raw};
use crate::query::contact::Contact;

/// A shape with four corners and two directions: boxes, turned or not.
pub(super) struct Parallelogram {
    u: Raw,
    v: Raw,
    /// Twice the middle.
    middle: Raw,
}

impl Parallelogram {
    /// From two sides of a box and twice its middle.
    pub(super) const fn new([u, v, middle]: [Raw; 3]) -> Self {
        Self { u, v, middle }
    }

    pub(super) fn of(core: Core<'_>) -> Option<Self> {
        let &[p, q, r, s] = core.corners else { return None };
        let [p, q, r, s] = [p, q, r, s].map(Raw::of);
        let middle = p.add(r);
        (middle == q.add(s)).then(|| Self { u: q.sub(p), v: s.sub(p), middle })
    }

    /// One of the corners, counter-clockwise: twice that is an even sum.
    const fn corner(&self, index: usize) -> Raw {
        let (u, v) = (matches!(index, 1 | 2), matches!(index, 2 | 3));
        let twice = if u { self.middle.add(self.u) } else { self.middle.sub(self.u) };
        let twice = if v { twice.add(self.v) } else { twice.sub(self.v) };
        Raw { x: twice.x >> 1, y: twice.y >> 1 }
    }

    pub(super) fn meets<const CLOSED: bool>(&self, other: &Self) -> bool {
        // Below 2^31: twice the distance of two points of the domain, or near it.
        let sides = [self.u, self.v, other.u, other.v, other.middle.sub(self.middle)];
        let settled = if LONG { None } else { short_boxes::meet(sides) };
        settled.unwrap_or_else(|| all_meet::<CLOSED>(sides))
    }
}

/// The side of the sum of two boxes that is nearest to the origin; `None` if they do not overlap.
/// [`Unsure`] if another side is equally near, or nearly so.
///
/// The margin across a side is twice the height of the nearer one of two opposite sides.
pub(super) fn nearest(p: &Parallelogram, q: &Parallelogram) -> Result<Option<PolygonSide>, Unsure> {
    let d = q.middle.sub(p.middle);
    let sides = [p.u, p.v, q.u, q.v];
    let margins = exact_margins([p.u, p.v, q.u, q.v, d]);
    let mut best = Least::new();
    for (k, (side, margin)) in sides.into_iter().zip(margins).enumerate() {
        if margin <= 0 {
            return Ok(None);
        }
        best.add(Nearness::of(margin, side.len2()), || (k, side))?;
    }
    let (k, side) = best.get()?;
    let toward = side.cross(d);
    if toward == 0 {
        return Err(Unsure);
    }
    // No other side is parallel, or it would be equally near.
    Ok(Some(side_toward(p, q, (k, side), toward < 0).0))
}

/// Where the origin is relative to the sum of two boxes; none if sides of both make up one.
pub(super) fn place(p: &Parallelogram, q: &Parallelogram) -> Option<NearestPart> {
    let d = q.middle.sub(p.middle);
    let sides = [p.u, p.v, q.u, q.v];
    let margins = exact_margins([p.u, p.v, q.u, q.v, d]);
    let mut nearest = NearestCorner::none();
    for (k, (side, margin)) in sides.into_iter().zip(margins).enumerate() {
        if margin <= 0 {
            let others = if k < 2 { [q.u, q.v] } else { [p.u, p.v] };
            if others.iter().any(|other| side.cross(*other) == 0) {
                return None;
            }
            let (side, end) = side_toward(p, q, (k, side), side.cross(d) < 0);
            let place = nearest.add(&side, margin.unsigned_abs() >> 1, end);
            if place.is_some() {
                return place;
            }
        }
    }
    Some(nearest.place())
}

/// How two boxes overlap; [`Unsure`] if two sides are equally near, or nearly so.
pub(super) fn contact(p: &Parallelogram, q: &Parallelogram) -> Result<Option<Contact>, Unsure> {
    let side = nearest(p, q)?;
    Ok(side.map(|side| across(&side, p.corner(side.a), q.corner(side.b))))
}

/// One of two opposite sides of the sum, and the corners at which it ends.
///
/// The origin is before that side, or nearer to it than to the opposite one. The sum's middle is on
/// its left. No other sides are parallel to these two.
fn side_toward(
    p: &Parallelogram,
    q: &Parallelogram,
    (k, side): (usize, Raw),
    forward: bool,
) -> (PolygonSide, (usize, usize)) {
    // Those of the reversed B run backward.
    let of_a = k < 2;
    let edge = if forward { side } else { side.reversed() };
    let begin = (k & 1) | usize::from(forward != of_a) << 1;
    let end = (begin + 1) & 3;
    let corner = |u: bool, v: bool| if v { 3 ^ usize::from(u) } else { usize::from(u) };
    let ((i, j), end) = if of_a {
        let j = corner(edge.cross(q.u) > 0, edge.cross(q.v) > 0);
        ((begin, j), (end, j))
    } else {
        let i = corner(edge.cross(p.u) < 0, edge.cross(p.v) < 0);
        ((i, begin), (i, end))
    };
    (PolygonSide { from: p.corner(i).sub(q.corner(j)), edge, a: i, b: j, of_a, of_b: !of_a }, end)
}
