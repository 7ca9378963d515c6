//! A level of polygons and chains judged from the input: winding numbers by brute force, and the
//! edges that remain after opposite ones cancel.
//!
//! It shares no code with the library and has no grid. Coordinates are relative to the scene's
//! origin and small, all arithmetic is in 128 bits.

pub mod build;
pub mod frames;
pub mod hostile;
pub mod rays;
pub mod thin;

use std::collections::BTreeMap;
use tilesat::{Fx, Grid, Path, PathKind, Vec2};

pub type P = (i128, i128);

pub fn sub(a: P, b: P) -> P {
    (a.0 - b.0, a.1 - b.1)
}

pub fn cross(a: P, b: P) -> i128 {
    a.0 * b.1 - a.1 * b.0
}

pub fn dot(a: P, b: P) -> i128 {
    a.0 * b.0 + a.1 * b.1
}

pub fn gcd(a: i128, b: i128) -> i128 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}

/// A polygon or chain, as in the input.
#[derive(Clone, Debug)]
pub struct Shape {
    pub kind: PathKind,
    pub flags: u8,
    pub points: Vec<P>,
}

#[derive(Clone, Debug)]
pub struct Scene {
    pub shapes: Vec<Shape>,
    pub origin: P,
    /// Raw.
    pub cell: i32,
    /// The grid's first corner relative to the origin, and its cells, unless the builder chooses
    /// them.
    pub grid: Option<(P, u16, u16)>,
}

#[derive(Clone, Copy, Debug)]
pub enum Body {
    Box { lo: P, hi: P },
    Circle { c: P, r: i128 },
}

/// A piece of an edge from `a` to `b`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Piece {
    pub a: P,
    pub b: P,
}

type Extent = (i128, i128, i128);

/// Points are given as `p / SCALE`, so that one can be a little beside a lattice point.
pub const SCALE: i128 = 1 << 60;

impl Shape {
    fn closed(&self) -> bool {
        matches!(self.kind, PathKind::Solid | PathKind::Hole)
    }

    pub fn edges(&self) -> Vec<(P, P)> {
        let n = self.points.len();
        let count = if self.closed() { n } else { n - 1 };
        (0..count).map(|i| (self.points[i], self.points[(i + 1) % n])).collect()
    }

    pub fn area2(&self) -> i128 {
        self.edges().iter().map(|&(a, b)| cross(a, b)).sum()
    }

    /// The winding number of a point that is on no edge, for a polygon that turns left.
    fn winding(&self, p: P) -> i128 {
        let mut w = 0;
        for (a, b) in self.edges() {
            let (up, below) = ((b.1 * SCALE > p.1), (a.1 * SCALE > p.1));
            if up != below {
                let side = cross(sub(b, a), (p.0 - a.0 * SCALE, p.1 - a.1 * SCALE));
                assert_ne!(side, 0);
                w += if up && side > 0 {
                    1
                } else if !up && side < 0 {
                    -1
                } else {
                    0
                };
            }
        }
        w * self.area2().signum()
    }
}

impl Scene {
    /// The number of solids, minus holes, that contain a point `p / SCALE` that is on no edge.
    pub fn winding(&self, p: P) -> i128 {
        let of = |s: &Shape| match s.kind {
            PathKind::Solid => s.winding(p),
            PathKind::Hole => -s.winding(p),
            _ => 0,
        };
        self.shapes.iter().map(of).sum()
    }

    /// The boundary of the polygons after opposite edges cancel, cut where others on the same line
    /// end, each piece once.
    pub fn boundary(&self) -> Vec<Piece> {
        // By direction and distance from the origin: from, to, and the sign of the direction.
        let mut lines = BTreeMap::<(P, i128), Vec<Extent>>::new();
        for shape in self.shapes.iter().filter(|s| s.closed()) {
            let turn = shape.area2().signum() * if shape.kind == PathKind::Hole { -1 } else { 1 };
            for (a, b) in shape.edges() {
                let d = sub(b, a);
                let g = gcd(d.0, d.1);
                let mut dir = (d.0 / g, d.1 / g);
                let mut sign = turn;
                if dir < (0, 0) {
                    dir = (-dir.0, -dir.1);
                    sign = -sign;
                }
                let (s, t) = (dot(a, dir), dot(b, dir));
                lines.entry((dir, cross(dir, a))).or_default().push((s.min(t), s.max(t), sign));
            }
        }
        let mut out = Vec::new();
        for ((dir, offset), edges) in lines {
            let mut cuts: Vec<i128> = edges.iter().flat_map(|e| [e.0, e.1]).collect();
            cuts.sort_unstable();
            cuts.dedup();
            let len2 = dot(dir, dir);
            // p . dir = s and dir x p = offset.
            let at = |s: i128| ((dir.0 * s - dir.1 * offset) / len2, (dir.1 * s + dir.0 * offset) / len2);
            for w in cuts.windows(2) {
                let net: i128 = edges.iter().filter(|e| e.0 <= w[0] && w[1] <= e.1).map(|e| e.2).sum();
                match net.signum() {
                    1 => out.push(Piece { a: at(w[0]), b: at(w[1]) }),
                    -1 => out.push(Piece { a: at(w[1]), b: at(w[0]) }),
                    _ => {}
                }
            }
        }
        out
    }

    /// The boundary, and the walls once.
    pub fn blocking(&self) -> Vec<Piece> {
        let mut out = self.boundary();
        let walls = self.shapes.iter().filter(|s| s.kind == PathKind::Wall);
        out.extend(walls.flat_map(Shape::edges).map(|(a, b)| Piece { a, b }));
        out
    }

