//! A tile map as a level: its cells, which of them a box of coordinates reaches, and if there is
//! anything at all.

use super::surface::{BlockSurface, CellQuery};
use super::{Outside, ShapeSet, Store, TileMap};
use crate::num::Raw;
use crate::shape::{Aabb, Circle};
use crate::world::cell::Way;
use crate::world::cell::{Block, Cells, Range};
use crate::world::convex::ConvexBody;
use crate::world::level::{Feature, MotionPiece, Seen, World, sealed};
use crate::world::lines::{BlockHit, Lines};
use crate::world::probes::Probe;
use crate::world::tangent::Tangent;
use crate::world::tile_map::features::Features;
use crate::world::tile_map::kind::Fill;

impl<S: ShapeSet, T: Store> sealed::Sealed for TileMap<'_, S, T> {}

impl<S: ShapeSet, T: Store> World for TileMap<'_, S, T> {
    const BLOCKS: bool = !S::SHAPED;
    const ROUND: bool = S::ARCS;
    const GRID: bool = true;
    const CERTAIN: bool = true;

    #[doc(hidden)]
    const ARCS: bool = S::ARCS;

    type Features<'w>
        = Features<'w, S, T>
    where
        Self: 'w;

    #[inline]
    fn features(&self, region: &Aabb) -> Features<'_, S, T> {
        TileMap::features(self, region)
    }

    #[inline]
    fn features_near(&self, region: &Aabb, joints: bool) -> Features<'_, S, T> {
        self.features_for(&CellQuery { joints, ..CellQuery::all(region) })
    }

    #[inline]
    fn next_near(&self, features: &mut Features<'_, S, T>) -> Option<Feature> {
        // A second copy of the surface of shapes would take 800 bytes.
        if S::SHAPED { features.next() } else { features.next_near() }
    }

    #[inline]
    fn features_ahead(&self, way: &MotionPiece) -> Features<'_, S, T> {
        TileMap::features_ahead(self, way)
    }

    #[inline]
    fn cells(&self, region: &Aabb) -> Cells {
        TileMap::cells(self, region)
    }

    fn next_cell(&self, cells: &mut Cells) -> Option<Block> {
        TileMap::next_cell(self, cells)
    }

    fn way(&self, bounds: &Aabb, r: i32, d: Raw) -> Way {
        TileMap::way(self, bounds, r, d)
    }

    fn next_strip(&self, way: &mut Way) {
        TileMap::next_strip(self, way);
    }

    #[inline]
    fn next_on_way(&self, way: &mut Way) -> Option<Block> {
        TileMap::next_on_way(self, way)
    }

    #[inline]
    fn lines(&self, bounds: &Aabb, d: Raw) -> Lines {
        TileMap::lines(self, bounds, d)
    }

    #[inline]
    fn starts_inside(&self, lines: &Lines, bounds: &Aabb) -> bool {
        TileMap::starts_inside(self, lines, bounds)
    }

    #[inline]
    fn next_block(&self, lines: &mut Lines, pass_one_way: bool, seen: &mut u32) -> Option<BlockHit> {
        TileMap::next_block(self, lines, pass_one_way, seen)
    }

    #[inline]
    fn corners(&self, block: &Block) -> (Raw, Raw) {
        let (x, y) = (block.x, block.y);
        let is_square = self.holds(x, y) && (S::SHAPED || !matches!(self.outside, Outside::Edge));
        if is_square { self.grid.square(x, y) } else { self.extent(x, y) }
    }

    #[inline]
    fn features_of_cells(&self, region: &Aabb, d: Raw, joints: bool) -> Features<'_, S, T> {
        self.features_of(&CellQuery { d, joints, ..CellQuery::all(region) })
    }

    fn enter(&self, features: &mut Features<'_, S, T>, block: &Block) {
        features.enter(block);
    }

    fn next_here(&self, features: &mut Features<'_, S, T>) -> Option<Feature> {
        features.next_here()
    }

    #[inline]
    fn fill(&self, x: i32, y: i32) -> Fill {
        self.kind_at(x, y).fill()
    }

    #[inline]
    fn one_way_face(&self, block: &Block) -> Option<Feature> {
        TileMap::one_way_face(self, block)
    }

    #[inline]
    fn look(&self, region: &Aabb, r: i32, seen: &mut Seen) -> bool {
        TileMap::look(self, region, r, seen)
    }

    fn is_known_empty(&self, region: &Aabb) -> bool {
        TileMap::is_known_empty(self, region)
    }

    fn is_behind(&self, region: &Aabb, r: i32, line: &Tangent) -> bool {
        TileMap::is_behind(self, region, r, line)
    }

    #[inline]
    fn cell_size(&self) -> u32 {
        self.grid.cell as u32
    }

    fn most_cells(&self, width: u32, height: u32) -> u32 {
        self.grid.most_cells(width, height)
    }

    #[inline]
    fn overlaps_aabb(&self, b: &Aabb) -> bool {
        TileMap::overlaps(self, b)
    }

    #[inline]
    fn meets_convex(&self, body: &ConvexBody<'_>, closed: bool) -> bool {
        if closed { self.convex_meets::<true>(body) } else { self.convex_meets::<false>(body) }
    }

    fn overlaps_circle(&self, c: &Circle) -> bool {
        TileMap::overlaps(self, c)
    }

    #[inline]
    fn touches_aabb(&self, b: &Aabb) -> bool {
        TileMap::touches(self, b)
    }

    #[inline]
    fn touches_circle(&self, c: &Circle) -> bool {
        TileMap::touches(self, c)
    }

    fn flags_touched<P: Probe>(&self, shape: &P) -> u8 {
        TileMap::flags_touched(self, shape)
    }
}

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// The cells whose inside meets a region.
    pub(in crate::world) const fn cells(&self, region: &Aabb) -> Cells {
        Cells::of(self.solid_range(self.open_range(region.lo(), region.hi())))
    }

    #[inline(never)]
    pub(in crate::world) const fn next_cell(&self, cells: &mut Cells) -> Option<Block> {
        let (mut x, mut y, last) = (cells.x, cells.y, cells.range.x1);
        while y <= cells.range.y1 {
            if !self.holds(cells.range.x0, y) || !self.holds(last, y) {
                return self.next_cell_beyond(cells, x, y);
            }
            if T::OCCUPIED && x <= last {
                x = self.next_occupied(x, last, y);
            }
            let mut tile = self.place(x, y);
            while x <= last {
                let id = self.id_at(tile);
                if !self.kinds.is_empty(id) {
                    // The call after the last cell is then over at once: 35 instructions less.
                    let row_ends = x == last;
                    (cells.x, cells.y) =
                        if row_ends { (cells.range.x0, y.wrapping_add(1)) } else { (x.wrapping_add(1), y) };
                    return Some(Block { x, y, kind: self.kinds.get(id) });
                }
                (x, tile) = (x.wrapping_add(1), tile.wrapping_add(1));
            }
            (x, y) = (cells.range.x0, y.wrapping_add(1));
        }
        cells.y = y;
        None
    }

    /// The next cell of a walk from a cell on, with cells beyond the map.
    #[inline(never)]
    const fn next_cell_beyond(&self, cells: &mut Cells, mut x: i32, mut y: i32) -> Option<Block> {
        while y <= cells.range.y1 {
            while x <= cells.range.x1 {
                let kind = self.kind_at(x, y);
                if !kind.is_empty() {
                    (cells.x, cells.y) = (x.wrapping_add(1), y);
                    return Some(Block { x, y, kind });
                }
                x = x.wrapping_add(1);
            }
            (x, y) = (cells.range.x0, y.wrapping_add(1));
        }
        cells.y = y;
        None
    }

    /// The face of a one-way tile, if nothing covers it.
    pub(in crate::world) fn one_way_face(&self, block: &Block) -> Option<Feature> {
        BlockSurface::one_way(self, block.x, block.y)
    }

    /// Whether a region of at most [`SMALL`](Self::SMALL) cells is in the map and has no tile.
    #[inline(never)]
    pub(in crate::world) fn is_known_empty(&self, region: &Aabb) -> bool {
        let Some(range) = self.range_inside(region.lo(), region.hi()) else { return false };
        if range.cells() > Self::SMALL {
            return false;
        }
        if T::OCCUPIED || T::BITS != 8 {
            return self.next_cell(&mut Cells::of(range)).is_none();
        }
        let width = range.x1.wrapping_sub(range.x0).wrapping_add(1) as usize;
        let (mut y, mut first) = (range.y0, self.place(range.x0, range.y0) as usize);
        loop {
            let row = self.data.get(first..first.wrapping_add(width));
            if !row.is_some_and(|row| row.iter().all(|&id| self.kinds.is_empty(id))) {
                return false;
            }
            if y >= range.y1 {
                return true;
            }
            (y, first) = (y.wrapping_add(1), first.wrapping_add(self.stride.into()));
        }
    }

    const SMALL: u32 = 64;

    /// The cells of a region inside the map: a quotient an axis, from where it is stepped.
    #[inline(always)]
    pub(super) const fn range_inside(&self, lo: Raw, hi: Raw) -> Option<Range> {
        let grid = &self.grid;
        let (x0, y0) = (lo.x.wrapping_sub(grid.x.origin), lo.y.wrapping_sub(grid.y.origin));
        let (x1, y1) = (hi.x.wrapping_sub(grid.x.origin), hi.y.wrapping_sub(grid.y.origin));
        // The sign of any of them; where a difference wraps, its minuend's own bound is passed.
        if (x0 | y0 | grid.x.size.wrapping_sub(x1) | grid.y.size.wrapping_sub(y1)) < 0 {
            return None;
        }
        let (first_x, first_y) = (grid.quotient(x0 as u32) as i32, grid.quotient(y0 as u32) as i32);
        Some(Range { x0: first_x, y0: first_y, x1: grid.last_before(x1, first_x), y1: grid.last_before(y1, first_y) })
    }

    /// The cells that can hold solid and meet a box with area in their inside.
    #[inline]
    pub(super) const fn solid_range_of(&self, lo: Raw, hi: Raw) -> Range {
        match self.range_inside(lo, hi) {
            Some(range) => range,
            None => self.solid_range(self.open_range(lo, hi)),
        }
    }
}

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// The cells whose closed square meets the closed box: `ceil(lo / cell) - 1` is the column of
    /// `lo - 1`.
    pub(in crate::world) const fn closed_range(&self, lo: Raw, hi: Raw) -> Range {
        let one = Raw { x: 1, y: 1 };
        self.open_range(lo.sub(one), hi.add(one))
    }

    /// The cells whose open square meets the open box, for a box with area.
    #[inline(never)]
    pub(in crate::world) const fn open_range(&self, lo: Raw, hi: Raw) -> Range {
        let (x0, x1) = self.grid.columns(lo.x, hi.x.wrapping_sub(1));
        let (y0, y1) = self.grid.rows(lo.y, hi.y.wrapping_sub(1));
        Range { x0, y0, x1, y1 }
    }

    /// The part of a range inside the map.
    pub(in crate::world) const fn inside(&self, r: Range) -> Range {
        let (last_x, last_y) = (self.grid.x.count as i32 - 1, self.grid.y.count as i32 - 1);
        Range {
            x0: if r.x0 < 0 { 0 } else { r.x0 },
            y0: if r.y0 < 0 { 0 } else { r.y0 },
            x1: if r.x1 > last_x { last_x } else { r.x1 },
            y1: if r.y1 > last_y { last_y } else { r.y1 },
        }
    }

    /// The cells of a range that can hold solid. Where the border is repeated, border blocks stand
    /// for the bands beyond them, and shaped ones have separate bands. There is nothing outside
    /// where that is empty.
    #[inline(never)]
    pub(in crate::world) const fn solid_range(&self, r: Range) -> Range {
        if self.has_solid_beyond() {
            return r;
        }
        let r = self.inside(r);
        if !matches!(self.outside, Outside::Edge) {
            return r;
        }
        let (last_x, last_y) = (self.grid.x.count as i32 - 1, self.grid.y.count as i32 - 1);
        Range {
            x0: if r.x0 > last_x { last_x } else { r.x0 },
            y0: if r.y0 > last_y { last_y } else { r.y0 },
            x1: if r.x1 < 0 { 0 } else { r.x1 },
            y1: if r.y1 < 0 { 0 } else { r.y1 },
        }
    }

    /// Whether cells beyond the map can hold solid that no cell of the map represents.
    #[inline]
    pub(super) const fn has_solid_beyond(&self) -> bool {
        match self.outside {
            Outside::Empty => false,
            Outside::Solid => true,
            Outside::Edge => S::SHAPED,
        }
    }
}
