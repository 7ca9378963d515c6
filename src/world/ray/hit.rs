//! What a ray is asked, and what it answers.

use crate::num::{Axis, Toi, Vec2};
pub use crate::query::Inside;
use crate::world::Cell;

/// What a ray meets. Made from an [`Inside`] alone, it passes one-way edges.
///
/// ```
/// use tilesat::{Inside, RayRules};
/// assert_eq!(RayRules::from(Inside::Hit), RayRules { inside: Inside::Hit, one_way: false });
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RayRules {
    /// What a start inside the solid does.
    pub inside: Inside,
    /// Whether a one-way edge is met by a ray that moves against its normal, ends included and from on it too. From behind it is always passed.
    pub one_way: bool,
}

impl From<Inside> for RayRules {
    fn from(inside: Inside) -> Self {
        Self { inside, one_way: false }
    }
}

/// What a ray met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RayHit {
    /// When: the exact floor in 2^-30 of the fraction of the motion, for straight faces and ends of arcs.
    ///
    /// Within an arc a lower bound, early by less than one raw of way for motions up to 4096 units, and by less than four for any.
    pub toi: Toi,
    /// Where, rounded to the free side of the piece that was hit.
    ///
    /// Of a straight face, each coordinate is less than one raw off: rounded toward the start, or away from it where the normal is
    /// on that side; so along a face's axis it is exact. Of an arc it is that of `toi`, rounded away from the solid.
    pub point: Vec2,
    /// The outward normal of the piece that was hit: reduced, of a block's face a unit axis; within an arc the vector from its centre to `point`,
    /// the other way where it is concave. See [`TileMap::cast_ray`](crate::world::TileMap::cast_ray) for corners and starts inside.
    pub axis: Axis,
    /// The cell that the piece belongs to; where the border is repeated ([`Outside::Edge`](crate::world::Outside::Edge)) and only blocks are, the border
    /// cell. Of a [solid](crate::world::Solids) it holds the key.
    pub cell: Cell,
    /// Which piece of that cell, as [`Feature::index`](crate::world::Feature::index); 0 for a start inside.
    pub index: u16,
    /// The user flags of the tile or segment.
    pub flags: u8,
    /// Whether it is a one-way face.
    pub one_way: bool,
    /// Which level of a pair, as [`Feature::source`](crate::world::Feature::source).
    pub source: u8,
    /// Whether the ray started inside the solid; only with [`Inside::Hit`].
    pub inside: bool,
    /// The work done: cells entered, the first and the last one included; of [`Solids`](crate::world::Solids) the boxes looked at.
    pub cells: u32,
}
