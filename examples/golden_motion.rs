//! Golden on a chip, motion through all shapes, and the ninja: `cargo run --release --example golden_motion --target thumbv6m-none-eabi [-- VECTORS]`.
//!
//! One of eight parts of `golden.rs`, which says what it is about; each fits the flash of a small chip.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg_attr(
    target_os = "none",
    allow(unsafe_code, reason = "entry points of a bare-metal program are unsafe by nature")
)]

#[cfg(target_os = "none")]
#[path = "golden/chip.rs"]
mod chip;
#[cfg(target_os = "none")]
use chip::golden::MOTION as PARTS;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("for chips: on a computer `golden` is all of it");
}
