//! A body on a moving solid moves with it, to the last bit, for as long as it stands on it.

use tilesat::{
    Aabb, Axis, Body, Capsule, Circle, Fx, Joined, MoveError, Mover, Quantity, RangeError, Side, Solid, Solids,
    TileKind, TileKinds, TileMap, Vec2, motion::Ride,
};
use tilesat_judge::solids::{P, disc, raw, rect, solid, vec2};
use tilesat_judge::{Random, cases};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
const UNIT: i64 = 1 << 16;
const GRAVITY: i64 = UNIT / 4;
const MOVER: Mover = Mover::platformer(Axis::NEG_Y);

fn empty() -> TileMap<'static> {
    TileMap::from_ascii("   \n   \n   ", &KINDS).unwrap()
}

/// One tick of a game: ride, the solids move, the body falls and lands. Returns the body, and
/// whether it stands.
fn tick<B: Body>(solids: &mut [Solid], body: &mut B, v: &mut Vec2, walk: i64) -> (Ride, bool) {
    let level = empty();
    let ridden = MOVER.ride(&level, solids, body, Fx::from_bits(GRAVITY as i32)).unwrap();
    *body = ridden.body;
    Solid::move_all(solids);
    let here = Solids::new(solids);
    let v0 = vec2((walk, raw(*v).1 + GRAVITY));
    let moved = MOVER.move_and_slide(&Joined::new(&level, &here), body, v0).unwrap();
    (*body, *v) = (moved.body, moved.velocity);
    (ridden.ride, moved.floor)
}

fn offset<B: Body>(body: &B, solid: &Solid) -> P {
    let (a, b) = (raw(body.position()), raw(solid.shape().min()));
    (a.0 - b.0, a.1 - b.1)
}

/// Ways of platforms that never sink faster than gravity: the n-th motion of each.
fn way(kind: i64, n: i64, random: &mut Random) -> P {
    match kind {
        0 => (random.around(3 * UNIT), 0),
        1 => (0, if n / 100 % 2 == 0 { -7 } else { 7 }),
        2 => (1, if n % 2 == 0 { -1 } else { 1 }),
        // A circle: radius 30 units, 1200 ticks per round.
        3 => {
            let at = |n: i64| {
                let a = f64::from((n % 1200) as i32) / 600.0 * std::f64::consts::PI;
                ((a.cos() * 30.0 * 65536.0).round() as i64, (a.sin() * 30.0 * 65536.0).round() as i64)
            };
            (at(n + 1).0 - at(n).0, at(n + 1).1 - at(n).1)
        }
        4 => (random.around(60 * UNIT), if n % 2 == 0 { -GRAVITY } else { GRAVITY }),
        _ => (random.around(UNIT), random.within(-3 * GRAVITY, GRAVITY)),
    }
}

fn rides<B: Body + PartialEq>(body: B, kind: i64, side: Option<Side>, random: &mut Random) {
    let base = solid((0, 0), (40 * UNIT, 8 * UNIT), 5);
    let mut solids = [side.map_or(base, |s| base.with_one_way(s)), solid((0, 900 * UNIT), (9, 901 * UNIT), 6)];
    let (mut body, mut v) = (body, Vec2::ZERO);
    let start = offset(&body, &solids[0]);
    for n in 0..10_000 {
        let mut motion = way(kind, n, random);
        let at = raw(solids[0].shape().min());
        if (at.0 + motion.0).abs() > 3000 * UNIT {
            motion.0 = -motion.0;
        }
        if (at.1 + motion.1).abs() > 3000 * UNIT {
            motion.1 = -motion.1.abs().min(GRAVITY) * at.1.signum();
        }
        solids[0] = solids[0].with_motion(vec2(motion)).unwrap();
        let (ride, floor) = tick(&mut solids, &mut body, &mut v, 0);
        assert_eq!((ride, floor, v), (Ride::Carried, true, Vec2::ZERO), "{kind} {n}");
        assert_eq!(offset(&body, &solids[0]), start, "{kind} {n}: {motion:?}");
    }
}

