//! The hero of a platformer on lifts: carried without drift, squashed, and off them by jumps.

use super::character::{JUMP, KINDS, NOTHING, boxed, ledge, limits};
use tilesat::{
    Aabb, Axis, Body, Character, Circle, Feel, Fx, Input, Joined, Outcome, Side, Solid, Solids, TileMap, Vec2, fx,
};
use tilesat_judge::Random;

fn rides<B: Body + PartialEq>(body: B, feel: Feel) {
    let level = TileMap::from_ascii("   \n", &KINDS).unwrap();
    let mut lifts = [Solid::new(boxed(0, 24, 60, 8), 7).unwrap()];
    let mut hero = Character::new(body, limits(), feel);
    while !hero.on_floor() {
        let _ = hero.step_on(&level, &mut lifts, NOTHING).unwrap();
    }
    let offset = |hero: &Character<B>, lifts: &[Solid]| hero.body().position() - lifts[0].shape().min();
    let start = offset(&hero, &lifts);
    let mut random = Random::new(11);
    for n in 0..10_000 {
        let at = lifts[0].shape().min();
        let sign = |v: Fx, random: &mut Random| {
            if v.abs() > 300 { -i64::from(v.signum().to_num::<i32>()) } else { random.sign() }
        };
        // Up at any speed, down by at most the snap.
        let (x, y) = (sign(at.x, &mut random) * random.below(3 << 16), sign(at.y, &mut random) * random.below(5 << 16));
        lifts[0] = lifts[0].with_motion(Vec2::from_raw(x as i32, y as i32)).unwrap();
        let step = hero.step_on(&level, &mut lifts, NOTHING).unwrap();
        assert_eq!((step.outcome, hero.ridden(), hero.velocity), (Outcome::Moved, Some(7), Vec2::ZERO), "{n}");
        assert_eq!(offset(&hero, &lifts), start, "{n}");
    }
    // A jump takes the lift's motion along.
    lifts[0] = lifts[0].with_motion(Vec2::from_ints(3, -2)).unwrap();
    let step = hero.step_on(&level, &mut lifts, JUMP).unwrap();
    assert_eq!((step.jumped, hero.velocity), (true, Vec2::new(fx!(3), -feel.jump - fx!(2))));
}

#[test]
fn a_lift_carries_without_drift() {
    rides(boxed(20, 4, 10, 14), Feel::DEFAULT);
    rides(Circle::new(Vec2::from_ints(30, 10), fx!(6.5)).unwrap(), Feel::DEFAULT);
    rides(boxed(20, 4, 10, 14), Feel { gravity: fx!(0.6), jump: fx!(6), ..Feel::DEFAULT });
}

