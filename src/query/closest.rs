//! The points of two shapes that are nearest to each other, and how far apart they are.

use super::meet;
use super::meet::{Region, clamp, corners, region};
use super::overlap::Touches;
use crate::num::{Fx, Raw, Vec2, div_sqrt, isqrt64, mul128, on_circle, scaled, sqr64, toward, usqr};
use crate::shape::{Aabb, Circle, Segment};

/// The nearest points of two shapes that are apart.
///
/// `Some((a, b))`: a point of A and one of B whose distance is the distance of the shapes. Each
/// component is rounded to nearest, so a point may be half a raw unit off its shape. `None` if the
/// shapes touch or overlap; ask [`contact`](super::Contacts::contact) then. In the order (B, A) the
/// result has the same two points, exchanged.
///
/// If two parallel sides make many pairs equally near, a rule decides. Between boxes (and segments
/// along x or y) the result is the middle of the facing parts, half a raw unit rounded down.
/// Between sloped segments it is the lexicographically first end and its opposite.
///
/// Cost: comparisons for boxes; a few thousand instructions on a Cortex-M0 for circles and sloped
/// segments. It cannot fail.
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
    /// The nearest points of this shape and of `b`; `None` if the shapes touch.
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

/// The foot of `p` on a line with direction `e`: `p` less the normal `(-e.y, e.x)` times
/// `cross / len2`.
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

/// A circle and a point outside it.
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
            // The direction to the foot is known exactly. The rounded foot is not on it.
            let e = b.sub(a);
            let (x, y) = if cross > 0 { (e.y, e.x.wrapping_neg()) } else { (e.y.wrapping_neg(), e.x) };
            (c.add(toward(Raw { x, y }, r)), foot(c, e, cross, len2))
        }
    }
}

/// An end or corner of one shape, and the square of its distance to the other.
#[derive(Clone, Copy)]
struct ClosestVertex {
    vertex: Raw,
    square: Square,
    of_first: bool,
}

impl ClosestVertex {
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

    /// The nearer one; in a tie, which is either the same pair of points or one of many between
    /// parallels, the first lexicographically.
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
    let corner = |x, y| ClosestVertex::to_segment(Raw { x, y }, a, b, false);
    let ends = ClosestVertex::to_box(a, lo, hi, true).or(ClosestVertex::to_box(b, lo, hi, true));
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
    let first = ClosestVertex::to_segment(a, p, q, true).or(ClosestVertex::to_segment(b, p, q, true));
    let second = ClosestVertex::to_segment(p, a, b, false).or(ClosestVertex::to_segment(q, a, b, false));
    let best = first.or(second);
    let v = best.vertex;
    if best.of_first { (v, on_segment(v, p, q)) } else { (on_segment(v, a, b), v) }
}

/// Implements one ordered pair, from a test that they touch and a kernel for shapes that do not.
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

/// A pair of different shapes, in both orders. The points come in the order of the shapes, so
/// `both_orders` is not enough.
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

impl Circle {
    /// The point of the disc that is nearest to `p`: `p` itself if it is inside.
    ///
    /// Each component is the exact one rounded to nearest, so the point may be half a raw unit
    /// outside the circle. Mirrored points give mirrored bits. `p` may be anywhere. Cost: two
    /// quotients by a root, some 1150 instructions on a Cortex-M0.
    ///
    /// ```
    /// use tilesat::{Circle, Fx, Vec2};
    /// let ball = Circle::new(Vec2::from_ints(0, 0), Fx::from_num(5))?;
    /// assert_eq!(ball.closest_point(Vec2::from_ints(6, -8)), Vec2::from_ints(3, -4));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub const fn closest_point(&self, p: Vec2) -> Vec2 {
        on_disc(Raw::of(p), self.c(), self.r()).vec2()
    }
}

impl Segment {
    /// The point of the segment that is nearest to `p`.
    ///
    /// Each component is the exact one rounded to nearest, halves toward `p`, so the point may be
    /// half a raw unit off the segment. Reversing the segment changes nothing, and mirrored points
    /// give mirrored bits. `p` may be anywhere. The point is exact and cheap for segments along x
    /// or y, or if an end is nearest. Otherwise it takes two long divisions, some 2000 instructions
    /// on a Cortex-M0.
    ///
    /// ```
    /// use tilesat::{Segment, Vec2};
    /// let slope = Segment::new(Vec2::from_ints(0, 0), Vec2::from_ints(20, 10))?;
    /// assert_eq!(slope.closest_point(Vec2::from_ints(5, 15)), Vec2::from_ints(10, 5));
    /// assert_eq!(slope.closest_point(Vec2::from_ints(-3, 0)), slope.a());
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub const fn closest_point(&self, p: Vec2) -> Vec2 {
        on_segment(Raw::of(p), self.ra(), self.rb()).vec2()
    }
}

