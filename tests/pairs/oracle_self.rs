//! Checks the judge: the 256-bit oracle against big rationals, and its integers against big
//! integers.
//!
//! `TILESAT_RATIONAL_CASES` sets the number of cases per class, over all pairs (default 10 000; the
//! full run takes 1 000 000).

use tilesat_judge::Random;
use tilesat_judge::num_bigint::{BigInt, BigUint, Sign};
use tilesat_judge::num_rational::BigRational;
use tilesat_judge::oracle::figure::{Figure, PAIRS};
use tilesat_judge::oracle::generate::{CLASSES, Class, Pairs};
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::oracle::measure::{self, Measure};
use tilesat_judge::oracle::rational;
use tilesat_judge::oracle::sum::Place;

fn big(n: Int256) -> BigInt {
    let bytes: Vec<u8> = n.limbs().iter().flat_map(|limb| limb.to_le_bytes()).collect();
    BigInt::from_signed_bytes_le(&bytes)
}

fn cases() -> u64 {
    std::env::var("TILESAT_RATIONAL_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(10_000)
}

/// Of any size up to `bits` bits, with runs of ones and zeros as often as random bits.
fn number(r: &mut Random, bits: u32) -> (Int256, BigInt) {
    let mut limb = || match r.below(4) {
        0 => 0,
        1 => u64::MAX,
        _ => r.next(),
    };
    let words = [limb(), limb(), limb(), limb()];
    let keep = r.below(i64::from(bits) + 1) as u32;
    let bytes: Vec<u8> = words.iter().flat_map(|w| w.to_le_bytes()).collect();
    let magnitude = BigUint::from_bytes_le(&bytes) & ((BigUint::from(1u8) << keep) - 1u8);
    let value = BigInt::from_biguint(if r.one_in(2) { Sign::Plus } else { Sign::Minus }, magnitude);
    let shift = |n: i64| Int256::new(n);
    // Built from 32-bit digits, with the multiplication and addition under test.
    let base = shift(1 << 32);
    let digits = value.magnitude().to_u32_digits();
    let built = digits.iter().rev().fold(Int256::ZERO, |sum, d| sum * base + shift(i64::from(*d)));
    (if value.sign() == Sign::Minus { -built } else { built }, value)
}

#[test]
fn int256_equals_big_integers() {
    let mut r = Random::new(1);
    for _ in 0..200_000 {
        let (a, wide_a) = number(&mut r, 254);
        let (b, wide_b) = number(&mut r, 254);
        assert_eq!(big(a), wide_a);
        assert_eq!(big(a + b), &wide_a + &wide_b);
        assert_eq!(big(a - b), &wide_a - &wide_b);
        assert_eq!(big(-a), -&wide_a);
        assert_eq!(big(a.abs()), BigInt::from(wide_a.magnitude().clone()));
        assert_eq!(a.cmp(&b), wide_a.cmp(&wide_b));
        assert_eq!(a.signum(), big(a).sign() as i32 - Sign::NoSign as i32);
        let half = r.below(255) as u32;
        let (c, wide_c) = number(&mut r, half);
        let (d, wide_d) = number(&mut r, 254 - half);
        assert_eq!(big(c * d), wide_c * wide_d);
        let (m, n) = (r.next() as i64, r.next() as i64);
        assert_eq!(big(Int256::product(m, n)), BigInt::from(m) * BigInt::from(n));
    }
}

fn check(a: &Figure, b: &Figure) {
    let m = Measure::new(a, b);
    let square = BigRational::new(big(m.square.num), big(m.square.den));
    assert_eq!(m.overlaps(), rational::overlaps(a, b), "overlaps {a:?} {b:?}");
    assert_eq!(m.touches(), rational::touches(a, b), "touches {a:?} {b:?}");
    let exit = rational::square_exit(a, b);
    assert_eq!(m.place == Place::Inside, exit.is_some(), "interior {a:?} {b:?}");
    let expected = exit.unwrap_or_else(|| rational::square_distance(a, b));
    assert_eq!(square, expected, "squared distance {a:?} {b:?}");
    for (a, b) in [(a, b), (b, a)] {
        assert_eq!(measure::contains(a, b), rational::contains(a, b), "contains {a:?} {b:?}");
    }
}

#[test]
fn oracle_equals_big_rationals() {
    let each = cases().div_ceil(PAIRS.len() as u64);
    for class in CLASSES {
        std::thread::scope(|scope| {
            for half in [&PAIRS[..3], &PAIRS[3..]] {
                scope.spawn(move || {
                    for &pair in half {
                        let mut pairs = Pairs::new(pair, class, 0x7e57);
                        for _ in 0..each {
                            let (a, b) = pairs.next();
                            check(&a, &b);
                        }
                    }
                });
            }
        });
        println!("{class:?}: oracle and rationals agree on {each} cases for each of {} pairs", PAIRS.len());
    }
}

/// A class that did not reach its subject would test nothing.
#[test]
fn classes_hold_what_they_say() {
    for pair in PAIRS {
        for class in CLASSES {
            let mut pairs = Pairs::new(pair, class, 3);
            let (mut touch, mut apart, mut overlap) = (0, 0, 0);
            for _ in 0..4000 {
                let (a, b) = pairs.next();
                let m = Measure::new(&a, &b);
                match (m.overlaps(), m.touches()) {
                    (true, true) => overlap += 1,
                    (false, true) => touch += 1,
                    (false, false) => apart += 1,
                    (true, false) => panic!("overlap without touch: {a:?} {b:?}"),
                }
            }
            println!("{pair:?} {class:?}: overlap {overlap} touch {touch} apart {apart}");
            match class {
                Class::Exact => assert!(touch > 3000, "{pair:?} {class:?}"),
                Class::Near => assert!(touch > 40 && apart > 400 && overlap > 400, "{pair:?} {class:?}"),
                Class::Deep => assert!(overlap > 1000, "{pair:?} {class:?}"),
                _ => assert!(apart > 400 && overlap > 40, "{pair:?} {class:?}"),
            }
        }
    }
}
