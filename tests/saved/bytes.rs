//! Randomly changed bytes: an error, or a value that any constructor would accept.

use crate::same::bytes;
use crate::values::{
    Grid, Hash, Near, bouncer, grid, hash, heroes, lists, rope, rubber, scene, shapes, solids, walker,
};
use serde::Serialize;
use serde::de::DeserializeOwned;
use tilesat::broad::{BroadPhase, Exceptions, PairEvents};
use tilesat::scene::SceneTag;
use tilesat::{
    Aabb, Capsule, Character, Circle, ConvexPolygon, Fx, Input, Mover, OrientedBox, Scene, Solid, Surface, TileMap,
    Vec2, Walker,
};
use tilesat_judge::scenes::{BODIES, check, room};
use tilesat_judge::{Random, cases};

/// Changes, removes and adds bytes. Returns how many values were still read.
fn corrupted<T: Serialize + DeserializeOwned>(value: &T, times: u64, mut valid: impl FnMut(T)) -> u64 {
    still_read(&bytes(value), times, &mut |changed| postcard::from_bytes(changed).map(&mut valid).is_ok())
}

/// [`corrupted`], where `reads` is whether changed bytes are read.
fn still_read(written: &[u8], times: u64, reads: &mut dyn FnMut(&[u8]) -> bool) -> u64 {
    let mut read = 0;
    for case in 0..cases(times) {
        let mut random = Random::new(case);
        let mut changed = written.to_vec();
        for _ in 0..=random.below(3) {
            let at = random.below(changed.len().max(1) as i64) as usize;
            match random.below(8) {
                0 => changed.truncate(at),
                1 => changed.insert(at, random.next() as u8),
                2 if at < changed.len() => drop(changed.remove(at)),
                // One more or less is where checks are off by one.
                3 if at < changed.len() => changed[at] = changed[at].wrapping_add(2),
                4 if at < changed.len() => changed[at] ^= 1 << random.below(8),
                _ if at < changed.len() => changed[at] = random.next() as u8,
                _ => {}
            }
        }
        read += u64::from(reads(&changed));
    }
    read
}

#[test]
fn shapes_are_what_constructors_take() {
    let (aabbs, circles, _, capsules, turned, polygons) = shapes();
    let mut read = 0;
    for aabb in aabbs {
        read += corrupted(&aabb, 3000, |it: Aabb| assert_eq!(Aabb::new(it.min(), it.max()), Ok(it)));
    }
    for circle in circles {
        read += corrupted(&circle, 3000, |it: Circle| assert_eq!(Circle::new(it.centre(), it.radius()), Ok(it)));
    }
    for capsule in capsules {
        read += corrupted(&capsule, 3000, |it: Capsule| assert_eq!(Capsule::new(it.a(), it.b(), it.radius()), Ok(it)));
    }
    for polygon in polygons {
        read += corrupted(&polygon, 6000, |it: ConvexPolygon<5>| {
            let again = ConvexPolygon::new(it.vertices()).unwrap().with_radius(it.radius());
            assert_eq!(again, Ok(it));
        });
    }
    for one in turned {
        read += corrupted(&one, 6000, |it: OrientedBox| {
            let (u, v) = (it.along().raw(), it.across().raw());
            let cross = i64::from(u.0) * i64::from(v.1) - i64::from(u.1) * i64::from(v.0);
            assert!(cross > 0 || u == (0, 0) || v == (0, 0), "{it:?}");
            for corner in it.corners() {
                assert!(Circle::new(corner, it.radius()).is_ok(), "{it:?}");
            }
        });
    }
    assert!(read > 5000, "hardly anything is read: {read}");
}

#[test]
fn parts_of_games_never_panic() {
    let mut read = 0;
    for solid in solids() {
        read += corrupted(&solid, 3000, |it: Solid| {
            let again = Solid::new(it.shape(), it.key()).and_then(|again| again.with_conveyor(it.conveyor()));
            assert!(again.and_then(|again| again.with_motion(it.motion())).is_ok());
        });
    }
    let map: TileMap<'_> = room();
    for hero in heroes().into_iter().step_by(10) {
        read += corrupted(&hero, 1000, |mut it: Character| {
            for _ in 0..3 {
                let _ = it.step(&map, Input { run: Fx::ONE, jump: true, drop: false });
            }
        });
    }
    let body = Aabb::new(Vec2::from_ints(30, 50), Vec2::from_ints(38, 60)).unwrap();
    read += corrupted(&walker(), 3000, |it: Walker| {
        let _ = it.walk(&map, &body, Vec2::from_ints(3, 9), None);
    });
    read += corrupted(&bouncer(), 3000, |it: Mover<Surface>| {
        let _ = it.move_and_slide(&map, &body, Vec2::from_ints(3, 9));
    });
    read += corrupted(&rubber(), 3000, |it: Surface| {
        let _ = it.respond(Vec2::from_ints(3, 9), tilesat::Axis::NEG_Y);
    });
    read += corrupted(&rope(), 3000, |(_, link, masses, gravity, carry, ..): crate::values::Rope| {
        let _ = (link.stick.pull(Vec2::ZERO, Vec2::from_ints(1, 1)), masses.share_of_a());
        let _ = gravity.act(Vec2::from_ints(1, 1), carry);
    });
    let (events, exceptions) = lists();
    read += corrupted(&events, 3000, |mut it: PairEvents<8>| {
        assert!(it.pairs().is_sorted());
        let _ = it.finish(|_| true);
    });
    read += corrupted(&exceptions, 3000, |it: Exceptions<4>| assert!(it.iter().is_sorted_by(|a, b| a.0 < b.0)));
    assert!(read > 5000, "hardly anything is read: {read}");
}

/// A scene that was read has equal copies of everything that it keeps twice, and makes steps.
fn scenes<B: BroadPhase<Tag = SceneTag> + Copy + Serialize + DeserializeOwned>(near: B) {
    let map = room();
    let mut read = 0;
    for (seed, frames) in [(1, 1), (3, 26), (5, 400)] {
        read += corrupted(&scene(near, seed, frames), 1500, |mut it: Scene<B, BODIES>| {
            for frame in 0..4 {
                check(&it);
                it.step(&map, Vec2::from_raw(0, 6554), |_| {}).unwrap();
                let some = it.bodies().nth(frame).map(|(handle, body)| (handle, *body));
                if let Some((handle, body)) = some {
                    it.remove(handle).unwrap();
                    let _ = it.insert(&body);
                }
            }
        });
    }
    assert!(read > 100, "hardly anything is read: {read}");
}

#[test]
fn scenes_are_whole() {
    scenes::<Near>(Near::new());
    scenes::<Grid>(grid());
    scenes::<Hash>(hash());
}
