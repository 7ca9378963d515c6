//! The hero among convex solids, in one call per frame. Convex boxes give the bits of plain ones.
//! On sloped lifts and turning planks, the hero is never in a solid, and is carried as exactly as
//! they move.

use tilesat::world::ConvexSolid;
use tilesat::{Aabb, Axis, Character, Circle, Feel, Fx, Input, OrientedBox, Outcome, Solid, TileMap, Vec2, fx};
use tilesat_judge::solids::shapes::{Any, Figure, Rider};
use tilesat_judge::solids::twins::BLOCKS;
use tilesat_judge::solids::{P, disc, raw, rect, vec2};
use tilesat_judge::{Random, cases};

const UNIT: i64 = 1 << 16;

fn input(random: &mut Random) -> Input {
    Input { run: Fx::from_bits(random.around(2 * UNIT) as i32), jump: random.one_in(3), drop: random.one_in(20) }
}

/// A level of 12 x 8 cells of 16 units, open or with some blocks and a floor.
fn level(tiles: &[u8; 96]) -> TileMap<'_, tilesat::Blocks> {
    let grid = tilesat::Grid::new(12, 8, fx!(16), Vec2::ZERO).unwrap();
    TileMap::on_grid(tiles, grid, &BLOCKS).unwrap()
}

fn whole(x: i64, y: i64) -> P {
    (x * UNIT, y * UNIT)
}

#[test]
fn boxes_are_boxes() {
    let (mut random, mut frames, mut ridden, mut alive) = (Random::new(331), 0, 0, 0);
    for _ in 0..cases(300) {
        let tiles: [u8; 96] = core::array::from_fn(|i| u8::from(i >= 84 || random.one_in(12)));
        let level = level(&tiles);
        let lift = |x: i64, random: &mut Random| {
            let (x, y) = (x + random.within(0, 10), random.within(20, 90));
            rect(whole(x, y), whole(x + random.within(10, 50), y + random.within(2, 12)))
        };
        let boxes = [lift(0, &mut random), lift(70, &mut random), lift(140, &mut random)];
        let mut plain: Vec<_> = boxes.iter().zip(0..).map(|(b, key)| Solid::new(*b, key).unwrap()).collect();
        let mut convex: Vec<_> = boxes.iter().zip(0..).map(|(b, key)| ConvexSolid::new(*b, key).unwrap()).collect();
        let at = whole(random.within(0, 180), random.within(0, 10));
        let body = rect(at, (at.0 + 8 * UNIT, at.1 + 10 * UNIT));
        if level.overlaps(&body) {
            continue;
        }
        let mut one = Character::new(body, level.bounds(), Feel::DEFAULT);
        let mut two = one;
        for _ in 0..120 {
            let motions: [P; 3] = core::array::from_fn(|_| (0, random.around(2 * UNIT)));
            for ((a, b), m) in plain.iter_mut().zip(&mut convex).zip(motions) {
                a.set_motion(vec2(m)).unwrap();
                *b = b.with_motion(vec2(m)).unwrap();
            }
            let press = input(&mut random);
            let (a, b) = (one.step_on(&level, &mut plain, press).unwrap(), two.step_on(&level, &mut convex, press));
            let b = b.unwrap();
            if a.outcome != b.outcome {
                // Where plain boxes find no way, convex ones may find that it can stay.
                assert!(matches!(a.outcome, Outcome::Squashed { .. }) && b.outcome == Outcome::Moved, "{a:?}\n{b:?}");
                alive += 1;
                break;
            }
            assert_eq!((one.body(), one.velocity, one.ridden()), (two.body(), two.velocity, two.ridden()), "{plain:?}");
            (frames, ridden) = (frames + 1, ridden + u32::from(one.ridden().is_some()));
            if a.outcome != Outcome::Moved {
                break;
            }
        }
    }
    println!("{frames} frames, {ridden} ridden, {alive} more alive");
    assert!(frames > 5000 && ridden > 500 && alive * 100 < frames);
}

/// A wedge that rises to the right.
fn ramp(at: P, rise: i64) -> Any {
    let points = [whole(0, 0), whole(60, -rise), whole(60, 8), whole(0, 8)];
    tilesat::ConvexPolygon::new(&points.map(|p| vec2((p.0 + at.0, p.1 + at.1)))).unwrap().into()
}

fn rests_on_ramps<B: Rider>(make: impl Fn(P) -> B, seed: u64) {
    let mut random = Random::new(seed);
    let tiles = [0; 96];
    let level = level(&tiles);
    let limits = rect(whole(-2000, -2000), whole(2000, 2000));
    let mut frames = 0;
    for _ in 0..cases(60) {
        let rise = random.within(0, 45);
        let mut solids = [ConvexSolid::new(ramp(whole(60, 80), rise), 9).unwrap()];
        let mut hero = Character::new(make(whole(90, 40 - rise)), limits, Feel::DEFAULT);
        for _ in 0..60 {
            let _ = hero.step_on(&level, &mut solids, Input::default()).unwrap();
        }
        assert_eq!(hero.ridden(), Some(9), "{rise} {hero:?}");
        // Less than it can follow down.
        let motion = |random: &mut Random| (random.around(3 * UNIT), random.around(UNIT));
        for _ in 0..60 {
            let (m, before) = (motion(&mut random), hero.body().position());
            solids[0] = solids[0].with_motion(vec2(m)).unwrap();
            let step = hero.step_on(&level, &mut solids, Input::default()).unwrap();
            let figure = hero.body().figure();
            assert!(step.outcome == Outcome::Moved && !figure.meets(&Figure::of(&solids[0].shape())), "{hero:?}");
            assert_eq!(hero.ridden(), Some(9), "{rise} {m:?} {hero:?}");
            assert_eq!(hero.body().position(), before + vec2(m), "{rise} {m:?} {hero:?}");
            frames += 1;
        }
    }
    assert!(frames > 1000);
}

