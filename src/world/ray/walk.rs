//! The walk of a ray over the cells of any grid, exactly and without division.
//!
//! By the closed rule: no cell that has a point in common with the ray is missed.

use crate::num::umul;
use crate::world::grid::{Grid, GridAxis};

/// One axis of a ray on its way.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Lane {
    /// The index of the cell: the one just ahead, where the ray is on a line. -1 and the count
    /// stand for the bands beyond the map.
    pub(in crate::world) cell: i32,
    /// 1 or -1; -1 if there is no motion.
    pub(in crate::world) step: i32,
    /// Distance from the start to the next line, if there is one: below 2^31.
    pub(in crate::world) near: u32,
    /// At least the number of lines ahead, up to the end, that have a cell of the map behind them.
    pub(in crate::world) lines: i32,
    /// The size of the motion, below 2^30.
    pub(in crate::world) size: u32,
}

impl Lane {
    /// A coordinate moved along the ray.
    #[inline]
    pub(in crate::world) fn ahead(&self, v: i32, by: u32) -> i32 {
        v.wrapping_add(self.step.wrapping_mul(by as i32))
    }

    /// After `n` more lines.
    #[inline]
    pub(in crate::world) fn crossed(self, n: u32, cell: u32) -> Self {
        let near = self.near.wrapping_add(n.wrapping_mul(cell));
        Self { cell: self.ahead(self.cell, n), near, lines: self.lines.wrapping_sub(n as i32), ..self }
    }

    /// At the start, and always without motion: whether the start is on a line, where it touches
    /// the cell before the first one too. True for some starts in a band as well, where both cells
    /// are beyond the map.
    #[inline]
    pub(in crate::world) fn on_line(&self, cell: u32) -> bool {
        self.near == cell
    }
}

/// A set of axes: 1 for the lines between columns, 2 for those between rows.
pub(in crate::world) type Axes = u32;

pub(in crate::world) const X: Axes = 1;
pub(in crate::world) const Y: Axes = 2;

/// The difference of the times of the next two crossings times both sizes: below 2^61.
#[inline]
pub(in crate::world) fn lead(x: &Lane, y: &Lane) -> i64 {
    umul(x.near, y.size).wrapping_sub(umul(y.near, x.size)) as i64
}

/// Axes on whose lines the ray runs: it is in two cells at any time.
#[inline]
pub(in crate::world) fn along(x: &Lane, y: &Lane, cell: u32) -> Axes {
    let columns = if x.size == 0 && x.on_line(cell) { X } else { 0 };
    columns | if y.size == 0 && y.on_line(cell) { Y } else { 0 }
}

/// How a walk treats the border of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::world) enum Beyond {
    /// Nothing is beyond: the walk ends where it leaves the grid.
    Nothing,
    /// The bands around the grid are separate cells, -1 and the count.
    Bands,
    /// The bands are part of the border cells.
    Merged,
}

impl Grid {
    /// Measures one axis of a ray. `beyond` gives the index of a cell beyond the grid, from whether
    /// it is before the grid and from the last cell.
    #[inline]
    pub(in crate::world) fn lane_with(
        &self,
        span: &GridAxis,
        o: i32,
        d: i32,
        beyond: impl FnOnce(bool, i32) -> i32,
    ) -> Lane {
        // A motion toward smaller coordinates (or none) is one toward larger ones in the mirror: a
        // point on a line belongs to the cell ahead.
        let u = o.wrapping_sub(span.origin);
        let v = if d > 0 { u } else { span.size.wrapping_sub(u) };
        let last = (span.count as i32).wrapping_sub(1);
        let mut cell = self.quotient(v as u32) as i32;
        if v as u32 >= span.size as u32 {
            cell = beyond(v < 0, last);
        }
        let size = d.unsigned_abs();
        // Divides by a power of two that the cell is not below, and rounds up: never too few.
        let some = (size >> (self.log & 31)).wrapping_add(1) as i32;
        let room = last.wrapping_sub(cell);
        Lane {
            cell: if d > 0 { cell } else { room },
            step: if d > 0 { 1 } else { -1 },
            near: self.line(cell.wrapping_add(1)).wrapping_sub(v) as u32,
            lines: if some < room { some } else { room },
            size,
        }
    }

    /// Measures one axis of a ray on a grid whose bands are cells.
    pub(in crate::world) fn ray_lane(&self, span: &GridAxis, o: i32, d: i32) -> Lane {
        self.lane_with(span, o, d, |before, last| if before { -1 } else { last.wrapping_add(1) })
    }

