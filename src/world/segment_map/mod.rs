//! A level of free line segments: polygons, walls and one-way chains in a grid, read from bytes.
//!
//! The bytes are little-endian, at any alignment. They can be read and written in constants.
//!
//! | bytes | what |
//! |---|---|
//! | 32 | header |
//! | 24 per segment | segments |
//! | 2 per cell, and 2 | offsets into the references, row after row |
//! | 2 per reference | segment indices, ascending within a cell |
//! | 1 per cell | winding numbers of the reference points, signed |
//!
//! | header at | type | what |
//! |---|---|---|
//! | 0 | | `TSEG` |
//! | 4 | u8 | version, 1 |
//! | 5 | u8 | 0 |
//! | 6 | u16 | segments |
//! | 8, 12 | i32 | origin x, y |
//! | 16 | i32 | side of a cell |
//! | 20, 22 | u16 | columns, rows |
//! | 24 | u16 | references |
//! | 26 | u16 | 0 |
//! | 28 | u32 | checksum of everything, itself as zero |

mod build;
mod cancel;
mod convex;
mod join;
mod overlap;
mod parse;
mod path;
mod raster;
mod ray;
mod surface;

pub use parse::Size;
pub use path::{Path, PathKind};
pub use ray::SegmentRayHits;
pub use surface::SegmentFeatures;

use super::grid::Grid;
use crate::num::{Axis, Fx, Raw, Vec2};

/// A level of polygons, walls and one-way chains: a view of bytes that have been checked once.
///
/// You can make one in three ways. The macro [`segment_map!`](crate::segment_map) builds it
/// from [`Path`]s at compile time. [`build_into`](Self::build_into) builds it at run time in memory
/// that you lend. [`from_bytes`](Self::from_bytes) reads a file that was built before, without a
/// copy. All three give the same bytes. The map itself owns no data.
///
/// ```
/// use tilesat::{Fx, Path, PathKind, SegmentMap, Vec2, fx, segment_map};
/// const HILL: [Vec2; 4] = [Vec2::from_ints(0, 80), Vec2::from_ints(64, 48), Vec2::from_ints(96, 48), Vec2::from_ints(160, 80)];
/// const CAVE: [Vec2; 3] = [Vec2::from_ints(64, 56), Vec2::from_ints(96, 56), Vec2::from_ints(80, 72)];
/// const LEDGE: [Vec2; 2] = [Vec2::from_ints(96, 32), Vec2::from_ints(128, 32)];
/// segment_map!(static LEVEL: [
///     Path::new(PathKind::Solid, &HILL),
///     Path::new(PathKind::Hole, &CAVE),
///     Path::new(PathKind::OneWay, &LEDGE).with_flags(1),
/// ], fx!(32));
/// assert_eq!((LEVEL.count(), LEVEL.width(), LEVEL.height()), (8, 5, 2));
///
/// // The same level at run time.
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
/// A point is solid if more solids than holes are around it. Polygons may overlap. If two of them
/// share an edge, or a part of one, that part is removed, and nothing can snag there. A hole must
/// lie in a solid. Otherwise its edges are thin walls.
///
/// ```text
///   +------------+           Solids less holes: solid where the number is above 0. Each polygon may run either way
///   | 1 +---+  +-|---+       round: its area tells, and its segments are turned so that the solid is on their left
///   |   | 0 |  |2| 1 |       where y grows up (on their right where it grows down). Edges inside of the solid stay,
///   |   +---+  +-|---+       and do no harm.
///   +------------+     0
/// ```
///
/// # Where the boundary continues
///
/// At the end of a segment there is a vertex only if the free angle is more than half a turn. All
/// segments through the point count, also those that only pass through it:
///
/// ```text
///            o  wall                      o a vertex: around the end of the wall, from one face to the other
///            |                            + none: in the corners beside the wall the angle is a quarter turn
///   o========+========o  floor            . none, flat, where two floors lie side by side: o====.====o
/// ```
///
/// # Bounds
///
/// A map has at most 32 768 segments, and 65 535 pairs of a segment and a cell that it meets.
/// Larger cells make fewer pairs. Building takes 4 KB of stack and no memory except the bytes. It
/// reads the edges of all polygons once for each 64 of them, and compares those that are near each
/// other. It also compares each end of a segment with the segments of its cell, so smaller cells
/// make it faster.
///
/// The compiler builds some 2000 segments before its limit on constants, the lint
/// `long_running_const_eval`, in 5 to 20 seconds. You may allow more:
/// `segment_map!(#[allow(long_running_const_eval)] static LEVEL: ..)`. Build larger levels on the
/// host, and include their bytes.
#[derive(Clone, Copy, Debug)]
#[doc(alias("ChainShape", "polyline", "EdgeShape"))]
pub struct SegmentMap<'a> {
    grid: Grid,
    /// 24 bytes per segment.
    segments: &'a [u8],
    /// Two bytes per cell and two more: where the cell's references start.
    offsets: &'a [u8],
    /// Two bytes per reference.
    refs: &'a [u8],
    /// A byte per cell.
    winding: &'a [u8],
}

