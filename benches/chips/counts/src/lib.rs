//! Shared code of the counting firmwares: the counter, the measurement of a row, its inputs, and
//! the start-up of the core.

//! On a computer the crate is empty.
#![no_std]
#![cfg(target_os = "none")]

pub mod bodies;
pub mod clock;
pub mod counter;
pub mod inputs;
pub mod measure;
pub mod shapes;
pub mod span;
pub mod stack;

/// The core that this firmware is built for.
pub const CORE: &str = env!("CORE");
