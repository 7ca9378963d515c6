//! Prints the costs of whole scenes.

#![no_std]
#![no_main]

mod queries;
mod scene;

use tilesat_chip::entry;
use tilesat_counts::bodies::Bodies;
use tilesat_counts::measure::Table;

/// Most of the memory of the smallest board.
static mut SCENE: Bodies<0> = scene::NONE;

#[entry]
fn main() -> ! {
    let scene = &raw mut SCENE;
    // SAFETY: nothing else names it, and this runs once.
    let scene = unsafe { &mut *scene };
    let mut table = Table::start();
    scene::rows(&mut table, scene);
    scene::snapshots();
    table.end()
}
