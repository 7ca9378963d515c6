//! Markers in a map's type: which shapes it can hold, and how its tile ids are stored.

use super::block_surface::BlockSurface;
use super::features::Surface;
use super::shape_surface::ShapeSurface;
use crate::world::TileShape;
use crate::world::sealed::Sealed;
use core::fmt::Debug;

/// Which shapes a [`TileMap`](crate::world::TileMap) can hold, so that a level of blocks links no code for anything else.
///
/// Sealed; the markers are types such as [`Blocks`]. A table that names another shape is refused by the constructors.
pub trait Set: Sealed + Copy + Debug + Eq + 'static {
    /// One bit for each discriminant of [`TileShape`] that is allowed.
    const SHAPES: u64;

    /// Whether there are shapes besides blocks and one-way tiles.
    #[doc(hidden)]
    const SHAPED: bool = Self::SHAPES & bits(TileShape::HalfTop, TileShape::SteepHighBottomLeft) != 0;

    /// Whether there are arcs.
    #[doc(hidden)]
    const ARCS: bool = Self::SHAPES & bits(TileShape::ConvexTopLeft, TileShape::ConcaveBottomLeft) != 0;

    /// How a map's surface is derived from such tiles.
    #[doc(hidden)]
    type Surface: Surface;
}

/// The bits of the shapes `from..=to`.
const fn bits(from: TileShape, to: TileShape) -> u64 {
    (2 << to as u64) - (1 << from as u64)
}

/// Empty, full and one-way tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Blocks;

impl Sealed for Blocks {}
impl Set for Blocks {
    const SHAPES: u64 = bits(TileShape::Empty, TileShape::Full) | bits(TileShape::OneWayUp, TileShape::OneWayLeft);
    type Surface = BlockSurface;
}

/// [`Blocks`], half tiles and straight slopes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Slopes;

impl Sealed for Slopes {}
impl Set for Slopes {
    const SHAPES: u64 = AllShapes::SHAPES & !bits(TileShape::ConvexTopLeft, TileShape::ConcaveBottomLeft);
    type Surface = ShapeSurface<false>;
}

/// Every [`TileShape`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AllShapes;

impl Sealed for AllShapes {}
impl Set for AllShapes {
    const SHAPES: u64 = bits(TileShape::Empty, TileShape::OneWayLeft);
    type Surface = ShapeSurface<true>;
}

/// How a [`TileMap`](crate::world::TileMap) stores its tile ids.
///
/// Sealed; the markers are [`Bytes`] and [`Bits`].
pub trait Store: Sealed + Copy + Debug + Eq + 'static {
    /// Bits of one tile: 8 or 1.
    const BITS: u32;
}

/// One byte a tile: 256 ids.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bytes;

impl Sealed for Bytes {}
impl Store for Bytes {
    const BITS: u32 = 8;
}

/// One bit a tile, the least significant bit of a byte first: ids 0 and 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bits;

impl Sealed for Bits {}
impl Store for Bits {
    const BITS: u32 = 1;
}

#[cfg(test)]
#[allow(clippy::unreachable, reason = "a test")]
mod tests {
    use super::{Bits, BlockSurface, Blocks, Bytes, Set, TileShape, bits};
    use crate::num::{Fx, Vec2};
    use crate::world::{Grid, TileKind, TileKinds, TileMap, TileMapError};

    /// A set without one-way tiles, so that a table can name a shape that is not in it.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    struct FullOnly;

    impl super::Sealed for FullOnly {}
    impl Set for FullOnly {
        const SHAPES: u64 = bits(TileShape::Empty, TileShape::Full);
        type Surface = BlockSurface;
    }

    #[test]
    fn a_shape_that_is_not_in_the_set_is_refused() {
        static FINE: TileKinds = TileKinds::EMPTY.with(255, TileKind::FULL.with_flags(255));
        static ONE: TileKinds = FINE.with(255, TileKind::ONE_WAY_UP);
        static TWO: TileKinds = ONE.with(7, TileKind::ONE_WAY_UP);
        static FIRST: TileKinds = TWO.with(0, TileKind::ONE_WAY_UP);
        let Ok(grid) = Grid::new(2, 1, Fx::lit("16"), Vec2::ZERO) else { unreachable!() };
        let build = |kinds: &'static TileKinds| TileMap::<FullOnly, Bytes>::build(&[0; 2], grid, 2, kinds).map(|_| ());
        assert_eq!(build(&FINE), Ok(()));
        assert_eq!(build(&ONE), Err(TileMapError::ShapeNotInSet { id: 255 }));
        assert_eq!(build(&TWO), Err(TileMapError::ShapeNotInSet { id: 7 }));
        assert_eq!(build(&FIRST), Err(TileMapError::ShapeNotInSet { id: 0 }));
        // Blocks has them all, whatever the store.
        assert!(TileMap::<Blocks, Bytes>::build(&[0; 2], grid, 2, &FIRST).is_ok());
        assert!(TileMap::<Blocks, Bits>::build(&[0; 1], grid, 2, &FIRST).is_ok());
    }
}
