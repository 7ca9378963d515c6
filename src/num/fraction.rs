//! The time of a hit: a fraction of a motion, rounded down.

use super::{LONG, SPLIT};

/// The floor of `num / den` in parts of 2^30, for `0 < num <= den < 2^31`.
#[inline]
pub(crate) fn fraction(num: u32, den: u32) -> u32 {
    if LONG { (u64::from(num) << 30).checked_div(u64::from(den)).unwrap_or(0) as u32 } else { by_digits(num, den) }
}

/// Long division in three digits of ten bits, each from a 16-bit reciprocal that is never too large. A digit is short by less than
/// 0.11 before it is floored, as each of its three factors adds: the remainder without its low 15 bits 2^-5, the divisor so 2^-5, the reciprocal
/// 2^10 times 2^-14.4. So it is right or one too small, and the remainder, below `2 den`, tells.
#[inline]
fn by_digits(num: u32, den: u32) -> u32 {
    let (mut rest, mut den) = (num, den);
    if SPLIT {
        // No instruction counts leading zeros there.
        while den < 1 << 30 {
            den <<= 1;
            rest <<= 1;
        }
    } else {
        let shift = den.leading_zeros().wrapping_sub(1) & 31;
        den <<= shift;
        rest <<= shift;
    }
    // 2^31 / d for d in 2^15..=2^16: the line 48/17 - 32/17 d is off by 1/17 at most, and each step of Newton squares that.
    let d = (den >> 15).wrapping_add(1);
    let r = 92_521u32.wrapping_sub(d.wrapping_mul(61_681) >> 16);
    let e = (1u32 << 31).wrapping_sub(d.wrapping_mul(r)) as i32;
    let r = r.wrapping_add(((r as i32).wrapping_mul(e >> 12) >> 19) as u32);
    let e = (1u32 << 31).wrapping_sub(d.wrapping_mul(r)) as i32;
    let r = r.wrapping_add(((r as i32).wrapping_mul(e >> 8) >> 23) as u32);
    let (mut q, mut digits) = (0u32, 3);
    while digits != 0 {
        let digit = (rest >> 15).wrapping_mul(r) >> 21;
        rest = (rest << 10).wrapping_sub(digit.wrapping_mul(den));
        q = (q << 10).wrapping_add(digit);
        if rest >= den {
            rest = rest.wrapping_sub(den);
            q = q.wrapping_add(1);
        }
        digits -= 1;
    }
    q
}

#[cfg(test)]
mod tests {
    use super::{by_digits, fraction};

    fn check(num: u32, den: u32) {
        let floor = (u64::from(num) << 30) / u64::from(den);
        assert_eq!((u64::from(fraction(num, den)), u64::from(by_digits(num, den))), (floor, floor), "{num} / {den}");
    }

    /// All small fractions; all divisors that differ in the bits that the reciprocal sees, and those next to them, with numerators that leave
    /// remainders close to 0 and to the divisor.
    #[test]
    fn is_the_exact_floor() {
        for den in 1..600 {
            for num in 1..=den {
                check(num, den);
            }
        }
        for top in 1u32 << 15..1 << 16 {
            for low in [0, 1, 0x3fff, 0x4000, 0x7ffe, 0x7fff] {
                let den = top << 15 | low;
                for num in [1, 2, 3, den / 3, den / 2, den - 2, den - 1, den, 0x2aaa_aaaa % den, 0x1234_5678 % den + 1]
                {
                    check(num, den);
                }
                // Quotients q / 2^10 and q / 2^20, just reached and just missed.
                for q in [1u64, 511, 1023, 0x5_5555, 0xf_fffe] {
                    let num = (u64::from(den) * q).div_ceil(1 << if q < 1024 { 10 } else { 20 }) as u32;
                    check(num, den);
                    check(num.max(2) - 1, den);
                }
            }
        }
    }
}
