//! Bodies in square cells: of a grid with borders, or of a world without.

mod blocks;
mod error;
mod factor;
mod grid;
mod hash;
mod lattice;
mod lists;
mod near;
mod pairs;
mod path;
#[cfg(test)]
mod tests;

pub use error::GridError;
pub use grid::{Border, LooseGrid};
pub use hash::SpatialHash;
use lattice::{At, Lattice, Run, Window, is_free};
