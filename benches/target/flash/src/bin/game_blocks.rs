//! The platformer among blocks as the firmware plays it: a player that plays by itself, 16 boxes and 16 balls, coins, spikes, ladders, a goal.
#![no_std]
#![no_main]
#[path = "../../../../../examples/platformer/flash.rs"]
#[allow(dead_code, reason = "the firmware's own loop and its outcome")]
#[allow(clippy::collapsible_if, reason = "the example is for older compilers as well")]
mod flash;
use flash::{RULES, level, sim};
use tilesat_flash::Later;

tilesat_flash::game!(
    Later<sim::Sim> = Later::NONE,
    map = level(),
    |state| state.begin(sim::Sim::new(&map, RULES, sim::SEED).ok()),
    |sim| sim.step(&map)
);
