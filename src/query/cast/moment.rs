//! When a moving point enters a disc, or reaches the flat side of a grown segment or slope.
//!
//! Moments that are not fractions of integers are lower bounds in parts of 2^30, never late.

use super::kernel::{Course, Moment};
use super::offset::{offset, offset_to_radius};
use crate::num::{
    Axis, LONG, Raw, SPLIT, Toi, add128, dot, fraction, imul, leading_zeros64, less128, mul64, root128_down,
    root128_up, sqr_signed, sqr64, sub128, umul, usqr,
};
use crate::query::meet::circle_circle;
use core::cmp::{Ordering, Reverse};

/// When a point enters a disc: a lower bound of `c / (b + sqrt(rra - cross^2))`, with c = |m|^2 -
/// r^2 and b = -m.d.
///
/// This form has no cancellation. The root and the denominator are rounded up, the numerator and
/// the quotient down, so it is never late. Each step keeps 31 bits or whole raw units: it is early
/// by less than a raw unit of travel.
#[inline(never)]
pub(crate) fn entry_time(c: u64, b: u64, rra: (u64, u64), cross: i64) -> Toi {
    let (word, shift) = word(b.wrapping_add(root128_up(sub128(rra, sqr_signed(cross)))));
    quotient(c >> shift, word.wrapping_add(1))
}

/// When a point leaves a disc: a lower bound of `(b + sqrt(rra - cross^2)) / a`, with b = -m.d and
/// a = |d|^2, `inner` = r^2 - |m|^2.
///
/// If b is not positive, the point starts inside. Then this has no cancellation either:
/// `inner / (|b| + sqrt(..))`.
#[inline(never)]
pub(crate) fn exit_time(inner: u64, b: i64, a: u64, rra: (u64, u64), cross: i64) -> Toi {
    let square = sub128(rra, sqr64(cross.unsigned_abs()));
    if b > 0 {
        ratio((b as u64).wrapping_add(root128_down(square)), a)
    } else {
        ratio(inner, b.unsigned_abs().wrapping_add(root128_up(square)))
    }
}

/// When a gap falls to the square root of a number: a lower bound of `(gap - sqrt(reach)) / into`,
/// for gap^2 >= reach and a result up to one.
///
/// As `(gap^2 - reach) / ((gap + sqrt(reach)) into)`, which has no cancellation either. Everything
/// is scaled to the full width first. Each rounding is then one of 31 bits: below a raw unit of
/// travel for motions up to 2^27 raw.
#[inline(never)]
pub(crate) fn gap_time(gap: u64, into: u64, reach: (u64, u64)) -> Toi {
    // Below 2^61; the square of the gap, and the reach with it, below 2^122.
    let scale = leading_zeros64(gap | into).saturating_sub(3);
    let (gap, into, reach) = (gap << scale, into << scale, shift_left(reach, 2 * scale));
    let num = sub128(sqr64(gap), reach);
    if num == (0, 0) {
        return Toi::ZERO;
    }
    let ((sum, a), (into, b)) = (word_up(gap.wrapping_add(root128_up(reach))), word_up(into));
    // The quotient is below one, so the rest of the numerator fits the 62 bits of the product.
    let shift = a + b;
    let num = if shift == 0 { num.1 } else { (num.0 << (64 - shift)) | (num.1 >> shift) };
    ratio(num, umul(sum, into))
}

/// `num / den` rounded down, at most one, for a divisor up to 2^31; 0 for 0 / 0.
fn quotient(num: u64, den: u32) -> Toi {
    if num != 0 && num >= u64::from(den) {
        return Toi::ONE;
    }
    // The only 32-bit divisor is a power of two.
    Toi::exact(if num == 0 {
        0
    } else if den >> 31 != 0 {
        (num >> 1) as u32
    } else {
        fraction(num as u32, den)
    })
}

/// The top 31 bits of a number, and how far it was shifted: at most 33.
fn word(n: u64) -> (u32, u32) {
    let shift = (64 - leading_zeros64(n)).saturating_sub(31);
    ((n >> shift) as u32, shift)
}

/// [`word`] rounded up: at most 2^31.
fn word_up(n: u64) -> (u32, u32) {
    let (word, shift) = word(n);
    (if u64::from(word) << shift == n { word } else { word.wrapping_add(1) }, shift)
}

/// `num / den` rounded down, at most one: the divisor is rounded up to 31 bits.
pub(crate) fn ratio(num: u64, den: u64) -> Toi {
    let (den, shift) = word_up(den);
    quotient(num >> shift, den)
}

