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
    /// Which piece. Of a tile: 0..=3 the faces on its sides, 4..=7 their vertices, counted from the side toward row 0, turning right,
    /// bottom, left (a vertex follows the face that ends in it); 8 the slope, arc or inner face, 9 its vertex. Of a segment map: twice the
    /// segment's index, plus one for the vertex at its end.
    pub index: u16,
    /// The user flags of the cell's tile.
    pub flags: u8,
    /// Whether it blocks only what comes from entirely in front.
    pub one_way: bool,
    /// Which level of a `Joined` pair it is from: 0 for the first, and for a level alone.
    pub source: u8,
}

/// The shape of a [`Feature`]. Directions are reduced: one slope has one direction.
///
/// Where a vertex ends an arc, its edge is the arc's tangent there. A cusp (the end of a quarter pipe or of a wall) has `e_out == -e_in`.
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
        /// Length in multiples of `dir`, raw; 0 only where a map that ends with the domain goes on beyond it.
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
    /// A quarter of a circle that bounds the solid, ends included.
    ///
    /// ```text
    ///   convex, quadrant (1, -1)      concave, quadrant (1, 1)
    ///       ..._                          centre +         |
    ///       ....`.   solid inside                         ,'   solid
    ///       ......\                                     _.'    outside
    ///  centre +----                              ----''
    /// ```
    Arc {
        /// The centre.
        centre: Vec2,
        /// The radius, raw, above 0.
        radius: i32,
        /// Both components 1 or -1: from the centre toward the arc.
        quadrant: Axis,
        /// Whether the solid is on the centre's side; its normal points away from the centre then, else toward it.
        convex: bool,
    },
}