#[test]
fn a_hero_at_rest_goes_with_a_sloped_lift() {
    rests_on_ramps(|p| rect(p, (p.0 + 8 * UNIT, p.1 + 10 * UNIT)), 332);
    rests_on_ramps(|p| disc(p, 5 * UNIT), 333);
}

fn plays_on_planks<B: Rider>(make: impl Fn(P) -> B, seed: u64) {
    let (mut random, mut frames, mut ridden, mut jumps) = (Random::new(seed), 0, 0, 0);
    let tiles: [u8; 96] = core::array::from_fn(|i| u8::from(i >= 84));
    let level = level(&tiles);
    let limits = rect(whole(-2000, -2000), whole(2000, 2000));
    let plank = |x: i64, turn: i64| {
        OrientedBox::new(vec2(whole(x, 70)), vec2(whole(36, 2)), Axis::new(64, turn as i32)).unwrap()
    };
    for _ in 0..cases(40) {
        let (mut turns, mut speeds) = ([0i64; 2], [1i64; 2]);
        let mut solids = [(50, 4), (135, 6)].map(|(x, key)| ConvexSolid::new(plank(x, 0), key).unwrap());
        let mut hero = Character::new(make(whole(50, 40)), limits, Feel::DEFAULT);
        for _ in 0..200 {
            for ((solid, x), (turn, speed)) in solids.iter_mut().zip([50, 135]).zip(turns.iter_mut().zip(&mut speeds)) {
                if turn.abs() >= 40 || random.one_in(15) {
                    *speed = -turn.signum() * random.within(1, 5) + i64::from(*turn == 0);
                }
                *turn += *speed;
                *solid = solid.with_turn(plank(x, *turn)).unwrap();
            }
            let press = if random.one_in(2) { Input::default() } else { input(&mut random) };
            let step = hero.step_on(&level, &mut solids, press).unwrap();
            let figure = hero.body().figure();
            for solid in &solids {
                let shape = Figure::of(&solid.shape().into());
                assert!(!figure.meets(&shape), "{hero:?} {solid:?} {step:?}");
            }
            assert_eq!(step.outcome, Outcome::Moved, "{hero:?} {solids:?}");
            (frames, ridden, jumps) =
                (frames + 1, ridden + u32::from(hero.ridden().is_some()), jumps + u32::from(step.jumped));
            if hero.body().position().x < fx!(0) || hero.body().position().x > fx!(190) {
                hero.place(make(whole(50, 20)));
            }
        }
    }
    println!("{frames} frames, {ridden} on planks, {jumps} jumps");
    assert!(ridden * 8 > frames && jumps > 100);
}

#[test]
fn a_hero_plays_on_planks_that_turn() {
    plays_on_planks(|p| rect(p, (p.0 + 8 * UNIT, p.1 + 10 * UNIT)), 334);
    plays_on_planks(|p| disc(p, 5 * UNIT), 335);
}

/// Two heroes in one call are two calls.
#[test]
fn two_heroes_on_one_seesaw() {
    let tiles = [0; 96];
    let level = level(&tiles);
    let limits: Aabb = rect(whole(-2000, -2000), whole(2000, 2000));
    let plank = |turn: i32| OrientedBox::new(vec2(whole(90, 70)), vec2(whole(60, 2)), Axis::new(64, turn)).unwrap();
    let hero = |x: i64| Character::new(disc(whole(x, 50), 4 * UNIT), limits, Feel::DEFAULT);
    let mut both: [Character<Circle>; 2] = [hero(60), hero(120)];
    let mut apart = both;
    let mut solids = [[ConvexSolid::new(plank(0), 1).unwrap()]; 3];
    for turn in 0..40 {
        let inputs = [Input::default(), Input { run: fx!(0.5), ..Input::default() }];
        for list in &mut solids {
            list[0] = list[0].with_turn(plank(turn / 2)).unwrap();
        }
        let steps = Character::step_all(&mut both, &level, &mut solids[0], &inputs).unwrap();
        for (i, hero) in apart.iter_mut().enumerate() {
            assert_eq!(hero.step_on(&level, &mut solids[1 + i], inputs[i]).unwrap(), steps[i]);
        }
        assert_eq!(both, apart);
    }
    assert!(both.iter().all(|hero| hero.ridden() == Some(1)));
    assert!(raw(both[1].body().centre()).1 > raw(both[0].body().centre()).1);
}
