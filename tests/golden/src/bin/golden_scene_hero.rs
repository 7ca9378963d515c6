//! Golden on a chip: a hero in a scene. One of the parts, each of which fits the flash of a small
//! chip.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg_attr(
    target_os = "none",
    allow(unsafe_code, reason = "entry points of a bare-metal program are unsafe by nature")
)]

use tilesat_golden::{SCENE_HERO, program};

program!(SCENE_HERO);
