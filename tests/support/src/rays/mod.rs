//! Rays against levels of every shape, from the definitions: independent tables, exact numbers of
//! any size, no walk.

pub mod cast;
pub mod check;
pub mod generate;
pub mod level;
pub mod moment;
pub mod solid;
