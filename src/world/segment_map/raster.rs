//! Which cells a segment meets, row after row, exactly and without division.

use crate::num::{Axis, Raw, imul};
use crate::world::Grid;

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
/// Read from the end with the smaller y, in the mirror where x falls: from `(u0, v0)` both coordinates grow, in the ratio of `p` and `q`.
/// Row after row, the first column is the first one whose far side is not left of where the segment enters the row, and the last is the
/// last one whose near side is not right of where it leaves; neither falls.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rows {
    row: i32,
    last_row: i32,
    /// In the mirror, if there is one.
    first: i32,
    last: i32,
    /// The column of the end.
    end: i32,
    /// `((first + 1) cell - u0) q - (row cell - v0) p`: not negative where the first column is right. A distance and a direction
    /// below 2^30 each, so that the difference is below 2^61.
    enter: i64,
    /// `((last + 1) cell - u0) q - ((row + 1) cell - v0) p`: positive where the next column is not met yet.
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
        // Where `q` is 0, `leave` is never positive and `enter` never negative: two rows at most, from end to end.
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
