//! Two bodies, one of them fast, in one step. An independent exact swept test in `i128` judges
//! them.

use super::swept::{NOWHERE, PX, ball, body_of, boxed, launch, level, meetings, scene, vec2};
use core::num::NonZeroU8;
use tilesat::broad::SortSweep;
use tilesat::prelude::*;
use tilesat::scene::{SceneBody, SceneEvent, SceneTag, Shape};
use tilesat::{Aabb, Circle, ConvexPolygon, Fx, Scene, Vec2};
use tilesat_judge::convex::shape::MOST;
use tilesat_judge::scenes::BODIES;
use tilesat_judge::solids::shapes::Any;
use tilesat_judge::{Random, cases};

/// Whether a point that moves from `p` by `d` enters a box, borders excluded. Exact.
fn enters_box(p: (i128, i128), d: (i128, i128), lo: (i128, i128), hi: (i128, i128)) -> bool {
    // The times at which it is between the sides, as fractions of one denominator.
    let (wide, high) = (d.0.abs().max(1), d.1.abs().max(1));
    let span = |p: i128, d: i128, lo: i128, hi: i128, scale: i128| match d.signum() {
        0 => (lo < p && p < hi).then_some((0, wide * high)),
        1 => Some(((lo - p) * scale, (hi - p) * scale)),
        _ => Some(((p - hi) * scale, (p - lo) * scale)),
    };
    let (Some(x), Some(y)) = (span(p.0, d.0, lo.0, hi.0, high), span(p.1, d.1, lo.1, hi.1, wide)) else { return false };
    x.0.max(y.0).max(0) < x.1.min(y.1).min(wide * high)
}

/// The same for a disc.
fn enters_disc(p: (i128, i128), d: (i128, i128), c: (i128, i128), r: i128) -> bool {
    let (m, rr, dd) = ((p.0 - c.0, p.1 - c.1), r * r, d.0 * d.0 + d.1 * d.1);
    let end = (m.0 + d.0, m.1 + d.1);
    let (along, cross) = (-(m.0 * d.0 + m.1 * d.1), m.0 * d.1 - m.1 * d.0);
    let within = |v: (i128, i128)| v.0 * v.0 + v.1 * v.1 < rr;
    within(m) || within(end) || (0 < along && along < dd && cross * cross < rr * dd)
}

/// Whether a shape that moves by `d` overlaps another on its way: the Minkowski sum, in its parts.
fn sweeps(a: &Shape, d: (i128, i128), b: &Shape) -> bool {
    let wide = |v: Vec2| (i128::from(v.raw().0), i128::from(v.raw().1));
    let parts = |shape: &Shape| match shape {
        Shape::Aabb(aabb) => (wide(aabb.min()), wide(aabb.max()), 0),
        Shape::Circle(circle) => (wide(circle.centre()), wide(circle.centre()), i128::from(circle.radius().to_bits())),
    };
    let ((alo, ahi, ar), (blo, bhi, br)) = (parts(a), parts(b));
    // The corner `alo` of the moving one. The other has grown by the first one's size.
    let (lo, hi, r) = ((blo.0 - (ahi.0 - alo.0), blo.1 - (ahi.1 - alo.1)), bhi, ar + br);
    enters_box(alo, d, (lo.0 - r, lo.1), (hi.0 + r, hi.1))
        || enters_box(alo, d, (lo.0, lo.1 - r), (hi.0, hi.1 + r))
        || [lo, hi, (lo.0, hi.1), (hi.0, lo.1)].iter().any(|&corner| enters_disc(alo, d, corner, r))
}

