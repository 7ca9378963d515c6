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
//! | what does this box or circle run into? | [`cast_shape`](TileMap::cast_shape) | where the motion would start to overlap; exact |
//! | what does this ray see? | [`cast_ray`](TileMap::cast_ray), [`cast_ray_all`](TileMap::cast_ray_all) | solids are closed; one-way edges by an option |
//! | does this point see that one? | [`line_of_sight`](TileMap::line_of_sight) | solids are closed |
//! | what of the surface does this body overlap, how deep, which way out? | [`contacts`](TileMap::contacts) | nearest first, each once |
//! | what is the nearest point of the surface? | [`closest_point`](TileMap::closest_point) | exact order; inside or outside |
//! | which faces, arcs and vertices are near? | [`features`](TileMap::features) | the surface of the solid, and one-way edges |
//!
//! A [`SegmentMap`] reads a level of free line segments, polygons and chains, from bytes too, and answers the same questions, but for the
//! tiles. A [`Joined`] pair of levels, of either kind, is one level without a seam. Platforms and doors that move are [`Solids`], joined to a level; a level that moves is
//! [`Placed`]. Rays see these too, and [`Solids::key_of`] tells whom they met.
//!
//! Movers see a level through [`World`] and nothing else.

mod cell;
mod feature;
mod grid;
mod joined;
mod near;
mod placed;
mod placed_ray;
mod ray;
mod segment_map;
mod shells;
mod solids;
mod tile_map;
mod way;

pub use cell::Cell;
pub use feature::{Feature, Geometry};
pub use grid::Grid;
pub use joined::pair::{Joined, JoinedFeatures};
pub use joined::ray::JoinedRayHits;
#[cfg(feature = "defmt")]
pub(crate) use joined::ray::RayWorld;
pub use near::closest::{Near, OneWay};
pub(crate) use near::contacts::contacts as contacts_of;
pub use near::contacts::{Pushable, WorldContact};
pub use placed::{Placed, PlacedFeatures};
pub use placed_ray::PlacedRayHits;
pub use ray::hit::{Inside, RayHit, RayRules};
pub use ray::sight::RayHits;
pub use segment_map::{
    Path, PathKind, SegmentFault, SegmentFeatures, SegmentMap, SegmentMapError, SegmentRayHits, Size,
};
pub use solids::features::SolidFeatures;
pub use solids::list::Solids;
pub use solids::ray::SolidRayHits;
pub use solids::solid::{Side, Solid};
pub use tile_map::error::TileMapError;
pub use tile_map::features::Features;
pub use tile_map::kind::{TileKind, TileKinds};
pub use tile_map::map::{Outside, TileMap};
pub use tile_map::region::{Probe, TileAt, Tiles};
pub use tile_map::set::{AllShapes, Bits, Blocks, Bytes, Set, Slopes, Store};
pub use tile_map::shape::TileShape;

use crate::shape::{Aabb, Circle};
pub(crate) use tile_map::block_cells::{Block, Cells};
pub(crate) use way::Way;

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

    /// Whether there may be faces of other directions than tiles have.
    #[doc(hidden)]
    const WIDE: bool = false;

    /// The cursor of [`features`](Self::features).
    type Features<'w>: Iterator<Item = Feature>
    where
        Self: 'w;

    /// Every face and vertex of the surface that has a point in the closed region, in an order that depends on the level only.
    ///
    /// Pieces near the region may come too.
    fn features(&self, region: &Aabb) -> Self::Features<'_>;

    /// Those of the features that a piece of a motion could run into and the piece before could not: not less, but more may come.
    #[doc(hidden)]
    fn features_ahead(&self, way: &Way) -> Self::Features<'_> {
        self.features(way.piece)
    }

    /// Whether the surface and the overlap tests are two views of one solid wherever a body can be, so that the end of a motion that meets nothing
    /// needs no test.
    #[doc(hidden)]
    const CERTAIN: bool = Self::BLOCKS;

    /// Whether the level is a grid of blocks and nothing else: then its surface is known from [`cells`](Self::cells) too.
    #[doc(hidden)]
    const GRID: bool = false;

    /// A walk over the cells of a grid that hold something and whose inside meets a region, row after row.
    #[doc(hidden)]
    fn cells(&self, region: &Aabb) -> Cells {
        let _ = region;
        Cells::NONE
    }

    #[doc(hidden)]
    fn next_cell(&self, cells: &mut Cells) -> Option<Block> {
        let _ = cells;
        None
    }

    /// Whether a cell of a grid is full.
    #[doc(hidden)]
    fn is_full(&self, x: i32, y: i32) -> bool {
        let _ = (x, y);
        false
    }

    /// The face of a one-way cell of a grid, if nothing covers it.
    #[doc(hidden)]
    fn one_way_face(&self, block: &Block) -> Option<Feature> {
        let _ = block;
        None
    }

    /// A box that holds whatever of the level is in a region with area: nothing that a body in the region could meet or overlap with its inside is
    /// outside of the box, one-way faces included. `None` where there is nothing at all.
    #[doc(hidden)]
    fn occupied(&self, region: &Aabb) -> Option<Aabb> {
        Some(*region)
    }

    /// The same with the cells that the box is around, where a level of cells knows them.
    #[doc(hidden)]
    fn occupied_cells(&self, region: &Aabb) -> (Option<Aabb>, Option<Cells>) {
        (self.occupied(region), None)
    }

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
    const GRID: bool = !S::SHAPED;
    const CERTAIN: bool = true;

    type Features<'w>
        = Features<'w, S, T>
    where
        Self: 'w;

    #[inline]
    fn features(&self, region: &Aabb) -> Features<'_, S, T> {
        TileMap::features(self, region)
    }

    #[inline]
    fn features_ahead(&self, way: &Way) -> Features<'_, S, T> {
        TileMap::features_ahead(self, way)
    }

    #[inline]
    fn cells(&self, region: &Aabb) -> Cells {
        TileMap::cells(self, region)
    }

    fn next_cell(&self, cells: &mut Cells) -> Option<Block> {
        TileMap::next_cell(self, cells)
    }

    #[inline]
    fn is_full(&self, x: i32, y: i32) -> bool {
        self.full(x, y)
    }

    #[inline]
    fn one_way_face(&self, block: &Block) -> Option<Feature> {
        TileMap::one_way_face(self, block)
    }

    fn occupied(&self, region: &Aabb) -> Option<Aabb> {
        TileMap::occupied(self, region)
    }

    #[inline]
    fn occupied_cells(&self, region: &Aabb) -> (Option<Aabb>, Option<Cells>) {
        TileMap::occupied_cells(self, region)
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