#[test]
fn a_rider_does_not_drift_in_ten_thousand_ticks() {
    let mut random = Random::new(71);
    for kind in 0..6 {
        for side in [None, Some(Side::Up)] {
            rides(rect((5 * UNIT, -12 * UNIT), (11 * UNIT + 1, 0)), kind, side, &mut random);
            rides(disc((7 * UNIT + 3, -4 * UNIT), 4 * UNIT), kind, side, &mut random);
        }
        // Over the edge by all but a raw unit, and a circle whose lowest point is exactly on the
        // corner.
        rides(rect((1 - 6 * UNIT, -12 * UNIT), (1, 0)), kind, None, &mut random);
        rides(disc((40 * UNIT, -4 * UNIT), 4 * UNIT), kind, None, &mut random);
        // Standing, and lying over each edge with a part of the core.
        let capsule = |a: P, b: P| Capsule::new(vec2(a), vec2(b), Fx::from_bits(4 << 16)).unwrap();
        rides(capsule((9 * UNIT + 5, -4 * UNIT), (9 * UNIT + 5, -20 * UNIT)), kind, None, &mut random);
        rides(capsule((1, -4 * UNIT), (-20 * UNIT, -4 * UNIT)), kind, None, &mut random);
        rides(capsule((40 * UNIT - 1, -4 * UNIT), (60 * UNIT, -4 * UNIT)), kind, None, &mut random);
    }
}

#[test]
fn a_conveyor_adds_its_velocity_exactly() {
    let mut random = Random::new(72);
    for _ in 0..cases(200) {
        let belt = (random.around(UNIT), 0);
        let base = solid((-2000 * UNIT, 0), (2000 * UNIT, 8 * UNIT), 5).with_conveyor(vec2(belt)).unwrap();
        let (mut solids, mut v) = ([base], Vec2::ZERO);
        let mut body = rect((0, -9 * UNIT), (5 * UNIT, 0));
        let mut expected = (0, -9 * UNIT);
        for _ in 0..200 {
            let motion = (random.around(3), random.within(-UNIT, GRAVITY));
            solids[0] = solids[0].with_motion(vec2(motion)).unwrap();
            assert_eq!(tick(&mut solids, &mut body, &mut v, 0), (Ride::Carried, true));
            expected = (expected.0 + motion.0 + belt.0, expected.1 + motion.1);
            assert_eq!(raw(body.min()), expected);
        }
    }
}

#[test]
fn a_rider_leaves_where_it_walks_off() {
    let mut solids = [solid((0, 0), (20 * UNIT, 8 * UNIT), 5)];
    let (mut body, mut v) = (rect((10 * UNIT, -9 * UNIT), (15 * UNIT, 0)), Vec2::ZERO);
    for n in 0..20 {
        solids[0] = solids[0].with_motion(vec2((-UNIT, 0))).unwrap();
        let over = body.min().x < solids[0].shape().max().x;
        let (ride, _) = tick(&mut solids, &mut body, &mut v, 2 * UNIT);
        assert_eq!(ride, if over { Ride::Carried } else { Ride::Free }, "{n}");
    }
    assert!(body.max().y > 0);
}

