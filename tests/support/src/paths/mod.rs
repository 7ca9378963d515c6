//! Levels of line segments and their conditions, from the definitions: all pairs, no walks, no
//! tables.

pub mod generate;
pub mod level;
pub mod oracle;
pub mod vertices;
