//! What characters of a scene stand on besides boxes: balls, capsules and polygons up to 45
//! degrees, and low crates, which they climb.

use super::scene_character::{GRAVITY, KINDS, Room, frame, hero, play, rect};
use super::steps::open;
use core::num::NonZeroU8;
use tilesat::broad::{Handle, SortSweep};
use tilesat::prelude::*;
use tilesat::scene::{SceneBody, SceneCharacter, SceneTag, Shape, WithCapsules};
use tilesat::shape::AnyShape;
use tilesat::{Aabb, Axis, Capsule, Character, Circle, Feel, Fx, Input, OrientedBox, Scene, TileMap, Vec2, fx};
use tilesat_judge::Random;
use tilesat_judge::scenes::BODIES;

fn ball(x: i16, y: i16, r: i16) -> Circle {
    Circle::new(Vec2::from_ints(x, y), Fx::from_num(r)).unwrap()
}

fn feet(hero: &SceneCharacter) -> Fx {
    hero.character.body().max().y
}

/// A hero lands on a ball, stays there for ever, and jumps as high as off tiles.
#[test]
fn stands_on_a_ball_and_jumps() {
    let level =
        TileMap::from_ascii("................\n................\n................\n................", &KINDS).unwrap();
    let floor = rect(-100, 60, 400, 4);
    for (mass, radius) in [(0, 8), (1, 8), (20, 3), (1, 20)] {
        let mut room = Room::empty();
        room.insert(&SceneBody::fixed(floor, 2)).unwrap();
        let body = SceneBody { mass: NonZeroU8::new(mass), ..SceneBody::new(ball(55, 60 - radius, radius), 3) };
        let boulder = room.insert(&body).unwrap();
        let top = 60 - 2 * radius;
        let mut hero = hero(&mut room, 50, top - 20, 1);
        for k in 0..200 {
            frame(&mut room, &level, &[], &mut hero, Input::default());
            assert!(feet(&hero) <= top + 1, "{mass} {radius} {k}");
            if k > 30 {
                assert_eq!(
                    (feet(&hero), hero.character.velocity),
                    (Fx::from_num(top), Vec2::ZERO),
                    "{mass} {radius} {k}"
                );
                assert!(hero.character.on_floor() && hero.stands_on() == Some(boulder), "{mass} {radius} {k}");
            }
        }
        assert!(mass == 0 || !room.is_awake(boulder).unwrap());
        let mut highest = feet(&hero);
        for k in 0..60 {
            frame(&mut room, &level, &[], &mut hero, Input { jump: k < 30, ..Input::default() });
            highest = highest.min(feet(&hero));
        }
        assert_eq!(Fx::from_num(top) - highest, fx!(42.75), "{mass} {radius}");
        assert_eq!(hero.stands_on(), Some(boulder));
    }
}

/// A ball carries what stands on it, like a box of the same size.
#[test]
fn a_ball_carries_like_a_box() {
    let level = open();
    for (trial, motion) in [(1, 0), (-2, 0), (0, -1), (0, 2), (3, -1)].into_iter().enumerate() {
        let games = [Shape::from(ball(55, 68, 8)), rect(47, 60, 16, 16).into()].map(|shape| {
            let mut room = Room::empty();
            let velocity = Vec2::from_ints(motion.0, motion.1);
            let body = SceneBody { velocity, floats: true, mass: NonZeroU8::new(50), ..SceneBody::of(shape, 3) };
            let balloon = room.insert(&body).unwrap();
            let mut hero = hero(&mut room, 50, 60, 1);
            let (mut at, mut random, mut input) = (Vec::new(), Random::new(trial as u64), Input::default());
            for _ in 0..120 {
                play(&mut random, &mut input);
                input.run = Fx::ZERO;
                frame(&mut room, &level, &[], &mut hero, input);
                at.push((hero.character.position(), hero.character.velocity, hero.stands_on() == Some(balloon)));
            }
            at
        });
        assert_eq!(games[0], games[1], "{motion:?}");
        let (first, last) = (games[0][0].0, games[0][119].0);
        assert!((last - first).dot(Vec2::from_ints(motion.0, motion.1)) > 0);
    }
}