/// Relative to a lift with constant motion, a jump equals one on still ground: position, frame by
/// frame, until it lands. In its first frame the motion is only the velocity. It also leaves lifts
/// that sink faster than the jump rises.
#[test]
fn a_flight_off_a_lift_is_that_on_still_ground() {
    fn plays<B: Body + PartialEq>(body: B, random: &mut Random) {
        let level = TileMap::from_ascii("   \n", &KINDS).unwrap();
        let motion = Vec2::from_raw(random.around(3 << 16) as i32, random.around(5 << 16) as i32);
        // Every fourth ends exactly on the floor, a frame before it lands. On a lift that rises it
        // has landed by then.
        let exact = random.below(4) == 0;
        let motion = if exact { Vec2::new(motion.x, motion.y.abs()) } else { motion };
        let jump = if exact { Feel::DEFAULT.jump } else { Fx::from_bits(random.within(1 << 14, 6 << 16) as i32) };
        let feel = Feel { jump, ..Feel::DEFAULT };
        let mut still = (Character::new(body, limits(), feel), [Solid::new(boxed(-400, 24, 800, 8), 7).unwrap()]);
        while !still.0.on_floor() {
            let _ = still.0.step_on(&level, &mut still.1, NOTHING).unwrap();
        }
        let mut lift = still;
        // Every third leaves by a spring instead of a jump.
        let spring = (random.below(3) == 0).then_some(jump);
        let released = if exact { 60 } else { random.below(20) };
        let run = Fx::from_bits(random.around(2 << 16) as i32);
        let offset = |(hero, lifts): &(Character<B>, [Solid; 1])| hero.body().position() - lifts[0].shape().min();
        for frame in 0..60 {
            let input = Input { run, jump: spring.is_none() && frame < released + 1, drop: false };
            if let Some(spring) = spring.filter(|_| frame == 0) {
                (still.0.velocity.y, lift.0.velocity.y) = (-spring, -spring);
            }
            let before = lift.0.body().position();
            lift.1[0] = lift.1[0].with_motion(motion).unwrap();
            let a = still.0.step_on(&level, &mut still.1, input).unwrap();
            let b = lift.0.step_on(&level, &mut lift.1, input).unwrap();
            assert_eq!(offset(&lift), offset(&still), "{motion:?} {jump} {frame}");
            assert_eq!((a.jumped, a.landed), (b.jumped, b.landed), "{motion:?} {jump} {frame}");
            if b.jumped || spring.is_some() && frame == 0 {
                assert_eq!(lift.0.body().position() - before, lift.0.velocity, "{motion:?} {jump}");
            }
            let carried = if lift.0.on_floor() { Vec2::ZERO } else { motion };
            assert_eq!(lift.0.velocity, still.0.velocity + carried, "{motion:?} {jump} {frame}");
            if b.landed {
                return;
            }
        }
        panic!("never down: {motion:?} {jump}");
    }
    let mut random = Random::new(12);
    for _ in 0..300 {
        plays(boxed(20, 4, 10, 14), &mut random);
        plays(Circle::new(Vec2::from_ints(30, 10), fx!(6.5)).unwrap(), &mut random);
    }
}

/// How a hero leaves a lift.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Leaves {
    Drops,
    RunsOff,
    /// Over the edge, and a jump some frames later.
    Late(u32),
}

/// A drop through a one-way lift and a run over its edge are those on still ground too: position,
/// frame by frame, whichever way the lift goes. So is a jump in the coyote time. In one case the
/// lift gets in the way: it goes before the body, so one that sinks comes under a body that has
/// just run off its front. There the body does not stand again.
#[test]
fn every_way_off_a_lift_is_that_on_still_ground() {
    fn plays<B: Body + PartialEq + std::fmt::Debug>(body: B, leaves: Leaves, random: &mut Random) -> bool {
        let level = TileMap::from_ascii("   \n", &KINDS).unwrap();
        let motion = Vec2::from_raw(random.around(3 << 16) as i32, random.around(5 << 16) as i32);
        let lift = Solid::new(boxed(0, 24, 60, 8), 7).unwrap().with_one_way(Side::Up);
        let mut still = (Character::new(body, limits(), Feel::DEFAULT), [lift]);
        while !still.0.on_floor() {
            let _ = still.0.step_on(&level, &mut still.1, NOTHING).unwrap();
        }
        let mut moves = still;
        let run = Fx::from_bits(random.within(1 << 15, 3 << 16) as i32) * random.sign() as i32;
        let offset = |(hero, lifts): &(Character<B>, [Solid; 1])| hero.body().position() - lifts[0].shape().min();
        let exact = leaves == Leaves::Drops || motion.y <= 0 || (motion.x < 0) != (run < 0);
        let mut away = 0;
        for frame in 0..200 {
            let press = |n| leaves == Leaves::Late(n) && away == n;
            let jump = (1..=Feel::DEFAULT.coyote.into()).any(press);
            let input = Input { run, jump, drop: leaves == Leaves::Drops && frame == 2 };
            moves.1[0] = moves.1[0].with_motion(motion).unwrap();
            let before = moves.0.body().position();
            let a = still.0.step_on(&level, &mut still.1, input).unwrap();
            let b = moves.0.step_on(&level, &mut moves.1, input).unwrap();
            let case = || format!("{leaves:?} {motion:?} {run} {frame} {:?} {:?}", still.0, moves.0);
            assert_eq!((a.jumped, still.0.on_floor()), (b.jumped, moves.0.on_floor()), "{}", case());
            assert_eq!(jump, b.jumped, "{}", case());
            away += u32::from(!moves.0.on_floor());
            // Until it falls faster than the fastest fall.
            if away > 19 {
                return exact;
            }
            if !exact && away > 0 {
                continue;
            }
            assert_eq!(offset(&moves), offset(&still), "{}", case());
            let carried = if moves.0.on_floor() { Vec2::ZERO } else { motion };
            assert_eq!(moves.0.velocity, still.0.velocity + carried, "{}", case());
            if away > 0 && leaves == Leaves::Drops {
                assert_eq!(moves.0.body().position() - before, moves.0.velocity, "{}", case());
            }
        }
        panic!("never off: {leaves:?} {motion:?} {run}");
    }
    let (mut random, mut exact) = (Random::new(13), 0);
    for n in 0..600 {
        let leaves = [Leaves::Drops, Leaves::RunsOff, Leaves::Late(1 + n / 3 % 5)][n as usize % 3];
        exact += u32::from(plays(boxed(20, 4, 10, 14), leaves, &mut random));
        exact += u32::from(plays(Circle::new(Vec2::from_ints(30, 10), fx!(6.5)).unwrap(), leaves, &mut random));
    }
    assert!(exact > 900, "{exact}");
}

