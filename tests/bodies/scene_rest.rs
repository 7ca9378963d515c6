//! Scenes: bodies rest in nooks. A sleeping body touches everything that may wake it, and its pairs
//! last.

use tilesat::broad::{PairEvent, PairEvents, SortSweep};
use tilesat::prelude::*;
use tilesat::scene::{SceneBody, SceneEvent, SceneTag, Sleep};
use tilesat::{
    Aabb, Axis, Capsule, Circle, ConvexPolygon, Fx, OrientedBox, Ratio, Scene, Surface, TileKind, TileKinds, TileMap,
    Vec2, fx,
};
use tilesat_judge::rooms::drawn;
use tilesat_judge::scenes::BODIES;
use tilesat_judge::solids::shapes::Any;

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
fn bx(x: i16, y: i16, w: i16, h: i16) -> Aabb {
    Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h)).unwrap()
}
fn raw(x: i32, y: i32, w: i32, h: i32) -> Aabb {
    Aabb::new(Vec2::from_raw(x, y), Vec2::from_raw(x + w, y + h)).unwrap()
}
type S = Scene<SortSweep<BODIES, SceneTag>, BODIES>;
type OfAny = Scene<SortSweep<BODIES, SceneTag>, BODIES, 0, Any>;

/// A trap and a crate in it both rest. A ball wakes the crate. No pair ends that the next step
/// begins again.
#[test]
fn waking_does_not_end_pairs() {
    let level = TileMap::from_ascii("#........#\n#........#\n##########\n", &KINDS).unwrap();
    let g = Vec2::from_raw(0, 6_554);
    let mut scene = S::new(SortSweep::new());
    let _ = scene.insert(&SceneBody::new(bx(40, 22, 10, 10), 1)).unwrap();
    let _ = scene.insert(&SceneBody::new(bx(40, 12, 10, 10), 2)).unwrap();
    let trap = SceneBody::fixed(bx(36, 20, 20, 12), 3);
    scene.insert(&SceneBody { filter: trap.filter.with_sensor(true), ..trap }).unwrap();
    let mut events = PairEvents::<32>::new();
    let mut log = Vec::new();
    for k in 0..200 {
        if k == 100 {
            assert!(scene.awake().is_empty());
            let b = SceneBody {
                velocity: Vec2::from_ints(-4, 0),
                ..SceneBody::new(Circle::new(Vec2::from_ints(80, 26), Fx::from_num(4)).unwrap(), 4)
            };
            scene.insert(&b).unwrap();
        }
        scene
            .step(&level, g, |e| {
                if let SceneEvent::Touch { pair, .. } = e {
                    events.feed(pair);
                }
            })
            .unwrap();
        events.finish(|p| scene.rests(p)).unwrap();
        for e in events.iter() {
            if !matches!(e, PairEvent::Stay(_)) {
                log.push((k, e));
            }
        }
    }
    for (_, event) in &log {
        assert!(log.iter().filter(|(_, e)| e == event).count() == 1, "{event:?} twice");
    }
}

