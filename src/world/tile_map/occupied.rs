//! Where in a region there is anything at all.

use super::block_cells::Cells;
use super::range::Range;
use crate::shape::Aabb;
use crate::world::{Outside, Set, Store, TileMap};

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// The box around the cells of a region that are not empty; see [`World::occupied`](crate::world::World::occupied).
    pub(in crate::world) const fn occupied(&self, region: &Aabb) -> Option<Aabb> {
        self.occupied_cells(region).0
    }

    /// The same with those cells, and what is between them.
    pub(in crate::world) const fn occupied_cells(&self, region: &Aabb) -> (Option<Aabb>, Option<Cells>) {
        let range = self.open_range(region.lo(), region.hi());
        let found = match self.outside {
            Outside::Empty => self.filled(self.inside(range), Range::NOWHERE),
            // Blocks at the border stand for what is beyond it; a region that holds only that has no cell inside.
            Outside::Edge if !S::SHAPED => self.filled(self.solid_range(range), Range::NOWHERE),
            Outside::Solid | Outside::Edge => {
                let inside = self.inside(range);
                self.filled(inside, beyond(range, inside))
            }
        };
        (self.extent_of(found), Some(Cells::of(found)))
    }

    /// The cells of a range of the map that are not empty, and another range with them.
    const fn filled(&self, range: Range, mut found: Range) -> Range {
        let mut y = range.y0;
        while y <= range.y1 {
            if self.occupied.is_empty() || !self.row_is_empty(range.x0, range.x1, y) {
                let mut tile = self.place(range.x0, y);
                let mut x = range.x0;
                while x <= range.x1 {
                    if !self.kinds.get(self.id_at(tile)).is_empty() {
                        found = found.with(x, y);
                    }
                    tile = tile.wrapping_add(1);
                    x = x.wrapping_add(1);
                }
            }
            y = y.wrapping_add(1);
        }
        found
    }

    const fn extent_of(&self, found: Range) -> Option<Aabb> {
        if found.x0 > found.x1 {
            return None;
        }
        let (lo, hi) = self.extent_between((found.x0, found.y0), (found.x1, found.y1));
        Some(Aabb::from_raw_unchecked(lo, hi))
    }
}

/// The cells of a range that are beyond the map: one row or column on each side, and what is between them.
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
