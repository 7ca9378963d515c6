//! Products, roots, reciprocals and quotients against 128-bit arithmetic of the host.
//!
//! `cargo test --test pairs numbers:: -- --ignored` sweeps every 32-bit operand.

use tilesat::num::{
    div_sqrt, imul, imul_split, isqrt64, isqrt64_ceil, less128, mul_div, mul_div_wide, mul64, recip, rsqrt, sqr64,
    umul, umul_split, usqr, usqr_split,
};
use tilesat::{Axis, Fx, Toi, Vec2};
use tilesat_judge::Random;
use tilesat_judge::oracle::exit::is_unit;

const RANDOM_CASES: u32 = 1_000_000;

/// Ends, powers of two and their neighbours, patterns of ones.
fn words() -> Vec<u64> {
    let mut all = vec![0, u64::MAX, 0xffff_0000_ffff_0000, 0x0000_ffff_0000_ffff, 0x5555_5555_5555_5555];
    for bit in 0..64 {
        let n = 1u64 << bit;
        all.extend([n - 1, n, n + 1, n.wrapping_neg(), n.wrapping_neg() - 1]);
    }
    all
}

/// Every bit length equally often.
fn word(r: &mut Random) -> u64 {
    r.next() >> r.below(64)
}

fn check_products_32(a: u32, b: u32) {
    let exact = u64::from(a) * u64::from(b);
    assert_eq!(umul(a, b), exact, "{a} * {b}");
    assert_eq!(umul_split(a, b), exact, "{a} * {b}");
    let signed = i64::from(a as i32) * i64::from(b as i32);
    let (sa, sb) = (a as i32, b as i32);
    assert_eq!((imul(sa, sb), imul_split(sa, sb)), (signed, signed), "{sa} * {sb}");
    let square = u64::from(a) * u64::from(a);
    assert_eq!((usqr(a), usqr_split(a)), (square, square), "{a} squared");
}

fn check_products_64(a: u64, b: u64) {
    let halves = |n: u128| ((n >> 64) as u64, n as u64);
    let (product, square) = (u128::from(a) * u128::from(b), u128::from(a) * u128::from(a));
    assert_eq!(mul64(a, b), halves(product), "{a} * {b}");
    assert_eq!(sqr64(a), halves(square), "{a} squared");
    assert_eq!(less128(halves(product), halves(square)), product < square);
    assert!(!less128(halves(product), halves(product)));
}

#[test]
fn products_are_exact() {
    for a in words() {
        for b in words() {
            check_products_32(a as u32, b as u32);
            check_products_64(a, b);
        }
    }
    let mut r = Random::new(11);
    for _ in 0..RANDOM_CASES {
        let (a, b) = (word(&mut r), word(&mut r));
        check_products_32(a as u32, b as u32);
        check_products_64(a, b);
        check_products_64(r.next(), r.next());
    }
}

fn check_root(n: u64) {
    let s = u128::from(isqrt64(n));
    let n = u128::from(n);
    assert!(s * s <= n && n < (s + 1) * (s + 1), "root of {n}: {s}");
    let up = u128::from(isqrt64_ceil(n as u64));
    let ceiling = if s * s == n { s } else { s + 1 };
    assert_eq!(up, ceiling.min(u128::from(u32::MAX)), "root of {n} rounded up");
}

#[test]
fn roots_are_exact_next_to_every_square_near_a_power_of_two() {
    for n in words() {
        check_root(n);
        let s = n >> 32;
        for s in s.saturating_sub(40)..=(s + 40).min(u64::from(u32::MAX)) {
            let square = s * s;
            check_root(square.saturating_sub(1));
            check_root(square);
            check_root(square + 1);
        }
    }
}

#[test]
fn roots_are_exact_on_random_words() {
    let mut r = Random::new(12);
    for _ in 0..RANDOM_CASES {
        check_root(word(&mut r));
        let s = word(&mut r) >> 32;
        check_root((s * s).saturating_sub(1));
        check_root(s * s);
    }
}

/// `2^47 / sqrt(h)` is between `y - 1.992` and `y + 1.526`: the extremes over all words.
fn check_rsqrt(h: u32) {
    let y = u128::from(rsqrt(h));
    let thousandths = |n: u128| n * n * u128::from(h);
    let exact = 1_000_000u128 << 94;
    assert!(thousandths(1000 * y - 1992) <= exact && exact <= thousandths(1000 * y + 1526), "rsqrt of {h}: {y}");
}

/// `2^63 / d` is in `y .. y + 26.5`.
fn check_recip(d: u32) {
    let (y, d) = (u128::from(recip(d)), u128::from(d));
    assert!(y * d <= 1 << 63 && 1 << 64 < (2 * y + 53) * d, "recip of {d}: {y}");
}

