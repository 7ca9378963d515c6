//! Characters among the bodies of a scene: on boxes as on tiles, carried exactly, and never in the
//! way of themselves.

use super::steps::open;
use core::num::NonZeroU8;
use tilesat::broad::SortSweep;
use tilesat::prelude::*;
use tilesat::scene::{BodyShape, SceneBody, SceneCharacter, SceneTag, SortSweepScene, WithCapsules};
use tilesat::{
    Aabb, Body, Capsule, Character, Feel, Fx, Input, Joined, Outcome, Scene, Solid, Solids, TileKind, TileKinds,
    TileMap, Vec2, fx,
};
use tilesat_judge::Random;
use tilesat_judge::scenes::BODIES;

pub(super) type Room = SortSweepScene<32>;

pub(super) const GRAVITY: Vec2 = Vec2::new(fx!(0), fx!(0.25));
const HERO: u32 = 1;

pub(super) static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'-', TileKind::ONE_WAY_UP);

pub(super) fn rect(x: i16, y: i16, w: i16, h: i16) -> Aabb {
    Aabb::from_size(Vec2::from_ints(x, y), Vec2::from_ints(w, h)).unwrap()
}

/// A character of 10 by 14 with its feet at `y`, and its body of a mass.
pub(super) fn hero(room: &mut Room, x: i16, y: i16, mass: u8) -> SceneCharacter {
    let hero = Character::new(rect(x, y - 14, 10, 14), rect(-8000, -1000, 16000, 2000), Feel::DEFAULT);
    let body = SceneBody { mass: NonZeroU8::new(mass), ..SceneBody::led(*hero.body(), HERO) };
    SceneCharacter::new(hero, room.insert(&body).unwrap())
}

/// One frame in a level with lifts, which have moved.
pub(super) fn frame<S: BodyShape, B: Body + Into<S>, const N: usize>(
    room: &mut Scene<SortSweep<N, SceneTag>, N, 0, S>,
    level: &TileMap<'_>,
    lifts: &[Solid],
    hero: &mut SceneCharacter<B>,
    input: Input,
) {
    assert_eq!(hero.lead(room, level, lifts, input).unwrap().outcome, Outcome::Moved);
    room.step(&Joined::new(level, &Solids::new(lifts)), GRAVITY, |_| {}).unwrap();
    hero.follow(room, level, lifts).unwrap();
}

/// Random inputs that a player could make.
pub(super) fn play(random: &mut Random, input: &mut Input) {
    if random.below(16) == 0 {
        input.run = Fx::from_num(random.around(2));
    }
    if random.below(10) == 0 {
        input.jump = random.below(2) == 0;
    }
}

/// A row of boxes is as good as a floor of tiles: the same bits, over fixed boxes and crates.
#[test]
fn runs_and_jumps_on_boxes_as_on_tiles() {
    let text = "#".repeat(40) + "\n" + &format!("#{}#\n", ".".repeat(38)).repeat(8) + &"#".repeat(40);
    let level = TileMap::from_ascii(&text, &KINDS).unwrap(); // the floor is at y = 144
    let raised = text.replacen(&format!("#{}#\n{}", ".".repeat(38), "#".repeat(40)), &("#".repeat(40) + "\n"), 1);
    let raised = TileMap::from_ascii(&raised, &KINDS).unwrap(); // at y = 128
    for trial in 0..12 {
        let mut room = Room::empty();
        for k in 0..19 {
            let shape = rect(16 + 32 * k, 128, 32, 16);
            let crate_ = SceneBody::new(shape, 100 + k as u32);
            room.insert(&if trial % 2 == 0 { SceneBody { mass: None, ..crate_ } } else { crate_ }).unwrap();
        }
        let mut hero = hero(&mut room, 300, 100, 1);
        let mut other = hero.character;
        let (mut random, mut input) = (Random::new(trial), Input::default());
        for k in 0..800 {
            play(&mut random, &mut input);
            frame(&mut room, &level, &[], &mut hero, input);
            let _ = other.step(&raised, input).unwrap();
            assert_eq!(hero.character.body(), other.body(), "{trial}, {k}");
            assert_eq!((hero.character.velocity, hero.character.on_floor()), (other.velocity, other.on_floor()));
        }
    }
}