/// `a << by`, for results that fit.
const fn shift_left(a: (u64, u64), by: u32) -> (u64, u64) {
    if by == 0 {
        a
    } else if by < 64 {
        ((a.0 << by) | (a.1 >> (64 - by)), a.1 << by)
    } else {
        (a.1 << (by & 63), 0)
    }
}

/// The last moment, in parts of 2^30, at which something has not happened yet.
///
/// It has not happened at `from`, and once it has, it stays so. Only a ray may end before it
/// happens, exactly at the border. Steps are doubled, then halved. The questions are twice the bits
/// by which `from` is short, at most 60.
pub(super) fn last_before(from: Toi, happened: impl Fn(u32) -> bool) -> Toi {
    let (mut last, mut step) = (from.raw(), 1u32);
    let mut before = |step: u32| {
        let next = last.wrapping_add(step);
        let free = next <= Toi::ONE.raw() && !happened(next);
        if free {
            last = next;
        }
        free
    };
    while before(step) {
        step <<= 1;
    }
    while step > 1 {
        step >>= 1;
        before(step);
    }
    Toi::exact(last)
}

/// `dir . v`; for the slopes of tiles, whose components are at most 2, with two products of words:
/// |v| is below 2^30.
pub(crate) fn along(dir: Axis, v: Raw) -> i64 {
    // A product that is one instruction costs less than this test.
    if !LONG && is_small(dir) {
        i64::from(dir.x.wrapping_mul(v.x)).wrapping_add(i64::from(dir.y.wrapping_mul(v.y)))
    } else {
        dot(dir.x, v.x, dir.y, v.y)
    }
}

const fn is_small(dir: Axis) -> bool {
    dir.x.wrapping_add(2) as u32 <= 4 && dir.y.wrapping_add(2) as u32 <= 4
}

/// The square of r |dir|.
pub(crate) fn reach(r: i32, dir: Axis) -> (u64, u64) {
    let rr = usqr(r.unsigned_abs());
    if LONG {
        return mul64(rr, dir.length_squared());
    }
    match dir.length_squared() {
        2 => (0, rr << 1),
        5 => (0, usqr(r.unsigned_abs() << 1).wrapping_add(rr)),
        nn => mul64(rr, nn),
    }
}

/// Whether the square of a height is less than `reach`.
pub(crate) fn is_below(height: u64, reach: (u64, u64)) -> bool {
    if !LONG && height >> 32 == 0 {
        return reach.0 != 0 || usqr(height as u32) < reach.1;
    }
    less128(sqr64(height), reach)
}

/// Whether the centre is not before an end of a face at the moment T when the disc meets the face's
/// line.
///
/// For the start of the face that is `u = dir . m(T) >= 0`, with `m` the centre relative to it. For
/// the face's end (`at_end`), `m` is relative to that, and the direction is -dir.
#[inline]
pub(crate) fn meets_beyond(m: Raw, d: Raw, dir: Axis, at_end: bool, r: i32) -> bool {
    match pass_end(m, d, dir, at_end) {
        Pass::Never(beyond) => beyond,
        Pass::At { cross, du } => is_in_time(offset(cross, dir, r, du), du),
    }
}

/// When a motion passes an end of a face squarely.
pub(super) enum Pass {
    /// Whether it is beyond at T, whatever the radius.
    Never(bool),
    /// At the moment s with u = 0 the height is |dir|^2 cross / du, and it falls. T is later than s
    /// if that height is more than r |dir|.
    At { cross: i64, du: i64 },
}

/// A separate call if multiplications are calls: its stack is free again before squares are
/// compared.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
fn pass_end(m: Raw, d: Raw, dir: Axis, at_end: bool) -> Pass {
    let dir = if at_end { dir.reversed() } else { dir };
    pass(along(dir, m), along(dir, d), || if at_end { m.cross(d).wrapping_neg() } else { m.cross(d) })
}

/// How a motion passes an end: it starts `u` beyond the end, and moves by `du` along the face.
#[inline]
pub(super) fn pass(u: i64, du: i64, cross: impl FnOnce() -> i64) -> Pass {
    let beyond = u.wrapping_add(du);
    if u >= 0 && beyond >= 0 {
        return Pass::Never(true);
    }
    if u < 0 && beyond < 0 {
        return Pass::Never(false);
    }
    let cross = cross();
    // Below the line at s: T is before that.
    if (du > 0) == (cross < 0) { Pass::Never(du <= 0) } else { Pass::At { cross, du } }
}

/// Whether it is beyond at T. The face's direction has the length whose square is `len2`.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
pub(super) fn passes_in_time(cross: i64, du: i64, len2: u64, r: i32) -> bool {
    is_in_time(offset_to_radius(cross, len2, r, du), du)
}

