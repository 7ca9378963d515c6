//! Features: the faces and vertices of a level's surface, the only thing that motion ever sees of a level.

use super::Cell;
use crate::num::{Axis, Vec2};

/// One piece of a level's surface, with what its tile says about it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Feature {
    /// Where it is.
    pub geometry: Geometry,
    /// The cell whose solid it bounds.
    pub cell: Cell,
    /// Which piece of that cell: 0..=3 faces, 4..=7 vertices, counted from the side toward row 0, turning right, bottom, left
    /// (a vertex follows the face that ends in it).
    pub index: u8,
    /// The user flags of the cell's tile.
    pub flags: u8,
    /// Whether it blocks only what comes from entirely in front.
    pub one_way: bool,
}

/// The shape of a [`Feature`]. Directions are reduced: one slope has one direction.
///
/// ```text
///             n = (dir.y, -dir.x)            e_in     p
///                    ^                     -------->+   solid wedge: left of both
///      a +-----------+----------> dir      ..solid..|   edges (y up)
///        ....solid on the left....         .........| e_out
///                                          .........v
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Geometry {
    /// A straight one-sided edge from `a` to `a + dir * len`; its outward normal is `(dir.y, -dir.x)`.
    Face {
        /// Start.
        a: Vec2,
        /// Reduced direction.
        dir: Axis,
        /// Length in multiples of `dir`, raw.
        len: i32,
        /// Whether the solid goes on beyond the start and the end (flat or concave joint), so that the end point itself blocks.
        joined: [bool; 2],
    },
    /// A strictly convex corner of the solid.
    Vertex {
        /// The corner.
        p: Vec2,
        /// Direction of the edge that ends here.
        e_in: Axis,
        /// Direction of the edge that starts here.
        e_out: Axis,
    },
}
