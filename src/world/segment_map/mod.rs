//! A level of free line segments: polygons, walls and one-way chains in a grid, read from bytes.

mod build;
mod bytes;
mod cancel;
mod cells;
mod check;
mod emit;
mod error;
mod features;
mod join;
mod joint;
mod macros;
mod orient;
mod overlap;
mod parse;
mod path;
mod raster;
mod ray;
mod seg;
mod size;
mod solid;
mod thin;
mod verify;
mod winding;
mod world;

pub use error::{SegmentFault, SegmentMapError};
pub use features::SegmentFeatures;
pub use path::{Path, PathKind};
pub use ray::SegmentRayHits;
pub(super) use seg::{Kind, Seg};
pub use size::Size;

use super::Grid;
use crate::num::{Fx, Vec2};
use bytes::{SEGMENT, half};

/// A level of polygons, walls and one-way chains, read from where it lies: a view of bytes that have been checked once.
///
/// Made from [`Path`]s by the compiler ([`segment_map!`](crate::segment_map)), at run time in storage of the caller's
/// ([`build_into`](Self::build_into)), or elsewhere: a file that is included is taken by [`from_bytes`](Self::from_bytes), without a copy. All three
/// give the same bytes. It owns nothing and needs no memory but itself.
///
/// ```
/// use tilesat::{Fx, Path, PathKind, SegmentMap, Vec2, segment_map};
/// const HILL: [Vec2; 4] = [Vec2::from_ints(0, 80), Vec2::from_ints(64, 48), Vec2::from_ints(96, 48), Vec2::from_ints(160, 80)];
/// const CAVE: [Vec2; 3] = [Vec2::from_ints(64, 56), Vec2::from_ints(96, 56), Vec2::from_ints(80, 72)];
/// const LEDGE: [Vec2; 2] = [Vec2::from_ints(96, 32), Vec2::from_ints(128, 32)];
/// segment_map!(static LEVEL: [
///     Path::new(PathKind::Solid, &HILL),
///     Path::new(PathKind::Hole, &CAVE),
///     Path::new(PathKind::OneWay, &LEDGE).with_flags(1),
/// ], Fx::lit("32"));
/// assert_eq!((LEVEL.count(), LEVEL.width(), LEVEL.height()), (8, 5, 2));
///
/// // The same at run time.
/// let mut room = [0; 600];
/// let paths = [Path::new(PathKind::Solid, &HILL), Path::new(PathKind::Hole, &CAVE)];
/// let used = SegmentMap::build_into(&paths, Fx::from_num(32), &mut room)?;
/// let level = SegmentMap::from_bytes(&room[..used])?;
/// assert_eq!(level.count(), 7);
/// # Ok::<(), tilesat::SegmentMapError>(())
/// ```
///
/// # What is solid
///
/// A point is solid where more solids than holes are around it. Polygons may lie over each other; where two of them share an edge, or a
/// part of one, it is gone, so that nothing can snag there. What a hole takes must lie in a solid: the edges of one that does not are thin
/// walls in the open.
///
/// ```text
///   +------------+           Solids less holes: solid where the number is above 0. Each polygon may run either way
///   | 1 +---+  +-|---+       round: its area tells, and its segments are turned so that the solid is on their left
///   |   | 0 |  |2| 1 |       where y grows up (on their right where it grows down). Edges inside of the solid stay,
///   |   +---+  +-|---+       and do no harm.
///   +------------+     0
/// ```
///
/// # Where the boundary goes on
///
/// At the end of a segment there is a vertex only where the free angle is more than half a turn. All segments through the point count,
/// those that neither start nor end there, too:
///
/// ```text
///            o  wall                      o a vertex: around the end of the wall, from one face to the other
///            |                            + none: in the corners beside the wall the angle is a quarter turn
///   o========+========o  floor            . none, flat, where two floors lie side by side: o====.====o
/// ```
///
/// # Bounds
///
/// At most 32768 segments, and 65535 pairs of a segment and a cell whose closed square it meets: larger cells make fewer. Of `n` edges of
/// polygons, building compares each with each, and needs no memory but the bytes.
///
/// The compiler builds about 300 segments before its limit on constants (the lint `long_running_const_eval`), which a level of some 1000 may be
/// allowed to exceed, at the price of tens of seconds: `segment_map!(#[allow(long_running_const_eval)] static LEVEL: ..)`. Larger levels are
/// built on the host, and their bytes are included.
#[derive(Clone, Copy, Debug)]
pub struct SegmentMap<'a> {
    grid: Grid,
    /// 24 bytes a segment.
    segments: &'a [u8],
    /// Two bytes a cell and two more: where the cell's references start.
    offsets: &'a [u8],
    /// Two bytes a reference.
    refs: &'a [u8],
    /// A byte a cell.
    winding: &'a [u8],
}

