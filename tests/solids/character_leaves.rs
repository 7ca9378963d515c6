//! What becomes of a lift's motion when a hero leaves the lift.

use super::character::{JUMP, KINDS, NOTHING, boxed, limits};
use tilesat::motion::OnLeave;
use tilesat::{Character, Feel, Fx, Input, Solid, TileMap, Vec2, fx};

/// Off a lift by a jump, with the button held: the velocity and the displacement of each frame,
/// relative to the level.
fn flight(motion: Vec2, on_leave: OnLeave, run: Fx) -> Vec<(Vec2, Vec2)> {
    let level = TileMap::from_ascii("   \n", &KINDS).unwrap();
    let mut lift = [Solid::new(boxed(-200, 24, 400, 8), 7).unwrap()];
    let mut hero = Character::new(boxed(0, 10, 10, 14), limits(), Feel { on_leave, ..Feel::DEFAULT });
    let _ = hero.step_on(&level, &mut lift, NOTHING).unwrap();
    let mut all = Vec::new();
    for _ in 0..12 {
        lift[0].set_motion(motion).unwrap();
        let start = hero.body().min();
        let step = hero.step_on(&level, &mut lift, Input { run, ..JUMP }).unwrap();
        assert_eq!(step.jumped, all.is_empty());
        all.push((hero.velocity, hero.body().min() - start));
    }
    all
}

#[test]
fn the_motion_of_a_lift_is_kept_or_added_once() {
    let (gravity, jump, air) = (Feel::DEFAULT.gravity, Feel::DEFAULT.jump, Feel::DEFAULT.air_acceleration);
    for motion in [(2, -1), (-3, 2), (1, 4), (0, -2), (0, 0)].map(Vec2::from) {
        for run in [fx!(0), fx!(-1.5), fx!(3)] {
            let [kept, added, upward] =
                [OnLeave::Keep, OnLeave::Add, OnLeave::AddUpward].map(|on_leave| flight(motion, on_leave, run));
            let still = flight(Vec2::ZERO, OnLeave::Keep, run);
            // The frame of the jump is the same, but for a solid that sinks.
            assert_eq!((kept[0], kept[0].0), (added[0], still[0].0 + motion), "{motion} {run}");
            for (n, (velocity, way)) in kept.iter().enumerate() {
                assert_eq!((*velocity, *way), (still[n].0 + motion, still[n].1 + motion), "{motion} {run} {n}");
            }
            let mut x = added[0].0.x;
            for (n, (velocity, way)) in added.iter().enumerate() {
                let rises = -jump + motion.y + gravity * Fx::from_num(n);
                assert_eq!((*velocity, *velocity), (Vec2::new(x, rises), *way), "{motion} {run} {n}");
                assert_eq!((upward[n].0.x, upward[n].1.x), (x, x), "{motion} {run} {n}");
                let lost = motion.y.max(fx!(0));
                assert_eq!((upward[n].0.y, upward[n].1.y), (rises - lost, rises - lost), "{motion} {run} {n}");
                x = if x < run { (x + air).min(run) } else { (x - air).max(run) };
            }
        }
    }
}

/// Back on the lift, the velocity is relative to it again: over the level it does not change.
#[test]
fn a_hero_that_lands_on_its_lift_keeps_its_speed_over_the_level() {
    for on_leave in [OnLeave::Keep, OnLeave::Add, OnLeave::AddUpward] {
        let level = TileMap::from_ascii("   \n", &KINDS).unwrap();
        let mut lift = [Solid::new(boxed(-400, 24, 800, 8), 7).unwrap()];
        let mut hero = Character::new(boxed(0, 10, 10, 14), limits(), Feel { on_leave, ..Feel::DEFAULT });
        let motion = Vec2::from_ints(2, 0);
        let mut landed = 0;
        for frame in 0..80 {
            lift[0].set_motion(motion).unwrap();
            let before = hero.velocity;
            let step = hero.step_on(&level, &mut lift, Input { jump: frame == 1, ..NOTHING }).unwrap();
            if step.landed && frame > 1 {
                landed += 1;
                let slows = if on_leave == OnLeave::Keep { fx!(0) } else { Feel::DEFAULT.air_acceleration };
                let over = (before.x - slows).max(fx!(0));
                let over = if on_leave == OnLeave::Keep { before.x } else { over };
                assert_eq!(hero.velocity.x + motion.x, over, "{on_leave:?}");
            }
        }
        assert_eq!((landed, hero.ridden(), hero.velocity), (1, Some(7), Vec2::ZERO), "{on_leave:?}");
    }
}
