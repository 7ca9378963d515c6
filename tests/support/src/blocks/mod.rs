//! A level from the definitions, to judge the tile map: no clamped indices, no walk, nothing
//! incremental.

pub mod ask;
pub mod bodies;
pub mod build;
pub mod level;
pub mod rays;
