//! The boolean kernels, on raw values: strict if `CLOSED` is false, closed if it is true.

use crate::num::{LONG, Raw, SPLIT, less128, mul64, sqr_signed, usqr};
use core::cmp::Ordering;

/// `a < b`, or `a <= b` for closed sets.
#[inline]
const fn below<const CLOSED: bool>(a: i32, b: i32) -> bool {
    if CLOSED { a <= b } else { a < b }
}

/// [`below`] for squares of distances and of radii.
#[inline(always)]
pub(crate) const fn is_within<const CLOSED: bool>(square: u64, limit: u64) -> bool {
    square < limit || (CLOSED && square == limit)
}

/// Whether two intervals meet. Strict comparison is right for intervals of no length too: they meet
/// an interval that has the point inside.
#[inline]
const fn intervals<const CLOSED: bool>(alo: i32, ahi: i32, blo: i32, bhi: i32) -> bool {
    if CLOSED { alo <= bhi && blo <= ahi } else { alo < bhi && blo < ahi }
}

/// Box against box, each by its corners.
#[inline]
pub(crate) const fn aabb_aabb<const CLOSED: bool>(alo: Raw, ahi: Raw, blo: Raw, bhi: Raw) -> bool {
    if LONG {
        // Four comparisons without a branch; callgrind: 15 instructions instead of 20.
        return (below::<CLOSED>(alo.x, bhi.x) & below::<CLOSED>(blo.x, ahi.x))
            & (below::<CLOSED>(alo.y, bhi.y) & below::<CLOSED>(blo.y, ahi.y));
    }
    intervals::<CLOSED>(alo.x, ahi.x, blo.x, bhi.x) && intervals::<CLOSED>(alo.y, ahi.y, blo.y, bhi.y)
}

/// Whether `(x, y)` lies in the disc of radius `r` (below 2^30) around the origin; the coordinates
/// are magnitudes of any size.
#[inline]
pub(crate) const fn in_disc<const CLOSED: bool>(x: u32, y: u32, r: u32) -> bool {
    let beyond = if CLOSED { x > r || y > r } else { x >= r || y >= r };
    !beyond && in_square::<CLOSED>(x, y, r)
}

/// [`in_disc`] for a point that is known to lie in the square around the disc.
#[inline]
const fn in_square<const CLOSED: bool>(x: u32, y: u32, r: u32) -> bool {
    if SPLIT { by_octagons::<CLOSED>(x, y, r) } else { by_squares::<CLOSED>(x, y, r) }
}

/// An octagon around the circle and one inside it settle 85 % of the square by shifts; for cores
/// whose long product is a call.
#[inline]
pub(super) const fn by_octagons<const CLOSED: bool>(x: u32, y: u32, r: u32) -> bool {
    // With c = 7/16 > sqrt(2) - 1 and x >= y, |v| <= x + c y; the shifts drop fractions that are
    // subtracted, so `above` is not below that.
    let (sum, min) = (x.wrapping_add(y), if x < y { x } else { y });
    let above = sum.wrapping_sub(min >> 1).wrapping_sub(min >> 4);
    if above < r || (CLOSED && above == r) {
        return true;
    }
    // As |v| >= (x + y)/sqrt(2), a point with a sum from `outer` on is outside the closed disc:
    // that is at least 23/16 r > sqrt(2) r for r > 0. r = 0 does not occur here: strict, no square
    // has a point; closed, it was accepted.
    let outer = r.wrapping_add(r.wrapping_add(1) >> 1).wrapping_sub(r >> 4);
    if sum >= outer {
        return false;
    }
    let order = squares_out_of_line(x, y, r);
    order.is_lt() || (CLOSED && order.is_eq())
}

#[inline]
pub(super) const fn by_squares<const CLOSED: bool>(x: u32, y: u32, r: u32) -> bool {
    is_within::<CLOSED>(usqr(x).wrapping_add(usqr(y)), usqr(r))
}

/// One call for both, so the frequent cases need no saved registers.
#[inline(never)]
const fn squares_out_of_line(x: u32, y: u32, r: u32) -> Ordering {
    let (square, limit) = (usqr(x).wrapping_add(usqr(y)), usqr(r));
    if square < limit {
        Ordering::Less
    } else if square == limit {
        Ordering::Equal
    } else {
        Ordering::Greater
    }
}

