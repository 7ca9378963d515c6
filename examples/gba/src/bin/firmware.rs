//! The platformer's bodies on the console, for 600 frames and then 10 000. Prints the same lines as
//! `cargo run --release --example firmware`.
#![no_std]
#![no_main]

use tilesat_games::platformer::{flash, sim};
use tilesat_gba::{entry, println};

entry!(main);

fn main() -> i32 {
    for frames in [sim::FIRMWARE_FRAMES, 10_000] {
        match flash::run(frames, |_, _| {}) {
            Ok(outcome) => println!("{outcome}"),
            Err(failure) => {
                println!("no run: {failure:?}");
                return 1;
            }
        }
    }
    0
}