    /// The axes of the lines that a ray crosses next, both at a corner; 0 where nothing ahead
    /// matters, or the motion ends before.
    #[inline]
    pub(in crate::world) fn next_lines(&self, x: &Lane, y: &Lane, beyond: Beyond) -> Axes {
        let mut lines = 0;
        if leads_on(x, self.x.count, beyond) {
            lines |= X;
        }
        if leads_on(y, self.y.count, beyond) {
            lines |= Y;
        }
        let over = lines
            & match lead(x, y).signum() {
                -1 => X,
                0 => X | Y,
                _ => Y,
            };
        // The motion ends before the next line, or leaves the grid. Or the last column reaches to
        // the end of the domain, and only rows change from here (or the other way round).
        if over == 0 && !matches!(beyond, Beyond::Nothing) { lines } else { over }
    }
}

/// Whether a line is ahead, with a cell behind it that matters: of those beyond the map, only bands
/// do.
#[inline(never)]
fn leads_on(side: &Lane, count: u32, beyond: Beyond) -> bool {
    let last = (count as i32).wrapping_sub(1);
    let room = if side.step > 0 { last.wrapping_sub(side.cell) } else { side.cell };
    side.near <= side.size && room.wrapping_add(matches!(beyond, Beyond::Bands) as i32) > 0
}

/// A ray on its way over a grid.
///
/// ```text
///   start on a corner     over one line     over a corner     along a line
///        c | c               |                | b | c            | c
///        --o--            o--+-> c            |---x---         o-+-->
///        c | c               |                a/  | b            | c
/// ```
///
/// The cells of a step are `c`, and `b` at a corner. From now on the ray has a point in them, and
/// it had none before. At the start that includes the cells behind a line on which it starts.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct RayWalk {
    pub(in crate::world) x: Lane,
    pub(in crate::world) y: Lane,
    /// Cells entered, the first and the last included.
    pub(in crate::world) cells: u32,
    /// The axes on which the cells before the last line belong to this step too.
    wide: Axes,
    /// Whether the cell before both lines does.
    back: bool,
}

impl RayWalk {
    pub(in crate::world) fn new(x: Lane, y: Lane, cell: u32) -> Self {
        let (columns, rows) = (if x.on_line(cell) { X } else { 0 }, if y.on_line(cell) { Y } else { 0 });
        Self { x, y, cells: 1, wide: columns | rows, back: true }
    }

    /// The fraction of the motion at the next line of one of these axes: below 2^31 / 2^30.
    #[inline]
    pub(in crate::world) fn time(&self, over: Axes) -> (u32, u32) {
        if over & X != 0 { (self.x.near, self.x.size) } else { (self.y.near, self.y.size) }
    }

    /// Crosses lines that [`next_lines`](Grid::next_lines) has named.
    pub(in crate::world) fn cross(&mut self, over: Axes, cell: u32) {
        self.x = self.x.crossed(over & X, cell);
        self.y = self.y.crossed(over >> 1, cell);
        self.cells = self.cells.wrapping_add(over & X).wrapping_add(over >> 1);
        self.wide = if over == X | Y { over } else { along(&self.x, &self.y, cell) };
        self.back = false;
    }

    /// Continues over lines that have nothing behind them.
    pub(in crate::world) fn jump(&mut self, columns: u32, rows: u32, cell: u32) {
        if columns | rows != 0 {
            self.x = self.x.crossed(columns, cell);
            self.y = self.y.crossed(rows, cell);
            self.cells = self.cells.wrapping_add(columns).wrapping_add(rows);
            self.wide = 0;
        }
    }

    /// The cell of the step by its number, below 4. 0 is the one ahead, 1 and 2 are beside it, 3 is
    /// behind both lines. At a corner, 1 is across rows alone and 2 across columns alone.
    #[inline]
    pub(in crate::world) fn cell(&self, number: u32) -> Option<(i32, i32)> {
        if number == X | Y && !self.back { None } else { self.neighbour(number, self.wide) }
    }

    /// The cell with a number, if these axes have two.
    fn neighbour(&self, number: u32, wide: Axes) -> Option<(i32, i32)> {
        if number & !wide != 0 {
            return None;
        }
        let x = if number & X != 0 { self.x.cell.wrapping_sub(self.x.step) } else { self.x.cell };
        let y = if number & Y != 0 { self.y.cell.wrapping_sub(self.y.step) } else { self.y.cell };
        Some((x, y))
    }

    /// Whether something holds in all cells that the start touches. With `just_after`, only the
    /// cells count that the ray is in just after the start.
    pub(in crate::world) fn all_at_start(&self, just_after: bool, cell: u32, test: impl Fn(i32, i32) -> bool) -> bool {
        let wide = if just_after { along(&self.x, &self.y, cell) } else { self.wide };
        let mut number = 4u32;
        while number != 0 {
            number = number.wrapping_sub(1);
            if let Some((x, y)) = self.neighbour(number, wide) {
                if !test(x, y) {
                    return false;
                }
            }
        }
        true
    }
}
