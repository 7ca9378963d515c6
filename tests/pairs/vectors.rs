//! Vectors as points and directions against plain 128-bit arithmetic, up to the ends of 16.16.

use tilesat::num::isqrt64;
use tilesat::{Axis, Fx, Ratio, Vec2};
use tilesat_judge::Random;

const MIN: i32 = i32::MIN;
const MAX: i32 = i32::MAX;

/// A small lattice, the ends of the range and of the domain, and random words of every size.
fn words() -> Vec<i32> {
    let mut r = Random::new(23);
    let ends = [MIN, MIN + 1, MIN / 2, -(1 << 29), -65_536, 65_536, 1 << 29, 1 << 30, MAX - 1, MAX];
    let any = (0..9).map(|_| (r.next() >> 32) as i32 >> r.below(32));
    (-4..=4).chain(ends).chain(any.collect::<Vec<_>>()).collect()
}

fn pairs() -> Vec<(Vec2, Vec2)> {
    let (words, mut r) = (words(), Random::new(29));
    let mut word = || words[r.below(words.len() as i64) as usize];
    let some = (0..40_000).map(|_| (Vec2::from_raw(word(), word()), Vec2::from_raw(word(), word())));
    let mut all: Vec<_> = some.collect();
    for &a in &words {
        all.extend(words.iter().map(|&b| (Vec2::from_raw(a, b), Vec2::from_raw(b, a))));
    }
    all
}

fn saturated(n: i128) -> i32 {
    n.clamp(MIN.into(), MAX.into()) as i32
}

#[test]
fn distances_of_any_two_points() {
    for (a, b) in pairs() {
        let ((ax, ay), (bx, by)) = (a.raw(), b.raw());
        let square = (i128::from(ax) - i128::from(bx)).pow(2) + (i128::from(ay) - i128::from(by)).pow(2);
        let down = i128::from(a.distance(b).to_bits());
        assert_eq!(a.distance(b), b.distance(a));
        assert!(down * down <= square, "{a:?} {b:?}");
        assert!(down == i128::from(MAX) || square < (down + 1) * (down + 1), "{a:?} {b:?}");
        if let Some(between) = b.checked_sub(a) {
            assert_eq!(a.distance(b), between.length());
        }
    }
    assert_eq!(u64::from(isqrt64(2 << 32)), 92_681);
    assert_eq!(Vec2::ZERO.distance(Vec2::from_ints(1, 1)), Fx::from_bits(92_681));
}

#[test]
fn points_between_two_points_are_rounded_toward_the_first() {
    let parts = [0, 1, 2, 3, (1 << 29) - 1, 1 << 29, (1 << 29) + 1, 357_913_941, (1 << 30) - 1, 1 << 30];
    for (a, b) in pairs() {
        assert_eq!((a.lerp(b, Ratio::ZERO), a.lerp(b, Ratio::ONE)), (a, b));
        for raw in parts {
            let part = Ratio::from_raw(raw).unwrap();
            // `/` of plain numbers rounds toward zero: of a difference, toward its start.
            let exact = |a: i32, b: i32| {
                let by = (i128::from(b) - i128::from(a)) * i128::from(raw) / (1 << 30);
                i32::try_from(i128::from(a) + by).unwrap()
            };
            let ((ax, ay), (bx, by)) = (a.raw(), b.raw());
            assert_eq!(a.lerp(b, part).raw(), (exact(ax, bx), exact(ay, by)), "{a:?} {b:?} {raw}");
            if ![ax, ay, bx, by].contains(&MIN) {
                assert_eq!((-a).lerp(-b, part), -a.lerp(b, part), "the mirrored points");
            }
            // The way back rounds to the other end: at most a raw unit beyond.
            let (there, back) = (a.lerp(b, part), b.lerp(a, part.complement()));
            let apart = [(there.x, back.x), (there.y, back.y)].map(|(p, q)| p.to_bits().abs_diff(q.to_bits()));
            assert!(apart.iter().all(|&apart| apart <= 1), "{a:?} {b:?} {raw}");
        }
    }
}

#[test]
fn components_and_quarter_turns() {
    for (a, b) in pairs() {
        let ((ax, ay), (bx, by)) = (a.raw(), b.raw());
        let wide = |n: i32| i128::from(n);
        assert_eq!(a.abs().raw(), (saturated(wide(ax).abs()), saturated(wide(ay).abs())));
        assert_eq!(a.signum().raw(), (ax.signum() << 16, ay.signum() << 16));
        assert_eq!(a.perp().raw(), (saturated(-wide(ay)), ax));
        assert_eq!((a.min(b).raw(), a.max(b).raw()), ((ax.min(bx), ay.min(by)), (ax.max(bx), ay.max(by))));
        let (lo, hi) = (a.min(b), a.max(b));
        for p in [a, b, Vec2::ZERO, Vec2::from_raw(MIN, MAX), Vec2::from_raw(3, -3)] {
            let (px, py) = p.raw();
            let inside = (px.clamp(ax.min(bx), ax.max(bx)), py.clamp(ay.min(by), ay.max(by)));
            assert_eq!(p.clamp(lo, hi).raw(), inside);
            if ax > bx && ay > by {
                assert_eq!(p.clamp(a, b), b, "bounds that are exchanged");
            }
        }
    }
    let one = 1 << 16;
    let sides = [Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y].map(Vec2::raw);
    assert_eq!(sides, [(one, 0), (0, one), (-one, 0), (0, -one)]);
}

#[test]
fn a_vector_is_its_direction() {
    for (v, _) in pairs() {
        let (x, y) = v.raw();
        assert_eq!((Axis::of(v), Axis::from(v)), (Axis::new(x, y), Axis::new(x, y)));
        assert_eq!(v.unit(), Axis::new(x, y).unit());
    }
    assert_eq!(Vec2::ZERO.unit(), Axis::X.unit());
}