/// Seen from a crate that slides, runs and jumps are those on a crate at rest.
#[test]
fn a_crate_that_slides_is_a_floor_at_rest() {
    for (trial, speed) in [1, -2, 3].into_iter().enumerate() {
        let speed = Fx::from_num(speed);
        let text = "#".repeat(400) + "\n";
        let level = TileMap::from_ascii(&text, &KINDS).unwrap();
        let level = level.with_origin(Vec2::from_ints(-3200, 100)).unwrap();
        let start = |velocity| {
            let mut room = Room::empty();
            let body = SceneBody { velocity: Vec2::new(velocity, Fx::ZERO), ..SceneBody::new(rect(0, 60, 120, 40), 2) };
            let chest = room.insert(&body).unwrap();
            let mut hero = hero(&mut room, 50, 60, 1);
            for _ in 0..3 {
                frame(&mut room, &level, &[], &mut hero, Input::default());
            }
            (room, chest, hero)
        };
        let (mut still, mut moving) = (start(Fx::ZERO), start(speed));
        let (mut random, mut input, mut jumps) = (Random::new(trial as u64), Input::default(), 0);
        let seen = |(room, chest, hero): &(Room, tilesat::broad::Handle, SceneCharacter)| {
            let from = room.body(*chest).unwrap().shape.position();
            (hero.character.position() - from, hero.character.on_floor())
        };
        // The first steps differ: it was not on the crate yet.
        let late = seen(&still).0 - seen(&moving).0;
        for k in 0..400 {
            play(&mut random, &mut input);
            // It stays on the crate.
            let x = seen(&still).0.x;
            input.run = if x < 20 {
                fx!(1)
            } else if x > 90 {
                fx!(-1)
            } else {
                input.run
            };
            for (room, _, hero) in [&mut still, &mut moving] {
                frame(room, &level, &[], hero, input);
            }
            let ((a, stands), (b, also)) = (seen(&still), seen(&moving));
            assert_eq!((a, stands), (b + late, also), "{speed}, {k}");
            jumps += u32::from(!stands);
        }
        assert!(jumps > 40, "{jumps}");
    }
}

/// A crate on a lift carries it like the lift itself, up, down and sideways.
#[test]
fn a_crate_on_a_lift_carries_it() {
    let level = open();
    for motion in [(1, 0), (0, -2), (0, 2), (-3, 1), (2, -3)] {
        let mut room = Room::empty();
        let mut lifts = [Solid::new(rect(-200, 100, 400, 8), 7).unwrap()];
        let chest = room.insert(&SceneBody::new(rect(0, 80, 40, 20), 2)).unwrap();
        let (mut on_crate, mut on_lift) = (hero(&mut room, 10, 80, 1), hero(&mut room, 100, 100, 1));
        let mut starts = None;
        for k in 0..60 {
            let by = if k < 10 { (0, 0) } else { motion };
            lifts[0].set_motion(Vec2::from_ints(by.0, by.1)).unwrap();
            room.ride(&level, &mut lifts, GRAVITY, fx!(5), |_, ride| assert!(ride.is_ok())).unwrap();
            for hero in [&mut on_crate, &mut on_lift] {
                let step = hero.lead(&mut room, &level, &lifts, Input::default()).unwrap();
                assert_eq!(step.outcome, Outcome::Moved);
            }
            room.step(&Joined::new(&level, &Solids::new(&lifts)), GRAVITY, |_| {}).unwrap();
            for hero in [&mut on_crate, &mut on_lift] {
                hero.follow(&room, &level, &lifts).unwrap();
            }
            let from = lifts[0].shape().min();
            let seen = [room.body(chest).unwrap().shape.position(), on_crate.character.position()].map(|at| at - from);
            let seen = [seen[0], seen[1], on_lift.character.position() - from];
            assert_eq!(*starts.get_or_insert(seen), seen, "{motion:?}, {k}");
        }
        assert_eq!((on_crate.stands_on(), on_lift.stands_on()), (Some(chest), None));
        assert_eq!(on_lift.character.ridden(), Some(7));
    }
}

