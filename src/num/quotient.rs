//! Roots and quotients: one canonical integer algorithm each, without division.

use super::wide::{LONG, SPLIT, imul, mul64, umul};

/// `round(256 / sqrt((i + 0.5) / 128)) - 256` for i in 32..128, at most 255. The first quarter is
/// never read: with it, the top seven bits of a word are the index.
const RSQRT_TABLE: [u8; 128] = rsqrt_table();

/// Rounds `256 / sqrt(u)` to nearest, with `u = (2i + 1) / 256`: the largest t with (2t - 1)^2 u <=
/// 512^2.
#[expect(clippy::indexing_slicing, reason = "bounded by the loop; runs in the compiler")]
const fn rsqrt_table() -> [u8; 128] {
    let mut table = [0u8; 128];
    let mut i = 32;
    while i < 128 {
        let u = 2 * i as u64 + 1;
        let mut t = 256u64;
        while t < 511 && (2 * t + 1) * (2 * t + 1) * u <= 512 * 512 * 256 {
            t += 1;
        }
        table[i] = (t - 256) as u8;
        i += 1;
    }
    table
}

/// `2^15 / sqrt(h / 2^32)` for h in `[2^30, 2^32)`, relative error below 2^-12.9; other inputs give
/// some number.
#[inline]
#[expect(clippy::indexing_slicing, reason = "the index has seven bits")]
const fn rsqrt_seed(h: u32) -> u32 {
    let t = RSQRT_TABLE[(h >> 25) as usize] as u32 + 256;
    let e = (h >> 18).wrapping_mul(t * t) as i32;
    let e16 = e.wrapping_sub(1 << 30) >> 14;
    let e2 = e16.wrapping_mul(e16) >> 16;
    ((t << 7) as i32)
        .wrapping_sub((t as i32).wrapping_mul(e16) >> 10)
        .wrapping_add((t as i32).wrapping_mul(e2).wrapping_mul(3) >> 12) as u32
}

/// The reciprocal square root `2^31 / sqrt(h / 2^32)` of a normalised word.
///
/// `h` must be in `[2^30, 2^32)`. The error is within -1.53 and +2.00, checked for every `h`. It is
/// a call where multiplications are calls as well.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
#[must_use]
pub const fn rsqrt(h: u32) -> u32 {
    if LONG {
        let y = rsqrt_wide(h);
        return if y > u32::MAX as u64 { u32::MAX } else { y as u32 };
    }
    let y0 = min32(rsqrt_seed(h), 65535);
    // e / 2^31 is twice the seed's relative error: |e| < 2^20 for h in range.
    let e = ((umul(h, y0 * y0) as i64).wrapping_sub(1i64 << 62) >> 31) as i32;
    let e8 = e >> 8;
    let second = ((e8.wrapping_mul(e8) >> 13).wrapping_mul((y0 >> 8) as i32)).wrapping_mul(3) >> 12;
    if SPLIT {
        // floor(y0 e / 2^16) by two single multiplications: e = 256 e8 + its low byte.
        let low = ((y0 * (e as u32 & 0xff)) >> 8) as i32;
        let first = (y0 as i32).wrapping_mul(e8).wrapping_add(low) >> 8;
        (y0 << 16).saturating_add_signed(second.wrapping_sub(first))
    } else {
        let y = ((y0 as i64) << 16).wrapping_sub(imul(y0 as i32, e) >> 16).wrapping_add(second as i64);
        if y > u32::MAX as i64 { u32::MAX } else { y as u32 }
    }
}

/// [`rsqrt`] in double words, for 64-bit processors. For 2^30 it is 2^32, which does not fit a
/// word.
///
/// It computes the same sum, but shifts all parts at once. The sum is rounded up, because the
/// subtrahend is rounded down.
#[inline(always)]
pub(super) const fn rsqrt_wide(h: u32) -> u64 {
    let y0 = min32(rsqrt_seed(h), 65535);
    // 2^31 more than e.
    let product = umul(h, y0 * y0) >> 31;
    let (e8, y0) = (product.wrapping_sub(1 << 31) as i64 >> 8, y0 as u64);
    let second = (e8.wrapping_mul(e8) as u64 >> 13).wrapping_mul(y0 >> 8).wrapping_mul(3) >> 12;
    let first = y0.wrapping_mul((3u64 << 31).wrapping_sub(product));
    first.wrapping_add(second << 16).wrapping_add(0xffff) >> 16
}

