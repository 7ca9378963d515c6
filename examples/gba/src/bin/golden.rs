//! The golden hashes on the console: the first thousand vectors of each query, and ten thousand frames of the ninja; the lines of
//! `cargo run --release --example golden -- 1000`.
#![no_std]
#![no_main]

#[path = "../../../golden/mod.rs"]
mod golden;

use golden::{GROUPS, Line, Run};
use tilesat_gba::{entry, println};

entry!(main);

fn main() -> i32 {
    let mut tell = |line: &Line| println!("{line}");
    let mut run = Run::new(1000, &mut tell);
    for part in GROUPS.iter().copied().flatten() {
        part(&mut run);
    }
    println!("{run}");
    0
}
