//! What characters of a scene ask: where their floor ends, whether there is room for another body,
//! and what presses them.

use super::scene_character::{KINDS, Room, frame, hero, play, rect};
use super::steps::open;
use core::num::NonZeroU8;
use tilesat::broad::BroadError;
use tilesat::scene::{SceneBody, SceneCharacter, SceneFault};
use tilesat::{Aabb, Circle, Filter, Fx, Input, LayerMask, Solid, TileMap, Vec2, fx};
use tilesat_judge::Random;

/// Rows of boxes have the ledges of the same rows of tiles.
#[test]
fn ledges_of_boxes_are_those_of_tiles() {
    let mut seen = [0, 0];
    for trial in 0..20 {
        let mut random = Random::new(trial);
        let row: String = (0..38).map(|_| if random.below(4) == 0 { '.' } else { '#' }).collect();
        let air = "#".repeat(40) + "\n" + &format!("#{}#\n", ".".repeat(38)).repeat(7);
        let (boxes, tiles) = (air.clone() + &format!("#{}#\n", ".".repeat(38)), air + "#" + &row + "#\n");
        let pit = format!("#{}#\n", ".".repeat(38)) + &"#".repeat(40);
        let (boxes, tiles) = (boxes + &pit, tiles + &pit);
        let [boxes, tiles] = [&boxes, &tiles].map(|rows| TileMap::from_ascii(rows, &KINDS).unwrap());
        let mut room = Room::empty();
        // Each run of tiles is a row of flush boxes.
        let mut from = 0;
        for (x, pair) in (1..).zip(row.chars().chain(['.']).collect::<Vec<_>>().windows(2)) {
            let (tile, next) = (pair[0] == '#', pair[1] == '#');
            if tile && (!next || random.below(2) == 0) {
                let first = if from == 0 { x } else { from };
                let shape = rect(16 * first, 128, 16 * (x + 1 - first), 16);
                room.insert(&SceneBody::fixed(shape, 10 + x as u32)).unwrap();
                from = 0;
            } else if tile && from == 0 {
                from = x;
            }
        }
        let mut hero = hero(&mut room, 300, 100, 1);
        let mut input = Input::default();
        for k in 0..400 {
            play(&mut random, &mut input);
            if hero.character.body().max().y > 130 {
                hero.character.place(rect(random.within(20, 600) as i16, 100, 10, 14));
            }
            frame(&mut room, &boxes, &[], &mut hero, input);
            for far in [fx!(-6), fx!(-0.5), fx!(0.5), fx!(3), fx!(12)] {
                let on_boxes = hero.ledge_ahead(&room, &boxes, &[], far).unwrap();
                let on_tiles = hero.character.ledge_ahead(&tiles, far).unwrap();
                assert_eq!(on_boxes, on_tiles, "{trial}, {k}, {far}: {:?}", hero.character.body());
                seen[usize::from(on_boxes)] += 1;
            }
        }
    }
    assert!(seen[0] > 30_000 && seen[1] > 1000, "{seen:?}");
}

/// A patrol turns at the ends of a loose crate, and of the lift below it.
#[test]
fn patrols_on_a_crate_and_on_a_lift() {
    let level = open();
    let lifts = [Solid::new(rect(-20, 100, 100, 8), 7).unwrap()];
    for (feet, from, to) in [(80, 0, 60), (100, -20, 80)] {
        let mut room = Room::empty();
        if feet == 80 {
            room.insert(&SceneBody::new(rect(0, 80, 60, 20), 2)).unwrap();
        }
        let mut hero = hero(&mut room, 20, feet, 1);
        let (mut run, mut turns) = (fx!(1), 0);
        for k in 0..900 {
            frame(&mut room, &level, &lifts, &mut hero, Input::running(run));
            if hero.ledge_ahead(&room, &level, &lifts, hero.character.stopping_distance(run)).unwrap() {
                (run, turns) = (-run, turns + 1);
            }
            let body = hero.character.body();
            assert!(body.min().x >= from && body.max().x <= to && body.max().y == feet, "{k}: {body:?}");
        }
        assert!((9..30).contains(&turns), "{turns}");
    }
}