/// The exact floor of the square root of a double word.
///
/// Exact for all 2^64 inputs; no integer division. About 270 instructions on a Cortex-M0, 135 on a
/// Cortex-M3, 30 on 64-bit processors.
#[cfg_attr(not(target_pointer_width = "64"), inline(never))]
#[cfg_attr(target_pointer_width = "64", inline)]
#[must_use]
pub const fn isqrt64(n: u64) -> u32 {
    if super::wide::LONG { isqrt_float(n) } else { isqrt_words(n) }
}

/// Heron's method on an `f64`: constant functions have no root, and `u64::isqrt` takes 90
/// instructions.
///
/// Halving the bits of a positive `f64` halves its exponent: with the constant, the result is
/// within 3.5 % of the root. A step takes a relative error e to e^2 / 2: three take it below 2^-45,
/// and roundings add 2^-51. A root is below 2^32, so the candidate is at most one off, either way.
/// The lowest bit of `n` is dropped first, because a signed conversion is one instruction. That
/// changes the root of an odd `n` by less than one.
#[inline(always)]
#[expect(clippy::cast_precision_loss, clippy::float_arithmetic, reason = "what the rounding does is derived above")]
pub(super) const fn isqrt_float(n: u64) -> u32 {
    let x = (n >> 1) as i64 as f64 * 2.0;
    let mut root = f64::from_bits((x.to_bits() >> 1).wrapping_add(0x1ff7_a3be_a91d_9b1b));
    root = 0.5 * (root + x / root);
    root = 0.5 * (root + x / root);
    root = 0.5 * (root + x / root);
    // 2^32 itself has a square of 0 here, and 2^32 - 1 a next square of 0.
    let near = root as i64 as u64;
    let low = near.wrapping_sub((near >> 32 != 0 || near.wrapping_mul(near) > n) as u64);
    let next = low.wrapping_add(1);
    low.wrapping_add((next >> 32 == 0 && next.wrapping_mul(next) <= n) as u64) as u32
}

#[inline(always)]
pub(super) const fn isqrt_words(n: u64) -> u32 {
    if n == 0 {
        return 0;
    }
    let shift = leading_zeros64(n) & !1;
    let m = n << shift;
    // n = m / 2^shift, so floor(sqrt n) = floor(floor(sqrt m) / 2^(shift/2)).
    isqrt_norm((m >> 32) as u32, m as u32) >> (shift >> 1)
}

/// [`isqrt64`] at run time: with the feature `libm` by the processor's own root, where `libm` uses
/// that.
///
/// On x86-64 a cast of a circle against a circle takes 197 instructions with it, 211 without
/// (20 000 casts, half of them hits).
#[cfg(all(feature = "libm", target_arch = "x86_64", not(tilesat_split)))]
#[expect(clippy::cast_precision_loss, reason = "what the rounding does is derived below")]
#[inline]
pub(crate) fn root64(n: u64) -> u32 {
    // With k the exact floor: for k < 2^26.5 only the root rounds. Above, k^2 as an `f64` is short
    // by 2^10 at most, its root by 2^-22, half of the last place of k: that rounds back to k. So
    // the candidate is never short; it is 1 too large at most, where n rounds up to the next
    // square. At 2^32 it saturates to what is exact.
    let candidate = libm::sqrt(n as f64) as u32;
    candidate.wrapping_sub(u32::from(super::wide::usqr(candidate) > n))
}

/// [`isqrt64`] at run time.
#[cfg(not(all(feature = "libm", target_arch = "x86_64", not(tilesat_split))))]
#[inline]
pub(crate) fn root64(n: u64) -> u32 {
    isqrt64(n)
}

/// The exact ceiling of the square root of a double word, at most `u32::MAX`.
///
/// Exact for all sums of squares inside the domain; only above `(2^32 - 1)^2` does it saturate.
#[inline]
#[must_use]
pub const fn isqrt64_ceil(n: u64) -> u32 {
    let s = isqrt64(n);
    if super::wide::usqr(s) == n { s } else { s.saturating_add(1) }
}

