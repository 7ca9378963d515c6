//! Cycles of the 16.78 MHz clock, by two timers of 16 bits in a row.

use crate::register::{read16, write16};

/// Cycles of one picture: 228 lines of 1232.
pub const FRAME: u32 = 280_896;

const LOW: u32 = 0x0400_0100;
const HIGH: u32 = 0x0400_0104;
const RUN: u16 = 0x80;
/// Counts the other timer's overflows.
const CASCADE: u16 = 0x84;

/// Starts counting at zero.
#[inline(never)]
pub fn start() {
    for timer in [LOW, HIGH] {
        write16(timer + 2, 0);
        write16(timer, 0);
    }
    write16(HIGH + 2, CASCADE);
    write16(LOW + 2, RUN);
}

/// Stops, and returns the cycles since the start, about ten of them its own.
#[inline(never)]
pub fn stop() -> u32 {
    write16(LOW + 2, 0);
    u32::from(read16(HIGH)) << 16 | u32::from(read16(LOW))
}
