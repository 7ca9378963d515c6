//! The example's ninja: one circle that runs, slides and jumps among all tile shapes, with a pad.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat_flash::{Later, port};
use tilesat_games::ninja::{Keys, Ninja, level};

/// Left, right and jump of a pad.
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
