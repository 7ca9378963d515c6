//! Levels: what is solid, what it is made of, and what a ray or a body meets there.
//!
//! A [`TileMap`] reads a level from the bytes that it is stored as, usually in flash. It answers:
//!
//! | question | call | counts |
//! |---|---|---|
//! | does this box or circle overlap the solid? | [`overlaps`](TileMap::overlaps) | strict, exact |
//! | ... or touch it? | [`touches`](TileMap::touches) | closed, exact |
//! | which tiles are here? | [`tiles_in`](TileMap::tiles_in) | strict; every tile of the map, solid or not |
//! | which flags does this shape touch? | [`flags_touched`](TileMap::flags_touched) | closed; every tile of the map, solid or not |
//! | what does this ray see? | [`cast_ray`](TileMap::cast_ray), [`cast_ray_all`](TileMap::cast_ray_all) | solids are closed; one-way edges by an option |
//! | does this point see that one? | [`line_of_sight`](TileMap::line_of_sight) | solids are closed |
//! | what of the surface does this body overlap, how deep, which way out? | [`contacts`](TileMap::contacts) | nearest first, each once |
//! | what is the nearest point of the surface? | [`closest_point`](TileMap::closest_point) | exact order; inside or outside |
//! | which faces, arcs and vertices are near? | [`features`](TileMap::features) | the surface of the solid, and one-way edges |
//!
//! A [`SegmentMap`] reads a level of free line segments, polygons and chains, from bytes too, and answers the same questions, but for the
//! tiles. A [`Joined`] pair of levels, of either kind, is one level without a seam.
//!
//! Movers see a level through [`World`] and nothing else.

mod cell;
mod feature;
mod grid;
mod joined;
mod near;
mod ray;
mod segment_map;
mod tile_map;

pub use cell::Cell;
pub use feature::{Feature, Geometry};
pub use grid::Grid;
pub use joined::pair::{Joined, JoinedFeatures};
pub use joined::ray::JoinedRayHits;
pub use near::closest::{Near, OneWay};
pub use near::contacts::{Pushable, WorldContact};
pub use ray::hit::{Inside, RayHit, RayRules};
pub use ray::sight::RayHits;
pub use segment_map::{
    Path, PathKind, SegmentFault, SegmentFeatures, SegmentMap, SegmentMapError, SegmentRayHits, Size,
};
pub use tile_map::error::TileMapError;
pub use tile_map::features::Features;
pub use tile_map::kind::{TileKind, TileKinds};
pub use tile_map::map::{Outside, TileMap};
pub use tile_map::region::{Probe, TileAt, Tiles};
pub use tile_map::set::{AllShapes, Bits, Blocks, Bytes, Set, Slopes, Store};
pub use tile_map::shape::TileShape;

use crate::shape::{Aabb, Circle};

pub(crate) mod sealed {
    //! Only this crate implements the traits that its exactness argument rests on.

    /// A supertrait that nobody outside can implement.
    pub trait Sealed {}
}

/// What a [mover](crate::motion::Mover) needs of a level: its surface near a box, and two exact overlap tests.
///
/// Sealed: that a mover never ends in the solid rests on `features` and the tests being two views of one set of points.
pub trait World: sealed::Sealed {
    /// Whether all faces are along x or y and all corners a block's: then a mover links no code for others.
    #[doc(hidden)]
    const BLOCKS: bool;

    /// Whether there may be arcs.
    #[doc(hidden)]
    const ROUND: bool;

    /// The cursor of [`features`](Self::features).
    type Features<'w>: Iterator<Item = Feature>
    where
        Self: 'w;

    /// Every face and vertex of the surface that has a point in the closed region, in an order that depends on the level only.
    ///
    /// Pieces near the region may come too.
    fn features(&self, region: &Aabb) -> Self::Features<'_>;

    /// The side of a cell, raw and not zero: longer motions are enumerated in pieces of about this length.
    fn cell_size(&self) -> u32;

    /// Whether a box overlaps the solid; strict and exact.
    fn overlaps_aabb(&self, b: &Aabb) -> bool;

    /// Whether a circle overlaps the solid; strict and exact.
    fn overlaps_circle(&self, c: &Circle) -> bool;

    /// Whether a box has a point in common with the solid, borders included; exact.
    fn touches_aabb(&self, b: &Aabb) -> bool;

    /// Whether a circle has a point in common with the solid, borders included; exact.
    fn touches_circle(&self, c: &Circle) -> bool;
}

impl<S: Set, T: Store> sealed::Sealed for TileMap<'_, S, T> {}

impl<S: Set, T: Store> World for TileMap<'_, S, T> {
    const BLOCKS: bool = !S::SHAPED;
    const ROUND: bool = S::ARCS;

    type Features<'w>
        = Features<'w, S, T>
    where
        Self: 'w;

    #[inline]
    fn features(&self, region: &Aabb) -> Features<'_, S, T> {
        TileMap::features(self, region)
    }

    #[inline]
    fn cell_size(&self) -> u32 {
        self.grid.cell as u32
    }

    #[inline]
    fn overlaps_aabb(&self, b: &Aabb) -> bool {
        TileMap::overlaps(self, b)
    }

    #[inline]
    fn overlaps_circle(&self, c: &Circle) -> bool {
        TileMap::overlaps(self, c)
    }

    #[inline]
    fn touches_aabb(&self, b: &Aabb) -> bool {
        TileMap::touches(self, b)
    }

    #[inline]
    fn touches_circle(&self, c: &Circle) -> bool {
        TileMap::touches(self, c)
    }
}
