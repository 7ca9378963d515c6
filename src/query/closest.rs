//! The points of two shapes that are nearest to each other.

use super::fraction::Square;
use super::meet::{self, clamp, corners};
use super::overlap::Touches;
use super::region::{Region, region};
use super::round::{on_circle, scaled, toward};
use crate::num::{Raw, Vec2, sqr64, usqr};
use crate::shape::{Aabb, Circle, Segment};

/// The nearest points of two shapes that are apart.
///
/// `Some((a, b))`: a point of A and one of B whose distance is the distance of the shapes, each component rounded to nearest: a point
/// may be half a raw unit off its shape. `None` where the shapes touch or overlap; ask
/// [`contact`](super::Contacts::contact) then. In the order (B, A) the same two points are given, exchanged.
///
/// Where two parallel sides make many pairs as near: between boxes (and segments along x or y) the middle of what faces each
/// other, half a raw unit rounded down; between sloped segments the end that comes first lexicographically and its opposite.
///
/// Cost: a cold path, a few thousand instructions on a Cortex-M0 for circles and sloped segments, comparisons for boxes. It cannot fail.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Circle, Fx, Vec2};
/// let wall = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(16, 16))?;
/// let ball = Circle::new(Vec2::from_ints(22, 24), Fx::from_num(5))?;
/// assert_eq!(ball.closest_points(&wall), Some((Vec2::from_ints(19, 20), Vec2::from_ints(16, 16))));
/// assert_eq!(wall.closest_points(&wall), None);
/// # Ok::<(), tilesat::RangeError>(())
/// ```
pub trait ClosestPoint<B: ?Sized> {
    /// A point of this shape and one of `b` that are as near as the shapes are; `None` where those touch.
    #[must_use]
    fn closest_points(&self, b: &B) -> Option<(Vec2, Vec2)>;
}

/// The point of a segment nearest to any point.
pub(crate) const fn on_segment(p: Raw, a: Raw, b: Raw) -> Raw {
    let (lo, hi) = corners(a, b);
    if lo.x == hi.x || lo.y == hi.y {
        return clamp(p, lo, hi);
    }
    match region::<true>(p, a, b, false) {
        Region::End(end) => end,
        Region::Line { cross, len2 } => foot(p, b.sub(a), cross, len2),
    }
}

/// The foot of `p` on a line with direction `e`: `p` less the normal `(-e.y, e.x)` times `cross / len2`.
const fn foot(p: Raw, e: Raw, cross: i64, len2: u64) -> Raw {
    Raw { x: p.x.wrapping_add(scaled(e.y, cross, len2)), y: p.y.wrapping_sub(scaled(e.x, cross, len2)) }
}

/// The point of a disc nearest to any point.
pub(crate) const fn on_disc(p: Raw, c: Raw, r: i32) -> Raw {
    let (x, y) = (p.x.abs_diff(c.x), p.y.abs_diff(c.y));
    if meet::in_disc::<true>(x, y, r as u32) {
        return p;
    }
    // Not zero, and below 2^64: a component is below 2^31 + 2^29.
    let d = usqr(x).wrapping_add(usqr(y));
    let (x, y) = (on_circle(x, r as u32, d) as i32, on_circle(y, r as u32, d) as i32);
    Raw {
        x: if p.x < c.x { c.x.wrapping_sub(x) } else { c.x.wrapping_add(x) },
        y: if p.y < c.y { c.y.wrapping_sub(y) } else { c.y.wrapping_add(y) },
    }
}

/// The nearest coordinates of two intervals, or the middle of what they have in common, twice.
const fn intervals(alo: i32, ahi: i32, blo: i32, bhi: i32) -> (i32, i32) {
    if ahi < blo {
        (ahi, blo)
    } else if bhi < alo {
        (alo, bhi)
    } else {
        let middle = meet::middle(alo, ahi, blo, bhi);
        (middle, middle)
    }
}

const fn boxes(alo: Raw, ahi: Raw, blo: Raw, bhi: Raw) -> (Raw, Raw) {
    let (ax, bx) = intervals(alo.x, ahi.x, blo.x, bhi.x);
    let (ay, by) = intervals(alo.y, ahi.y, blo.y, bhi.y);
    (Raw { x: ax, y: ay }, Raw { x: bx, y: by })
}

/// A circle and a point outside of it.
const fn disc_and_point(c: Raw, r: i32, p: Raw) -> (Raw, Raw) {
    (c.add(toward(p.sub(c), r)), p)
}

const fn disc_and_segment(c: Raw, r: i32, a: Raw, b: Raw) -> (Raw, Raw) {
    let (lo, hi) = corners(a, b);
    if lo.x == hi.x || lo.y == hi.y {
        return disc_and_point(c, r, clamp(c, lo, hi));
    }
    match region::<false>(c, a, b, false) {
        Region::End(end) => disc_and_point(c, r, end),
        Region::Line { cross, len2 } => {
            // The way to the foot is known exactly as a direction, which the rounded foot is not.
            let e = b.sub(a);
            let (x, y) = if cross > 0 { (e.y, e.x.wrapping_neg()) } else { (e.y.wrapping_neg(), e.x) };
            (c.add(toward(Raw { x, y }, r)), foot(c, e, cross, len2))
        }
    }
}

