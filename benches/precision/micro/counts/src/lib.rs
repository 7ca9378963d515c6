//! What the programs share that print what queries cost on this core: a line a workload, class,
//! backend and question, with the mean of all, of hits and of misses.
//!
//! The inputs are the host's. A query is called through a pointer with its operands by reference
//! and stores its answer; an empty call of the same kind is taken off. A frame of bodies that move,
//! or of a broad phase, is such a call as well.

//!
//! On a computer the crate is empty.
#![no_std]
#![cfg(target_os = "none")]

mod frames;
mod inputs;
mod table;

pub use frames::room;
pub use table::{Query, Table};
pub use tilesat_counts::clock::{Long, Short};
