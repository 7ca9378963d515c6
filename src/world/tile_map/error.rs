//! What can be wrong with a level.

use crate::error::Quantity;
use core::fmt;

/// A level that was refused, and why.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum TileMapError {
    /// The width or the height is zero.
    EmptyMap,
    /// The width or the height is above 32767.
    TooManyCells(u16),
    /// The side of a cell, in raw, is odd or outside of 2^8..=2^24.
    Cell(i32),
    /// The map does not fit the [domain](crate::num::DOMAIN): which axis, and the raw coordinate of its end.
    OutOfDomain {
        /// [`Quantity::X`] or [`Quantity::Y`].
        what: Quantity,
        /// The end that is outside; it saturates.
        value: i32,
    },
    /// Rows would overlap: the stride is less than the width.
    Stride(u16),
    /// The data ends before the last tile. Bytes are counted, also where a tile is a bit.
    TooShort {
        /// The bytes that the map needs.
        needed: u32,
        /// The bytes that there are.
        found: u32,
    },
    /// A row of text is longer or shorter than the first.
    RowLength {
        /// The row, from 0.
        row: u32,
        /// The characters of the first row.
        expected: u32,
        /// The characters of this one.
        found: u32,
    },
    /// A character of the text is not ASCII, so that bytes would not be tiles.
    NotAscii {
        /// The row, from 0.
        row: u32,
        /// The column, from 0.
        column: u32,
    },
    /// A row of text ends with a carriage return and a line feed: line feeds alone are wanted.
    CarriageReturn {
        /// The row, from 0.
        row: u32,
    },
    /// The table names a shape that the map's [`Set`](crate::world::Set) does not have, for this id.
    ShapeNotInSet {
        /// The first such id.
        id: u8,
    },
    /// The bits of [`with_occupancy`](crate::world::TileMap::with_occupancy) are too few, or not those of the tiles.
    Occupancy {
        /// The first row that is missing or wrong.
        row: u16,
    },
}

impl fmt::Display for TileMapError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::EmptyMap => write!(f, "the map has no cells"),
            Self::TooManyCells(n) => write!(f, "{n} cells on a side are more than 32767"),
            Self::Cell(raw) => write!(f, "a cell of {raw} raw is odd or not in 256..=16777216 (256 units)"),
            Self::OutOfDomain { what, value } => write!(f, "the map ends at {what:?} = {value} raw, out of range"),
            Self::Stride(stride) => write!(f, "a stride of {stride} is less than the width"),
            Self::TooShort { needed, found } => write!(f, "{found} bytes of tiles where {needed} are needed"),
            Self::RowLength { row, expected, found } => {
                write!(f, "row {row} has {found} characters where the first has {expected}")
            }
            Self::NotAscii { row, column } => write!(f, "the character at row {row}, column {column} is not ASCII"),
            Self::CarriageReturn { row } => {
                write!(f, "row {row} has a carriage return; rows end with line feeds alone")
            }
            Self::Occupancy { row } => write!(f, "the occupancy of row {row} is missing or not that of its tiles"),
            Self::ShapeNotInSet { id } => {
                write!(f, "the table gives tile {id}")?;
                if id.is_ascii_graphic() {
                    write!(f, " '{}'", char::from(id))?;
                }
                f.write_str(" a shape that is not in the map's set: a map of another set is made by `of` or `of_ascii`")
            }
        }
    }
}

impl core::error::Error for TileMapError {}
