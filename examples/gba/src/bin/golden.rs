//! The golden hashes on the console: the first thousand vectors of each query, and ten thousand
//! frames of the ninja. Prints the lines of `cargo run --release -p tilesat-golden -- 1000`.
#![no_std]
#![no_main]

use tilesat_gba::{entry, println};
use tilesat_golden::{GROUPS, LEAST, Line, Run};

entry!(main);

fn main() -> i32 {
    let mut tell = |line: &Line| println!("{line}");
    let mut run = Run::new(LEAST, &mut tell);
    for part in GROUPS.iter().copied().flatten() {
        part(&mut run);
    }
    println!("{run}");
    0
}
