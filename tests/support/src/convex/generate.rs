//! Streams of pairs: anywhere, on small lattices, touching to the bit, nearly touching, up to the
//! ends of the domain.

use super::shape::{Kind, MOST, Shape, hull, sum};
use crate::oracle::figure::{LIMIT, Point};
use crate::{Random, gcd};

/// The class of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Anywhere in 64 units.
    Uniform,
    /// A few lattice points of any spacing: full of ties, parallels and flat shapes.
    Lattice,
    /// The origin on the border of the sum: a corner, a point of a side, or an arc by a Pythagorean
    /// triple.
    Touch,
    /// The same, and then up to 2 raw off.
    Near,
    /// Up to the ends of the domain.
    Domain,
    /// Slivers: sides that are nearly parallel, corners that are nearly flat.
    Thin,
}

pub const CLASSES: [Class; 6] = [Class::Uniform, Class::Lattice, Class::Touch, Class::Near, Class::Domain, Class::Thin];

pub struct Pairs {
    pub random: Random,
    pair: (Kind, Kind),
    class: Class,
}

impl Pairs {
    pub fn new(pair: (Kind, Kind), class: Class, seed: u64) -> Self {
        let random = Random::new(seed ^ (pair.0 as u64) << 40 ^ (pair.1 as u64) << 44 ^ (class as u64) << 48);
        Self { random, pair, class }
    }

    /// The next pair, inside the domain, in the order of kinds asked for.
    #[allow(clippy::should_implement_trait, reason = "it never ends, and is no iterator")]
    pub fn next(&mut self) -> (Shape, Shape) {
        loop {
            let (a, b) = self.propose();
            if a.in_domain() && b.in_domain() {
                return (a, b);
            }
        }
    }

    fn propose(&mut self) -> (Shape, Shape) {
        let r = &mut self.random;
        let (i, j) = self.pair;
        match self.class {
            Class::Uniform => (shape(r, i, 1 << 22, 1), shape(r, j, 1 << 22, 1)),
            Class::Lattice => {
                let unit = [1, 1, 3, 1 << 16, 44_000_003][r.below(5) as usize];
                let size = r.within(1, 6);
                (shape(r, i, size, unit), shape(r, j, size, unit))
            }
            Class::Touch => touching(r, i, j),
            Class::Near => {
                let (a, b) = touching(r, i, j);
                (a.moved((r.around(2), r.around(2))), b)
            }
            Class::Domain => {
                let (a, b) = (shape(r, i, LIMIT - 1, 1), shape(r, j, LIMIT - 1, 1));
                if r.one_in(2) { (a, b) } else { touch(r, a, b) }
            }
            Class::Thin => {
                let (a, b) = (thin(r, i), thin(r, j));
                if r.one_in(2) { (a, b) } else { touch(r, a, b) }
            }
        }
    }
}

fn touching(r: &mut Random, i: Kind, j: Kind) -> (Shape, Shape) {
    let (size, unit) = if r.one_in(2) { (r.within(1, 9), 1) } else { (1 << 20, 1) };
    let (a, b) = (shape(r, i, size, unit), shape(r, j, size, unit));
    touch(r, a, b)
}

/// Moves A so that the origin comes to the border of the sum.
pub fn touch(r: &mut Random, a: Shape, b: Shape) -> (Shape, Shape) {
    let sum = sum(&a, &b);
    let border = sum.points();
    let at = r.below(border.len() as i64) as usize;
    let (p, q) = (border[at], border[(at + 1) % border.len()]);
    let e = (q.0 - p.0, q.1 - p.1);
    let g = gcd(e.0, e.1).max(1);
    let k = if r.one_in(3) { 0 } else { r.within(0, g) };
    let on = (p.0 + e.0 / g * k, p.1 + e.1 / g * k);
    // Out of there by the radii, in a direction in which that is whole: an axis, a triple, or
    // across the side if it is one.
    let n = sum.radius;
    let (x, y, h) = [(1, 0, 1), (3, 4, 5), (5, 12, 13), (4, 3, 5), (0, 1, 1)][r.below(5) as usize];
    let out = if n % h == 0 { (r.sign() * x * n / h, r.sign() * y * n / h) } else { (r.sign() * n, 0) };
    (a.moved((-on.0 + out.0, -on.1 + out.1)), b)
}