/// Circle against circle: the point `b - a` against a disc of the sum of the radii.
#[inline]
pub(crate) const fn circle_circle<const CLOSED: bool>(a: Raw, b: Raw, r: i32) -> bool {
    if LONG {
        return is_within::<CLOSED>(b.sub(a).len2(), usqr(r as u32));
    }
    in_disc::<CLOSED>(a.x.abs_diff(b.x), a.y.abs_diff(b.y), r as u32)
}

/// The signed gap of a coordinate to an interval: negative strictly inside, 0 on an end.
#[inline]
pub(crate) const fn gap(c: i32, lo: i32, hi: i32) -> i32 {
    let (left, right) = (lo.wrapping_sub(c), c.wrapping_sub(hi));
    if left > right { left } else { right }
}

/// A gap outside of an interval; 0 inside.
#[inline]
const fn outside(gap: i32) -> i32 {
    if gap > 0 { gap } else { 0 }
}

/// Circle against box. A radius of zero is a point, which needs both gaps negative if strict.
#[inline]
pub(crate) const fn circle_aabb<const CLOSED: bool>(c: Raw, r: i32, lo: Raw, hi: Raw) -> bool {
    let (gx, gy) = (gap(c.x, lo.x, hi.x), gap(c.y, lo.y, hi.y));
    if LONG {
        // Without a branch that a processor predicts wrongly. If half of the pairs hit, this takes
        // a quarter of the time, with 36 instructions instead of 30.
        let square = Raw { x: outside(gx), y: outside(gy) }.len2();
        return is_within::<CLOSED>(square, usqr(r as u32)) || (gx & gy) < 0;
    }
    circle_gaps::<CLOSED>(gx, gy, r)
}

/// [`circle_aabb`] after the gaps.
#[inline]
pub(crate) const fn circle_gaps<const CLOSED: bool>(gx: i32, gy: i32, r: i32) -> bool {
    if !below::<CLOSED>(gx, r) || !below::<CLOSED>(gy, r) {
        return false;
    }
    gx <= 0 || gy <= 0 || in_square::<CLOSED>(gx as u32, gy as u32, r as u32)
}

/// Circle against segment.
#[inline]
pub(crate) const fn circle_segment<const CLOSED: bool>(c: Raw, r: i32, a: Raw, b: Raw) -> bool {
    if LONG {
        return by_region::<CLOSED>(c, r, a, b);
    }
    let (lo, hi) = corners(a, b);
    let (gx, gy) = (gap(c.x, lo.x, hi.x), gap(c.y, lo.y, hi.y));
    if !below::<CLOSED>(gx, r) || !below::<CLOSED>(gy, r) {
        return false;
    }
    if lo.x == hi.x || lo.y == hi.y {
        return circle_gaps::<CLOSED>(gx, gy, r);
    }
    // If a product is cheap, the test that saves two of them is not worth its registers.
    let inside = SPLIT && gx <= 0 && gy <= 0;
    match region::<false>(c, a, b, inside) {
        Region::End(p) => circle_circle::<CLOSED>(c, p, r),
        Region::Line { cross, len2 } => near_line::<CLOSED>(cross, r, len2),
    }
}

/// Circle against segment, relative to the first end. It does not test the bounding box, which
/// takes more than it saves if products are cheap.
#[inline(always)]
const fn by_region<const CLOSED: bool>(c: Raw, r: i32, a: Raw, b: Raw) -> bool {
    let (e, m) = (Offset::between(a, b), Offset::between(a, c));
    let (dot, len2) = (e.dot(m), e.dot(e));
    let square = if dot <= 0 {
        m.len2()
    } else if dot >= len2 {
        let m = m.sub(e);
        m.len2()
    } else {
        return near_line::<CLOSED>(e.cross(m), r, len2 as u64);
    };
    is_within::<CLOSED>(square, usqr(r as u32))
}

/// A difference of two points inside the domain, as wide as a register.
#[cfg(not(all(target_pointer_width = "64", not(tilesat_split))))]
pub(crate) use crate::num::Raw as Offset;

#[cfg(not(all(target_pointer_width = "64", not(tilesat_split))))]
impl Raw {
    #[inline(always)]
    pub(crate) const fn between(from: Self, to: Self) -> Self {
        to.sub(from)
    }

    #[inline(always)]
    pub(crate) const fn of_raw(v: Self) -> Self {
        v
    }

    #[inline(always)]
    pub(crate) const fn raw(self) -> Self {
        self
    }
}

