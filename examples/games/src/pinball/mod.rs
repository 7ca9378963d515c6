//! Pinball: the table, and the balls on it.

mod ball;
pub mod table;

pub use ball::{Ball, RADIUS};
