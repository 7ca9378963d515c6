//! Quotients without division instructions: a table-and-Newton reciprocal gives a candidate, an exact remainder corrects it.

use super::root::{leading_zeros32, leading_zeros64};
use super::wide::{LONG, less128, mul64, umul};

/// `round(2^15 / (i + 64.5)) - 256` for i in 0..64, at most 255.
const RECIP_TABLE: [u8; 64] = recip_table();

#[expect(clippy::indexing_slicing, reason = "bounded by the loop; runs in the compiler")]
const fn recip_table() -> [u8; 64] {
    let mut table = [0u8; 64];
    let mut i = 0;
    while i < 64 {
        // round(2^15 / (i + 64.5)) = floor((2^16 / (2i + 129)) + 1/2)
        let d = 2 * i as u32 + 129;
        let t = (2 * 65536 + d) / (2 * d);
        table[i] = if t > 511 { 255 } else { (t - 256) as u8 };
        i += 1;
    }
    table
}

/// The reciprocal `2^63 / d` of a normalised word.
///
/// `d` must be at least 2^31. The error is in `(-26.5, 0]`, checked for every `d`.
#[inline]
#[must_use]
#[expect(clippy::indexing_slicing, reason = "the index is masked to the table's length")]
pub const fn recip(d: u32) -> u32 {
    let t = RECIP_TABLE[((d >> 25).wrapping_sub(64) & 63) as usize] as u32 + 256;
    let e = (1i32 << 24).wrapping_sub((d >> 16).wrapping_mul(t) as i32);
    let y = ((t << 8) as i32).wrapping_add((t as i32).wrapping_mul(e >> 4) >> 12) as u32;
    // At most 131 064, and the result at most 2^32 - 16.
    let e2 = ((1u64 << 48).wrapping_sub(umul(d, y)) as i64 >> 17) as i32;
    ((y as i64) << 15).wrapping_add(super::wide::imul(y as i32, e2) >> 16) as u32
}

/// The exact floor of `a * b / d`; `u32::MAX` where that does not fit, or `d` is zero.
///
/// No division on chips: about 150 instructions on a Cortex-M0 where the compiler's 64-bit division takes 450.
#[inline(never)]
#[must_use]
pub const fn mul_div(a: u32, b: u32, d: u32) -> u32 {
    if d != 0 {
        if a == 0 || b == 0 {
            return 0;
        }
        if b == d {
            return a;
        }
    }
    let n = umul(a, b);
    if (n >> 32) as u32 >= d {
        return u32::MAX;
    }
    if LONG { divided(n, d as u64) } else { by_reciprocal(n, d) }
}

/// By the processor, for quotients that fit.
#[inline(always)]
const fn divided(n: u64, d: u64) -> u32 {
    match n.checked_div(d) {
        Some(q) => q as u32,
        None => u32::MAX,
    }
}

/// The floor of `n / d` for quotients that fit and a `d` that is not zero.
#[inline(always)]
const fn by_reciprocal(n: u64, d: u32) -> u32 {
    let shift = leading_zeros32(d);
    if d & d.wrapping_sub(1) == 0 {
        // A power of two, as where a time is in parts of 2^30: a shift, in words. The high one is below d.
        let log = 31 - shift;
        return ((n >> 32) as u32) << ((32 - log) & 31) | n as u32 >> log;
    }
    // With D = d * 2^shift >= 2^31: n / d = (n * 2^shift / 2^32) * (2^32 / D), and recip(D) / 2^31 <= 2^32 / D.
    // The quotient fits a word, so n < d * 2^32 and n * 2^shift < 2^64.
    let scaled = n << shift;
    let y = recip(d << shift);
    let hi = umul((scaled >> 32) as u32, y);
    let lo = umul(scaled as u32, y) >> 32;
    let mut q = (hi.wrapping_add(lo) >> 31) as u32;
    // Never above the exact quotient; below it by at most 26.5 parts in 2^31 (53 units) and a truncation: at most 7 rounds by 8.
    let mut rem = n.wrapping_sub(umul(q, d));
    let mut step = d as u64 * 8;
    let mut weight = 8;
    while weight > 0 {
        if rem >= step {
            rem = rem.wrapping_sub(step);
            q = q.wrapping_add(weight);
        } else {
            step >>= 1;
            weight >>= 1;
        }
    }
    q
}

/// The exact floor of `a * k / n`, for `n <= 2^63`; `u32::MAX` where it does not fit, or `n` is zero.
///
/// As fast as [`mul_div`] where `a` and `n` are words, else some 700 instructions on a Cortex-M0. Used where a result must be exact and is asked for
/// rarely: points on segments, replies of velocities.
#[inline(never)]
#[must_use]
pub const fn mul_div_wide(a: u64, k: u32, n: u64) -> u32 {
    if (a | n) >> 32 == 0 {
        return mul_div(a as u32, k, n as u32);
    }
    let (hi, lo) = mul64(a, k as u64);
    let top = (hi << 32) | (lo >> 32);
    if hi >> 32 != 0 || top >= n {
        return u32::MAX;
    }
    if LONG && hi == 0 { divided(lo, n) } else { by_wide_reciprocal((top, lo), n) }
}

