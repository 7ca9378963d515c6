//! What `tilesat bake` and `tilesat rooms` write of the levels in `examples/levels`, and of a world in the corpus.

pub(crate) mod quarry;
#[allow(dead_code, reason = "a program needs not all that is known of a world")]
pub(crate) mod quarry_rooms;
pub(crate) mod steps;
#[allow(dead_code, reason = "a program needs not all that is known of a world")]
pub(crate) mod steps_rooms;
pub(crate) mod world;
