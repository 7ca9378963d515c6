//! Two levels as one.

pub(in crate::world) mod hidden;
pub(in crate::world) mod pair;
pub(in crate::world) mod ray;
