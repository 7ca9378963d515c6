//! How large the byte form of a level is, and where its tables are.

use super::SegmentMap;
use super::bytes::{HEADER, SEGMENT, part};
use crate::world::Grid;

/// What a level takes: cells, segments, references, bytes. From [`SegmentMap::measure`].
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

    /// Segments: the edges of polygons less what they share, two for an edge of a wall, one for an edge of a one-way chain.
    #[must_use]
    pub const fn segments(&self) -> u16 {
        self.segments
    }

    /// Pairs of a segment and a cell whose closed square it meets.
    #[must_use]
    pub const fn refs(&self) -> u16 {
        self.refs
    }

    /// Bytes of the whole: 34, and 24 a segment, 2 a reference, 3 a cell.
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
