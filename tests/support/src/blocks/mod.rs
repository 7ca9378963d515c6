//! A level written down from the definitions, to judge the tile map by: no clamped indices, no
//! walk, no incremental anything.

pub mod ask;
pub mod bodies;
pub mod build;
pub mod level;
pub mod rays;