/// Fixed boxes block from all sides, at any speed.
#[test]
fn no_fixed_box_is_passed() {
    let level = open();
    let mut random = Random::new(5);
    for trial in 0..400 {
        let mut room = Room::empty();
        // A chamber of four thin walls.
        let walls = [rect(-100, -60, 200, 1), rect(-100, 60, 200, 1), rect(-100, -60, 1, 120), rect(99, -60, 1, 120)];
        for (wall, key) in walls.into_iter().zip(2..) {
            room.insert(&SceneBody::fixed(wall, key)).unwrap();
        }
        let mut hero = hero(&mut room, 0, 0, 1);
        let mut input = Input::default();
        for k in 0..120 {
            play(&mut random, &mut input);
            if random.below(10) == 0 {
                let speed = |random: &mut Random| Fx::from_num(random.around(200));
                hero.character.velocity = Vec2::new(speed(&mut random), speed(&mut random));
            }
            frame(&mut room, &level, &[], &mut hero, input);
            let body = hero.character.body();
            let inside = body.min().x >= -99 && body.max().x <= 99 && body.min().y >= -59 && body.max().y <= 60;
            assert!(inside, "{trial}, {k}: {body:?}");
        }
    }
}

/// What a box does below a character: it rises, sinks, is removed, is put elsewhere, and sleeps.
#[test]
fn goes_along_with_the_box_below() {
    let text = "#".repeat(40) + "\n" + &format!("#{}#\n", ".".repeat(38)).repeat(8) + &"#".repeat(40);
    let level = TileMap::from_ascii(&text, &KINDS).unwrap(); // the floor is at y = 144
    let start = || {
        let mut room = Room::empty();
        let body = SceneBody { mass: NonZeroU8::new(60), ..SceneBody::new(rect(100, 124, 20, 20), 2) };
        let chest = room.insert(&body).unwrap();
        let mut hero = hero(&mut room, 105, 124, 1);
        for _ in 0..120 {
            frame(&mut room, &level, &[], &mut hero, Input::default());
        }
        assert_eq!(hero.stands_on(), Some(chest));
        (room, chest, hero)
    };
    let still = Input::default();
    let feet = |hero: &SceneCharacter| hero.character.body().max().y;

    // The box below sleeps.
    let (mut room, chest, mut hero) = start();
    assert!(!room.is_awake(chest).unwrap());
    // A kick from below lifts both, and they come down together.
    room.push(chest, Vec2::from_ints(0, -5)).unwrap();
    let mut highest = fx!(144);
    for _ in 0..90 {
        frame(&mut room, &level, &[], &mut hero, still);
        let top = room.body(chest).unwrap().shape.aabb().min().y;
        assert!(feet(&hero) <= top && feet(&hero) >= top - fx!(1), "{} {top}", feet(&hero));
        highest = highest.min(feet(&hero));
    }
    assert!(highest < 90 && feet(&hero) == 124 && hero.stands_on() == Some(chest), "{highest}");

    // It falls if the box is removed, or put elsewhere.
    for removed in [true, false] {
        let (mut room, chest, mut hero) = start();
        if removed {
            let _ = room.remove(chest).unwrap();
        } else {
            room.place(chest, rect(300, 124, 20, 20)).unwrap();
        }
        for _ in 0..40 {
            frame(&mut room, &level, &[], &mut hero, still);
        }
        assert_eq!(hero.character.body(), &rect(105, 130, 10, 14));
        assert_eq!(hero.stands_on(), None);
    }

    // Its button to drop works on one-way tiles, not on boxes.
    let (mut room, chest, mut hero) = start();
    for k in 0..60 {
        frame(&mut room, &level, &[], &mut hero, Input { drop: true, jump: k == 20, ..still });
    }
    assert_eq!((hero.stands_on(), feet(&hero)), (Some(chest), fx!(124)));
}

/// The masses share a push, and a box at a wall ends it.
#[test]
fn pushes_by_its_mass() {
    let text = "#".repeat(40) + "\n" + &format!("#{}#\n", ".".repeat(38)).repeat(8) + &"#".repeat(40);
    let level = TileMap::from_ascii(&text, &KINDS).unwrap();
    for (mass, speed) in [(1, 0.5), (3, 0.75), (255, 0.996)] {
        let mut room = Room::empty();
        let chest = room.insert(&SceneBody::new(rect(300, 130, 14, 14), 2)).unwrap();
        let mut hero = hero(&mut room, 288, 144, mass);
        let mut at = Vec::new();
        for _ in 0..900 {
            frame(&mut room, &level, &[], &mut hero, Input::running(fx!(1)));
            at.push(room.body(chest).unwrap().shape.position().x);
        }
        let made = f64::from((at[199] - at[99]).to_num::<f32>()) / 100.0;
        assert!((made - speed).abs() < 0.01, "{mass}: {made}");
        assert_eq!(at[899], 624 - 14); // at the wall
        let body = hero.character.body();
        assert!(body.max().x <= 611 && body.max().x >= 609, "{body:?}");
        // The box stays when the push ends.
        for _ in 0..60 {
            frame(&mut room, &level, &[], &mut hero, Input::running(fx!(-1)));
        }
        assert_eq!(room.body(chest).unwrap().shape.position().x, 610);
    }
}

