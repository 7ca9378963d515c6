//! The platformer among blocks, as in the firmware: an automatic player, 16 boxes and 16 balls,
//! coins, spikes, ladders and a goal.
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
