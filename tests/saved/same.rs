//! A restored state equals the saved one, bit for bit, through bytes and through text.

use crate::values::{
    Near, bouncer, convex_solids, grid, hash, heroes, lists, rope, rubber, scene, shapes, solids, springs, walker,
};
use core::fmt::Debug;
use serde::Serialize;
use serde::de::DeserializeOwned;
use tilesat::broad::{BroadPhase, BruteForce};
use tilesat::scene::{SceneBody, SceneCharacter, SceneTag, SortSweepScene};
use tilesat::shape::{AnyShape, Compound};
use tilesat::{
    Aabb, Axis, Character, Circle, Feel, Fx, Input, Mover, Scene, TileKind, TileKinds, TileMap, Vec2, fx, motion::Memo,
};
use tilesat_judge::scenes::{BODIES, check, room};

pub(crate) fn bytes<T: Serialize>(value: &T) -> Vec<u8> {
    let mut room = vec![0; 1 << 14];
    postcard::to_slice(value, &mut room).unwrap().to_vec()
}

/// Through bytes and through text.
fn again<T: Serialize + DeserializeOwned>(value: &T) -> T {
    let text = serde_json::to_string(value).unwrap();
    let read: T = serde_json::from_str(&text).unwrap_or_else(|e| panic!("{e}: {text}"));
    let written = bytes(&read);
    assert_eq!(written, bytes(value), "{text}");
    postcard::from_bytes(&written).unwrap()
}

fn same<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T) {
    assert_eq!(again(value), *value);
}

#[test]
fn plain_states_are_the_same() {
    let (aabbs, circles, segments, capsules, turned, polygons) = shapes();
    aabbs.iter().for_each(same);
    circles.iter().for_each(same);
    segments.iter().for_each(same);
    capsules.iter().for_each(same);
    turned.iter().for_each(same);
    polygons.iter().for_each(same);
    let mut any: Vec<AnyShape<5>> = vec![aabbs[1].into(), circles[3].into(), segments[0].into(), turned[1].into()];
    any.extend(capsules.iter().map(|it| AnyShape::from(*it)).chain(polygons.iter().map(|it| AnyShape::from(*it))));
    any.iter().for_each(same);
    same(&Compound::<AnyShape<5>, 8>::new(&any).unwrap());
    let none = serde_json::from_str::<Compound<AnyShape<5>, 8>>("{\"parts\":[]}");
    assert!(none.unwrap_err().to_string().contains("a compound needs at least one part"));
    solids().iter().for_each(same);
    convex_solids().iter().for_each(same);
    heroes().iter().for_each(same);
    same(&walker());
    same(&Mover::new());
    same(&bouncer());
    same(&springs());
    same(&rubber());
    same(&rope());
    let (events, exceptions) = lists();
    same(&events);
    same(&exceptions);
    assert!(events.iter().count() > 2 && again(&events).iter().eq(events.iter()));
}

/// The code linked for bounces is not written. It returns with the table.
#[test]
fn a_table_of_responses_still_bounces() {
    static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL.with_flags(2));
    let level = TileMap::from_ascii("....\n####\n", &KINDS).unwrap();
    let body = Aabb::new(Vec2::from_ints(4, 4), Vec2::from_ints(10, 14)).unwrap();
    let moved = again(&springs()).move_and_slide(&level, &body, Vec2::from_ints(1, 4)).unwrap();
    assert_eq!(moved.velocity, Vec2::from_ints(1, -4));
}

#[test]
fn a_hero_goes_on_the_same() {
    static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    let level = TileMap::from_ascii("#......#\n#......#\n#......#\n########\n", &KINDS).unwrap();
    for hero in heroes() {
        let (mut one, mut other): (Character, _) = (hero, again(&hero));
        for _ in 0..20 {
            let input = Input { run: fx!(1), jump: true, drop: false };
            assert_eq!(one.step(&level, input), other.step(&level, input));
            assert_eq!(one, other);
        }
    }
}

/// On a crate that slides: what it rides is a part of its state.
#[test]
fn a_character_of_a_scene_goes_on_the_same() {
    let level = room();
    let boxed = |y| Aabb::from_size(Vec2::from_ints(20, y), Vec2::from_ints(16, 12)).unwrap();
    let mut scene = SortSweepScene::<4>::empty();
    let velocity = Vec2::new(fx!(0.25), Fx::ZERO);
    scene.insert(&SceneBody { velocity, floats: true, ..SceneBody::new(boxed(40), 1) }).unwrap();
    let body = scene.insert(&SceneBody::led(boxed(28), 2)).unwrap();
    let mut hero = SceneCharacter::new(Character::new(boxed(28), level.bounds(), Feel::DEFAULT), body);
    for frame in 0..40 {
        let read: SceneCharacter = again(&hero);
        assert_eq!(read, hero, "{frame}");
        let _ = hero.lead(&mut scene, &level, &[], Input::default()).unwrap();
        scene.step(&level, Vec2::ZERO, |_| {}).unwrap();
        hero.follow(&scene, &level, &[]).unwrap();
    }
    assert!(hero.stands_on().is_some() && hero.character.position().x > 25);
}

