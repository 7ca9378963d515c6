//! The errors of levels: of tiles, and of segments.

use super::cell::Cell;
use crate::error::Quantity;
use core::fmt;

/// Why a level was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum TileMapError {
    /// The width or the height is zero.
    EmptyMap,
    /// The width or the height is above 32 767.
    TooManyCells(u16),
    /// The side of a cell, in raw, is odd or outside of 2^8..=2^24.
    Cell(i32),
    /// The map does not fit the [domain](crate::num::DOMAIN).
    OutOfDomain {
        /// [`Quantity::X`] or [`Quantity::Y`].
        what: Quantity,
        /// The raw coordinate of the end that is outside; it saturates.
        value: i32,
    },
    /// Rows would overlap: the stride is less than the width.
    Stride(u16),
    /// The data ends before the last tile. Bytes are counted, even if a tile is a bit.
    TooShort {
        /// The number of bytes that the map needs.
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
    /// A character of the text is not ASCII, so it is not one byte.
    NotAscii {
        /// The row, from 0.
        row: u32,
        /// The column, from 0.
        column: u32,
    },
    /// A row of text ends with a carriage return and a line feed. Use only line feeds.
    CarriageReturn {
        /// The row, from 0.
        row: u32,
    },
    /// The table names a shape for this id that the map's [`ShapeSet`](crate::world::ShapeSet) does
    /// not have.
    ShapeNotInSet {
        /// The first such id.
        id: u8,
    },
    /// The bits of [`with_occupancy`](crate::world::TileMap::with_occupancy) are too few, or do not
    /// match the tiles.
    Occupancy {
        /// The first row that is missing or wrong.
        row: u16,
    },
}

impl fmt::Display for TileMapError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::EmptyMap => write!(f, "the map has no cells: width and height must be at least 1"),
            Self::TooManyCells(n) => {
                write!(f, "a side of {n} cells is longer than 32767: use larger cells, or cut the world into rooms")
            }
            Self::Cell(raw) => {
                write!(f, "a cell of {raw} raw is refused: {CELLS}")
            }
            Self::OutOfDomain { what, value } => {
                write!(f, "the map ends at {what:?} = {value} raw, out of range: move its origin, or cut it into rooms")
            }
            Self::Stride(stride) => {
                write!(f, "a stride of {stride} is less than the width, so rows would overlap: raise it")
            }
            Self::TooShort { needed, found } => {
                write!(
                    f,
                    "the tiles have {found} bytes, but the map needs {needed}: pass more, or lower its size or stride"
                )
            }
            Self::RowLength { expected: 0, .. } => {
                f.write_str("row 0 is empty: begin the text behind the quote, or open it with \"\\")
            }
            Self::RowLength { row, expected, found: 0 } => {
                write!(f, "row {row} is empty where row 0 has {expected}: remove it, or fill it")
            }
            Self::RowLength { row, expected, found } => {
                let s = if found == 1 { "" } else { "s" };
                write!(f, "row {row} has {found} character{s} where row 0 has {expected}: make them equal")
            }
            Self::NotAscii { row, column } => {
                write!(f, "the character at row {row}, column {column} is not ASCII: use one byte per tile")
            }
            Self::CarriageReturn { row } => {
                write!(f, "row {row} has a carriage return: end each row with only a line feed")
            }
            Self::Occupancy { row } => {
                write!(
                    f,
                    "the occupancy of row {row} is missing or does not match its tiles: call `fill_occupancy` again"
                )
            }
            Self::ShapeNotInSet { id } => {
                write!(f, "the table gives tile {id}")?;
                if id.is_ascii_graphic() {
                    write!(f, " '{}'", char::from(id))?;
                }
                f.write_str(
                    " a shape that is not in the map's set: choose another set with `of`, `of_ascii` or `of_bytes`",
                )
            }
        }
    }
}

const CELLS: &str = "its side must be even, from 256 to 16777216 raw (256 units)";

impl core::error::Error for TileMapError {}