/// Whatever its surface and however low the gravity, a body that sleeps on the floor touches it. So
/// a change of the floor wakes it.
#[test]
fn what_sleeps_at_the_floor_touches_it() {
    let level = TileMap::from_ascii("............\n............\n............\n############\n", &KINDS).unwrap();
    let floor = bx(0, 48, 12 * 16, 16);
    let mut bad = 0;
    let mut stat = std::collections::BTreeMap::new();
    for percent in [0, 30, 50, 70, 80, 90, 95, 100] {
        for gy in [1, 3, 50, 655, 6_553, 6_554, 20_001, 65_537] {
            for vx in [0, 1, 7777, -65_535] {
                for k in (0..40).step_by(tilesat_judge::thorough(5, 1)) {
                    for round in [false, true] {
                        let surface = Surface::new(Ratio::percent(percent).unwrap(), Ratio::percent(30).unwrap());
                        let y = 30 * 65_536 + k * 7_919;
                        let shape: tilesat::scene::Shape = if round {
                            Circle::new(Vec2::from_raw(90 * 65_536 + 13 * k, y), Fx::from_bits(300_007)).unwrap().into()
                        } else {
                            raw(90 * 65_536 + 13 * k, y, 600_001, 600_003).into()
                        };
                        let mut scene = S::new(SortSweep::new());
                        let h = scene
                            .insert(&SceneBody { surface, velocity: Vec2::from_raw(vx, 0), ..SceneBody::new(shape, 1) })
                            .unwrap();
                        let mut n = 0;
                        while !scene.awake().is_empty() && n < 3000 {
                            scene.step(&level, Vec2::from_raw(0, gy), |_| {}).unwrap();
                            n += 1;
                        }
                        if n == 3000 {
                            continue;
                        }
                        let b = scene.body(h).unwrap().shape.aabb();
                        let gap = 48 * 65_536 - b.max().raw().1;
                        scene.wake_region(&floor);
                        if gap >= 0 && scene.awake().is_empty() {
                            bad += 1;
                            let e = stat.entry((percent, gy, round)).or_insert((0, i32::MAX, i32::MIN));
                            *e = (e.0 + 1, e.1.min(gap), e.2.max(gap));
                        }
                    }
                }
            }
        }
    }
    for e in &stat {
        println!("floats {e:?}");
    }
    assert_eq!(bad, 0);
}

/// The same on a body that carries it. If that one is removed, moved or pushed away from below, the
/// sleeper on top wakes.
#[test]
fn what_sleeps_on_a_body_wakes_with_it() {
    let level = TileMap::from_ascii("............\n............\n............\n############\n", &KINDS).unwrap();
    let mut slept = 0;
    for percent in [0, 30, 50, 70, 90, 100] {
        for gy in [655, 6_554, 20_001] {
            for k in (0..40).step_by(tilesat_judge::thorough(5, 1)) {
                for form in 0..16 {
                    let surface = Surface::new(Ratio::percent(percent).unwrap(), Ratio::percent(30).unwrap());
                    let y = 20 * 65_536 + k * 7_919;
                    let ball = |r, y| Circle::new(Vec2::from_raw(90 << 16, y), Fx::from_bits(r)).unwrap();
                    let top: tilesat::scene::Shape =
                        if form & 1 == 0 { ball(300_007, y).into() } else { raw(89 << 16, y, 300_001, 300_003).into() };
                    let base = raw(85 << 16, 38 << 16, 10 << 16, 10 << 16);
                    let base = SceneBody { surface, ..SceneBody::new(base, 1) };
                    let base = if form & 2 == 0 { base } else { SceneBody { mass: None, ..base } };
                    let mut scene = S::new(SortSweep::new());
                    let base = scene.insert(&base).unwrap();
                    let top = scene.insert(&SceneBody { surface, ..SceneBody::new(top, 2) }).unwrap();
                    let gravity = Vec2::from_raw(0, gy);
                    for _ in 0..2000 {
                        if scene.awake().is_empty() {
                            break;
                        }
                        scene.step(&level, gravity, |_| {}).unwrap();
                    }
                    if !scene.awake().is_empty() {
                        continue;
                    }
                    slept += 1;
                    match form >> 2 {
                        0 => drop(scene.remove(base).unwrap()),
                        1 => scene.place(base, bx(10, 10, 10, 10)).unwrap(),
                        2 => scene.push(base, Vec2::from_ints(12, 0)).unwrap(),
                        _ => scene.set_velocity(base, Vec2::from_ints(0, 1)).unwrap(),
                    }
                    scene.step(&level, gravity, |_| {}).unwrap();
                    if form & 2 == 0 || form >> 2 < 2 {
                        assert!(scene.is_awake(top).unwrap(), "{percent} % at {gravity:?}: {k} {form}");
                    }
                }
            }
        }
    }
    assert!(slept > tilesat_judge::thorough(1_000, 5_000), "{slept}");
}