/// The floor of a product of 96 bits, by its top 64 and its low 64, with `n`, which is above the top.
#[inline(always)]
const fn by_wide_reciprocal((top, lo): (u64, u64), n: u64) -> u32 {
    // With N = n 2^shift >= 2^63 and P = a k 2^shift < 2^32 N: P / N from the top 64 bits of the 96 of P and the top 32 of N.
    let shift = leading_zeros64(n);
    let top = if shift < 32 { (top << shift) | ((lo as u32 as u64) << shift >> 32) } else { lo << (shift - 32) };
    let (nh, nl) = ((n << shift >> 32) as u32, (n << shift) as u32);
    let y = recip(nh);
    let sum = umul((top >> 32) as u32, y).wrapping_add(umul(top as u32, y) >> 32);
    // The low half of N makes that too large by at most 2 and a fraction; the reciprocal's 26.5 parts in 2^32 of 2 and two truncations make it
    // too small by at most 55. So what is short, from 3 less, is below 64.
    let mut q = (sum >> 31).saturating_sub(3) as u32;
    // The remainder and N in units of 2^32, a little too small and too large: q stays no more than exact, and ends at most 1 short.
    let mut rem = top.wrapping_sub(umul(q, nh)).wrapping_sub(umul(q, nl) >> 32).saturating_sub(1);
    let unit = nh as u64 + 1;
    let mut step = unit << 5;
    let mut weight = 32;
    while weight > 0 {
        if rem >= step {
            rem = rem.wrapping_sub(step);
            q = q.wrapping_add(weight);
        }
        step >>= 1;
        weight >>= 1;
    }
    // Below 2 n <= 2^64.
    q.wrapping_add((lo.wrapping_sub(n.wrapping_mul(q as u64)) >= n) as u32)
}

/// The exact floor of `s / sqrt(n)`, for quotients below 2^31; `u32::MAX` for others, or where `n` is zero.
///
/// Starts from the reciprocal square root and settles by comparing `q^2 n` with `s^2` in 128 bits: one comparison more than
/// the candidate is short, at most 9, and at most 1 for quotients below 2^27.
#[inline(never)]
#[must_use]
pub const fn div_sqrt(s: u64, n: u64) -> u32 {
    let square = super::wide::sqr64(s);
    // s / sqrt(n) >= 2^31, that is s^2 >= 2^62 n.
    if !less128(square, (n >> 2, n << 62)) {
        return u32::MAX;
    }
    let half_shift = super::root::leading_zeros64(n) >> 1;
    let h = ((n << (2 * half_shift)) >> 32) as u32;
    // 1/sqrt(n) = 2^half_shift y / 2^63 with y = 2^47/sqrt(h'), h <= h' < h + 1. rsqrt is less than 2 above its value at h, and
    // that is at most 2 above the one at h': y - 4 never exceeds the exact factor, and is at most 8 below it.
    let y = super::root::rsqrt(h).saturating_sub(4);
    let product = umul((s >> 32) as u32, y).wrapping_add(umul(s as u32, y) >> 32);
    let mut q = (product >> (31 - half_shift)) as u32;
    while !less128(square, mul64(super::wide::usqr(q.wrapping_add(1)), n)) {
        q = q.wrapping_add(1);
    }
    q
}

#[cfg(test)]
mod tests {
    use super::{by_reciprocal, by_wide_reciprocal, mul_div, mul_div_wide};

    /// Around every power of two and its multiples, where quotients change.
    #[test]
    fn reciprocals_divide_as_the_processor_does() {
        let near = |bits: u32| (0..bits).flat_map(|k| [0, 1, 2, 3].map(|by| (1u64 << k) * (2 + by) / 2 - by % 2));
        for d in near(32).filter_map(|d| u32::try_from(d).ok()).filter(|&d| d != 0) {
            for q in near(32).filter_map(|q| u32::try_from(q).ok()) {
                let n = u64::from(q) * u64::from(d);
                for n in [n.saturating_sub(1), n, n + u64::from(d / 2), n + u64::from(d) - 1] {
                    assert_eq!(u64::from(by_reciprocal(n, d)), n / u64::from(d), "{n} / {d}");
                }
                assert_eq!((mul_div(q, d, d), mul_div(d, q, d)), (q, q));
            }
        }
        for n in near(62).filter(|n| n >> 32 != 0) {
            for (q, k) in near(31).flat_map(|q| [(q, 1 << 30), (q, 0x9e37_79b9), (q, u64::from(u32::MAX))]) {
                let a = (u128::from(q) * u128::from(n) / u128::from(k)) as u64;
                for a in [a, a + 1, a.saturating_sub(1)] {
                    let product = u128::from(a) * u128::from(k);
                    let exact = product / u128::from(n);
                    if let Ok(exact) = u32::try_from(exact) {
                        let halves = ((product >> 32) as u64, product as u64);
                        assert_eq!(by_wide_reciprocal(halves, n), exact, "{a} {k} / {n}");
                        assert_eq!(mul_div_wide(a, k as u32, n), exact, "{a} {k} / {n}");
                    }
                }
            }
        }
    }
}
