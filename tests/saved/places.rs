//! Every place of a saved state is changed, one at a time: each byte to several values, and each
//! number, flag and name of the text. What comes back is an error that says something, or a value
//! that can be used: it is written again as it was read, and a scene makes steps.

use crate::same::bytes;
use crate::values::{
    Grid, Hash, Near, bouncer, convex_solids, grid, hash, heroes, lists, rope, scene, shapes, solids, springs, walker,
};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json, to_value};
use tilesat::broad::BroadPhase;
use tilesat::scene::{SceneTag, Snapshot};
use tilesat::{Aabb, Character, Input, Mover, Scene, TileMap, Vec2, Walker, fx};
use tilesat_judge::cases;
use tilesat_judge::scenes::{BODIES, check, room};

/// How many changed states were refused, and how many were read.
#[derive(Default)]
struct Found {
    refused: u32,
    read: u32,
}

impl Found {
    fn count(&mut self, is_read: bool) {
        *(if is_read { &mut self.read } else { &mut self.refused }) += 1;
    }
}

/// Each byte, to its neighbours, its ends and with each bit turned; and each beginning of the
/// whole. `reads` is whether changed bytes are read.
fn every_byte(written: &[u8], step: usize, reads: &mut dyn FnMut(&[u8]) -> bool) -> Found {
    let mut found = Found::default();
    for at in (0..written.len()).step_by(step) {
        let was = written[at];
        let turned = (0..8).map(|bit| was ^ 1 << bit);
        for to in turned.chain([0, 1, 0x7f, 0x80, 0xff, was.wrapping_add(1), was.wrapping_sub(1)]) {
            let mut changed = written.to_vec();
            changed[at] = to;
            if to != was {
                found.count(reads(&changed));
            }
        }
        assert!(!reads(&written[..at]), "the first {at} bytes are read");
        found.refused += 1;
    }
    found
}

/// The paths to all that is not made of parts, and of the lists.
fn places(form: &Value, path: &str, all: &mut Vec<String>) {
    match form {
        Value::Object(parts) => parts.iter().for_each(|(name, part)| places(part, &format!("{path}/{name}"), all)),
        Value::Array(parts) => {
            all.push(path.into());
            parts.iter().enumerate().for_each(|(k, part)| places(part, &format!("{path}/{k}"), all));
        }
        _ => all.push(path.into()),
    }
}

/// Each place of the text, to values of its kind and to one of another kind. `reads` is whether a
/// changed text is read.
fn every_place(form: &Value, step: usize, reads: &mut dyn FnMut(&str) -> bool) -> Found {
    let (mut all, mut found) = (Vec::new(), Found::default());
    places(form, "", &mut all);
    for path in all.iter().step_by(step) {
        let was = form.pointer(path).unwrap().clone();
        let to = match &was {
            Value::Number(number) => {
                let n = number.as_i64().unwrap_or(i64::MAX);
                let ends = [0, 1, -1, 255, 256, 65_535, 65_536, 1 << 28, 1 << 29, i32::MAX.into(), i32::MIN.into()];
                let mut near = vec![n.wrapping_add(1), n.wrapping_sub(1), n.wrapping_neg()];
                near.extend(ends);
                near.into_iter().map(|n| json!(n)).chain([Value::Null, json!("x")]).collect()
            }
            Value::Bool(is) => vec![json!(!is), json!(2)],
            Value::Array(parts) => {
                let mut more = parts.clone();
                more.extend(parts.first().cloned());
                let fewer = parts.split_first().map_or(vec![], |(_, rest)| rest.to_vec());
                let mut back = parts.clone();
                back.reverse();
                vec![json!([]), json!(more), json!(fewer), json!(back), json!(0)]
            }
            _ => vec![
                Value::Null,
                json!("Free"),
                json!("Fixed"),
                json!("Awake"),
                json!("Asleep"),
                json!("Woken"),
                json!(0),
            ],
        };
        for to in to {
            let mut changed = form.clone();
            *changed.pointer_mut(path).unwrap() = to.clone();
            if to != was {
                found.count(reads(&changed.to_string()));
            }
        }
    }
    found
}

