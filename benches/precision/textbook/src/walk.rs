//! A body that moves through a level of tiles and slides. By one axis after the other, to its goal
//! or along all that it crosses. Or in small steps and out again.

use crate::Scalar;
use crate::shape::{Aabb, Vector};
use crate::tile::{Body, Exit, Tile};

/// Tiles by the ids of their shapes, row by row; all is solid outside.
#[derive(Clone, Copy, Debug)]
pub struct Level<'a, S> {
    pub cells: &'a [u8],
    pub width: i32,
    pub height: i32,
    /// A side of a cell in pixels.
    pub cell: i32,
    pub origin: Vector<S>,
    pub tiles: &'a [Tile<S>; 34],
}

/// Keeps a body on a line out of the cell behind it: about a thousandth of a pixel.
const LITTLE: i32 = 64;
/// How far a body moves before it is pushed out, in pixels.
const STEP: i32 = 4;
/// How often it is pushed out after a step.
const ROUNDS: i32 = 4;

impl<S: Scalar> Level<'_, S> {
    fn column(&self, x: S) -> i32 {
        (x - self.origin.x).floor().div_euclid(self.cell)
    }

    fn row(&self, y: S) -> i32 {
        (y - self.origin.y).floor().div_euclid(self.cell)
    }

    /// The last column that holds something before `x`.
    fn last_column(&self, x: S) -> i32 {
        -(self.origin.x - x).floor().div_euclid(self.cell) - 1
    }

    fn last_row(&self, y: S) -> i32 {
        -(self.origin.y - y).floor().div_euclid(self.cell) - 1
    }

    fn id(&self, column: i32, row: i32) -> u8 {
        if column < 0 || row < 0 || column >= self.width || row >= self.height {
            return 1;
        }
        self.cells[(row * self.width + column) as usize]
    }

    fn corner(&self, column: i32, row: i32) -> Vector<S> {
        self.origin + Vector { x: S::of_int(column * self.cell), y: S::of_int(row * self.cell) }
    }

    fn is_solid(&self, columns: (i32, i32), rows: (i32, i32)) -> bool {
        (rows.0..=rows.1).any(|row| (columns.0..=columns.1).any(|column| self.id(column, row) != 0))
    }
}

/// Among blocks: x first, then y. After a hit it stops at the border.
pub fn by_axes<S: Scalar>(level: &Level<'_, S>, body: &Aabb<S>, motion: Vector<S>) -> Aabb<S> {
    let (size, little) = (body.hi - body.lo, S::of_raw(LITTLE));
    let mut lo = body.lo;
    lo.x = lo.x + motion.x;
    let rows = (level.row(lo.y), level.row(lo.y + size.y - little));
    if motion.x > S::ZERO {
        let column = level.column(lo.x + size.x - little);
        if level.is_solid((column, column), rows) {
            lo.x = level.corner(column, 0).x - size.x;
        }
    } else if motion.x < S::ZERO {
        let column = level.column(lo.x);
        if level.is_solid((column, column), rows) {
            lo.x = level.corner(column + 1, 0).x;
        }
    }
    lo.y = lo.y + motion.y;
    let columns = (level.column(lo.x), level.column(lo.x + size.x - little));
    if motion.y > S::ZERO {
        let row = level.row(lo.y + size.y - little);
        if level.is_solid(columns, (row, row)) {
            lo.y = level.corner(0, row).y - size.y;
        }
    } else if motion.y < S::ZERO {
        let row = level.row(lo.y);
        if level.is_solid(columns, (row, row)) {
            lo.y = level.corner(0, row + 1).y;
        }
    }
    Aabb { lo, hi: lo + size }
}

/// Among blocks: x first, then y, with all columns and rows on the way. No slack: a body on a line
/// is beside it.
pub fn by_columns<S: Scalar>(level: &Level<'_, S>, body: &Aabb<S>, motion: Vector<S>) -> Aabb<S> {
    let size = body.hi - body.lo;
    let mut lo = body.lo;
    let rows = (level.row(lo.y), level.last_row(lo.y + size.y));
    let to = lo.x + motion.x;
    if motion.x > S::ZERO {
        let mut columns = level.last_column(lo.x + size.x) + 1..=level.last_column(to + size.x);
        let wall = columns.find(|&column| level.is_solid((column, column), rows));
        lo.x = wall.map_or(to, |column| level.corner(column, 0).x - size.x);
    } else if motion.x < S::ZERO {
        let mut columns = (level.column(to)..level.column(lo.x)).rev();
        let wall = columns.find(|&column| level.is_solid((column, column), rows));
        lo.x = wall.map_or(to, |column| level.corner(column + 1, 0).x);
    }
    let columns = (level.column(lo.x), level.last_column(lo.x + size.x));
    let to = lo.y + motion.y;
    if motion.y > S::ZERO {
        let mut rows = level.last_row(lo.y + size.y) + 1..=level.last_row(to + size.y);
        let wall = rows.find(|&row| level.is_solid(columns, (row, row)));
        lo.y = wall.map_or(to, |row| level.corner(0, row).y - size.y);
    } else if motion.y < S::ZERO {
        let mut rows = (level.row(to)..level.row(lo.y)).rev();
        let wall = rows.find(|&row| level.is_solid(columns, (row, row)));
        lo.y = wall.map_or(to, |row| level.corner(0, row + 1).y);
    }
    Aabb { lo, hi: lo + size }
}

/// The deepest contact with a tile near.
fn deepest<S: Scalar, B: Body<S>>(level: &Level<'_, S>, body: &B) -> Option<Exit<S>> {
    let bounds = body.bounds();
    let mut found: Option<Exit<S>> = None;
    for row in level.row(bounds.lo.y)..=level.row(bounds.hi.y) {
        for column in level.column(bounds.lo.x)..=level.column(bounds.hi.x) {
            let tile = &level.tiles[usize::from(level.id(column, row))];
            if let Tile::Empty = tile {
                continue;
            }
            let corner = level.corner(column, row);
            let near = body.moved(Vector { x: -corner.x, y: -corner.y });
            let Some(exit) = tile.exit(&near, S::of_int(level.cell)) else { continue };
            if found.is_none_or(|f| exit.depth > f.depth) {
                found = Some(exit);
            }
        }
    }
    found
}

/// Small steps, each followed by a push out of the deepest contact.
pub fn by_steps<S: Scalar, B: Body<S>>(level: &Level<'_, S>, body: &B, motion: Vector<S>) -> B {
    let steps = motion.x.magnitude().most(motion.y.magnitude()).floor() / STEP + 1;
    let n = S::of_int(steps);
    let step = Vector { x: motion.x / n, y: motion.y / n };
    let mut body = *body;
    for _ in 0..steps {
        body = body.moved(step);
        for _ in 0..ROUNDS {
            let Some(exit) = deepest(level, &body) else { break };
            body = body.moved(exit.along * exit.depth);
        }
    }
    body
}
