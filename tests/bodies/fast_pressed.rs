//! Fast bodies that others press: wedged ones store no speed, and slow ones that run into them
//! count by their masses.

use super::kept_out::ball;
use super::steps::{Swept, open, step_with};
use core::num::NonZeroU8;
use tilesat::broad::SortSweep;
use tilesat::prelude::*;
use tilesat::scene::{Reply, SceneBody, Shape};
use tilesat::{Aabb, Fx, Ratio, Surface, TileKind, TileKinds, TileMap, Vec2, fx};
use tilesat_judge::Random;

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);

fn step(scene: &mut Swept, level: &TileMap<'_>, gravity: Fx) {
    step_with(scene, level, Vec2::new(Fx::ZERO, gravity), &mut |_| Reply::Meet, &mut |_| ()).unwrap();
}

/// The largest component of the velocities.
fn fastest(scene: &Swept) -> Fx {
    let of = |velocity: Vec2| velocity.x.abs().max(velocity.y.abs());
    scene.bodies().map(|(_, body)| of(body.velocity)).max().unwrap_or(Fx::ZERO)
}

/// A bin of this many tiles, whose floor is at y = 640.
fn bin(wide: usize) -> String {
    format!("#{}#\n", ".".repeat(wide)).repeat(40) + &"#".repeat(wide + 2)
}

/// Balls and boxes fall into a bin. Before, those wedged between others and a wall kept all that
/// gravity added, 0.25 in each step, in 39 of 40 bins of three tiles.
#[test]
fn wedged_bodies_store_no_speed() {
    let mut random = Random::new(41);
    for trial in 0..tilesat_judge::thorough(96, 480) {
        let wide = [2, 3, 6][trial % 3];
        let text = bin(wide);
        let level = TileMap::from_ascii(&text, &KINDS).unwrap();
        let surface = Surface::new(Ratio::ZERO, Ratio::percent([0, 30][trial / 3 % 2]).unwrap());
        let mut scene = Swept::new(SortSweep::new());
        for key in 0..12 {
            let size = random.within(3, 8);
            let x = Fx::from_num(random.within(16 + size, 16 + 16 * wide as i64 - size));
            let (y, size) = (fx!(600) - fx!(20) * key, Fx::from_num(size));
            let flat = Vec2::new(size, Fx::from_num(random.within(3, 7)));
            let shape: Shape = if trial % 2 == 0 || key % 2 == 0 {
                ball(x, y, size).into()
            } else {
                Aabb::from_centre(Vec2::new(x, y), flat).unwrap().into()
            };
            scene.insert(&SceneBody { fast: true, surface, ..SceneBody::new(shape, key as u32) }).unwrap();
        }
        for frame in 0..1200 {
            step(&mut scene, &level, fx!(0.25));
            assert!(frame < 600 || fastest(&scene) < 8, "{trial}, {frame}: {}", fastest(&scene));
        }
    }
}

