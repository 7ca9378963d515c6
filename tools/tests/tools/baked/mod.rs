//! What `tilesat bake` writes of the levels in `examples/levels`.

pub(crate) mod quarry;
pub(crate) mod steps;
