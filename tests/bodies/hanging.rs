//! No body sleeps in the air: neither when what held its pile is gone, nor because its neighbours
//! fell asleep.

use tilesat::broad::{BroadPhase, BruteForce, SortSweep};
use tilesat::motion::Surface;
use tilesat::query::Distance;
use tilesat::scene::{SceneBody, SceneTag, Sleep};
use tilesat::shape::AnyShape;
use tilesat::{Aabb, Axis, Capsule, Circle, Fx, OrientedBox, Ratio, Scene, TileKinds, TileMap, Vec2, fx};
use tilesat_judge::Random;
use tilesat_judge::scenes::BODIES;
use tilesat_judge::solids::shapes::Any;

type Mixed = Scene<SortSweep<BODIES, SceneTag>, BODIES, 0, Any>;

fn aabb(x: i16, y: i16, width: i16, height: i16) -> Aabb {
    Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + width, y + height)).unwrap()
}

fn any_shape(random: &mut Random, centre: Vec2, size: Fx) -> Any {
    let other = Fx::from_bits(100_000 + random.below(300_000) as i32);
    match random.below(4) {
        0 => AnyShape::Circle(Circle::new(centre, size).unwrap()),
        1 => AnyShape::Aabb(Aabb::from_centre(centre, Vec2::new(other, size)).unwrap()),
        2 => AnyShape::Capsule(Capsule::new(centre, centre + Vec2::new(Fx::ZERO, other / 2), size).unwrap()),
        _ => {
            let along = Axis::new(1 + random.below(8) as i32, random.below(18) as i32 - 9);
            AnyShape::OrientedBox(OrientedBox::new(centre, Vec2::new(other, size / 2), along).unwrap())
        }
    }
}

/// Piles of all shapes on a platform between two walls. They sleep, and the platform goes.
#[test]
fn a_pile_falls_when_its_platform_goes() {
    let level = TileMap::from_ascii("..........\n..........\n", &TileKinds::EMPTY).unwrap();
    let (gravity, mut slept, mut apart) = (Vec2::from_raw(0, 12_000), 0, 0);
    for seed in 0..260 {
        let random = &mut Random::new(7000 + seed);
        let mut scene = Mixed::new(SortSweep::new());
        let fixed = |shape, key| SceneBody { mass: None, ..SceneBody::of_shape(AnyShape::Aabb(shape), key) };
        let platform = scene.insert(&fixed(aabb(80, 40, 40, 8), 0)).unwrap();
        for (key, x) in [(100, 79), (101, 120)] {
            scene.insert(&fixed(aabb(x, -200, 1, 248), key)).unwrap();
        }
        let mut y = 40 << 16;
        let mut bodies = Vec::new();
        for key in 1..=2 + random.below(8) as u32 {
            let size = 100_000 + random.below(300_000) as i32;
            y -= 3 * size + random.below(200_000) as i32;
            let centre = Vec2::from_raw((100 << 16) + random.around(200_000) as i32, y + size);
            let friction = if random.below(2) == 0 { Ratio::ONE } else { Ratio::HALF };
            let shape = any_shape(random, centre, Fx::from_bits(size));
            let body = SceneBody { surface: Surface::new(Ratio::ZERO, friction), ..SceneBody::of_shape(shape, key) };
            bodies.push(scene.insert(&body).unwrap());
        }
        for _ in 0..600 {
            scene.step(&level, gravity, |_| {}).unwrap();
        }
        if !scene.awake().is_empty() {
            continue;
        }
        slept += 1;
        let before: Vec<Any> = bodies.iter().map(|&body| scene.body(body).unwrap().shape).collect();
        let rests = |at: &Any| before.iter().filter(|other| other.distance(at) == Fx::ZERO).count() > 1;
        apart += u32::from(before.len() > 2 && !before.iter().all(rests));
        scene.remove(platform).unwrap();
        for _ in 0..60 {
            scene.step(&level, gravity, |_| {}).unwrap();
        }
        for (body, before) in bodies.iter().zip(&before) {
            let now = scene.body(*body).unwrap().shape;
            assert!(now != *before && scene.is_awake(*body).unwrap(), "seed {seed}: {before:?} hangs in the air");
        }
    }
    assert!(slept > 200 && apart > 20, "{slept} {apart}");
}

