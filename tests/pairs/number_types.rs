//! The public numbers against 128-bit arithmetic of the host, and the limits of shapes.

use tilesat::num::DOMAIN;
use tilesat::prelude::*;
use tilesat::{Aabb, Axis, Circle, Fx, Mover, Quantity, RangeError, Segment, Toi, Vec2, fx};
use tilesat_judge::Random;

/// Units, ends, zero, and their neighbours, with each sign.
fn words() -> Vec<i32> {
    let sizes = [0, 1, 2, 3, 7, 65_536, (1 << 28) - 1, 1 << 28, (1 << 30) - 1, 1 << 30];
    sizes.into_iter().flat_map(|n| [n, -n]).collect()
}

fn pairs() -> Vec<(i32, i32)> {
    let mut r = Random::new(5);
    let any =
        (0..400).map(|_| (r.around(1 << 30) as i32, (r.sign() * r.magnitude(1 << 30)) as i32)).collect::<Vec<_>>();
    words().into_iter().flat_map(|x| words().into_iter().map(move |y| (x, y))).chain(any).collect()
}

#[test]
fn products_of_directions_are_exact() {
    let all = pairs();
    for (i, &(x, y)) in all.iter().enumerate() {
        let a = Axis::new(x, y);
        let square = i128::from(x).pow(2) + i128::from(y).pow(2);
        assert_eq!(i128::from(a.length_squared()), square, "{a:?}");
        assert_eq!(a.is_zero(), square == 0, "{a:?}");
        assert_eq!((a.perp(), -a, a.reversed()), (Axis::new(-y, x), Axis::new(-x, -y), Axis::new(-x, -y)));
        for &(u, v) in all.iter().skip(i % 7).step_by(7) {
            let (b, w) = (Axis::new(u, v), Vec2::from_raw(u, v));
            let product = |p: i32, q: i32| i128::from(p) * i128::from(q);
            let (dot, cross) = (product(x, u) + product(y, v), product(x, v) - product(y, u));
            assert_eq!((i128::from(a.dot(b)), i128::from(a.dot_vec(w))), (dot, dot), "{a:?} {b:?}");
            assert_eq!(i128::from(a.perp_dot(b)), cross, "{a:?} {b:?}");
            let here = Vec2::from_raw(x, y);
            assert_eq!((i128::from(here.dot(w)), i128::from(here.perp_dot(w))), (dot, cross), "{here:?} {w:?}");
        }
    }
}

/// `i32::MIN` has no opposite. Movers take the nearest direction, and products are exact unless all
/// four components are that.
#[test]
fn directions_without_an_opposite() {
    const MIN: i32 = i32::MIN;
    for (x, y) in [(0, MIN), (MIN, 0), (MIN, 7), (-9, MIN), (MIN, MIN)] {
        let (a, nearest) = (Axis::new(x, y), Axis::new(x.max(-i32::MAX), y.max(-i32::MAX)));
        assert_eq!(Mover::platformer(a), Mover::platformer(nearest), "{a:?}");
        for (u, v) in [(MIN, i32::MAX), (i32::MAX, MIN), (-1, MIN), (0, MIN), (1, 0), (MIN, MIN)] {
            let b = Axis::new(u, v);
            let product = |p: i32, q: i32| i128::from(p) * i128::from(q);
            assert_eq!(i128::from(a.perp_dot(b)), product(x, v) - product(y, u), "{a:?} {b:?}");
            if [x, y, u, v] != [MIN; 4] {
                assert_eq!(i128::from(a.dot(b)), product(x, u) + product(y, v), "{a:?} {b:?}");
            }
        }
        let (size, unit) = (f64::from(x).hypot(f64::from(y)), a.unit());
        for (part, unit) in [(x, unit.x()), (y, unit.y())] {
            let off = unit.to_num::<f64>() - f64::from(part) / size;
            assert!(off.abs() < 1.5 / f64::from(1 << 30), "{a:?}: off by {off}");
        }
    }
}

