//! Rows of whole scenes: 64 bodies among all tile shapes, half of them boxes and half circles; and
//! balls in a crowded room.

use core::mem::MaybeUninit;
use tilesat::broad::SortSweep;
use tilesat::scene::{SceneTag, Shape, Sleep, Snapshot, Stepped};
use tilesat::{Aabb, Fx, Ratio, Scene, SceneBody, Surface, Vec2};
use tilesat_chip::eprintln;
use tilesat_counts::inputs::{Random, UNIT, circle, vec};
use tilesat_counts::measure::{Budget, Query, Table, nothing, sample, tell};
use tilesat_counts::shapes::{Map, level, on};
use tilesat_counts::span::Span;
use tilesat_counts::stack::depth;

const BODIES: usize = 64;
/// A tenth of a unit per step per step.
const GRAVITY: Vec2 = Vec2::from_raw(0, 6554);
/// Steps per row.
const STEPS: u32 = 64;

pub type Bodies = Scene<SortSweep<BODIES, SceneTag>, BODIES>;

/// The type of the firmware's static.
pub const NONE: Bodies = Scene::with_sleep(SortSweep::new(), Sleep::NEVER);

pub fn rows(table: &mut Table, scene: &mut Bodies) {
    if level().is_none_or(|map| fill(scene, &map).is_none() || steps(table, scene, &map).is_none()) {
        table.wrong += 1;
    }
}

/// Bodies of 6 to 24 units, at most 2 units per step fast. None of them is in the solid.
fn fill(scene: &mut Bodies, map: &Map) -> Option<()> {
    let (mut random, mut key) = (Random::new(5), 0);
    let bouncy = Surface::new(Ratio::HALF, Ratio::percent(20)?).resting_below(Fx::from_bits(UNIT / 2));
    while key < BODIES as u32 {
        let r = &mut random;
        let (x, y, size) = (r.raw(30, 730), r.raw(30, 730), r.raw(6, 24));
        let shape: Shape = if key % 2 == 0 {
            Aabb::new(vec((x, y)), vec((x + size, y + r.raw(6, 24)))).ok()?.into()
        } else {
            circle((x, y), size / 2)?.into()
        };
        if !shape.overlaps_level(map) {
            let velocity = vec((r.raw(-2, 2), r.raw(-2, 2)));
            scene.insert(&SceneBody { velocity, surface: bouncy, ..SceneBody::new(shape, key) }).ok()?;
            key += 1;
        }
    }
    Some(())
}

fn steps(table: &Table, scene: &mut Bodies, map: &Map) -> Option<()> {
    row(table, "64 bodies awake, step", Some((350_000, 0)), scene, map, |s| usize::from(s.moved) == BODIES)?;
    // Until most of them lie on the level or on each other.
    for _ in 0..300 {
        scene.step(map, GRAVITY, |_| {}).ok()?;
    }
    row(table, "64 bodies awake that lie, step", None, scene, map, |s| usize::from(s.moved) == BODIES)?;
    scene.sleep = Sleep { still: Fx::ONE, steps: 1 };
    for _ in 0..1000 {
        scene.step(map, GRAVITY, |_| {}).ok()?;
    }
    row(table, "64 asleep, step", Some((500, 0)), scene, map, |s| *s == Stepped::default())?;
    packed(table, scene)
}

const PACKED: usize = 30;

/// Balls that fill half of a closed room, and never come to rest.
fn packed(table: &Table, scene: &mut Bodies) -> Option<()> {
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
    scene.sleep = Sleep::NEVER;
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

/// Consecutive steps.
fn row(
    table: &Table,
    name: &str,
    budget: Budget,
    scene: &mut Bodies,
    map: &Map,
    expect: impl Fn(&Stepped) -> bool,
) -> Option<()> {
    type Step = Query<*mut Bodies, Map, Option<Stepped>>;
    let step: Step = |scene, map| {
        // SAFETY: the only reference to the scene while this runs.
        MaybeUninit::new(unsafe { &mut **scene }.step(map, GRAVITY, |_| {}).ok())
    };
    let scene = core::ptr::from_mut(scene);
    let mut span = Span::EMPTY;
    for _ in 0..STEPS {
        span.add(sample(&table.counter, step, nothing, &scene, map).1);
    }
    let bytes = depth(step, &scene, map);
    // SAFETY: `step` always writes its answer.
    let last = unsafe { step(&scene, map).assume_init() };
    if !last.is_some_and(|stepped| expect(&stepped)) {
        eprintln!("scene: {name}: the steps are not of this class: {last:?}");
        return None;
    }
    tell("scenes", name, span, budget);
    tell("stack", format_args!("scene: {name}"), bytes, None);
    Some(())
}
