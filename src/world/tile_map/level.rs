//! A tile map as a level: its cells, which of them a box of coordinates reaches, and if there is
//! anything at all.

use super::clear::is_clear;
use super::surface::{BlockSurface, CellQuery};
use super::{Outside, ShapeSet, Store, TileMap};
use crate::num::Raw;
use crate::shape::{Aabb, Circle};
use crate::world::cell::Way;
use crate::world::cell::{Block, Cells, Range};
use crate::world::convex::ConvexBody;
use crate::world::level::{ANY_BODY, Feature, MotionPiece, Seen, World, sealed};
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
                    (cells.x, cells.y) = (x.wrapping_add(1), y);
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

    /// The cells of a region that a body may meet, and the box around them; see
    /// [`World::look`](crate::world::World::look).
    #[inline(never)]
    pub(in crate::world) fn look(&self, region: &Aabb, r: i32, seen: &mut Seen) -> bool {
        let inside = self.range_inside(region.lo(), region.hi());
        let found = match inside {
            Some(range) => self.met(range, Range::NOWHERE, region, r),
            None => self.met_beyond(region, r),
        };
        seen.held = self.extent_of(found);
        if seen.held.is_some() {
            seen.cells = Some(Cells::of(found));
        }
        // The map is in the domain.
        inside.is_some()
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

    /// The cells that a region that is not all inside the map meets.
    #[inline(never)]
    fn met_beyond(&self, region: &Aabb, r: i32) -> Range {
        let range = self.open_range(region.lo(), region.hi());
        let (range, found) = if self.has_solid_beyond() {
            let inside = self.inside(range);
            (inside, beyond(range, inside))
        } else {
            (self.solid_range(range), Range::NOWHERE)
        };
        // A region entirely beyond the map has no cell inside.
        if range.x0 > range.x1 || range.y0 > range.y1 { found } else { self.met(range, found, region, r) }
    }

    /// The cells of a range of the map that a body in the region may meet, and another range with
    /// them. The range has a cell, so both loops ask after the first one.
    fn met(&self, range: Range, mut found: Range, region: &Aabb, r: i32) -> Range {
        let (mut y, mut row) = (range.y0, self.place(range.x0, range.y0));
        loop {
            let x0 = if T::OCCUPIED { self.next_occupied(range.x0, range.x1, y) } else { range.x0 };
            let (mut x, mut tile) = (x0, row.wrapping_add(x0.wrapping_sub(range.x0) as u32));
            while !T::OCCUPIED || x <= range.x1 {
                let id = self.id_at(tile);
                if !self.kinds.is_empty(id) {
                    self.meet(&mut found, id, (x, y), region, r);
                }
                if x >= range.x1 {
                    break;
                }
                (x, tile) = (x.wrapping_add(1), tile.wrapping_add(1));
            }
            if y >= range.y1 {
                return found;
            }
            (y, row) = (y.wrapping_add(1), row.wrapping_add(u32::from(self.stride)));
        }
    }

    /// A separate function: the walk mostly reaches empty tiles, and needs the registers.
    #[inline(never)]
    const fn meet(&self, found: &mut Range, id: u8, (x, y): (i32, i32), region: &Aabb, r: i32) {
        let kind = self.kinds.get(id);
        let clear = S::SHAPED
            && r != ANY_BODY
            && !kind.is_full()
            && is_clear(kind.shape, self.grid.square(x, y), (region.lo(), region.hi()), r);
        if !clear {
            *found = found.with(x, y);
        }
    }

    const fn extent_of(&self, found: Range) -> Option<Aabb> {
        if found.x0 > found.x1 {
            return None;
        }
        let (lo, hi) = self.extent_between((found.x0, found.y0), (found.x1, found.y1));
        Some(Aabb::from_raw_unchecked(lo, hi))
    }
}

/// The cells of a range that are beyond the map: one row or column on each side, and the cells
/// between them.
const fn beyond(range: Range, inside: Range) -> Range {
    let (left, right) = (range.x0 < inside.x0, range.x1 > inside.x1);
    let (top, bottom) = (range.y0 < inside.y0, range.y1 > inside.y1);
    // A row beyond is as wide as the range, a column beyond as high.
    let (row, column) = (top || bottom, left || right);
    if !row && !column {
        return Range::NOWHERE;
    }
    Range {
        x0: if row || left { range.x0 } else { range.x1 },
        x1: if row || right { range.x1 } else { range.x0 },
        y0: if column || top { range.y0 } else { range.y1 },
        y1: if column || bottom { range.y1 } else { range.y0 },
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
    const fn has_solid_beyond(&self) -> bool {
        match self.outside {
            Outside::Empty => false,
            Outside::Solid => true,
            Outside::Edge => S::SHAPED,
        }
    }
}