/// Width, precision, sign and fill are those of each component.
#[test]
fn vectors_print_as_their_components() {
    let v = Vec2::new(fx!(1.5), fx!(-2));
    assert_eq!(v.to_string(), "(1.5, -2)");
    for (x, y) in pairs() {
        let v = Vec2::from_raw(x, y);
        let (x, y) = (v.x, v.y);
        assert_eq!(format!("{v}"), format!("({x}, {y})"));
        assert_eq!(format!("{v:.2}"), format!("({x:.2}, {y:.2})"));
        assert_eq!(format!("{v:14.3}"), format!("({x:14.3}, {y:14.3})"));
        assert_eq!(format!("{v:+}"), format!("({x:+}, {y:+})"));
        assert_eq!(format!("{v:*<12}"), format!("({x:*<12}, {y:*<12})"));
    }
}

#[test]
fn sums_of_vectors_saturate() {
    let all = pairs();
    let ends = [(i32::MAX, i32::MIN), (i32::MIN, i32::MAX), (i32::MIN, i32::MIN), (i32::MAX, i32::MAX)];
    for &(x, y) in all.iter().step_by(3).chain(&ends) {
        let a = Vec2::from_raw(x, y);
        assert_eq!((-a).raw(), (x.saturating_neg(), y.saturating_neg()));
        let square = i128::from(x).pow(2) + i128::from(y).pow(2);
        assert_eq!(i128::from(a.length_squared()), square, "{a:?}");
        let length = i128::from(a.length().to_bits());
        let full = length == i128::from(i32::MAX);
        assert!(length * length <= square && (full || square < (length + 1).pow(2)), "{a:?}: {length}");
        for &(u, v) in all.iter().step_by(5).chain(&ends) {
            let b = Vec2::from_raw(u, v);
            let (sum, difference) =
                ((x.saturating_add(u), y.saturating_add(v)), (x.saturating_sub(u), y.saturating_sub(v)));
            assert_eq!(
                ((a + b).raw(), a.saturating_add(b).raw(), (a - b).raw()),
                (sum, sum, difference),
                "{a:?} {b:?}"
            );
            let (mut more, mut less) = (a, a);
            more += b;
            less -= b;
            assert_eq!((more.raw(), less.raw()), (sum, difference), "{a:?} {b:?}");
            assert_eq!((a.min(b).raw(), a.max(b).raw()), ((x.min(u), y.min(v)), (x.max(u), y.max(v))), "{a:?} {b:?}");
        }
        let fields = [Fx::from_bits(x), Fx::from_bits(y)];
        assert_eq!((Vec2::from(fields), Vec2::from((fields[0], fields[1])), <[Fx; 2]>::from(a)), (a, a, fields));
    }
}

#[test]
fn times_are_parts_of_motions() {
    let one = 1u32 << 30;
    assert_eq!((Toi::from_raw(one), Toi::from_raw(one + 1), Toi::from_raw(0)), (Some(Toi::ONE), None, Some(Toi::ZERO)));
    for raw in [0, 1, 2, 3, 1 << 14, (1 << 14) - 1, one / 3, one / 2, one - 1, one] {
        let toi = Toi::from_raw(raw).expect("at most one");
        assert_eq!((toi.raw(), toi.to_fx().to_bits()), (raw, (raw >> 14) as i32));
        for (x, y) in pairs() {
            let part = |d: i32| (i128::from(d) * i128::from(raw) / i128::from(one)) as i32;
            assert_eq!(toi.of(Vec2::from_raw(x, y)).raw(), (part(x), part(y)), "{toi:?} of {x}, {y}");
        }
    }
}

