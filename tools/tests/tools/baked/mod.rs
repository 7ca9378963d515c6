//! What `tilesat bake` writes of the levels in `examples/levels`, and of a world in the corpus.

pub(crate) mod quarry;
pub(crate) mod steps;
pub(crate) mod world;
