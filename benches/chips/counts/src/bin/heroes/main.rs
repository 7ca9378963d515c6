//! Prints what a hero costs: single frames of a platformer, played by random keys.

#![no_std]
#![no_main]

mod play;

use tilesat::{Blocks, Slopes};
use tilesat_chip::entry;
use tilesat_counts::measure::Table;

#[entry]
fn main() -> ! {
    let mut table = Table::start();
    let counter = &table.counter;
    let rows = [
        play::row::<Blocks, false>(counter, "a hero among blocks"),
        play::row::<Slopes, false>(counter, "a hero among slopes"),
        play::row::<Blocks, true>(counter, "a hero among blocks with a lift"),
        play::row::<Slopes, true>(counter, "a hero among slopes with a lift"),
    ];
    table.wrong += rows.iter().filter(|row| row.is_none()).count() as u32;
    table.end()
}
