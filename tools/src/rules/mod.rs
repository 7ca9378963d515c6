//! What the names that people give to tiles and objects mean to the library.

pub mod flip;
pub mod identifier;
pub mod kind;
pub mod names;
pub mod traits;
