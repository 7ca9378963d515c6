//! A small level of any shapes.

use super::piece::{Kind, Piece};
use super::polygon::{Point, solid};
use crate::Random;
use tilesat::world::ShapeSet;
use tilesat::{Aabb, Fx, Grid, Outside, TileKind, TileKinds, TileMap, TileShape, Vec2};

/// Ids are shapes; each has other flags.
pub static KINDS: TileKinds = kinds_in(u64::MAX);

/// Only the shapes of a set.
const fn kinds_in(shapes: u64) -> TileKinds {
    let (mut kinds, mut id) = (TileKinds::EMPTY, 0);
    while id < TileShape::ALL.len() {
        if shapes >> id & 1 != 0 {
            kinds = kinds.with(id as u8, TileKind::of(TileShape::ALL[id]).with_flags(3 * id as u8 + 1));
        }
        id += 1;
    }
    kinds
}

pub const OUTSIDES: [Outside; 3] = [Outside::Empty, Outside::Solid, Outside::Edge];

/// The end of the domain.
pub const FAR: i64 = (1 << 29) - 1;

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mosaic {
    pub width: i64,
    pub height: i64,
    pub cell: i64,
    pub origin: Point,
    pub outside: Outside,
    pub tiles: Vec<u8>,
}

impl Mosaic {
    /// Nothing outside, cells of an odd number of half raw units, somewhere.
    pub fn new(width: i64, height: i64, tiles: Vec<u8>) -> Self {
        Self { width, height, cell: 2 * 7 * 64 + 2, origin: (-64_000, 12_345), outside: Outside::Empty, tiles }
    }

    /// Cells of any size: powers of two, odd multiples of two, the limits; in the middle of the
    /// domain or at its ends.
    pub fn random(random: &mut Random, width: i64, height: i64, ids: &[u8]) -> Self {
        let tiles = (0..width * height).map(|_| ids[random.below(ids.len() as i64) as usize]).collect();
        let cells = [898, 1 << 20, 1 << 8, 258, 2 * 50_021, (1 << 24) - 2, 1 << 24];
        let cell = cells[random.below(7) as usize];
        let mut origin = |count: i64| match random.below(4) {
            0 => -FAR,
            1 => FAR - count * cell,
            2 => -cell * (count / 2),
            _ => random.around(1 << 20),
        };
        Self { cell, origin: (origin(width), origin(height)), ..Self::new(width, height, tiles) }
    }

    pub fn map<S: ShapeSet>(&self) -> TileMap<'_, S> {
        let origin = Vec2::from_raw(self.origin.0 as i32, self.origin.1 as i32);
        let grid = Grid::new(self.width as u16, self.height as u16, Fx::from_bits(self.cell as i32), origin).unwrap();
        TileMap::of(&self.tiles, grid, const { &kinds_in(S::SHAPES) }).unwrap().with_outside(self.outside)
    }

    /// The domain.
    pub fn everything() -> Aabb {
        let end = FAR as i32;
        Aabb::new(Vec2::from_raw(-end, -end), Vec2::from_raw(end, end)).unwrap()
    }

    /// All features that the library reports.
    pub fn features<S: ShapeSet>(&self) -> Vec<Piece> {
        self.map::<S>().features(&Self::everything()).map(|f| Piece::of(&f)).collect()
    }

    fn holds(&self, (x, y): Point) -> bool {
        (0..self.width).contains(&x) && (0..self.height).contains(&y)
    }

    fn tile(&self, (x, y): Point) -> u8 {
        self.tiles[(y * self.width + x) as usize]
    }

    /// The cells of the map, and a ring around it if there is an outside.
    pub fn cells(&self) -> Vec<Point> {
        let ring = i64::from(self.outside != Outside::Empty);
        (-ring..self.height + ring).flat_map(|y| (-ring..self.width + ring).map(move |x| (x, y))).collect()
    }

    /// The id of a cell of the map or of the ring.
    pub fn id(&self, cell: Point) -> u8 {
        if self.holds(cell) {
            return self.tile(cell);
        }
        if self.outside == Outside::Solid {
            return 1;
        }
        let near = (cell.0.clamp(0, self.width - 1), cell.1.clamp(0, self.height - 1));
        let (dx, dy) = (cell.0 - near.0, cell.1 - near.1);
        let id = self.tile(near);
        // Whether the tile's half edge around a point of its border, in quarters of the cell, is
        // solid.
        let covered =
            |x: i64, y: i64| solid(id).iter().any(|e| e.index < 8 && (e.a.0 + e.b.0, e.a.1 + e.b.1) == (x, y));
        let (x, y) = (2 + 2 * dx, 2 + 2 * dy);
        if dx != 0 && dy != 0 {
            return u8::from(covered(x, y - dy) && covered(x - dx, y));
        }
        if dx != 0 {
            return match (id, covered(x, 1), covered(x, 3)) {
                (34 | 36, ..) => id,
                (_, true, true) => 1,
                (_, true, false) => 2,
                (_, false, true) => 4,
                _ => 0,
            };
        }
        match (id, covered(1, y), covered(3, y)) {
            (35 | 37, ..) => id,
            (_, true, true) => 1,
            (_, true, false) => 5,
            (_, false, true) => 3,
            _ => 0,
        }
    }

    pub fn piece(&self, cell: Point, index: u16, one_way: bool, kind: Kind) -> Piece {
        let near = (cell.0.clamp(0, self.width - 1), cell.1.clamp(0, self.height - 1));
        let flags = if self.holds(cell) || self.outside == Outside::Edge { 3 * self.tile(near) + 1 } else { 0 };
        Piece { cell, index, one_way, flags, kind }
    }

    /// A piece in halves of a cell in raw coordinates. The ring reaches to the end of the domain,
    /// and nothing is beyond that. It may have no width.
    pub fn in_raw(&self, piece: Piece) -> Option<Piece> {
        let ring = self.outside != Outside::Empty;
        let far_x = |p: Point| ring && (p.0 == -2 || p.0 == 2 * self.width + 2);
        let far_y = |p: Point| ring && (p.1 == -2 || p.1 == 2 * self.height + 2);
        let end = |v: i64| if v < 0 { -FAR } else { FAR };
        let raw = |p: Point| {
            let x = if far_x(p) { end(p.0) } else { self.origin.0 + p.0 * self.cell / 2 };
            let y = if far_y(p) { end(p.1) } else { self.origin.1 + p.1 * self.cell / 2 };
            (x, y)
        };
        let far = |p: Point| far_x(p) || far_y(p);
        let kind = match piece.kind {
            Kind::Face { a, b, dir, joined } => {
                if (far_x(a) && a.0 == b.0) || (far_y(a) && a.1 == b.1) {
                    return None;
                }
                Kind::Face { a: raw(a), b: raw(b), dir, joined: [joined[0] || far(a), joined[1] || far(b)] }
            }
            Kind::Vertex { p, .. } if far(p) => return None,
            Kind::Vertex { p, e_in, e_out } => Kind::Vertex { p: raw(p), e_in, e_out },
            Kind::Arc { centre, quadrant, convex, .. } => {
                Kind::Arc { centre: raw(centre), radius: self.cell, quadrant, convex }
            }
        };
        Some(Piece { kind, ..piece })
    }
}
