//! A fast exact judge of pairs of shapes, in 128-bit integers.
//!
//! It compares two cores (points, segments, boxes, convex polygons) by the intervals of their
//! difference `A - B` along x, y and across every side. The origin is in the interior if it is
//! strictly inside all intervals and the difference has area. It is outside if it is outside one
//! interval. The distance is that of a corner of one core and a side of the other. Each distance is
//! a fraction, compared with a radius by products. Nothing divides or takes a root, and nothing
//! shares code with the library. The self test checks that it equals big rationals, and for the
//! convex family the exact fractions of the tests' judge.
//!
//! Coordinates are below 2^30, so a cross product is below 2^62. Its square, and a squared radius
//! times a squared length, are below 2^124. Arithmetic is checked: a product that does not fit ends
//! the run.

use tilesat_judge::convex::shape::{MOST, Shape};
use tilesat_judge::oracle::figure::{Figure, Point};

/// Position of the origin in the difference of two cores.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    Inside,
    On,
    Outside,
}

#[derive(Clone, Copy, Debug)]
pub struct Core {
    points: [Point; MOST],
    count: usize,
    /// All sides are along x or y: they need no axes besides these.
    upright: bool,
    pub radius: i64,
}

fn sub(a: Point, b: Point) -> Point {
    (a.0 - b.0, a.1 - b.1)
}

fn cross(a: Point, b: Point) -> i64 {
    a.0 * b.1 - a.1 * b.0
}

fn dot(a: Point, b: Point) -> i64 {
    a.0 * b.0 + a.1 * b.1
}

fn square(n: i64) -> i128 {
    i128::from(n) * i128::from(n)
}

impl From<&Figure> for Core {
    fn from(figure: &Figure) -> Self {
        let (points, count) = figure.corners();
        Self::of(&points[..count], figure.radius(), count == 4)
    }
}

impl From<&Shape> for Core {
    fn from(shape: &Shape) -> Self {
        Self::of(&shape.vertices(), shape.radius(), matches!(shape, Shape::Aabb { .. }))
    }
}

impl Core {
    fn of(corners: &[Point], radius: i64, upright: bool) -> Self {
        let mut points = [(0, 0); MOST];
        points[..corners.len()].copy_from_slice(corners);
        Self { points, count: corners.len(), upright, radius }
    }

    fn moved(&self, by: Point) -> Self {
        Self { points: self.points.map(|p| (p.0 + by.0, p.1 + by.1)), ..*self }
    }

    /// A point that moves by `d` is a segment.
    fn swept(&self, d: Point) -> Self {
        let p = self.points[0];
        Self::of(&[p, (p.0 + d.0, p.1 + d.1)], self.radius, false)
    }

    fn points(&self) -> &[Point] {
        &self.points[..self.count]
    }

    /// Each side once. A point has one side, without length.
    fn sides(&self) -> impl Iterator<Item = (Point, Point)> + '_ {
        let sides = if self.count < 3 { 1 } else { self.count };
        (0..sides).map(|i| (self.points[i], self.points[(i + 1) % self.count]))
    }

    /// The directions of all sides, also of those without length.
    fn edges(&self) -> impl Iterator<Item = Point> + '_ {
        self.sides().map(|(p, q)| sub(q, p))
    }

    /// Least and greatest height along an axis.
    fn span(&self, n: Point) -> (i64, i64) {
        let mut all = self.points().iter().map(|&p| dot(p, n));
        let first = all.next().unwrap_or(0);
        all.fold((first, first), |(lo, hi), h| (lo.min(h), hi.max(h)))
    }
}

/// The axes across all sides of the difference and of a way. Other axes decide nothing.
fn axes(a: &Core, b: &Core, way: Point) -> impl Iterator<Item = Point> {
    let slanted = |core: &Core| if core.upright { 0 } else { core.count };
    let edges = a.edges().take(slanted(a)).chain(b.edges().take(slanted(b)));
    let across = edges.chain([way]).map(|e| (-e.1, e.0)).filter(|n| *n != (0, 0));
    [(1, 0), (0, 1)].into_iter().chain(across)
}

/// Whether the difference of the cores has area: whether two of its sides are not parallel.
fn has_area(a: &Core, b: &Core) -> bool {
    let mut edges = a.edges().chain(b.edges()).filter(|e| *e != (0, 0));
    edges.next().is_some_and(|u| edges.any(|v| cross(u, v) != 0))
}

