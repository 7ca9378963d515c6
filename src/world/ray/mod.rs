//! Rays against any level.

pub(in crate::world) mod arc;
pub(in crate::world) mod cast;
pub(in crate::world) mod cusp;
pub(in crate::world) mod dda;
pub(in crate::world) mod detour;
pub(in crate::world) mod germ;
pub(in crate::world) mod hit;
pub(in crate::world) mod level;
pub(in crate::world) mod line;
pub(in crate::world) mod piece;
pub(in crate::world) mod scan;
pub(in crate::world) mod sight;
pub(in crate::world) mod walk;
