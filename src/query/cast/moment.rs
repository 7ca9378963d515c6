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

#[cfg(test)]
mod tests {
    use super::{exit_time, gap_time, ratio};
    use crate::num::{Toi, sqr64};

    const ONE: u128 = 1 << 30;

    /// Every bit length, a few numbers of each.
    fn numbers(bits: u32) -> impl Iterator<Item = u64> + Clone {
        (0..bits)
            .flat_map(|k| [1, 3, 5, 0x9e37_79b9_7f4a_7c15 >> (63 - k)].map(|n| (n << k >> k & ((2 << k) - 1)) | 1 << k))
    }

    /// No more than `num / den`, and less by four parts in 2^30 and two steps at most.
    fn check(got: Toi, num: u64, den: u64, case: &[u64]) {
        let exact = (u128::from(num) * ONE / u128::from(den)).min(ONE);
        let got = u128::from(got.raw());
        assert!(got <= exact && exact - got <= (exact >> 28) + 2, "{got} for {exact}: {case:?}");
    }

    #[test]
    fn ratios_are_rounded_down_to_one() {
        assert_eq!(ratio(1 << 40, 1 << 41).raw(), 1 << 29);
        for den in numbers(62) {
            for num in
                [0, 1, den / 3, den / 2, den - 1, den, den.saturating_add(1), den.saturating_mul(2), u64::MAX >> 1]
            {
                check(ratio(num, den), num, den, &[num, den]);
            }
            // By a power of two it is exact.
            for shift in 0..den.leading_zeros() {
                assert_eq!(ratio(1, 1 << shift).raw(), (1u32 << 30).checked_shr(shift).unwrap_or(0), "{shift}");
            }
        }
    }

    #[test]
    fn gaps_fall_to_a_whole_root() {
        for root in numbers(60) {
            for into in numbers(60) {
                for left in [0, 1, into / 7, into / 2, into - 1, into] {
                    let gap = root + left;
                    check(gap_time(gap, into, sqr64(root)), left, into, &[gap, into, root]);
                }
            }
        }
    }

    #[test]
    fn exits_with_a_whole_root() {
        for root in numbers(58) {
            for b in numbers(58) {
                for cross in [0, 1, 1 << 40, -(1 << 57)] {
                    let (square, across) = (u128::from(root).pow(2), u128::from(i64::unsigned_abs(cross)).pow(2));
                    let sum = square + across;
                    let rra = ((sum >> 64) as u64, sum as u64);
                    let far = b + root;
                    for a in [far, far * 2 + 1, far / 2 + 1] {
                        check(exit_time(0, b as i64, a, rra, cross), far, a, &[b, a, root]);
                    }
                    for inner in [far / 3, far, far * 2] {
                        check(exit_time(inner, -(b as i64), 1, rra, cross), inner, far, &[inner, b, root]);
                    }
                    check(exit_time(root / 2, 0, 1, rra, cross), root / 2, root, &[root]);
                }
            }
        }
    }
}
