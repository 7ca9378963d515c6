//! Characters that boxes of a scene carry, press and crowd: into walls, through one-way tiles, over
//! many small boxes, and put elsewhere.

use super::scene_character::{GRAVITY, KINDS, Room, frame, hero, rect};
use super::steps::open;
use core::num::NonZeroU8;
use tilesat::scene::{SceneBody, SceneCharacter};
use tilesat::{Aabb, Fx, Input, Joined, Solid, Solids, TileMap, Vec2, fx};

/// How deep a character is in a box.
fn depth(hero: &SceneCharacter, other: &Aabb) -> Fx {
    hero.character.body().intersection(other).map_or(Fx::ZERO, |both| {
        let size = both.max() - both.min();
        size.x.min(size.y)
    })
}

/// A crate carries its rider against a fixed wall, also in a jump. The wall stops the rider.
#[test]
fn no_box_carries_it_into_a_fixed_one() {
    let level = open();
    for speed in [0.25, 1.0, 3.0, 6.0, 9.0] {
        for thick in [1, 2, 4, 12] {
            for jump in 0..24 {
                let mut room = Room::empty();
                let velocity = Vec2::new(Fx::from_num(speed), Fx::ZERO);
                let raft = SceneBody { velocity, floats: true, ..SceneBody::new(rect(0, 40, 60, 10), 2) };
                room.insert(&raft).unwrap();
                let wall = rect(90, -60, thick, 98);
                room.insert(&SceneBody::fixed(wall, 3)).unwrap();
                let mut hero = hero(&mut room, 40, 40, 1);
                for k in 0..40 {
                    let input = Input { jump: k >= jump, ..Input::default() };
                    frame(&mut room, &level, &[], &mut hero, input);
                    assert_eq!(depth(&hero, &wall), 0, "{speed}, {thick}, {jump}, {k}");
                    assert!(hero.character.body().max().x <= 90, "{speed}, {thick}, {jump}, {k}");
                }
            }
        }
    }
}

/// A platform that the game places: along a wall of tiles it lifts the rider, and through one-way
/// tiles it leaves the rider behind.
#[test]
fn a_placed_platform_carries_as_a_solid_does() {
    // A wall of tiles from x = 64 on: the rider is at it, the platform below leads into it.
    let text = "....##\n".repeat(10);
    let level = TileMap::from_ascii(&text, &KINDS).unwrap();
    let mut room = Room::empty();
    let platform = room.insert(&SceneBody::fixed(rect(0, 140, 70, 8), 2)).unwrap();
    let mut rider = hero(&mut room, 53, 140, 1);
    for k in 0..60 {
        frame(&mut room, &level, &[], &mut rider, Input::default());
        room.place(platform, rect(k + 1, 139 - k, 70, 8)).unwrap();
        assert!(k < 2 || rider.character.on_floor(), "{k}");
    }
    rider.follow(&room, &level, &[]).unwrap();
    assert_eq!((rider.character.body().max().x, rider.character.body().max().y), (fx!(64), fx!(80)));

    let level = TileMap::from_ascii("....\n....\n....\n----\n....\n....", &KINDS).unwrap();
    let mut room = Room::empty();
    let platform = room.insert(&SceneBody::fixed(rect(0, 48, 60, 8), 2)).unwrap();
    let mut rider = hero(&mut room, 20, 48, 1);
    for k in 0..30 {
        frame(&mut room, &level, &[], &mut rider, Input::default());
        room.place(platform, rect(0, 48 + k, 60, 8)).unwrap();
        assert_eq!(rider.character.body().max().y, 48, "{k}");
    }
}

/// A door between two walls closes on it: it stays on this side.
#[test]
fn no_placed_box_presses_it_through_another() {
    let level = open();
    for speed in 1..=6 {
        let mut room = Room::empty();
        let floor = rect(-200, 100, 400, 10);
        room.insert(&SceneBody::fixed(floor, 2)).unwrap();
        let press = room.insert(&SceneBody::fixed(rect(-50, 0, 100, 20), 3)).unwrap();
        let mut hero = hero(&mut room, 0, 100, 1);
        for k in 0..40 {
            frame(&mut room, &level, &[], &mut hero, Input::default());
            let y = (k * speed).min(75);
            room.place(press, rect(-50, y, 100, 20)).unwrap();
        }
        for _ in 0..60 {
            frame(&mut room, &level, &[], &mut hero, Input::default());
        }
        let feet = hero.character.body().max().y;
        assert!(feet <= 107, "{speed}: {feet}");
    }
}