/// A shape whose numbers are multiples of `unit`, in the square of half side `size`.
pub fn shape(r: &mut Random, kind: Kind, size: i64, unit: i64) -> Shape {
    let point = |r: &mut Random| (r.around(size) * unit, r.around(size) * unit);
    let round = |r: &mut Random| match r.below(3) {
        0 => 0,
        1 => r.within(0, size) * unit,
        _ => r.within(0, size / 4) * unit,
    };
    match kind {
        Kind::Aabb => {
            let (p, q) = (point(r), point(r));
            Shape::Aabb { min: (p.0.min(q.0), p.1.min(q.1)), max: (p.0.max(q.0), p.1.max(q.1)) }
        }
        Kind::Circle => Shape::Circle { centre: point(r), radius: r.within(0, size) * unit },
        Kind::Segment => Shape::Segment { a: point(r), b: point(r) },
        Kind::Capsule => Shape::Capsule { a: point(r), b: point(r), radius: round(r) },
        Kind::Turned => {
            let direction = match r.below(4) {
                0 => [(1, 0), (0, 1), (-1, 0), (0, -1)][r.below(4) as usize],
                1 => ((1 + r.below(5)) * r.sign(), (1 + r.below(5)) * r.sign()),
                2 => (r.around(1 << 30) | 1, r.around(1 << 30)),
                _ => [(3, 4), (4, -3), (-5, 12), (8, 15)][r.below(4) as usize],
            };
            let half = (r.within(0, size) * unit, r.within(0, size) * unit);
            Shape::Turned { centre: point(r), half, direction, radius: round(r) }
        }
        Kind::Polygon => {
            let count = r.within(3, MOST as i64);
            let points: Vec<Point> = (0..count).map(|_| point(r)).collect();
            wound(r, &points).map_or_else(|| shape_of_triangle(unit), |points| Shape::polygon(&points, round(r)))
        }
    }
}

fn shape_of_triangle(unit: i64) -> Shape {
    Shape::polygon(&[(0, 0), (unit, 0), (0, unit)], 0)
}

/// The hull of some points, from any corner, in either direction. `None` if they are on one line.
pub fn wound(r: &mut Random, points: &[Point]) -> Option<Vec<Point>> {
    let mut points = hull(points);
    if points.len() < 3 {
        return None;
    }
    let first = r.below(points.len() as i64) as usize;
    points.rotate_left(first);
    if r.one_in(2) {
        points.reverse();
    }
    Some(points)
}

/// Long in one direction, a few raw wide.
fn thin(r: &mut Random, kind: Kind) -> Shape {
    let long = 1 << r.within(8, 26);
    let d = (r.around(long), r.around(long));
    let mut near = |s: i64, t: i64| (d.0 * s / 8 + r.around(t), d.1 * s / 8 + r.around(t));
    let (p, q, m) = (near(-8, 2), near(8, 2), near(3, 3));
    match kind {
        Kind::Segment => Shape::Segment { a: p, b: q },
        Kind::Capsule => Shape::Capsule { a: p, b: q, radius: r.within(0, 3) },
        Kind::Turned => {
            let half = (r.within(0, long), r.within(0, 3));
            Shape::Turned { centre: (r.around(3), r.around(3)), half, direction: (d.0 | 1, d.1), radius: 0 }
        }
        Kind::Polygon => wound(r, &[p, q, m]).map_or_else(|| shape_of_triangle(3), |points| Shape::polygon(&points, 0)),
        other => shape(r, other, 6, 1),
    }
}
