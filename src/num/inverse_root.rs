//! The reciprocal of a root, and quotients by a root.

use super::quotient::{leading_zeros64, rsqrt, rsqrt_wide};
use super::wide::{LONG, less128, mul64, sqr64, umul, usqr};

/// The reciprocal of a root, for all numbers that are computed from one: `1 / sqrt(n)` is
/// `2^half y / 2^63`.
///
/// `n << 2 half` is in `[2^62, 2^64)`, and `y` is the [`rsqrt`] of its top word h. The exact factor
/// is 2^47/sqrt(h'), with h <= h' < h + 1. rsqrt is less than 2 above the exact value at h, and
/// that is at most 2 above the factor. So `y - 4` never exceeds the exact factor, and is at most 8
/// below it.
#[derive(Clone, Copy)]
pub(crate) struct InverseRoot {
    pub(super) y: u64,
    pub(super) half: u32,
}

impl InverseRoot {
    /// The inverse root of a number that is not zero.
    #[inline(always)]
    pub(crate) const fn of(n: u64) -> Self {
        // Only the shift of zero would be wrong.
        let half = leading_zeros64(n | 1) >> 1;
        let top = (n << (2 * half) >> 32) as u32;
        Self { y: if LONG { rsqrt_wide(top) } else { rsqrt(top) as u64 }, half }
    }

    /// [`of`](Self::of) as a call, for places at which the compiler would repeat parts of it.
    #[inline(never)]
    pub(crate) const fn called(n: u64) -> Self {
        Self::of(n)
    }

    /// [`isqrt64`] of the same number, if it is below 2^62.
    ///
    /// The candidate is below the root by less than 9, and for roots below 2^27 by less than 2.
    #[inline(always)]
    pub(crate) const fn root(self, n: u64) -> u32 {
        // Below 2^62, so `half` is not zero.
        let root = self.half_below(n << (2 * self.half)) >> (self.half.wrapping_sub(1) & 63);
        let mut next = root.wrapping_add(1);
        // Most often so. The compiler would enter a loop alone by four more instructions.
        if next.wrapping_mul(next) > n {
            return root as u32;
        }
        while next.wrapping_mul(next) <= n {
            next = next.wrapping_add(1);
        }
        next.wrapping_sub(1) as u32
    }

    /// Half of a lower bound of `a / (2^half sqrt(n))`.
    #[inline(always)]
    const fn half_below(self, a: u64) -> u64 {
        ((a as u128 * self.y.wrapping_sub(4) as u128) >> 64) as u64
    }

    /// [`div_sqrt`] of the same number, for quotients below 2^31.
    #[inline(always)]
    pub(crate) const fn times(self, s: u64, n: u64) -> u32 {
        self.times_root_of(s, n, sqr64(s))
    }

    /// [`times`](Self::times), with the square of `s`.
    #[inline(always)]
    const fn times_root_of(self, s: u64, n: u64, square: (u64, u64)) -> u32 {
        let q = if LONG {
            // The quotient is below 2^31, so one bit more of the product has room above.
            self.half_below(s << self.half << 1) as u32
        } else {
            self.candidate(s).0
        };
        // Most often so. The compiler would enter a loop alone by four more instructions.
        if less128(square, mul64(usqr(q.wrapping_add(1)), n)) {
            return q;
        }
        settled(q.wrapping_add(1), square, n)
    }

    /// A candidate for [`div_sqrt`] of the same number that is not too large, and whether it is
    /// known to be right. In words, because a shift of a double word is a call on `ARMv6-M`.
    ///
    /// The exact quotient is `s f / 2^32` in parts of `2^(31 - half)`, where `f` is the exact
    /// factor, at most 8 above `y - 4`. The product drops less than one, and the 8 are at most
    /// `s / 2^29`. If that does not reach the next whole quotient, the candidate is right.
    #[inline(always)]
    const fn candidate(self, s: u64) -> (u32, bool) {
        let (y, cut) = ((self.y as u32).wrapping_sub(4), 31u32.wrapping_sub(self.half) & 31);
        let product = umul((s >> 32) as u32, y).wrapping_add(umul(s as u32, y) >> 32);
        let (hi, lo, below_one) = ((product >> 32) as u32, product as u32, (1u32 << cut) - 1);
        // In two steps: a shift by 32 is none.
        let q = hi << 1 << (31 - cut) | lo >> cut;
        let fits = hi >> cut | q >> 31 | (s >> 59) as u32;
        (q, fits == 0 && (lo & below_one).wrapping_add((s >> 29) as u32).wrapping_add(2) <= below_one)
    }
}

/// The largest whole number, from `q` on, of which the square times `n` is at most `square`.
#[inline(always)]
const fn settled(mut q: u32, square: (u64, u64), n: u64) -> u32 {
    while !less128(square, mul64(usqr(q.wrapping_add(1)), n)) {
        q = q.wrapping_add(1);
    }
    q
}

/// The exact floor of `s / sqrt(n)`, for quotients below 2^31; `u32::MAX` for others, or where `n`
/// is zero.
///
/// Starts from the reciprocal square root and settles by comparing `q^2 n` with `s^2` in 128 bits.
/// It makes one comparison more than the candidate is short. The candidate is short by at most 9,
/// and by at most 1 for quotients below 2^27.
///
/// On chips the bits behind the candidate mostly show that it is not short. Then no comparison is
/// needed, and a Cortex-M0 takes 270 instructions in place of 510. For quotients of 2^20 that fails
/// in one of 300 cases.
#[inline(never)]
#[must_use]
pub const fn div_sqrt(s: u64, n: u64) -> u32 {
    if !LONG {
        let (q, is_sure, _) = near_quotient(s, n);
        return if is_sure { q } else { div_sqrt_closely(q, s, n) };
    }
    let square = sqr64(s);
    if is_wide(square, n) { u32::MAX } else { InverseRoot::of(n).times_root_of(s, n, square) }
}

/// The [candidate](InverseRoot::candidate) of [`div_sqrt`], whether it is the answer, and the
/// inverse root. A separate call: its stack is free again before squares are compared.
#[inline(never)]
pub(super) const fn near_quotient(s: u64, n: u64) -> (u32, bool, InverseRoot) {
    let inverse = InverseRoot::of(n);
    let (q, is_sure) = inverse.candidate(s);
    (q, is_sure && n != 0, inverse)
}

/// [`div_sqrt`] from a candidate that may be short.
#[inline(never)]
pub(super) const fn div_sqrt_closely(q: u32, s: u64, n: u64) -> u32 {
    let square = sqr64(s);
    if is_wide(square, n) {
        return u32::MAX;
    }
    settled(q, square, n)
}

/// Whether `s / sqrt(n)` is 2^31 or more: s^2 >= 2^62 n.
#[inline(always)]
const fn is_wide(square: (u64, u64), n: u64) -> bool {
    !less128(square, (n >> 2, n << 62))
}