/// Many small boxes below: it stands on them, and goes on.
#[test]
fn stands_on_any_number_of_boxes() {
    let level = open();
    for (size, wide) in [(3, 10), (4, 10), (6, 10), (8, 100)] {
        let mut room = Room::empty();
        let count = 30;
        for k in 0..count {
            let (x, y) = (size * (k % 15), 100 + size * (k / 15));
            let key = 100_000 + k as u32;
            room.insert(&SceneBody::fixed(rect(x, y, size, size), key)).unwrap();
        }
        let mut hero = hero(&mut room, 5, 90, 1);
        let feet = hero.character.body().max();
        let body = Aabb::new(Vec2::new(feet.x - Fx::from_num(wide), feet.y - fx!(14)), feet).unwrap();
        assert!(hero.character.set_body(&level, body));
        for _ in 0..60 {
            frame(&mut room, &level, &[], &mut hero, Input::default());
        }
        assert_eq!(hero.character.body().max().y, 100, "{size}");
        assert!(hero.stands_on().is_some());
        frame(&mut room, &level, &[], &mut hero, Input { jump: true, ..Input::default() });
        assert!(hero.character.velocity.y < -4, "{size}");
    }
}

/// The order of insertion changes nothing, whatever the keys: two rafts part below it.
#[test]
fn keys_decide_which_box_carries_it() {
    let level = open();
    let ends = [[2, 3], [70_000, 70_001]].map(|keys| {
        [[0, 1], [1, 0]].map(|order| {
            let mut room = Room::empty();
            for k in order {
                let (x, speed) = [(-40, fx!(-1)), (0, fx!(1))][k];
                let velocity = Vec2::new(speed, Fx::ZERO);
                let raft = SceneBody { velocity, floats: true, ..SceneBody::new(rect(x, 40, 40, 10), keys[k]) };
                room.insert(&raft).unwrap();
            }
            let mut hero = hero(&mut room, -5, 40, 1);
            for _ in 0..30 {
                frame(&mut room, &level, &[], &mut hero, Input::default());
            }
            hero.character.position()
        })
    });
    assert!(ends.as_flattened().iter().all(|end| *end == ends[0][0]), "{ends:?}");
}

/// The game puts it elsewhere while a lift moves its body: it is where the game has put it.
#[test]
fn a_respawn_is_exact() {
    let level = open();
    for waits in [0, 1, 30] {
        for by_scene in [false, true] {
            let mut room = Room::empty();
            let mut lifts = [Solid::new(rect(-400, 100, 1000, 8), 7).unwrap()];
            let mut hero = hero(&mut room, 0, 100, 1);
            let ride = |room: &mut Room, lifts: &mut [Solid; 1]| {
                lifts[0].set_motion(Vec2::from_ints(2, 0)).unwrap();
                room.ride(&level, lifts, GRAVITY, fx!(5), |_, _| ()).unwrap();
            };
            let step = |room: &mut Room, lifts: &[Solid; 1], hero: &mut SceneCharacter| {
                let _ = hero.lead(room, &level, lifts, Input::default()).unwrap();
                room.step(&Joined::new(&level, &Solids::new(lifts)), GRAVITY, |_| {}).unwrap();
                hero.follow(room, &level, lifts).unwrap();
            };
            for _ in 0..20 {
                ride(&mut room, &mut lifts);
                step(&mut room, &lifts, &mut hero);
            }
            for _ in 0..waits {
                ride(&mut room, &mut lifts);
                room.step(&Joined::new(&level, &Solids::new(&lifts)), GRAVITY, |_| {}).unwrap();
            }
            let start = rect(300, 0, 10, 14);
            hero.character.place(start);
            if by_scene {
                room.place(hero.handle(), start).unwrap();
            }
            ride(&mut room, &mut lifts);
            step(&mut room, &lifts, &mut hero);
            assert_eq!(hero.character.position(), Vec2::new(fx!(300), fx!(0.25)), "{waits} {by_scene}");
        }
    }
}

/// Under a heavy crate that bridges a gap it bumps its head, and falls.
#[test]
fn a_heavy_crate_above_ends_a_jump() {
    let level = open();
    let mut room = Room::empty();
    for (shape, key) in [(rect(-100, 100, 300, 10), 2), (rect(-40, 60, 30, 40), 3), (rect(40, 60, 30, 40), 4)] {
        room.insert(&SceneBody::fixed(shape, key)).unwrap();
    }
    let mass = NonZeroU8::new(255);
    room.insert(&SceneBody { mass, ..SceneBody::new(rect(-20, 40, 70, 20), 5) }).unwrap();
    let mut hero = hero(&mut room, 10, 100, 1);
    for _ in 0..20 {
        frame(&mut room, &level, &[], &mut hero, Input::default());
    }
    let mut air = 0;
    for k in 0..60 {
        frame(&mut room, &level, &[], &mut hero, Input { jump: k == 0, ..Input::default() });
        air += u32::from(!hero.character.on_floor());
    }
    assert!(hero.character.on_floor() && air < 24, "{air}");
}