/// A body of 10 with the feet of a hero.
fn sized(hero: &SceneCharacter, height: i16) -> Aabb {
    let (lo, hi) = (hero.character.body().min(), hero.character.body().max());
    Aabb::new(Vec2::new(lo.x, hi.y - Fx::from_num(height)), hi).unwrap()
}

/// It stands up only if no body is above it that it would meet.
#[test]
fn stands_up_only_with_room() {
    let level = open();
    let floor = rect(-100, 100, 300, 10);
    let (above, beside) = (rect(45, 70, 20, 20), rect(60, 88, 12, 12));
    let ball = Circle::new(Vec2::from_ints(56, 84), fx!(5)).unwrap();
    let body = |shape: Aabb| SceneBody::new(shape, 3);
    let ghost = SceneBody { filter: Filter::new(LayerMask::NONE, LayerMask::NONE), ..body(above) };
    let sensor = SceneBody { filter: Filter::default().with_sensor(true), ..body(above) };
    let cases = [
        (SceneBody { floats: true, ..body(above) }, false),
        (SceneBody { mass: None, ..body(above) }, false),
        (SceneBody { floats: true, ..SceneBody::new(ball, 3) }, false),
        (SceneBody { floats: true, ..ghost }, true),
        (SceneBody { floats: true, ..sensor }, true),
        (body(beside), true),
    ];
    for (k, (other, fits)) in cases.into_iter().enumerate() {
        let mut room = Room::empty();
        room.insert(&SceneBody::fixed(floor, 2)).unwrap();
        let mut hero = hero(&mut room, 50, 100, 1);
        let low = sized(&hero, 8);
        assert!(hero.set_body(&room, &level, &[], low).unwrap());
        room.insert(&other).unwrap();
        for _ in 0..4 {
            // It presses against the crate beside it.
            frame(&mut room, &level, &[], &mut hero, Input::running(fx!(0.5)));
        }
        let (before, tall) = (hero, sized(&hero, 14));
        assert_eq!(hero.set_body(&room, &level, &[], tall).unwrap(), fits, "{k}");
        assert_eq!(hero.character.body(), if fits { &tall } else { before.character.body() });
        assert!(fits || hero == before, "{k}");
        frame(&mut room, &level, &[], &mut hero, Input::default());
        assert_eq!(room.body(hero.handle()).unwrap().shape.aabb().min().y, if fits { fx!(86) } else { fx!(92) }, "{k}");
    }
    // A lift above, and the level.
    let mut room = Room::empty();
    room.insert(&SceneBody::fixed(floor, 2)).unwrap();
    let mut hero = hero(&mut room, 50, 100, 1);
    let (low, tall) = (sized(&hero, 8), sized(&hero, 14));
    assert!(hero.set_body(&room, &level, &[], low).unwrap());
    let lift = [Solid::new(rect(40, 80, 40, 10), 4).unwrap()];
    assert!(!hero.set_body(&room, &level, &lift, tall).unwrap());
    let ceiling = TileMap::from_ascii("####\n####\n####\n####\n####\n####", &KINDS).unwrap();
    let ceiling = ceiling.with_origin(Vec2::from_ints(30, -6)).unwrap();
    assert!(!hero.set_body(&room, &ceiling, &[], tall).unwrap());
    assert!(hero.set_body(&room, &level, &[], tall).unwrap());
}

/// A hero that crouches on a raft goes along with it like one that does not.
#[test]
fn crouching_keeps_it_on_a_raft() {
    let level = open();
    let ends = [false, true].map(|crouches| {
        let mut room = Room::empty();
        let velocity = Vec2::from_ints(2, -1);
        let raft = SceneBody { velocity, floats: true, ..SceneBody::new(rect(0, 100, 60, 10), 2) };
        room.insert(&raft).unwrap();
        let mut hero = hero(&mut room, 20, 100, 1);
        for k in 0..60 {
            if crouches && k % 7 == 6 {
                let body = sized(&hero, if k % 2 == 0 { 8 } else { 14 });
                assert!(hero.set_body(&room, &level, &[], body).unwrap());
            }
            frame(&mut room, &level, &[], &mut hero, Input::default());
        }
        hero.character.body().max()
    });
    assert_eq!(ends[0], ends[1]);
}