/// An upper bound of the square root of a number below 2^124, within one part in 2^31 (exact
/// ceiling below 2^64).
pub(crate) fn root128_up(n: (u64, u64)) -> u64 {
    let (top, shift) = top_word(n);
    let (word, root) = if shift == 0 {
        (top, root64(top))
    } else {
        let word = top.saturating_add(1);
        (word, root_norm(word))
    };
    // Added as a double word: the root after 2^32 - 1 has no room in a word.
    (root as u64 + (super::wide::usqr(root) != word) as u64) << (shift / 2)
}

/// A lower bound of the root (the exact floor below 2^64).
pub(crate) fn root128_down(n: (u64, u64)) -> u64 {
    let (top, shift) = top_word(n);
    let root = if shift == 0 { root64(top) } else { root_norm(top) };
    (root as u64) << (shift / 2)
}

/// The root of a word whose top is in `[2^30, 2^32)`.
#[inline]
fn root_norm(n: u64) -> u32 {
    if LONG { root64(n) } else { isqrt_norm((n >> 32) as u32, n as u32) }
}

/// The part that the least even shift leaves in 64 bits. If it is not zero, at least 2^62.
const fn top_word((hi, lo): (u64, u64)) -> (u64, u32) {
    if hi == 0 {
        return (lo, 0);
    }
    // At most 60.
    let shift = (65 - leading_zeros64(hi)) & !1;
    ((hi << (64 - shift)) | (lo >> shift), shift)
}

/// Exact floor square root of `h * 2^32 + lo`, h in `[2^30, 2^32)`.
const fn isqrt_norm(h: u32, lo: u32) -> u32 {
    let y = min32(rsqrt_seed(h), 65535);
    let mut s = min32((h >> 16).wrapping_mul(y) >> 15, 65535);
    let mut r = h.wrapping_sub(s.wrapping_mul(s)) as i32;
    s = min32((s as i32).wrapping_add((r >> 6).wrapping_mul((y >> 2) as i32) >> 24) as u32, 65535);
    r = h.wrapping_sub(s.wrapping_mul(s)) as i32;
    while r < 0 {
        s = s.wrapping_sub(1);
        r = r.wrapping_add((2 * s + 1) as i32);
    }
    while r > (2 * s) as i32 {
        r = r.wrapping_sub((2 * s + 1) as i32);
        s += 1;
    }
    // s is the root of the high word and r its remainder. The low half of the root is about r *
    // 2^16 / (2 s).
    let e = 0x8000_0000u32.wrapping_sub(s.wrapping_mul(y)) as i32;
    let y = min32((y as i32).wrapping_add((y as i32 >> 3).wrapping_mul(e >> 5) >> 23) as u32, 65536);
    let q = if r as u32 >= 0x1_ffff { 65535 } else { min32((r as u32 >> 1).wrapping_mul(y) >> 15, 65535) };
    let mut root = ((s << 16) | q) as u64;
    let mut rem =
        (((r as u64) << 32) | lo as u64).wrapping_sub(umul(q, s) << 17).wrapping_sub(q.wrapping_mul(q) as u64) as i64;
    while rem < 0 {
        root -= 1;
        rem += (2 * root + 1) as i64;
    }
    while rem > (2 * root) as i64 {
        rem -= (2 * root + 1) as i64;
        root += 1;
    }
    root as u32
}

/// Leading zeros of a double word; the 64-bit builtin costs 78 instructions on `ARMv6-M`, two words
/// of the 32-bit one less.
#[inline]
#[must_use]
pub(crate) const fn leading_zeros64(n: u64) -> u32 {
    if super::wide::LONG {
        return n.leading_zeros();
    }
    let hi = (n >> 32) as u32;
    if hi != 0 { leading_zeros32(hi) } else { 32 + leading_zeros32(n as u32) }
}

/// Leading zeros of a word: a ladder of compares where the core has no `CLZ`.
#[inline]
#[must_use]
pub(crate) const fn leading_zeros32(n: u32) -> u32 {
    if SPLIT { ladder(n) } else { n.leading_zeros() }
}

