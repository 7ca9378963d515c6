//! The hero that is launched: springs, stomps and ladders set its velocity, and no button changes
//! that. And what the buttons for jump and drop mean together.

use super::character::{JUMP, KINDS, NOTHING, boxed, ledge, limits};
use tilesat::{Character, Feel, Fx, Input, Outcome, TileMap, Vec2, fx};

const BOTH: Input = Input { jump: true, drop: true, ..NOTHING };

/// A hero that stands on the ledge.
fn standing(feel: Feel) -> Character {
    let mut hero = Character::new(boxed(75, 146, 10, 14), limits(), feel);
    for _ in 0..3 {
        let _ = hero.step(&ledge(), NOTHING).unwrap();
    }
    assert!(hero.on_floor());
    hero
}

/// How high it gets, and whether it ever jumps, with the button down in these frames.
fn flight(mut hero: Character, button: impl Fn(i32) -> bool) -> (Fx, bool) {
    let (start, mut top, mut jumped) = (hero.body().min().y, hero.body().min().y, false);
    for frame in 0..90 {
        jumped |= hero.step(&ledge(), Input { jump: button(frame), ..NOTHING }).unwrap().jumped;
        top = top.min(hero.body().min().y);
        if hero.on_floor() {
            break;
        }
    }
    (start - top, jumped)
}

#[test]
fn a_button_changes_no_spring() {
    let mut hero = standing(Feel::DEFAULT);
    for (spring, rise) in [(fx!(8), fx!(124)), (fx!(5), fx!(47.5)), (fx!(4), fx!(30)), (fx!(1), fx!(1.5))] {
        hero.velocity.y = -spring;
        assert_eq!(flight(hero, |_| false), (rise, false)); // the sum of its speeds
        for press in 0..12 {
            for released in press + 1..14 {
                let held = |frame| (press..released).contains(&frame);
                // A press that is still buffered when it lands is a jump of the next flight.
                assert_eq!(flight(hero, held).0, rise, "{spring} {press} {released}");
            }
        }
    }
    // In the frame after it walked off: a stomp of the same speed.
    let mut hero = Character::new(boxed(152, 146, 10, 14), limits(), Feel::DEFAULT);
    while hero.body().min().x < 161 {
        let _ = hero.step(&ledge(), Input { run: fx!(2), ..NOTHING }).unwrap();
    }
    assert!(!hero.on_floor());
    hero.velocity.y = fx!(-3);
    assert_eq!(flight(hero, |frame| frame < 3), (flight(hero, |_| false).0, false));
}

/// Without gravity, as on a ladder, "up" stays where it was: a hero that stands on the ceiling
/// jumps off it, and falls back to it.
#[test]
fn up_stays_without_gravity() {
    let level = TileMap::from_ascii("####\n....\n....\n....\n####\n", &KINDS).unwrap(); // free from y = 16 to 64
    for (gravity, y, away) in [(fx!(-0.25), 16, 1), (fx!(0.25), 50, -1)] {
        let mut hero = Character::new(boxed(20, y, 10, 14), limits(), Feel { gravity, ..Feel::DEFAULT });
        for _ in 0..3 {
            let _ = hero.step(&level, NOTHING).unwrap();
        }
        assert!(hero.on_floor());
        let from = hero.position().y;
        hero.feel.gravity = fx!(0);
        for frame in 1..4 {
            let step = hero.step(&level, JUMP).unwrap();
            assert_eq!((step.jumped, hero.position().y - from), (frame == 1, fx!(4.5) * away * frame));
        }
        let mut other = hero;
        other.place(boxed(20, y, 10, 14));
        for hero in [&mut hero, &mut other] {
            hero.feel.gravity = fx!(0);
            hero.velocity.y = fx!(-1) * away;
            for _ in 0..60 {
                let _ = hero.step(&level, NOTHING).unwrap();
            }
            assert!(hero.on_floor() && hero.position().y == from);
        }
    }
}

#[test]
fn a_ladder_in_a_jump_is_climbed_at_its_speed() {
    let mut hero = standing(Feel::DEFAULT);
    for _ in 0..12 {
        let _ = hero.step(&ledge(), JUMP).unwrap();
    }
    for frame in 0..10 {
        hero.velocity.y = fx!(-3);
        let y = hero.body().min().y;
        let _ = hero.step(&ledge(), NOTHING).unwrap(); // the button is up
        assert_eq!(y - hero.body().min().y, fx!(2.75), "{frame}");
    }
    // What only brakes the rise, as water does, leaves it the hero's own jump.
    let mut hero = standing(Feel::DEFAULT);
    for _ in 0..4 {
        let _ = hero.step(&ledge(), JUMP).unwrap();
    }
    hero.velocity.y += fx!(0.5);
    let _ = hero.step(&ledge(), NOTHING).unwrap();
    assert_eq!(hero.velocity.y, -Feel::DEFAULT.jump_cut);
}

