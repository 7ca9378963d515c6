//! Pinball: the table, and the balls on it.

mod ball;
mod flippers;
pub mod table;

pub use ball::{Ball, RADIUS};
pub use flippers::{FLIPPER, Flippers};
