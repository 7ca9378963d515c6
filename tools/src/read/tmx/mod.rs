//! Maps of Tiled: tile layers by the crate `tiled`, behind a guard; object layers by a reader of our own, whose numbers are exact.

mod guard;
mod object;
mod objects;
mod tiles;
mod unpack;
mod xml;

pub(crate) use objects::read as objects;
pub use tiles::load;
