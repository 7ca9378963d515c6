//! Golden on a chip, numbers, pairs of shapes, responses: `cargo run --release --example golden_shapes --target thumbv6m-none-eabi [-- VECTORS]`.
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
use chip::golden::SHAPES as PARTS;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("for chips: on a computer `golden` is all of it");
}
