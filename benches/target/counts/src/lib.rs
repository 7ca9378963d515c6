//! What the counting firmwares share: the counter, the measurement of a row, its inputs, and what the core needs to start.

#![no_std]

pub mod clock;
pub mod counter;
pub mod inputs;
pub mod measure;
pub mod shapes;
pub mod span;
pub mod stack;

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;

/// The core that this firmware is built for.
pub const CORE: &str = env!("CORE");
