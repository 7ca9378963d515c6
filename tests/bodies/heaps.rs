//! Scenes: heaps of balls without friction come to rest. What can yield keeps its momentum. Units,
//! y down.

use tilesat::broad::{Handle, SortSweep};
use tilesat::query::Contacts;
use tilesat::scene::{SceneBody, SceneTag};
use tilesat::{Aabb, Circle, Fx, Ratio, Scene, Surface, TileKind, TileKinds, TileMap, Vec2, fx};
use tilesat_judge::{Random, cases};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);

type Heap = Scene<SortSweep<32, SceneTag>, 32>;

/// The deepest overlap of two of the bodies.
fn deepest(scene: &Heap, bodies: &[Handle]) -> Fx {
    let shape = |at: &Handle| scene.body(*at).unwrap().shape;
    let pairs = bodies.iter().enumerate().flat_map(|(k, a)| bodies[..k].iter().map(move |b| (a, b)));
    pairs.filter_map(|(a, b)| shape(a).contact(&shape(b))).map(|contact| contact.depth()).max().unwrap_or(Fx::ZERO)
}

/// Balls of radius 8 in a pit that ends at `right`: at its wall, or before that at a fixed body.
fn balls(r: &mut Random, count: i32, right: i32) -> (Heap, Vec<Handle>) {
    let mut scene = Heap::new(SortSweep::new());
    if right % 16 != 0 {
        let wall = Aabb::new(Vec2::from_ints(right as i16, -400), Vec2::from_ints(right as i16 + 40, 256)).unwrap();
        scene.insert(&SceneBody::fixed(wall, 99)).unwrap();
    }
    let columns = (right - 16) / 17;
    let place = |k: i32, r: &mut Random| {
        let left = r.below(1 << 16) as i32 + ((25 + 17 * (k % columns)) << 16);
        let center = Vec2::from_raw(left.min((right - 8) << 16), (246 - 18 * (k / columns)) << 16);
        SceneBody::new(Circle::new(center, fx!(8)).unwrap(), k as u32)
    };
    let bodies = (0..count).map(|k| scene.insert(&place(k, r)).unwrap()).collect();
    (scene, bodies)
}

/// They are inelastic and without friction, so only the level and what they give up slows them.
#[test]
fn heaps_of_balls_come_to_rest() {
    let rows = "#......#\n".repeat(16) + "########\n";
    let map = TileMap::from_ascii(&rows, &KINDS).unwrap();
    let (mut runs, mut moving, mut deep) = (0, 0, Fx::ZERO);
    for right in [80, 86, 96, 103, 112] {
        for count in [8, 16, 24] {
            for case in 0..cases(6) {
                let (mut scene, bodies) = balls(&mut Random::new(case), count, right);
                for gravity in [fx!(0.1), fx!(0.25)] {
                    for handle in &bodies {
                        scene.wake(*handle).unwrap();
                    }
                    let mut steps = 0;
                    while steps < 1500 && !scene.awake().is_empty() {
                        scene.step(&map, Vec2::new(Fx::ZERO, gravity), |_| {}).unwrap();
                        steps += 1;
                    }
                    (runs, moving) = (runs + 1, moving + u32::from(steps == 1500));
                    deep = deep.max(deepest(&scene, &bodies));
                }
            }
        }
    }
    println!("{moving} of {runs} heaps move after 1500 steps; the deepest overlap is {deep}");
    assert!(moving * 50 <= runs, "{moving} of {runs}");
    assert!(deep < fx!(3), "{deep}");
}

/// Two crates on ice continue as one, and so do two balls that meet as they fall.
#[test]
fn two_that_yield_keep_their_momentum() {
    let rows = "................\n".repeat(4) + "################\n";
    let map = TileMap::from_ascii(&rows, &KINDS).unwrap();
    let crate_at = |x: Fx, key| {
        let low = Vec2::new(x, fx!(54));
        SceneBody::new(Aabb::new(low, low + Vec2::from_ints(10, 10)).unwrap(), key)
    };
    let ball_at = |x: Fx, key| SceneBody::new(Circle::new(Vec2::new(x, fx!(-900)), fx!(5)).unwrap(), key);
    for surface in [Surface::SLICK, Surface::new(Ratio::HALF, Ratio::ZERO)] {
        for speed in [fx!(0.2), fx!(1), fx!(4)] {
            for gap in [fx!(0), fx!(0.3), fx!(2.7)] {
                for pair in [
                    [crate_at(fx!(20), 1), crate_at(fx!(30) + gap, 2)],
                    [ball_at(fx!(20), 1), ball_at(fx!(30) + gap, 2)],
                ] {
                    let mut scene = Heap::new(SortSweep::new());
                    let [first, second] = pair.map(|body| scene.insert(&SceneBody { surface, ..body }).unwrap());
                    scene.set_velocity(first, Vec2::new(speed, Fx::ZERO)).unwrap();
                    for step in 0..20 {
                        scene.step(&map, Vec2::new(Fx::ZERO, fx!(0.25)), |_| {}).unwrap();
                        let sum = scene.body(first).unwrap().velocity + scene.body(second).unwrap().velocity;
                        assert_eq!(sum.x, speed, "{speed}, {gap}, step {step}");
                    }
                    assert!(scene.body(second).unwrap().velocity.x > speed / 3, "they have met");
                }
            }
        }
    }
}