/// Why a segment map was refused.
///
/// Paths, points and segments are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SegmentMapError {
    /// There is no point.
    Empty,
    /// A polygon has fewer than three points, or a chain fewer than two.
    TooFewPoints {
        /// The path.
        path: u32,
        /// Its points.
        points: u32,
    },
    /// A point is the same as the one that follows it; in a polygon the first one follows the last.
    ZeroLength {
        /// The path.
        path: u32,
        /// The first of the two points.
        point: u32,
    },
    /// A point is outside the [domain](crate::num::DOMAIN).
    OutOfDomain {
        /// The path.
        path: u32,
        /// The point.
        point: u32,
        /// [`Quantity::X`] or [`Quantity::Y`].
        what: Quantity,
        /// The raw coordinate.
        value: i32,
    },
    /// A point is outside the given grid.
    OutsideGrid {
        /// The path.
        path: u32,
        /// The point.
        point: u32,
    },
    /// The signed area of a polygon is zero: it has no inside.
    NoArea {
        /// The path.
        path: u32,
    },
    /// There are more than 32 768 segments. This is the first one too many.
    TooManySegments {
        /// The path.
        path: u32,
        /// The point at which the segment starts that is too many.
        point: u32,
    },
    /// More than 65 535 pairs of a segment and a cell that it meets: use larger cells.
    TooManyRefs {
        /// The path.
        path: u32,
        /// The point at which the segment starts that is too many.
        point: u32,
    },
    /// The cells are refused: their size, their number, or their position.
    Grid(TileMapError),
    /// More than 127 solids, or holes outside of solids, overlap each other in a cell.
    TooDeep(Cell),
    /// The buffer is too small.
    TooSmall {
        /// The bytes that are needed.
        needed: u32,
        /// The bytes that there are.
        found: u32,
    },
    /// The bytes do not start with `TSEG`.
    NotSegments,
    /// The bytes are of another version of the format.
    Version(u8),
    /// A part of the header that must be zero is not.
    Reserved,
    /// The bytes are more or fewer than the header says.
    Length {
        /// The bytes that the header needs.
        needed: u32,
        /// The bytes that there are.
        found: u32,
    },
    /// The checksum does not fit the bytes.
    Checksum {
        /// The checksum that is stored.
        stored: u32,
        /// The checksum of the bytes.
        computed: u32,
    },
    /// A segment is invalid.
    Segment {
        /// Its index.
        index: u16,
        /// Its fault.
        fault: SegmentFault,
    },
    /// A cell does not list the segments that meet it.
    Refs(Cell),
    /// The references are not as many as the segments have, or as the offsets say.
    RefCount {
        /// The number of references that there should be.
        needed: u32,
        /// The number of references.
        found: u32,
    },
    /// The winding number of a cell is not that of its segments.
    Winding(Cell),
}

/// The fault of a segment in its byte form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SegmentFault {
    /// It is the first of too many: there are at most 32 768.
    TooMany,
    /// The length is below 1.
    Length,
    /// The direction is zero, or both components have a common divisor.
    Direction,
    /// An end is not on the grid.
    OffGrid,
    /// An attribute that does not exist, or joints that contradict each other.
    Attributes,
    /// The segment after the vertex at its end does not exist, does not leave from there, or the
    /// vertex is not convex.
    Next,
}

impl fmt::Display for SegmentMapError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Empty => write!(f, "there are no points: a map needs at least one path"),
            Self::TooFewPoints { path, points } => {
                let s = if points == 1 { "" } else { "s" };
                write!(f, "path {path} has {points} point{s}: a polygon needs 3, a chain 2")
            }
            Self::ZeroLength { path, point } => {
                write!(f, "path {path}: point {point} is the same as the next: remove one of them")
            }
            Self::OutOfDomain { path, point, what, value } => {
                write!(f, "path {path}, point {point}: {what:?} = {value} raw is out of range: {NEAR_ORIGIN}")
            }
            Self::OutsideGrid { path, point } => {
                write!(f, "path {path}, point {point} is outside the grid: enlarge the grid")
            }
            Self::NoArea { path } => write!(f, "path {path} is a polygon without area: draw it as a wall"),
            Self::TooManySegments { path, point } => {
                write!(f, "path {path}, point {point} begins segment 32769 of at most 32768: cut the level in two")
            }
            Self::TooManyRefs { path, point } => {
                write!(f, "path {path}, point {point}: the cells list more than 65535 segments: use larger cells")
            }
            Self::Grid(e) => e.fmt(f),
            Self::TooDeep(Cell { x, y }) => {
                write!(f, "cell ({x}, {y}) has more than 127 polygons over each other: merge some")
            }
            Self::TooSmall { needed, found } => {
                write!(f, "the buffer has {found} bytes, but the map needs {needed}: lend at least {needed}")
            }
            Self::NotSegments => {
                write!(f, "the bytes do not begin with TSEG: pass those of `build_into`, or of `tilesat bake`")
            }
            Self::Version(version) => write!(f, "version {version} of the format is unknown: {AGAIN}"),
            Self::Reserved => write!(f, "a reserved part of the header is not zero: {AGAIN}"),
            Self::Length { needed, found } => {
                write!(f, "there are {found} bytes, but the header needs {needed}: pass the whole file and no more")
            }
            Self::Checksum { stored, computed } => {
                write!(f, "the checksum is {computed:#x}, not {stored:#x}, so the bytes have changed: {AGAIN}")
            }
            Self::Segment { index, fault } => write!(f, "segment {index} {}: {AGAIN}", fault.text()),
            Self::Refs(Cell { x, y }) => write!(f, "cell ({x}, {y}) does not list the segments that meet it: {AGAIN}"),
            Self::RefCount { needed, found } => {
                write!(f, "the cells list {found} references, but the segments need {needed}: {AGAIN}")
            }
            Self::Winding(Cell { x, y }) => write!(f, "the winding number of cell ({x}, {y}) is wrong: {AGAIN}"),
        }
    }
}