impl<'a> SegmentMap<'a> {
    /// The grid of the cells.
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

    /// A segment by its index, below [`count`](Self::count); of length 0 for other indices, which
    /// do not occur.
    #[inline]
    pub(super) const fn segment(&self, index: u16) -> Seg {
        Seg::read(self.segments, index)
    }

    /// The segments that meet the closed square of a cell, ascending; none beyond the grid.
    #[inline]
    pub(super) const fn refs(&self, x: i32, y: i32) -> Refs<'a> {
        let Some(cell) = self.place(x, y) else { return Refs::NONE };
        let at = cell << 1;
        let (from, to) = (half(self.offsets, at) as usize, half(self.offsets, at.wrapping_add(2)) as usize);
        Refs { left: part(self.refs, from << 1, to << 1) }
    }

    /// How many solids (less holes) contain the reference point of a cell. That is the corner with
    /// the smaller coordinates, moved into the cell by an infinitesimal along x and a much smaller
    /// one along y. 0 beyond the grid.
    #[inline]
    #[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
    pub(super) const fn winding(&self, x: i32, y: i32) -> i8 {
        match self.place(x, y) {
            Some(cell) if cell < self.winding.len() => self.winding[cell] as i8,
            _ => 0,
        }
    }

    /// The index of a cell in the tables.
    const fn place(&self, x: i32, y: i32) -> Option<usize> {
        if x as u32 >= self.grid.x.count || y as u32 >= self.grid.y.count {
            return None;
        }
        // Below 2^30.
        Some((y as usize).wrapping_mul(self.grid.x.count as usize).wrapping_add(x as usize))
    }
}

/// The segments of a cell by index; see [`SegmentMap::refs`].
#[derive(Clone, Debug)]
pub(super) struct Refs<'a> {
    left: &'a [u8],
}

impl Refs<'_> {
    pub(super) const NONE: Self = Self { left: &[] };

    /// Usable in constants.
    #[inline]
    pub(super) const fn advance(&mut self) -> Option<u16> {
        match self.left {
            [low, high, left @ ..] => {
                self.left = left;
                Some(*low as u16 | (*high as u16) << 8)
            }
            _ => None,
        }
    }
}

impl Iterator for Refs<'_> {
    type Item = u16;

    #[inline]
    fn next(&mut self) -> Option<u16> {
        self.advance()
    }
}

/// The kind of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::world) enum Kind {
    /// The boundary of a solid, which lies on the left of its direction.
    Solid,
    /// One face of a wall; another one runs the other way.
    Wall,
    /// Blocks bodies from its outward normal's side.
    OneWay,
}