impl<'a> SegmentMap<'a> {
    /// Where the cells are.
    #[must_use]
    pub const fn grid(&self) -> Grid {
        self.grid
    }

    /// The side of a cell.
    #[must_use]
    pub const fn cell(&self) -> Fx {
        self.grid.cell()
    }

    /// The corner of the first cell with the smallest coordinates.
    #[must_use]
    pub const fn origin(&self) -> Vec2 {
        self.grid.origin()
    }

    /// Columns.
    #[must_use]
    pub const fn width(&self) -> u16 {
        self.grid.width()
    }

    /// Rows.
    #[must_use]
    pub const fn height(&self) -> u16 {
        self.grid.height()
    }

    /// The number of segments.
    #[must_use]
    pub const fn count(&self) -> u16 {
        (self.segments.len() / SEGMENT) as u16
    }

    /// A segment by its index, below [`count`](Self::count); of length 0 for others, which nothing asks for.
    #[inline]
    pub(super) const fn segment(&self, index: u16) -> Seg {
        Seg::read(self.segments, index)
    }

    /// The segments that meet the closed square of a cell, ascending; none beyond the grid.
    #[inline]
    pub(super) const fn refs(&self, x: i32, y: i32) -> Refs<'a> {
        let Some(cell) = self.place(x, y) else { return Refs::NONE };
        let at = cell << 1;
        Refs { all: self.refs, at: half(self.offsets, at), end: half(self.offsets, at.wrapping_add(2)) }
    }

    /// How many solids (less holes) contain the reference point of a cell: its corner with the smaller coordinates, moved into the cell by
    /// an infinitesimal along x and a much smaller one along y. 0 beyond the grid.
    #[inline]
    #[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
    pub(super) const fn winding(&self, x: i32, y: i32) -> i8 {
        match self.place(x, y) {
            Some(cell) if cell < self.winding.len() => self.winding[cell] as i8,
            _ => 0,
        }
    }

    /// The place of a cell in the tables.
    const fn place(&self, x: i32, y: i32) -> Option<usize> {
        if x as u32 >= self.grid.x.count as u32 || y as u32 >= self.grid.y.count as u32 {
            return None;
        }
        // Below 2^30.
        Some((y as usize).wrapping_mul(self.grid.x.count as usize).wrapping_add(x as usize))
    }
}

/// The segments of a cell by index; see [`SegmentMap::refs`].
#[derive(Clone, Debug)]
pub(super) struct Refs<'a> {
    /// Those of all cells.
    all: &'a [u8],
    at: u16,
    end: u16,
}

impl Refs<'_> {
    pub(super) const NONE: Self = Self { all: &[], at: 0, end: 0 };

    /// Usable in constants.
    #[inline]
    pub(super) const fn advance(&mut self) -> Option<u16> {
        if self.at >= self.end {
            return None;
        }
        let index = half(self.all, (self.at as usize) << 1);
        self.at += 1;
        Some(index)
    }
}

impl Iterator for Refs<'_> {
    type Item = u16;

    #[inline]
    fn next(&mut self) -> Option<u16> {
        self.advance()
    }
}