/// The steps of the tables are 2^25 wide. Their ends have the worst start values.
fn sweep(from: u32, stride: usize, check: impl Fn(u32)) {
    (from..=u32::MAX).step_by(stride).for_each(&check);
    for knot in (u64::from(from)..1 << 32).step_by(1 << 25) {
        for near in knot.saturating_sub(500)..knot + 500 {
            u32::try_from(near).iter().filter(|n| **n >= from).for_each(|n| check(*n));
        }
    }
    (u32::MAX - 500..=u32::MAX).for_each(&check);
}

#[test]
fn reciprocal_root_stays_within_its_bounds() {
    sweep(1 << 30, 509, check_rsqrt);
}

#[test]
fn reciprocal_stays_within_its_bounds() {
    sweep(1 << 31, 509, check_recip);
}

#[test]
#[ignore = "every 32-bit word: some minutes"]
fn reciprocals_of_every_word() {
    std::thread::scope(|scope| {
        scope.spawn(|| (1u32 << 30..=u32::MAX).for_each(check_rsqrt));
        scope.spawn(|| (1u32 << 31..=u32::MAX).for_each(check_recip));
    });
}

#[test]
#[ignore = "ten thousand million roots: some minutes"]
fn roots_of_every_high_word() {
    let sweep = |from: u32, to: u32| {
        for h in from..=to {
            for low in [0, 0x8000_0000, 0xffff_ffff] {
                let n = u64::from(h) << 32 | low;
                let s = u64::from(isqrt64(n));
                // s <= 2^32 - 1: s^2 fits, and n - s^2 <= 2 s says n < (s + 1)^2.
                assert!(s * s <= n && n - s * s <= 2 * s, "root of {n}: {s}");
            }
        }
    };
    std::thread::scope(|scope| {
        scope.spawn(|| sweep(1 << 30, 5 << 29));
        scope.spawn(|| sweep(5 << 29, u32::MAX));
    });
}

fn saturated(quotient: u128) -> u32 {
    u32::try_from(quotient).unwrap_or(u32::MAX)
}

fn check_mul_div(a: u32, b: u32, d: u32) {
    let exact = (u128::from(a) * u128::from(b)).checked_div(u128::from(d)).map_or(u32::MAX, saturated);
    assert_eq!(mul_div(a, b, d), exact, "{a} * {b} / {d}");
}

#[test]
fn quotient_of_words_is_the_exact_floor() {
    let special: Vec<u32> = words().into_iter().filter_map(|w| u32::try_from(w).ok()).collect();
    for &a in &special {
        for &b in &special {
            for &d in &special {
                check_mul_div(a, b, d);
            }
        }
    }
    let mut r = Random::new(13);
    for _ in 0..RANDOM_CASES {
        let (a, b, d) = (word(&mut r) as u32, word(&mut r) as u32, word(&mut r) as u32);
        check_mul_div(a, b, d);
        // Quotients that are whole, or one raw short of it, and those near 2^32.
        let (q, d) = ((r.next() >> 32) as u32, d.max(1));
        check_mul_div(q, d, d);
        check_mul_div(q, d - 1, d);
        check_mul_div(u32::MAX, d, d);
    }
}

fn check_mul_div_wide(a: u64, k: u32, n: u64) {
    if n <= 1 << 63 {
        let exact = (u128::from(a) * u128::from(k)).checked_div(u128::from(n)).map_or(u32::MAX, saturated);
        assert_eq!(mul_div_wide(a, k, n), exact, "{a} * {k} / {n}");
    }
}

#[test]
fn quotient_of_a_wide_product_is_the_exact_floor() {
    for a in words() {
        for n in words() {
            for k in [0, 1, 2, 3, 0x7fff_ffff, 0x8000_0000, u32::MAX] {
                check_mul_div_wide(a, k, n);
            }
        }
    }
    let mut r = Random::new(14);
    for _ in 0..RANDOM_CASES / 4 {
        let (a, k, n) = (word(&mut r), word(&mut r) as u32, (word(&mut r) >> 1).max(1));
        check_mul_div_wide(a, k, n);
        check_mul_div_wide(a.min(n), u32::MAX, n);
        check_mul_div_wide(n - 1, k, n);
        check_mul_div_wide(n, k, n);
    }
}

fn check_div_sqrt(s: u64, n: u64) {
    let square = u128::from(s) * u128::from(s);
    // None: above every 128-bit number, hence above s^2.
    let above = |q: u128| (q * q).checked_mul(u128::from(n)).is_none_or(|x| x > square);
    let q = div_sqrt(s, n);
    if n > 0 && above(1 << 31) {
        assert!(!above(q.into()) && above(u128::from(q) + 1), "{s} / sqrt({n}): {q}");
    } else {
        assert_eq!(q, u32::MAX, "{s} / sqrt({n})");
    }
}