/// One step of two bodies, one of them fast. They meet exactly if the judge says so, once, and
/// neither ends in or beyond the other.
#[test]
fn two_meet_where_their_ways_do() {
    let map = level(NOWHERE);
    let (mut met, mut missed) = (0, 0);
    for case in 0..30_000 * cases(1) {
        let mut r = Random::new(9000 + case);
        let any = |r: &mut Random, x: i64, y: i64| -> Shape {
            let size = r.within(PX / 8, 20 * PX) & !1;
            if r.one_in(2) { ball(x, y, size / 2).into() } else { boxed(x, y, size, r.within(PX / 8, 20 * PX)).into() }
        };
        let (one, two) = (any(&mut r, 0, 0), {
            let at = (r.around(200 * PX), r.around(200 * PX));
            any(&mut r, at.0, at.1)
        });
        let toward = two.position().raw();
        let aim = |r: &mut Random, c: i32| i64::from(c) * r.within(1, 30) / 10 + r.around(10 * PX);
        let velocity = vec2(aim(&mut r, toward.0), aim(&mut r, toward.1));
        let floats =
            |shape: Shape, key: u32, velocity: Vec2| SceneBody { floats: true, velocity, ..SceneBody::new(shape, key) };
        let (keys, slow) = (if r.one_in(2) { (1, 2) } else { (2, 1) }, vec2(r.around(4 * PX), r.around(4 * PX)));
        let first = SceneBody { fast: true, ..floats(one, keys.0, velocity) };
        let second = match r.below(3) {
            0 => SceneBody::fixed(two, keys.1),
            1 => floats(two, keys.1, slow),
            _ => SceneBody { fast: true, ..floats(two, keys.1, launch(&mut r, 20 * PX)) },
        };
        let mut scene = scene(&[first, second]);
        let (v, w) = (first.velocity.raw(), if second.mass.is_some() { second.velocity.raw() } else { (0, 0) });
        let apart = (i128::from(v.0) - i128::from(w.0), i128::from(v.1) - i128::from(w.1));
        if sweeps(&one, (0, 0), &two) {
            continue;
        }
        let meets = sweeps(&one, apart, &two);
        let (stepped, told) = meetings(&mut scene, &map, Vec2::ZERO);
        assert_eq!((stepped.held, told.len()), (0, usize::from(meets)), "{case}: {first:?} {second:?} {told:?}");
        (met, missed) = (met + u32::from(meets), missed + u32::from(!meets));
        let (a, b) = (body_of(&scene, keys.0), body_of(&scene, keys.1));
        if !meets {
            assert_eq!((a.shape.position(), b.velocity), (one.position() + first.velocity, second.velocity));
            continue;
        }
        let (time, ends) = (told[0].1, (a.shape.position().raw(), b.shape.position().raw()));
        // The position of the second when they meet, and the way of the first relative to it,
        // before and after.
        let at = |from: Vec2, v: (i32, i32)| {
            let part = |v: i32| (i64::from(v) * i64::from(time.raw())) >> 30;
            (i128::from(from.raw().0) + i128::from(part(v.0)), i128::from(from.raw().1) + i128::from(part(v.1)))
        };
        let (p, q) = (at(one.position(), v), at(two.position(), w));
        let meeting = (p.0 - q.0, p.1 - q.1);
        let start = (one.position() - two.position()).raw();
        let end = (i128::from(ends.0.0) - i128::from(ends.1.0), i128::from(ends.0.1) - i128::from(ends.1.1));
        let core = match two {
            Shape::Aabb(b) => {
                let (w, h) = b.size().raw();
                if w < 17 || h < 17 {
                    continue;
                }
                Shape::from(boxed(
                    i64::from(b.min().raw().0) + 8,
                    i64::from(b.min().raw().1) + 8,
                    i64::from(w) - 16,
                    i64::from(h) - 16,
                ))
            }
            Shape::Circle(c) => {
                ball(c.centre().raw().0.into(), c.centre().raw().1.into(), i64::from(c.radius().to_bits()) - 8).into()
            }
        };
        let moved = |by: (i128, i128)| (by.0 - i128::from(start.0), by.1 - i128::from(start.1));
        let place = moved(meeting);
        assert!(!sweeps(&one, place, &core), "{case}: they meet too late");
        let there = match one {
            Shape::Aabb(b) => Shape::from(b.translated(vec2(place.0 as i64, place.1 as i64)).unwrap()),
            Shape::Circle(c) => c.translated(vec2(place.0 as i64, place.1 as i64)).unwrap().into(),
        };
        assert!(
            !sweeps(&there, (end.0 - meeting.0, end.1 - meeting.1), &core),
            "{case}: one goes through the other\n{first:?}\n{second:?}\n{a:?}\n{b:?}"
        );
    }
    println!("{met} met, {missed} did not");
    assert!(met > 5_000 && missed > 5_000);
}

