//! Velocities after contacts, against exact rationals that share nothing with the kernels.

#![allow(clippy::cast_precision_loss, reason = "tests stop at the first surprise")]

use tilesat::motion::response::{bounce, respond, slide, split};
use tilesat::{Axis, Fx, Ratio, Surface, Vec2, motion::Speed};
use tilesat_judge::num_bigint::BigInt;
use tilesat_judge::plain::{P, dot, raw, vec2};
use tilesat_judge::{Random, cases};

fn axis(p: P) -> Axis {
    Axis::new(p.0 as i32, p.1 as i32)
}

fn perp(n: P) -> P {
    (-n.1, n.0)
}

const ONE: i64 = 1 << 30;

/// The exact reply as numerators over |n|^2 2^60.
fn exact(v: P, n: P, restitution: Ratio, friction: Ratio) -> ([BigInt; 2], BigInt) {
    let one = BigInt::from(ONE);
    let (s, c) = (BigInt::from(-dot(v, n)), BigInt::from(dot(v, perp(n))));
    let j = &s * (&one + restitution.raw());
    let all = &c * &one * &one;
    let most = &j * friction.raw();
    let taken = if all < BigInt::from(0) { -most.min(-all.clone()) } else { most.min(all.clone()) };
    let part = |n: i64, t: i64| &j * n * &one - &taken * t;
    let den = BigInt::from(dot(n, n)) * &one * &one;
    let t = perp(n);
    ([&den * v.0 + part(n.0, t.0), &den * v.1 + part(n.1, t.1)], den)
}

fn size_of(n: &BigInt) -> BigInt {
    if *n < BigInt::from(0) { -n } else { n.clone() }
}

/// All promises about one reply, which must be `within` raw of the exact one.
fn check(v: P, n: P, restitution: Ratio, friction: Ratio) -> P {
    let out = raw(respond(vec2(v), axis(n), restitution, friction).unwrap());
    let tell = || format!("{v:?} at {n:?}, {restitution:?} {friction:?}: {out:?}");
    if dot(v, n) >= 0 {
        assert_eq!(out, v, "{}", tell());
        return out;
    }
    assert!(dot(out, n) >= 0, "into the surface: {}", tell());
    assert!(dot(out, out) <= dot(v, v), "faster: {}", tell());
    let (num, den) = exact(v, n, restitution, friction);
    let straight = n.0 == 0 || n.1 == 0;
    for (num, out) in num.iter().zip([out.0, out.1]) {
        let off = num - &den * out;
        let size = size_of(&off);
        assert!(size <= &den * (if straight { 1 } else { 2 }), "far off: {}", tell());
        assert!(!straight || &den * out.abs() <= size_of(num), "not toward rest: {}", tell());
        let whole = [Ratio::ZERO, Ratio::ONE].contains(&restitution) && friction.raw() == 0;
        assert!(!(straight && whole) || size == BigInt::from(0), "not exact: {}", tell());
    }
    out
}

fn ratios() -> [Ratio; 5] {
    [Ratio::ZERO, Ratio::new(1, 3).unwrap(), Ratio::HALF, Ratio::percent(70).unwrap(), Ratio::ONE]
}

#[test]
fn every_small_velocity_at_every_small_normal() {
    let span = |n: i64| (-n..=n).flat_map(move |x| (-n..=n).map(move |y| (x, y)));
    for v in span(9) {
        for n in span(5).filter(|n| *n != (0, 0)) {
            for restitution in ratios() {
                for friction in ratios() {
                    let out = check(v, n, restitution, friction);
                    let at = |v: P, n: P| raw(respond(vec2(v), axis(n), restitution, friction).unwrap());
                    assert_eq!(at((-v.0, v.1), (-n.0, n.1)), (-out.0, out.1), "{v:?} {n:?}: mirrored in x");
                    assert_eq!(at((v.0, -v.1), (n.0, -n.1)), (out.0, -out.1), "{v:?} {n:?}: mirrored in y");
                }
            }
        }
    }
}

fn any(r: &mut Random, limit: i64) -> P {
    (r.sign() * r.magnitude(limit), r.sign() * r.magnitude(limit))
}

