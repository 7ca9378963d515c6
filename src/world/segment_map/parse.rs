//! From bytes to a map: its size, and a check of everything on which queries rely.
//!
//! No step of the checks, and none of a query, depends on bytes that were not checked before.

use super::raster::Rows;
use super::{
    ATTR_AT, END_JOINED, HEADER, KIND, Kind, MAGIC, MOST, NONE, SEGMENT, START_JOINED, SegmentMap, VERSION, at,
    checksum, half, part, path, word,
};
use crate::num::{Fx, Vec2, imul};
use crate::world::cell::Cell;
use crate::world::error::{SegmentFault, SegmentMapError};
use crate::world::grid::Grid;

/// The size of a level: cells, segments, references, bytes.
///
/// [`SegmentMap::measure`] computes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Size {
    pub(super) grid: Grid,
    pub(super) segments: u16,
    pub(super) refs: u16,
}

impl Size {
    /// The cells.
    #[must_use]
    pub const fn grid(&self) -> Grid {
        self.grid
    }

    /// The number of segments.
    ///
    /// Edges that polygons share are not counted. An edge of a wall counts as two, that of a
    /// one-way chain as one.
    #[must_use]
    pub const fn segments(&self) -> u16 {
        self.segments
    }

    /// Pairs of a segment and a cell whose closed square it meets.
    #[must_use]
    pub const fn refs(&self) -> u16 {
        self.refs
    }

    /// The number of bytes of the level: 34, and 24 per segment, 2 per reference, 3 per cell.
    ///
    /// Below 2^32, as there are fewer than 2^30 cells.
    #[must_use]
    pub const fn bytes(&self) -> usize {
        self.winding_at().wrapping_add(self.cells())
    }

    pub(super) const fn cells(&self) -> usize {
        (self.grid.x.count as usize).wrapping_mul(self.grid.y.count as usize)
    }

    pub(super) const fn offsets_at(&self) -> usize {
        HEADER.wrapping_add((self.segments as usize).wrapping_mul(SEGMENT))
    }

    pub(super) const fn refs_at(&self) -> usize {
        self.offsets_at().wrapping_add(self.cells().wrapping_add(1) << 1)
    }

    pub(super) const fn winding_at(&self) -> usize {
        self.refs_at().wrapping_add((self.refs as usize) << 1)
    }

    /// The tables of a level of this size that is being built.
    pub(super) const fn tables<'a>(&self, data: &'a mut [u8]) -> Tables<'a> {
        let (segments, data) = cut(cut(data, HEADER).1, self.offsets_at().wrapping_sub(HEADER));
        let (offsets, data) = cut(data, self.refs_at().wrapping_sub(self.offsets_at()));
        let (refs, data) = cut(data, self.winding_at().wrapping_sub(self.refs_at()));
        Tables { segments, offsets, refs, winding: cut(data, self.cells()).0 }
    }

    /// The tables of a level of this size.
    pub(super) const fn view<'a>(&self, data: &'a [u8]) -> SegmentMap<'a> {
        SegmentMap {
            grid: self.grid,
            segments: part(data, HEADER, self.offsets_at()),
            offsets: part(data, self.offsets_at(), self.refs_at()),
            refs: part(data, self.refs_at(), self.winding_at()),
            winding: part(data, self.winding_at(), self.bytes()),
        }
    }
}

/// The tables of a level, each of which may be written while the others are read.
pub(super) struct Tables<'a> {
    pub(super) segments: &'a mut [u8],
    pub(super) offsets: &'a mut [u8],
    pub(super) refs: &'a mut [u8],
    pub(super) winding: &'a mut [u8],
}

/// The first bytes, and the others; none if there are fewer.
const fn cut(data: &mut [u8], at: usize) -> (&mut [u8], &mut [u8]) {
    match data.split_at_mut_checked(at) {
        Some(parts) => parts,
        None => (&mut [], &mut []),
    }
}

