//! A fast exact judge of pairs of shapes, in 128-bit integers.
//!
//! It compares two cores (points, segments, boxes) by the intervals of their difference `A - B`
//! along x, y and across every side. The origin is in the interior if it is strictly inside all
//! intervals and the difference has area. It is outside if it is outside one interval. The distance
//! is that of a corner of one core and a side of the other. Each distance is a fraction, compared
//! with a radius by products. Nothing divides or takes a root, and nothing shares code with the
//! library. The self test checks that it equals big rationals.
//!
//! Coordinates are below 2^30, so a cross product is below 2^62. Its square, and a squared radius
//! times a squared length, are below 2^124.

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
    points: [Point; 4],
    count: usize,
    pub radius: i64,
}

fn sub(a: Point, b: Point) -> Point {
    (a.0 - b.0, a.1 - b.1)
}

fn cross(a: Point, b: Point) -> i128 {
    i128::from(a.0) * i128::from(b.1) - i128::from(a.1) * i128::from(b.0)
}

fn dot(a: Point, b: Point) -> i128 {
    i128::from(a.0) * i128::from(b.0) + i128::from(a.1) * i128::from(b.1)
}

impl Core {
    pub fn of(figure: &Figure) -> Self {
        let (points, count) = figure.corners();
        Self { points, count, radius: figure.radius() }
    }

    /// A point that moves by `d` is a segment.
    fn swept(&self, d: Point) -> Self {
        let p = self.points[0];
        Self { points: [p, (p.0 + d.0, p.1 + d.1), p, p], count: 2, ..*self }
    }

    fn points(&self) -> &[Point] {
        &self.points[..self.count]
    }

    /// Each side once. A point has one side, without length.
    fn sides(&self) -> impl Iterator<Item = (Point, Point)> + '_ {
        let sides = if self.count < 3 { 1 } else { self.count };
        (0..sides).map(|i| (self.points[i], self.points[(i + 1) % self.count]))
    }

    /// The direction of the one side that a segment has.
    fn edge(&self) -> Point {
        if self.count == 2 { sub(self.points[1], self.points[0]) } else { (0, 0) }
    }

    /// Least and greatest height along an axis.
    fn span(&self, n: Point) -> (i128, i128) {
        let mut all = self.points().iter().map(|&p| dot(p, n));
        let first = all.next().unwrap_or(0);
        all.fold((first, first), |(lo, hi), h| (lo.min(h), hi.max(h)))
    }

    /// Its extents along x and y.
    fn size(&self) -> Point {
        let span = |n| {
            let (lo, hi) = self.span(n);
            (hi - lo) as i64
        };
        (span((1, 0)), span((0, 1)))
    }
}

/// A and B, and optionally the way of A.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    a: Core,
    b: Core,
    pub radius: i64,
}

impl Pair {
    pub fn new(a: &Figure, b: &Figure) -> Self {
        let (a, b) = (Core::of(a), Core::of(b));
        Self { a, b, radius: a.radius + b.radius }
    }

    /// The axes across all sides of the difference and of a way. Zero axes decide nothing.
    fn axes(&self, way: Point) -> [Point; 5] {
        let across = |e: Point| (-e.1, e.0);
        [(1, 0), (0, 1), across(self.a.edge()), across(self.b.edge()), across(way)]
    }

    /// Whether the difference of the cores has area: whether two of its sides are not parallel.
    fn has_area(&self) -> bool {
        let sides = |c: &Core| {
            let (w, h) = c.size();
            if c.count == 4 { [(w, 0), (0, h)] } else { [c.edge(), (0, 0)] }
        };
        let ([p, q], [r, s]) = (sides(&self.a), sides(&self.b));
        let all = [p, q, r, s];
        all.iter().enumerate().any(|(i, &u)| all[i + 1..].iter().any(|&v| cross(u, v) != 0))
    }

    /// Position of the origin in `A - B`, with A swept along its way.
    fn place(&self, way: Point) -> Place {
        let mut place = if self.has_area() { Place::Inside } else { Place::On };
        for n in self.axes(way) {
            if n == (0, 0) {
                continue;
            }
            let ((a0, a1), (b0, b1)) = (self.a.span(n), self.b.span(n));
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

    /// Whether disjoint cores are nearer than a distance. With `closed`, at most that far.
    fn nearer(&self, distance: i64, closed: bool) -> bool {
        near_corners(&self.a, &self.b, distance, closed) || near_corners(&self.b, &self.a, distance, closed)
    }

    pub fn overlaps(&self) -> bool {
        match self.place((0, 0)) {
            Place::Inside => true,
            Place::On => self.radius > 0,
            Place::Outside => self.nearer(self.radius, false),
        }
    }

    pub fn touches(&self) -> bool {
        self.place((0, 0)) != Place::Outside || self.nearer(self.radius, true)
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
        match self.place((0, 0)) {
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
            && self.axes((0, 0)).iter().filter(|n| **n != (0, 0)).any(|&n| {
                let ((a0, a1), (b0, b1)) = (self.a.span(n), self.b.span(n));
                let least = (a1 - b0).min(b1 - a0);
                least * least <= i128::from(d).pow(2) * dot(n, n)
            })
    }

    /// Whether A, moving along `d`, will overlap B. They do not overlap at the start.
    pub fn is_met(&self, d: Point) -> bool {
        if self.radius == 0 {
            return self.has_area() && self.place(d) == Place::Inside;
        }
        // One of them is a disc: its centre moves.
        let swept = if self.a.count == 1 {
            Self { a: self.a.swept(d), ..*self }
        } else {
            Self { a: self.b.swept((-d.0, -d.1)), b: self.a, ..*self }
        };
        swept.place((0, 0)) != Place::Outside || swept.nearer(self.radius, false)
    }
}

/// Whether a corner of one core is nearer to a side of another than a distance. With `closed`, at
/// most that far.
fn near_corners(a: &Core, b: &Core, distance: i64, closed: bool) -> bool {
    let limit = i128::from(distance).pow(2);
    let below = |x: i128, y: i128| if closed { x <= y } else { x < y };
    distance >= 0
        && a.points().iter().any(|&p| {
            b.sides().any(|(u, v)| {
                let (e, m) = (sub(v, u), sub(p, u));
                let (along, whole) = (dot(m, e), dot(e, e));
                if along <= 0 {
                    below(dot(m, m), limit)
                } else if along >= whole {
                    let m = sub(p, v);
                    below(dot(m, m), limit)
                } else {
                    below(cross(e, m).pow(2), limit * whole)
                }
            })
        })
}