/// The first number that each constructor refuses, and the last one that it accepts.
#[test]
fn shapes_end_at_the_domain() {
    let most = DOMAIN - 1;
    let at = |x: i32, y: i32| Vec2::from_raw(x, y);
    let error = |what, value| Some(RangeError { what, value });
    for end in [most, -most] {
        let over = end + end.signum();
        let (zero, x, y) = (Vec2::ZERO, at(over, 0), at(0, over));
        assert!(Segment::new(at(end, end), at(-end, end)).is_ok());
        for (v, what) in [(x, Quantity::X), (y, Quantity::Y)] {
            assert_eq!(Segment::new(v, zero).err(), error(what, over));
            assert_eq!(Segment::new(zero, v).err(), error(what, over));
            assert_eq!(Aabb::new(v.min(zero), v.max(zero)).err(), error(what, over));
            assert_eq!(Aabb::new(v, v).err(), error(what, over));
            assert_eq!(Aabb::from_centre(v, zero).err(), error(what, over));
            assert_eq!(Circle::new(v, Fx::ZERO).err(), error(what, over));
            let unit = at(v.raw().0.signum(), v.raw().1.signum());
            let edge = at(end * unit.raw().0.abs(), end * unit.raw().1.abs());
            assert_eq!(Segment::new(edge, zero).expect("inside").translated(unit).err(), error(what, over));
            assert_eq!(Aabb::new(edge, edge).expect("inside").translated(unit).err(), error(what, over));
            assert_eq!(Circle::new(edge, Fx::ZERO).expect("inside").translated(unit).err(), error(what, over));
            let back = at(-unit.raw().0, -unit.raw().1);
            assert!(Circle::new(edge, Fx::ZERO).expect("inside").translated(back).is_ok());
        }
    }
    let r = Fx::from_bits;
    assert!(Circle::new(at(0, 0), r(most)).is_ok() && Circle::new(at(5, 0), r(most - 5)).is_ok());
    assert!(Circle::new(at(-5, 0), r(most - 5)).is_ok() && Circle::new(at(0, -5), r(most - 5)).is_ok());
    assert_eq!(Circle::new(at(0, 0), r(-1)).err(), error(Quantity::Radius, -1));
    assert_eq!(Circle::new(at(0, 0), r(DOMAIN)).err(), error(Quantity::Radius, DOMAIN));
    for (x, y) in [(6, 0), (-6, 0), (0, 6), (0, -6)] {
        assert!(Circle::new(at(x, y), r(most - 5)).is_err(), "{x} {y}");
    }
    for (x, y) in [(-1, 0), (0, -1), (DOMAIN, 0), (0, DOMAIN)] {
        assert_eq!(Aabb::from_centre(at(0, 0), at(x, y)).err(), error(Quantity::HalfExtent, x + y));
    }
    assert_eq!(Aabb::new(at(3, 0), at(2, 9)).err(), error(Quantity::Width, -1));
    assert_eq!(Aabb::new(at(0, 7), at(2, 4)).err(), error(Quantity::Height, -3));
    let b = Aabb::from_centre(at(10, 20), at(3, 4)).expect("inside");
    assert_eq!((b.min(), b.max(), b.size(), b.centre()), (at(7, 16), at(13, 24), at(6, 8), at(10, 20)));
    assert_eq!(Aabb::from_centre(at(0, 0), at(most, most)).map(|b| b.size()), Ok(at(2 * most, 2 * most)));
    let odd = Aabb::new(at(-3, -1), at(0, 2)).expect("inside");
    assert_eq!((odd.centre(), odd.union(&b)), (at(-2, 0), Aabb::new(at(-3, -1), at(13, 24)).expect("inside")));
}

/// All pairs of boxes on a small lattice, against the coordinates that are in both.
#[test]
fn boxes_have_in_common_what_both_contain() {
    let at = Vec2::from_raw;
    let boxes: Vec<Aabb> =
        (0..256).filter_map(|n: i32| Aabb::new(at(n & 3, n >> 2 & 3), at(n >> 4 & 3, n >> 6)).ok()).collect();
    assert_eq!(boxes.len(), 100);
    for a in &boxes {
        for b in &boxes {
            let common = a.intersection(b);
            assert_eq!(common.is_some(), a.touches(b), "{a:?} {b:?}");
            for n in 0..16 {
                let p = at(n & 3, n >> 2);
                let inside = |b: &Aabb| b.min().max(p) == p && b.max().min(p) == p;
                assert_eq!(common.is_some_and(|common| inside(&common)), inside(a) && inside(b), "{a:?} {b:?} {p}");
            }
        }
        for by in -2..3 {
            let (lo, hi) = (a.min() - at(by, by), a.max() + at(by, by));
            assert_eq!(a.grown(Fx::from_bits(by)), Aabb::new(lo, hi), "{a:?} {by}");
        }
    }
    let (most, all) = (DOMAIN - 1, Aabb::new(at(1 - DOMAIN, 1 - DOMAIN), at(DOMAIN - 1, DOMAIN - 1)).expect("inside"));
    assert_eq!(boxes[0].grown(Fx::from_bits(most)), Ok(all));
    for by in [Fx::MIN, Fx::MAX, Fx::DELTA] {
        assert!(all.grown(by).is_err(), "{by}");
    }
}