/// One frame of `drop` is enough, also if the lift starts to sink, speeds up or turns round in any
/// later frame, by up to half the gravity per frame.
#[test]
fn one_frame_drops_through_a_lift_that_changes_its_motion() {
    let level = TileMap::from_ascii("   \n", &KINDS).unwrap();
    let starts = [fx!(0), fx!(0.5), fx!(1), fx!(2), fx!(4), fx!(5), fx!(-0.5), fx!(-3)];
    let rates = [fx!(0), fx!(0.05), fx!(0.125), fx!(-0.125)];
    for (before, rate) in starts.into_iter().flat_map(|before| rates.map(|rate| (before, rate))) {
        for change in 0..30 {
            let mut lift = [Solid::new(boxed(0, 24, 60, 8), 7).unwrap().with_one_way(Side::Up)];
            let mut hero = Character::new(boxed(20, 10, 10, 14), limits(), Feel::DEFAULT);
            let mut go = |frame: i32, drop| {
                let y = if frame < -5 { fx!(0) } else { before + rate * (frame - change).max(0) };
                lift[0].set_motion(Vec2::new(fx!(0), y.min(fx!(5)))).unwrap();
                let _ = hero.step_on(&level, &mut lift, Input { drop, ..NOTHING }).unwrap();
                (hero.on_floor(), hero.body().max().y - lift[0].shape().min().y)
            };
            let _ = go(-9, false);
            assert!((-5..0).all(|frame| go(frame, false).0));
            // Until it is below the lift, or the lift has gone from it.
            for frame in 0..30 {
                let (on_floor, below) = go(frame, frame == 0);
                assert!(!on_floor, "{before} {rate} {change} {frame} {below}");
                if !(0..=6).contains(&below) {
                    break;
                }
            }
        }
    }
}

/// It runs over the front edge of a lift that is faster than it: it keeps the lift's speed, and
/// the lift does not catch it.
#[test]
fn nobody_surfs_on_the_front_edge() {
    let level = TileMap::from_ascii("   \n", &KINDS).unwrap();
    let mut lift = [Solid::new(boxed(0, 24, 30, 6), 7).unwrap()];
    let mut hero = Character::new(boxed(10, 10, 10, 14), limits(), Feel::DEFAULT);
    let (mut speeds, mut leaves) = (Vec::new(), 0);
    for _ in 0..60 {
        lift[0].set_motion(Vec2::from_ints(2, 0)).unwrap();
        let (x, on_floor) = (hero.body().min().x, hero.on_floor());
        let _ = hero.step_on(&level, &mut lift, Input { run: fx!(1.5), ..NOTHING }).unwrap();
        speeds.push(hero.body().min().x - x);
        leaves += u32::from(on_floor && !hero.on_floor());
    }
    assert_eq!((leaves, hero.ridden()), (1, None));
    assert!(speeds[10..].iter().all(|&speed| speed == fx!(3.5)), "{speeds:?}");
}