/// [`passes_in_time`] by the order of the height at s and the radius: s <= T on the way to the
/// face, else T <= s.
#[inline]
fn is_in_time(order: Ordering, du: i64) -> bool {
    if du > 0 { order.is_ge() } else { order.is_le() }
}

/// A motion that enters a disc around the origin: what its moment is computed from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    rr: u64,
    /// |d|^2.
    a: u64,
    /// -m.d, positive.
    b: u64,
    pub(crate) cross: i64,
}

impl Crossing {
    /// For the point `m` that moves by `d` into the disc of radius `r`.
    ///
    /// Decided without a root or a division. The line of the motion comes nearer than r: cross^2 <
    /// r^2 |d|^2, in 124 bits. The motion ends inside (|m + d| < r), or after the nearest point of
    /// the line.
    #[inline]
    pub(crate) fn of(m: Raw, r: i32, d: Raw) -> Option<Self> {
        let (dot, cross) = m.dot_cross(d);
        let b = dot.wrapping_neg();
        if b <= 0 {
            return None;
        }
        if !passes(cross, r as u32, d) {
            return None;
        }
        let (rr, a) = (usqr(r as u32), d.len2());
        if b as u64 >= a && m.add(d).len2() >= rr {
            return None;
        }
        Some(Self { rr, a, b: b as u64, cross })
    }

    /// Whether the point `m` is inside from the start.
    #[inline]
    pub(crate) fn starts_inside(&self, m: Raw) -> bool {
        m.len2() < self.rr
    }

    /// For a ray from `m`, which stops at a touch, also one from the rim or up to it. A tangent
    /// does not enter.
    pub(crate) fn touching(m: Raw, r: i32, d: Raw) -> Option<Self> {
        let b = m.dot(d).wrapping_neg();
        if b <= 0 {
            return None;
        }
        let (rr, a, cross) = (usqr(r as u32), d.len2(), m.cross(d));
        let reaches = b as u64 <= a || m.add(d).len2() <= rr;
        (reaches && less128(sqr64(cross.unsigned_abs()), mul64(rr, a))).then_some(Self { rr, a, b: b as u64, cross })
    }

    /// A lower bound of the moment of entry, the displacement up to it, rounded away from the
    /// centre, and the normal there.
    #[inline]
    pub(crate) fn contact(&self, m: Raw, d: Raw) -> (Toi, Raw, Axis) {
        let t = self.toi(m);
        let step = Raw { x: t.of_raw_beside(m.x, d.x, true), y: t.of_raw_beside(m.y, d.y, true) };
        (t, step, direction(m.add(step)))
    }

    /// The bound alone.
    #[inline]
    pub(crate) fn toi(&self, m: Raw) -> Toi {
        entry_time(m.len2().saturating_sub(self.rr), self.b, mul64(self.rr, self.a), self.cross)
    }

    /// The exact floor of the moment.
    ///
    /// At a moment T, in parts of 2^30, the point is at `2^30 m + T d`, components below 2^61. It
    /// has entered where that is nearer than 2^30 r (squares below 2^123), or where the closest
    /// approach is over: T |d|^2 > 2^30 b.
    pub(crate) fn exact_toi(&self, m: Raw, d: Raw) -> Toi {
        last_before(self.toi(m), |t| {
            let at = |m: i32, d: i32| (i64::from(m) << 30).wrapping_add(imul(d, t as i32)).unsigned_abs();
            let square = add128(sqr64(at(m.x, d.x)), sqr64(at(m.y, d.y)));
            less128(square, (self.rr >> 4, self.rr << 60))
                || less128((self.b >> 34, self.b << 30), mul64(self.a, u64::from(t)))
        })
    }
}

/// Whether the point `m` that moves by `d`, outside the disc of radius `r` before, enters it:
/// [`Crossing::of`] and nothing else.
#[inline]
pub(crate) fn enters(m: Raw, r: i32, d: Raw) -> bool {
    let (dot, cross) = m.dot_cross(d);
    let b = dot.wrapping_neg();
    if b <= 0 {
        return false;
    }
    // Of signed words, where a product is as cheap as their magnitudes.
    let square = |v: Raw| if SPLIT { v.len2() } else { v.dot(v) as u64 };
    passes(cross, r as u32, d) && ((b as u64) < square(d) || square(m.add(d)) < usqr(r as u32))
}

