//! A level as plain cells.

use super::P;
use super::body::{Body, vec2};
use tilesat::{Fx, Grid, Outside, TileKind, TileKinds, TileMap};

pub const SOLID: u8 = b'#';
pub const DEADLY: u8 = b'%';
pub const ONE_WAY: u8 = b'-';
pub const COIN: u8 = b'o';

pub static KINDS: TileKinds = TileKinds::EMPTY
    .with(SOLID, TileKind::FULL)
    .with(DEADLY, TileKind::FULL.with_flags(4))
    .with(ONE_WAY, TileKind::ONE_WAY_UP.with_flags(2))
    .with(COIN, TileKind::EMPTY.with_flags(8));

/// Cells row after row, numbered from (0, 0) at the origin.
#[derive(Clone, Debug)]
pub struct Level {
    pub tiles: Vec<u8>,
    pub width: i64,
    pub height: i64,
    pub cell: i64,
    pub origin: P,
    pub outside: Outside,
}

impl Level {
    /// Rows of text, the same length each; `cell` is raw. Nothing outside.
    pub fn new(rows: &[&str], cell: i64) -> Self {
        let tiles: Vec<u8> = rows.iter().flat_map(|row| row.bytes()).collect();
        let (width, height) = (rows[0].len() as i64, rows.len() as i64);
        assert_eq!(tiles.len() as i64, width * height, "ragged level");
        Self { tiles, width, height, cell, origin: (0, 0), outside: Outside::Empty }
    }

    pub fn with_origin(mut self, origin: P) -> Self {
        self.origin = origin;
        self
    }

    pub fn with_outside(mut self, outside: Outside) -> Self {
        self.outside = outside;
        self
    }

    pub fn map(&self) -> TileMap<'_> {
        let cell = Fx::from_bits(i32::try_from(self.cell).unwrap());
        let grid = Grid::new(self.width as u16, self.height as u16, cell, vec2(self.origin)).unwrap();
        TileMap::on_grid(&self.tiles, grid, &KINDS).unwrap().with_outside(self.outside)
    }

    /// The tile of any cell. Repeats a repeated border, but not one-way edges above and below the
    /// map.
    pub fn tile(&self, x: i64, y: i64) -> u8 {
        let (cx, cy) = (x.clamp(0, self.width - 1), y.clamp(0, self.height - 1));
        let tile = self.tiles[(cy * self.width + cx) as usize];
        if (cx, cy) == (x, y) {
            return tile;
        }
        match self.outside {
            Outside::Empty => b'.',
            Outside::Solid => SOLID,
            Outside::Edge if tile == ONE_WAY && cy != y => b'.',
            Outside::Edge => tile,
        }
    }

    pub fn flags(&self, x: i64, y: i64) -> u8 {
        let beyond = x < 0 || y < 0 || x >= self.width || y >= self.height;
        if beyond && self.outside != Outside::Edge { 0 } else { KINDS.get(self.tile(x, y)).flags }
    }

    pub fn full(&self, x: i64, y: i64) -> bool {
        matches!(self.tile(x, y), SOLID | DEADLY)
    }

    /// Whether the cell has a one-way face.
    pub fn one_way(&self, x: i64, y: i64) -> bool {
        self.tile(x, y) == ONE_WAY && !self.full(x, y - 1)
    }

    /// The corners of a cell.
    pub fn square(&self, x: i64, y: i64) -> (P, P) {
        let lo = (self.origin.0 + x * self.cell, self.origin.1 + y * self.cell);
        (lo, (lo.0 + self.cell, lo.1 + self.cell))
    }

    pub fn column(&self, x: i64) -> i64 {
        (x - self.origin.0).div_euclid(self.cell)
    }

    pub fn row(&self, y: i64) -> i64 {
        (y - self.origin.1).div_euclid(self.cell)
    }

    /// The cells whose closed square meets the closed box. With an empty outside, only those of the
    /// map.
    pub fn cells(&self, lo: P, hi: P) -> impl Iterator<Item = P> + use<> {
        let (mut x0, mut y0) = (self.column(lo.0 - 1), self.row(lo.1 - 1));
        let (mut x1, mut y1) = (self.column(hi.0), self.row(hi.1));
        if self.outside == Outside::Empty {
            (x0, y0) = (x0.max(0), y0.max(0));
            (x1, y1) = (x1.min(self.width - 1), y1.min(self.height - 1));
        }
        (y0..=y1).flat_map(move |y| (x0..=x1).map(move |x| (x, y)))
    }

    /// The cells under a motion.
    pub fn cells_along(&self, body: &Body, d: P) -> impl Iterator<Item = P> + use<> {
        let (lo, hi) = body.bounds();
        self.cells((lo.0 + d.0.min(0), lo.1 + d.1.min(0)), (hi.0 + d.0.max(0), hi.1 + d.1.max(0)))
    }

    /// Whether a body reaches the inside of the union of all full cells.
    pub fn overlaps(&self, body: &Body) -> bool {
        let (lo, hi) = body.bounds();
        if body.has_area() {
            return self.cells(lo, hi).any(|(x, y)| {
                let (a, b) = self.square(x, y);
                let meets = lo.0 < b.0 && a.0 < hi.0 && lo.1 < b.1 && a.1 < hi.1;
                meets && self.full(x, y) && body.reaches(a, b)
            });
        }
        // Groups of columns and rows. On a line between two cells, both of them count as one.
        let group = |lo: i64, hi: i64, index: &dyn Fn(i64) -> i64| -> Vec<(i64, i64)> {
            if lo == hi {
                vec![(index(lo - 1), index(lo))]
            } else {
                (index(lo)..=index(hi - 1)).map(|k| (k, k)).collect()
            }
        };
        let columns = group(lo.0, hi.0, &|v| self.column(v));
        let rows = group(lo.1, hi.1, &|v| self.row(v));
        columns
            .iter()
            .any(|&(x0, x1)| rows.iter().any(|&(y0, y1)| (x0..=x1).all(|x| (y0..=y1).all(|y| self.full(x, y)))))
    }

    /// A number for each cell that is not solid, equal for cells that are joined by their sides. A
    /// body with area that moves without overlapping stays within one number.
    pub fn rooms(&self) -> Vec<u32> {
        let mut rooms = vec![0; self.tiles.len()];
        let mut next = 0;
        for start in 0..rooms.len() {
            let (x, y) = (start as i64 % self.width, start as i64 / self.width);
            if rooms[start] != 0 || self.full(x, y) {
                continue;
            }
            next += 1;
            let mut open = vec![(x, y)];
            while let Some((x, y)) = open.pop() {
                let inside = x >= 0 && y >= 0 && x < self.width && y < self.height;
                if !inside || self.full(x, y) || rooms[(y * self.width + x) as usize] != 0 {
                    continue;
                }
                rooms[(y * self.width + x) as usize] = next;
                open.extend([(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)]);
            }
        }
        rooms
    }

    /// The room that a body with area is in; 0 in the solid and outside.
    pub fn room_of(&self, rooms: &[u32], body: &Body) -> u32 {
        let m = body.middle();
        let (x, y) = (self.column(m.0), self.row(m.1));
        let inside = x >= 0 && y >= 0 && x < self.width && y < self.height;
        if inside { rooms[(y * self.width + x) as usize] } else { 0 }
    }
}
