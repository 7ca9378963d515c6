//! Whose code is compared. Each module tells the lists of the workloads what it can answer.

pub mod box2d;
pub mod chipmunk;
pub mod exact;
pub mod ncollide;
pub mod ours;
pub mod parry;
pub mod textbook;