/// The sum of the velocities along a floor of a row of balls with gaps, of which the first moves.
fn row(radii: &[Fx], speed: Fx, platform: Option<Fx>, gravity: Vec2, steps: i32) -> Fx {
    let rows = "................................................\n".repeat(4) + &"#".repeat(48);
    let map = TileMap::from_ascii(&rows, &KINDS).unwrap();
    let mut scene = Heap::new(SortSweep::new());
    if let Some(v) = platform {
        let bounds = Aabb::new(Vec2::from_ints(0, 40), Vec2::from_ints(700, 50)).unwrap();
        let velocity = Vec2::new(v, Fx::ZERO);
        scene.insert(&SceneBody { velocity, ..SceneBody::fixed(bounds, 99) }).unwrap();
    }
    let floor = if platform.is_some() { fx!(40) } else { fx!(64) };
    let bodies: Vec<_> = (0..)
        .zip(radii)
        .map(|(k, &r)| {
            let ball = Circle::new(Vec2::new(fx!(40) + fx!(20) * k, floor - r), r).unwrap();
            let velocity = if k == 0 { Vec2::new(speed, Fx::ZERO) } else { Vec2::ZERO };
            scene.insert(&SceneBody { velocity, ..SceneBody::new(ball, k as u32) }).unwrap()
        })
        .collect();
    for _ in 0..steps {
        for handle in &bodies {
            scene.wake(*handle).unwrap();
        }
        scene.step(&map, gravity, |_| {}).unwrap();
    }
    bodies.iter().map(|at| scene.body(*at).unwrap().velocity.x).sum()
}

/// Balls of two sizes push each other into the floor and up. Along the floor they are free. In a
/// row some are lifted off the floor for a step, and wedged there.
#[test]
fn rows_keep_their_momentum_along_a_floor() {
    for radii in [[fx!(5), fx!(5)], [fx!(5), fx!(4)], [fx!(4), fx!(5)], [fx!(7), fx!(5)], [fx!(3), fx!(6)]] {
        for speed in [fx!(0.5), fx!(1), fx!(2), fx!(3)] {
            for count in [2, 3, 6] {
                for platform in [None, Some(fx!(0)), Some(fx!(1))] {
                    let all: Vec<Fx> = radii.into_iter().cycle().take(count).collect();
                    let sum = row(&all, speed, platform, Vec2::new(Fx::ZERO, fx!(0.2)), 150);
                    let most = if count == 2 || radii[0] == radii[1] { fx!(0.001) } else { speed / 10 };
                    assert!((sum - speed).abs() < most, "{radii:?} {speed} {count} {platform:?}: {sum}");
                }
            }
        }
    }
}

/// Wind adds the same to both.
#[test]
fn two_keep_their_momentum_in_the_wind() {
    for wind in [fx!(-0.01), fx!(0.01), fx!(0.05), fx!(0.15)] {
        for speed in [fx!(1), fx!(3)] {
            let sum = row(&[fx!(5); 2], speed, None, Vec2::new(wind, fx!(0.2)), 40);
            assert_eq!(sum, speed + wind * 80, "{wind} {speed}");
        }
    }
}

/// A hero who weighs as much as one ball walks through a pit of 30.
#[test]
fn a_heap_can_be_pushed_aside() {
    let rows = "#..............................#\n".repeat(13) + &"#".repeat(32);
    let map = TileMap::from_ascii(&rows, &KINDS).unwrap();
    for floats in [false, true] {
        for speed in [fx!(1), fx!(3)] {
            let mut scene = Heap::new(SortSweep::new());
            for k in 0..30_i32 {
                let center = Vec2::new(fx!(60) + fx!(17.5) * (k % 24), fx!(199) - fx!(17) * (k / 24));
                scene.insert(&SceneBody::new(Circle::new(center, fx!(8)).unwrap(), k as u32)).unwrap();
            }
            let hero = Aabb::new(Vec2::from_ints(20, 188), Vec2::from_ints(30, 208)).unwrap();
            let hero = scene.insert(&SceneBody { floats, ..SceneBody::new(hero, 99) }).unwrap();
            for _ in 0..250 {
                let y = scene.body(hero).unwrap().velocity.y;
                scene.set_velocity(hero, Vec2::new(speed, y)).unwrap();
                scene.step(&map, Vec2::new(Fx::ZERO, fx!(0.2)), |_| {}).unwrap();
            }
            let way = scene.body(hero).unwrap().shape.position().x - fx!(25);
            assert!(way > speed * 90, "{floats} {speed}: {way} of {}", speed * 250);
        }
    }
}