/// A body that cannot move, since it overlaps the level, is met where it is. Its order in the scene
/// does not matter.
#[test]
fn held_bodies_are_met_where_they_are() {
    let map = level("....\n.##.\n....");
    let boxed = |x: i64, y: i64| Aabb::new(vec2(x << 16, y << 16), vec2((x + 8) << 16, (y + 4) << 16)).unwrap();
    for (mass, speed) in [(206, 4), (1, 4), (20, 9)] {
        let held = SceneBody { velocity: Vec2::from_ints(0, -3), ..SceneBody::new(boxed(41, 29), 5) };
        let ball = Circle::new(Vec2::from_ints(43, 37), Fx::from_bits(2 << 16)).unwrap();
        let velocity = Vec2::from_ints(3, -speed);
        let ball = SceneBody { velocity, mass: NonZeroU8::new(mass), ..SceneBody::new(ball, 11) };
        let run = |order: [SceneBody; 2]| {
            let mut scene = scene(&order);
            let mut seen = Vec::new();
            for _ in 0..4 {
                let stepped = scene.step(&map, Vec2::ZERO, |_| {}).unwrap();
                seen.push((stepped.held, body_of(&scene, 5).velocity, body_of(&scene, 11).shape.position()));
            }
            seen
        };
        let seen = run([held, ball]);
        assert_eq!(seen, run([ball, held]), "{mass} {speed}");
        assert!(seen[0].0 == 1 && seen[0].1 == Vec2::ZERO && seen[0].2.y >= 35, "{seen:?}");
    }
}

type Polygon = ConvexPolygon<MOST>;

/// Steps a fast and a slow body. Returns whether they met, and how deep they overlap.
fn step_pair(fast: (Any, Vec2, u8), slow: (Any, Vec2)) -> (bool, Fx) {
    let mut scene = Scene::<SortSweep<BODIES, SceneTag>, BODIES, 0, Any>::new(SortSweep::new());
    let mass = NonZeroU8::new(fast.2);
    let fast = SceneBody::<Any> { fast: true, mass, velocity: fast.1, ..SceneBody::of(fast.0, 1) };
    let slow = SceneBody::<Any> { velocity: slow.1, ..SceneBody::of(slow.0, 2) };
    let (fast, slow) = (scene.insert(&fast).unwrap(), scene.insert(&slow).unwrap());
    let mut meets = false;
    scene.step(&level(NOWHERE), Vec2::ZERO, |event| meets |= matches!(event, SceneEvent::Meet { .. })).unwrap();
    let contact = scene.body(fast).unwrap().shape.contact(&scene.body(slow).unwrap().shape);
    (meets, contact.map_or(Fx::ZERO, |contact| contact.depth()))
}

/// A fast body that is led along a slanted side of a slow one meets it again and again: their ways
/// are rounded. It goes along, and the two do not overlap.
#[test]
fn nobody_waits_at_a_slanted_side() {
    let plank = Aabb::new(vec2(-2_537_772, -2_157_235), vec2(872_727, -1_299_633)).unwrap();
    let wedge = [vec2(2_356_357, -2_038_453), vec2(1_176_709, -989_877), vec2(390_277, -1_055_413)];
    let wedge: Any = Polygon::new(&wedge).unwrap().into();
    for mass in [1, 28, 255] {
        let seen = step_pair((plank.into(), vec2(-119_696, 66_315), mass), (wedge, vec2(27_667, -141_411)));
        assert_eq!(seen, (true, Fx::ZERO), "{mass}");
    }
    let mut r = Random::new(14);
    let mut met = 0;
    for case in 0..cases(20_000) {
        let mut near = |most: i64| vec2(r.within(-most, most), r.within(-most, most));
        let corners = [near(40 * PX), near(40 * PX), near(40 * PX)];
        let (at, by, by_slow) = (near(60 * PX), near(3 * PX), near(3 * PX));
        let Ok(slow) = Polygon::hull(&corners) else { continue };
        let fast = Aabb::from_size(at, vec2(r.within(PX, 50 * PX), r.within(PX, 20 * PX))).unwrap();
        let (fast, slow) = (Any::from(fast), Any::from(slow));
        if !fast.overlaps(&slow) {
            let (meets, depth) = step_pair((fast, by, r.within(1, 255) as u8), (slow, by_slow));
            assert!(depth.to_bits() <= 4, "case {case}: {depth}");
            met += u64::from(meets);
        }
    }
    assert!(met > cases(20_000) / 100, "{met}");
}
