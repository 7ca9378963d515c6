//! Prints the costs of a scene that remembers how bodies lie.

#![no_std]
#![no_main]

use tilesat::Scene;
use tilesat::broad::SortSweep;
use tilesat::scene::Sleep;
use tilesat_chip::entry;
use tilesat_counts::bodies::{BODIES, Bodies, GRAVITY, fill, row};
use tilesat_counts::measure::Table;
use tilesat_counts::shapes::level;

/// All bodies, and 16 ways of those that never rest.
const PLACES: usize = BODIES + 16;

// The bytes per place that the page of `Scene::remembering` gives.
const _: () = assert!(size_of::<Bodies<64>>() - size_of::<Bodies<0>>() == 64 * 124);

static mut SCENE: Bodies<PLACES> = Scene::remembering(SortSweep::new(), Sleep::NEVER);

#[entry]
fn main() -> ! {
    let scene = &raw mut SCENE;
    // SAFETY: nothing else names it, and this runs once.
    let scene = unsafe { &mut *scene };
    let mut table = Table::start();
    table.wrong += u32::from(rows(&table, scene).is_none());
    table.end()
}

/// Once those that roll and slide have come to rest. A ball and the box that it leans on never do:
/// they repeat 22 steps with a motion each, which is more than the places hold.
fn rows(table: &Table, scene: &mut Bodies<PLACES>) -> Option<()> {
    let map = level()?;
    fill(scene, &map)?;
    for _ in 0..2000 {
        scene.step(&map, GRAVITY, |_| {}).ok()?;
    }
    row(table, "64 bodies awake that lie, remembered, step", Some((110_000, 0)), scene, &map, |stepped| {
        usize::from(stepped.moved) == BODIES
    })
}