#[test]
fn several_characters_ride_in_three_steps_as_one_does_in_one() {
    let level = ledge();
    let mut lifts = [Solid::new(boxed(160, 160, 90, 8), 7).unwrap()];
    let mut alone = (Character::new(boxed(170, 140, 10, 14), limits(), Feel::DEFAULT), lifts);
    let mut heroes = [alone.0; 2];
    let mut jumps = 0;
    for frame in 0..400 {
        let y = if frame / 60 % 2 == 0 { -1 } else { 1 };
        let input = Input { run: fx!(0.1), jump: frame % 90 > 70, ..NOTHING };
        let rode = alone.0.ridden();
        lifts[0] = lifts[0].with_motion(Vec2::from_ints(0, y)).unwrap();
        alone.1 = lifts;
        let step = alone.0.step_on(&level, &mut alone.1, input).unwrap();

        jumps += i32::from(step.jumped && rode == Some(7));

        let (mut moved, mut as_array) = (lifts, heroes);
        let steps = Character::step_all(&mut as_array, &level, &mut moved, &[input; 2]).unwrap();
        let rides = heroes.each_mut().map(|hero| hero.ride(&level, &lifts, false).unwrap());
        Solid::move_all(&mut lifts);
        let solids = Solids::new(&lifts);
        let world = Joined::new(&level, &solids);
        for (hero, (outcome, carry)) in heroes.iter_mut().zip(rides) {
            assert_eq!(outcome, Outcome::Moved);
            let together = hero.step_carried(&world, input, carry).unwrap();
            assert_eq!((together, *hero), (step, alone.0), "{frame}");
        }
        assert_eq!((as_array, moved, steps), (heroes, lifts, [step; 2]), "{frame}");
    }
    assert!(jumps >= 3);
    // After a refused call, only the solids have moved.
    let (mut refused, mut moved) = (heroes, lifts.map(|lift| lift.with_motion(Vec2::from_ints(0, 1)).unwrap()));
    let inputs = [NOTHING, Input { run: Fx::MAX, ..NOTHING }];
    refused[1].feel.acceleration = Fx::MAX;
    let before = refused;
    assert!(Character::step_all(&mut refused, &level, &mut moved, &inputs).is_err());
    assert_eq!((refused, moved[0].shape().min().y), (before, lifts[0].shape().min().y + fx!(1)));
    // So it is for one, which the lift would have carried.
    let (mut one, mut moved) = (before[1], lifts.map(|lift| lift.with_motion(Vec2::from_ints(0, 1)).unwrap()));
    assert!(one.ridden() == Some(7) && one.step_on(&level, &mut moved, inputs[1]).is_err());
    assert_eq!(one, before[1]);
}