#[test]
fn velocities_and_normals_of_all_sizes() {
    let mut r = Random::new(7);
    for case in 0..cases(60_000) {
        let limit = if case % 4 == 0 { i64::from(i32::MAX) } else { 1 << (case % 29 + 1) };
        let (mut v, n) = (any(&mut r, (1 << 29) - 1), any(&mut r, limit));
        if case % 3 == 0 {
            // Grazing: along the surface, within a raw unit or two.
            let k = 1 + (1 << 29) / (n.0.abs().max(n.1.abs()) + 1);
            let k = r.around(k);
            v = (-n.1 * k + r.around(2), n.0 * k + r.around(2));
            if v.0.abs().max(v.1.abs()) >= 1 << 29 {
                continue;
            }
        }
        if n == (0, 0) {
            continue;
        }
        let ratio = |r: &mut Random| {
            let some = ratios();
            if r.one_in(2) { some[r.below(5) as usize] } else { Ratio::from_raw(r.within(0, ONE) as u32).unwrap() }
        };
        let (restitution, friction) = (ratio(&mut r), ratio(&mut r));
        let out = check(v, n, restitution, friction);
        let mirrored = respond(vec2((-v.0, -v.1)), axis((-n.0, -n.1)), restitution, friction).unwrap();
        assert_eq!(raw(mirrored), (-out.0, -out.1), "{v:?} {n:?}: turned by 180 degrees");
        let mirrored = respond(vec2((-v.0, v.1)), axis((-n.0, n.1)), restitution, friction).unwrap();
        assert_eq!(raw(mirrored), (-out.0, out.1), "{v:?} {n:?}: mirrored in x");
    }
}

#[test]
fn parts_add_up_and_are_nearest() {
    let mut r = Random::new(8);
    for case in 0..cases(60_000) {
        let limit = if case % 4 == 0 { i64::from(i32::MAX) } else { 1 << (case % 29 + 1) };
        let (v, n) = (any(&mut r, (1 << 29) - 1), any(&mut r, limit));
        let parts = split(vec2(v), axis(n)).unwrap();
        let (along, across) = (raw(parts.normal), raw(parts.tangent));
        assert_eq!((along.0 + across.0, along.1 + across.1), v);
        let nn = dot(n, n);
        if nn != 0 {
            let s = BigInt::from(dot(v, n));
            for (n, along) in [(n.0, along.0), (n.1, along.1)] {
                let off: BigInt = (&s * n - BigInt::from(nn) * along) * 2;
                assert!(off <= BigInt::from(nn) && -off <= BigInt::from(nn), "{v:?} at {n:?}: {parts:?}");
            }
        }
    }
}

/// Endless elastic reflections. The speed is never above the start, and at the end all but a few
/// raw units of it are left.
#[test]
fn a_million_reflections() {
    let mut r = Random::new(9);
    for start in [(65_536, 0), (70_001, 12_345), (3, 200), (1_000_003, 999), ((1 << 28) - 1, -12_345_678)] {
        let (mut v, speed) = (vec2(start), Speed::of(vec2(start)));
        let mut least = f64::MAX;
        for _ in 0..cases(300_000) {
            let n = any(&mut r, 1 << 20);
            let n = if dot(raw(v), n) < 0 { n } else { (-n.0, -n.1) };
            let next = speed.bounce(v, axis(n)).unwrap();
            assert!(next.length_squared() <= speed.squared(), "{v:?} at {n:?}: {next:?}");
            assert!(dot(raw(next), n) >= 0);
            v = next;
            least = least.min((v.length_squared() as f64 / speed.squared() as f64).sqrt());
        }
        let lost = (1.0 - least) * (speed.squared() as f64).sqrt();
        println!("from {start:?}: least speed {least}, {lost} raw");
        assert!(lost < 2.0, "{start:?}: {lost} raw lost at the worst");
    }
}

/// The normal may have any length, up to components that have no opposite.
#[test]
fn the_longest_normals() {
    const MIN: i64 = i32::MIN as i64;
    let mut r = Random::new(11);
    for case in 0..cases(20_000) {
        let size = r.within(1, 30);
        let other = r.around(1 << size);
        let n = [(MIN, other), (other, MIN), (MIN, MIN), (MIN, 0), (0, MIN)][case as usize % 5];
        let v = any(&mut r, 1 << (case % 28 + 1));
        let (restitution, friction) = (Ratio::percent(30).unwrap(), Ratio::percent((case % 70) as u8).unwrap());
        let out = raw(respond(vec2(v), axis(n), restitution, friction).unwrap());
        if dot(v, n) >= 0 {
            assert_eq!(out, v, "{v:?} at {n:?}");
            continue;
        }
        let (numerators, den) = exact(v, n, restitution, friction);
        for (numerator, part) in numerators.iter().zip([out.0, out.1]) {
            let off = size_of(&(numerator - &den * part));
            assert!(off <= &den * 3, "{v:?} at {n:?}, {friction:?}: {out:?}");
        }
        assert!(dot(out, n) >= 0 && dot(out, out) <= dot(v, v), "{v:?} at {n:?}: {out:?}");
    }
}

