//! Rows of whole scenes: 64 bodies among all tile shapes, half of them boxes and half circles.
//!
//! A firmware of its own, as that of the solids.

#![no_std]
#![no_main]

#[path = "../counter.rs"]
#[expect(dead_code, reason = "the other firmware tests the counter")]
mod counter;
#[path = "../inputs.rs"]
#[expect(dead_code, reason = "the other firmware's classes of inputs")]
mod inputs;
#[path = "../measure.rs"]
#[expect(dead_code, reason = "what is counted here changes from call to call")]
mod measure;
#[path = "../shapes.rs"]
#[expect(dead_code, reason = "its level is used here")]
mod shapes;
#[path = "../stack.rs"]
mod stack;

use core::mem::MaybeUninit;
use cortex_m_rt::{ExceptionFrame, entry, exception};
use counter::{Counter, elapsed, now};
use inputs::{Random, UNIT, circle, vec};
use measure::{CORE, Query};
use semihosting::{eprintln, println, process};
use shapes::{Map, level};
use tilesat::broad::SortSweep;
use tilesat::scene::{SceneTag, Shape, Sleep, Stepped};
use tilesat::{Aabb, Fx, Ratio, Scene, SceneBody, Surface, Vec2};

const BODIES: usize = 64;
/// A tenth of a unit a step and step.
const GRAVITY: Vec2 = Vec2::from_raw(0, 6554);
/// How many steps a row is.
const STEPS: u32 = 64;

type Bodies = Scene<SortSweep<BODIES, SceneTag>, BODIES>;

#[entry]
fn main() -> ! {
    static mut SCENE: Bodies = Scene::with_sleep(SortSweep::new(), Sleep::NEVER);
    let counter = Counter::start();
    let wrong = level().is_none_or(|map| fill(SCENE, &map).is_none() || rows(&counter, SCENE, &map).is_none());
    process::exit(i32::from(wrong))
}

/// The default handler loops for ever; a fault must end the run.
#[exception]
unsafe fn HardFault(frame: &ExceptionFrame) -> ! {
    eprintln!("hard fault at {:#010x}", frame.pc());
    process::exit(70)
}

/// Bodies of 6 to 24 units, at most 2 units a step fast, none of them in the solid.
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

fn rows(counter: &Counter, scene: &mut Bodies, map: &Map) -> Option<()> {
    row(counter, "64 bodies awake, step", 350_000, scene, map, |s| usize::from(s.moved) == BODIES)?;
    // Until most of them lie on the level or on each other.
    for _ in 0..300 {
        scene.step(map, GRAVITY, |_| {}).ok()?;
    }
    row(counter, "64 bodies awake that lie, step", 0, scene, map, |s| usize::from(s.moved) == BODIES)?;
    scene.sleep = Sleep { still: Fx::ONE, steps: 1 };
    for _ in 0..1000 {
        scene.step(map, GRAVITY, |_| {}).ok()?;
    }
    row(counter, "64 asleep, step", 500, scene, map, |s| *s == Stepped::default())
}

/// Steps that follow each other.
fn row(
    counter: &Counter,
    name: &str,
    budget: u32,
    scene: &mut Bodies,
    map: &Map,
    expect: impl Fn(&Stepped) -> bool,
) -> Option<()> {
    let (mut sum, mut least, mut most) = (0, u32::MAX, 0);
    for _ in 0..STEPS {
        let from = now();
        let stepped = step(scene, map);
        let count = counter.instructions(elapsed(from, now()));
        if !stepped.is_some_and(|stepped| expect(&stepped)) {
            eprintln!("scene: {name}: some steps are not of this class: {stepped:?}");
            return None;
        }
        (sum, least, most) = (sum + count, least.min(count), most.max(count));
    }
    let (mean, tenth) = (sum / STEPS, sum % STEPS * 10 / STEPS);
    let budget = if CORE == "M0" { budget } else { 0 };
    println!("{CORE}|scene: {name}|{mean}.{tenth} ({least}..{most})|{mean}.{tenth} ({least}..{most})|{budget}");
    let deep: Query<*mut Bodies, Map, Option<Stepped>> = |scene, map| {
        // SAFETY: the only reference to the scene while this runs.
        MaybeUninit::new(step(unsafe { &mut **scene }, map))
    };
    let bytes = stack::depth(deep, &core::ptr::from_mut(scene), map);
    println!("{CORE} stack|scene: {name}|{bytes}|{bytes}|0");
    Some(())
}

#[inline(never)]
fn step(scene: &mut Bodies, map: &Map) -> Option<Stepped> {
    scene.step(map, GRAVITY, |_| {}).ok()
}
