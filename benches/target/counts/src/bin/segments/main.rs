//! Prints what queries on levels of segments and motion in them cost: apart from the tiles, for one
//! chip's flash is too small for both.

#![no_std]
#![no_main]

mod rows;

use tilesat_chip::entry;
use tilesat_counts::measure::Table;

#[entry]
fn main() -> ! {
    let mut table = Table::start();
    rows::rows(&mut table);
    table.end()
}
