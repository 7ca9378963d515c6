//! The cells of a walk against those of closed squares.

#[allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests stop at the first surprise")]
mod walk {
    extern crate std;

    use crate::num::{Fx, Vec2};
    use crate::world::grid::GridAxis;
    use crate::world::ray::walk::{Beyond, RayWalk};
    use crate::world::{Cell, Grid};
    use std::vec::Vec;

    const FAR: i128 = 1 << 40;

    /// The cells that a ray touches, grouped by the moment at which it first does. They follow from
    /// the closed intervals of time in which the ray is in their columns and rows. Moments are
    /// multiplied by both components of the motion.
    fn expected(grid: &Grid, beyond: Beyond, o: [i128; 2], d: [i128; 2]) -> Vec<Vec<Cell>> {
        let scale = d.map(|d| d.abs().max(1));
        let whole = scale[0] * scale[1];
        let interval = |axis: usize, span: &GridAxis, index: i128| {
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
        let side = |span, o, d| grid.lane_with(span, o, d, |before, last| if before { -outer } else { last + outer });
        let cell = grid.cell as u32;
        let mut walk = RayWalk::new(side(&grid.x, o[0], d[0]), side(&grid.y, o[1], d[1]), cell);
        let mut steps = Vec::new();
        loop {
            let known = |v: i32, count: u16| {
                let bands = i32::from(beyond == Beyond::Bands);
                -bands <= v && v < i32::from(count) + bands
            };
            let cells =
                (0..4).filter_map(|n| walk.cell(n)).filter(|c| known(c.0, grid.width()) && known(c.1, grid.height()));
            steps.push(sorted(cells.map(|(x, y)| Cell::of(x, y)).collect()));
            let over = grid.next_lines(&walk.x, &walk.y, beyond);
            if over == 0 {
                assert!(walk.cells <= grid.x.count + grid.y.count + 4);
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

    /// Every step has exactly the cells that are touched from then on: between all points of the
    /// half-cell lattice and one raw beside them.
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