/// Changes a value in both forms. Of the check, only this part is compiled for each type.
fn both<T: Serialize + DeserializeOwned>(value: &T, step: usize, mut used: impl FnMut(T)) {
    let mut take = |read: Result<T, String>| {
        let is_read = read.is_ok();
        match read {
            Ok(value) => {
                // Reading does not change it.
                let written = bytes(&value);
                let again = postcard::from_bytes::<T>(&written).unwrap_or_else(|e| panic!("read once, then {e}"));
                assert_eq!(bytes(&again), written);
                used(value);
            }
            Err(error) => assert!(!error.is_empty()),
        }
        is_read
    };
    let one = every_byte(&bytes(value), step, &mut |changed| {
        take(postcard::from_bytes(changed).map_err(|error| error.to_string()))
    });
    let two = every_place(&to_value(value).unwrap(), step, &mut |changed| {
        take(serde_json::from_str(changed).map_err(|error| error.to_string()))
    });
    assert!(one.refused + one.read > 0 && two.refused > 0, "nothing was changed");
}

fn all<T: Serialize + DeserializeOwned>(values: &[T]) {
    for value in values {
        both(value, 1, |_| {});
    }
}

#[test]
fn parts_of_games() {
    let (aabbs, circles, segments, capsules, turned, polygons) = shapes();
    all(&aabbs);
    all(&circles);
    all(&segments);
    all(&capsules);
    all(&turned);
    all(&polygons);
    all(&solids());
    all(&convex_solids());
    let (events, exceptions) = lists();
    both(&events, 1, |mut it| {
        let _ = it.finish(|_| true);
    });
    both(&exceptions, 1, |it| assert!(it.iter().is_sorted_by(|a, b| a.0 < b.0)));
    let ((particles, link, masses, gravity, carry, energy, quiet, ..), map): (_, TileMap<'_>) = (rope(), room());
    both(&(particles, link, masses, gravity, carry, energy, quiet), 1, |_| {});
    let body = Aabb::new(Vec2::from_ints(30, 50), Vec2::from_ints(38, 60)).unwrap();
    both(&walker(), 1, |it: Walker| {
        let _ = it.walk(&map, &body, Vec2::from_ints(3, 9), None);
    });
    both(&bouncer(), 1, |it: Mover<_>| {
        let _ = it.move_and_slide(&map, &body, Vec2::from_ints(3, 9));
    });
    both(&springs(), 1, |it: Mover<_>| {
        let _ = it.move_and_slide(&map, &body, Vec2::from_ints(3, 9));
    });
    for hero in heroes().into_iter().step_by(30) {
        both(&hero, 1, |mut it: Character| {
            for _ in 0..2 {
                let _ = it.step(&map, Input { run: fx!(1), jump: true, drop: false });
            }
        });
    }
}

/// A scene that is read makes steps, and keeps twice the same what it keeps twice.
fn scenes<B: BroadPhase<Tag = SceneTag> + Copy + Serialize + DeserializeOwned>(near: B) {
    let map = room();
    // Every place with TILESAT_CASES=20.
    let step = (20 / cases(1_usize)).max(1);
    for (seed, frames) in [(3, 26), (5, 400)] {
        both(&scene(near, seed, frames), step, |mut it: Scene<B, BODIES>| {
            check(&it);
            for _ in 0..2 {
                it.step(&map, Vec2::from_raw(0, 6554), |_| {}).unwrap();
                check(&it);
            }
        });
    }
    let snapshot = scene(near, 4, 26).snapshot();
    both(&snapshot, step, |it: Snapshot<B, BODIES>| check(&Scene::from(&it)));
}

#[test]
fn scenes_in_a_list() {
    scenes::<Near>(Near::new());
}

#[test]
fn scenes_in_a_grid() {
    scenes::<Grid>(grid());
}

#[test]
fn scenes_in_a_hash() {
    scenes::<Hash>(hash());
}
