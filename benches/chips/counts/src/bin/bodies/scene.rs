//! Rows of whole scenes: 64 bodies among all tile shapes, half of them boxes and half circles; and
//! balls in a crowded room.

use crate::queries;
use core::mem::MaybeUninit;
use tilesat::broad::SortSweep;
use tilesat::scene::{SceneTag, Sleep, Snapshot, Stepped};
use tilesat::{Fx, Ratio, Scene, SceneBody, Surface};
use tilesat_counts::bodies::{BODIES, Bodies, GRAVITY, fill, row};
use tilesat_counts::inputs::{Random, UNIT, circle, vec};
use tilesat_counts::measure::{Query, Table, tell};
use tilesat_counts::shapes::{Map, level, on};
use tilesat_counts::stack::depth;

/// The value of the firmware's static.
pub const NONE: Bodies<0> = Scene::with_sleep(SortSweep::new(), Sleep::NEVER);

pub fn rows(table: &mut Table, scene: &mut Bodies<0>) {
    if level().is_none_or(|map| fill(scene, &map).is_none() || steps(table, scene, &map).is_none()) {
        table.wrong += 1;
    }
}

fn steps(table: &mut Table, scene: &mut Bodies<0>, map: &Map) -> Option<()> {
    row(table, "64 bodies awake, step", Some((350_000, 0)), scene, map, |s| usize::from(s.moved) == BODIES)?;
    queries::rows(table, scene, map);
    // Until most of them lie on the level or on each other.
    for _ in 0..300 {
        scene.step(map, GRAVITY, |_| {}).ok()?;
    }
    row(table, "64 bodies awake that lie, step", None, scene, map, |s| usize::from(s.moved) == BODIES)?;
    scene.set_sleep(Sleep { still: Fx::ONE, steps: 1 });
    for _ in 0..1000 {
        scene.step(map, GRAVITY, |_| {}).ok()?;
    }
    row(table, "64 asleep, step", Some((500, 0)), scene, map, |s| *s == Stepped::default())?;
    packed(table, scene)
}

const PACKED: usize = 30;

/// Balls that fill half of a closed room, and never come to rest.
fn packed(table: &Table, scene: &mut Bodies<0>) -> Option<()> {
    static ROOM: [u8; 48] = {
        let (mut tiles, mut i) = ([0; 48], 0);
        while i < 48 {
            tiles[i] = (i % 8 == 0 || i % 8 == 7 || i / 8 == 0 || i / 8 == 5) as u8;
            i += 1;
        }
        tiles
    };
    loop {
        let first = scene.bodies().next().map(|(handle, _)| handle);
        let Some(handle) = first else { break };
        scene.remove(handle).ok()?;
    }
    scene.set_sleep(Sleep::NEVER);
    let (map, mut random) = (on(&ROOM, 8, 6)?, Random::new(5));
    let bouncy = Surface::new(Ratio::percent(95)?, Ratio::ZERO);
    for key in 0..PACKED as i32 {
        let r = &mut random;
        let at = ((36 + key % 6 * 24) * UNIT, (34 + key / 6 * 19) * UNIT);
        let velocity = vec((r.raw(-3, 3), r.raw(-3, 3)));
        let ball = SceneBody::new(circle(at, 8 * UNIT)?, key as u32);
        scene.insert(&SceneBody { velocity, surface: bouncy, ..ball }).ok()?;
    }
    for _ in 0..30 {
        scene.step(&map, GRAVITY, |_| {}).ok()?;
    }
    row(table, "30 balls packed and bouncing, step", None, scene, &map, |s| usize::from(s.moved) == PACKED)
}

/// Stack of a snapshot of sixteen slots, which is 1984 bytes large.
pub fn snapshots() {
    type Near = SortSweep<16, SceneTag>;
    type Pair = (Scene<Near, 16>, Snapshot<Near, 16>);
    let mut pair: Pair = (Scene::new(SortSweep::new()), Snapshot::new(SortSweep::new()));
    // SAFETY: the only reference to the pair while either runs.
    let returned: Query<*mut Pair, (), ()> = |pair, ()| unsafe {
        let (scene, snapshot) = &mut **pair;
        *snapshot = scene.snapshot();
        MaybeUninit::new(())
    };
    // SAFETY: as above.
    let written: Query<*mut Pair, (), ()> = |pair, ()| unsafe {
        let (scene, snapshot) = &mut **pair;
        scene.snapshot_into(snapshot);
        MaybeUninit::new(())
    };
    const _: () = assert!(size_of::<Snapshot<Near, 16>>() == 1984);
    let pair = &raw mut pair;
    tell("stack", "a snapshot of 16 bodies, returned", depth(returned, &pair, &()), None);
    tell("stack", "a snapshot of 16 bodies, written in place", depth(written, &pair, &()), None);
}