/// Products and quotients of 16.16 in 128 bits, toward zero.
fn scaled_exactly(v: i32, s: i32) -> i128 {
    i128::from(v) * i128::from(s) / 65_536
}

fn fits(v: i128) -> Option<i32> {
    i32::try_from(v).ok()
}

fn saturated(v: i128) -> i32 {
    v.clamp(i32::MIN.into(), i32::MAX.into()) as i32
}

fn both(v: (Option<i32>, Option<i32>)) -> Option<Vec2> {
    Some(Vec2::from_raw(v.0?, v.1?))
}

#[test]
fn vectors_scale_toward_zero_and_saturate() {
    let all = pairs();
    let ends = [(i32::MAX, i32::MIN), (i32::MIN, 1), (-1, i32::MAX), (0, i32::MIN)];
    let factors = words().into_iter().chain([i32::MAX, i32::MIN, 65_535, -65_537, 196_608]);
    for s in factors {
        let fx = Fx::from_bits(s);
        for &(x, y) in all.iter().step_by(3).chain(&ends) {
            let v = Vec2::from_raw(x, y);
            let (px, py) = (scaled_exactly(x, s), scaled_exactly(y, s));
            let product = Vec2::from_raw(saturated(px), saturated(py));
            assert_eq!((v * fx, fx * v, v.saturating_mul(fx)), (product, product, product), "{v:?} * {fx}");
            assert_eq!(v.checked_mul(fx), both((fits(px), fits(py))), "{v:?} * {fx}");
            let whole = Vec2::from_raw(x.saturating_mul(s), y.saturating_mul(s));
            assert_eq!((v * s, s * v), (whole, whole), "{v:?} * {s}");

            let exact = |v: i32, up: i128| match (i128::from(v) * up).checked_div(i128::from(s)) {
                Some(q) => q,
                None => i128::from(v.signum()) << 40, // by zero: toward the sign
            };
            let (qx, qy) = (exact(x, 65_536), exact(y, 65_536));
            let quotient = Vec2::from_raw(saturated(qx), saturated(qy));
            assert_eq!((v / fx, v.saturating_div(fx)), (quotient, quotient), "{v:?} / {fx}");
            let checked = if s == 0 { None } else { both((fits(qx), fits(qy))) };
            assert_eq!(v.checked_div(fx), checked, "{v:?} / {fx}");
            assert_eq!(v / s, Vec2::from_raw(saturated(exact(x, 1)), saturated(exact(y, 1))), "{v:?} / {s}");

            let mut assigned = [v; 4];
            assigned[0] *= fx;
            assigned[1] /= fx;
            assigned[2] *= s;
            assigned[3] /= s;
            assert_eq!(assigned, [v * fx, v / fx, v * s, v / s]);
        }
    }
    for &(x, y) in all.iter().step_by(2).chain(&ends) {
        for &(u, w) in all.iter().step_by(5).chain(&ends) {
            let (a, b) = (Vec2::from_raw(x, y), Vec2::from_raw(u, w));
            assert_eq!(a.checked_add(b), both((x.checked_add(u), y.checked_add(w))));
            assert_eq!(a.checked_sub(b), both((x.checked_sub(u), y.checked_sub(w))));
        }
    }
}

#[test]
fn whole_units_are_never_cut() {
    for x in [-32_769, -32_768, -1, 0, 1, 32_767, 32_768, 70_000, i32::MIN, i32::MAX] {
        let fits = (-32_768..=32_767).contains(&x);
        let refused = |what| RangeError { what, value: if x < 0 { i32::MIN } else { i32::MAX } };
        let raw = |x: i32| Fx::from_bits(x.wrapping_shl(16));
        assert_eq!(
            Vec2::try_from((x, 7)),
            if fits { Ok(Vec2::new(raw(x), raw(7))) } else { Err(refused(Quantity::X)) }
        );
        assert_eq!(
            Vec2::try_from((7, x)),
            if fits { Ok(Vec2::new(raw(7), raw(x))) } else { Err(refused(Quantity::Y)) }
        );
    }
    assert_eq!(Vec2::from((3_i16, -4_i16)), Vec2::from_ints(3, -4));
    assert_eq!(<(Fx, Fx)>::from(Vec2::from_ints(3, -4)), (Fx::from_num(3), Fx::from_num(-4)));
    for (raw, below) in [(0, 0), (65_535, 0), (65_536, 1), (-1, -1), (-65_536, -1), (i32::MIN, -32_768)] {
        assert_eq!(Vec2::from_raw(raw, 0).to_ints(), (below, 0));
    }
}

