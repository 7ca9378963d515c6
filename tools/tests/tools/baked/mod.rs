//! The output of `tilesat bake` and `tilesat rooms` for the levels in `examples/levels`, and for a
//! world in the corpus.

pub(crate) mod quarry;
pub(crate) mod quarry_rooms;
pub(crate) mod steps;
pub(crate) mod steps_rooms;
pub(crate) mod world;
