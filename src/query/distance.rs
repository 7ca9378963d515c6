//! How far apart two shapes are.

use super::meet;
use super::region::{Region, region};
use crate::num::{Fx, Raw, Vec2, div_sqrt, isqrt64, usqr};
use crate::shape::{Aabb, Circle, Segment};

/// The distance between two shapes, or to a point.
///
/// The exact distance rounded down to a raw unit; zero where they touch or overlap, and where they are less than a raw unit apart
/// ([`touches`](super::Touches::touches) tells these cases apart). `a.distance(&b)` is `b.distance(&a)`.
///
/// Cost: at most one square root, about 300 instructions on a Cortex-M0 (500 to 950 for a sloped segment); four to six times that for a
/// sloped segment against a box or a segment. It cannot fail. Points may be anywhere: only to one outside of the
/// [domain](crate::num::DOMAIN) can the distance exceed `Fx`, and it is then `Fx::MAX`.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Circle, Fx, Vec2};
/// let wall = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(16, 16))?;
/// let ball = Circle::new(Vec2::from_ints(19, 20), Fx::from_num(2))?;
/// assert_eq!(ball.distance(&wall), 3); // 5 from the corner, less the radius
/// assert_eq!(wall.distance(&Vec2::from_ints(8, -7)), 7);
/// # Ok::<(), tilesat::RangeError>(())
/// ```
pub trait Distance<B: ?Sized> {
    /// The distance to `b`, rounded down; zero where the two touch.
    #[must_use]
    fn distance(&self, b: &B) -> Fx;
}

/// The gap between two intervals; 0 where they meet. Below 2^32 for any point against a shape.
const fn apart(alo: i32, ahi: i32, blo: i32, bhi: i32) -> u32 {
    if ahi < blo {
        ahi.abs_diff(blo)
    } else if bhi < alo {
        bhi.abs_diff(alo)
    } else {
        0
    }
}

/// The length of a vector of magnitudes, rounded down.
///
/// One is a shape's coordinate less any `i32` at most, below 2^31 + 2^29: the sum of squares is below 2^64.
const fn hypot(x: u32, y: u32) -> u32 {
    if y == 0 {
        x
    } else if x == 0 {
        y
    } else {
        isqrt64(usqr(x).wrapping_add(usqr(y)))
    }
}

/// Between boxes; points are boxes.
const fn boxes(alo: Raw, ahi: Raw, blo: Raw, bhi: Raw) -> u32 {
    hypot(apart(alo.x, ahi.x, blo.x, bhi.x), apart(alo.y, ahi.y, blo.y, bhi.y))
}

const fn points(a: Raw, b: Raw) -> u32 {
    hypot(a.x.abs_diff(b.x), a.y.abs_diff(b.y))
}

/// From any point to a segment.
const fn to_segment(p: Raw, a: Raw, b: Raw) -> u32 {
    let (lo, hi) = meet::corners(a, b);
    if lo.x == hi.x || lo.y == hi.y {
        return boxes(p, p, lo, hi);
    }
    match region::<true>(p, a, b, false) {
        Region::End(end) => points(p, end),
        Region::Line { cross, len2 } => div_sqrt(cross.unsigned_abs(), len2),
    }
}

/// From a circle whose centre has the given distance. Rounding down commutes with whole numbers: floor(x - r) = floor(x) - r.
const fn from_border(centre: u32, radius: i32) -> Fx {
    let rest = centre.saturating_sub(radius as u32);
    Fx::from_bits(if rest > i32::MAX as u32 { i32::MAX } else { rest as i32 })
}

const fn min(a: u32, b: u32) -> u32 {
    if a < b { a } else { b }
}

/// Where they do not touch, one end or corner realises the distance. The least of rounded values is the rounded least.
const fn segment_box(s: &Segment, lo: Raw, hi: Raw) -> u32 {
    let (a, b) = (s.ra(), s.rb());
    if meet::segment_aabb::<true>(a, b, lo, hi) {
        return 0;
    }
    let ends = min(boxes(a, a, lo, hi), boxes(b, b, lo, hi));
    let left = min(to_segment(lo, a, b), to_segment(Raw { x: lo.x, y: hi.y }, a, b));
    let right = min(to_segment(hi, a, b), to_segment(Raw { x: hi.x, y: lo.y }, a, b));
    min(ends, min(left, right))
}

const fn segments(s: &Segment, t: &Segment) -> u32 {
    let (a, b, p, q) = (s.ra(), s.rb(), t.ra(), t.rb());
    if meet::segment_segment::<true>(a, b, p, q) {
        return 0;
    }
    min(min(to_segment(p, a, b), to_segment(q, a, b)), min(to_segment(a, p, q), to_segment(b, p, q)))
}

/// One ordered pair: the distance of the cores and the radius to take off.
macro_rules! distance {
    ($a:ty, $b:ty, |$x:ident, $y:ident| $core:expr, $radius:expr) => {
        impl Distance<$b> for $a {
            #[inline]
            fn distance(&self, b: &$b) -> Fx {
                let ($x, $y) = (self, b);
                from_border($core, $radius)
            }
        }
    };
}

/// A pair of different shapes, in both orders.
macro_rules! distance_both {
    ($a:ty, $b:ty, |$x:ident, $y:ident| $core:expr, $radius:expr) => {
        distance!($a, $b, |$x, $y| $core, $radius);
        distance!($b, $a, |$y, $x| $core, $radius);
    };
}

distance!(Aabb, Vec2, |a, p| boxes(a.lo(), a.hi(), Raw::of(*p), Raw::of(*p)), 0);
distance!(Circle, Vec2, |a, p| points(a.c(), Raw::of(*p)), a.r());
distance!(Segment, Vec2, |a, p| to_segment(Raw::of(*p), a.ra(), a.rb()), 0);
distance!(Aabb, Aabb, |a, b| boxes(a.lo(), a.hi(), b.lo(), b.hi()), 0);
distance!(Circle, Circle, |a, b| points(a.c(), b.c()), a.r().wrapping_add(b.r()));
distance!(Segment, Segment, |a, b| segments(a, b), 0);
distance_both!(Circle, Aabb, |a, b| boxes(a.c(), a.c(), b.lo(), b.hi()), a.r());
distance_both!(Circle, Segment, |a, b| to_segment(a.c(), b.ra(), b.rb()), a.r());
distance_both!(Segment, Aabb, |a, b| segment_box(a, b.lo(), b.hi()), 0);