/// A difference of two points inside the domain, as wide as a register. Such a processor loads a
/// word as a double word at no cost, but needs one more instruction to widen a difference.
#[cfg(all(target_pointer_width = "64", not(tilesat_split)))]
#[derive(Clone, Copy)]
pub(crate) struct Offset {
    x: i64,
    y: i64,
}

#[cfg(all(target_pointer_width = "64", not(tilesat_split)))]
impl Offset {
    #[inline(always)]
    pub(crate) const fn between(from: Raw, to: Raw) -> Self {
        Self { x: (to.x as i64).wrapping_sub(from.x as i64), y: (to.y as i64).wrapping_sub(from.y as i64) }
    }

    #[inline(always)]
    pub(crate) const fn sub(self, o: Self) -> Self {
        Self { x: self.x.wrapping_sub(o.x), y: self.y.wrapping_sub(o.y) }
    }

    #[inline(always)]
    pub(crate) const fn add(self, o: Self) -> Self {
        Self { x: self.x.wrapping_add(o.x), y: self.y.wrapping_add(o.y) }
    }

    #[inline(always)]
    pub(crate) const fn reversed(self) -> Self {
        Self { x: self.x.wrapping_neg(), y: self.y.wrapping_neg() }
    }

    #[inline(always)]
    pub(crate) const fn dot(self, o: Self) -> i64 {
        self.x.wrapping_mul(o.x).wrapping_add(self.y.wrapping_mul(o.y))
    }

    #[inline(always)]
    pub(crate) const fn cross(self, o: Self) -> i64 {
        self.x.wrapping_mul(o.y).wrapping_sub(self.y.wrapping_mul(o.x))
    }

    #[inline(always)]
    pub(crate) const fn of_raw(v: Raw) -> Self {
        Self { x: v.x as i64, y: v.y as i64 }
    }

    #[inline(always)]
    pub(crate) const fn len2(self) -> u64 {
        self.dot(self) as u64
    }

    /// Below 2^30 in size, as each difference of two points.
    #[inline(always)]
    pub(crate) const fn raw(self) -> Raw {
        Raw { x: self.x as i32, y: self.y as i32 }
    }
}

/// Whether a point is nearer to a line than `r`, or as near where `CLOSED`.
///
/// `cross` is the cross product of a vector along the line and one to the point. It is below 2^61,
/// so its square and `r^2 len2` are below 2^122.
#[inline(always)]
pub(crate) const fn near_line<const CLOSED: bool>(cross: i64, r: i32, len2: u64) -> bool {
    let (square, limit) = (sqr_signed(cross), mul64(usqr(r as u32), len2));
    if CLOSED { !less128(limit, square) } else { less128(square, limit) }
}

/// The corners of a segment's bounding box.
#[inline]
pub(crate) const fn corners(a: Raw, b: Raw) -> (Raw, Raw) {
    let (lx, hx) = if a.x < b.x { (a.x, b.x) } else { (b.x, a.x) };
    let (ly, hy) = if a.y < b.y { (a.y, b.y) } else { (b.y, a.y) };
    (Raw { x: lx, y: ly }, Raw { x: hx, y: hy })
}

/// The middle of what two intervals have in common. The half raw unit of an odd sum is rounded
/// down: this is the one value that a mirrored scene does not mirror.
#[inline]
pub(crate) const fn middle(alo: i32, ahi: i32, blo: i32, bhi: i32) -> i32 {
    let (lo, hi) = (if alo > blo { alo } else { blo }, if ahi < bhi { ahi } else { bhi });
    lo.wrapping_add(hi) >> 1
}

/// The point of a box that is nearest to `p`.
#[inline]
pub(crate) const fn clamp(p: Raw, lo: Raw, hi: Raw) -> Raw {
    let x = if p.x < lo.x { lo.x } else { p.x };
    let y = if p.y < lo.y { lo.y } else { p.y };
    Raw { x: if x > hi.x { hi.x } else { x }, y: if y > hi.y { hi.y } else { y } }
}

/// The least and the largest cross product of `e` (not axis-parallel) with the corners of a box,
/// relative to `a`.
#[inline]
pub(crate) const fn cross_range(a: Raw, e: Raw, lo: Raw, hi: Raw) -> (i64, i64) {
    // e.x y - e.y x grows with y where e.x > 0 and falls with x where e.y > 0.
    let (y0, y1) = if e.x > 0 { (lo.y, hi.y) } else { (hi.y, lo.y) };
    let (x0, x1) = if e.y > 0 { (hi.x, lo.x) } else { (lo.x, hi.x) };
    (e.cross(Raw { x: x0, y: y0 }.sub(a)), e.cross(Raw { x: x1, y: y1 }.sub(a)))
}