/// Without the reference the same roundings add up. That is its purpose.
#[test]
fn without_a_reference_speed_bleeds() {
    let mut r = Random::new(9);
    let start = vec2((70_001, 12_345));
    let mut v = start;
    for _ in 0..200_000 {
        let n = any(&mut r, 1 << 20);
        let n = if dot(raw(v), n) < 0 { n } else { (-n.0, -n.1) };
        v = bounce(v, axis(n), Ratio::ONE).unwrap();
    }
    assert!(v.length_squared() < start.length_squared() / 2, "{v:?}");
}

#[test]
fn a_reference_follows_what_the_game_does() {
    let (v, g) = (vec2((50_000, -20_000)), vec2((0, 1_000)));
    let speed = Speed::of(v).changed(v, v + g);
    assert_eq!(speed, Speed::of(v + g));
    // A debt of speed stays.
    let owed = Speed::of(vec2((50_001, -20_000)));
    assert_eq!(owed.changed(v, v + g).squared() - (v + g).length_squared(), owed.squared() - v.length_squared());
    // So does an excess of speed.
    let fast = Speed::of(vec2((49_999, -20_000)));
    assert_eq!(fast.changed(v, v + g).squared() + v.length_squared(), (v + g).length_squared() + fast.squared());
}

#[test]
fn named_replies() {
    let v = Vec2::from_ints(10, 8);
    assert_eq!(slide(v, Axis::NEG_Y), Ok(Vec2::from_ints(10, 0)));
    assert_eq!(bounce(v, Axis::NEG_Y, Ratio::HALF), Ok(Vec2::from_ints(10, -4)));
    // 10, 8 less 2 (64/25) of (4, 3): -262/25 and -184/25.
    assert_eq!(bounce(v, Axis::new(-4, -3), Ratio::ONE), Ok(Vec2::from_raw(-686_817, -482_345)));
    assert_eq!(respond(v, Axis::new(0, 0), Ratio::ONE, Ratio::ONE), Ok(v), "no normal, no contact");
    assert!(respond(Vec2::from_raw(1 << 29, 0), Axis::X, Ratio::ONE, Ratio::ONE).is_err());
    // At rest below eight units per frame.
    let dull = Surface::new(Ratio::ONE, Ratio::ZERO).resting_below(Fx::from_num(8));
    assert_eq!(dull.respond(v, Axis::NEG_Y), Ok(Vec2::from_ints(10, 0)));
    assert_eq!(dull.respond(v + Vec2::from_raw(0, 1), Axis::NEG_Y), Ok(Vec2::from_raw(10 << 16, -(8 << 16) - 1)));
}

/// A bounce approaches its reference from far off, up and down, and stays in the direction of the
/// mirror image.
#[test]
fn a_bounce_is_drawn_to_its_reference() {
    let mut r = Random::new(10);
    for case in 0..cases(60_000) {
        let (v, aim) = (any(&mut r, (1 << 28) - 1), any(&mut r, (1 << 28) - 1));
        let mut n = any(&mut r, 1 << (case % 30 + 1));
        if case % 4 == 0 {
            n = if r.one_in(2) { (r.sign(), 0) } else { (0, r.sign() * 77) };
        }
        if dot(v, n) >= 0 {
            continue;
        }
        let speed = Speed::of(vec2(aim));
        let out = raw(speed.bounce(vec2(v), axis(n)).unwrap());
        let tell = || format!("{v:?} at {n:?} drawn to {aim:?}: {out:?}");
        let straight = n.0 == 0 || n.1 == 0;
        let reference = dot(aim, aim) as f64;
        let (was, is, aimed) = ((dot(v, v) as f64).sqrt(), (dot(out, out) as f64).sqrt(), reference.sqrt());
        assert!(dot(out, n) >= 0, "{}", tell());
        if straight && (was - aimed).abs() < 1.9 {
            assert_eq!(out, if n.0 == 0 { (v.0, -v.1) } else { (-v.0, v.1) }, "{}", tell());
            continue;
        }
        let kept = dot(out, out) <= dot(aim, aim) || (straight && (was - aimed).abs() < 3.1);
        assert!(kept && (is > aimed - 3.1 || (is > was - 3.1 && aimed > 2.0 * was)), "{}", tell());
        let (mirror, _) = exact(v, n, Ratio::ONE, Ratio::ZERO);
        let cross: BigInt = &mirror[0] * out.1 - &mirror[1] * out.0;
        let size = &mirror[0] * &mirror[0] + &mirror[1] * &mirror[1];
        // Aside by at most 3 raw. More if the rounded image was short and is stretched.
        let aside = BigInt::from(3 + (3.0 * aimed / was) as i64);
        assert!(&cross * &cross <= size * &aside * &aside, "{}", tell());
        let flipped = raw(speed.bounce(vec2((v.0, -v.1)), axis((n.0, -n.1))).unwrap());
        assert_eq!(flipped, (out.0, -out.1), "{}", tell());
    }
}