/// A segment from `a` to `a + dir * len`; its outward normal is `(dir.y, -dir.x)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::world) struct Seg {
    pub(in crate::world) a: Raw,
    /// Reduced.
    pub(in crate::world) dir: Axis,
    /// In multiples of `dir`, at least 1.
    pub(in crate::world) len: i32,
    /// The segment that leaves the convex vertex at the end. `None` without a vertex.
    pub(in crate::world) next: Option<u16>,
    pub(in crate::world) kind: Kind,
    /// No vertex at the start: the boundary, or the one-way chain, continues there.
    pub(in crate::world) start_joined: bool,
    /// No vertex at the end. If it is not set and the segment is not one-way, `next` is there.
    pub(in crate::world) end_joined: bool,
    /// The user's flags.
    pub(in crate::world) flags: u8,
}

/// Segments are fewer than this: twice an index, and one for the vertex, is the index of a feature.
pub(super) const MOST: u16 = 1 << 15;

/// The value of `next` if there is no vertex.
pub(super) const NONE: u16 = u16::MAX;

/// The bits of the attribute byte.
pub(super) const KIND: u8 = 3;
pub(super) const START_JOINED: u8 = 4;
pub(super) const END_JOINED: u8 = 8;

/// The offset of the fields after the geometry.
pub(super) const NEXT_AT: usize = 20;
pub(super) const ATTR_AT: usize = 22;

impl Seg {
    const NONE: Self = Self {
        a: Raw::ZERO,
        dir: Axis::new(0, 0),
        len: 0,
        next: Some(0),
        kind: Kind::Solid,
        start_joined: false,
        end_joined: false,
        flags: 0,
    };

    /// The end: inside the domain, so nothing wraps.
    pub(in crate::world) const fn b(&self) -> Raw {
        Raw {
            x: self.a.x.wrapping_add(self.dir.x.wrapping_mul(self.len)),
            y: self.a.y.wrapping_add(self.dir.y.wrapping_mul(self.len)),
        }
    }

    /// Whether a point is on the closed segment. Distances inside the domain and directions are
    /// below 2^30: the product is below 2^61.
    pub(in crate::world) const fn holds(&self, p: Raw) -> bool {
        // The start already decides most of them.
        let (a, dir) = (self.a, self.dir);
        let before_x = if dir.x < 0 { p.x > a.x } else { p.x < a.x };
        if before_x || if dir.y < 0 { p.y > a.y } else { p.y < a.y } {
            return false;
        }
        let b = self.b();
        if if dir.x < 0 { p.x < b.x } else { p.x > b.x } || if dir.y < 0 { p.y < b.y } else { p.y > b.y } {
            return false;
        }
        Raw { x: self.dir.x, y: self.dir.y }.cross(p.sub(a)) == 0
    }

    /// Segment `index` of a table; zeros beyond its end.
    #[inline]
    pub(super) const fn read(table: &[u8], index: u16) -> Self {
        let at = index as usize * SEGMENT;
        // One comparison for all fields. No slices: each is a dozen calls, and the compiler counts
        // those in constants.
        if at + SEGMENT > table.len() {
            return Self::NONE;
        }
        let (next, attr) = (field::<NEXT_AT>(table, at) as u16, field::<NEXT_AT>(table, at) >> 16);
        Self {
            a: Raw { x: field::<0>(table, at) as i32, y: field::<4>(table, at) as i32 },
            dir: Axis { x: field::<8>(table, at) as i32, y: field::<12>(table, at) as i32 },
            len: field::<16>(table, at) as i32,
            next: if next == NONE { None } else { Some(next) },
            kind: match attr as u8 & KIND {
                0 => Kind::Solid,
                1 => Kind::Wall,
                _ => Kind::OneWay,
            },
            start_joined: attr as u8 & START_JOINED != 0,
            end_joined: attr as u8 & END_JOINED != 0,
            flags: (attr >> 8) as u8,
        }
    }
}

