//! Golden on a chip: turned boxes that move through all shapes. One of the parts, each of which
//! fits the flash of a small chip.
#![no_std]
#![no_main]
#![allow(unsafe_code, reason = "entry points of a bare-metal program are unsafe by nature")]

use tilesat_chip::entry;
use tilesat_golden::{TURNED, chip};

#[entry]
fn main() -> ! {
    chip::run(TURNED)
}
