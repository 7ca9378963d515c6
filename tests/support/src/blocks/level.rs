//! A level as a list of closed rectangles, with the bands around the map.

use tilesat::{Fx, Grid, Outside, TileKind, TileKinds, TileMap, Vec2};

/// Beyond every coordinate of the domain.
pub const FAR: i64 = 1 << 40;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    pub column: i64,
    pub row: i64,
    pub x0: i64,
    pub y0: i64,
    pub x1: i64,
    pub y1: i64,
    pub full: bool,
}

impl Cell {
    pub fn holds(&self, x: i64, y: i64) -> bool {
        self.x0 <= x && x <= self.x1 && self.y0 <= y && y <= self.y1
    }
}

/// Ids are shapes: 0 empty, 1 full, 2 one-way; 3 to 5 the same with flags.
pub static KINDS: TileKinds = TileKinds::EMPTY
    .with(1, TileKind::FULL)
    .with(2, TileKind::ONE_WAY_UP)
    .with(3, TileKind::EMPTY.with_flags(1))
    .with(4, TileKind::FULL.with_flags(2))
    .with(5, TileKind::ONE_WAY_UP.with_flags(4));

#[derive(Clone, Debug)]
pub struct Level {
    pub width: i64,
    pub height: i64,
    pub cell: i64,
    pub x: i64,
    pub y: i64,
    pub outside: Outside,
    pub tiles: Vec<u8>,
}

impl Level {
    pub fn map(&self) -> TileMap<'_> {
        let origin = Vec2::from_raw(self.x as i32, self.y as i32);
        let grid = Grid::new(self.width as u16, self.height as u16, Fx::from_bits(self.cell as i32), origin).unwrap();
        TileMap::on_grid(&self.tiles, grid, &KINDS).unwrap().with_outside(self.outside)
    }

    pub fn right(&self) -> i64 {
        self.x + self.width * self.cell
    }

    pub fn bottom(&self) -> i64 {
        self.y + self.height * self.cell
    }

    pub fn in_map(&self, column: i64, row: i64) -> bool {
        (0..self.width).contains(&column) && (0..self.height).contains(&row)
    }

    /// The id of any cell of the plane. A solid outside has id 1.
    pub fn id(&self, column: i64, row: i64) -> u8 {
        let at = |c: i64, r: i64| self.tiles[(r * self.width + c) as usize];
        match self.outside {
            _ if self.in_map(column, row) => at(column, row),
            Outside::Empty => 0,
            Outside::Solid => 1,
            Outside::Edge => {
                let id = at(column.clamp(0, self.width - 1), row.clamp(0, self.height - 1));
                if id % 3 == 2 && !(0..self.height).contains(&row) { 0 } else { id }
            }
        }
    }

    pub fn full(&self, column: i64, row: i64) -> bool {
        self.id(column, row) % 3 == 1
    }

    pub fn one_way(&self, column: i64, row: i64) -> bool {
        self.id(column, row) % 3 == 2
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
                let ((x0, x1), (y0, y1)) = (side(column, self.x, self.width), side(row, self.y, self.height));
                out.push(Cell { column, row, x0, y0, x1, y1, full: self.full(column, row) });
            }
        }
        out
    }

    /// The columns' or rows' lines.
    pub fn lines_x(&self) -> impl Iterator<Item = i64> + '_ {
        (0..=self.width).map(|i| self.x + i * self.cell)
    }

    pub fn lines_y(&self) -> impl Iterator<Item = i64> + '_ {
        (0..=self.height).map(|i| self.y + i * self.cell)
    }
}