/// Whether `|cross| < r |d|`, exactly: as squares of 124 bits. If these are expensive, bounds of
/// the length mostly settle it, by one product of words each.
#[inline]
fn passes(cross: i64, r: u32, d: Raw) -> bool {
    if LONG {
        return less128(sqr_signed(cross), mul64(usqr(r), d.len2()));
    }
    let (cross, (below, above)) = (cross.unsigned_abs(), octagons(d));
    cross < umul(r, below) || (cross < umul(r, above) && passes_closely(cross, r, d))
}

#[inline(never)]
fn passes_closely(cross: u64, r: u32, d: Raw) -> bool {
    less128(sqr64(cross), mul64(usqr(r), d.len2()))
}

/// Bounds of the length of a vector, below 2^30 per component: from x the larger component and y
/// the smaller one, by shifts.
///
/// At least `x + 3 y / 8` less 1/16 and 1/256 of that, since `sqrt(1 + (3/8)^2) < 256 / 239`; at
/// most `x + 7 y / 16`, since that is more than sqrt(2) - 1. The fractions that the shifts drop are
/// made up for.
pub(in crate::query) const fn octagons(d: Raw) -> (u32, u32) {
    let (dx, dy) = (d.x.unsigned_abs(), d.y.unsigned_abs());
    let (x, y) = if dx > dy { (dx, dy) } else { (dy, dx) };
    let below = x.wrapping_add(y >> 2).wrapping_add(y >> 3);
    let below = below.wrapping_sub(below >> 4).wrapping_sub(below >> 8).saturating_sub(2);
    (below, x.wrapping_add(y >> 1).wrapping_sub(y >> 4).wrapping_add(1))
}

/// The direction of a point from the origin: along x or y it has one length, whatever the radius.
pub(crate) fn direction(m: Raw) -> Axis {
    if m.x == 0 || m.y == 0 { Axis::new(m.x.signum(), m.y.signum()) } else { Axis::new(m.x, m.y) }
}

/// A disc around the origin that a point enters.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    m: Raw,
    crossing: Crossing,
}

/// The disc of radius `r` around `b`, as the point `a` that moves by `d` enters it.
#[inline]
pub(super) fn enter_disc(a: Raw, b: Raw, r: i32, d: Raw) -> Course<Disc> {
    if is_inside(a, b, r) { Course::Inside } else { Course::of(meet_disc(a.sub(b), r, d)) }
}

/// [`enter_disc`] without a time.
#[inline]
pub(super) fn hit_disc(a: Raw, b: Raw, r: i32, d: Raw) -> Course<()> {
    if is_inside(a, b, r) { Course::Inside } else { Course::of(enters(a.sub(b), r, d).then_some(())) }
}

/// Where a product is cheap, so are the squares.
#[inline]
fn is_inside(a: Raw, b: Raw, r: i32) -> bool {
    let m = a.sub(b);
    if SPLIT { circle_circle::<false>(a, b, r) } else { (m.dot(m) as u64) < usqr(r as u32) }
}

/// [`enter_disc`] for a start outside, relative to the disc's centre.
#[inline]
pub(in crate::query) fn meet_disc(m: Raw, r: i32, d: Raw) -> Option<Disc> {
    Crossing::of(m, r, d).map(|crossing| Disc { m, crossing })
}

/// The contact with the disc of radius `r` around the origin of a point outside of it.
#[inline]
pub(super) fn corner_contact(m: Raw, r: i32, d: Raw) -> Option<(Toi, Raw, Axis)> {
    meet_disc(m, r, d).map(|disc| disc.contact(d))
}

/// [`meet_disc`] for a ray, which touching stops; with the bound of its time.
pub(in crate::query) fn touch_disc(m: Raw, r: i32, d: Raw) -> Option<(Toi, Disc)> {
    Crossing::touching(m, r, d).map(|crossing| (crossing.toi(m), Disc { m, crossing }))
}

impl Disc {
    /// A key to order two discs that are met at the same moment. The lesser one opposes the motion
    /// more, then is less beside its line, then farther along x. Exchanged and mirrored shapes give
    /// the same order. If the two mirror each other at a motion along x or y, it is the one on the
    /// left.
    pub(in crate::query) const fn order(&self) -> (Reverse<u64>, u64, Reverse<u32>, i64) {
        let Crossing { b, cross, .. } = self.crossing;
        (Reverse(b), cross.unsigned_abs(), Reverse(self.m.x.unsigned_abs()), cross)
    }
}

impl Moment for Disc {
    fn exact_toi(&self, d: Raw) -> Toi {
        self.crossing.exact_toi(self.m, d)
    }

    #[inline]
    fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        self.crossing.contact(self.m, d)
    }
}