#[test]
fn what_sinks_faster_than_a_body_falls_leaves_it() {
    for side in [None, Some(Side::Up)] {
        let base = solid((0, 0), (20 * UNIT, 8 * UNIT), 5);
        let mut solids = [side.map_or(base, |s| base.with_one_way(s))];
        let (mut body, mut v) = (rect((2 * UNIT, -9 * UNIT), (7 * UNIT, 0)), Vec2::ZERO);
        let mut fallen = 0;
        for n in 1..=8 {
            solids[0] = solids[0].with_motion(vec2((UNIT / 2, 2 * UNIT))).unwrap();
            let (ride, floor) = tick(&mut solids, &mut body, &mut v, 0);
            fallen += n * GRAVITY;
            assert_eq!((ride, floor), (Ride::Free, false), "{n}");
            assert_eq!(raw(body.min()), (2 * UNIT, fallen - 9 * UNIT), "falls freely, and is not carried sideways");
        }
        // It stops, the body lands, and stays.
        for _ in 0..20 {
            tick(&mut solids, &mut body, &mut v, 0);
        }
        assert_eq!((body.max().y, v), (solids[0].shape().min().y, Vec2::ZERO));
        assert_eq!(tick(&mut solids, &mut body, &mut v, 0), (Ride::Carried, true));
    }
}

#[test]
fn what_rises_under_a_falling_body_takes_it_along() {
    // It falls by 1 and the platform comes by 5, one-way or not, at any speed.
    for (side, speed) in [(None, 5), (Some(Side::Up), 5), (None, 900), (Some(Side::Up), 900)] {
        let base = solid((0, 0), (20 * UNIT, UNIT / 8), 5);
        let mut solids = [side.map_or(base, |s| base.with_one_way(s))];
        let mut body = rect((2 * UNIT, -11 * UNIT), (7 * UNIT, -2 * UNIT));
        solids[0] = solids[0].with_motion(vec2((0, -speed * UNIT))).unwrap();
        let ridden = MOVER.ride(&empty(), &solids, &body, Fx::ONE).unwrap();
        Solid::move_all(&mut solids);
        assert_eq!(
            (ridden.ride, ridden.body.max().y),
            (Ride::Pushed { by: 5, normal: Axis::NEG_Y }, solids[0].shape().min().y)
        );
        body = ridden.body;
        // From then on it stands.
        solids[0] = solids[0].with_motion(vec2((0, -speed * UNIT))).unwrap();
        let ridden = MOVER.ride(&empty(), &solids, &body, Fx::ZERO).unwrap();
        assert_eq!((ridden.ride, ridden.floor), (Ride::Carried, Some(5)));
        // One-way: from below and beside, nothing happens.
        let below = rect((2 * UNIT, 0), (7 * UNIT, UNIT / 16))
            .translated(vec2((0, raw(solids[0].shape().min()).1 + 1)))
            .unwrap();
        if side.is_some() {
            for motion in [(0, 50 * UNIT), (0, -50 * UNIT), (50 * UNIT, 0)] {
                let solids = [solids[0].with_motion(vec2(motion)).unwrap()];
                let ridden = MOVER.ride(&empty(), &solids, &below, Fx::ONE).unwrap();
                assert_eq!((ridden.ride, ridden.body), (Ride::Free, below));
            }
        }
    }
}

#[test]
fn of_two_floors_the_one_that_rises_most_carries() {
    let (a, b) = (solid((0, 0), (10 * UNIT, UNIT), 9), solid((10 * UNIT, 0), (20 * UNIT, UNIT), 4));
    let body = rect((7 * UNIT, -9 * UNIT), (13 * UNIT, 0));
    for (ma, mb, carried, floor) in [
        ((UNIT, 0), (0, 0), (0, 0), 4),
        ((UNIT, -1), (0, 0), (UNIT, -1), 9),
        ((UNIT, 0), (-UNIT, 5), (UNIT, 0), 9),
        ((UNIT, 7), (-UNIT, 5), (-UNIT, 5), 4),
        ((UNIT, UNIT), (0, UNIT + 1), (UNIT, UNIT), 9),
    ] {
        let list = [a.with_motion(vec2(ma)).unwrap(), b.with_motion(vec2(mb)).unwrap()];
        for list in [list, [list[1], list[0]]] {
            let ridden = MOVER.ride(&empty(), &list, &body, Fx::ONE).unwrap();
            assert_eq!((raw(ridden.motion), ridden.floor), (carried, Some(floor)), "{ma:?} {mb:?}");
        }
    }
}