/// Each of several characters is moved as a single one is: in other places, by other inputs, also
/// down through a lift, and squashed.
#[test]
fn several_characters_do_not_affect_each_other() {
    let rows = "##########\n          \n          \n          \n          \n          \n##########";
    let level = TileMap::from_ascii(rows, &KINDS).unwrap(); // a ceiling at y = 16, a floor at 96
    let boxes = [boxed(40, 70, 60, 6), boxed(110, 60, 40, 12)];
    let platform = Solid::new(boxes[0], 7).unwrap().with_one_way(Side::Up);
    let mut lifts = [platform, Solid::new(boxes[1], 8).unwrap()];
    let hero = |x| Character::new(boxed(x, 20, 10, 14), limits(), Feel::DEFAULT);
    let mut heroes = [hero(46), hero(80), hero(120)];
    let mut random = Random::new(5);
    let (mut drops, mut rides, mut squashed) = (0, 0, 0);
    for frame in 0..3000 {
        let mut input = || Input {
            run: Fx::from_bits(random.within(-(1 << 15), 1 << 15) as i32),
            jump: random.below(4) == 0,
            drop: random.below(16) == 0,
        };
        let inputs = [input(), input(), input()];
        let y = if frame / 24 % 2 == 0 { -1 } else { 1 };
        let far = 1 + frame / 240 % 2; // every other time, up to the ceiling
        lifts[0].set_motion(Vec2::from_ints(0, y)).unwrap();
        lifts[1].set_motion(Vec2::from_ints(-y, y * far)).unwrap();
        if frame % 30 == 0 {
            for (index, one) in heroes.iter_mut().enumerate() {
                let above = lifts[index / 2].shape().min() + Vec2::from_ints(4 + 30 * (index as i16 % 2), -16);
                one.place(Aabb::from_size(above, Vec2::from_ints(10, 14)).unwrap());
            }
        }
        let (mut together, mut moved) = (heroes, lifts);
        let steps = Character::step_all(&mut together, &level, &mut moved, &inputs).unwrap();
        for (index, one) in heroes.iter_mut().enumerate() {
            let (was, mut own) = (one.ridden(), lifts);
            let step = one.step_on(&level, &mut own, inputs[index]).unwrap();
            assert_eq!((step, *one, own), (steps[index], together[index], moved), "{frame} {index}");
            drops += i32::from(inputs[index].drop && was == Some(7) && !one.on_floor());
            rides += i32::from(one.ridden().is_some());
            squashed += i32::from(matches!(step.outcome, Outcome::Squashed { .. }));
        }
        lifts = moved;
    }
    assert!(drops > 20 && rides > 300 && squashed > 5, "{drops} {rides} {squashed}");
}

#[test]
fn what_cannot_yield_is_squashed_and_goes_on_later() {
    let level = TileMap::from_ascii("####\n    \n    \n    \n", &KINDS).unwrap();
    let mut lifts = [Solid::new(boxed(0, 40, 64, 8), 7).unwrap()];
    let mut hero = Character::new(boxed(20, 26, 10, 14), limits(), Feel::DEFAULT);
    let _ = hero.step_on(&level, &mut lifts, NOTHING).unwrap();
    let mut go = |hero: &mut Character, y| {
        lifts[0] = lifts[0].with_motion(Vec2::from_ints(0, y)).unwrap();
        hero.step_on(&level, &mut lifts, NOTHING).unwrap().outcome
    };
    assert_eq!([go(&mut hero, -4), go(&mut hero, -4)], [Outcome::Moved; 2]); // 2 units are left
    let before = *hero.body();
    assert_eq!(go(&mut hero, -3), Outcome::Squashed { by: 7, normal: Axis::NEG_Y });
    assert_eq!(*hero.body(), before);
    assert_eq!(go(&mut hero, 4), Outcome::Moved);
    assert!((0..20).all(|_| go(&mut hero, 0) == Outcome::Moved) && hero.on_floor());
}

/// A one-way lift presses nobody to a ceiling: it passes through the hero, who falls through it.
#[test]
fn a_one_way_lift_squashes_nobody() {
    let level = TileMap::from_ascii("####\n    \n    \n    \n", &KINDS).unwrap();
    for (speed, one_way) in [1, 2, 3, 7].into_iter().flat_map(|speed| [(speed, true), (speed, false)]) {
        let lift = Solid::new(boxed(0, 40, 64, 8), 7).unwrap();
        let mut lifts = [if one_way { lift.with_one_way(Side::Up) } else { lift }];
        let mut hero = Character::new(boxed(20, 26, 10, 14), limits(), Feel::DEFAULT);
        let (mut squashed, mut rode) = (0, 0);
        for frame in 0..40 {
            lifts[0].set_motion(Vec2::from_ints(0, if frame < 2 { 0 } else { -speed })).unwrap();
            let step = hero.step_on(&level, &mut lifts, NOTHING).unwrap();
            squashed += u32::from(step.outcome != Outcome::Moved);
            rode += u32::from(hero.ridden() == Some(7));
            assert!(!level.overlaps(hero.body()) && (rode > 0 || frame < 1));
        }
        assert!(rode > 2);
        assert!(if one_way { squashed == 0 && hero.body().max().y > 60 } else { squashed > 0 }, "{speed} {squashed}");
    }
}
