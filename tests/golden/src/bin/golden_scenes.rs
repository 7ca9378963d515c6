//! Golden on a chip: scenes of bodies. One of the parts, each of which fits the flash of a small
//! chip.
#![no_std]
#![no_main]
#![allow(unsafe_code, reason = "entry points of a bare-metal program are unsafe by nature")]

use tilesat_chip::entry;
use tilesat_golden::{SCENES, chip};

#[entry]
fn main() -> ! {
    chip::run(SCENES)
}