/// A hero stands, and slow walkers run into it from one side. Their momentum is all that it gets.
#[test]
fn a_slow_body_pushes_a_fast_one_by_its_mass() {
    let text = "#".repeat(60) + "\n" + &format!("#{}#\n", ".".repeat(58)).repeat(10) + &"#".repeat(60);
    let level = TileMap::from_ascii(&text, &KINDS).unwrap();
    for (mass, count) in [(255, 1), (255, 3), (255, 8), (20, 1), (20, 8), (1, 1)] {
        // Seen from above, on the floor of the level, and a single one on a fixed body.
        let kinds = [(fx!(0.75), fx!(0), false), (fx!(1.5), fx!(0), false)];
        for (speed, gravity, fixed) in kinds.into_iter().chain([false, true].map(|on| (fx!(0.75), fx!(0.25), on))) {
            if fixed && count > 1 {
                continue;
            }
            let floor = if fixed {
                fx!(155)
            } else if gravity > 0 {
                fx!(171)
            } else {
                fx!(96)
            };
            let body = |shape: Shape, key| SceneBody::new(shape, key);
            let mut scene = Swept::new(SortSweep::new());
            let hero = Aabb::from_centre(Vec2::new(fx!(400), floor - fx!(1)), Vec2::from_ints(6, 6)).unwrap();
            let hero = SceneBody { fast: true, mass: NonZeroU8::new(mass), ..body(hero.into(), 1) };
            let hero = scene.insert(&hero).unwrap();
            if fixed {
                let bridge = Aabb::new(Vec2::from_ints(20, 160), Vec2::from_ints(900, 170)).unwrap();
                scene.insert(&SceneBody::fixed(bridge, 99)).unwrap();
            }
            let walkers: Vec<_> = (0..count)
                .map(|k: i32| {
                    let at = Vec2::new(fx!(370) - fx!(11) * (k / 3), floor + fx!(11) * (k % 3 - i32::from(count > 1)));
                    let at = if gravity > 0 { Vec2::new(fx!(380) - fx!(11) * k, floor) } else { at };
                    scene.insert(&body(ball(at.x, at.y, fx!(5)).into(), 2 + k as u32)).unwrap()
                })
                .collect();
            for _ in 0..400 {
                let down = scene.body(hero).unwrap().velocity.y;
                scene.set_velocity(hero, Vec2::new(Fx::ZERO, down)).unwrap();
                for &walker in &walkers {
                    let Shape::Circle(at) = scene.body(walker).unwrap().shape else { continue };
                    let down = if gravity > 0 { scene.body(walker).unwrap().velocity.y } else { Fx::ZERO };
                    let toward =
                        if at.centre().x < scene.body(hero).unwrap().shape.aabb().max().x { speed } else { Fx::ZERO };
                    scene.set_velocity(walker, Vec2::new(toward, down)).unwrap();
                }
                step(&mut scene, &level, gravity);
                let place = scene.body(hero).unwrap().shape;
                for &walker in &walkers {
                    let other = scene.body(walker).unwrap().shape;
                    let deep = place.contact(&other).map_or(Fx::ZERO, |contact| contact.depth());
                    assert!(deep <= speed, "mass {mass}, {count} at {speed}: a walker is in the hero by {deep}");
                }
            }
            let far = scene.body(hero).unwrap().shape.aabb().centre().x - fx!(400);
            // All of them at each step, as one inelastic body.
            let most = speed * 400 * count / (i32::from(mass) + count) + speed;
            assert!(far >= 0 && far <= most, "mass {mass}, {count} at {speed}, gravity {gravity}: {far}");
        }
    }
}

/// Fast bodies that fall together lead each other, and gain what gravity adds.
#[test]
fn a_group_that_falls_gains_speed() {
    let (mut random, mut lost) = (Random::new(42), fx!(0));
    let level = open();
    for trial in 0..40 {
        let mut scene = Swept::new(SortSweep::new());
        for key in 0..9 {
            let mut number = |from: i64, to: i64| Fx::from_bits(random.within(from << 12, to << 12) as i32);
            let at = Vec2::new(fx!(13) * (key % 3) + number(0, 24), fx!(13) * (key / 3) + number(0, 24));
            let flat = Vec2::new(number(64, 96), number(64, 96));
            let shape: Shape = if trial % 2 == 0 {
                ball(at.x, at.y, flat.x).into()
            } else {
                Aabb::from_centre(at, flat).unwrap().into()
            };
            let velocity = Vec2::new(number(-32, 32), number(-32, 32));
            scene.insert(&SceneBody { fast: true, velocity, ..SceneBody::new(shape, key as u32) }).unwrap();
        }
        let sum = |scene: &Swept| scene.bodies().map(|(_, body)| body.velocity.y).sum::<Fx>() / 9;
        let start = sum(&scene);
        for _ in 0..60 {
            step(&mut scene, &level, fx!(0.25));
        }
        lost += start + fx!(15) - sum(&scene);
    }
    assert!(lost.abs() < fx!(0.25) * 40, "{}", lost / 40);
}