/// A fixed platform that is said to move throws a crate up to that far in each step, for ever. A
/// scene that remembers looks again when the platform changes.
#[test]
fn a_thrown_crate_falls_when_its_platform_changes() {
    let level = TileMap::from_ascii("........\n........\n........\n", &TileKinds::EMPTY).unwrap();
    let gravity = Vec2::from_raw(0, 50_000);
    for (up, change) in [2000, 10_000, 28_000, 40_000].into_iter().flat_map(|up| (0..4).map(move |change| (up, change)))
    {
        let fallen = |remembers: bool| {
            let mut scene =
                Scene::<SortSweep<BODIES, SceneTag>, BODIES, BODIES>::remembering(SortSweep::new(), Sleep::NEVER);
            let velocity = Vec2::from_raw(0, -up);
            let platform = SceneBody { velocity, ..SceneBody::fixed(aabb(20, 40, 20, 8), 1) };
            let platform = scene.insert(&platform).unwrap();
            let crate_ = scene.insert(&SceneBody::new(aabb(26, 30, 8, 8), 2)).unwrap();
            for step in 0..400 {
                if step == 300 {
                    match change {
                        0 => drop(scene.remove(platform).unwrap()),
                        1 => scene.set_velocity(platform, Vec2::ZERO).unwrap(),
                        2 => scene.place(platform, aabb(100, 40, 20, 8)).unwrap(),
                        _ => scene.alter(platform, |body| body.filter = body.filter.with_sensor(true)).unwrap(),
                    }
                }
                if !remembers {
                    scene.wake_region(&aabb(0, 0, 200, 100)); // forgets
                }
                scene.step(&level, gravity, |_| {}).unwrap();
            }
            scene.body(crate_).unwrap().shape.position()
        };
        assert_eq!(fallen(true), fallen(false), "{up} {change}");
    }
}

/// Three boxes in a row sleep. A quiet one touches them on the left in the step in which a moving
/// one does on the right. All five are one pile then, whichever was inserted first.
#[test]
fn a_pile_that_is_woken_from_both_ends_is_one() {
    fn awake<B: BroadPhase<Tag = SceneTag>>(near: B, order: [usize; 5]) -> Vec<(i32, bool)> {
        let level = TileMap::from_ascii("....\n....\n", &TileKinds::EMPTY).unwrap();
        let mut scene = Scene::<B, BODIES>::with_sleep(near, Sleep { steps: 5, ..Sleep::default() });
        let body = |x: i32, key: u32, v: i32| {
            let shape = Aabb::from_size(Vec2::from_raw(x, 0), Vec2::new(fx!(8), fx!(8))).unwrap();
            SceneBody { velocity: Vec2::from_raw(v, 0), ..SceneBody::new(shape, key) }
        };
        let unit = 8 << 16;
        let all = [
            body(-12, 0, 3), // touches after four steps
            body(unit, 1, 0),
            body(2 * unit, 2, 0),
            body(3 * unit, 3, 0),
            body(4 * unit + 4 * 40_000, 4, -40_000), // so does this one
        ];
        let mut handles = [None; 5];
        let (inner, outer): (Vec<usize>, Vec<usize>) = order.into_iter().partition(|at| (1..4).contains(at));
        for at in inner {
            handles[at] = Some(scene.insert(&all[at]).unwrap());
        }
        for _ in 0..10 {
            scene.step(&level, Vec2::ZERO, |_| {}).unwrap();
        }
        assert!(scene.awake().is_empty());
        for at in outer {
            handles[at] = Some(scene.insert(&all[at]).unwrap());
        }
        let mut awake = Vec::new();
        for step in 0..6 {
            scene.step(&level, Vec2::ZERO, |_| {}).unwrap();
            awake.extend(handles.iter().flatten().map(|&handle| (step, scene.is_awake(handle).unwrap())));
        }
        awake
    }
    let wanted: Vec<_> =
        (0..6).flat_map(|step| [true, step > 3, step > 3, step > 3, true].map(|awake| (step, awake))).collect();
    for order in [[0, 1, 2, 3, 4], [4, 1, 2, 3, 0], [0, 3, 2, 1, 4], [4, 2, 3, 1, 0]] {
        assert_eq!(awake(SortSweep::<BODIES, SceneTag>::new(), order), wanted, "{order:?}");
        assert_eq!(awake(BruteForce::<BODIES, SceneTag>::new(), order), wanted, "{order:?}");
    }
}
