//! The walk of a ray over the cells of any grid, by the closed rule: no cell that has a point in common with the ray is missed.

use super::dda::{Axes, Side, X, Y, along, lead};
use crate::world::grid::{Grid, Span};

/// What a walk does at the border of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::world) enum Beyond {
    /// Nothing is beyond: the walk ends where it leaves the grid.
    Nothing,
    /// The bands around the grid are cells of their own, -1 and the count.
    Bands,
    /// The bands are part of the border cells.
    Merged,
}

impl Grid {
    /// Measures one axis of a ray on a grid whose bands are cells.
    pub(in crate::world) fn ray_side(&self, span: &Span, o: i32, d: i32) -> Side {
        self.side_with(span, o, d, |before, last| if before { -1 } else { last.wrapping_add(1) })
    }

    /// The axes of the lines that a ray crosses next, both at a corner; 0 where nothing ahead matters, or the motion ends before.
    #[inline]
    pub(in crate::world) fn next_lines(&self, x: &Side, y: &Side, beyond: Beyond) -> Axes {
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
        // The motion ends before the next line, or leaves the grid; or the last column reaches to the end of the domain, so that only rows
        // change from here (or the other way round).
        if over == 0 && !matches!(beyond, Beyond::Nothing) { lines } else { over }
    }
}

/// Whether a line is ahead, with a cell behind it that matters: of those beyond the map, only bands do.
#[inline(never)]
fn leads_on(side: &Side, count: u16, beyond: Beyond) -> bool {
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
/// The cells of a step (`c`, and `b` at a corner) are those that the ray has a point in common with from now on and had not before. At the start
/// that includes those behind a line on which it starts.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Walk {
    pub(in crate::world) x: Side,
    pub(in crate::world) y: Side,
    /// Cells entered, the first and the last included.
    pub(in crate::world) cells: u32,
    /// The axes on which the cells before the last line belong to this step too.
    wide: Axes,
    /// Whether the cell before both lines does.
    back: bool,
}

