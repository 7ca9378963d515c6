//! Fast bodies that chase a hero sink into each other slowly, as the limits of scenes say.

use super::kept_out::{ball, depth};
use super::steps::{Swept, step_with};
use core::num::NonZeroU8;
use tilesat::broad::SortSweep;
use tilesat::scene::{Reply, SceneBody, Shape};
use tilesat::{Aabb, Fx, TileKind, TileKinds, TileMap, Vec2, fx};
use tilesat_judge::{Random, cases, enough};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
const ROOM: &str = "##########\n#........#\n#........#\n#........#\n#........#\n##########\n";

/// How deep any of these bodies is in another at most, if eleven enemies chase a hero of this mass
/// that runs to and fro in a room.
fn deepest(seed: u64, mass: u8, round: bool, frames: u32) -> Fx {
    let level = TileMap::from_ascii(ROOM, &KINDS).unwrap();
    let r = &mut Random::new(seed);
    let mut scene = Swept::new(SortSweep::new());
    let mut insert = |x: i16, y: i16, round: bool, mass: u8, key: u32| {
        let at = Vec2::from_ints(x, y);
        let crate_ = || Aabb::from_centre(at, Vec2::from_ints(5, 5)).unwrap();
        let shape = if round { Shape::Circle(ball(at.x, at.y, fx!(5))) } else { Shape::Aabb(crate_()) };
        let body = SceneBody { mass: NonZeroU8::new(mass), fast: true, ..SceneBody::of_shape(shape, key) };
        scene.insert(&body).unwrap()
    };
    let hero = insert(28, 28, false, mass, 1);
    let enemies: Vec<_> =
        (0..11_i16).map(|k| insert(28 + k % 8 * 14, 56 + k / 8 * 14, round, 1, 10 + k as u32)).collect();
    let (mut run, mut until, mut deepest) = (Vec2::ZERO, 0, Fx::ZERO);
    for frame in 0..frames {
        if frame == until {
            until += 60 + r.below(240) as u32;
            run = Vec2::new(fx!(1.5) * (r.below(3) as i32 - 1), fx!(1.5) * (r.below(3) as i32 - 1));
        }
        scene.set_velocity(hero, run).unwrap();
        let centre = |scene: &Swept, body| scene.body(body).unwrap().shape.aabb().centre();
        for &enemy in &enemies {
            let way = centre(&scene, hero) - centre(&scene, enemy);
            scene.set_velocity(enemy, way.unit().scaled(fx!(0.75))).unwrap();
        }
        step_with(&mut scene, &level, Vec2::ZERO, &mut |_| Reply::Meet, &mut |_| ()).unwrap();
        deepest = enemies.iter().map(|&body| depth(&scene, body)).fold(deepest, Fx::max);
    }
    deepest
}

/// For ten seconds of 60 frames.
#[test]
fn chasers_hardly_sink_in_at_first() {
    for case in 0..cases(tilesat_judge::thorough(2_u64, 4)) {
        for mass in [1, 3, 255] {
            let [boxes, balls] = [false, true].map(|round| deepest(case, mass, round, 600));
            assert!(boxes < fx!(0.05), "case {case}, mass {mass}: boxes are {boxes} deep");
            assert!(balls < fx!(0.1), "case {case}, mass {mass}: balls are {balls} deep");
        }
    }
}

/// Balls in a corner go on sinking.
#[test]
fn balls_that_chase_for_minutes_sink_in_further() {
    let deep = (0..cases(tilesat_judge::thorough(2_u64, 6))).map(|case| deepest(case, 3, true, 3600)).max().unwrap();
    println!("{deep} deep");
    assert!(deep < fx!(0.5) && enough(deep > fx!(0.02)), "{deep} deep");
}