    pub fn overlaps(&self, blocking: &[Piece], body: Body) -> bool {
        if body.has_area() {
            blocking.iter().any(|p| body.meets(p.a, p.b, false)) || self.winding(body.inner()) > 0
        } else {
            let (lo, hi) = body.bounds();
            if lo == hi { self.inside(lo) } else { thin::overlaps(self, lo, hi) }
        }
    }

    pub fn touches(&self, blocking: &[Piece], body: Body) -> bool {
        blocking.iter().any(|p| body.meets(p.a, p.b, true)) || self.winding(body.inner()) > 0
    }

    pub fn flags(&self, body: Body) -> u8 {
        let touched = |s: &&Shape| s.edges().iter().any(|&(a, b)| body.meets(a, b, true));
        self.shapes.iter().filter(touched).fold(0, |all, s| all | s.flags)
    }

    /// Whether a point has solid all around it: between any two neighbours of the directions of the
    /// edges through it.
    pub fn inside(&self, p: P) -> bool {
        let mut dirs: Vec<P> = vec![(1, 0), (0, 1), (-1, 0), (0, -1)];
        for (a, b) in self.shapes.iter().filter(|s| s.closed()).flat_map(Shape::edges) {
            let d = sub(b, a);
            let g = gcd(d.0, d.1);
            dirs.extend([(d.0 / g, d.1 / g), (-d.0 / g, -d.1 / g)]);
        }
        let half = |d: &P| d.1 < 0 || (d.1 == 0 && d.0 < 0);
        dirs.sort_by(|a, b| half(a).cmp(&half(b)).then(0.cmp(&cross(*a, *b))));
        dirs.dedup();
        let n = dirs.len();
        (0..n).all(|i| {
            let (u, v) = (dirs[i], dirs[(i + 1) % n]);
            self.winding((p.0 * SCALE + u.0 + v.0, p.1 * SCALE + u.1 + v.1)) > 0
        })
    }

    pub fn vec2(&self, p: P) -> Vec2 {
        Vec2::from_raw((p.0 + self.origin.0) as i32, (p.1 + self.origin.1) as i32)
    }

    pub fn local(&self, v: Vec2) -> P {
        let (x, y) = v.raw();
        (i128::from(x) - self.origin.0, i128::from(y) - self.origin.1)
    }

    /// The level in its byte form.
    pub fn bytes(&self) -> Vec<u8> {
        let points: Vec<Vec<Vec2>> =
            self.shapes.iter().map(|s| s.points.iter().map(|&p| self.vec2(p)).collect()).collect();
        let paths: Vec<Path<'_>> =
            self.shapes.iter().zip(&points).map(|(s, p)| Path { points: p, kind: s.kind, flags: s.flags }).collect();
        let cell = Fx::from_bits(self.cell);
        let size = match self.grid {
            None => tilesat::SegmentMap::measure(&paths, cell).unwrap(),
            Some((at, w, h)) => {
                tilesat::SegmentMap::measure_on(&paths, Grid::new(w, h, cell, self.vec2(at)).unwrap()).unwrap()
            }
        };
        let mut out = vec![0; size.bytes()];
        let len = tilesat::SegmentMap::build_on(&paths, size.grid(), &mut out).unwrap();
        assert_eq!(len, out.len());
        out
    }
}

impl Body {
    pub fn has_area(&self) -> bool {
        let (lo, hi) = self.bounds();
        lo.0 < hi.0 && lo.1 < hi.1
    }

    pub fn bounds(&self) -> (P, P) {
        match *self {
            Self::Box { lo, hi } => (lo, hi),
            Self::Circle { c, r } => ((c.0 - r, c.1 - r), (c.0 + r, c.1 + r)),
        }
    }

    /// A point of the body, times `SCALE`, that is on no edge: beside the middle in a direction
    /// that no edge of a small scene has.
    fn inner(&self) -> P {
        let (lo, hi) = self.bounds();
        ((lo.0 + hi.0) * (SCALE / 2) + 1, (lo.1 + hi.1) * (SCALE / 2) + (1 << 20))
    }

    /// Whether a segment meets the body, open or closed.
    pub fn meets(&self, a: P, b: P, closed: bool) -> bool {
        let below = |l: i128, r: i128| l < r || (closed && l == r);
        match *self {
            Self::Circle { c, r } => {
                let (d, m) = (sub(b, a), sub(c, a));
                let (along, len2) = (dot(d, m), dot(d, d));
                let end = |p: P| below(dot(sub(c, p), sub(c, p)), r * r);
                if along <= 0 {
                    end(a)
                } else if along >= len2 {
                    end(b)
                } else {
                    below(cross(d, m) * cross(d, m), r * r * len2)
                }
            }
            Self::Box { lo, hi } => {
                // The times at which the segment is inside each pair of sides, as fractions, and
                // [0, 1]. It reaches a side before or after it passes it, so for the open box there
                // must be a time between.
                let (mut from, mut to) = ((0, 1), (1, 1));
                for (o, d, lo, hi) in [(a.0, b.0 - a.0, lo.0, hi.0), (a.1, b.1 - a.1, lo.1, hi.1)] {
                    if d == 0 {
                        if !(below(lo, o) && below(o, hi)) {
                            return false;
                        }
                        continue;
                    }
                    let (enter, leave) = if d > 0 { (lo - o, hi - o) } else { (o - hi, o - lo) };
                    if enter * from.1 > from.0 * d.abs() {
                        from = (enter, d.abs());
                    }
                    if leave * to.1 < to.0 * d.abs() {
                        to = (leave, d.abs());
                    }
                }
                below(from.0 * to.1, to.0 * from.1)
            }
        }
    }
}