/// On the flank of a ball it stands up to 45 degrees. The height is that of the circle.
#[test]
fn stands_on_flanks_up_to_45_degrees() {
    let level = open();
    let (radius, mut stood) = (20, [0, 0]);
    for beside in -19..=19_i16 {
        let mut room = Room::empty();
        room.insert(&SceneBody::fixed(ball(0, 40, radius), 3)).unwrap();
        room.insert(&SceneBody::fixed(rect(-200, 60, 400, 4), 2)).unwrap();
        // The lower corner that is nearer to the middle of the ball.
        let mut hero = hero(&mut room, if beside > 0 { beside } else { beside - 10 }, 20, 1);
        for _ in 0..100 {
            frame(&mut room, &level, &[], &mut hero, Input::default());
        }
        let steep = f64::from(beside.abs()) > f64::from(radius) / 2.0_f64.sqrt();
        let circle = 40.0 - (f64::from(radius).powi(2) - f64::from(beside).powi(2)).sqrt();
        let at = feet(&hero).to_num::<f64>();
        assert!(hero.character.on_floor());
        if steep {
            assert_eq!(feet(&hero), 60, "{beside}");
        } else {
            assert!((at - circle).abs() < 0.001, "{beside}: {at} {circle}");
        }
        stood[usize::from(steep)] += 1;
    }
    assert_eq!(stood, [29, 10]);
}

/// It walks down a boulder without leaving it, and up again.
#[test]
fn walks_over_a_boulder() {
    let level = open();
    for way in [1, -1] {
        let mut room = Room::empty();
        let boulder = room.insert(&SceneBody::fixed(ball(0, 60, 40), 3)).unwrap();
        let mut hero = hero(&mut room, -5, 20, 1);
        let above = |hero: &SceneCharacter, beside: Fx| {
            let (beside, at) = (beside.to_num::<f64>(), feet(hero).to_num::<f64>());
            60.0 - (1600.0 - beside * beside).sqrt() - at
        };
        let beside = |hero: &SceneCharacter| {
            let body = hero.character.body();
            if body.min().x > 0 { body.min().x } else { body.max().x.min(Fx::ZERO) }
        };
        for _ in 0..26 {
            frame(&mut room, &level, &[], &mut hero, Input::running(Fx::from_num(way)));
            // Down it is a frame behind the circle.
            let gap = above(&hero, beside(&hero));
            assert!(
                hero.character.on_floor() && hero.stands_on() == Some(boulder) && (-0.01..1.1).contains(&gap),
                "{gap}"
            );
        }
        let low = hero.character.position();
        for _ in 0..60 {
            frame(&mut room, &level, &[], &mut hero, Input::running(Fx::from_num(-way)));
            let gap = above(&hero, beside(&hero));
            assert!(hero.character.on_floor() && (-0.01..1.1).contains(&gap), "{gap}");
            assert_eq!(hero.character.velocity.y, 0);
        }
        let made = (hero.character.position() - low).x.abs();
        assert!(made > 35 && made < 60, "{made}");
    }
}