/// Gravity does not act on fast balls that float, so it takes no speed from them.
#[test]
fn floating_bodies_keep_their_energy_under_gravity() {
    let text = "#".repeat(12) + "\n" + &"#..........#\n".repeat(10) + &"#".repeat(12);
    let level = TileMap::from_ascii(&text, &KINDS).unwrap();
    let energy = |scene: &Swept| {
        let of = |v: Vec2| v.x.to_num::<f64>().powi(2) + v.y.to_num::<f64>().powi(2);
        scene.bodies().map(|(_, body)| of(body.velocity)).sum::<f64>()
    };
    let (mut random, mut scene) = (Random::new(43), Swept::new(SortSweep::new()));
    for key in 0..25 {
        let mut number = |to: i64| Fx::from_bits(random.within(-to << 12, to << 12) as i32);
        let at = ball(fx!(32) + fx!(32) * (key % 5), fx!(32) + fx!(32) * (key / 5), fx!(12));
        let velocity = Vec2::new(number(128), number(128));
        let body = SceneBody { fast: true, floats: true, surface: Surface::ELASTIC, ..SceneBody::new(at, key as u32) };
        scene.insert(&SceneBody { velocity, ..body }).unwrap();
    }
    let start = energy(&scene);
    for _ in 0..2000 {
        step(&mut scene, &level, fx!(0.25));
    }
    assert!(energy(&scene) > 0.98 * start, "{} of {start}", energy(&scene));
}

/// A ball of mass 255 hits a walker that runs into it, before three slow plates. The walker is fast
/// from then on, and passes none of them.
#[test]
fn what_a_fast_body_hits_passes_nothing() {
    let level = open();
    for surface in [Surface::SLICK, Surface::ELASTIC] {
        let mut scene = Swept::new(SortSweep::new());
        let heavy = NonZeroU8::new(255);
        let shot = SceneBody {
            mass: heavy,
            surface,
            velocity: Vec2::from_ints(-40, 0),
            ..SceneBody::new(ball(fx!(430), fx!(0), fx!(6)), 1)
        };
        scene.insert(&shot).unwrap();
        let walker = SceneBody {
            surface,
            velocity: Vec2::new(fx!(0.5), fx!(0)),
            ..SceneBody::new(ball(fx!(400), fx!(0), fx!(5)), 2)
        };
        let walker = scene.insert(&walker).unwrap();
        for (x, key) in [(385, 3), (377, 4), (369, 5)] {
            let plate = Aabb::from_centre(Vec2::from_ints(x, 0), Vec2::from_ints(2, 20)).unwrap();
            scene.insert(&SceneBody { mass: heavy, ..SceneBody::new(plate, key) }).unwrap();
        }
        step(&mut scene, &level, fx!(0));
        let place = scene.body(walker).unwrap().shape.position();
        assert!(place.x > fx!(391.9), "{surface:?}: {place}");
    }
}

/// A hero and slow walkers on a lift that rises: nobody sinks into it by more than a step of it and
/// gravity.
#[test]
fn nobody_sinks_into_a_lift_that_rises() {
    let level = open();
    let surface = Surface::new(Ratio::ZERO, Ratio::ONE);
    for walkers in [1_u8, 2] {
        let mut scene = Swept::new(SortSweep::new());
        let boxed =
            |x: i16, y: i16, w: i16, h: i16| Aabb::from_centre(Vec2::from_ints(x, y), Vec2::from_ints(w, h)).unwrap();
        let (up, mut place) = (Vec2::from_ints(0, -1), boxed(300, 900, 120, 4));
        let lift = scene.insert(&SceneBody { velocity: up, surface, ..SceneBody::fixed(place, 1) }).unwrap();
        let hero = SceneBody { mass: NonZeroU8::new(255), fast: true, ..SceneBody::new(boxed(300, 888, 8, 8), 2) };
        let mut all = vec![scene.insert(&SceneBody { surface, ..hero }).unwrap()];
        for k in 0..walkers {
            let walker = SceneBody::new(boxed([287, 313, 276, 324][usize::from(k)], 891, 5, 5), 3 + u32::from(k));
            all.push(scene.insert(&SceneBody { surface, ..walker }).unwrap());
        }
        for frame in 0..150 {
            for (k, &walker) in all.iter().enumerate().skip(1) {
                let y = scene.body(walker).unwrap().velocity.y;
                let toward = if k % 2 == 1 { fx!(0.75) } else { fx!(-0.75) };
                scene.set_velocity(walker, Vec2::new(toward, y)).unwrap();
            }
            step(&mut scene, &level, fx!(0.25));
            place = place.translated(up).unwrap();
            scene.place(lift, place).unwrap();
            for &body in &all {
                let deep = scene.body(body).unwrap().shape.aabb().max().y - place.min().y;
                assert!(deep < fx!(2.5), "{walkers} walkers, {frame}: {deep} in the lift");
            }
        }
    }
}
