//! Convex shapes against the solid of a segment map, by the rules of boxes and circles: the
//! segments first, then one point of the shape.

use super::overlap::Spoke;
use super::{Kind, Seg, SegmentMap};
use crate::num::{Raw, less128, mul64};
use crate::world::convex::ConvexBody;

impl SegmentMap<'_> {
    pub(super) fn convex_meets<const CLOSED: bool>(&self, body: &ConvexBody<'_>) -> bool {
        let (core, lo, hi) = (body.core, body.bounds.lo(), body.bounds.hi());
        let seen = |i: usize| core.corner(i).sub(body.offset);
        if core.radius == 0 && !CLOSED {
            if body.as_box().is_some() {
                return self.thin_overlaps(lo, hi);
            }
            if core.corners.len() == 2 {
                return self.line_inside(seen(0), seen(1));
            }
        }
        let range = if CLOSED { self.cells(lo, hi) } else { self.open_cells(lo, hi) };
        let meets = |seg: &Seg| seg.kind != Kind::OneWay && body.meets::<CLOSED, 2>([seg.a, seg.b()]);
        if self.any(range, meets) {
            return true;
        }
        let p = seen(0);
        let beside = self.winding_beside(p);
        if core.radius > 0 || core.corners.len() < 3 {
            return beside > 0;
        }
        // No segment leads from a corner into the shape. So all between the corner's sides is as
        // solid as their middle.
        let (next, last) = (seen(1), seen(core.before(0)));
        self.winding_toward(p, beside, next.sub(p).add(last.sub(p)), true) > 0
    }

    /// The winding number just ahead of a point in a direction, below 2^31 per component. It is
    /// that on the left of a segment that leaves the point in this direction, or on its right.
    fn winding_toward(&self, p: Raw, beside: i32, dir: Raw, on_left: bool) -> i32 {
        let way = Spoke { dir, change: 0 };
        let passed = |ray: &Spoke| ray.up_to(&way) && (on_left || !way.up_to(ray));
        self.spokes(p).filter(passed).fold(beside, |w, ray| w.wrapping_add(ray.change))
    }

    /// Whether the inside of the solid has a point between two points. Then both sides of the line
    /// are solid, at its start or after a crossing.
    ///
    /// Cost: the square of the number of the level's segments. It is used only for shapes without
    /// area that are not along x or y.
    fn line_inside(&self, p: Raw, q: Raw) -> bool {
        let (way, beside) = (q.sub(p), self.winding_beside(p));
        let start = [true, false].map(|on_left| self.winding_toward(p, beside, way, on_left));
        let sides = |after: Option<&Crossed>| {
            let crossed = |i: usize| {
                self.crossings(p, way)
                    .filter(|cut| after.is_some_and(|after| !after.is_before(cut)))
                    .fold(start.get(i).copied().unwrap_or(0), |w, cut| {
                        w.wrapping_add(cut.change.get(i).copied().unwrap_or(0))
                    })
            };
            crossed(0) > 0 && crossed(1) > 0
        };
        sides(None) || self.crossings(p, way).any(|cut| sides(Some(&cut)))
    }

    fn crossings(&self, p: Raw, way: Raw) -> impl Iterator<Item = Crossed> {
        (0..self.count()).filter_map(move |index| Crossed::of(&self.segment(index), p, way))
    }
}

/// Where a segment crosses the left or the right side of a line between its ends: after `num /
/// den`.
struct Crossed {
    num: u64,
    den: u64,
    /// The changes of the winding numbers on the left and on the right.
    change: [i32; 2],
}

impl Crossed {
    /// Products of differences are below 2^61, of two of these below 2^122.
    fn of(seg: &Seg, p: Raw, way: Raw) -> Option<Self> {
        if seg.kind != Kind::Solid {
            return None;
        }
        let (a, b) = (seg.a.sub(p), seg.b().sub(p));
        let (s, t) = (way.cross(a), way.cross(b));
        let (left, right) = ((s > 0) != (t > 0), (s < 0) != (t < 0));
        let (den, num) = (s.wrapping_sub(t), a.cross(b.sub(a)));
        if den == 0 || !(left || right) {
            return None;
        }
        // From left to right the solid, on the segment's left, is ahead. The way's parameter is a x
        // e / way x e.
        let sign = den.signum() as i32;
        let num = if den > 0 { num.wrapping_neg() } else { num };
        let den = den.unsigned_abs();
        (num > 0 && (num as u64) < den).then_some(Self {
            num: num as u64,
            den,
            change: [sign * i32::from(left), sign * i32::from(right)],
        })
    }

    fn is_before(&self, o: &Self) -> bool {
        less128(mul64(self.num, o.den), mul64(o.num, self.den))
    }
}
