//! Prints what queries on pairs and answers to contacts cost.

#![no_std]
#![no_main]

#[path = "../rows/cast.rs"]
mod cast;
#[path = "../../../../../examples/chip/fault.rs"]
mod fault;
#[path = "../rows/more_pairs.rs"]
mod more_pairs;
#[path = "../rows/near.rs"]
mod near;
#[path = "../rows/pairs.rs"]
mod pairs;
#[path = "../rows/response.rs"]
mod response;

use tilesat_counts::entry;
use tilesat_counts::measure::Table;

#[entry]
fn main() -> ! {
    let mut table = Table::start();
    pairs::rows(&mut table);
    cast::rows(&mut table);
    response::rows(&mut table);
    more_pairs::rows(&mut table);
    near::rows(&mut table);
    table.end()
}
