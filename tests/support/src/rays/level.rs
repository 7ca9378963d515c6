//! A level of every shape, as the cells of the plane.

use super::solid::{Exact, Point, Solid, exact, small};
use crate::Random;
use tilesat::{AllShapes, Fx, Grid, Outside, TileKind, TileKinds, TileMap, TileShape, Vec2};

/// Beyond every coordinate of the domain.
const FAR: i64 = 1 << 33;

/// Ids are shapes; from 64 on the same with flags.
pub static KINDS: TileKinds = {
    let mut kinds = TileKinds::EMPTY;
    let mut id = 0;
    while id < 38 {
        let kind = TileKind::of(TileShape::ALL[id as usize]);
        kinds = kinds.with(id, kind).with(id + 64, kind.with_flags(id + 64));
        id += 1;
    }
    kinds
};

#[derive(Clone, Debug)]
pub struct Cell {
    pub column: i64,
    pub row: i64,
    pub lo: Point,
    pub hi: Point,
    /// The shape, as an id of N++ without flags.
    pub id: u8,
    pub solid: Solid,
}

impl Cell {
    fn holds(&self, p: &Exact) -> bool {
        let (lo, hi) = (exact(self.lo), exact(self.hi));
        lo.0 <= p.0 && p.0 <= hi.0 && lo.1 <= p.1 && p.1 <= hi.1
    }
}

#[derive(Clone, Debug)]
pub struct Level {
    pub width: i64,
    pub height: i64,
    pub cell: i64,
    pub origin: Point,
    pub outside: Outside,
    pub tiles: Vec<u8>,
}

pub const OUTSIDES: [Outside; 3] = [Outside::Empty, Outside::Solid, Outside::Edge];

/// Sides of cells: powers of two, multiples of ten (tangents at Pythagorean points), odd multiples
/// of two, the limits.
const CELLS: [i64; 10] =
    [1 << 20, 1 << 8, 300, 16 << 16, 1 << 24, (1 << 24) - 2, 10 * 65_001, 2 * 7 * 64, 2 * 50_021, 650];

impl Level {
    /// A level of up to 5 x 5 cells of a few shapes, anywhere in the domain.
    pub fn random(random: &mut Random) -> Self {
        let (width, height) = (random.within(1, 5), random.within(1, 5));
        let cell = CELLS[random.below(CELLS.len() as i64) as usize];
        let origin = |random: &mut Random, count: i64| {
            let (lowest, highest) = (1 - (1i64 << 29), (1 << 29) - 1 - count * cell);
            match random.below(5) {
                0 => 0,
                1 => -cell * random.within(1, count),
                2 => random.within(lowest, highest),
                3 => highest,
                _ => random.around(4 * cell).clamp(lowest, highest),
            }
        };
        let origin = (origin(random, width), origin(random, height));
        let outside = OUTSIDES[random.below(3) as usize];
        let palette: Vec<u8> = (0..random.within(1, 6)).map(|_| random.within(1, 37) as u8).collect();
        let density = random.within(2, 10);
        let tile = |random: &mut Random| match random.below(12) {
            n if n >= density + 2 => 0,
            0 | 1 => random.within(0, 37) as u8,
            _ => palette[random.below(palette.len() as i64) as usize],
        };
        let tiles = (0..width * height).map(|_| tile(random) + if random.one_in(3) { 64 } else { 0 }).collect();
        Self { width, height, cell, origin, outside, tiles }
    }

    pub fn map(&self) -> TileMap<'_, AllShapes> {
        let origin = Vec2::from_raw(self.origin.0 as i32, self.origin.1 as i32);
        let grid = Grid::new(self.width as u16, self.height as u16, Fx::from_bits(self.cell as i32), origin).unwrap();
        TileMap::<AllShapes>::of(&self.tiles, grid, &KINDS).unwrap().with_outside(self.outside)
    }

    pub fn end(&self) -> Point {
        (self.origin.0 + self.width * self.cell, self.origin.1 + self.height * self.cell)
    }

    /// The shape of any cell; beyond the map a block, a half, a one-way edge or nothing.
    fn id(&self, column: i64, row: i64) -> u8 {
        let (c, r) = (column.clamp(0, self.width - 1), row.clamp(0, self.height - 1));
        let id = self.tiles[(r * self.width + c) as usize] % 64;
        match self.outside {
            _ if (c, r) == (column, row) => id,
            Outside::Empty => 0,
            Outside::Solid => 1,
            Outside::Edge => {
                // In a cell of side 4 each half of an edge has its own middle.
                let solid = Solid::of(id, (0, 0), (4, 4));
                let covers = |p| solid.covers(&exact(p));
                let across = |v: i64, inner: i64| if v < inner { 0 } else { 4 };
                let (x, y) = (across(column, c), across(row, r));
                if c != column && r != row {
                    // The halves that meet in the corner.
                    let near = |v: i64| i64::midpoint(v, 2);
                    return u8::from(covers((x, near(y))) && covers((near(x), y)));
                }
                let (first, second, halves, along) = if r == row {
                    (covers((x, 1)), covers((x, 3)), (2, 4), [34, 36])
                } else {
                    (covers((1, y)), covers((3, y)), (5, 3), [35, 37])
                };
                match (first, second) {
                    (true, true) => 1,
                    (true, false) => halves.0,
                    (false, true) => halves.1,
                    _ if along.contains(&id) => id,
                    _ => 0,
                }
            }
        }
    }

    /// Every cell of the map, and around it bands to the end of the plane: together they cover it.
    pub fn cells(&self) -> Vec<Cell> {
        let side = |i: i64, origin: i64, count: i64| {
            let lo = if i < 0 { -FAR } else { origin + i * self.cell };
            let hi = if i >= count { FAR } else { origin + (i + 1) * self.cell };
            (lo, hi)
        };
        let mut out = Vec::new();
        for row in -1..=self.height {
            for column in -1..=self.width {
                let (x, y) = (side(column, self.origin.0, self.width), side(row, self.origin.1, self.height));
                let (lo, hi, id) = ((x.0, y.0), (x.1, y.1), self.id(column, row));
                out.push(Cell { column, row, lo, hi, id, solid: Solid::of(id, lo, hi) });
            }
        }
        out
    }
}

/// Whether a point beside `o` is strictly inside the union of the solids: whether sixteen points
/// around it, much nearer than anything else, are in the solid. Eight of them are almost on the
/// axes, so that one lies in a cusp between an arc and a line.
pub fn is_inside(cells: &[Cell], o: Point, p: &Exact) -> bool {
    let reach = |c: &&Cell| c.lo.0 <= o.0 && o.0 <= c.hi.0 && c.lo.1 <= o.1 && o.1 <= c.hi.1;
    let cells: Vec<&Cell> = cells.iter().filter(reach).collect();
    let (near, third, nearer) = (small(300, false), small(300, true), small(900, false));
    [(&near, &third), (&third, &near), (&near, &nearer), (&nearer, &near)].iter().all(|(a, b)| {
        [(1, 1), (1, -1), (-1, 1), (-1, -1)].iter().all(|&(i, j)| {
            let q = (&p.0 + *a * i, &p.1 + *b * j);
            cells.iter().any(|c| c.holds(&q) && c.solid.covers(&q))
        })
    })
}
