//! What can be wrong with a segment map.

use crate::error::Quantity;
use crate::world::{Cell, TileMapError};
use core::fmt;

/// A segment map that was refused, and why. Paths, points and segments are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SegmentMapError {
    /// There is not a single point.
    Empty,
    /// A polygon of fewer than three points, or a chain of fewer than two: nothing that could be closed, or drawn.
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
    /// A point is outside of the [domain](crate::num::DOMAIN).
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
    /// A point is outside of the given grid.
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
    /// More than 32768 segments, in this one of this path.
    TooManySegments {
        /// The path.
        path: u32,
        /// The point where the segment starts that is too much.
        point: u32,
    },
    /// More than 65535 pairs of a segment and a cell that it meets: larger cells are needed.
    TooManyRefs {
        /// The path.
        path: u32,
        /// The point where the segment starts that is too much.
        point: u32,
    },
    /// The cells are refused: their size, their number, or their place.
    Grid(TileMapError),
    /// More than 127 solids, or holes outside of solids, lie over each other in a cell.
    TooDeep(Cell),
    /// The room for the bytes is too small.
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
        /// The one that is stored.
        stored: u32,
        /// The one that the bytes have.
        computed: u32,
    },
    /// A segment is not one.
    Segment {
        /// Its index.
        index: u16,
        /// What is wrong.
        fault: SegmentFault,
    },
    /// The references of a cell are not those of the segments that meet it.
    Refs(Cell),
    /// The references are not as many as the segments have, or as the offsets say.
    RefCount {
        /// How many there should be.
        needed: u32,
        /// How many there are.
        found: u32,
    },
    /// The winding number of a cell is not that of its segments.
    Winding(Cell),
}

/// What is wrong with a segment of a byte form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SegmentFault {
    /// It is the first of too many: there are at most 32768.
    TooMany,
    /// The length is below 1.
    Length,
    /// The direction is zero, or both components have a common divisor.
    Direction,
    /// An end is not on the grid.
    OffGrid,
    /// An attribute that does not exist, or joints that contradict each other.
    Attributes,
    /// The segment after the vertex at its end does not exist, does not leave from there, or the vertex is not convex.
    Next,
}

impl fmt::Display for SegmentMapError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Empty => write!(f, "there are no points"),
            Self::TooFewPoints { path, points } => write!(f, "path {path} has {points} points, too few for its kind"),
            Self::ZeroLength { path, point } => write!(f, "path {path}: point {point} is the same as the next"),
            Self::OutOfDomain { path, point, what, value } => {
                write!(f, "path {path}, point {point}: {what:?} = {value} raw is out of range")
            }
            Self::OutsideGrid { path, point } => write!(f, "path {path}, point {point} is outside of the grid"),
            Self::NoArea { path } => write!(f, "path {path} is a polygon without area"),
            Self::TooManySegments { path, point } => {
                write!(f, "more than 32768 segments at path {path}, point {point}")
            }
            Self::TooManyRefs { path, point } => {
                write!(f, "more than 65535 segments in cells at path {path}, point {point}: use larger cells")
            }
            Self::Grid(e) => e.fmt(f),
            Self::TooDeep(cell) => write!(f, "more than 127 polygons lie over each other in cell {cell:?}"),
            Self::TooSmall { needed, found } => write!(f, "room for {found} bytes where {needed} are needed"),
            Self::NotSegments => write!(f, "the bytes are no segment map"),
            Self::Version(version) => write!(f, "version {version} of the format is not known"),
            Self::Reserved => write!(f, "a part of the header that must be zero is not"),
            Self::Length { needed, found } => write!(f, "{found} bytes where the header needs {needed}"),
            Self::Checksum { stored, computed } => write!(f, "the checksum is {computed:#x}, not {stored:#x}"),
            Self::Segment { index, fault } => write!(f, "segment {index}: {fault:?}"),
            Self::Refs(cell) => write!(f, "the segments of cell {cell:?} are not those that meet it"),
            Self::RefCount { needed, found } => write!(f, "{found} references where {needed} are needed"),
            Self::Winding(cell) => write!(f, "the winding number of cell {cell:?} is wrong"),
        }
    }
}

impl core::error::Error for SegmentMapError {}