/// Caches are not written.
#[test]
fn a_memo_is_read_empty() {
    let level = room();
    let (mover, mut memo) = (Mover::platformer(Axis::NEG_Y), Memo::new());
    let body = Aabb::new(Vec2::from_ints(30, 54), Vec2::from_ints(38, 64)).unwrap();
    let fall = Vec2::from_raw(0, 6554);
    let first = memo.move_and_slide(&mover, &level, 0, &body, fall).unwrap();
    assert_ne!(memo, Memo::new());
    let mut read: Memo<Aabb> = again(&memo);
    assert_eq!(read, Memo::new());
    assert_eq!(read.move_and_slide(&mover, &level, 0, &body, fall), Ok(first));
}

fn goes_on<B: BroadPhase<Tag = SceneTag> + Copy + PartialEq + Serialize + DeserializeOwned + Debug>(near: B) {
    let map = room();
    for (seed, frames) in [(0, 0), (1, 1), (2, 7), (3, 26), (4, 60), (5, 400)] {
        let mut one = scene(near, seed, frames);
        let mut other: Scene<B, BODIES> = again(&one);
        for frame in 0..40 {
            assert_eq!(bytes(&one), bytes(&other), "{seed}, {frame}");
            assert!(one.snapshot() == other.snapshot(), "{seed}, {frame}");
            check(&other);
            let mut told = [Vec::new(), Vec::new()];
            for (scene, told) in [&mut one, &mut other].into_iter().zip(&mut told) {
                let stepped =
                    scene.step(&map, Vec2::from_raw(0, 6554), |event| told.push(format!("{event:?}"))).unwrap();
                told.push(format!("{stepped:?}"));
            }
            assert_eq!(told[0], told[1], "{seed}, {frame}");
            // New slots are the same, too.
            if frame % 8 == 0 {
                for scene in [&mut one, &mut other] {
                    let (handle, body) = scene.bodies().next().map(|(handle, body)| (handle, *body)).unwrap();
                    scene.remove(handle).unwrap();
                    scene.insert(&body).unwrap();
                }
            }
        }
    }
}

#[test]
fn scenes_go_on_the_same() {
    goes_on(Near::new());
    goes_on(BruteForce::<BODIES, SceneTag>::new());
    goes_on(grid());
    goes_on(hash());
}

/// What a free slot keeps does not depend on the body that it had, except for its left side.
fn free_slots<B: BroadPhase<Tag = SceneTag> + Copy + PartialEq + Serialize + DeserializeOwned + Debug>(near: B) {
    let map = room();
    // The second one is too large for a cell.
    let ball = |k: i16, key: u32| {
        let radius = if k == 1 { fx!(30) } else { fx!(2) };
        SceneBody::new(Circle::new(Vec2::from_ints(40 + 3 * k, 30), radius).unwrap(), key)
    };
    // In every order of removals, before and after steps.
    for order in 0..27 {
        for steps in [0, 1, 3] {
            let mut twins = [0, 10].map(|keys| {
                let mut scene = Scene::<B, BODIES>::new(near);
                let handles = [0, 1, 2].map(|k| scene.insert(&ball(k, keys + k as u32)).unwrap());
                for _ in 0..steps {
                    scene.step(&map, Vec2::ZERO, |_| {}).unwrap();
                }
                (scene, handles)
            });
            for at in [order % 3, order / 3 % 3, order / 9] {
                let [(one, handles), (other, _)] = &mut twins;
                assert_eq!(one.remove(handles[at]).is_ok(), other.remove(handles[at]).is_ok());
                same(&one.snapshot());
                assert_eq!(
                    one.snapshot() == other.snapshot(),
                    one.bodies().next().is_none(),
                    "only the keys of bodies differ"
                );
                one.step(&map, Vec2::ZERO, |_| {}).unwrap();
                other.step(&map, Vec2::ZERO, |_| {}).unwrap();
                same(&one.snapshot());
            }
        }
    }
}

#[test]
fn free_slots_are_the_same() {
    free_slots(Near::new());
    free_slots(BruteForce::<BODIES, SceneTag>::new());
    free_slots(grid());
    free_slots(hash());
}