/// A body that does not bounce rests in a V, also if its sides do not meet at a right angle. No
/// later step changes it, and it falls asleep.
#[test]
fn bodies_without_bounce_rest_in_a_nook() {
    let shapes = [('\\', 9), ('l', 20), ('h', 24), ('s', 29), ('S', 33)];
    let uneven = drawn(&["......", "......", "......", r"\...lh", r"#\lh##", "######"], 16 << 16, &shapes);
    let steep = drawn(&["......", "......", "......", ".S..s.", ".#Ss#.", ".####.", "######"], 16 << 16, &shapes);
    let gravity = Vec2::from_raw(0, 6_554);
    let mut rests = 0;
    for level in [uneven.all(), steep.all()] {
        for percent in [0, 20] {
            for x in (28..68).step_by(9) {
                let at = |dx: i16, dy: i16| Vec2::from_ints(x + dx, 14 + dy);
                let corners = [(-5, 0), (-2, -4), (3, -3), (5, 1), (0, 4)].map(|(dx, dy)| at(dx, dy));
                let bodies: [Any; 5] = [
                    Circle::new(at(0, 0), Fx::from_num(5)).unwrap().into(),
                    bx(x - 4, 10, 9, 8).into(),
                    Capsule::new(at(-3, 0), at(2, 0), Fx::from_num(4)).unwrap().into(),
                    OrientedBox::new(at(0, 0), Vec2::from_ints(5, 3), Axis::new(4, 3)).unwrap().into(),
                    ConvexPolygon::hull(&corners).unwrap().into(),
                ];
                for shape in bodies {
                    let surface = Surface::new(Ratio::ZERO, Ratio::percent(percent).unwrap());
                    let mut scene = OfAny::with_sleep(SortSweep::new(), Sleep::NEVER);
                    let body = scene.insert(&SceneBody { surface, ..SceneBody::of(shape, 1) }).unwrap();
                    for _ in 0..3_000 {
                        scene.step(&level, gravity, |_| {}).unwrap();
                    }
                    let rest = *scene.body(body).unwrap();
                    for _ in 0..50 {
                        scene.step(&level, gravity, |_| {}).unwrap();
                        assert_eq!(*scene.body(body).unwrap(), rest, "from {shape:?}, {surface:?}");
                    }
                    scene.set_sleep(Sleep::default());
                    for _ in 0..60 {
                        scene.step(&level, gravity, |_| {}).unwrap();
                    }
                    assert!(scene.awake().is_empty(), "{rest:?} from {shape:?}");
                    rests += 1;
                }
            }
        }
    }
    assert_eq!(rests, 100);
}

/// A ball that rolls off a corner, of a tile or of a body, ends each of its steps in the air. It
/// does not fall asleep there.
#[test]
fn what_sleeps_at_a_corner_touches_it() {
    let (mut slept, mut fell) = (0, 0);
    for of_tile in [true, false] {
        let rows = if of_tile { ["..........", "...####..."] } else { [".........."; 2] };
        let rows = format!("..........\n..........\n{}\n{}\n", rows[1], rows[0]);
        let level = TileMap::from_ascii(&rows, &KINDS).unwrap();
        let ledge = bx(48, 32, 64, 16);
        for radius in [20_000, 65_536, 150_000, 262_144, 500_000] {
            for gy in [655, 3_000, 6_554, 16_384, 32_768] {
                for k in 0..200 {
                    let mut scene = S::new(SortSweep::new());
                    if !of_tile {
                        scene.insert(&SceneBody::fixed(ledge, 2)).unwrap();
                    }
                    let at = Vec2::from_raw((112 << 16) + 3 * k * k - 20_000, (32 << 16) - radius - 40_000);
                    let ball = Circle::new(at, Fx::from_bits(radius)).unwrap();
                    let ball = scene.insert(&SceneBody::new(ball, 1)).unwrap();
                    let at = |scene: &S| scene.body(ball).unwrap().shape.position();
                    let mut steps = 0;
                    while scene.is_awake(ball).unwrap() && at(&scene).y < Fx::from_num(100) {
                        scene.step(&level, Vec2::from_raw(0, gy), |_| {}).unwrap();
                        steps += 1;
                        assert!(steps < 3_000, "{:?}", at(&scene));
                    }
                    if scene.is_awake(ball).unwrap() {
                        fell += 1;
                        continue;
                    }
                    let larger = Circle::new(at(&scene), Fx::from_bits(radius + 8)).unwrap();
                    let touches = if of_tile { level.touches(&larger) } else { larger.touches(&ledge) };
                    assert!(touches, "{of_tile}: {radius} by {gy}, asleep at {:?}", at(&scene));
                    slept += 1;
                }
            }
        }
    }
    assert!(slept > 1_000 && fell > 1_000, "{slept} sleep, {fell} fall");
}

