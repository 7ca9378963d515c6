//! The platformer among blocks as the firmware plays it: a player that plays by itself, 16 boxes
//! and 16 balls, coins, spikes, ladders, a goal.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat_flash::Later;
use tilesat_games::platformer::flash::{RULES, level};
use tilesat_games::platformer::sim;

tilesat_flash::game!(
    Later<sim::Sim> = Later::NONE,
    map = level(),
    |state| state.begin(sim::Sim::new(&map, RULES, sim::SEED).ok()),
    |sim| sim.step(&map)
);
