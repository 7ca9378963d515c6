//! Prints the costs of queries on levels of segments and of motion in them. Tiles are in another
//! program: one chip's flash does not hold both.

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
