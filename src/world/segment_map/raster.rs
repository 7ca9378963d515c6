//! The cells that a segment meets, exactly and without division; the cells of a query; and how many
//! solids hold the corner of each.

use super::{Kind, SegmentMap};
use crate::num::{Axis, Raw, imul};
use crate::world::cell::Range;
use crate::world::grid::{Grid, GridAxis};

/// Columns `x0..=x1` of row `y`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Row {
    pub(super) y: i32,
    pub(super) x0: i32,
    pub(super) x1: i32,
}

/// The cells whose closed square meets a segment inside the grid.
///
/// ```text
///   +---+---+---+      A line or a corner touched counts for all cells that touch it:
///   | x | x |   |      through the corner of four cells the segment meets four.
///   +---*---+---+
///   | x | x*|   |
///   +---+---+*--+
///   |   | x | x |
///   +---+---+---+
/// ```
///
/// A segment is read from the end with the smaller y, in the mirror if x falls. From `(u0, v0)`
/// both coordinates grow, in the ratio of `p` and `q`. In each row, the first column is the first
/// one whose far side is not left of where the segment enters. The last is the last one whose near
/// side is not right of where it leaves. Neither falls from row to row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rows {
    row: i32,
    last_row: i32,
    /// In the mirror, if there is one.
    first: i32,
    last: i32,
    /// The column of the end.
    end: i32,
    /// `((first + 1) cell - u0) q - (row cell - v0) p`: not negative where the first column is
    /// right. A distance and a direction are below 2^30 each, and the difference below 2^61.
    enter: i64,
    /// `((last + 1) cell - u0) q - ((row + 1) cell - v0) p`: positive where the next column is not
    /// met yet.
    leave: i64,
    /// The change of both by a column and by a row: `cell q` and `cell p`, below 2^54.
    column_step: i64,
    row_step: i64,
    /// The columns' sum in the mirror, or -1.
    mirror: i32,
}

impl Rows {
    /// The segment from `a` to `b` along `dir`: both ends in the closed grid.
    pub(super) const fn new(grid: &Grid, a: Raw, b: Raw, dir: Axis) -> Self {
        let (from, to) = if dir.y < 0 { (b, a) } else { (a, b) };
        let (mut u0, mut u1) = (from.x.wrapping_sub(grid.x.origin), to.x.wrapping_sub(grid.x.origin));
        let (v0, v1) = (from.y.wrapping_sub(grid.y.origin), to.y.wrapping_sub(grid.y.origin));
        let (columns, rows) = (grid.x.count as i32, grid.y.count as i32);
        let mut mirror = -1;
        if u1 < u0 {
            (u0, u1) = (grid.x.size.wrapping_sub(u0), grid.x.size.wrapping_sub(u1));
            mirror = columns.wrapping_sub(1);
        }
        let (p, q) = (dir.x.wrapping_abs(), dir.y.wrapping_abs());
        let (first, row) = (before(grid, u0), before(grid, v0));
        let next_x = grid.line(first.wrapping_add(1)).wrapping_sub(u0);
        let next_y = grid.line(row.wrapping_add(1)).wrapping_sub(v0);
        let (column_step, row_step) = (imul(grid.cell, q), imul(grid.cell, p));
        let leave = imul(next_x, q).wrapping_sub(imul(next_y, p));
        Self {
            row,
            last_row: at_most(grid, v1, rows),
            first,
            last: first,
            end: at_most(grid, u1, columns),
            enter: leave.wrapping_add(row_step),
            leave,
            column_step,
            row_step,
            mirror,
        }
    }

    /// The next row with its columns.
    pub(super) const fn advance(&mut self) -> Option<Row> {
        if self.row > self.last_row {
            return None;
        }
        // If `q` is 0, `leave` is never positive and `enter` never negative: two rows at most, from
        // end to end.
        while self.leave <= 0 && self.last < self.end {
            self.last = self.last.wrapping_add(1);
            self.leave = self.leave.wrapping_add(self.column_step);
        }
        while self.enter < 0 && self.first < self.last {
            self.first = self.first.wrapping_add(1);
            self.enter = self.enter.wrapping_add(self.column_step);
        }
        let y = self.row;
        self.row = y.wrapping_add(1);
        self.enter = self.enter.wrapping_sub(self.row_step);
        self.leave = self.leave.wrapping_sub(self.row_step);
        Some(if self.mirror < 0 {
            Row { y, x0: self.first, x1: self.last }
        } else {
            Row { y, x0: self.mirror.wrapping_sub(self.last), x1: self.mirror.wrapping_sub(self.first) }
        })
    }
}