#[test]
fn floating_point_and_back() {
    for raw in [0, 1, -1, 3, 65_536, -98_304, (1 << 24) - 1, 1 << 30, i32::MIN] {
        let v = Vec2::from_raw(raw, -(raw / 2));
        let (x, y) = v.to_f32();
        assert_eq!(f64::from(x).to_bits(), (f64::from(raw) / 65_536.0).to_bits());
        assert_eq!(Vec2::from_f32(x, y), Some(v));
    }
    // Beyond 24 bits to nearest, ties to even.
    let (x, y) = Vec2::from_raw((1 << 24) + 1, (1 << 24) + 3).to_f32();
    assert_eq!(Vec2::from_f32(x, y).map(Vec2::raw), Some((1 << 24, (1 << 24) + 4)));
}

#[test]
fn directions_and_times_as_floating_point() {
    // Parts of 2^30, to nearest, ties to even: a step is 2^-24 from a half to one.
    let rounded = |raw: i32| (f64::from(raw) / f64::from(1 << 30)) as f32;
    for raw in
        [0_i32, 1, 3, (1 << 24) + 1, (1 << 24) + 3, (1 << 29) + 32, (1 << 29) + 96, 644_245_094, (1 << 30) - 1, 1 << 30]
    {
        let time = Toi::from_raw(raw.unsigned_abs()).unwrap();
        assert_eq!(time.to_f32().to_bits(), rounded(raw).to_bits());
    }
    for (x, y) in [(1, 0), (0, -1), (3, 4), (-1, 2), (i32::MAX, 1), (-7, -7)] {
        let unit = Axis::new(x, y).unit();
        let (raw, (x, y)) = (unit.raw(), unit.to_f32());
        assert_eq!([x, y].map(f32::to_bits), [raw.0, raw.1].map(|c| rounded(c).to_bits()));
    }
    assert_eq!(Toi::from_raw((1 << 30) - 1).map(Toi::to_f32), Some(1.0));
}

/// The doc tests show the refusals of `fx!`.
#[test]
fn literals_are_constants() {
    const ALL: [Fx; 6] = [fx!(0), fx!(-0.25), fx!(32767.99999), fx!(-32768), fx!(0.1), fx!(1e-3)];
    assert_eq!(ALL.map(Fx::to_bits), [0, -16_384, i32::MAX, i32::MIN, 6_554, 66]);
}

/// In the body of a macro, a minus and its number are two tokens with a space between.
#[test]
fn literals_inside_of_macros() {
    macro_rules! body {
        () => {
            [fx!(-1), fx!(-0.25), fx!(-32768), fx!(7)]
        };
    }
    macro_rules! passed {
        ($($value:literal)+) => {
            [$(fx!($value)),+]
        };
    }
    macro_rules! nested {
        () => {
            passed!(-1 -0.25 -32768 7)
        };
    }
    macro_rules! negated {
        ($($value:literal)+) => {
            [$(fx!(-$value)),+]
        };
    }
    macro_rules! tokens {
        ($($value:tt)+) => {
            fx!($($value)+)
        };
    }
    const RAW: [i32; 4] = [-65_536, -16_384, i32::MIN, 7 << 16];
    for all in [body!(), passed!(-1 -0.25 -32768 7), nested!()] {
        assert_eq!(all.map(Fx::to_bits), RAW);
    }
    assert_eq!(negated!(1 0.25 32768).map(Fx::to_bits).as_slice(), &RAW[..3]);
    assert_eq!([tokens!(-1), tokens!(-0.25)].map(Fx::to_bits).as_slice(), &RAW[..2]);
    // Half a raw unit and one and a half: ties to even, as for all literals.
    macro_rules! ties {
        () => {
            passed!(-0.00000762939453125 - 0.00002288818359375)
        };
    }
    assert_eq!(ties!().map(Fx::to_bits), [0, -2]);
}
