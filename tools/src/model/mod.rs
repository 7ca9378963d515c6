//! Levels as drawn, in one form for all formats. Nothing here knows what is solid.

pub mod decimal;
pub mod flip;
pub mod map;
pub mod object;
pub mod property;
pub mod tileset;
