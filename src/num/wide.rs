//! Products wider than a register, from 32-bit multiplications alone where the core has no long
//! multiply.

use core::cmp::Ordering;

/// True where the core has no 32x32 -> 64 multiply: `ARMv6-M`, `ARMv4T` and `ARMv5TE` in Thumb
/// state.
///
/// Stable Rust sets no `target_feature` that distinguishes `ARMv6-M` from `ARMv7-M`. But every
/// 32-bit Arm target with `UMULL` in all its instruction states has atomic compare-and-swap, and
/// those without do not. `ARMv8-M` baseline is the one exception: it uses the compiler's call,
/// slower, with the same bits. So no build script is needed. `--cfg tilesat_split` sets it
/// anywhere, so that the host's tests can run the code of those cores.
#[doc(hidden)] // for this crate's tests
pub const SPLIT: bool = cfg!(any(tilesat_split, all(target_arch = "arm", not(target_has_atomic = "32")))) && !ARM_STATE;

/// True on `ARMv4T` and `ARMv5TE` in Arm state, which has `UMULL`. A frame of the example for the
/// Game Boy Advance takes 8 % less with it.
///
/// These targets need a nightly compiler for their core library, and a nightly shows the two
/// features. Where they are hidden, the code is split: slower, with the same bits.
const ARM_STATE: bool = cfg!(all(
    not(tilesat_split),
    target_arch = "arm",
    target_feature = "soft-float",
    not(target_feature = "thumb-mode")
));

/// True if a register holds a double word. Then products and comparisons cost less than the
/// branches that save them.
pub(crate) const LONG: bool = cfg!(all(target_pointer_width = "64", not(tilesat_split)));

/// The 64-bit product of two unsigned words.
///
/// Exact for all inputs. 18 instructions on a Cortex-M0 (the compiler's call takes 36), one on
/// cores with a long multiply.
#[inline]
#[must_use]
pub const fn umul(a: u32, b: u32) -> u64 {
    if SPLIT { umul_split(a, b) } else { (a as u64) * (b as u64) }
}

/// The 64-bit square of an unsigned word.
///
/// Exact for all inputs. 9 instructions on a Cortex-M0.
#[inline]
#[must_use]
pub const fn usqr(a: u32) -> u64 {
    if SPLIT { usqr_split(a) } else { (a as u64) * (a as u64) }
}

/// The 64-bit product of two signed words.
///
/// Exact for all inputs.
#[inline]
#[must_use]
pub const fn imul(a: i32, b: i32) -> i64 {
    if SPLIT { imul_split(a, b) } else { (a as i64) * (b as i64) }
}

/// `a b + c d`, exact for results below 2^63: one call where a product is one already.
#[inline]
pub(crate) const fn dot(a: i32, b: i32, c: i32, d: i32) -> i64 {
    if SPLIT { dot_call(a, b, c, d) } else { dot_words(a, b, c, d) }
}

#[inline(never)]
const fn dot_call(a: i32, b: i32, c: i32, d: i32) -> i64 {
    dot_words(a, b, c, d)
}

#[inline(always)]
const fn dot_words(a: i32, b: i32, c: i32, d: i32) -> i64 {
    imul(a, b).wrapping_add(imul(c, d))
}

/// `a^2 + b^2`, for sums below 2^64.
#[inline]
pub(crate) const fn norm(a: i32, b: i32) -> u64 {
    if SPLIT { norm_call(a, b) } else { norm_words(a, b) }
}

#[inline(never)]
const fn norm_call(a: i32, b: i32) -> u64 {
    norm_words(a, b)
}

#[inline(always)]
const fn norm_words(a: i32, b: i32) -> u64 {
    if SPLIT {
        usqr(a.unsigned_abs()).wrapping_add(usqr(b.unsigned_abs()))
    } else {
        // Of signed words: their sizes are two instructions more each.
        (imul(a, a) as u64).wrapping_add(imul(b, b) as u64)
    }
}

/// [`umul`] from four 16-bit products. `ARMv6-M` runs it; the tests call it everywhere.
#[doc(hidden)] // for this crate's tests
#[inline(never)]
#[must_use]
pub const fn umul_split(a: u32, b: u32) -> u64 {
    let (ah, al, bh, bl) = (a >> 16, a & 0xffff, b >> 16, b & 0xffff);
    // ah*bl + al*bh < 2^33: the carry is worth 2^16 of the high word.
    let (mid, carry) = (ah * bl).overflowing_add(al * bh);
    let (lo, carry_lo) = (al * bl).overflowing_add(mid << 16);
    let hi = (ah * bh).wrapping_add(mid >> 16).wrapping_add((carry as u32) << 16).wrapping_add(carry_lo as u32);
    ((hi as u64) << 32) | lo as u64
}

/// [`imul`] from [`umul_split`].
///
/// If a is negative, it is its bits less 2^32, so the high word is less by b. If b is negative, the
/// high word is less by a.
#[doc(hidden)] // for this crate's tests
#[inline]
#[must_use]
pub const fn imul_split(a: i32, b: i32) -> i64 {
    let p = umul_split(a as u32, b as u32);
    let hi = ((p >> 32) as i32).wrapping_sub((a >> 31) & b).wrapping_sub((b >> 31) & a);
    ((hi as i64) << 32) | (p as u32 as i64)
}

