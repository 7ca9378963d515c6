//! A level whose tile ids are the discriminants of their shapes.

use super::region::{Point, Region, rectangle};
use tilesat::world::ShapeSet;
use tilesat::{AllShapes, Blocks, Fx, Grid, Outside, TileKind, TileKinds, TileMap, TileShape, Vec2};

/// Beyond every coordinate of the domain.
pub const FAR: i128 = 1 << 30;

/// The shapes of a set, with their ids as flags.
const fn kinds(shapes: u64) -> TileKinds {
    let mut kinds = TileKinds::EMPTY;
    let mut id = 0;
    while id < 38 {
        if shapes >> id & 1 == 1 {
            kinds = kinds.with(id, TileKind::of(TileShape::ALL[id as usize]).with_flags(id));
        }
        id += 1;
    }
    kinds
}

pub static KINDS: TileKinds = kinds(AllShapes::SHAPES);
static BLOCKS: TileKinds = kinds(Blocks::SHAPES);

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

/// The solid of a part of the plane, and the rest. Both are closed.
#[derive(Clone, Debug)]
pub struct Piece {
    pub solid: Option<Region>,
    pub rest: Option<Region>,
}

/// The shape of an id in a cell of side 2, y down, with its solid corner at the top left (halves:
/// with their side at the top).
fn base(group: u8) -> (Region, Region) {
    let polygons = |solid: &[Point], rest: &[Point]| (Region::Polygon(solid.into()), Region::Polygon(rest.into()));
    let arc = |centre, far| {
        let quarter = |outside| Region::Arc { centre, far, outside };
        (quarter(false), quarter(true))
    };
    match group {
        0 => polygons(&[(0, 0), (2, 0), (2, 1), (0, 1)], &[(0, 1), (2, 1), (2, 2), (0, 2)]),
        1 => polygons(&[(0, 0), (2, 0), (0, 2)], &[(2, 0), (2, 2), (0, 2)]),
        2 => arc((0, 0), (2, 2)),
        3 => {
            let (disc, rest) = arc((2, 2), (0, 0));
            (rest, disc)
        }
        4 => polygons(&[(0, 0), (2, 0), (0, 1)], &[(2, 0), (2, 2), (0, 2), (0, 1)]),
        5 => polygons(&[(0, 0), (2, 0), (2, 1), (0, 2)], &[(2, 1), (2, 2), (0, 2)]),
        6 => polygons(&[(0, 0), (1, 0), (0, 2)], &[(1, 0), (2, 0), (2, 2), (0, 2)]),
        _ => polygons(&[(0, 0), (2, 0), (1, 2), (0, 2)], &[(2, 0), (2, 2), (1, 2)]),
    }
}

/// The solid of a shape and the rest of its cell, in a cell of side 2.
pub fn shape(id: u8) -> (Option<Region>, Option<Region>) {
    let cell = Some(rectangle((0, 0), (2, 2)));
    if id == 1 {
        return (cell, None);
    }
    if !(2..34).contains(&id) {
        return (None, cell);
    }
    let (group, turn) = ((id - 2) / 4, (id - 2) % 4);
    let place = |(x, y): Point| match (group, turn) {
        (_, 0) => (x, y),
        // Halves turn about the middle, the others are mirrored.
        (0, 1) => (2 - y, x),
        (0, 3) => (y, x),
        (_, 1) => (2 - x, y),
        (_, 2) => (2 - x, 2 - y),
        _ => (x, 2 - y),
    };
    let (solid, rest) = base(group);
    (Some(solid.map(place)), Some(rest.map(place)))
}

impl Level {
    fn map<S: ShapeSet>(&self, kinds: &'static TileKinds) -> TileMap<'_, S> {
        let origin = Vec2::from_raw(self.x as i32, self.y as i32);
        let grid = Grid::new(self.width as u16, self.height as u16, Fx::from_bits(self.cell as i32), origin).unwrap();
        TileMap::<S>::of(&self.tiles, grid, kinds).unwrap().with_outside(self.outside)
    }

    pub fn all(&self) -> TileMap<'_, AllShapes> {
        self.map(&KINDS)
    }

