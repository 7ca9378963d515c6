//! Prints the costs of queries on pairs and of responses to contacts.

#![no_std]
#![no_main]

mod cast;
mod more_pairs;
mod near;
mod pairs;
mod response;

use tilesat_chip::entry;
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