/// A press, a door and a ceiling: the depth is what they lack of room, and at first there is none.
#[test]
fn tells_what_presses_it() {
    let level = open();
    for (key, speed) in [(3, 1), (5, 2), (5, 3)] {
        let mut room = Room::empty();
        let floor = room.insert(&SceneBody::fixed(rect(-200, 100, 400, 40), 4)).unwrap();
        let press = room.insert(&SceneBody::fixed(rect(-50, 20, 100, 40), key)).unwrap();
        room.insert(&SceneBody {
            filter: Filter::default().with_sensor(true),
            floats: true,
            ..SceneBody::new(rect(-5, 80, 20, 15), 9)
        })
        .unwrap();
        let mut hero = hero(&mut room, 0, 100, 1);
        for y in (20..=54).step_by(speed) {
            frame(&mut room, &level, &[], &mut hero, Input::default());
            assert_eq!(hero.pressed_by(&room).unwrap(), None, "{y}");
            room.place(press, rect(-50, y.min(46), 100, 40)).unwrap();
        }
        // 4 units too low. Whichever of both the hero is in: the press, as the floor blocks it.
        room.place(press, rect(-50, 50, 100, 40)).unwrap();
        frame(&mut room, &level, &[], &mut hero, Input::default());
        let (by, depth) = hero.pressed_by(&room).unwrap().unwrap();
        assert!([press, floor].contains(&by) && (2..=4).contains(&depth.to_num::<i32>()), "{by:?} {depth}");
    }
    // Of two equal ones, that with the smaller key; otherwise the deeper one.
    for (keys, by) in [([3, 4], [100, 100]), ([4, 3], [100, 100]), ([3, 4], [99, 100])] {
        let mut room = Room::empty();
        let mut hero = hero(&mut room, 0, 100, 1);
        frame(&mut room, &level, &[], &mut hero, Input::default());
        let feet = hero.character.body().max().y.to_num::<i16>();
        let at = |x: i16, top: i16| rect(x, feet - 2 + top - 100, 5, 40);
        let left = room.insert(&SceneBody::fixed(at(0, by[0]), keys[0])).unwrap();
        let right = room.insert(&SceneBody::fixed(at(5, by[1]), keys[1])).unwrap();
        let first = if by[0] < by[1] || keys[0] < keys[1] { left } else { right };
        assert_eq!(hero.pressed_by(&room).unwrap().unwrap().0, first, "{keys:?} {by:?}");
    }
}

/// Without its body, each question is refused, and nothing changes.
#[test]
fn a_removed_body_is_an_error() {
    let level = open();
    let mut room = Room::empty();
    room.insert(&SceneBody::fixed(rect(-20, 10, 60, 10), 10)).unwrap();
    let mut hero = hero(&mut room, 0, 10, 1);
    frame(&mut room, &level, &[], &mut hero, Input::default());
    let _ = room.remove(hero.handle()).unwrap();
    // Another body in its slot.
    room.insert(&SceneBody { mass: NonZeroU8::new(1), ..SceneBody::new(rect(0, 0, 4, 4), 11) }).unwrap();
    let (before, low) = (hero, sized(&hero, 8));
    let stale = |fault: SceneFault| assert!(matches!(fault, SceneFault::Broad(BroadError::Stale(_))));
    stale(hero.ledge_ahead(&room, &level, &[], fx!(1)).unwrap_err().fault);
    stale(hero.set_body(&room, &level, &[], low).unwrap_err().fault);
    stale(hero.pressed_by(&room).unwrap_err().fault);
    assert_eq!(hero, before);
}