#[test]
fn the_level_stops_a_rider_and_the_platform_goes_on() {
    let level = TileMap::from_ascii("   #\n    \n    ", &KINDS).unwrap(); // a block from (48, 0) to (64, 16)
    let mut solids = [solid((0, 16 * UNIT), (60 * UNIT, 20 * UNIT), 1)];
    let mut boxed = rect((30 * UNIT, 6 * UNIT), (40 * UNIT, 16 * UNIT));
    let mut ball = disc((43 * UNIT, 11 * UNIT), 5 * UNIT);
    for _ in 0..5 {
        solids[0] = solids[0].with_motion(vec2((3 * UNIT, 0))).unwrap();
        let (a, b) = (MOVER.ride(&level, &solids, &boxed, Fx::ONE), MOVER.ride(&level, &solids, &ball, Fx::ONE));
        let (a, b) = (a.unwrap(), b.unwrap());
        assert_eq!((a.ride, b.ride), (Ride::Carried, Ride::Carried));
        (boxed, ball) = (a.body, b.body);
        Solid::move_all(&mut solids);
    }
    assert_eq!((raw(boxed.max()), raw(ball.centre())), ((48 * UNIT, 16 * UNIT), (43 * UNIT, 11 * UNIT)));
}

#[test]
fn up_can_be_any_direction() {
    type Turned = fn(P) -> P;
    let up: [(P, Turned); 4] =
        [((0, -1), |p| p), ((0, 1), |p| (-p.0, -p.1)), ((1, 0), |p| (-p.1, p.0)), ((-1, 0), |p| (p.1, -p.0))];
    for (u, turn) in up {
        let mover = Mover::platformer(Axis::new(u.0 as i32, u.1 as i32));
        let list = [solid(turn((0, 0)), turn((9, 4)), 3).with_motion(vec2(turn((2, -3)))).unwrap()];
        let body = rect(turn((1, 0)), turn((5, -6)));
        let ridden = mover.ride(&empty(), &list, &body, Fx::ONE).unwrap();
        assert_eq!((ridden.ride, raw(ridden.motion)), (Ride::Carried, turn((2, -3))));
        // Without an up nothing carries. A rising solid pushes.
        let ridden = Mover::new().ride(&empty(), &list, &body, Fx::ONE).unwrap();
        assert_eq!(
            (ridden.ride, raw(ridden.motion)),
            (Ride::Pushed { by: 3, normal: Axis::new(u.0 as i32, u.1 as i32) }, turn((0, -3)))
        );
    }
}

#[test]
fn sizes_and_errors() {
    assert_eq!(size_of::<Solid>(), 36);
    assert!(Solid::new(rect((0, 0), (0, 5)), 1).is_err() && Solid::new(rect((0, 0), (5, 0)), 1).is_err());
    let s = solid((0, 0), (5, 5), 1);
    assert!(s.with_motion(vec2((1 << 28, 0))).is_err() && s.with_conveyor(vec2((0, -(1 << 28)))).is_err());
    let half = s.with_motion(vec2((1 << 27, 0))).unwrap();
    assert!(half.with_conveyor(vec2((1 << 27, 0))).is_err() && half.with_conveyor(vec2((-(1 << 27), 0))).is_ok());
    let far = solid(((1 << 29) - 9, 0), ((1 << 29) - 5, 9), 1);
    assert!(far.with_motion(vec2((4, 0))).is_ok() && far.with_motion(vec2((5, 0))).is_err());
    let body: Aabb = rect((0, 0), (1, 1));
    let refused = MOVER.ride(&empty(), &[], &body, -Fx::DELTA).unwrap_err();
    assert_eq!(refused, MoveError::Range(RangeError { what: Quantity::Follow, value: -1 }));
    let huge: Circle = disc((0, 0), 1 << 28);
    assert!(MOVER.ride(&empty(), &[], &huge, Fx::ZERO).is_err());
}