impl Walk {
    pub(in crate::world) fn new(x: Side, y: Side, cell: u32) -> Self {
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

    /// Goes on over lines behind all of which there is nothing.
    pub(in crate::world) fn jump(&mut self, columns: u32, rows: u32, cell: u32) {
        if columns | rows != 0 {
            self.x = self.x.crossed(columns, cell);
            self.y = self.y.crossed(rows, cell);
            self.cells = self.cells.wrapping_add(columns).wrapping_add(rows);
            self.wide = 0;
        }
    }

    /// The cell of the step by its number, below 4: 0 is the one ahead, 1 and 2 are beside it (at a corner the one that is across rows alone, and
    /// the one across columns alone), 3 is behind both lines.
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

    /// At the start: whether something holds in all cells that the start touches or, with a motion, in all that the ray is in just after.
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

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests stop at the first surprise")]
mod tests {
    extern crate std;

    use super::{Beyond, Walk};
    use crate::num::{Fx, Vec2};
    use crate::world::{Cell, Grid};
    use std::vec::Vec;

    const FAR: i128 = 1 << 40;

    /// The cells that a ray touches, grouped by the moment at which it first does: from the closed intervals of time in which it is in their columns and
    /// rows. Moments are multiplied by both components of the motion.
    fn expected(grid: &Grid, beyond: Beyond, o: [i128; 2], d: [i128; 2]) -> Vec<Vec<Cell>> {
        let scale = d.map(|d| d.abs().max(1));
        let whole = scale[0] * scale[1];
        let interval = |axis: usize, span: &super::Span, index: i128| {
            let count = i128::from(span.count);
            let (first, last) = match beyond {
                Beyond::Merged => (index == 0, index == count - 1),
                _ => (index < 0, index == count),
            };
            let line = |i: i128| i128::from(span.origin) + i * i128::from(grid.cell);
            let lo = if first { -FAR } else { line(index) };
            let hi = if last { FAR } else { line(index + 1) };
            let (o, d) = (o[axis], d[axis]);
            if d == 0 {
                return (lo <= o && o <= hi).then_some((0, whole));
            }
            let other = scale[1 - axis];
            let (from, to) = if d > 0 { (lo - o, hi - o) } else { (o - hi, o - lo) };
            Some((from * other, to * other))
        };
        let outer = i128::from(beyond == Beyond::Bands);
        let mut found = Vec::new();
        for y in -outer..i128::from(grid.y.count) + outer {
            for x in -outer..i128::from(grid.x.count) + outer {
                let (Some(a), Some(b)) = (interval(0, &grid.x, x), interval(1, &grid.y, y)) else { continue };
                let (from, to) = (a.0.max(b.0).max(0), a.1.min(b.1).min(whole));
                if from <= to {
                    found.push((from, Cell::of(x as i32, y as i32)));
                }
            }
        }
        found.sort_by_key(|f| f.0);
        found.chunk_by(|a, b| a.0 == b.0).map(|group| sorted(group.iter().map(|f| f.1).collect())).collect()
    }

    fn sorted(mut cells: Vec<Cell>) -> Vec<Cell> {
        cells.sort_by_key(|c| (c.y, c.x));
        cells
    }

    fn walked(grid: &Grid, beyond: Beyond, o: [i32; 2], d: [i32; 2]) -> Vec<Vec<Cell>> {
        let outer = i32::from(beyond != Beyond::Merged);
        let side = |span, o, d| grid.side_with(span, o, d, |before, last| if before { -outer } else { last + outer });
        let cell = grid.cell as u32;
        let mut walk = Walk::new(side(&grid.x, o[0], d[0]), side(&grid.y, o[1], d[1]), cell);
        let mut steps = Vec::new();
        loop {
            let known = |v: i32, count: u16| {
                let bands = i32::from(beyond == Beyond::Bands);
                -bands <= v && v < i32::from(count) + bands
            };
            let cells =
                (0..4).filter_map(|n| walk.cell(n)).filter(|c| known(c.0, grid.x.count) && known(c.1, grid.y.count));
            steps.push(sorted(cells.map(|(x, y)| Cell::of(x, y)).collect()));
            let over = grid.next_lines(&walk.x, &walk.y, beyond);
            if over == 0 {
                assert!(walk.cells <= u32::from(grid.x.count) + u32::from(grid.y.count) + 4);
                steps.retain(|s| !s.is_empty());
                return steps;
            }
            walk.cross(over, cell);
        }
    }

    fn check(grid: &Grid, o: [i32; 2], end: [i32; 2]) {
        let d = [end[0] - o[0], end[1] - o[1]];
        for beyond in [Beyond::Nothing, Beyond::Bands, Beyond::Merged] {
            let expected = expected(grid, beyond, o.map(i128::from), d.map(i128::from));
            assert_eq!(walked(grid, beyond, o, d), expected, "{grid:?} {beyond:?} from {o:?} by {d:?}");
        }
    }

    /// Every step has exactly the cells that are touched from then on: between all points of the half-cell lattice and one raw beside them.
    #[test]
    fn cells_are_those_of_the_closed_squares() {
        for (width, height, cell) in [(2, 2, 300), (3, 1, 256), (1, 2, 2 * 7 * 64)] {
            let grid = Grid::new(width, height, Fx::from_bits(cell), Vec2::from_raw(-cell, 5)).unwrap();
            let lattice = |n: i32, origin: i32| [-1, 0, 1].map(|by| origin + (n - 1) * cell / 2 + by);
            let (xs, ys): (Vec<i32>, Vec<i32>) = (
                (0..2 * i32::from(width) + 3).flat_map(|n| lattice(n, -cell)).collect(),
                (0..2 * i32::from(height) + 3).flat_map(|n| lattice(n, 5)).collect(),
            );
            let points: Vec<[i32; 2]> = ys.iter().flat_map(|&y| xs.iter().map(move |&x| [x, y])).collect();
            for &o in points.iter().step_by(2) {
                for &end in points.iter().skip(o[0].unsigned_abs() as usize % 3).step_by(3) {
                    check(&grid, o, end);
                }
            }
        }
    }

    /// Long rays over large grids, and from one end of the domain to the other.
    #[test]
    fn cells_are_those_of_the_closed_squares_far_away() {
        let mut seed = 1u64;
        let mut random = |n: i32| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((i64::from((seed >> 33) as u32) * i64::from(n)) >> 31) as i32
        };
        for _ in 0..3000 {
            let cell = [256, 1 << 20, 1_048_578, 1 << 24, 100_042][random(5) as usize];
            let (width, height) = (1 + random(20), 1 + random(20));
            let origin = [random(1 << 27) - (1 << 26), random(1 << 27) - (1 << 26)];
            let grid =
                Grid::new(width as u16, height as u16, Fx::from_bits(cell), Vec2::from_raw(origin[0], origin[1]))
                    .unwrap();
            let mut point = || {
                let near = |random: &mut dyn FnMut(i32) -> i32, origin: i32, count: i32| match random(4) {
                    0 => random((1 << 30) - 1) - (1 << 29) + 1,
                    1 => origin + cell * random(count + 1),
                    2 => origin + cell / 2 * random(2 * count + 1) + random(3) - 1,
                    _ => origin + random(cell * count),
                };
                [near(&mut random, origin[0], width), near(&mut random, origin[1], height)]
            };
            let (a, b) = (point(), point());
            check(&grid, a, b);
        }
    }
}