const AGAIN: &str = "bake the level again";
const NEAR_ORIGIN: &str = "keep points less than 8192 units from the origin";

impl SegmentFault {
    const fn text(self) -> &'static str {
        match self {
            Self::TooMany => "is one too many, as a map has at most 32768",
            Self::Length => "has a length below 1",
            Self::Direction => "has a direction that is zero or has a common divisor",
            Self::OffGrid => "has an end outside of the grid",
            Self::Attributes => "has attributes that do not exist or contradict each other",
            Self::Next => "does not continue in the segment that it names as the next",
        }
    }
}

impl core::error::Error for SegmentMapError {}

impl SegmentMapError {
    /// Only for [`segment_map!`]: the message of [`Display`](core::fmt::Display) for the paths of a
    /// level, in a constant.
    #[doc(hidden)]
    #[must_use]
    pub const fn __text(&self) -> Text {
        let text = Text { bytes: [0; 128], len: 0 };
        match *self {
            Self::Empty => text.and("there are no points: a map needs at least one path"),
            Self::TooFewPoints { path, points } => {
                let text = text.at(path, None).and(" has ").number(points);
                text.and(if points == 1 { " point" } else { " points" }).and(": a polygon needs 3, a chain 2")
            }
            Self::ZeroLength { path, point } => {
                text.at(path, None).and(": point ").number(point).and(" is the same as the next: remove one of them")
            }
            Self::OutOfDomain { path, point, what, value } => {
                let text =
                    text.at(path, Some(point)).and(if matches!(what, Quantity::X) { ": X = " } else { ": Y = " });
                text.signed(value).and(" raw is out of range: ").and(NEAR_ORIGIN)
            }
            Self::OutsideGrid { path, point } => {
                text.at(path, Some(point)).and(" is outside the grid: enlarge the grid")
            }
            Self::NoArea { path } => text.at(path, None).and(" is a polygon without area: draw it as a wall"),
            Self::TooManySegments { path, point } => {
                text.at(path, Some(point)).and(" begins segment 32769 of at most 32768: cut the level in two")
            }
            Self::TooManyRefs { path, point } => {
                text.at(path, Some(point)).and(": the cells list more than 65535 segments: use larger cells")
            }
            Self::Grid(TileMapError::Cell(raw)) => {
                text.and("a cell of ").signed(raw).and(" raw is refused: ").and(CELLS)
            }
            Self::Grid(TileMapError::TooManyCells(n)) => text
                .and("a side of ")
                .number(n as u32)
                .and(" cells is longer than 32767: use larger cells, or cut the world into rooms"),
            Self::TooDeep(Cell { x, y }) => {
                let text = text.and("cell (").signed(x as i32).and(", ").signed(y as i32);
                text.and(") has more than 127 polygons over each other: merge some")
            }
            _ => text.and("the level does not fit its grid: use larger cells"),
        }
    }
}

/// A message that the compiler can put together.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Text {
    bytes: [u8; 128],
    len: usize,
}

impl Text {
    /// The message.
    #[must_use]
    pub const fn as_str(&self) -> &str {
        match self.bytes.split_at_checked(self.len) {
            Some((text, _)) => match core::str::from_utf8(text) {
                Ok(text) => text,
                Err(_) => "",
            },
            None => "",
        }
    }

    #[expect(clippy::indexing_slicing, reason = "behind comparisons with the lengths")]
    const fn and(mut self, text: &str) -> Self {
        let (text, mut i) = (text.as_bytes(), 0);
        while i < text.len() && self.len < self.bytes.len() {
            self.bytes[self.len] = text[i];
            self.len += 1;
            i += 1;
        }
        self
    }

    const fn at(self, path: u32, point: Option<u32>) -> Self {
        let text = self.and("path ").number(path);
        match point {
            Some(point) => text.and(", point ").number(point),
            None => text,
        }
    }

    const fn signed(self, n: i32) -> Self {
        let text = if n < 0 { self.and("-") } else { self };
        text.number(n.unsigned_abs())
    }

    const fn number(self, n: u32) -> Self {
        const DIGITS: [&str; 10] = ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"];
        let text = if n > 9 { self.number(n / 10) } else { self };
        #[expect(clippy::indexing_slicing, reason = "a remainder by 10 indexes 10 entries")]
        text.and(DIGITS[(n % 10) as usize])
    }
}