    /// The same level as a map of blocks, if it is one.
    pub fn blocks(&self) -> Option<TileMap<'_, Blocks>> {
        self.tiles.iter().all(|&id| Blocks::SHAPES >> id & 1 == 1).then(|| self.map(&BLOCKS))
    }

    fn at(&self, column: i64, row: i64) -> u8 {
        self.tiles[(row * self.width + column) as usize]
    }

    /// The quarters of a small disc around a point of a border tile's side, in halves of a cell,
    /// that its solid fills. Works in a cell of side 8, with the neighbours of `p`.
    fn covered(&self, column: i64, row: i64, p: Point) -> bool {
        let (solid, _) = shape(self.at(column, row));
        solid.is_some_and(|s| s.map(|(x, y)| (1000 * x, 1000 * y)).contains(p))
    }

    /// The solid of a part beyond the map with a repeated border: halves (of `lo..hi`) beside
    /// covered halves of the border tile's side.
    fn band(&self, column: i64, row: i64, lo: Point, hi: Point) -> Vec<Piece> {
        let (c, r) = (column.clamp(0, self.width - 1), row.clamp(0, self.height - 1));
        // Beside the tile's side, just inside of the tile.
        let near = |i: i64, inner: i64| if i < inner { 1 } else { 1999 };
        let (x, y) = (near(column, c), near(row, r));
        let piece = |solid: bool, lo: Point, hi: Point| {
            let region = Some(rectangle(lo, hi));
            if solid { Piece { solid: region, rest: None } } else { Piece { solid: None, rest: region } }
        };
        match (c != column, r != row) {
            (true, true) => {
                let (quarter_x, quarter_y) = (if x == 1 { 500 } else { 1500 }, if y == 1 { 500 } else { 1500 });
                let solid = self.covered(c, r, (quarter_x, y)) && self.covered(c, r, (x, quarter_y));
                vec![piece(solid, lo, hi)]
            }
            (true, false) => {
                let middle = i128::midpoint(lo.1, hi.1);
                vec![
                    piece(self.covered(c, r, (x, 500)), lo, (hi.0, middle)),
                    piece(self.covered(c, r, (x, 1500)), (lo.0, middle), hi),
                ]
            }
            _ => {
                let middle = i128::midpoint(lo.0, hi.0);
                vec![
                    piece(self.covered(c, r, (500, y)), lo, (middle, hi.1)),
                    piece(self.covered(c, r, (1500, y)), (middle, lo.1), hi),
                ]
            }
        }
    }

    /// The plane, cut into cells and bands, all coordinates times `scale`.
    pub fn pieces(&self, scale: i128) -> Vec<Piece> {
        let side = |i: i64, origin: i64, count: i64| {
            let lo = if i < 0 { -FAR } else { i128::from(origin + i * self.cell) };
            let hi = if i >= count { FAR } else { i128::from(origin + (i + 1) * self.cell) };
            (lo * scale, hi * scale)
        };
        let mut out = Vec::new();
        for row in -1..=self.height {
            for column in -1..=self.width {
                let ((x0, x1), (y0, y1)) = (side(column, self.x, self.width), side(row, self.y, self.height));
                if (0..self.width).contains(&column) && (0..self.height).contains(&row) {
                    let half = i128::from(self.cell) * scale / 2;
                    let (solid, rest) = shape(self.at(column, row));
                    let place = |r: Region| r.map(|(x, y)| (x0 + half * x, y0 + half * y));
                    out.push(Piece { solid: solid.map(place), rest: rest.map(place) });
                } else {
                    let whole = Some(rectangle((x0, y0), (x1, y1)));
                    match self.outside {
                        Outside::Empty => out.push(Piece { solid: None, rest: whole }),
                        Outside::Solid => out.push(Piece { solid: whole, rest: None }),
                        Outside::Edge => out.extend(self.band(column, row, (x0, y0), (x1, y1))),
                    }
                }
            }
        }
        out
    }
}
