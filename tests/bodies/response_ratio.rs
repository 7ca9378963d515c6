//! Ratios: nearest, complete, and toward zero.

use tilesat::{Fx, Ratio};

const ONE: u128 = 1 << 30;

/// 0, 1, powers of two and their neighbours.
fn words() -> Vec<u32> {
    let near = |k: u32| [(1u32 << k).wrapping_sub(1), 1 << k, (1u32 << k).wrapping_add(1)];
    (0..32).flat_map(near).chain([0, u32::MAX, 3_000_000_019, 100, 360]).collect()
}

fn check(num: u32, den: u32) {
    let ratio = Ratio::new(num, den);
    if den == 0 || num > den {
        assert_eq!(ratio, None, "{num} / {den}");
        return;
    }
    let raw = u128::from(ratio.unwrap().raw());
    let twice = 2 * u128::from(num) * ONE;
    let den = u128::from(den);
    assert!(twice < (2 * raw + 1) * den && twice + den >= 2 * raw * den, "{num} / {den}: {raw}");
    if den < 1 << 31 {
        assert_eq!(Ratio::new(den as u32 - num, den as u32), Some(ratio.unwrap().complement()), "{num} / {den}");
    }
}

#[test]
fn nearest() {
    for num in 0..=70 {
        (0..=70).for_each(|den| check(num, den));
    }
    for num in words() {
        for den in words() {
            check(num, den);
        }
    }
    for hundredths in 0..=255 {
        let same = if hundredths > 100 { None } else { Ratio::new(hundredths.into(), 100) };
        assert_eq!(Ratio::percent(hundredths), same);
    }
    assert_eq!(Ratio::from_raw((1 << 30) + 1), None);
    assert_eq!((Ratio::new(7, 7), Ratio::new(0, 9)), (Some(Ratio::ONE), Some(Ratio::ZERO)));
    assert_eq!(Ratio::new(1, 2), Some(Ratio::HALF));
}

#[test]
fn parts_are_rounded_toward_zero() {
    for word in words() {
        for raw in words().into_iter().filter(|&raw| u128::from(raw) <= ONE) {
            let (ratio, length) = (Ratio::from_raw(raw).unwrap(), word as i32);
            let exact = i128::from(length) * i128::from(raw) / (ONE as i128);
            assert_eq!(i128::from(ratio.of(Fx::from_bits(length)).to_bits()), exact, "{length} {raw}");
        }
    }
}
