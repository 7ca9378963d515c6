//! The ninja of the example, one circle that runs, slides and jumps among all tile shapes, with a pad.
#![no_std]
#![no_main]
#[path = "../../../../../examples/ninja/level.rs"]
#[allow(dead_code, reason = "the desktop draws it")]
mod level;
#[path = "../../../../../examples/ninja/ninja.rs"]
mod ninja;
use ninja::{Keys, Ninja};
use tilesat_flash::{Later, port};

/// A pad's left, right and jump.
fn keys() -> Keys {
    let pad = port();
    Keys { run: (pad & 1) as i32 - (pad >> 1 & 1) as i32, jump: pad & 4 != 0 }
}

tilesat_flash::game!(
    Later<Ninja> = Later::NONE,
    map = level::map(),
    |state| state.begin(Ninja::new(level::START).ok()),
    |ninja| ninja.step(&map, keys()).is_ok()
);
