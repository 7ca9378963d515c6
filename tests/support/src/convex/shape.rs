//! The six shapes as bare integers.

use crate::oracle::figure::{Point, in_domain};
use crate::oracle::sum::Sum;

/// The most corners of a polygon here; sums of two have at most twice as many.
pub const MOST: usize = 6;

/// A shape of which nothing is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    Aabb {
        min: Point,
        max: Point,
    },
    Circle {
        centre: Point,
        radius: i64,
    },
    Segment {
        a: Point,
        b: Point,
    },
    Capsule {
        a: Point,
        b: Point,
        radius: i64,
    },
    Turned {
        centre: Point,
        half: Point,
        direction: Point,
        radius: i64,
    },
    /// Strictly convex, in order, either way round.
    Polygon {
        points: [Point; MOST],
        count: usize,
        radius: i64,
    },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Aabb,
    Circle,
    Segment,
    Capsule,
    Turned,
    Polygon,
}

pub const KINDS: [Kind; 6] = [Kind::Aabb, Kind::Circle, Kind::Segment, Kind::Capsule, Kind::Turned, Kind::Polygon];

/// The unordered pairs with at least one of the three that are not plain.
pub fn pairs() -> impl Iterator<Item = (Kind, Kind)> {
    (3..6).flat_map(|i| (0..=i).map(move |j| (KINDS[i], KINDS[j])))
}

/// `h d / |d|` for a component `d` of a direction with the square `square`, to nearest: twice it
/// rounded down, and half of that up.
fn part(h: i64, d: i64, square: u128) -> i64 {
    let twice = 2 * u128::from(h.unsigned_abs()) * u128::from(d.unsigned_abs());
    let floor = (twice * twice / square).isqrt() as i64;
    (floor + 1) / 2 * d.signum()
}

impl Shape {
    pub fn polygon(points: &[Point], radius: i64) -> Self {
        let mut all = [(0, 0); MOST];
        all[..points.len()].copy_from_slice(points);
        Self::Polygon { points: all, count: points.len(), radius }
    }

    /// A box, a circle or a segment: among themselves they have kernels of their kind.
    pub const fn is_plain(&self) -> bool {
        matches!(self, Self::Aabb { .. } | Self::Circle { .. } | Self::Segment { .. })
    }

    /// The points whose hull, grown by [`radius`](Self::radius), is the shape.
    pub fn vertices(&self) -> Vec<Point> {
        match *self {
            Self::Aabb { min, max } => vec![min, (max.0, min.1), max, (min.0, max.1)],
            Self::Circle { centre, .. } => vec![centre],
            Self::Segment { a, b } | Self::Capsule { a, b, .. } => vec![a, b],
            Self::Turned { centre: c, half, direction: d, .. } => {
                let square = (i128::from(d.0).pow(2) + i128::from(d.1).pow(2)) as u128;
                let u = (part(half.0, d.0, square), part(half.0, d.1, square));
                let v = (part(half.1, -d.1, square), part(half.1, d.0, square));
                let at = |s: i64, t: i64| (c.0 + s * u.0 + t * v.0, c.1 + s * u.1 + t * v.1);
                vec![at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)]
            }
            Self::Polygon { points, count, .. } => points[..count].to_vec(),
        }
    }

    pub const fn radius(&self) -> i64 {
        match *self {
            Self::Circle { radius, .. }
            | Self::Capsule { radius, .. }
            | Self::Turned { radius, .. }
            | Self::Polygon { radius, .. } => radius,
            _ => 0,
        }
    }

    /// The shape without its radius.
    pub fn sharp(&self) -> Self {
        match *self {
            Self::Circle { centre, .. } => Self::Circle { centre, radius: 0 },
            Self::Capsule { a, b, .. } => Self::Capsule { a, b, radius: 0 },
            Self::Turned { centre, half, direction, .. } => Self::Turned { centre, half, direction, radius: 0 },
            Self::Polygon { points, count, .. } => Self::Polygon { points, count, radius: 0 },
            other => other,
        }
    }

    pub fn moved(&self, by: Point) -> Self {
        self.map(|p| (p.0 + by.0, p.1 + by.1), |d| d)
    }

    /// Points mapped by `f`, directions by `turn`. `f` keeps distances. Puts a box back in order.
    pub fn map(&self, f: impl Fn(Point) -> Point, turn: impl Fn(Point) -> Point) -> Self {
        match *self {
            Self::Aabb { min, max } => {
                let (p, q) = (f(min), f(max));
                Self::Aabb { min: (p.0.min(q.0), p.1.min(q.1)), max: (p.0.max(q.0), p.1.max(q.1)) }
            }
            Self::Circle { centre, radius } => Self::Circle { centre: f(centre), radius },
            Self::Segment { a, b } => Self::Segment { a: f(a), b: f(b) },
            Self::Capsule { a, b, radius } => Self::Capsule { a: f(a), b: f(b), radius },
            Self::Turned { centre, half, direction, radius } => {
                Self::Turned { centre: f(centre), half, direction: turn(direction), radius }
            }
            Self::Polygon { points, count, radius } => {
                Self::polygon(&points[..count].iter().map(|p| f(*p)).collect::<Vec<_>>(), radius)
            }
        }
    }

    /// Inside the domain with its whole extent.
    pub fn in_domain(&self) -> bool {
        in_domain(&self.vertices(), self.radius())
    }
}

/// The direction of the turn `p`, `q`, `r`.
fn turn(p: Point, q: Point, r: Point) -> i128 {
    let (x, y) = (i128::from(q.0 - p.0), i128::from(q.1 - p.1));
    (x * i128::from(r.1 - p.1) - y * i128::from(r.0 - p.0)).signum()
}

/// The convex hull, counter-clockwise (y up), strictly: Andrew's two chains.
pub fn hull(points: &[Point]) -> Vec<Point> {
    let mut sorted = points.to_vec();
    sorted.sort_unstable();
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let chain = |points: &mut dyn Iterator<Item = Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for p in points {
            while chain.len() > 1 && turn(chain[chain.len() - 2], chain[chain.len() - 1], p) <= 0 {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut lower = chain(&mut sorted.iter().copied());
    lower.extend(chain(&mut sorted.iter().rev().copied()));
    lower
}

/// `A + (-B)`: the hull of all differences of vertices, and the radii.
pub fn sum(a: &Shape, b: &Shape) -> Sum {
    let (p, q) = (a.vertices(), b.vertices());
    let all: Vec<Point> = p.iter().flat_map(|p| q.iter().map(move |q| (p.0 - q.0, p.1 - q.1))).collect();
    Sum::of_hull(&hull(&all), a.radius() + b.radius())
}