impl<'a> SegmentMap<'a> {
    /// A view of a level in its byte form, as [`build_into`](Self::build_into) writes it.
    ///
    /// Nothing is copied: `include_bytes!` is enough, at any alignment. All conditions on which
    /// queries rely are checked, and no bytes can make them panic or loop. The level must be one
    /// that could have been built: its cells list all segments that meet them, and every winding
    /// number is right. It does not check whether the polygons are closed. In a constant, a damaged
    /// file is a compile error and the program pays nothing.
    ///
    /// Cost: each byte for the checksum, each reference twice (to find it among those of its cell,
    /// and for the winding numbers).
    ///
    /// # Errors
    /// [`SegmentMapError`] says what is wrong and where. Every change of a single byte and every
    /// other length is refused.
    ///
    /// ```
    /// use tilesat::{Path, PathKind, SegmentMap, SegmentMapError, Vec2, fx};
    /// let hill = [Vec2::from_ints(0, 0), Vec2::from_ints(40, 0), Vec2::from_ints(20, -9)];
    /// let mut room = [0; 512];
    /// let used = SegmentMap::build_into(&[Path::new(PathKind::Solid, &hill)], fx!(32), &mut room)?;
    /// assert_eq!(SegmentMap::from_bytes(&room[..used])?.count(), 3);
    /// room[40] ^= 1; // a damaged file
    /// assert!(matches!(SegmentMap::from_bytes(&room[..used]), Err(SegmentMapError::Checksum { .. })));
    /// # Ok::<(), SegmentMapError>(())
    /// ```
    pub const fn from_bytes(data: &'a [u8]) -> Result<Self, SegmentMapError> {
        let size = match header(data) {
            Ok(size) => size,
            Err(e) => return Err(e),
        };
        let (stored, computed) = (word(data, at::CHECKSUM), checksum(data));
        if stored != computed {
            return Err(SegmentMapError::Checksum { stored, computed });
        }
        let map = size.view(data);
        match map.verify() {
            Ok(()) => Ok(map),
            Err(e) => Err(e),
        }
    }
}

/// The size of a level, if the header is right and the bytes are as many as it says.
const fn header(data: &[u8]) -> Result<Size, SegmentMapError> {
    if data.len() < HEADER {
        return Err(SegmentMapError::Length { needed: HEADER as u32, found: data.len() as u32 });
    }
    if word(data, at::MAGIC) != MAGIC {
        return Err(SegmentMapError::NotSegments);
    }
    let version = half(data, at::VERSION);
    if version as u8 != VERSION {
        return Err(SegmentMapError::Version(version as u8));
    }
    if version >> 8 != 0 || half(data, at::RESERVED) != 0 {
        return Err(SegmentMapError::Reserved);
    }
    let origin = Vec2::from_raw(word(data, at::ORIGIN_X) as i32, word(data, at::ORIGIN_Y) as i32);
    let cell = Fx::from_bits(word(data, at::CELL) as i32);
    let grid = match Grid::new(half(data, at::WIDTH), half(data, at::HEIGHT), cell, origin) {
        Ok(grid) => grid,
        Err(e) => return Err(SegmentMapError::Grid(e)),
    };
    if half(data, at::SEGMENTS) > MOST {
        return Err(SegmentMapError::Segment { index: MOST, fault: SegmentFault::TooMany });
    }
    let size = Size { grid, segments: half(data, at::SEGMENTS), refs: half(data, at::REFS) };
    if data.len() == size.bytes() {
        Ok(size)
    } else {
        Err(SegmentMapError::Length { needed: size.bytes() as u32, found: clamped(data.len()) })
    }
}

/// A number of bytes, saturating.
pub(super) const fn clamped(bytes: usize) -> u32 {
    if bytes > u32::MAX as usize { u32::MAX } else { bytes as u32 }
}

