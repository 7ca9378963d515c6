//! Levels of tiles: bytes, a table of kinds, and the surface that they have.

pub(in crate::world) mod ascii;
pub(in crate::world) mod block_cells;
pub(in crate::world) mod block_surface;
pub(in crate::world) mod error;
pub(in crate::world) mod features;
pub(in crate::world) mod form;
pub(in crate::world) mod kind;
pub(in crate::world) mod map;
pub(in crate::world) mod occupancy;
pub(in crate::world) mod occupied;
pub(in crate::world) mod outline;
pub(in crate::world) mod overlap;
pub(in crate::world) mod range;
pub(in crate::world) mod region;
pub(in crate::world) mod set;
pub(in crate::world) mod shape;
pub(in crate::world) mod shape_surface;
pub(in crate::world) mod solid;
pub(in crate::world) mod tile_pieces;
pub(in crate::world) mod walk;
