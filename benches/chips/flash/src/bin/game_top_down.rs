//! The example's game seen from above: a box that slides along walls and slips around corners.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat_flash::{Later, port};
use tilesat_games::top_down::{Hero, START, rooms};

/// The four directions of a pad.
fn keys() -> (i32, i32) {
    let pad = port();
    let key = |bit: u32| (pad >> bit & 1) as i32;
    (key(0) - key(1), key(2) - key(3))
}

tilesat_flash::game!(
    Later<Hero> = Later::NONE,
    map = rooms(),
    |state| state.begin(Hero::new(START, 4).ok()),
    |hero| hero.step(&map, keys()).is_ok()
);
