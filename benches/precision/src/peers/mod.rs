//! Whose code is compared. Each module tells the lists of the workloads what it can answer.

pub mod box2d;
pub mod chipmunk;
pub mod exact;
pub mod ncollide;
pub mod ours;
pub mod parry;
pub mod textbook;

/// Its character controller, over the queries of parry2d.
pub const RAPIER: &str = "rapier2d";
/// A broad phase and nothing else.
pub const BROCCOLI: &str = "broccoli";
