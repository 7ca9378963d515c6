//! A level of cells, each with one convex piece, or a piece with a quarter arc. Decides exactly
//! whether a body overlaps the solid at a sixteenth of a motion.

use tilesat_judge::rooms::body::Body;
use tilesat_judge::shapes::level::{Level, shape};
use tilesat_judge::shapes::region::Region;

type P = (i64, i64);

/// Positions have this many parts per raw unit. Relative coordinates stay below 2^27: cells and
/// bodies are below 2^22 raw.
pub const FINE: i64 = 16;

#[derive(Clone, Copy, Debug)]
enum Solid {
    Nothing,
    Polygon([P; 4], usize),
    /// The corner of the cell at the centre of the arc, the opposite one, and whether the solid is
    /// outside the arc.
    Arc(P, P, bool),
}

pub struct Room {
    width: i64,
    height: i64,
    cell: i64,
    origin: P,
    tiles: Vec<u8>,
    solids: Vec<Solid>,
}

impl Room {
    /// Everything outside it is solid.
    pub fn new(level: &Level) -> Self {
        let half = level.cell / 2 * FINE;
        let at = |p: (i128, i128)| (p.0 as i64 * half, p.1 as i64 * half);
        let solids = (0..38).map(|id| match shape(id).0 {
            None => Solid::Nothing,
            Some(Region::Arc { centre, far, outside }) => Solid::Arc(at(centre), at(far), outside),
            Some(Region::Polygon(points)) => {
                let mut out = [(0, 0); 4];
                out.iter_mut().zip(&points).for_each(|(o, p)| *o = at(*p));
                // In one direction of rotation.
                let (u, v) = (sub(out[1], out[0]), sub(out[2], out[0]));
                if u.0 * v.1 < u.1 * v.0 {
                    out[..points.len()].reverse();
                }
                Solid::Polygon(out, points.len())
            }
        });
        Self {
            width: level.width,
            height: level.height,
            cell: level.cell,
            origin: (level.x, level.y),
            tiles: level.tiles.clone(),
            solids: solids.collect(),
        }
    }

    /// Whether the body overlaps the solid after `sixteenths` of a motion.
    pub fn overlaps(&self, body: Body, d: P, sixteenths: i64) -> bool {
        if let Some(parts) = body.parts() {
            return parts.into_iter().any(|part| self.overlaps(part, d, sixteenths));
        }
        let (lo, hi) = body.bounds();
        let place = |p: P| {
            let at = |p: i64, d: i64, origin: i64| (p - origin) * FINE + d * sixteenths;
            (at(p.0, d.0, self.origin.0), at(p.1, d.1, self.origin.1))
        };
        let (lo, hi, side) = (place(lo), place(hi), self.cell * FINE);
        if lo.0 < 0 || lo.1 < 0 || hi.0 > self.width * side || hi.1 > self.height * side {
            return true;
        }
        let cells = |lo: i64, hi: i64, count: i64| lo / side..=(hi / side).min(count - 1);
        cells(lo.1, hi.1, self.height).any(|row| {
            cells(lo.0, hi.0, self.width).any(|column| {
                let at = |p: P| (p.0 - column * side, p.1 - row * side);
                let solid = self.solids[usize::from(self.tiles[(row * self.width + column) as usize])];
                match body {
                    Body::Disc(c, r) => disc(&solid, at(place(c)), r * FINE),
                    Body::Rect(..) | Body::Pill(..) => rect(&solid, at(lo), at(hi)),
                }
            })
        })
    }
}

fn sub(a: P, b: P) -> P {
    (a.0 - b.0, a.1 - b.1)
}

fn dot(a: P, b: P) -> i64 {
    a.0 * b.0 + a.1 * b.1
}

fn cross(a: P, b: P) -> i64 {
    a.0 * b.1 - a.1 * b.0
}

/// Whether a point is nearer to the segment from `a` to `b` than a distance.
fn near(p: P, a: P, b: P, r: i64) -> bool {
    let (e, m, n) = (sub(b, a), sub(p, a), sub(p, b));
    if dot(m, e) <= 0 {
        dot(m, m) < r * r
    } else if dot(n, e) >= 0 {
        dot(n, n) < r * r
    } else {
        i128::from(cross(e, m)).pow(2) < i128::from(r * r) * i128::from(dot(e, e))
    }
}

fn within(p: P, a: P, b: P) -> bool {
    a.0.min(b.0) <= p.0 && p.0 <= a.0.max(b.0) && a.1.min(b.1) <= p.1 && p.1 <= a.1.max(b.1)
}

fn disc(solid: &Solid, c: P, r: i64) -> bool {
    match *solid {
        Solid::Nothing => false,
        Solid::Polygon(points, n) => {
            let side = |i: usize| (points[i], points[(i + 1) % n]);
            let inside = (0..n).all(|i| {
                let (a, b) = side(i);
                cross(sub(b, a), sub(c, a)) >= 0
            });
            inside || (0..n).map(side).any(|(a, b)| near(c, a, b, r))
        }
        Solid::Arc(centre, far, outside) => {
            let (m, q) = (sub(c, centre), sub(far, centre));
            let (square, radius) = (dot(m, m), q.0.abs());
            let inside =
                within(c, centre, far) && if outside { square >= radius * radius } else { square <= radius * radius };
            let corner = if outside { far } else { centre };
            let straight = near(c, (centre.0, far.1), corner, r) || near(c, corner, (far.0, centre.1), r);
            let toward = m.0 * q.0.signum() >= 0 && m.1 * q.1.signum() >= 0;
            let (least, most) = (radius - r, radius + r);
            let arc = toward && square < most * most && (least < 0 || square > least * least);
            inside || straight || arc
        }
    }
}

fn rect(solid: &Solid, lo: P, hi: P) -> bool {
    let corners = [lo, (hi.0, lo.1), hi, (lo.0, hi.1)];
    match *solid {
        Solid::Nothing => false,
        // No side and no axis separates them, and both have area.
        Solid::Polygon(points, n) => {
            let points = &points[..n];
            let beyond = |f: fn(&P) -> i64, lo: i64, hi: i64| {
                points.iter().all(|p| f(p) <= lo) || points.iter().all(|p| f(p) >= hi)
            };
            !beyond(|p| p.0, lo.0, hi.0)
                && !beyond(|p| p.1, lo.1, hi.1)
                && (0..n).all(|i| {
                    let (a, b) = (points[i], points[(i + 1) % n]);
                    corners.iter().any(|&c| cross(sub(b, a), sub(c, a)) > 0)
                })
        }
        Solid::Arc(centre, far, outside) => {
            // The part of the box in the cell. Its corners include the nearest and the farthest
            // point from the centre.
            let cut = |lo: i64, hi: i64, c: i64, f: i64| (lo.max(c.min(f)), hi.min(c.max(f)));
            let ((x0, x1), (y0, y1)) = (cut(lo.0, hi.0, centre.0, far.0), cut(lo.1, hi.1, centre.1, far.1));
            let radius = (far.0 - centre.0).abs();
            let mut squares = [(x0, y0), (x1, y0), (x0, y1), (x1, y1)].map(|p| {
                let m = sub(p, centre);
                dot(m, m)
            });
            squares.sort_unstable();
            let reaches = if outside { squares[3] > radius * radius } else { squares[0] < radius * radius };
            x0 < x1 && y0 < y1 && reaches
        }
    }
}
