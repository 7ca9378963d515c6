//! What the programs share that print what queries cost on this core: a line a workload, class, backend and question, with the mean of all,
//! of hits and of misses.
//!
//! The inputs are the host's. A query is called through a pointer with its operands by reference and stores its answer; an
//! empty call of the same kind is taken off. A frame of bodies that move, or of a broad phase, is such a call as well.

#![no_std]

#[path = "../../../../target/counts/src/clock.rs"]
mod clock;
#[path = "../../../../target/counts/src/counter.rs"]
#[allow(dead_code, reason = "those who model cycles use more of it")]
mod counter;
#[path = "../../../../../examples/chip/fault.rs"]
mod fault;
mod frames;
mod inputs;
mod table;

pub use clock::{Long, Short};
pub use frames::room;
pub use table::{Query, Table};
