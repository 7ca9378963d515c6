//! Random scenes and bodies.

use super::{Body, P, Scene, Shape, cross, sub};
use crate::Random;
use tilesat::PathKind;

/// Sides of cells.
const CELLS: [i32; 8] = [256, 258, 300, 512, 14 * 64, 1022, 4096, 1 << 16];

fn lattice(random: &mut Random, step: i128, size: i64) -> P {
    (i128::from(random.within(0, size)) * step, i128::from(random.within(0, size)) * step)
}

/// Corners in the order of their directions from a point among them, so that no two edges cross.
fn star(random: &mut Random, step: i128, size: i64) -> Vec<P> {
    let mut points: Vec<P> = (0..random.within(3, 7)).map(|_| lattice(random, step, size)).collect();
    let c = points.iter().fold((0, 0), |s, p| (s.0 + p.0, s.1 + p.1));
    let n = points.len() as i128;
    let key = |p: &P| (p.0 * n - c.0, p.1 * n - c.1);
    let half = |d: P| d.1 < 0 || (d.1 == 0 && d.0 < 0);
    points.sort_by(|a, b| half(key(a)).cmp(&half(key(b))).then(0.cmp(&cross(key(a), key(b)))));
    points
}

fn polygon(random: &mut Random, step: i128, size: i64) -> Vec<P> {
    let points = match random.below(6) {
        0 | 1 => {
            let (a, b) = (lattice(random, step, size), lattice(random, step, size));
            vec![a, (b.0, a.1), b, (a.0, b.1)]
        }
        2 => {
            let (a, k) = (lattice(random, step, size), step * i128::from(random.within(1, 4)));
            let m = k * 2;
            vec![a, (a.0 + m, a.1), (a.0 + m, a.1 + k), (a.0 + k, a.1 + k), (a.0 + k, a.1 + m), (a.0, a.1 + m)]
        }
        3 => (0..random.within(3, 6)).map(|_| lattice(random, step, size)).collect(),
        _ => star(random, step, size),
    };
    let mut points: Vec<P> = if random.one_in(3) {
        let by = (i128::from(random.around(2)), i128::from(random.around(2)));
        points.iter().map(|p| (p.0 + by.0, p.1 + by.1)).collect()
    } else {
        points
    };
    points.dedup();
    if points.first() == points.last() {
        points.pop();
    }
    if random.one_in(2) {
        points.reverse();
    }
    points
}

/// Polygons of all kinds, overlapping, touching, with holes, in either winding; walls; one-way
/// chains.
pub fn scene(random: &mut Random) -> Scene {
    let size = random.within(3, 12);
    let step = i128::from([64, 128, 150, 256, 300, 512][random.below(6) as usize]);
    let cell = CELLS[random.below(CELLS.len() as i64) as usize];
    let mut shapes = Vec::new();
    while shapes.is_empty() || (shapes.len() < 7 && !random.one_in(4)) {
        let kind = match random.below(10) {
            0 => PathKind::Wall,
            1 => PathKind::OneWay,
            2 => PathKind::Hole,
            _ => PathKind::Solid,
        };
        let mut points = polygon(random, step, size);
        if matches!(kind, PathKind::Wall | PathKind::OneWay) {
            points.truncate(random.within(2, 4) as usize);
        }
        let flags = 1 << random.below(8);
        let shape = Shape { kind, flags, points };
        let closed = matches!(kind, PathKind::Solid | PathKind::Hole);
        let least = if closed { 3 } else { 2 };
        if shape.points.len() < least || (closed && shape.area2() == 0) {
            continue;
        }
        shapes.push(shape);
    }
    let far = (1i128 << 29) - (1 << 20);
    let near = |random: &mut Random| i128::from(random.around(1 << 20));
    let origin = match random.below(4) {
        0 => (0, 0),
        1 => (-far, far),
        2 => (far, -far),
        _ => (near(random), near(random)),
    };
    let mut scene = Scene { shapes, origin, cell, grid: None };
    if random.one_in(2) {
        // A grid around all, with lines through the lattice or beside it.
        let (lo, hi) = scene.bounds();
        let cell = i128::from(cell);
        let back = |random: &mut Random| [0, 0, cell, cell / 2, 1, 2][random.below(6) as usize];
        let at = (lo.0 - back(random), lo.1 - back(random));
        let count = |lo: i128, hi: i128, more: i64| ((hi - lo + cell - 1) / cell).max(1) as u16 + more as u16;
        let (w, h) = (count(at.0, hi.0, random.below(3)), count(at.1, hi.1, random.below(3)));
        scene.grid = Some((at, w, h));
    }
    scene
}