/// An end or corner of one shape, and the square of its distance to the other.
#[derive(Clone, Copy)]
struct Candidate {
    vertex: Raw,
    square: Square,
    of_first: bool,
}

impl Candidate {
    const fn to_segment(vertex: Raw, a: Raw, b: Raw, of_first: bool) -> Self {
        let square = match region::<false>(vertex, a, b, false) {
            Region::End(end) => Square { num: (0, end.sub(vertex).len2()), den: 1 },
            Region::Line { cross, len2 } => Square { num: sqr64(cross.unsigned_abs()), den: len2 },
        };
        Self { vertex, square, of_first }
    }

    const fn to_box(vertex: Raw, lo: Raw, hi: Raw, of_first: bool) -> Self {
        Self { vertex, square: Square { num: (0, clamp(vertex, lo, hi).sub(vertex).len2()), den: 1 }, of_first }
    }

    /// The nearer one; in a tie, which is either the same pair of points or one of many between parallels, the first lexicographically.
    fn or(self, other: Self) -> Self {
        let first = (self.vertex.x, self.vertex.y) <= (other.vertex.x, other.vertex.y);
        if self.square.less(other.square) || (first && !other.square.less(self.square)) { self } else { other }
    }
}

fn segment_and_box(a: Raw, b: Raw, lo: Raw, hi: Raw) -> (Raw, Raw) {
    let (slo, shi) = corners(a, b);
    if slo.x == shi.x || slo.y == shi.y {
        return boxes(slo, shi, lo, hi);
    }
    let corner = |x, y| Candidate::to_segment(Raw { x, y }, a, b, false);
    let ends = Candidate::to_box(a, lo, hi, true).or(Candidate::to_box(b, lo, hi, true));
    let left = corner(lo.x, lo.y).or(corner(lo.x, hi.y));
    let right = corner(hi.x, lo.y).or(corner(hi.x, hi.y));
    let best = ends.or(left).or(right);
    let v = best.vertex;
    if best.of_first { (v, clamp(v, lo, hi)) } else { (on_segment(v, a, b), v) }
}

fn segments(a: Raw, b: Raw, p: Raw, q: Raw) -> (Raw, Raw) {
    let ((alo, ahi), (blo, bhi)) = (corners(a, b), corners(p, q));
    if (alo.x == ahi.x || alo.y == ahi.y) && (blo.x == bhi.x || blo.y == bhi.y) {
        return boxes(alo, ahi, blo, bhi);
    }
    let first = Candidate::to_segment(a, p, q, true).or(Candidate::to_segment(b, p, q, true));
    let second = Candidate::to_segment(p, a, b, false).or(Candidate::to_segment(q, a, b, false));
    let best = first.or(second);
    let v = best.vertex;
    if best.of_first { (v, on_segment(v, p, q)) } else { (on_segment(v, a, b), v) }
}

/// One ordered pair, from a test that they touch and a kernel for where they do not.
macro_rules! closest {
    ($a:ty, $b:ty, |$x:ident, $y:ident| $points:expr) => {
        impl ClosestPoint<$b> for $a {
            #[inline]
            fn closest_points(&self, b: &$b) -> Option<(Vec2, Vec2)> {
                let ($x, $y) = (self, b);
                (!$x.touches($y)).then(|| {
                    let (a, b): (Raw, Raw) = $points;
                    (a.vec2(), b.vec2())
                })
            }
        }
    };
}

/// A pair of different shapes, in both orders.
macro_rules! closest_both {
    ($a:ty, $b:ty, |$x:ident, $y:ident| $points:expr) => {
        closest!($a, $b, |$x, $y| $points);

        impl ClosestPoint<$a> for $b {
            #[inline]
            fn closest_points(&self, b: &$a) -> Option<(Vec2, Vec2)> {
                b.closest_points(self).map(|(b, a)| (a, b))
            }
        }
    };
}

closest!(Aabb, Aabb, |a, b| boxes(a.lo(), a.hi(), b.lo(), b.hi()));
closest!(Circle, Circle, |a, b| {
    let v = b.c().sub(a.c());
    (a.c().add(toward(v, a.r())), b.c().sub(toward(v, b.r())))
});
closest!(Segment, Segment, |a, b| segments(a.ra(), a.rb(), b.ra(), b.rb()));
closest_both!(Circle, Aabb, |a, b| disc_and_point(a.c(), a.r(), clamp(a.c(), b.lo(), b.hi())));
closest_both!(Circle, Segment, |a, b| disc_and_segment(a.c(), a.r(), b.ra(), b.rb()));
closest_both!(Segment, Aabb, |a, b| segment_and_box(a.ra(), a.rb(), b.lo(), b.hi()));