/// Refused calls change nothing, and say why.
#[test]
fn a_refused_step_changes_nothing() {
    let level = open();
    let mut room = Room::empty();
    room.insert(&SceneBody::fixed(rect(-20, 10, 60, 10), 10)).unwrap();
    let mut hero = hero(&mut room, 0, 10, 1);
    frame(&mut room, &level, &[], &mut hero, Input::default());
    hero.character.velocity = Vec2::from_ints(5000, 0);
    let before = (room, hero);
    let same = |room: &Room, hero: &SceneCharacter| {
        *hero == before.1 && room.bodies().eq(before.0.bodies()) && room.awake() == before.0.awake()
    };
    let refused = hero.lead(&mut room, &level, &[], Input::running(fx!(6000))).unwrap_err();
    assert!(same(&room, &hero), "{refused}");

    let _ = room.remove(hero.handle()).unwrap();
    let before = hero;
    assert!(hero.lead(&mut room, &level, &[], Input::default()).is_err());
    assert!(hero.follow(&room, &level, &[]).is_err());
    assert_eq!(hero, before);
}

/// Above and below are one: a scene upside down, with the gravity turned round.
#[test]
fn plays_upside_down() {
    let level = open();
    let turned = |b: &Aabb| Aabb::new(Vec2::new(b.min().x, -b.max().y), Vec2::new(b.max().x, -b.min().y)).unwrap();
    for trial in 0..8 {
        let boxes = [rect(-60, 40, 80, 16), rect(30, 30, 60, 26), rect(-20, 20, 10, 10)];
        let mut rooms = [Room::empty(), Room::empty()];
        let mut heroes = rooms.each_mut().map(|room| hero(room, 0, 20, 3));
        for (room, flipped) in rooms.iter_mut().zip([false, true]) {
            for (k, b) in boxes.iter().enumerate() {
                let shape = if flipped { turned(b) } else { *b };
                let body = SceneBody::new(shape, 2 + k as u32);
                room.insert(&if k < 2 { SceneBody { mass: None, ..body } } else { body }).unwrap();
            }
        }
        heroes[1].character.feel.gravity = fx!(-0.25);
        let body = turned(heroes[1].character.body());
        heroes[1].character.place(body);
        rooms[1].place(heroes[1].handle(), body).unwrap();
        heroes[1] = SceneCharacter::new(heroes[1].character, heroes[1].handle());
        let (mut random, mut input) = (Random::new(trial), Input::default());
        for k in 0..300 {
            play(&mut random, &mut input);
            for ((room, hero), gravity) in rooms.iter_mut().zip(&mut heroes).zip([GRAVITY, -GRAVITY]) {
                let _ = hero.lead(room, &level, &[], input).unwrap();
                room.step(&level, gravity, |_| {}).unwrap();
                hero.follow(room, &level, &[]).unwrap();
            }
            assert_eq!(heroes[0].character.body(), &turned(heroes[1].character.body()), "{trial}, {k}");
            assert_eq!(heroes[0].stands_on(), heroes[1].stands_on(), "{trial}, {k}");
        }
    }
}

