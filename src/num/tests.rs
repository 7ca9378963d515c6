//! Numbers against wider ones: what the public functions are built from.

#[allow(clippy::unwrap_used, reason = "a test")]
mod parts {
    use crate::num::part::Ratio;

    /// 0, powers of two and their neighbours, and all ones.
    fn near_powers(bits: u32) -> impl Iterator<Item = u64> {
        (0..bits).flat_map(|k| [(1 << k) - 1, 1 << k, (1u64 << k).wrapping_add(1)]).chain([u64::MAX >> (64 - bits)])
    }

    #[test]
    fn parts_are_rounded_to_their_sides() {
        let one = u128::from(Ratio::ONE.raw());
        for raw in near_powers(31).filter(|&raw| u128::from(raw) <= one).chain([1_000_000_007, 333_333_333]) {
            let ratio = Ratio::from_raw(raw as u32).unwrap();
            for n in near_powers(64).chain([0x1234_5678_9abc_def0]) {
                let (product, d) = (u128::from(n) * u128::from(raw), n as i32);
                assert_eq!(u128::from(ratio.of_wide(n)), product / one, "{n} {raw}");
                assert_eq!(u128::from(ratio.of_wide_up(n)), product.div_ceil(one), "{n} {raw}");
                let size = (u128::from(d.unsigned_abs()) * u128::from(raw)).div_ceil(one) as i32;
                assert_eq!(ratio.of_raw_up(d), if d < 0 { size.wrapping_neg() } else { size }, "{d} {raw}");
            }
        }
    }
}

mod quotients {
    use crate::num::quotient::{by_reciprocal, by_wide_reciprocal, mul_div, mul_div_wide};

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

mod unit {
    use crate::num::by_length::{div_length, unit_by};
    use crate::num::direction::{Normalised, unit_nearest};
    use crate::num::inverse_root::{InverseRoot, div_sqrt};
    use crate::num::quotient::isqrt64;
    use crate::num::{Axis, sqr64};

    /// The sides are at and beside 1, 2, 3, 5 and 7 times powers of two, in all pairs and signs. A
    /// walk over all sizes follows.
    #[test]
    fn one_reciprocal_root_gives_all_that_needs_one() {
        let sizes = (0..30).flat_map(|k| [1, 2, 3, 5, 7].map(|m| (m << k) >> 2)).filter(|v| (1..1 << 30).contains(v));
        let sides = sizes.flat_map(|v| [-1, 0, 1].map(|by| v + by)).filter(|v| (1..1 << 30).contains(v));
        let pairs = sides.clone().flat_map(|x| sides.clone().map(move |y| (x, y)));
        let walked = (0..400_000u64).map(|k| {
            let bits = k.wrapping_mul(0x9e37_79b9_7f4a_7c15);
            (((bits >> 34) >> (k % 29)) as i32 | 1, ((bits & 0x3fff_ffff) >> (k % 23)) as i32 | 1)
        });
        for (x, y) in pairs.chain(walked).step_by(tilesat_judge::thorough(7, 1)) {
            for axis in [Axis::new(x, y), Axis::new(-x, y), Axis::new(x, -y), Axis::new(-x, -y)] {
                let n = axis.length_squared();
                let inverse = InverseRoot::of(n);
                assert_eq!(unit_by(axis, inverse), unit_nearest(axis), "{axis:?}");
                assert_eq!(inverse.root(n), isqrt64(n), "{axis:?}");
                // Quotients below 2^31, just reached and just missed.
                for q in [1u64, 3, 0x1234, 0x7654_3210, (1 << 31) - 1] {
                    let s = isqrt64(n) as u64 * q;
                    for s in [s, s + q / 2, s + q].into_iter().filter(|&s| sqr64(s) < (n >> 2, n << 62)) {
                        assert_eq!(inverse.times(s, n), div_sqrt(s, n), "{axis:?} {s}");
                        let floor = |q: u64| u128::from(q).pow(2) * u128::from(n) <= u128::from(s).pow(2);
                        assert_eq!(div_length(s, axis), (div_sqrt(s, n), unit_nearest(axis)), "{axis:?} {s}");
                        let q = u64::from(div_sqrt(s, n));
                        assert!(floor(q) && !floor(q + 1), "{axis:?} {s}");
                    }
                }
            }
        }
    }

    #[test]
    fn products_are_rounded_to_nearest() {
        for recip in [1 << 31, (1 << 31) + 1, 0xb504_f333, 0xdead_beef, u32::MAX] {
            for component in [1, 2, 3, 4, 5, 0x4000_0001, 0x5a82_799a, 0x7fff_ffff] {
                let product = u64::from(component) * u64::from(recip);
                for halve in [false, true] {
                    let got = Normalised { x: 0, y: 0, recip, halve }.nearest(component);
                    let shift = 32 + u32::from(halve);
                    assert_eq!(u64::from(got), (product + (1 << (shift - 1))) >> shift, "{component} {recip} {halve}");
                }
            }
        }
    }
}

mod roots {
    use crate::num::quotient::{isqrt_words, isqrt64, root128_down, root128_up};

    /// Around squares of every size: bounds on their sides, exact below 2^64, else within a part in
    /// 2^31.
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

mod domain {
    use crate::error::{Quantity, RangeError};
    use crate::num::{DOMAIN, MOTION, check_length, check_motion};
    use crate::num::{Fx, Vec2};