/// Round characters on round bodies, and on polygons.
#[test]
fn round_characters_stand_on_any_shape() {
    let level = open();
    let body = Capsule::new(Vec2::from_ints(50, 10), Vec2::from_ints(50, 20), fx!(5)).unwrap();
    let limits = rect(-8000, -1000, 16000, 2000);
    let log = Capsule::new(Vec2::from_ints(40, 60), Vec2::from_ints(60, 60), fx!(6)).unwrap();
    for (below, top) in [(WithCapsules::from(log), 54), (ball(50, 60, 8).into(), 52), (rect(40, 58, 20, 8).into(), 58)]
    {
        let mut scene = Scene::<SortSweep<BODIES, SceneTag>, BODIES, 0, WithCapsules>::new(SortSweep::new());
        let below = scene.insert(&SceneBody { mass: None, ..SceneBody::of(below, 2) }).unwrap();
        let led = scene.insert(&SceneBody::led(body, 1)).unwrap();
        let mut hero = SceneCharacter::new(Character::new(body, limits, Feel::DEFAULT), led);
        let mut jumps = 0;
        for k in 0..90 {
            let step = hero.lead(&mut scene, &level, &[], Input { jump: k == 60, ..Input::default() }).unwrap();
            jumps += u32::from(step.jumped);
            scene.step(&level, GRAVITY, |_| {}).unwrap();
            hero.follow(&scene, &level, &[]).unwrap();
            if (40..60).contains(&k) {
                let above = Fx::from_num(top) - hero.character.body().aabb().max().y;
                assert!(hero.stands_on() == Some(below) && (0..=1).contains(&above.to_bits()), "{above}");
            }
        }
        assert_eq!(jumps, 1);
    }
    // Beside the middle of a small ball: its own middle is not above the ball.
    for beside in -6..=6_i16 {
        let mut scene = Scene::<SortSweep<BODIES, SceneTag>, BODIES, 0, WithCapsules>::new(SortSweep::new());
        let below = scene.insert(&SceneBody { mass: None, ..SceneBody::of(ball(50, 60, 4), 2) }).unwrap();
        let body = ball(50 + beside, 45, 5);
        let led = scene.insert(&SceneBody::led(body, 1)).unwrap();
        let mut hero = SceneCharacter::new(Character::new(body, limits, Feel::DEFAULT), led);
        for _ in 0..60 {
            frame(&mut scene, &level, &[], &mut hero, Input::default());
        }
        let (at, x) = (hero.character.position().y.to_num::<f64>(), f64::from(beside));
        assert!((at - 60.0 + (81.0 - x * x).sqrt()).abs() < 0.001, "{beside}: {at}");
        assert_eq!((hero.stands_on(), hero.character.velocity), (Some(below), Vec2::ZERO));
    }
    // A ramp of three in four, and a diamond with its corner up.
    let ramp = OrientedBox::new(Vec2::from_ints(50, 70), Vec2::from_ints(30, 5), Axis::new(4, 3)).unwrap();
    let diamond = OrientedBox::new(Vec2::from_ints(50, 70), Vec2::from_ints(10, 10), Axis::new(1, 1)).unwrap();
    let hero_box = rect(45, 30, 10, 14);
    for below in [ramp, diamond] {
        let mut scene = Scene::<SortSweep<BODIES, SceneTag>, BODIES, 0, AnyShape<6>>::new(SortSweep::new());
        let below = scene.insert(&SceneBody { mass: None, ..SceneBody::of(below, 2) }).unwrap();
        let led = scene.insert(&SceneBody::led(hero_box, 1)).unwrap();
        let mut hero = SceneCharacter::new(Character::new(hero_box, limits, Feel::DEFAULT), led);
        let mut at = Vec::new();
        for _ in 0..90 {
            frame(&mut scene, &level, &[], &mut hero, Input::default());
            at.push(hero.character.position());
        }
        assert!(at[60..].iter().all(|p| *p == at[60]) && hero.stands_on() == Some(below), "{:?}", at[89]);
    }
}

/// It climbs crates that are no higher than its step, and pushes the others; fixed ones block.
#[test]
fn climbs_low_crates() {
    let text = "#".repeat(40) + "\n" + &format!("#{}#\n", ".".repeat(38)).repeat(8) + &"#".repeat(40);
    let level = TileMap::from_ascii(&text, &KINDS).unwrap(); // the floor is at y = 144
    for (height, fixed, climbs) in
        [(3, false, true), (4, false, true), (5, false, false), (4, true, true), (5, true, false)]
    {
        for way in [1, -1] {
            let mut room = Room::empty();
            let body = SceneBody::new(rect(300, 144 - height, 30, height), 2);
            let low = room.insert(&if fixed { SceneBody { mass: None, ..body } } else { body }).unwrap();
            let mut hero = hero(&mut room, if way > 0 { 270 } else { 350 }, 144, 1);
            let mut stood = 0;
            for _ in 0..110 {
                frame(&mut room, &level, &[], &mut hero, Input::running(Fx::from_num(way)));
                stood += u32::from(hero.stands_on() == Some(low));
            }
            let moved = room.body(low).unwrap().shape.position().x != 300;
            let passed = if way > 0 { hero.character.position().x > 340 } else { hero.character.position().x < 280 };
            assert_eq!((stood > 25, passed, moved), (climbs, climbs, !climbs && !fixed), "{height} {fixed} {way}");
        }
    }
}

/// Below a ceiling that leaves no room above a low crate, it pushes the crate.
#[test]
fn pushes_a_low_crate_through_a_passage() {
    let tunnel = "#".repeat(20) + "\n" + &format!("#{}#\n", ".".repeat(18)).repeat(3) + "#......" + &"#".repeat(13);
    let level = tunnel + "\n#" + &".".repeat(18) + "#\n" + &"#".repeat(20); // 16 high from x = 112, the floor is at y = 96
    let level = TileMap::from_ascii(&level, &KINDS).unwrap();
    for start in [122, 150] {
        let mut room = Room::empty();
        let low = room.insert(&SceneBody::new(rect(start, 92, 10, 4), 2)).unwrap();
        let mut hero = hero(&mut room, start - 15, 96, 3);
        for _ in 0..80 {
            frame(&mut room, &level, &[], &mut hero, Input::running(fx!(1)));
        }
        assert!(room.body(low).unwrap().shape.position().x > start + 30, "{start}");
    }
}

