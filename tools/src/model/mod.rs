//! Levels as they were drawn, in the one form into which all formats are read. Nothing here knows
//! what is solid.

pub mod decimal;
pub mod flip;
pub mod map;
pub mod object;
pub mod property;
pub mod tileset;
