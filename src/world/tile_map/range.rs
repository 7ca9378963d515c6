//! Which cells a box of coordinates reaches.

use crate::num::Raw;
use crate::world::{Outside, Set, Store, TileMap};

/// Columns `x0..=x1` of rows `y0..=y1`; empty where a first is above its last.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Range {
    pub(in crate::world) x0: i32,
    pub(in crate::world) y0: i32,
    pub(in crate::world) x1: i32,
    pub(in crate::world) y1: i32,
}

impl Range {
    pub(in crate::world) const NONE: Self = Self { x0: 0, y0: 0, x1: -1, y1: -1 };

    /// Without a cell, to be [widened](Self::with).
    pub(in crate::world) const NOWHERE: Self = Self { x0: i32::MAX, y0: i32::MAX, x1: i32::MIN, y1: i32::MIN };

    /// Widened to a cell.
    #[inline]
    pub(in crate::world) const fn with(self, x: i32, y: i32) -> Self {
        Self {
            x0: if x < self.x0 { x } else { self.x0 },
            y0: if y < self.y0 { y } else { self.y0 },
            x1: if x > self.x1 { x } else { self.x1 },
            y1: if y > self.y1 { y } else { self.y1 },
        }
    }

    #[inline]
    pub(in crate::world) const fn has_row(&self, y: i32) -> bool {
        self.y0 <= y && y <= self.y1
    }

    /// The columns, less those of a range that a box has left, both ways without going back.
    #[inline(never)]
    pub(in crate::world) const fn row_without(&self, seen: &Self) -> (i32, i32) {
        if seen.x0 <= self.x0 {
            (if seen.x1 < self.x0 { self.x0 } else { seen.x1.wrapping_add(1) }, self.x1)
        } else {
            (self.x0, if seen.x0 > self.x1 { self.x1 } else { seen.x0.wrapping_sub(1) })
        }
    }
}

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// The cells whose closed square meets the closed box: `ceil(lo / cell) - 1` is the column of `lo - 1`.
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

    /// The cells of a range that can hold solid: where the border is repeated, border blocks stand for the bands beyond them, shaped ones
    /// have bands of their own; there is nothing outside where that is empty.
    pub(in crate::world) const fn solid_range(&self, r: Range) -> Range {
        match self.outside {
            Outside::Solid => r,
            Outside::Edge if S::SHAPED => r,
            Outside::Empty => self.inside(r),
            Outside::Edge => {
                let (last_x, last_y) = (self.grid.x.count as i32 - 1, self.grid.y.count as i32 - 1);
                let r = self.inside(r);
                Range {
                    x0: if r.x0 > last_x { last_x } else { r.x0 },
                    y0: if r.y0 > last_y { last_y } else { r.y0 },
                    x1: if r.x1 < 0 { 0 } else { r.x1 },
                    y1: if r.y1 < 0 { 0 } else { r.y1 },
                }
            }
        }
    }
}
