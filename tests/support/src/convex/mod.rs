//! The convex family: capsules, oriented boxes and polygons with each other and with the three
//! plain shapes.
//!
//! The judge is that of [`oracle`](crate::oracle): the sum `A + (-B)` as an explicit hull, and the
//! origin's position in it.

pub mod ask;
pub mod bodies;
pub mod generate;
pub mod shape;
pub mod verify;