/// How deep each of thirty slow balls is in another, on average, after they chase a fixed post for
/// ten seconds, with so many steps per frame.
fn mean_depth(seed: u64, steps: u16) -> Fx {
    let rows = format!("{0}{1}{0}", "#".repeat(40) + "\n", ("#".to_owned() + &".".repeat(38) + "#\n").repeat(38));
    let level = TileMap::from_ascii(&rows, &KINDS).unwrap();
    let (mut scene, r) = (Swept::new(SortSweep::new()), &mut Random::new(seed));
    let post = Vec2::from_ints(320, 320);
    scene.insert(&SceneBody::fixed(ball(post.x, post.y, fx!(6)), 1)).unwrap();
    // On a lattice, off by up to a unit.
    let at = |r: &mut Random, k: i16| {
        let off = Vec2::from_raw(r.around(1 << 16) as i32, r.around(1 << 16) as i32);
        Vec2::from_ints(100 + k % 10 * 44, 60 + k / 10 * 220) + off
    };
    let chasers: Vec<_> = (0..30_i16)
        .map(|k| {
            let at = at(r, k);
            let body = SceneBody { floats: true, ..SceneBody::new(ball(at.x, at.y, fx!(6)), 10 + k as u32) };
            scene.insert(&body).unwrap()
        })
        .collect();
    let speed = fx!(0.75) / Fx::from(steps as u8);
    for _ in 0..600 * steps {
        for &chaser in &chasers {
            let way = post - scene.body(chaser).unwrap().shape.aabb().centre();
            scene.set_velocity(chaser, way.unit().scaled(speed)).unwrap();
        }
        step_with(&mut scene, &level, Vec2::ZERO, &mut |_| Reply::Meet, &mut |_| ()).unwrap();
    }
    chasers.iter().map(|&body| depth(&scene, body)).fold(Fx::ZERO, |sum, deep| sum + deep / fx!(30))
}

/// Two steps per frame, each with half of the velocity, halve the depth, and four halve it again.
#[test]
fn slow_chasers_sink_in_half_as_deep_in_two_steps_per_frame() {
    for case in 0..cases(3_u64) {
        let deep = [1, 2, 4].map(|steps| mean_depth(case, steps));
        println!("case {case}: {deep:?}");
        let [one, two, four] = deep;
        assert!(two < one * fx!(0.65) && four < two * fx!(0.75), "case {case}: {deep:?}");
        assert!(one > fx!(1) && one < fx!(3.5), "case {case}: {one}");
    }
}

/// A fast hero runs along a wall into which it presses, and a slow enemy chases it from ahead or
/// from behind. The straight path of the hero leads away from the enemy; the wall does not.
#[test]
fn a_slow_chaser_does_not_stop_a_hero_that_presses_against_a_wall() {
    let rows = "#.......\n".repeat(16);
    let level = TileMap::from_ascii(&rows, &KINDS).unwrap();
    for case in 0..cases(40_i16) {
        let r = &mut Random::new(case as u64);
        let mut scene = Swept::new(SortSweep::new());
        let hero =
            SceneBody { mass: NonZeroU8::new(255), fast: true, ..SceneBody::new(ball(fx!(21), fx!(60), fx!(5)), 1) };
        let hero = scene.insert(&hero).unwrap();
        let enemy = ball(Fx::from_num(20 + r.below(20)), Fx::from_num(90 - case % 2 * 60), fx!(4));
        let enemy = scene.insert(&SceneBody::new(enemy, 2)).unwrap();
        let speed = Fx::from_bits(r.below(30_000) as i32 + 20_000);
        let mut deepest = Fx::ZERO;
        for _ in 0..120 {
            scene.set_velocity(hero, Vec2::new(fx!(-0.75), fx!(0.75))).unwrap();
            let centre = |body| scene.body(body).unwrap().shape.position();
            let way = centre(hero) - centre(enemy);
            scene.set_velocity(enemy, way.unit().scaled(speed)).unwrap();
            step_with(&mut scene, &level, Vec2::ZERO, &mut |_| Reply::Meet, &mut |_| ()).unwrap();
            deepest = deepest.max(depth(&scene, enemy));
        }
        let ran = scene.body(hero).unwrap().shape.position().y - fx!(60);
        assert!(ran > fx!(85), "case {case}: the hero ran {ran} of 90");
        assert!(deepest < fx!(0.25), "case {case}: the enemy is {deepest} deep");
    }
}