#[inline(never)]
const fn ladder(mut n: u32) -> u32 {
    if n == 0 {
        return 32;
    }
    let mut zeros = 0;
    if n >> 16 == 0 {
        zeros += 16;
        n <<= 16;
    }
    if n >> 24 == 0 {
        zeros += 8;
        n <<= 8;
    }
    if n >> 28 == 0 {
        zeros += 4;
        n <<= 4;
    }
    if n >> 30 == 0 {
        zeros += 2;
        n <<= 2;
    }
    zeros + (1 - (n >> 31))
}

const fn min32(a: u32, b: u32) -> u32 {
    if a < b { a } else { b }
}

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
    ((y as i64) << 15).wrapping_add(imul(y as i32, e2) >> 16) as u32
}

/// The exact floor of `a * b / d`; `u32::MAX` where that does not fit, or `d` is zero.
///
/// There is no division on chips. It takes about 150 instructions on a Cortex-M0, where the
/// compiler's 64-bit division takes 450.
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
        if a == d {
            return b;
        }
    }
    let n = umul(a, b);
    if (n >> 32) as u32 >= d {
        return u32::MAX;
    }
    if LONG { divided(n, d as u64) } else { by_reciprocal(n, d) }
}

/// Divides by the processor's instruction, for quotients that fit.
#[inline(always)]
const fn divided(n: u64, d: u64) -> u32 {
    match n.checked_div(d) {
        Some(q) => q as u32,
        None => u32::MAX,
    }
}

/// The floor of `n / d` for quotients that fit and a `d` that is not zero.
#[inline(always)]
pub(super) const fn by_reciprocal(n: u64, d: u32) -> u32 {
    let shift = leading_zeros32(d);
    if d & d.wrapping_sub(1) == 0 {
        // A power of two, such as a time in parts of 2^30: a shift, in words. The high one is below
        // d.
        let log = 31 - shift;
        return ((n >> 32) as u32) << ((32 - log) & 31) | n as u32 >> log;
    }
    // With D = d * 2^shift >= 2^31: n / d = (n * 2^shift / 2^32) * (2^32 / D), and recip(D) /
    // 2^31 <= 2^32 / D. The quotient fits a word, so n < d * 2^32 and n * 2^shift < 2^64.
    let scaled = n << shift;
    let y = recip(d << shift);
    let hi = umul((scaled >> 32) as u32, y);
    let lo = umul(scaled as u32, y) >> 32;
    let mut q = (hi.wrapping_add(lo) >> 31) as u32;
    // Never above the exact quotient; below it by at most 26.5 parts in 2^31 (53 units) and a
    // truncation: at most 7 rounds by 8.
    let mut rem = n.wrapping_sub(umul(q, d));
    if rem < d as u64 {
        return q;
    }
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

/// The exact floor of `a * k / n`, for `n <= 2^63`; `u32::MAX` where it does not fit, or `n` is
/// zero.
///
/// As fast as [`mul_div`] if `a` and `n` are words, else some 700 instructions on a Cortex-M0. Use
/// it for rare results that must be exact: points on segments, replies of velocities.
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

/// The floor of a product of 96 bits over `n`. The product is given by its top 64 and its low 64
/// bits, and `n` is above the top.
#[inline(always)]
pub(super) const fn by_wide_reciprocal((top, lo): (u64, u64), n: u64) -> u32 {
    // With N = n 2^shift >= 2^63 and P = a k 2^shift < 2^32 N: P / N from the top 64 bits of the 96
    // of P and the top 32 of N.
    let shift = leading_zeros64(n);
    let top = if shift < 32 { (top << shift) | ((lo as u32 as u64) << shift >> 32) } else { lo << (shift - 32) };
    let (nh, nl) = ((n << shift >> 32) as u32, (n << shift) as u32);
    let y = recip(nh);
    let sum = umul((top >> 32) as u32, y).wrapping_add(umul(top as u32, y) >> 32);
    // The low half of N makes that too large by at most 2 and a fraction; the reciprocal's 26.5
    // parts in 2^32 of 2 and two truncations make it too small by at most 55. So what is short,
    // from 3 less, is below 64.
    let mut q = (sum >> 31).saturating_sub(3) as u32;
    // The remainder and N in units of 2^32, a little too small and too large: q stays no more than
    // exact, and ends at most 1 short.
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