/// The square of a length as an exact fraction: `num / den`, num as `(high, low)`, den not zero.
#[derive(Clone, Copy)]
pub(super) struct Square {
    pub(super) num: (u64, u64),
    pub(super) den: u64,
}

impl Square {
    /// Whether this is less than `rhs`: cross-multiplied, exact in 192 bits.
    #[inline(never)]
    pub(super) const fn less(self, rhs: Self) -> bool {
        let (a, b) = (mul128(self.num, rhs.den), mul128(rhs.num, self.den));
        if a.0 != b.0 {
            return a.0 < b.0;
        }
        if a.1 == b.1 { a.2 < b.2 } else { a.1 < b.1 }
    }
}

/// The distance between two shapes, or to a point.
///
/// The exact distance is rounded down to a raw unit. It is zero if the shapes touch or overlap, or
/// are less than a raw unit apart; [`touches`](super::Touches::touches) distinguishes these cases.
/// `a.distance(&b)` is `b.distance(&a)`.
///
/// Cost: at most one square root. It takes about 300 instructions on a Cortex-M0, and 500 to 950
/// for a sloped segment. A sloped segment against a box or a segment takes four to six times that.
/// It cannot fail. Points may be anywhere. The distance to a point outside the
/// [domain](crate::num::DOMAIN) may exceed `Fx`, and is then `Fx::MAX`.
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
    /// The distance to `b`, rounded down; zero if the two touch.
    #[must_use]
    #[doc(alias = "separation")]
    fn distance(&self, b: &B) -> Fx;
}

/// The gap between two intervals; 0 if they meet. Below 2^32 for any point against a shape.
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
/// One is a shape's coordinate less any `i32` at most, below 2^31 + 2^29: the sum of squares is
/// below 2^64.
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
const fn boxes_apart(alo: Raw, ahi: Raw, blo: Raw, bhi: Raw) -> u32 {
    hypot(apart(alo.x, ahi.x, blo.x, bhi.x), apart(alo.y, ahi.y, blo.y, bhi.y))
}

const fn points(a: Raw, b: Raw) -> u32 {
    hypot(a.x.abs_diff(b.x), a.y.abs_diff(b.y))
}

/// From any point to a segment.
pub(super) const fn to_segment(p: Raw, a: Raw, b: Raw) -> u32 {
    let (lo, hi) = meet::corners(a, b);
    if lo.x == hi.x || lo.y == hi.y {
        return boxes_apart(p, p, lo, hi);
    }
    match region::<true>(p, a, b, false) {
        Region::End(end) => points(p, end),
        Region::Line { cross, len2 } => div_sqrt(cross.unsigned_abs(), len2),
    }
}

/// From a circle whose centre has the given distance. Rounding down commutes with whole numbers:
/// floor(x - r) = floor(x) - r.
pub(super) const fn from_border(centre: u32, radius: i32) -> Fx {
    let rest = centre.saturating_sub(radius as u32);
    Fx::from_bits(if rest > i32::MAX as u32 { i32::MAX } else { rest as i32 })
}

const fn min(a: u32, b: u32) -> u32 {
    if a < b { a } else { b }
}

/// If they do not touch, one end or corner has the distance. The least of rounded values is the
/// rounded least.
const fn segment_box(s: &Segment, lo: Raw, hi: Raw) -> u32 {
    let (a, b) = (s.ra(), s.rb());
    if meet::segment_aabb::<true>(a, b, lo, hi) {
        return 0;
    }
    let ends = min(boxes_apart(a, a, lo, hi), boxes_apart(b, b, lo, hi));
    let left = min(to_segment(lo, a, b), to_segment(Raw { x: lo.x, y: hi.y }, a, b));
    let right = min(to_segment(hi, a, b), to_segment(Raw { x: hi.x, y: lo.y }, a, b));
    min(ends, min(left, right))
}

const fn segments_apart(s: &Segment, t: &Segment) -> u32 {
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

distance!(Aabb, Vec2, |a, p| boxes_apart(a.lo(), a.hi(), Raw::of(*p), Raw::of(*p)), 0);
distance!(Circle, Vec2, |a, p| points(a.c(), Raw::of(*p)), a.r());
distance!(Segment, Vec2, |a, p| to_segment(Raw::of(*p), a.ra(), a.rb()), 0);
distance!(Aabb, Aabb, |a, b| boxes_apart(a.lo(), a.hi(), b.lo(), b.hi()), 0);
distance!(Circle, Circle, |a, b| points(a.c(), b.c()), a.r().wrapping_add(b.r()));
distance!(Segment, Segment, |a, b| segments_apart(a, b), 0);
both_orders!(distance: Circle, Aabb, |a, b| boxes_apart(a.c(), a.c(), b.lo(), b.hi()), a.r());
both_orders!(distance: Circle, Segment, |a, b| to_segment(a.c(), b.ra(), b.rb()), a.r());
both_orders!(distance: Segment, Aabb, |a, b| segment_box(a, b.lo(), b.hi()), 0);