/// Segment against box: separating axes x, y and the segment's normal.
#[inline]
pub(crate) const fn segment_aabb<const CLOSED: bool>(a: Raw, b: Raw, lo: Raw, hi: Raw) -> bool {
    let (slo, shi) = corners(a, b);
    if !aabb_aabb::<CLOSED>(slo, shi, lo, hi) {
        return false;
    }
    let e = b.sub(a);
    if e.x == 0 || e.y == 0 {
        return true;
    }
    // A box of no size gives min = max, and a strict test that no value passes: its sum with a
    // segment has no inside.
    let (min, max) = cross_range(a, e, lo, hi);
    if CLOSED { min <= 0 && max >= 0 } else { min < 0 && max > 0 }
}

/// Segment against segment. Strict: a proper crossing. Closed: the axes x and y are needed for
/// collinear segments only.
#[inline]
pub(crate) const fn segment_segment<const CLOSED: bool>(a0: Raw, a1: Raw, b0: Raw, b1: Raw) -> bool {
    // Segments that cross properly do not need the test of the boxes, which only saves products.
    if CLOSED || !LONG {
        let ((alo, ahi), (blo, bhi)) = (corners(a0, a1), corners(b0, b1));
        if !aabb_aabb::<true>(alo, ahi, blo, bhi) {
            return false;
        }
    }
    straddles::<CLOSED>(a0, a1, b0, b1) && straddles::<CLOSED>(b0, b1, a0, a1)
}

/// Whether `p` and `q` are on different sides of the line through `a` and `b`; one call where a
/// product is one already.
#[inline(always)]
const fn straddles<const CLOSED: bool>(a: Raw, b: Raw, p: Raw, q: Raw) -> bool {
    if LONG { on_both_sides::<CLOSED>(a, b, p, q) } else { straddles_call::<CLOSED>(a, b, p, q) }
}

#[inline(never)]
const fn straddles_call<const CLOSED: bool>(a: Raw, b: Raw, p: Raw, q: Raw) -> bool {
    on_both_sides::<CLOSED>(a, b, p, q)
}

#[inline(always)]
const fn on_both_sides<const CLOSED: bool>(a: Raw, b: Raw, p: Raw, q: Raw) -> bool {
    let e = b.sub(a);
    let (s, t) = (e.cross(p.sub(a)), e.cross(q.sub(a)));
    if CLOSED { (s <= 0 && t >= 0) || (s >= 0 && t <= 0) } else { (s < 0 && t > 0) || (s > 0 && t < 0) }
}

/// The part of a segment that is nearest to a point.
#[derive(Clone, Copy)]
pub(crate) enum Region {
    /// This end; equal ends have no other region.
    End(Raw),
    /// A point between the ends.
    Line {
        /// The cross product of the edge with the vector from its first end to the point: distance
        /// times length, positive on the left (y up).
        cross: i64,
        /// The square of the edge's length, not zero.
        len2: u64,
    },
}

/// The region of `p` before the segment from `a` to `b`. Where `inside` is set, the segment is not
/// a point.
///
/// `FAR` allows any `p`; otherwise it must be inside the domain. The products with `p` itself are
/// below 2^62, and those with `a` below 2^60. So the difference is exact in 64 bits, even where
/// `p - a` needs 33.
///
/// `inside` says that `p` is known to be in the segment's bounding box. Then both products of the
/// dot product have the sign of a square, and neither exceeds that square. So the foot is between
/// the ends, or at one of them.
#[inline]
pub(crate) const fn region<const FAR: bool>(p: Raw, a: Raw, b: Raw, inside: bool) -> Region {
    let e = b.sub(a);
    // Where a signed product is as cheap as an unsigned one, magnitudes are not needed.
    let len2 = if SPLIT { e.len2() } else { e.dot(e) as u64 };
    if !inside {
        let dot = if FAR { e.dot(p).wrapping_sub(e.dot(a)) } else { e.dot(p.sub(a)) };
        if dot <= 0 {
            return Region::End(a);
        }
        if dot as u64 >= len2 {
            return Region::End(b);
        }
    }
    let cross = if FAR { e.cross(p).wrapping_sub(e.cross(a)) } else { e.cross(p.sub(a)) };
    Region::Line { cross, len2 }
}