impl Scene {
    pub fn bounds(&self) -> (P, P) {
        let points = || self.shapes.iter().flat_map(|s| s.points.iter());
        let (x, y) = (|p: &P| p.0, |p: &P| p.1);
        let lo = (points().map(x).min().unwrap(), points().map(y).min().unwrap());
        (lo, (points().map(x).max().unwrap(), points().map(y).max().unwrap()))
    }

    /// An interesting point or one up to 2 raw off: a corner, a lattice point, a crossing of a grid
    /// line, on or near an edge, anywhere.
    pub fn point(&self, random: &mut Random) -> P {
        let (lo, hi) = self.bounds();
        let shape = &self.shapes[random.below(self.shapes.len() as i64) as usize];
        let i = random.below(shape.points.len() as i64) as usize;
        let a = shape.points[i];
        let b = shape.points[(i + 1) % shape.points.len()];
        let within =
            |random: &mut Random, lo: i128, hi: i128| i128::from(random.within(lo as i64 - 300, hi as i64 + 300));
        let p = match random.below(6) {
            0 | 1 => a,
            2 => {
                let (k, d) = (i128::from(random.within(0, 16)), sub(b, a));
                (a.0 + d.0 * k / 16, a.1 + d.1 * k / 16)
            }
            3 => {
                let cell = i128::from(self.cell);
                let at = self.grid.map_or(lo, |g| g.0);
                let line = |v: i128, at: i128| at + (v - at) / cell * cell;
                (line(within(random, lo.0, hi.0), at.0), line(within(random, lo.1, hi.1), at.1))
            }
            4 => (a.0, b.1),
            _ => (within(random, lo.0, hi.0), within(random, lo.1, hi.1)),
        };
        let near = |random: &mut Random| if random.one_in(2) { 0 } else { i128::from(random.around(2)) };
        (p.0 + near(random), p.1 + near(random))
    }

    pub fn body(&self, random: &mut Random) -> Body {
        let p = self.point(random);
        match random.below(8) {
            0 => Body::Box { lo: p, hi: p },
            1 => {
                let q = self.point(random);
                let q = if random.one_in(2) { (p.0, q.1) } else { (q.0, p.1) };
                Body::Box { lo: (p.0.min(q.0), p.1.min(q.1)), hi: (p.0.max(q.0), p.1.max(q.1)) }
            }
            2 | 3 => {
                let q = self.point(random);
                Body::Box { lo: (p.0.min(q.0), p.1.min(q.1)), hi: (p.0.max(q.0), p.1.max(q.1)) }
            }
            4 => {
                let s = i128::from(random.magnitude(1000));
                Body::Box { lo: p, hi: (p.0 + s, p.1 + s) }
            }
            5 => Body::Circle { c: p, r: i128::from(random.magnitude(2000)) },
            _ => {
                // As far from a corner as a Pythagorean triple is long, or a raw unit more or less.
                let (a, b, c) = [(3, 4, 5), (8, 15, 17), (20, 21, 29), (0, 1, 1), (1, 0, 1)][random.below(5) as usize];
                let k = i128::from(random.within(1, 40));
                let s = (i128::from(random.sign()), i128::from(random.sign()));
                let c_ = (p.0 + s.0 * a * k, p.1 + s.1 * b * k);
                Body::Circle { c: c_, r: (c * k + i128::from(random.around(1))).max(0) }
            }
        }
    }
}