#[test]
fn a_wall_jump_keeps_the_rise_of_a_spring() {
    let rows = "#   #\n".repeat(30);
    let level = TileMap::from_ascii(&rows, &KINDS).unwrap();
    let feel = Feel { wall_jump: Some(fx!(3)), ..Feel::DEFAULT };
    let mut hero = Character::new(boxed(35, 300, 10, 14), limits(), feel);
    let toward = Input { run: fx!(2), ..NOTHING };
    while !hero.step(&level, toward).unwrap().wall {}
    hero.velocity.y = fx!(-8);
    assert!(hero.step(&level, Input { jump: true, ..toward }).unwrap().jumped);
    assert_eq!(hero.velocity, Vec2::new(fx!(-3), fx!(-7.75)));
    let _ = hero.step(&level, NOTHING).unwrap();
    assert_eq!(hero.velocity.y, fx!(-7.5));
}

#[test]
fn drop_wins_over_jump_on_a_platform_and_only_there() {
    let level = TileMap::from_ascii("    \n    \n====\n    \n    \n####\n    \n", &KINDS).unwrap();
    for wall_jump in [None, Some(fx!(3))] {
        let feel = Feel { wall_jump, ..Feel::DEFAULT };
        let mut hero = Character::new(boxed(20, 10, 10, 14), limits(), feel);
        for _ in 0..20 {
            let _ = hero.step(&level, NOTHING).unwrap();
        }
        assert!(hero.floor().is_some_and(|floor| floor.one_way));
        let mut frames = 0;
        while !hero.on_floor() || hero.body().max().y < 80 {
            let step = hero.step(&level, if frames < 2 { BOTH } else { NOTHING }).unwrap();
            assert!(!step.jumped && step.outcome == Outcome::Moved && frames < 60);
            frames += 1;
        }
        // On solid ground there is nothing to drop through.
        assert!(hero.step(&level, BOTH).unwrap().jumped);
    }
    // Half on a platform, half on the ground: it stays, and the press counts.
    let level = TileMap::from_ascii("    \n    \n==##\n    \n    \n", &KINDS).unwrap();
    let mut hero = Character::new(boxed(27, 10, 10, 22), limits(), Feel::DEFAULT);
    let _ = hero.step(&level, NOTHING).unwrap();
    let jumped = (0..2).filter(|_| hero.step(&level, BOTH).unwrap().jumped).count();
    assert_eq!(jumped, 1);
}

#[test]
fn a_press_that_dropped_jumps_off_no_wall() {
    let level = TileMap::from_ascii("#   \n#   \n#===\n#   \n#   \n#   \n#   \n#   \n", &KINDS).unwrap();
    let feel = Feel { wall_jump: Some(fx!(3)), ..Feel::DEFAULT };
    let mut hero = Character::new(boxed(16, 10, 10, 14), limits(), feel);
    let toward = Input { run: fx!(-1), ..NOTHING };
    for _ in 0..20 {
        let _ = hero.step(&level, toward).unwrap();
    }
    assert!(hero.step(&level, toward).unwrap().wall && hero.on_floor());
    assert!(!hero.step(&level, Input { run: fx!(-1), ..BOTH }).unwrap().jumped);
    for _ in 0..20 {
        assert!(!hero.step(&level, Input { jump: true, ..toward }).unwrap().jumped);
    }
    assert!(hero.body().min().y > 60);
}

/// A slower fall is no launch: a game that lets its hero glide leaves it the coyote time.
#[test]
fn a_slower_fall_keeps_the_grace() {
    for frames in 1..=Feel::DEFAULT.coyote {
        let mut hero = standing(Feel::DEFAULT);
        let run = Input { run: fx!(2), ..NOTHING };
        while hero.on_floor() {
            let _ = hero.step(&ledge(), run).unwrap();
        }
        for _ in 1..frames {
            hero.velocity.y = fx!(0.125);
            let _ = hero.step(&ledge(), run).unwrap();
        }
        hero.velocity.y = fx!(0.125);
        assert!(hero.step(&ledge(), Input { jump: true, ..run }).unwrap().jumped, "{frames}");
    }
}

/// A button that is held while the hero is put elsewhere is not a press there.
#[test]
fn a_held_button_is_no_press_after_a_new_start() {
    for held in [false, true] {
        let mut hero = standing(Feel::DEFAULT);
        if held {
            let _ = hero.step(&ledge(), JUMP).unwrap();
        }
        hero.place(boxed(80, 146, 10, 14));
        let jumped = (0..20).filter(|_| hero.step(&ledge(), JUMP).unwrap().jumped).count();
        assert_eq!(jumped, usize::from(!held));
    }
}