/// 32 bits of the segment at a place.
#[inline]
#[expect(clippy::indexing_slicing, reason = "behind the comparison with the length in `read`")]
const fn field<const AT: usize>(bytes: &[u8], at: usize) -> u32 {
    // No call: the compiler counts calls in constants.
    bytes[at + AT] as u32
        | (bytes[at + (AT + 1)] as u32) << 8
        | (bytes[at + (AT + 2)] as u32) << 16
        | (bytes[at + (AT + 3)] as u32) << 24
}

pub(super) const MAGIC: u32 = u32::from_le_bytes(*b"TSEG");
pub(super) const VERSION: u8 = 1;
/// Bytes of the header.
pub(super) const HEADER: usize = 32;
/// Bytes of a segment.
pub(super) const SEGMENT: usize = 24;

/// The offsets of the header's fields.
pub(super) mod at {
    pub(in crate::world::segment_map) const MAGIC: usize = 0;
    /// Version, a zero and the number of segments in one word.
    pub(in crate::world::segment_map) const VERSION: usize = 4;
    pub(in crate::world::segment_map) const SEGMENTS: usize = 6;
    pub(in crate::world::segment_map) const ORIGIN_X: usize = 8;
    pub(in crate::world::segment_map) const ORIGIN_Y: usize = 12;
    pub(in crate::world::segment_map) const CELL: usize = 16;
    pub(in crate::world::segment_map) const WIDTH: usize = 20;
    pub(in crate::world::segment_map) const HEIGHT: usize = 22;
    pub(in crate::world::segment_map) const REFS: usize = 24;
    pub(in crate::world::segment_map) const RESERVED: usize = 26;
    pub(in crate::world::segment_map) const CHECKSUM: usize = 28;
}

/// The bytes `from..to`; none if there are fewer.
pub(super) const fn part(data: &[u8], from: usize, to: usize) -> &[u8] {
    match data.split_at_checked(to) {
        Some((head, _)) => match head.split_at_checked(from) {
            Some((_, part)) => part,
            None => &[],
        },
        None => &[],
    }
}

/// 16 bits; 0 beyond the end. No slices, as in [`Seg::read`].
#[inline]
#[expect(clippy::indexing_slicing, reason = "behind comparisons with the length")]
pub(super) const fn half(data: &[u8], at: usize) -> u16 {
    if at < data.len() && at + 1 < data.len() { data[at] as u16 | (data[at + 1] as u16) << 8 } else { 0 }
}

/// 32 bits; 0 beyond the end.
#[inline]
pub(super) const fn word(data: &[u8], at: usize) -> u32 {
    match data.split_at_checked(at) {
        Some((_, &[a, b, c, d, ..])) => u32::from_le_bytes([a, b, c, d]),
        _ => 0,
    }
}

/// Writes 16 bits; nothing beyond the end.
#[expect(clippy::indexing_slicing, reason = "behind comparisons with the length")]
pub(super) const fn set_half(data: &mut [u8], at: usize, value: u16) {
    if at < data.len() && at + 1 < data.len() {
        (data[at], data[at + 1]) = (value as u8, (value >> 8) as u8);
    }
}

/// Writes 32 bits; nothing beyond the end.
pub(super) const fn set_word(data: &mut [u8], at: usize, value: u32) {
    set_half(data, at, value as u16);
    set_half(data, at.wrapping_add(2), (value >> 16) as u16);
}

/// Writes a byte; nothing beyond the end.
#[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
pub(super) const fn set_byte(data: &mut [u8], at: usize, value: u8) {
    if at < data.len() {
        data[at] = value;
    }
}

/// 32-bit FNV-1a with the checksum's own field as zero. Each step is one-to-one in the state and in
/// the byte, so every change of a single byte is detected.
#[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
pub(super) const fn checksum(data: &[u8]) -> u32 {
    let (mut hash, mut i) = (0x811c_9dc5u32, 0);
    while i < data.len() {
        let byte = if i & !3 == at::CHECKSUM { 0 } else { data[i] };
        hash = (hash ^ byte as u32).wrapping_mul(0x0100_0193);
        i += 1;
    }
    hash
}
