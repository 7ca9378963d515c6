//! Walks over the cells of a range that have a shape.

use super::range::Range;
use crate::num::Raw;
use crate::world::{Set, Store, TileKind, TileMap};

/// A walk over the cells of a range, row after row.
///
/// Public in a private module, because a sealed trait names it.
#[derive(Clone, Copy, Debug)]
pub struct Walk {
    /// The cell that it has come to.
    pub(super) x: i32,
    pub(super) y: i32,
    /// What that is.
    pub(super) kind: TileKind,
    /// Its place in the map's data, where all of the range is in the map.
    tile: u32,
    in_map: bool,
    /// The last column of its row.
    last: i32,
    range: Range,
    /// Cells that are passed over: those of a box that `range` has left.
    seen: Range,
}

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// A walk over the cells of a range, less those of a box that the range has left.
    #[inline]
    pub(super) const fn walk_of(&self, range: Range, seen: Range) -> Walk {
        let in_map = self.holds(range.x0, range.y0) && self.holds(range.x1, range.y1);
        // Before the first row, whose columns are over.
        let y = range.y0.wrapping_sub(1);
        Walk { x: 0, y, kind: TileKind::EMPTY, tile: 0, in_map, last: -1, range, seen }
    }

    /// Goes on to the next cell of a walk that has a shape; false where none is left.
    #[inline(never)]
    pub(super) const fn walk(&self, walk: &mut Walk) -> bool {
        if !walk.in_map {
            return self.walk_beyond(walk);
        }
        let (mut x, mut y, mut last, mut tile) = (walk.x, walk.y, walk.last, walk.tile);
        loop {
            while x < last {
                (x, tile) = (x.wrapping_add(1), tile.wrapping_add(1));
                let id = self.id_at(tile);
                if !self.kinds.is_empty(id) {
                    (walk.x, walk.y, walk.last, walk.tile) = (x, y, last, tile);
                    walk.kind = self.kinds.get(id);
                    return true;
                }
            }
            if y >= walk.range.y1 {
                return false;
            }
            y = y.wrapping_add(1);
            (x, last) = self.before_row(walk, y);
            tile = self.place(x, y);
        }
    }

    /// The column before the first one of a row of a walk, and the last.
    #[inline]
    const fn before_row(&self, walk: &Walk, y: i32) -> (i32, i32) {
        let range = &walk.range;
        let (x, last) = if walk.seen.has_row(y) { range.row_without(&walk.seen) } else { (range.x0, range.x1) };
        let empty = walk.in_map && x <= last && self.known_empty(x, last, y);
        (if empty { last } else { x.wrapping_sub(1) }, last)
    }

    /// The same where some of the range is not in the map.
    #[inline(never)]
    const fn walk_beyond(&self, walk: &mut Walk) -> bool {
        loop {
            while walk.x < walk.last {
                walk.x = walk.x.wrapping_add(1);
                walk.kind = self.kind_at(walk.x, walk.y);
                if !walk.kind.is_empty() {
                    return true;
                }
            }
            if walk.y >= walk.range.y1 {
                return false;
            }
            walk.y = walk.y.wrapping_add(1);
            (walk.x, walk.last) = self.before_row(walk, walk.y);
        }
    }

    /// The corners of the cell that a walk has come to.
    #[inline]
    pub(super) const fn corners(&self, walk: &Walk) -> (Raw, Raw) {
        if S::SHAPED && walk.in_map { self.grid.square(walk.x, walk.y) } else { self.extent(walk.x, walk.y) }
    }
}