/// [`usqr`] from three 16-bit products.
#[doc(hidden)] // for this crate's tests
#[inline]
#[must_use]
pub const fn usqr_split(a: u32) -> u64 {
    let (ah, al) = (a >> 16, a & 0xffff);
    // 2*ah*al*2^16: the doubling is folded into the shifts by 17 and 15.
    let mid = ah * al;
    let (lo, carry) = (al * al).overflowing_add(mid << 17);
    let hi = (ah * ah).wrapping_add(mid >> 15).wrapping_add(carry as u32);
    ((hi as u64) << 32) | lo as u64
}

/// The 128-bit product of two unsigned double words, as `(high, low)`; such pairs compare as
/// numbers.
///
/// Exact for all inputs. The result is a pair, so no 128-bit routine of the compiler is linked. 128
/// instructions on a Cortex-M0, out of line there; 15 on a Cortex-M3.
#[inline]
#[must_use]
pub const fn mul64(a: u64, b: u64) -> (u64, u64) {
    if LONG {
        pair(a as u128 * b as u128)
    } else if SPLIT {
        mul64_call(a, b)
    } else {
        mul64_words(a, b)
    }
}

/// The 128-bit square of an unsigned double word, as `(high, low)`.
///
/// Exact for all inputs. 73 instructions on a Cortex-M0, out of line there; 7 on a Cortex-M3.
#[inline]
#[must_use]
pub const fn sqr64(a: u64) -> (u64, u64) {
    if LONG {
        pair(a as u128 * a as u128)
    } else if SPLIT {
        sqr64_call(a)
    } else {
        sqr64_words(a)
    }
}

/// [`sqr64`] of the size of a signed double word.
#[inline]
pub(crate) const fn sqr_signed(a: i64) -> (u64, u64) {
    // A signed product is one as well.
    if LONG { pair((a as i128 * a as i128) as u128) } else { sqr64(a.unsigned_abs()) }
}

#[inline(always)]
const fn pair(product: u128) -> (u64, u64) {
    ((product >> 64) as u64, product as u64)
}

#[inline(never)]
const fn mul64_call(a: u64, b: u64) -> (u64, u64) {
    mul64_words(a, b)
}

#[inline(never)]
const fn sqr64_call(a: u64) -> (u64, u64) {
    sqr64_words(a)
}

#[inline(always)]
const fn mul64_words(a: u64, b: u64) -> (u64, u64) {
    let (ah, al, bh, bl) = ((a >> 32) as u32, a as u32, (b >> 32) as u32, b as u32);
    let (ll, hh, m1, m2) = (umul(al, bl), umul(ah, bh), umul(ah, bl), umul(al, bh));
    // Three words below 2^32: no carry is lost.
    let mid = (ll >> 32) + (m1 as u32 as u64) + (m2 as u32 as u64);
    (hh + (m1 >> 32) + (m2 >> 32) + (mid >> 32), (mid << 32) | (ll as u32 as u64))
}

#[inline(always)]
const fn sqr64_words(a: u64) -> (u64, u64) {
    let (ah, al) = ((a >> 32) as u32, a as u32);
    let m = umul(ah, al);
    let (lo, carry) = usqr(al).overflowing_add(m << 33);
    (usqr(ah) + (m >> 31) + carry as u64, lo)
}

/// Compares `a^2 p` with `b^2 q`, for products below 2^192.
#[inline(never)]
pub(crate) const fn cmp_squares((a, p): (u64, u64), (b, q): (u64, u64)) -> Ordering {
    let (a, b) = (square_times(a, p), square_times(b, q));
    if a.0 == b.0 && a.1 == b.1 && a.2 == b.2 {
        Ordering::Equal
    } else if a.0 < b.0 || (a.0 == b.0 && less128((a.1, a.2), (b.1, b.2))) {
        Ordering::Less
    } else {
        Ordering::Greater
    }
}

/// `a^2 b` as [`mul128`] has it: a call, except where that would return it through memory for three
/// products.
#[cfg_attr(target_pointer_width = "64", inline(always))]
#[cfg_attr(not(target_pointer_width = "64"), inline(never))]
pub(crate) const fn square_times(a: u64, b: u64) -> (u64, u64, u64) {
    mul128(sqr64(a), b)
}

/// The product of a 128-bit and a 64-bit number, high word first; such triples compare as numbers.
/// For products below 2^192.
#[inline]
pub(crate) const fn mul128(a: (u64, u64), b: u64) -> (u64, u64, u64) {
    let (low, high) = (mul64(a.1, b), mul64(a.0, b));
    let (mid, carry) = high.1.overflowing_add(low.0);
    (high.0.wrapping_add(carry as u64), mid, low.1)
}

/// The sum of 128-bit numbers below 2^127, both as `(high, low)`.
#[inline]
pub(crate) const fn add128(a: (u64, u64), b: (u64, u64)) -> (u64, u64) {
    let (lo, carry) = a.1.overflowing_add(b.1);
    (a.0.wrapping_add(b.0).wrapping_add(carry as u64), lo)
}

/// The difference of 128-bit numbers, `a` not less than `b`, both as `(high, low)`.
#[inline]
pub(crate) const fn sub128(a: (u64, u64), b: (u64, u64)) -> (u64, u64) {
    let (lo, borrow) = a.1.overflowing_sub(b.1);
    (a.0.wrapping_sub(b.0).wrapping_sub(borrow as u64), lo)
}

/// Whether the 128-bit number `a` is less than `b`, both as `(high, low)`.
#[inline]
#[must_use]
pub const fn less128(a: (u64, u64), b: (u64, u64)) -> bool {
    // One chain of subtractions; joining words is free, and no 128-bit routine of the compiler is
    // called.
    ((a.0 as u128) << 64 | a.1 as u128) < ((b.0 as u128) << 64 | b.1 as u128)
}
