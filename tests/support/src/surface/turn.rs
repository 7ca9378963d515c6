//! The eight turns and mirrors of a square, of points, shapes, mosaics and pieces.

use super::mosaic::Mosaic;
use super::piece::{Kind, Piece};
use super::polygon::{Point, one_way, solid};
use std::collections::BTreeSet;

#[derive(Clone, Copy, Debug)]
pub struct Turn {
    /// Whether x is mirrored first.
    pub mirror: bool,
    /// Then quarter turns from x to y.
    pub quarters: u8,
}

pub const TURNS: [Turn; 7] = {
    let mut turns = [Turn { mirror: true, quarters: 0 }; 7];
    let mut i = 1;
    while i < 7 {
        turns[i] = Turn { mirror: i >= 4, quarters: (i % 4) as u8 };
        i += 1;
    }
    turns
};

impl Turn {
    /// Turns a point around the origin, or a direction.
    pub fn point(self, p: Point) -> Point {
        let p = if self.mirror { (-p.0, p.1) } else { p };
        (0..self.quarters).fold(p, |p, _| (-p.1, p.0))
    }

    /// Turns a point in a box with a corner at the origin: size before, and the point in the turned
    /// box.
    fn within(self, (w, h): Point, p: Point) -> Point {
        let p = self.point((2 * p.0 - w, 2 * p.1 - h));
        let size = self.point((w, h));
        (i64::midpoint(p.0, size.0.abs()), i64::midpoint(p.1, size.1.abs()))
    }

    /// The shape that has the turned border.
    fn shape(self, id: u8) -> u8 {
        let border = |id: u8, turn: &dyn Fn(Point) -> Point| {
            let edges = solid(id).into_iter().chain(one_way(id));
            let ends = |e: &super::polygon::Edge| BTreeSet::from([turn(e.a), turn(e.b)]);
            edges.map(|e| (ends(&e), e.arc.map(|(c, convex)| (turn(c), convex)))).collect::<BTreeSet<_>>()
        };
        // The borders of a full cell and a one-way one differ: one has four sides.
        let turned = border(id, &|p| self.within((2, 2), p));
        (0..38).find(|&other| border(other, &|p| p) == turned).unwrap()
    }

    /// A mosaic turned around the origin.
    pub fn mosaic(self, m: &Mosaic) -> Mosaic {
        let size = self.point((m.width, m.height));
        let (width, height) = (size.0.abs(), size.1.abs());
        let mut tiles = vec![0; m.tiles.len()];
        for y in 0..m.height {
            for x in 0..m.width {
                let to = self.within((m.width - 1, m.height - 1), (x, y));
                tiles[(to.1 * width + to.0) as usize] = self.shape(m.tiles[(y * m.width + x) as usize]);
            }
        }
        let (a, b) = (m.origin, (m.origin.0 + m.width * m.cell, m.origin.1 + m.height * m.cell));
        let (a, b) = (self.point(a), self.point(b));
        Mosaic { width, height, tiles, origin: (a.0.min(b.0), a.1.min(b.1)), ..m.clone() }
    }

    /// The image of a piece. In a mirror a vertex belongs to the tile of its other edge. So without
    /// cell, index and flags.
    pub fn piece(self, piece: &Piece) -> Piece {
        let back = |p: Point| (-p.0, -p.1);
        let kind = match piece.kind {
            Kind::Face { a, b, dir, joined: [start, end] } => {
                let (a, b, dir) = (self.point(a), self.point(b), self.point(dir));
                if self.mirror {
                    Kind::Face { a: b, b: a, dir: back(dir), joined: [end, start] }
                } else {
                    Kind::Face { a, b, dir, joined: [start, end] }
                }
            }
            Kind::Vertex { p, e_in, e_out } => {
                let (p, e_in, e_out) = (self.point(p), self.point(e_in), self.point(e_out));
                if self.mirror {
                    Kind::Vertex { p, e_in: back(e_out), e_out: back(e_in) }
                } else {
                    Kind::Vertex { p, e_in, e_out }
                }
            }
            Kind::Arc { centre, radius, quadrant, convex } => {
                Kind::Arc { centre: self.point(centre), radius, quadrant: self.point(quadrant), convex }
            }
        };
        Piece { cell: (0, 0), index: 0, flags: 0, one_way: piece.one_way, kind }
    }
}
