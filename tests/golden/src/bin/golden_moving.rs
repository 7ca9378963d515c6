//! Golden on a chip: levels of boxes that move. One of the parts, each of which fits the flash of
//! a small chip.
#![no_std]
#![no_main]
#![allow(unsafe_code, reason = "entry points of a bare-metal program are unsafe by nature")]

use tilesat_chip::entry;
use tilesat_golden::{MOVING, chip};

#[entry]
fn main() -> ! {
    chip::run(MOVING)
}
