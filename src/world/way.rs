//! What a motion asks a level for.

use crate::num::Raw;
use crate::shape::Aabb;
use crate::world::Cells;

/// A piece of the motion of a body.
///
/// Public in a private module, because a sealed trait's method takes it.
#[derive(Clone, Copy, Debug)]
pub struct Way<'a> {
    /// Holds whatever of the level the inside of the body's bounds meets in this piece.
    pub(crate) piece: &'a Aabb,
    /// The cells that the inside of the piece meets, where they are known.
    pub(crate) cells: Option<Cells>,
    /// What they cover in the piece before.
    pub(crate) before: Option<&'a Aabb>,
    /// What they cover in the whole motion, a raw unit larger on every side.
    pub(crate) whole: Aabb,
    /// The whole motion, not zero.
    pub(crate) d: Raw,
    /// Whether it matters to the body how faces are joined: to one with corners, or without area.
    pub(crate) joints: bool,
}
