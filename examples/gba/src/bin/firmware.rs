//! The platformer's bodies for 600 frames on the console: the same line as `cargo run --release --example firmware`.
#![no_std]
#![no_main]

#[path = "../../../platformer/flash.rs"]
mod flash;

use tilesat_gba::{entry, println};

entry!(main);

fn main() -> i32 {
    match flash::run(|_, _| {}) {
        Ok(outcome) => {
            println!("{outcome}");
            0
        }
        Err(failure) => {
            println!("no run: {failure:?}");
            1
        }
    }
}
