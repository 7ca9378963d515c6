//! Cells of a grid, and walks over ranges of them.

use super::tile_map::kind::TileKind;

/// A cell of a [`TileMap`](super::TileMap): column and row, counted from the map's origin.
///
/// ```text
///            x = 0   1   2        columns and rows -1, width and height
///  row -1  .   .   .   .   .      stand for everything beyond the map
///  row  0  . +---+---+---+ .
///  row  1  . |   | * |   | .      * is Cell { x: 1, y: 1 }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cell {
    /// Column. -1 and the map's width stand for everything left and right of it. For a
    /// [solid](super::Solids) it is the key, in a row that no map has: see
    /// [`Solids::key_of`](super::Solids::key_of).
    pub x: i16,
    /// Row; -1 and the map's height stand for everything beyond the first and the last row.
    pub y: i16,
}

impl Cell {
    /// A cell from its column and row.
    #[must_use]
    pub const fn new(x: i16, y: i16) -> Self {
        Self { x, y }
    }

    /// For indices clamped to -1..=32767.
    pub(crate) const fn of(x: i32, y: i32) -> Self {
        Self { x: x as i16, y: y as i16 }
    }
}

/// Columns `x0..=x1` of rows `y0..=y1`; empty where a first is above its last.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Range {
    pub(in crate::world) x0: i32,
    pub(in crate::world) y0: i32,
    pub(in crate::world) x1: i32,
    pub(in crate::world) y1: i32,
}

impl Range {
    pub(in crate::world) const NONE: Self = Self { x0: 0, y0: 0, x1: -1, y1: -1 };

    /// Without a cell, to be [widened](Self::with).
    pub(in crate::world) const NOWHERE: Self = Self { x0: i32::MAX, y0: i32::MAX, x1: i32::MIN, y1: i32::MIN };

    /// Widened to a cell.
    #[inline]
    pub(in crate::world) const fn with(self, x: i32, y: i32) -> Self {
        Self {
            x0: if x < self.x0 { x } else { self.x0 },
            y0: if y < self.y0 { y } else { self.y0 },
            x1: if x > self.x1 { x } else { self.x1 },
            y1: if y > self.y1 { y } else { self.y1 },
        }
    }

    #[inline]
    pub(in crate::world) const fn has_row(&self, y: i32) -> bool {
        self.y0 <= y && y <= self.y1
    }

    /// The columns, less those of a range that begins before them or ends after them.
    #[inline(never)]
    pub(in crate::world) const fn row_without(&self, seen: &Self) -> (i32, i32) {
        if seen.x0 <= self.x0 {
            (if seen.x1 < self.x0 { self.x0 } else { seen.x1.wrapping_add(1) }, self.x1)
        } else {
            (self.x0, if seen.x1 < self.x1 || seen.x0 > self.x1 { self.x1 } else { seen.x0.wrapping_sub(1) })
        }
    }
}

/// A cell that holds something.
///
/// Public in a private module, because a sealed trait's methods name it.
#[derive(Clone, Copy, Debug)]
pub struct Block {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) kind: TileKind,
}

/// The next cell of a walk over such cells.
#[derive(Clone, Copy, Debug)]
pub struct Cells {
    pub(in crate::world) range: Range,
    pub(in crate::world) x: i32,
    pub(in crate::world) y: i32,
}

impl Cells {
    /// Over.
    pub(crate) const NONE: Self = Self::of(Range::NONE);

    pub(in crate::world) const fn of(range: Range) -> Self {
        Self { x: range.x0, y: range.y0, range }
    }
}
