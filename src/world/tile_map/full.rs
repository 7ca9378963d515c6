//! Which full cells a range has.

use super::{Outside, ShapeSet, Store, TileMap};
use crate::num::Raw;
use crate::world::cell::{Cells, Range};

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// A side of no length on a cell's border is inside the solid only where the cells on both
    /// sides are full. The open range is reversed then, and starts at the first of the two.
    #[inline(never)]
    pub(super) const fn thin_overlaps_blocks(&self, lo: Raw, hi: Raw) -> bool {
        let mut range = self.open_range(lo, hi);
        let (mut pair_x, mut pair_y) = (0, 0);
        if lo.x == hi.x {
            pair_x = range.x0.wrapping_sub(range.x1);
            range.x0 = range.x1;
        }
        if lo.y == hi.y {
            pair_y = range.y0.wrapping_sub(range.y1);
            range.y0 = range.y1;
        }
        if pair_x == 0 && pair_y == 0 {
            range = self.solid_range(range);
        }
        let mut y = range.y0;
        while y <= range.y1 {
            let mut x = range.x0;
            while x <= range.x1 {
                if self.full(x, y)
                    && self.full(x.wrapping_add(pair_x), y)
                    && self.full(x, y.wrapping_add(pair_y))
                    && self.full(x.wrapping_add(pair_x), y.wrapping_add(pair_y))
                {
                    return true;
                }
                x = x.wrapping_add(1);
            }
            y = y.wrapping_add(1);
        }
        false
    }

    /// Whether a cell of a range that can hold solid is full. If the range is not in the map, it is
    /// empty, or it has a cell beyond the map, which is full.
    pub(super) fn has_full(&self, range: Range) -> bool {
        if self.holds(range.x0, range.y0) && self.holds(range.x1, range.y1) {
            return self.any_full_in_map(range, |_, _| true);
        }
        range.x0 <= range.x1 && range.y0 <= range.y1
    }

    /// Whether a full cell of a range passes a test of its corners.
    #[inline]
    pub(super) fn any_full(&self, range: Range, test: impl Fn((Raw, Raw)) -> bool) -> bool {
        if self.holds(range.x0, range.y0) && self.holds(range.x1, range.y1) {
            return self.any_full_square(range, test);
        }
        let mut cells = Cells::of(range);
        while let Some(block) = self.next_cell(&mut cells) {
            if block.kind.is_full() && test(self.extent(block.x, block.y)) {
                return true;
            }
        }
        false
    }

    /// [`any_full`](Self::any_full) for a range in the map.
    #[inline(always)]
    pub(super) fn any_full_square(&self, range: Range, test: impl Fn((Raw, Raw)) -> bool) -> bool {
        let is_square = !matches!(self.outside, Outside::Edge);
        self.any_full_in_map(range, |x, y| test(if is_square { self.grid.square(x, y) } else { self.extent(x, y) }))
    }

    /// Whether a full cell of a range in the map passes a test.
    #[inline(always)]
    pub(super) fn any_full_in_map(&self, range: Range, test: impl Fn(i32, i32) -> bool) -> bool {
        let (mut y, mut rows) = (range.y0, self.occupied_rows(range.x0, range.x1, range.y0));
        while y <= range.y1 {
            let (mut x, row) = (range.x0, self.place(0, y));
            if T::OCCUPIED {
                x = self.first_occupied(&rows, x, range.x1);
                rows.step();
            }
            while x <= range.x1 {
                if self.kinds.get(self.id_at(row.wrapping_add(x as u32))).is_full() && test(x, y) {
                    return true;
                }
                x = x.wrapping_add(1);
                if T::OCCUPIED && x <= range.x1 {
                    x = self.next_occupied(x, range.x1, y);
                }
            }
            y = y.wrapping_add(1);
        }
        false
    }
}