impl SegmentMap<'_> {
    pub(super) const fn verify(&self) -> Result<(), SegmentMapError> {
        let (mut index, count) = (0u16, self.count());
        while index < count {
            if let Err(fault) = self.verify_fields(index) {
                return Err(SegmentMapError::Segment { index, fault });
            }
            index += 1;
        }
        index = 0;
        while index < count {
            if let Err(fault) = self.verify_joints(index) {
                return Err(SegmentMapError::Segment { index, fault });
            }
            index += 1;
        }
        if let Err(e) = self.verify_tables() {
            return Err(e);
        }
        self.verify_refs()
    }

    /// With a length of 1 or more and both ends on the grid, a direction is below 2^30.
    const fn verify_fields(&self, index: u16) -> Result<(), SegmentFault> {
        let seg = self.segment(index);
        let attr = half(self.segments, (index as usize).wrapping_mul(SEGMENT).wrapping_add(ATTR_AT)) as u8;
        if attr & !(KIND | START_JOINED | END_JOINED) != 0 || attr & KIND == KIND {
            return Err(SegmentFault::Attributes);
        }
        if seg.len < 1 {
            return Err(SegmentFault::Length);
        }
        if path::gcd(seg.dir.x.unsigned_abs(), seg.dir.y.unsigned_abs()) != 1 {
            return Err(SegmentFault::Direction);
        }
        let (x, y) = (&self.grid.x, &self.grid.y);
        // Products of two words: below 2^62, and no sum wraps.
        let end_x = imul(seg.dir.x, seg.len).wrapping_add(seg.a.x as i64);
        let end_y = imul(seg.dir.y, seg.len).wrapping_add(seg.a.y as i64);
        if holds(x.origin, x.size, seg.a.x as i64)
            && holds(y.origin, y.size, seg.a.y as i64)
            && holds(x.origin, x.size, end_x)
            && holds(y.origin, y.size, end_y)
        {
            Ok(())
        } else {
            Err(SegmentFault::OffGrid)
        }
    }

    const fn verify_joints(&self, index: u16) -> Result<(), SegmentFault> {
        let seg = self.segment(index);
        let one_way = matches!(seg.kind, Kind::OneWay);
        // One-way chains are joined at their vertices; all others have one where they are not
        // joined.
        let Some(next) = seg.next else {
            return if one_way || seg.end_joined { Ok(()) } else { Err(SegmentFault::Attributes) };
        };
        if one_way != seg.end_joined {
            return Err(SegmentFault::Attributes);
        }
        if next >= self.count() || next == NONE {
            return Err(SegmentFault::Next);
        }
        let (p, other) = (seg.b(), self.segment(next));
        let end = other.b();
        let turn = seg.dir.perp_dot(other.dir);
        let back = seg.dir.x == other.dir.x.wrapping_neg() && seg.dir.y == other.dir.y.wrapping_neg();
        let leaves = other.holds(p) && !(p.x == end.x && p.y == end.y);
        if !leaves || !(turn > 0 || back && !one_way) || !one_way && matches!(other.kind, Kind::OneWay) {
            return Err(SegmentFault::Next);
        }
        // A segment that starts at a vertex of a solid or a wall is not joined there.
        if !one_way && other.start_joined && p.x == other.a.x && p.y == other.a.y {
            return Err(SegmentFault::Attributes);
        }
        Ok(())
    }

    /// Checks that offsets do not fall and that each cell's indices ascend. Also checks its winding
    /// number.
    const fn verify_tables(&self) -> Result<(), SegmentMapError> {
        let (width, height) = (self.grid.x.count as i32, self.grid.y.count as i32);
        let (mut y, mut offset, mut place) = (0, 0, 0usize);
        while y < height {
            let (mut x, mut winding) = (0, 0);
            while x < width {
                place = place.wrapping_add(2);
                let next = half(self.offsets, place);
                let first = half(self.offsets, place.wrapping_sub(2));
                if first != offset || next < offset || next as usize > self.refs.len() >> 1 || !self.ascend(x, y) {
                    return Err(SegmentMapError::Refs(Cell::of(x, y)));
                }
                offset = next;
                winding = self.next_winding(x, y, winding);
                if winding != self.winding(x, y) as i32 {
                    return Err(SegmentMapError::Winding(Cell::of(x, y)));
                }
                x += 1;
            }
            y += 1;
        }
        let (needed, found) = (offset as u32, (self.refs.len() >> 1) as u32);
        if needed == found { Ok(()) } else { Err(SegmentMapError::RefCount { needed, found }) }
    }

    const fn ascend(&self, x: i32, y: i32) -> bool {
        let (mut refs, mut lowest) = (self.refs(x, y), 0);
        while let Some(index) = refs.advance() {
            if index < lowest || index >= self.count() {
                return false;
            }
            // Below 2^16: an index is below the count.
            lowest = index + 1;
        }
        true
    }

    /// Each segment is in all cells that it meets, and there are no other references. The check
    /// ends at the first cell where this fails. The references bound its work, whatever the
    /// segments are.
    const fn verify_refs(&self) -> Result<(), SegmentMapError> {
        let (mut index, mut needed) = (0u16, 0u32);
        while index < self.count() {
            let seg = self.segment(index);
            let mut rows = Rows::new(&self.grid, seg.a, seg.b(), seg.dir);
            while let Some(row) = rows.advance() {
                let mut x = row.x0;
                while x <= row.x1 {
                    if !self.refers(x, row.y, index) {
                        return Err(SegmentMapError::Refs(Cell::of(x, row.y)));
                    }
                    needed = needed.wrapping_add(1);
                    x += 1;
                }
            }
            index += 1;
        }
        let found = (self.refs.len() >> 1) as u32;
        if needed == found { Ok(()) } else { Err(SegmentMapError::RefCount { needed, found }) }
    }

    /// Whether a cell refers to a segment, by binary search, because its indices ascend.
    const fn refers(&self, x: i32, y: i32, index: u16) -> bool {
        let refs = self.refs(x, y);
        let (mut from, mut to) = (0, refs.left.len() >> 1);
        while from < to {
            let middle = (from + to) >> 1;
            let found = half(refs.left, middle << 1);
            if found == index {
                return true;
            }
            if found < index {
                from = middle + 1;
            } else {
                to = middle;
            }
        }
        false
    }
}

/// Whether a coordinate is on the closed side of the grid.
const fn holds(origin: i32, size: i32, v: i64) -> bool {
    let d = v.wrapping_sub(origin as i64);
    0 <= d && d <= size as i64
}
