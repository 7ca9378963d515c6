//! Square roots and reciprocal square roots without division: one canonical integer algorithm, the same bits on every core.
//!
//! A 7-bit table start and Newton steps in 32 bits; the root is then finished as in Zimmermann's Karatsuba square root
//! (INRIA report RR-3805), with a reciprocal multiplication where that paper divides, and corrected to the exact floor.

use super::wide::umul;

/// `round(256 / sqrt((i + 32.5) / 128)) - 256` for i in 0..96, at most 255; padded to a power of two so that a mask bounds the index.
const RSQRT_TABLE: [u8; 128] = rsqrt_table();

/// Twice the nearest integer decision of `256 / sqrt(u)`, `u = (2i + 65) / 256`: the largest t with (2t - 1)^2 u <= 512^2.
#[expect(clippy::indexing_slicing, reason = "bounded by the loop; runs in the compiler")]
const fn rsqrt_table() -> [u8; 128] {
    let mut table = [0u8; 128];
    let mut i = 0;
    while i < 96 {
        let u = 2 * i as u64 + 65;
        let mut t = 256u64;
        while t < 511 && (2 * t + 1) * (2 * t + 1) * u <= 512 * 512 * 256 {
            t += 1;
        }
        table[i] = (t - 256) as u8;
        i += 1;
    }
    table
}

/// `2^15 / sqrt(h / 2^32)` for h in `[2^30, 2^32)`, relative error below 2^-12.9; other inputs give some number.
#[inline]
#[expect(clippy::indexing_slicing, reason = "the index is masked to the table's length")]
const fn rsqrt_seed(h: u32) -> u32 {
    let t = RSQRT_TABLE[((h >> 25).wrapping_sub(32) & 127) as usize] as u32 + 256;
    let e = (h >> 18).wrapping_mul(t * t) as i32;
    let e16 = e.wrapping_sub(1 << 30) >> 14;
    let e2 = e16.wrapping_mul(e16) >> 16;
    ((t << 7) as i32)
        .wrapping_sub((t as i32).wrapping_mul(e16) >> 10)
        .wrapping_add((t as i32).wrapping_mul(e2).wrapping_mul(3) >> 12) as u32
}

/// The reciprocal square root `2^31 / sqrt(h / 2^32)` of a normalised word.
///
/// `h` must be in `[2^30, 2^32)`. The error is within -1.53 and +2.00, checked for every `h`. A call where the multiplications are calls as well.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
#[must_use]
pub const fn rsqrt(h: u32) -> u32 {
    let y0 = min32(rsqrt_seed(h), 65535);
    // e / 2^31 is twice the seed's relative error: |e| < 2^20 for h in range.
    let e = ((umul(h, y0 * y0) as i64).wrapping_sub(1i64 << 62) >> 31) as i32;
    let e8 = e >> 8;
    let second = ((e8.wrapping_mul(e8) >> 13).wrapping_mul((y0 >> 8) as i32)).wrapping_mul(3) >> 12;
    if super::wide::SPLIT {
        // floor(y0 e / 2^16) by two single multiplications: e = 256 e8 + its low byte.
        let low = ((y0 * (e as u32 & 0xff)) >> 8) as i32;
        let first = (y0 as i32).wrapping_mul(e8).wrapping_add(low) >> 8;
        (y0 << 16).saturating_add_signed(second.wrapping_sub(first))
    } else {
        let y = ((y0 as i64) << 16).wrapping_sub(super::wide::imul(y0 as i32, e) >> 16).wrapping_add(second as i64);
        if y > u32::MAX as i64 { u32::MAX } else { y as u32 }
    }
}

/// The exact floor of the square root of a double word.
///
/// Exact for all 2^64 inputs; no division. About 270 instructions on a Cortex-M0, 135 on a Cortex-M3.
#[inline(never)]
#[must_use]
pub const fn isqrt64(n: u64) -> u32 {
    if super::wide::LONG { n.isqrt() as u32 } else { isqrt_words(n) }
}

#[inline(always)]
const fn isqrt_words(n: u64) -> u32 {
    if n == 0 {
        return 0;
    }
    let shift = leading_zeros64(n) & !1;
    let m = n << shift;
    // n = m / 2^shift, so floor(sqrt n) = floor(floor(sqrt m) / 2^(shift/2)).
    isqrt_norm((m >> 32) as u32, m as u32) >> (shift >> 1)
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

/// An upper bound of the square root of a number below 2^124, within one part in 2^31 (exact ceiling below 2^64).
pub(crate) const fn root128_up(n: (u64, u64)) -> u64 {
    let (top, shift) = top_word(n);
    let (word, root) = if shift == 0 {
        (top, isqrt64(top))
    } else {
        let word = top.saturating_add(1);
        (word, isqrt_norm((word >> 32) as u32, word as u32))
    };
    // Added as a double word: the root after 2^32 - 1 has no room in a word.
    (root as u64 + (super::wide::usqr(root) != word) as u64) << (shift / 2)
}

/// The same as a lower bound (exact floor below 2^64).
pub(crate) const fn root128_down(n: (u64, u64)) -> u64 {
    let (top, shift) = top_word(n);
    let root = if shift == 0 { isqrt64(top) } else { isqrt_norm((top >> 32) as u32, top as u32) };
    (root as u64) << (shift / 2)
}

/// What the least even shift leaves in 64 bits; where it is not zero, at least 2^62.
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
    // s is the root of the high word and r its remainder; the low half of the root is about r * 2^16 / (2 s).
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

/// Leading zeros of a double word; the 64-bit builtin costs 78 instructions on `ARMv6-M`, two words of the 32-bit one less.
#[inline]
#[must_use]
pub(crate) const fn leading_zeros64(n: u64) -> u32 {
    let hi = (n >> 32) as u32;
    if hi != 0 { leading_zeros32(hi) } else { 32 + leading_zeros32(n as u32) }
}

/// Leading zeros of a word: a ladder of compares where the core has no `CLZ`.
#[inline]
#[must_use]
pub(crate) const fn leading_zeros32(n: u32) -> u32 {
    if super::wide::SPLIT { ladder(n) } else { n.leading_zeros() }
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

#[cfg(test)]
mod tests {
    use super::{isqrt_words, isqrt64, root128_down, root128_up};

    /// Around squares of every size: bounds on their sides, exact below 2^64, else within a part in 2^31.
    #[test]
    fn roots_of_double_words_are_bounds() {
        for bits in 0..62 {
            for root in [
                1u128 << bits,
                (1 << bits) + 1,
                (2 << bits) - 1,
                (3 << bits) >> 1,
                0x3243_f6a8_885a_308d >> (61 - bits),
            ] {
                let square = root * root;
                for n in [square - 1, square, square + 1, square + root] {
                    let halves = ((n >> 64) as u64, n as u64);
                    let (down, up) = (u128::from(root128_down(halves)), u128::from(root128_up(halves)));
                    assert!(down * down <= n && n <= up * up, "{n}: {down} {up}");
                    let part = if n >> 64 == 0 { 1 } else { root >> 30 };
                    assert!((down + part).pow(2) > n && (up.max(part) - part).pow(2) <= n, "{n}: {down} {up}");
                    assert!(n >> 64 != 0 || n == 0 || (up - 1).pow(2) < n, "{n}: {up}");
                    if let Ok(n) = u64::try_from(n) {
                        assert_eq!((isqrt_words(n), isqrt64(n)), (down as u32, down as u32), "{n}");
                    }
                }
            }
        }
    }
}
