//! Prints the costs of queries on levels and of motion in them.

#![no_std]
#![no_main]

mod ask;
mod blocks;
mod frames;
mod friction;
mod level;
mod shapes;

use tilesat_chip::entry;
use tilesat_counts::measure::Table;

#[entry]
fn main() -> ! {
    let mut table = Table::start();
    level::rows(&mut table);
    blocks::rows(&mut table);
    shapes::rows(&mut table);
    frames::rows(&mut table);
    friction::rows(&mut table);
    ask::rows(&mut table);
    table.end()
}
