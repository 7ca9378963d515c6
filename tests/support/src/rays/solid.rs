//! The shapes of N++ as polygons and arcs, from its tables: y down, in halves of a cell.

use num_bigint::BigInt;

pub type Point = (i64, i64);

/// A point in parts of 2^-1024 / 3.
pub type Exact = (BigInt, BigInt);

/// A length of `2^-bits`, or a third of it.
pub fn small(bits: u32, third: bool) -> BigInt {
    BigInt::from(if third { 1 } else { 3 }) << (1024 - bits)
}

fn length(v: i64) -> BigInt {
    small(0, false) * v
}

pub fn exact(p: Point) -> Exact {
    (length(p.0), length(p.1))
}

const CORNERS: [Point; 4] = [(0, 0), (2, 0), (2, 2), (0, 2)];

/// By id: the ends of the side within the cell.
const SIDES: [(u8, Point, Point); 24] = [
    (2, (0, 1), (2, 1)),
    (3, (1, 0), (1, 2)),
    (4, (2, 1), (0, 1)),
    (5, (1, 2), (1, 0)),
    (6, (0, 2), (2, 0)),
    (7, (0, 0), (2, 2)),
    (8, (2, 0), (0, 2)),
    (9, (2, 2), (0, 0)),
    (18, (0, 1), (2, 0)),
    (19, (0, 0), (2, 1)),
    (20, (2, 1), (0, 2)),
    (21, (2, 2), (0, 1)),
    (22, (0, 2), (2, 1)),
    (23, (0, 1), (2, 2)),
    (24, (2, 0), (0, 1)),
    (25, (2, 1), (0, 0)),
    (26, (0, 2), (1, 0)),
    (27, (1, 0), (2, 2)),
    (28, (2, 0), (1, 2)),
    (29, (1, 2), (0, 0)),
    (30, (1, 2), (2, 0)),
    (31, (0, 0), (1, 2)),
    (32, (1, 0), (0, 2)),
    (33, (2, 2), (1, 0)),
];

/// The solid of a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Solid {
    /// A convex polygon, clockwise in a picture with y down; empty where nothing is solid.
    Polygon(Vec<Point>),
    /// The part of the cell within the closed disc, or outside the open one.
    Round { lo: Point, hi: Point, centre: Point, convex: bool },
}

fn cross(a: Point, b: Point, p: Point) -> i128 {
    let (bx, by, px, py) = (b.0 - a.0, b.1 - a.1, p.0 - a.0, p.1 - a.1);
    i128::from(bx) * i128::from(py) - i128::from(by) * i128::from(px)
}

impl Solid {
    /// The solid of a shape in the cell with these corners. Halves may lie in cells that are not
    /// square.
    pub fn of(id: u8, lo: Point, hi: Point) -> Self {
        let at = |(i, j): Point| {
            let line = |lo: i64, hi: i64, k: i64| [lo, lo + (hi - lo) / 2, hi][k as usize];
            (line(lo.0, hi.0, i), line(lo.1, hi.1, j))
        };
        if id == 1 {
            return Self::Polygon(CORNERS.map(at).to_vec());
        }
        if !(2..34).contains(&id) {
            return Self::Polygon(Vec::new());
        }
        // In every group of four the solid corner turns right from the top left; of a half it is
        // one of two.
        let turn = usize::from((id - 2) % 4);
        if (10..18).contains(&id) {
            let convex = id < 14;
            let centre = at(CORNERS[if convex { turn } else { turn ^ 2 }]);
            return Self::Round { lo, hi, centre, convex };
        }
        let &(_, a, b) = SIDES.iter().find(|s| s.0 == id).unwrap();
        // The square without what is on the other side, in its own order.
        let solid = cross(a, b, CORNERS[turn]).signum();
        let around = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
        let kept = around.into_iter().filter(|&p| {
            let side = cross(a, b, p).signum();
            (side == solid && (p.0 != 1 && p.1 != 1)) || p == a || p == b
        });
        Self::Polygon(kept.map(at).collect())
    }

    /// The sides of the polygon, as they run.
    pub fn sides(&self) -> Vec<(Point, Point)> {
        match self {
            Self::Polygon(p) => (0..p.len()).map(|i| (p[i], p[(i + 1) % p.len()])).collect(),
            Self::Round { lo, hi, centre, convex } => {
                // The sides that meet in the solid corner.
                let p = [*lo, (hi.0, lo.1), *hi, (lo.0, hi.1)];
                let solid = if *convex { *centre } else { (lo.0 + hi.0 - centre.0, lo.1 + hi.1 - centre.1) };
                let sides = (0..4).map(|i| (p[i], p[(i + 1) % 4]));
                sides.filter(|&(a, b)| a == solid || b == solid).collect()
            }
        }
    }

    /// Whether a point of the closed cell is in the closed solid.
    pub fn covers(&self, p: &Exact) -> bool {
        let zero = BigInt::from(0);
        match self {
            Self::Polygon(points) => {
                !points.is_empty()
                    && self.sides().iter().all(|&(a, b)| {
                        let start = exact(a);
                        (&p.1 - start.1) * (b.0 - a.0) - (&p.0 - start.0) * (b.1 - a.1) >= zero
                    })
            }
            Self::Round { lo, hi, centre, convex } => {
                let (c, r) = (exact(*centre), length(hi.0 - lo.0));
                let (x, y) = (&p.0 - &c.0, &p.1 - &c.1);
                let (square, limit) = (&x * &x + &y * &y, &r * &r);
                if *convex { square <= limit } else { square >= limit }
            }
        }
    }
}
