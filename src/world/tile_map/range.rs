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

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// The cells whose closed square meets the closed box: `ceil(lo / cell) - 1` is the column of `lo - 1`.
    pub(in crate::world) const fn closed_range(&self, lo: Raw, hi: Raw) -> Range {
        Range {
            x0: self.grid.column(lo.x.wrapping_sub(1)),
            y0: self.grid.row(lo.y.wrapping_sub(1)),
            x1: self.grid.column(hi.x),
            y1: self.grid.row(hi.y),
        }
    }

    /// The cells whose open square meets the open box, for a box with area.
    pub(in crate::world) const fn open_range(&self, lo: Raw, hi: Raw) -> Range {
        Range {
            x0: self.grid.column(lo.x),
            y0: self.grid.row(lo.y),
            x1: self.grid.column(hi.x.wrapping_sub(1)),
            y1: self.grid.row(hi.y.wrapping_sub(1)),
        }
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
