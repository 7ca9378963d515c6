//! What `tilesat bake` and `tilesat rooms` write of the levels in `examples/levels`, and of a world
//! in the corpus.

pub(crate) mod quarry;
pub(crate) mod quarry_rooms;
pub(crate) mod steps;
pub(crate) mod steps_rooms;
pub(crate) mod world;
