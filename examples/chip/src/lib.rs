//! The parts that every firmware here needs on an emulated board: start-up, output, faults that end
//! the run, and the command line.
//!
//! On a computer the crate is empty.
#![no_std]
#![cfg(target_os = "none")]
#![allow(unsafe_code, reason = "handlers of faults and the logger of a bare-metal program are unsafe by nature")]

mod fault;
#[cfg(feature = "defmt")]
mod frames;
#[cfg(target_arch = "arm")]
pub mod stack;

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;
pub use semihosting::{eprintln, println, process};

/// The last number on the command line, if there is one.
#[must_use]
pub fn number() -> Option<u32> {
    let words = semihosting::experimental::env::args::<64>().ok()?;
    (&words).into_iter().filter_map(|word| word.ok()?.parse().ok()).last()
}