/// Position of the origin in `A - B`, with A swept along its way.
fn place(a: &Core, b: &Core, way: Point) -> Place {
    let mut place = if has_area(a, b) { Place::Inside } else { Place::On };
    for n in axes(a, b, way) {
        let ((a0, a1), (b0, b1)) = (a.span(n), b.span(n));
        let h = dot(way, n);
        let (lo, hi) = (a0 + h.min(0) - b1, a1 + h.max(0) - b0);
        if lo > 0 || hi < 0 {
            return Place::Outside;
        }
        if lo == 0 || hi == 0 {
            place = Place::On;
        }
    }
    place
}

/// A and B.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    a: Core,
    b: Core,
    pub radius: i64,
    /// Position of the origin in `A - B`.
    here: Place,
}

impl Pair {
    pub fn new(a: impl Into<Core>, b: impl Into<Core>) -> Self {
        let (a, b) = (a.into(), b.into());
        Self { a, b, radius: a.radius + b.radius, here: place(&a, &b, (0, 0)) }
    }

    /// With A moved.
    pub fn moved(&self, by: Point) -> Self {
        Self::new(self.a.moved(by), self.b)
    }

    /// Whether disjoint cores are nearer than a distance. With `closed`, at most that far.
    fn nearer(&self, distance: i64, closed: bool) -> bool {
        near_corners(&self.a, &self.b, distance, closed) || near_corners(&self.b, &self.a, distance, closed)
    }

    pub fn overlaps(&self) -> bool {
        match self.here {
            Place::Inside => true,
            Place::On => self.radius > 0,
            Place::Outside => self.nearer(self.radius, false),
        }
    }

    pub fn touches(&self) -> bool {
        self.here != Place::Outside || self.nearer(self.radius, true)
    }

    /// `d` is the distance, rounded down.
    pub fn distance_is(&self, d: i64) -> bool {
        if self.touches() {
            return d == 0;
        }
        d >= 0 && !self.nearer(self.radius + d, false) && self.nearer(self.radius + d + 1, false)
    }

    /// `d` is the shortest way out of an overlap, rounded up.
    pub fn depth_is(&self, d: i64) -> bool {
        match self.here {
            // radius + distance to the nearest line
            Place::Inside => self.out_within(d - self.radius) && !self.out_within(d - self.radius - 1),
            Place::On => d == self.radius,
            // radius - distance: at most d where the distance is at least radius - d.
            Place::Outside => !self.nearer(self.radius - d, false) && self.nearer(self.radius - d + 1, false),
        }
    }

    /// Whether a line along a side of the difference is at most this far away. The origin is
    /// inside.
    fn out_within(&self, d: i64) -> bool {
        d >= 0
            && axes(&self.a, &self.b, (0, 0)).any(|n| {
                let ((a0, a1), (b0, b1)) = (self.a.span(n), self.b.span(n));
                let least = (a1 - b0).min(b1 - a0);
                square(least) <= square(d) * i128::from(dot(n, n))
            })
    }

    /// Whether A, moving along `d`, will overlap B. They do not overlap at the start.
    pub fn is_met(&self, d: Point) -> bool {
        if self.radius == 0 {
            return place(&self.a, &self.b, d) == Place::Inside;
        }
        // One of them is a disc: its centre moves.
        let swept = if self.a.count == 1 {
            Self::new(self.a.swept(d), self.b)
        } else {
            Self::new(self.b.swept((-d.0, -d.1)), self.a)
        };
        swept.here != Place::Outside || swept.nearer(self.radius, false)
    }
}

/// Whether a corner of one core is nearer to a side of another than a distance. With `closed`, at
/// most that far.
fn near_corners(a: &Core, b: &Core, distance: i64, closed: bool) -> bool {
    let limit = square(distance);
    let below = |x: i128, y: i128| if closed { x <= y } else { x < y };
    let beside = |m: Point| below(i128::from(dot(m, m)), limit);
    distance >= 0
        && a.points().iter().any(|&p| {
            b.sides().any(|(u, v)| {
                let (e, m) = (sub(v, u), sub(p, u));
                let (along, whole) = (dot(m, e), dot(e, e));
                if along <= 0 {
                    beside(m)
                } else if along >= whole {
                    beside(sub(p, v))
                } else {
                    below(square(cross(e, m)), limit * i128::from(whole))
                }
            })
        })
}
