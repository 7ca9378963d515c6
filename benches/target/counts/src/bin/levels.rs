//! Prints what queries on levels and motion in them cost.

#![no_std]
#![no_main]

#[path = "../rows/ask.rs"]
mod ask;
#[path = "../rows/blocks.rs"]
mod blocks;
#[path = "../../../../../examples/chip/fault.rs"]
mod fault;
#[path = "../rows/frames.rs"]
mod frames;
#[path = "../rows/friction.rs"]
mod friction;
#[path = "../rows/level.rs"]
mod level;
#[path = "../rows/segments.rs"]
mod segments;
#[path = "../rows/shapes.rs"]
mod shapes;

use tilesat_counts::entry;
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
    segments::rows(&mut table);
    table.end()
}
