//! Moments of contact that are no fractions of integers: lower bounds in parts of 2^30, never late.

use crate::num::{Toi, fraction, leading_zeros64, root128_down, root128_up, sqr64, sub128, umul};

/// When a point enters a disc: a lower bound of `c / (b + sqrt(rra - cross^2))`, with c = |m|^2 - r^2 and b = -m.d.
///
/// This form has no cancellation. The root and the denominator are rounded up, the numerator and the quotient down, so it is never
/// late. Each step keeps 31 bits or whole raw units: it is early by less than a raw unit of way.
#[inline(never)]
pub(crate) fn entry_time(c: u64, b: u64, rra: (u64, u64), cross: i64) -> Toi {
    let (word, shift) = word(b.wrapping_add(root128_up(sub128(rra, sqr64(cross.unsigned_abs())))));
    quotient(c >> shift, word.wrapping_add(1))
}

/// When a point leaves a disc: a lower bound of `(b + sqrt(rra - cross^2)) / a`, with b = -m.d and a = |d|^2, `inner` = r^2 - |m|^2.
///
/// Where b is not positive (then the point starts inside) the same without cancellation, as above: `inner / (|b| + sqrt(..))`.
#[inline(never)]
pub(crate) fn exit_time(inner: u64, b: i64, a: u64, rra: (u64, u64), cross: i64) -> Toi {
    let square = sub128(rra, sqr64(cross.unsigned_abs()));
    if b > 0 {
        ratio((b as u64).wrapping_add(root128_down(square)), a)
    } else {
        ratio(inner, b.unsigned_abs().wrapping_add(root128_up(square)))
    }
}

/// When a gap falls to the square root of a number: a lower bound of `(gap - sqrt(reach)) / into`, for gap^2 >= reach and a result up to
/// one.
///
/// As `(gap^2 - reach) / ((gap + sqrt(reach)) into)`, which has no cancellation either. Everything is scaled to the full width first,
/// so that each rounding is one of 31 bits: below a raw unit of way for motions up to 2^27 raw.
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
    // The quotient is below one, so what is left of the numerator fits the 62 bits of the product.
    let shift = a + b;
    let num = if shift == 0 { num.1 } else { (num.0 << (64 - shift)) | (num.1 >> shift) };
    ratio(num, umul(sum, into))
}

/// `num / den` rounded down, at most one, for a divisor up to 2^31; nothing of nothing is nothing.
fn quotient(num: u64, den: u32) -> Toi {
    if num != 0 && num >= u64::from(den) {
        return Toi::ONE;
    }
    // A power of two is the one divisor that has 32 bits.
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

/// The same rounded up: at most 2^31.
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

/// The last moment, in parts of 2^30, at which something has not happened yet: not at `from`, at the motion's end it has, and it
/// stays so. Doubled steps, then halved ones: twice the bits of what `from` is short by, at most 60 questions.
pub(super) fn last_before(from: Toi, happened: impl Fn(u32) -> bool) -> Toi {
    let (mut last, mut step) = (from.raw(), 1u32);
    let mut before = |step: u32| {
        let next = last.wrapping_add(step);
        let free = next < Toi::ONE.raw() && !happened(next);
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
