//! Shared code of the programs that print the costs of queries on this core. They print a line per
//! workload, class, backend and question, with the mean of all, of hits and of misses.
//!
//! The inputs are the host's. The program calls a query through a pointer with its operands by
//! reference, and stores its answer. It subtracts an empty call of the same kind. A frame of moving
//! bodies or of a broad phase is such a call as well.

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