/// The first index whose closed cell holds the distance `d` from the origin.
const fn before(grid: &Grid, d: i32) -> i32 {
    if d > 0 { grid.quotient(d.wrapping_sub(1) as u32) as i32 } else { 0 }
}

/// The last one.
const fn at_most(grid: &Grid, d: i32, count: i32) -> i32 {
    let index = grid.quotient(d as u32) as i32;
    if index < count { index } else { count.wrapping_sub(1) }
}

impl SegmentMap<'_> {
    /// The cells that hold the points of a closed box, each point in one. That is the cell of
    /// [`Grid::cell_at`](crate::Grid::cell_at); points on the far borders of the grid are in the
    /// last cells.
    ///
    /// That is enough to find what meets the box: a segment is referred to by every cell whose
    /// closed square it meets.
    pub(super) const fn cells(&self, lo: Raw, hi: Raw) -> Range {
        let (x0, x1) = along(&self.grid.x, lo.x, self.grid.column(lo.x), self.grid.column(hi.x));
        let (y0, y1) = along(&self.grid.y, lo.y, self.grid.row(lo.y), self.grid.row(hi.y));
        Range { x0, y0, x1, y1 }
    }

    /// [`cells`](Self::cells) of a box without its borders, for a box with area.
    pub(super) const fn open_cells(&self, lo: Raw, hi: Raw) -> Range {
        self.cells(lo, Raw { x: hi.x.wrapping_sub(1), y: hi.y.wrapping_sub(1) })
    }
}

/// The first and the last cell of the grid from `first` to `last`; none if the box begins beyond
/// the end.
const fn along(span: &GridAxis, lo: i32, first: i32, last: i32) -> (i32, i32) {
    let count = span.count as i32;
    if first == count && lo.wrapping_sub(span.origin) > span.size {
        return (0, -1);
    }
    let end = count.wrapping_sub(1);
    let first = if first < end { first } else { end };
    (if first < 0 { 0 } else { first }, if last < end { last } else { end })
}

impl SegmentMap<'_> {
    /// The winding number of a cell's reference point, from that of the cell before it in the row
    /// (0 for the first one).
    ///
    /// ```text
    ///       ^ e          ^ e: +1 further left    The reference point R of a cell is its corner, moved right by an infinitesimal and
    ///   R---|---R   and  |       -1 right of e   up by a much smaller one. On the way from R to R there is what crosses the line
    ///                  solid left, y up          between the corners, the right one included and the left one not.
    /// ```
    ///
    /// Every segment that crosses the line before a corner meets the closed square of the cell
    /// before it.
    pub(super) const fn next_winding(&self, x: i32, y: i32, before: i32) -> i32 {
        let left = Raw { x: self.grid.x.origin.wrapping_add(self.grid.line(x)), y: self.grid.line_y(y) };
        if x == 0 {
            return self.passed(0, y, left);
        }
        let cell = x.wrapping_sub(1);
        let start = Raw { x: left.x.wrapping_sub(self.grid.cell), ..left };
        before.wrapping_add(self.passed(cell, y, left)).wrapping_sub(self.passed(cell, y, start))
    }

    /// The change of the winding number at segments of a cell that cross the height of `r`, from
    /// left to right. Only crossings at `r` or before it count.
    ///
    /// Just above `r`, segments that end at its height from below are gone, and those that start
    /// there upward have begun. The slope of a segment moves its crossing by a part of the smaller
    /// infinitesimal only: one exactly at `r` has been passed.
    const fn passed(&self, x: i32, y: i32, r: Raw) -> i32 {
        let mut sum = 0i32;
        let mut refs = self.refs(x, y);
        while let Some(index) = refs.advance() {
            let seg = self.segment(index);
            let (before, after) = (seg.a.y <= r.y, seg.b().y <= r.y);
            if before == after || !matches!(seg.kind, Kind::Solid) {
                continue;
            }
            // Positive if r is on the left of the segment. Upward, the ray does not pass it.
            // Downward it does.
            let side = Raw { x: seg.dir.x, y: seg.dir.y }.cross(r.sub(seg.a));
            if before && side <= 0 {
                sum = sum.wrapping_sub(1);
            } else if after && side >= 0 {
                sum = sum.wrapping_add(1);
            }
        }
        sum
    }
}
