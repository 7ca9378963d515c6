//! The compared code. Each module registers its answers in the lists of the workloads.

pub mod box2d;
pub mod chipmunk;
pub mod exact;
pub mod ncollide;
pub mod ours;
pub mod parry;
pub mod textbook;

/// Its character controller, with the queries of parry2d.
pub const RAPIER: &str = "rapier2d";
/// Only a broad phase.
pub const BROCCOLI: &str = "broccoli";
