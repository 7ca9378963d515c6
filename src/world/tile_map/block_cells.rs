//! The cells of a level of blocks that hold something, for a mover that reads them without their features.

use super::block_surface::BlockSurface;
use super::range::Range;
use crate::num::Raw;
use crate::shape::Aabb;
use crate::world::{Feature, Outside, Set, Store, TileMap};

/// A cell that is full, or has a one-way face.
///
/// Public in a private module, because a sealed trait's methods name it.
#[derive(Clone, Copy, Debug)]
pub struct Block {
    pub(crate) x: i32,
    pub(crate) y: i32,
    /// The corners of the cell; at a repeated border it goes on beyond the map.
    pub(crate) lo: Raw,
    pub(crate) hi: Raw,
    pub(crate) flags: u8,
    pub(crate) one_way: bool,
}

/// The place of a walk over such cells: the next one to look at.
#[derive(Clone, Copy, Debug)]
pub struct Cells {
    range: Range,
    x: i32,
    y: i32,
}

impl Cells {
    /// Over.
    pub(in crate::world) const NONE: Self = Self::of(Range::NONE);

    pub(in crate::world) const fn of(range: Range) -> Self {
        Self { x: range.x0, y: range.y0, range }
    }

    pub(in crate::world) const fn range(&self) -> Range {
        self.range
    }
}

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// The cells whose inside meets a region.
    pub(in crate::world) const fn cells(&self, region: &Aabb) -> Cells {
        Cells::of(self.solid_range(self.open_range(region.lo(), region.hi())))
    }

    pub(in crate::world) const fn next_cell(&self, cells: &mut Cells) -> Option<Block> {
        while cells.y <= cells.range.y1 {
            let (x, y) = (self.next_shape(cells.x, cells.range.x1, cells.y), cells.y);
            if x <= cells.range.x1 {
                let last = x == cells.range.x1;
                (cells.x, cells.y) = if last { (cells.range.x0, y.wrapping_add(1)) } else { (x.wrapping_add(1), y) };
                let (kind, (lo, hi)) = if self.holds(x, y) && !matches!(self.outside, Outside::Edge) {
                    (self.kinds.get(self.id(x, y)), self.grid.square(x, y))
                } else {
                    (self.kind_at(x, y), self.extent(x, y))
                };
                return Some(Block { x, y, lo, hi, flags: kind.flags, one_way: !kind.is_full() });
            }
            (cells.x, cells.y) = (cells.range.x0, y.wrapping_add(1));
        }
        None
    }

    /// The face of a one-way tile, if nothing covers it.
    pub(in crate::world) fn one_way_face(&self, block: &Block) -> Option<Feature> {
        BlockSurface::one_way(self, block.x, block.y)
    }
}
