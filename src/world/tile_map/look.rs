//! What a mover sees first of a tile map: the cells of a region that a body in it may meet.

use super::clear::is_clear;
use super::{Outside, ShapeSet, Store, TileMap};
use crate::shape::Aabb;
use crate::world::cell::{Block, Cells, Range};
use crate::world::level::{ANY_BODY, Seen};
use crate::world::tile_map::kind::TileKind;

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// The cells of a region that a body may meet, and the box around them; see
    /// [`World::look`](crate::world::World::look).
    ///
    /// Most looks find no tile. They are this function alone: 158 instructions on a Cortex-M0. With
    /// the rest in one function they are 208, because that leaves no registers to the walk.
    #[inline(never)]
    pub(in crate::world) fn look(&self, region: &Aabb, r: i32, seen: &mut Seen) -> bool {
        let Some(range) = self.range_inside(region.lo(), region.hi()) else {
            return self.look_beyond(region, r, seen);
        };
        match self.first_tile(&range) {
            None => seen.held = None,
            Some(at) => self.look_from(&range, at, region, r, seen),
        }
        // The map is in the domain.
        true
    }

    /// The first cell of a range of the map that is not empty. The range has a cell, so both loops
    /// ask after the first one.
    #[inline(always)]
    fn first_tile(&self, range: &Range) -> Option<(i32, i32)> {
        let (mut y, mut row) = (range.y0, self.place(range.x0, range.y0));
        loop {
            let x0 = if T::OCCUPIED { self.next_occupied(range.x0, range.x1, y) } else { range.x0 };
            let (mut x, mut tile) = (x0, row.wrapping_add(x0.wrapping_sub(range.x0) as u32));
            while !T::OCCUPIED || x <= range.x1 {
                if !self.kinds.is_empty(self.id_at(tile)) {
                    return Some((x, y));
                }
                if x == range.x1 {
                    break;
                }
                (x, tile) = (x.wrapping_add(1), tile.wrapping_add(1));
            }
            if y == range.y1 {
                return None;
            }
            (y, row) = (y.wrapping_add(1), row.wrapping_add(u32::from(self.stride)));
        }
    }

    /// The rest of a look at a range of the map, from its first tile on.
    #[inline(never)]
    fn look_from(&self, range: &Range, at: (i32, i32), region: &Aabb, r: i32, seen: &mut Seen) {
        let found = self.met(range, at, region, r);
        seen.held = None;
        if found.x0 > found.x1 {
            return;
        }
        let (first, last) = ((found.x0, found.y0), (found.x1, found.y1));
        // Cells of the map need no tests for those beyond, which take 40 instructions.
        let (lo, hi) = if !S::SHAPED && matches!(self.outside, Outside::Edge) {
            self.extent_between(first, last)
        } else {
            self.grid.area(first, last)
        };
        (seen.held, seen.cells) = (Some(Aabb::from_raw_unchecked(lo, hi)), Some(Cells::of(found)));
    }

    /// The cells of a range of the map that a body in the region may meet. The first tile is known.
    fn met(&self, range: &Range, (mut x, mut y): (i32, i32), region: &Aabb, r: i32) -> Range {
        let (mut found, mut row) = (Range::NOWHERE, self.place(0, y));
        loop {
            self.meet(&mut found, self.kinds.get(self.id_at(row.wrapping_add(x as u32))), (x, y), region, r);
            // The next one that is not empty.
            loop {
                x = x.wrapping_add(1);
                if T::OCCUPIED {
                    x = self.next_occupied(x, range.x1, y);
                }
                if x > range.x1 {
                    if y == range.y1 {
                        return found;
                    }
                    (x, y, row) = (range.x0.wrapping_sub(1), y.wrapping_add(1), row.wrapping_add(self.stride.into()));
                } else if !self.kinds.is_empty(self.id_at(row.wrapping_add(x as u32))) {
                    break;
                }
            }
        }
    }

    /// A look at a region that is not all inside the map. Returns false.
    #[inline(never)]
    fn look_beyond(&self, region: &Aabb, r: i32, seen: &mut Seen) -> bool {
        let range = self.open_range(region.lo(), region.hi());
        let (range, mut found) = if self.has_solid_beyond() {
            let inside = self.inside(range);
            (inside, beyond(range, inside))
        } else {
            (self.solid_range(range), Range::NOWHERE)
        };
        // A region entirely beyond the map has no cell inside: the walk finds none.
        let mut cells = Cells::of(range);
        while let Some(Block { x, y, kind }) = self.next_cell(&mut cells) {
            self.meet(&mut found, kind, (x, y), region, r);
        }
        seen.held = None;
        if found.x0 <= found.x1 {
            let (lo, hi) = self.extent_between((found.x0, found.y0), (found.x1, found.y1));
            (seen.held, seen.cells) = (Some(Aabb::from_raw_unchecked(lo, hi)), Some(Cells::of(found)));
        }
        false
    }

    /// Widens a range to a tile, unless a body in the region does not meet its solid.
    #[inline(always)]
    const fn meet(&self, found: &mut Range, kind: TileKind, at: (i32, i32), region: &Aabb, r: i32) {
        if S::SHAPED {
            self.meet_shaped(found, kind, at, region, r);
        } else {
            *found = found.with(at.0, at.1);
        }
    }

    /// A separate function: the walk needs the registers.
    #[inline(never)]
    const fn meet_shaped(&self, found: &mut Range, kind: TileKind, (x, y): (i32, i32), region: &Aabb, r: i32) {
        let clear = r != ANY_BODY
            && !kind.is_full()
            && is_clear(kind.shape, self.grid.square(x, y), (region.lo(), region.hi()), r);
        if !clear {
            *found = found.with(x, y);
        }
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