/// A capsule runs over boxes as over tiles.
#[test]
fn a_capsule_runs_on_boxes_as_on_tiles() {
    let (above, below) = (open(), "................\n".repeat(4) + &"#".repeat(16));
    let tiles = TileMap::from_ascii(&below, &KINDS).unwrap(); // the floor is at y = 64
    let mut scene = Scene::<SortSweep<BODIES, SceneTag>, BODIES, 0, WithCapsules>::new(SortSweep::new());
    for k in 0..8 {
        let shape = rect(32 * k, 64, 32, 16);
        scene.insert(&SceneBody { mass: None, ..SceneBody::of(shape, 2 + k as u32) }).unwrap();
    }
    let body = Capsule::new(Vec2::from_ints(100, 20), Vec2::from_ints(100, 30), fx!(5)).unwrap();
    let mut other = Character::new(body, rect(-8000, -1000, 16000, 2000), Feel::DEFAULT);
    let led = scene.insert(&SceneBody::led(body, 1)).unwrap();
    let mut hero = SceneCharacter::new(other, led);
    let (mut random, mut input) = (Random::new(3), Input::default());
    for k in 0..900 {
        play(&mut random, &mut input);
        // It stays above the row, and away from its ends.
        let x = other.position().x;
        input.run = if x < 40 {
            fx!(1.5)
        } else if x > 210 {
            fx!(-1.5)
        } else {
            input.run
        };
        let _ = hero.lead(&mut scene, &above, &[], input).unwrap();
        scene.step(&above, GRAVITY, |_| {}).unwrap();
        hero.follow(&scene, &above, &[]).unwrap();
        let _ = other.step(&tiles, input).unwrap();
        assert_eq!((hero.character.body(), hero.character.on_floor()), (other.body(), other.on_floor()), "{k}");
    }
}

/// Random play among crates: never in the level, hardly ever in a crate, and the same in every
/// order of insertion.
#[test]
fn random_play_among_crates() {
    let (mut deep, mut stood) = (0, 0);
    for trial in 0..30 {
        let mut random = Random::new(trial);
        let mut tiles = vec![vec!['.'; 24]; 12];
        for (y, row) in tiles.iter_mut().enumerate() {
            for (x, tile) in row.iter_mut().enumerate() {
                if x == 0 || y == 0 || x == 23 || y == 11 {
                    *tile = '#';
                }
            }
        }
        for _ in 0..10 {
            let (x, y, tile) = (random.within(1, 20), random.within(3, 9), ['#', '-'][random.below(2) as usize]);
            (x..(x + random.within(1, 4)).min(23)).for_each(|x| tiles[y as usize][x as usize] = tile);
        }
        let text: String = tiles.iter().map(|row| row.iter().collect::<String>() + "\n").collect();
        let level = TileMap::from_ascii(&text, &KINDS).unwrap();
        let mut boxes: Vec<Aabb> = Vec::new();
        while boxes.len() < 11 {
            let (w, h) = if boxes.is_empty() { (10, 14) } else { (random.within(4, 8) as i16 * 2, 12) };
            let next = rect(random.within(16, 350) as i16, random.within(16, 150) as i16, w, h);
            if !level.overlaps(&next) && !boxes.iter().any(|other| next.overlaps(other)) {
                boxes.push(next);
            }
        }
        // Two rooms, in both orders of insertion.
        let fast = trial % 2 == 0;
        let mut rooms = [Room::empty(), Room::empty()];
        let crates = |room: &mut Room, k: usize| {
            room.insert(&SceneBody { fast, ..SceneBody::new(boxes[k], 10 + k as u32) }).unwrap()
        };
        let _: Vec<_> = (1..11).map(|k| crates(&mut rooms[0], k)).collect();
        let place = boxes[0].min();
        let mass = [1, 3, 20][trial as usize % 3];
        let mut heroes = rooms.each_mut().map(|room| hero(room, place.x.to_num(), place.y.to_num::<i16>() + 14, mass));
        let _: Vec<_> = (1..11).rev().map(|k| crates(&mut rooms[1], k)).collect();
        let mut input = Input::default();
        for k in 0..1500 {
            play(&mut random, &mut input);
            input.drop = random.below(30) == 0;
            for (room, hero) in rooms.iter_mut().zip(&mut heroes) {
                frame(room, &level, &[], hero, input);
            }
            let hero = &heroes[0].character;
            assert_eq!((hero.body(), hero.velocity), (heroes[1].character.body(), heroes[1].character.velocity));
            assert!(!level.overlaps(hero.body()), "{trial}, {k}");
            let small = Aabb::from_centre(hero.body().centre(), Vec2::from_ints(2, 4)).unwrap();
            rooms[0].overlapping(&small, |_, body| deep += u32::from(body.key != HERO));
            stood += u32::from(heroes[0].stands_on().is_some());
        }
    }
    assert!(deep < 20 && stood > 2000, "{deep} {stood}");
}
