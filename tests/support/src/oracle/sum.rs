//! The Minkowski sum `A + (-B)` of two cores as an explicit convex polygon, and the origin's place
//! in it.

use super::figure::{Figure, Point};
use super::int256::Int256;

/// Convex hull, counter-clockwise when y grows upward, no three vertices on a line. One vertex: a
/// point; two: a segment.
#[derive(Clone, Copy, Debug)]
pub struct Sum {
    points: [Point; 16],
    count: usize,
    /// Radius of the disc that is added on top.
    pub radius: i64,
}

/// Where the origin lies with respect to the polygon, the radius left aside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    Inside,
    /// On the boundary; for a sum without area, anywhere on it.
    On,
    Outside,
}

/// Twice the signed area of the triangle `p`, `q`, `r`.
pub fn orient(p: Point, q: Point, r: Point) -> Int256 {
    Int256::product(q.0 - p.0, r.1 - p.1) - Int256::product(q.1 - p.1, r.0 - p.0)
}

pub fn dot(p: Point, q: Point) -> Int256 {
    Int256::product(p.0, q.0) + Int256::product(p.1, q.1)
}

impl Sum {
    pub fn new(a: &Figure, b: &Figure) -> Self {
        let ((va, na), (vb, nb)) = (a.corners(), b.corners());
        let mut points = [(0, 0); 16];
        let mut count = 0;
        for p in &va[..na] {
            for q in &vb[..nb] {
                points[count] = (p.0 - q.0, p.1 - q.1);
                count += 1;
            }
        }
        let (points, count) = hull(points, count);
        Self { points, count, radius: a.radius() + b.radius() }
    }

    /// A sum by its hull: counter-clockwise (y up), strictly convex.
    pub fn of_hull(hull: &[Point], radius: i64) -> Self {
        let mut points = [(0, 0); 16];
        points[..hull.len()].copy_from_slice(hull);
        Self { points, count: hull.len(), radius }
    }

    pub fn points(&self) -> &[Point] {
        &self.points[..self.count]
    }

    /// The edges of the boundary; a point has the one edge from itself to itself, a segment has its
    /// two directions.
    pub fn edges(&self) -> impl Iterator<Item = (Point, Point)> + '_ {
        (0..self.count).map(|i| (self.points[i], self.points[if i + 1 == self.count { 0 } else { i + 1 }]))
    }

    pub const fn has_area(&self) -> bool {
        self.count > 2
    }

    pub fn place(&self) -> Place {
        let origin = (0, 0);
        match self.points() {
            [p] if *p == origin => Place::On,
            [_] => Place::Outside,
            [p, q] => {
                let between = dot(*p, *q).signum() <= 0;
                if orient(*p, *q, origin).signum() == 0 && between { Place::On } else { Place::Outside }
            }
            _ => match self.edges().map(|(p, q)| orient(p, q, origin).signum()).min() {
                Some(1) => Place::Inside,
                Some(0) => Place::On,
                _ => Place::Outside,
            },
        }
    }

    /// The largest `u . p` over the polygon.
    pub fn support(&self, u: Point) -> Int256 {
        self.points().iter().map(|p| dot(u, *p)).max().expect("a sum has at least one vertex")
    }
}

/// Andrew's monotone chain.
fn hull(mut points: [Point; 16], count: usize) -> ([Point; 16], usize) {
    points[..count].sort_unstable();
    let mut distinct = 1;
    for i in 1..count {
        if points[i] != points[distinct - 1] {
            points[distinct] = points[i];
            distinct += 1;
        }
    }
    if distinct < 3 {
        return (points, distinct);
    }
    let mut chain = [(0, 0); 32];
    let mut n = 0;
    for &p in &points[..distinct] {
        n = push(&mut chain, 0, n, p);
    }
    let lower = n - 1;
    for &p in points[..distinct - 1].iter().rev() {
        n = push(&mut chain, lower, n, p);
    }
    // The last point pushed is the first one again.
    let mut result = [(0, 0); 16];
    result[..n - 1].copy_from_slice(&chain[..n - 1]);
    (result, n - 1)
}

/// Appends `p` after dropping every vertex above `base` at which the chain would not turn left.
fn push(chain: &mut [Point; 32], base: usize, mut n: usize, p: Point) -> usize {
    while n >= base + 2 && orient(chain[n - 2], chain[n - 1], p).signum() <= 0 {
        n -= 1;
    }
    chain[n] = p;
    n + 1
}
