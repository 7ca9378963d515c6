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
//! | what does this ray see? | [`cast_ray`](TileMap::cast_ray) | solids are closed; rays pass one-way edges |
//! | which faces and vertices are near? | [`features`](TileMap::features) | the surface of the solid, and one-way edges |
//!
//! Movers see a level through [`World`] and nothing else.

mod ascii;
mod cell;
mod dda;
mod detour;
mod error;
mod feature;
mod features;
mod fraction;
mod grid;
mod kind;
mod overlap;
mod range;
mod ray;
mod region;
mod set;
mod tile_map;

pub use cell::Cell;
pub use error::TileMapError;
pub use feature::{Feature, Geometry};
pub use features::Features;
pub use grid::Grid;
pub use kind::{TileKind, TileKinds, TileShape};
pub use ray::{Inside, RayHit};
pub use region::{Probe, TileAt, Tiles};
pub use set::{Bits, Blocks, Bytes, Set, Store};
pub use tile_map::{Outside, TileMap};

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
}

impl<S: Set, T: Store> sealed::Sealed for TileMap<'_, S, T> {}

impl<S: Set, T: Store> World for TileMap<'_, S, T> {
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
}