/// Random play among balls and boxes: no velocity is gained, hardly a frame is spent in the air
/// without a fall, and the bits are the same in another order and upside down.
#[test]
fn random_play_among_balls() {
    let (mut hovers, mut stood, mut deep) = (0, 0, 0);
    for trial in 0..24 {
        let mut random = Random::new(trial);
        let mut text = "#".repeat(24) + "\n" + &format!("#{}#\n", ".".repeat(22)).repeat(10) + &"#".repeat(24);
        text.replace_range(25 * 6 + 4..25 * 6 + 8, "####");
        let turned: String = text.lines().rev().map(|row| row.to_string() + "\n").collect();
        let levels = [&text, &text, &turned].map(|rows| TileMap::from_ascii(rows, &KINDS).unwrap());
        let mut shapes: Vec<Shape> = vec![rect(200, 40, 10, 14).into()];
        while shapes.len() < 12 {
            let (x, y, r) = (random.within(30, 350) as i16, random.within(30, 160) as i16, random.within(3, 10) as i16);
            let next = if random.below(3) == 0 { rect(x, y, r + 4, r).into() } else { ball(x, y, r).into() };
            if !levels[0].overlaps(&Shape::aabb(&next)) && !shapes.iter().any(|other: &Shape| other.touches(&next)) {
                shapes.push(next);
            }
        }
        let turn = |shape: &Shape| -> Shape {
            let y = |y: Fx| Fx::from_num(192) - y;
            match shape {
                Shape::Aabb(b) => {
                    Aabb::new(Vec2::new(b.min().x, y(b.max().y)), Vec2::new(b.max().x, y(b.min().y))).unwrap().into()
                }
                Shape::Circle(c) => Circle::new(Vec2::new(c.centre().x, y(c.centre().y)), c.radius()).unwrap().into(),
            }
        };
        let mut games = [(false, false), (true, false), (false, true)].map(|(back, down)| {
            let mut room = Room::empty();
            let mut led = None;
            let mut order: Vec<usize> = (0..12).collect();
            if back {
                order.reverse();
            }
            for k in order {
                let shape = if down { turn(&shapes[k]) } else { shapes[k] };
                if k == 0 {
                    let feel = Feel { gravity: if down { fx!(-0.25) } else { fx!(0.25) }, ..Feel::DEFAULT };
                    let hero = Character::new(shape.aabb(), rect(-1000, -1000, 3000, 3000), feel);
                    let body = SceneBody { mass: NonZeroU8::new(3), ..SceneBody::led(shape.aabb(), 1) };
                    led = Some(SceneCharacter::new(hero, room.insert(&body).unwrap()));
                } else {
                    let mass = NonZeroU8::new([0, 1, 1, 5][k % 4]);
                    room.insert(&SceneBody { mass, fast: k % 3 == 0, ..SceneBody::of(shape, 10 + k as u32) }).unwrap();
                }
            }
            (room, led.unwrap(), if down { -GRAVITY } else { GRAVITY })
        });
        let (mut input, mut still) = (Input::default(), 0);
        for k in 0..900 {
            play(&mut random, &mut input);
            let from = games[0].1.character.position().y;
            for ((room, hero, gravity), level) in games.iter_mut().zip(&levels) {
                let _ = hero.lead(room, level, &[], input).unwrap();
                room.step(level, *gravity, |_| {}).unwrap();
                hero.follow(room, level, &[]).unwrap();
            }
            let seen = |(_, hero, _): &(Room, SceneCharacter, Vec2)| {
                (Shape::from(*hero.character.body()), hero.character.velocity, hero.character.on_floor())
            };
            let (shape, velocity, floor) = seen(&games[0]);
            assert_eq!(seen(&games[1]), (shape, velocity, floor), "{trial}, {k}");
            assert_eq!(seen(&games[2]), (turn(&shape), Vec2::new(velocity.x, -velocity.y), floor), "{trial}, {k}");
            assert!(velocity.x.abs() <= 8 && velocity.y.abs() <= 8, "{trial}, {k}: {velocity:?}");
            still = if !floor && (games[0].1.character.position().y - from).abs() < 0.05 { still + 1 } else { 0 };
            hovers += u32::from(still > 5);
            let on = |at: Handle| games[0].0.body(at).is_ok_and(|body| matches!(body.shape, Shape::Circle(_)));
            stood += u32::from(games[0].1.stands_on().is_some_and(on));
            deep += u32::from(games[0].1.pressed_by(&games[0].0).unwrap().is_some_and(|(_, depth)| depth > 3));
        }
    }
    assert!(hovers < 20 && stood > 1000 && deep < 40, "{hovers} {stood} {deep}");
}