#[test]
fn quotient_by_a_root_is_the_exact_floor() {
    for s in words() {
        for n in words() {
            check_div_sqrt(s, n);
        }
    }
    let mut r = Random::new(15);
    for _ in 0..RANDOM_CASES / 4 {
        let n = word(&mut r).max(1);
        check_div_sqrt(word(&mut r), n);
        // An exact quotient and its neighbours.
        let (q, root) = (word(&mut r) >> 32, (word(&mut r) >> 32).max(1));
        for s in [(q * root).saturating_sub(1), q * root, q * root + 1] {
            check_div_sqrt(s, root * root);
        }
    }
}

fn check_unit(x: i32, y: i32) {
    let n = Axis::new(x, y).unit().raw();
    assert!(is_unit((x.into(), y.into()), (n.0.into(), n.1.into())), "unit of ({x}, {y}): {n:?}");
    for length in [0, 1, -1, 3 << 14, -(1 << 16) - 1, (1 << 29) - 1, i32::MAX, i32::MIN] {
        let part = |unit: i32| (i64::from(unit) * i64::from(length) / (1 << 30)).min(i32::MAX.into()) as i32;
        let scaled = Axis::new(x, y).unit().scaled(Fx::from_bits(length)).raw();
        assert_eq!(scaled, (part(n.0), part(n.1)), "unit of ({x}, {y}) scaled to {length}");
    }
    if x > i32::MIN && y > i32::MIN {
        assert_eq!(Axis::new(-x, y).unit().raw(), (-n.0, n.1), "mirrored ({x}, {y})");
        assert_eq!(Axis::new(x, -y).unit().raw(), (n.0, -n.1), "mirrored ({x}, {y})");
        assert_eq!(Axis::new(y, x).unit().raw(), (n.1, n.0), "transposed ({x}, {y})");
    }
}

#[test]
fn unit_vectors_are_within_one_and_a_half() {
    for x in -60..=60 {
        for y in -60..=60 {
            if (x, y) != (0, 0) {
                check_unit(x, y);
            }
        }
    }
    let special: Vec<i32> = words().into_iter().map(|w| w as i32).collect();
    for &x in &special {
        for &y in &special {
            if (x, y) != (0, 0) {
                check_unit(x, y);
            }
        }
    }
    let mut r = Random::new(16);
    for _ in 0..RANDOM_CASES {
        check_unit((word(&mut r) >> 32) as i32 | 1, (word(&mut r) >> 32) as i32);
        check_unit(r.next() as i32 | 1, r.next() as i32);
    }
    assert_eq!(Axis::new(0, 0).unit(), Axis::X.unit());
    for (axis, raw) in [(Axis::X, (1, 0)), (Axis::Y, (0, 1)), (Axis::NEG_X, (-1, 0)), (Axis::NEG_Y, (0, -1))] {
        assert_eq!(axis.unit().raw(), (raw.0 << 30, raw.1 << 30));
    }
}

/// Rounding is to nearest (the mean error is 0.15 units, the error of the reciprocal root).
/// Truncation would keep the bound above and miss this.
#[test]
#[expect(clippy::cast_precision_loss, reason = "a mean to two digits")]
fn unit_vectors_are_not_biased() {
    let mut r = Random::new(18);
    let mut sum = 0.0;
    for _ in 0..RANDOM_CASES / 4 {
        let (x, y) = (r.within(1, i64::from(i32::MAX)), r.within(1, i64::from(i32::MAX)));
        let n = Axis::new(x as i32, y as i32).unit().raw();
        let one = (1u64 << 30) as f64 / (x as f64).hypot(y as f64);
        sum += f64::from(n.0) - x as f64 * one + f64::from(n.1) - y as f64 * one;
    }
    let mean = sum / f64::from(RANDOM_CASES / 2);
    println!("mean error {mean:.3} units");
    assert!(mean.abs() < 0.25, "{mean}");
}

#[test]
fn vectors_and_fractions_of_motions() {
    let mut r = Random::new(17);
    for _ in 0..RANDOM_CASES / 4 {
        let mut component = || (r.next() >> 32) as i32 >> 1;
        let (a, b) = ((component(), component()), (component(), component()));
        let (v, w) = (Vec2::from_raw(a.0, a.1), Vec2::from_raw(b.0, b.1));
        let product = |x: i32, y: i32| i64::from(x) * i64::from(y);
        assert_eq!(v.dot(w), product(a.0, b.0) + product(a.1, b.1));
        assert_eq!(v.perp_dot(w), product(a.0, b.1) - product(a.1, b.0));
        let length = u64::from(isqrt64((product(a.0, a.0) + product(a.1, a.1)) as u64));
        assert_eq!(v.length(), Fx::from_bits(i32::try_from(length).unwrap_or(i32::MAX)));
        let part = r.within(0, 1 << 30);
        let toi = Toi::from_raw(part as u32).unwrap_or(Toi::ZERO);
        let scaled = |n: i32| (i128::from(n) * i128::from(part) / (1 << 30)) as i32;
        assert_eq!(toi.of(v).raw(), (scaled(a.0), scaled(a.1)), "{part} of {v:?}");
    }
    assert_eq!(Toi::from_raw((1 << 30) + 1), None);
}