    #[test]
    fn refuses_from_the_limit_on() {
        let error = |what, value| Err(RangeError { what, value });
        for limit in [MOTION, DOMAIN] {
            for most in [limit - 1, 1 - limit] {
                let over = most + most.signum();
                assert_eq!(check_motion(Vec2::from_raw(most, most), limit), Ok(()));
                assert_eq!(check_motion(Vec2::from_raw(over, over), limit), error(Quantity::MotionX, over));
                assert_eq!(check_motion(Vec2::from_raw(most, over), limit), error(Quantity::MotionY, over));
            }
        }
        for length in [0, 1, DOMAIN - 1] {
            assert_eq!(check_length(Fx::from_bits(length)), Ok(()));
        }
        for length in [-1, i32::MIN, DOMAIN, i32::MAX] {
            assert_eq!(check_length(Fx::from_bits(length)), error(Quantity::Length, length));
        }
    }
}

mod wide {
    use crate::num::{cmp_squares, square_times};

    /// Numbers that differ in one of the three words of a product only, or in none.
    #[test]
    fn squares_are_compared_in_all_words() {
        let numbers = [0, 1, 2, 3, 1 << 32, (1 << 32) + 1, (1 << 60) - 1, 1 << 60, (1 << 60) + 1];
        for (a, p) in numbers.into_iter().flat_map(|a| numbers.map(|p| (a, p))) {
            for (b, q) in numbers.into_iter().flat_map(|b| numbers.map(|q| (b, q))) {
                let expected = square_times(a, p).cmp(&square_times(b, q));
                assert_eq!(cmp_squares((a, p), (b, q)), expected, "{a} {p} {b} {q}");
            }
        }
    }
}

mod vec2 {
    use crate::num::vec2::Vec2;

    #[test]
    fn whole_units_are_shifted() {
        for (x, y) in [(3, -4), (-1, 1), (i16::MAX, i16::MIN)] {
            assert_eq!(Vec2::from_ints(x, y).raw(), (i32::from(x) * 65_536, i32::from(y) * 65_536));
        }
    }

    #[test]
    fn floating_point_is_rounded_or_refused() {
        let raw = |x: f32, y: f32| Vec2::from_f32(x, y).map(Vec2::raw);
        assert_eq!(raw(1.5, -0.25), Some((98_304, -16_384)));
        assert_eq!(raw(1.5 / 65_536.0, -2.5 / 65_536.0), Some((2, -2)));
        assert_eq!(raw(-32_768.0, 32_767.0), Some((i32::MIN, 32_767 << 16)));
        for bad in [32_768.0, -32_769.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert_eq!((raw(bad, 0.0), raw(0.0, bad)), (None, None), "{bad}");
        }
    }
}

mod toi {
    use crate::num::part::Toi;

    #[test]
    fn parts_beside_zero_are_rounded_to_a_side() {
        for raw in [0, 1, 3, 1 << 29, (1 << 29) + 1, (1 << 30) / 3, 3 << 28, (1 << 30) - 1, 1 << 30] {
            for (m, d) in (-9..=9).flat_map(|m| (-9..=9).map(move |d| (m, d))) {
                // In parts of 2^30.
                let (part, at) = (i64::from(d) * i64::from(raw), (i64::from(m) << 30) + i64::from(d) * i64::from(raw));
                for away in [true, false] {
                    let got = i64::from(Toi::exact(raw).of_raw_beside(m, d, away));
                    let size = (i64::from(m) + got).abs() << 30;
                    assert!(if away { size >= at.abs() } else { size <= at.abs() }, "{m} {d} {raw} {away}: {got}");
                    assert!(((got << 30) - part).abs() < 1 << 30, "{m} {d} {raw} {away}: {got}");
                }
            }
        }
    }
}

mod fraction {
    use crate::num::part::{by_digits, fraction};

    fn check(num: u32, den: u32) {
        let floor = (u64::from(num) << 30) / u64::from(den);
        assert_eq!((u64::from(fraction(num, den)), u64::from(by_digits(num, den))), (floor, floor), "{num} / {den}");
    }

    /// All small fractions. All divisors that differ in the bits that the reciprocal sees, and
    /// those next to them. Their numerators leave remainders close to 0 and to the divisor.
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

mod roots_at_run_time {
    use crate::num::quotient::{isqrt_words, isqrt64, root64};

    /// Numbers beside squares, where floors change: from roots near powers of two, and from a walk
    /// over all sizes. The processor, floats and words must agree.
    #[test]
    fn they_are_those_of_constants() {
        let walked = (0..200_000u64).map(|k| k.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> (32 + k % 24));
        let near = (0..=32)
            .flat_map(|bits| (0..2000).flat_map(move |by| [(1u64 << bits) + by, (1 << bits) - by.min(1 << bits)]));
        for root in walked.chain(near).filter(|root| root >> 32 == 0) {
            for n in [root * root, (root * root).saturating_sub(1), root * root + 1, root * root + 2 * root] {
                assert_eq!([root64(n), isqrt64(n)], [isqrt_words(n); 2], "{n}");
            }
        }
        for n in [u64::MAX, u64::MAX - 1, 1 << 63, (1 << 63) - 1, u64::MAX - (1 << 10), u64::MAX - (1 << 11)] {
            assert_eq!([root64(n), isqrt64(n)], [isqrt_words(n); 2], "{n}");
        }
    }
}