/// Between a wall and a fixed body, a fast box ends each step where it began, and friction takes
/// what gravity gives. It does not sleep there: nothing holds it from below.
#[test]
fn what_bounces_on_one_spot_stays_awake() {
    let level = TileMap::from_ascii("......\n.....#\n......\n......\n######\n", &KINDS).unwrap();
    for speed in [40, 114] {
        let mut scene = S::new(SortSweep::new());
        let at = |x, w| Aabb::from_size(Vec2::from_ints(x, 18), Vec2::from_ints(w, 14)).unwrap();
        scene.insert(&SceneBody::fixed(at(40, 10), 6)).unwrap();
        let surface = Surface::new(Ratio::ONE, Ratio::percent(10).unwrap());
        let velocity = Vec2::from_ints(-speed, 0);
        let flier = scene.insert(&SceneBody { surface, velocity, ..SceneBody::new(at(50, 14), 1) }).unwrap();
        for _ in 0..200 {
            scene.step(&level, Vec2::from_raw(0, 16_384), |_| {}).unwrap();
            let asleep = !scene.is_awake(flier).unwrap();
            assert!(!asleep || scene.is_supported(flier).unwrap(), "{:?}", scene.body(flier));
        }
    }
}

/// A body that lies still is supported in the step in which another one wakes it.
#[test]
fn what_wakes_still_lies() {
    let level = TileMap::from_ascii("#........#\n#........#\n##########\n", &KINDS).unwrap();
    let g = Vec2::from_raw(0, 6_554);
    for speed in [0, 1, 7] {
        let mut scene = S::new(SortSweep::new());
        let low = scene.insert(&SceneBody::new(bx(70, 22, 10, 10), 1)).unwrap();
        let high = scene.insert(&SceneBody::new(bx(70, 12, 10, 10), 2)).unwrap();
        while !scene.awake().is_empty() {
            scene.step(&level, g, |_| ()).unwrap();
        }
        // From above, or along the floor.
        let (x, y) = if speed == 0 { (74, 4) } else { (30, 28) };
        let ball = Circle::new(Vec2::from_ints(x, y), fx!(4)).unwrap();
        let velocity = Vec2::from_ints(speed, 0);
        scene.insert(&SceneBody { velocity, ..SceneBody::new(ball, 3) }).unwrap();
        let wakes = (0..400).any(|_| {
            let woken = scene.step(&level, g, |_| ()).unwrap().woken;
            let supported = [low, high].map(|body| scene.is_supported(body).unwrap());
            assert_eq!(supported, [true; 2], "{speed}");
            woken > 0
        });
        assert!(wakes, "{speed}");
    }
}

/// A sensor that swings below a crate does not keep it awake, though it would hold the crate up.
#[test]
fn a_moving_sensor_lets_the_body_on_it_sleep() {
    let level = TileMap::from_ascii("............\n............\n............\n############\n", &KINDS).unwrap();
    let mut scene = S::new(SortSweep::new());
    let weight = Vec2::from_raw(0, 6_554);
    scene.insert(&SceneBody::fixed(bx(40, 30, 4, 8), 1)).unwrap();
    let crate_ = scene.insert(&SceneBody::new(bx(36, 20, 14, 10), 2)).unwrap();
    let zone = SceneBody::new(bx(45, 29, 4, 4), 3);
    let filter = zone.filter.with_sensor(true);
    let zone = scene.insert(&SceneBody { floats: true, filter, ..zone }).unwrap();
    for step in 0..120 {
        let swing = if step % 2 == 0 { fx!(0.125) } else { fx!(-0.125) };
        scene.set_velocity(zone, Vec2::new(swing, Fx::ZERO)).unwrap();
        scene.step(&level, weight, |_| {}).unwrap();
    }
    assert_eq!((scene.is_awake(crate_), scene.is_awake(zone)), (Ok(false), Ok(true)));
}
