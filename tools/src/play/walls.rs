//! The segments of a level for the check. It reads their bytes, and compares them with bodies in
//! whole numbers.

use std::collections::HashMap;

use super::figure::Figure;

type Point = (i64, i64);

/// The solid side of a segment is its left if y grows up: `(-dy, dx)` from it.
#[derive(Debug, Clone, Copy)]
struct Edge {
    a: Point,
    b: Point,
}

/// The borders of polygons. Walls and one-way chains have no inside.
#[derive(Debug, Clone, Default)]
pub(super) struct Walls {
    edges: Vec<Edge>,
    /// For each square of this side, the edges whose box meets it.
    squares: HashMap<Point, Vec<u32>>,
    side: i64,
}

impl Walls {
    /// Reads the bytes of a segment map, as the library documents them.
    pub(super) fn new(bytes: &[u8]) -> Self {
        let word =
            |at: usize| bytes.get(at..at + 4).and_then(|word| word.try_into().ok()).map_or(0, i32::from_le_bytes);
        let count = bytes.get(6..8).map_or(0, |half| usize::from(half[0]) | usize::from(half[1]) << 8);
        let mut walls = Self { side: i64::from(word(16)).max(1 << 16), ..Self::default() };
        for at in (0..count).map(|i| 32 + 24 * i) {
            let number = |k: usize| i64::from(word(at + 4 * k));
            let a = (number(0), number(1));
            let b = (a.0 + number(2) * number(4), a.1 + number(3) * number(4));
            // The low bits of the attributes: 0 is the border of a solid.
            if bytes.get(at + 22).is_some_and(|attributes| attributes & KIND == 0) {
                walls.add(Edge { a, b });
            }
        }
        walls
    }

    /// The ends of the borders of polygons.
    pub(super) fn borders(&self) -> impl Iterator<Item = (Point, Point)> + '_ {
        self.edges.iter().map(|edge| (edge.a, edge.b))
    }

    fn add(&mut self, edge: Edge) {
        let index = self.edges.len() as u32;
        let (lo, hi) =
            ((edge.a.0.min(edge.b.0), edge.a.1.min(edge.b.1)), (edge.a.0.max(edge.b.0), edge.a.1.max(edge.b.1)));
        for square in self.squares_of(lo, hi) {
            self.squares.entry(square).or_default().push(index);
        }
        self.edges.push(edge);
    }

    fn squares_of(&self, lo: Point, hi: Point) -> Vec<Point> {
        let at = |v: i64| v.div_euclid(self.side);
        (at(lo.1)..=at(hi.1)).flat_map(|y| (at(lo.0)..=at(hi.0)).map(move |x| (x, y))).collect()
    }

    /// Whether the interiors of a body and of a polygon meet.
    pub(super) fn overlap(&self, figure: &Figure) -> bool {
        if self.edges.is_empty() {
            return false;
        }
        let (lo, hi) = figure.extent();
        let squares = self.squares_of(lo, hi);
        let near = squares.iter().filter_map(|square| self.squares.get(square)).flatten();
        let met = near.map(|&index| self.edges[index as usize]).find(|edge| enters(figure, edge));
        match met {
            // One side of an edge is solid, except for a hole outside any solid.
            Some(edge) => self.winding(beside(figure, &edge)) > 0 || self.winding(figure.middle()) > 0,
            None => self.winding(figure.middle()) > 0,
        }
    }

    /// The number of polygons, minus holes, around a point: from the edges that a ray to the right
    /// crosses.
    fn winding(&self, p: Point) -> i32 {
        let side = |e: &Edge| {
            let (dx, dy) = (i128::from(e.b.0 - e.a.0), i128::from(e.b.1 - e.a.1));
            dx * i128::from(p.1 - e.a.1) - dy * i128::from(p.0 - e.a.0)
        };
        let crossed = |e: &Edge| {
            if e.a.1 <= p.1 && p.1 < e.b.1 && side(e) > 0 {
                1
            } else if e.b.1 <= p.1 && p.1 < e.a.1 && side(e) < 0 {
                -1
            } else {
                0
            }
        };
        self.edges.iter().map(crossed).sum()
    }
}

const KIND: u8 = 3;

/// Whether a point of an edge is strictly inside a body.
fn enters(figure: &Figure, edge: &Edge) -> bool {
    match *figure {
        Figure::Box { min, max } => {
            let beside = |a: i64, b: i64, lo: i64, hi: i64| a.max(b) <= lo || a.min(b) >= hi;
            if beside(edge.a.0, edge.b.0, min.0, max.0) || beside(edge.a.1, edge.b.1, min.1, max.1) {
                return false;
            }
            let (dx, dy) = (i128::from(edge.b.0 - edge.a.0), i128::from(edge.b.1 - edge.a.1));
            let side = |p: Point| dx * i128::from(p.1 - edge.a.1) - dy * i128::from(p.0 - edge.a.0);
            let corners = [min, (max.0, min.1), max, (min.0, max.1)].map(side);
            corners.iter().any(|&side| side > 0) && corners.iter().any(|&side| side < 0)
        }
        Figure::Disc { centre, radius } => {
            let wide = |p: Point| (i128::from(p.0 - edge.a.0), i128::from(p.1 - edge.a.1));
            let (d, e, r) = (wide(edge.b), wide(centre), i128::from(radius));
            let (dot, length) = (d.0 * e.0 + d.1 * e.1, d.0 * d.0 + d.1 * d.1);
            if dot <= 0 {
                e.0 * e.0 + e.1 * e.1 < r * r
            } else if dot >= length {
                (e.0 - d.0).pow(2) + (e.1 - d.1).pow(2) < r * r
            } else {
                (d.0 * e.1 - d.1 * e.0).pow(2) < r * r * length
            }
        }
    }
}

/// A point on the solid side of an edge, next to its point nearest to the middle of a body.
fn beside(figure: &Figure, edge: &Edge) -> Point {
    let (dx, dy) = (i128::from(edge.b.0 - edge.a.0), i128::from(edge.b.1 - edge.a.1));
    let middle = figure.middle();
    let (ex, ey) = (i128::from(middle.0 - edge.a.0), i128::from(middle.1 - edge.a.1));
    let length = (dx * dx + dy * dy).max(1);
    let along = (dx * ex + dy * ey).clamp(0, length);
    let on = |from: i64, d: i128| from + (d * along / length) as i64;
    (on(edge.a.0, dx) - 2 * dy.signum() as i64, on(edge.a.1, dy) + 2 * dx.signum() as i64)
}
