//! Markers in a map's type: which shapes it can hold, and how its tile ids are stored.

use super::TileShape;
use super::sealed::Sealed;
use core::fmt::Debug;

/// Which shapes a [`TileMap`](super::TileMap) can hold, so that a level of blocks links no code for anything else.
///
/// Sealed; the markers are types such as [`Blocks`]. A table that names another shape is refused by the constructors.
pub trait Set: Sealed + Copy + Debug + Eq + 'static {
    /// One bit for each discriminant of [`TileShape`] that is allowed.
    const SHAPES: u32;
}

/// Empty, full and one-way tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Blocks;

impl Sealed for Blocks {}
impl Set for Blocks {
    const SHAPES: u32 = 1 << TileShape::Empty as u32 | 1 << TileShape::Full as u32 | 1 << TileShape::OneWayUp as u32;
}

/// How a [`TileMap`](super::TileMap) stores its tile ids.
///
/// Sealed; the markers are [`Bytes`] and [`Bits`].
pub trait Store: Sealed + Copy + Debug + Eq + 'static {
    /// Bits of one tile: 8 or 1.
    const BITS: u32;
}

/// One byte a tile: 256 ids.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Bytes;

impl Sealed for Bytes {}
impl Store for Bytes {
    const BITS: u32 = 8;
}

/// One bit a tile, the least significant bit of a byte first: ids 0 and 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Bits;

impl Sealed for Bits {}
impl Store for Bits {
    const BITS: u32 = 1;
}
