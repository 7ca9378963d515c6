//! Scenes of 64 bodies among all tile shapes, half of them boxes and half circles.

use crate::inputs::{Random, UNIT, circle, vec};
use crate::measure::{Budget, Query, Table, nothing, sample, tell};
use crate::shapes::Map;
use crate::span::Span;
use crate::stack::depth;
use core::mem::MaybeUninit;
use tilesat::broad::SortSweep;
use tilesat::scene::{SceneTag, Shape, Stepped};
use tilesat::{Aabb, Fx, Ratio, Scene, SceneBody, Surface, Vec2};
use tilesat_chip::eprintln;

pub const BODIES: usize = 64;
/// A tenth of a unit per step per step.
pub const GRAVITY: Vec2 = Vec2::from_raw(0, 6554);
/// Steps per row.
const STEPS: u32 = 64;

pub type Bodies<const M: usize> = Scene<SortSweep<BODIES, SceneTag>, BODIES, M>;

/// Bodies of 6 to 24 units, at most 2 units per step fast. None of them is in the solid.
pub fn fill<const M: usize>(scene: &mut Bodies<M>, map: &Map) -> Option<()> {
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

/// Consecutive steps.
pub fn row<const M: usize>(
    table: &Table,
    name: &str,
    budget: Budget,
    scene: &mut Bodies<M>,
    map: &Map,
    expect: impl Fn(&Stepped) -> bool,
) -> Option<()> {
    let step: Query<*mut Bodies<M>, Map, Option<Stepped>> = |scene, map| {
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
