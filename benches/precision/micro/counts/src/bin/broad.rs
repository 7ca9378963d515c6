//! Prints the costs of frames of broad phases. Runs on mps2-an385 and mps2-an386, which have the
//! longer clock.

#![no_std]
#![no_main]

use tilesat_chip::entry;
use tilesat_precision_counts::{Long, Table};
use tilesat_precision_queries::*;

#[cfg(not(large))]
static INPUTS: &[u8] = include_bytes!(concat!(env!("PRECISION_INPUTS"), "/broad.bin"));
#[cfg(large)]
static INPUTS: &[u8] = include_bytes!(concat!(env!("PRECISION_INPUTS"), "/crowds.bin"));

#[entry]
fn main() -> ! {
    let mut table = Table::<Long>::start(INPUTS);
    macro_rules! count {
        ($workload:literal, $backend:literal, $asked:literal, $n:literal, $phase:ty) => {
            for class in table.classes($workload).filter(|c| c.width == 4 * $n) {
                table.broad::<$phase, $n>(($workload, $backend, $asked), &class);
            }
        };
    }
    each_broad!(count 8, 2, 64);
    each_broad!(count 64, 8, 64);
    each_broad!(count 256, 32, 256);
    #[cfg(large)]
    {
        each_broad!(count 1024, 128, 1024);
        each_broad!(count 4096, 512, 4096);
    }
    table.end()
}
