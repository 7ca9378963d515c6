//! Distances from the origin to the sum, as squared fractions, and all answers that follow from
//! them.

use super::figure::{Figure, Point};
use super::int256::Int256;
use super::sum::{Place, Sum, dot, orient};

/// A fraction that is not negative: `num / den`, `den > 0`, not reduced.
#[derive(Clone, Copy, Debug)]
pub struct Fraction {
    pub num: Int256,
    pub den: Int256,
}

impl Fraction {
    #[allow(clippy::should_implement_trait, reason = "by value, as all of its operations")]
    pub fn cmp(self, other: Self) -> core::cmp::Ordering {
        (self.num * other.den).cmp(&(other.num * self.den))
    }

    /// The sign of `sqrt(self) - n`.
    pub fn root_minus(self, n: i64) -> i32 {
        if n < 0 {
            return 1;
        }
        (self.num - Int256::product(n, n) * self.den).signum()
    }
}

/// The sum, relative to the origin.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    pub place: Place,
    /// Squared distance from the origin to the polygon's boundary.
    pub square: Fraction,
    pub radius: i64,
    /// Only one direction leads out of the grown sum by the shortest way.
    pub one_exit: bool,
}

impl Measure {
    pub fn new(a: &Figure, b: &Figure) -> Self {
        Self::of(&Sum::new(a, b))
    }

    pub fn of(sum: &Sum) -> Self {
        let place = sum.place();
        let (square, one_exit) = match place {
            Place::Outside => (nearest_edge(sum), true),
            Place::On => (
                Fraction { num: Int256::ZERO, den: Int256::ONE },
                // From inside an edge there is one outward normal, from a vertex a cone of them,
                // from a flat sum two sides.
                sum.has_area() && !sum.points().contains(&(0, 0)),
            ),
            Place::Inside => nearest_line(sum),
        };
        Self { place, square, radius: sum.radius, one_exit }
    }

    /// The origin is interior to the grown sum.
    pub fn overlaps(&self) -> bool {
        match self.place {
            Place::Inside => true,
            Place::On => self.radius > 0,
            Place::Outside => self.square.root_minus(self.radius) < 0,
        }
    }

    /// The origin belongs to the grown sum.
    pub fn touches(&self) -> bool {
        self.place != Place::Outside || self.square.root_minus(self.radius) <= 0
    }

    /// `d` is the floor of the distance between the shapes.
    pub fn distance_is(&self, d: i64) -> bool {
        if self.touches() {
            return d == 0;
        }
        d >= 0 && self.square.root_minus(self.radius + d) >= 0 && self.square.root_minus(self.radius + d + 1) < 0
    }

    /// `d` is the ceiling of the shortest way out. For overlapping shapes.
    pub fn depth_is(&self, d: i64) -> bool {
        self.depth_at_most(d) && !self.depth_at_most(d - 1)
    }

    fn depth_at_most(&self, d: i64) -> bool {
        match self.place {
            // radius + sqrt(square) <= d
            Place::Inside => d >= self.radius && self.square.root_minus(d - self.radius) <= 0,
            // radius - sqrt(square) <= d
            _ => self.square.root_minus(self.radius - d) >= 0,
        }
    }

    /// The exit along `u` (any length) is exactly the shortest one.
    pub fn is_shortest_exit(&self, sum: &Sum, u: Point) -> bool {
        // The polygon's extent along the unit vector is support / |u|; it is negative when the
        // origin lies outside.
        let extent = sum.support(u);
        let right_side = match self.place {
            Place::Inside => extent.signum() > 0,
            Place::On => extent.signum() == 0,
            Place::Outside => extent.signum() < 0,
        };
        let along = Fraction { num: extent.squared(), den: dot(u, u) };
        right_side && along.cmp(self.square) == core::cmp::Ordering::Equal
    }
}

/// Squared distance from an origin outside the polygon to the polygon.
fn nearest_edge(sum: &Sum) -> Fraction {
    let squares = sum.edges().map(|(p, q)| to_edge(p, q));
    squares.min_by(|x, y| x.cmp(*y)).expect("a sum has at least one edge")
}

/// Squared distance from the origin to the segment from `p` to `q`.
pub fn to_edge(p: Point, q: Point) -> Fraction {
    let e = (q.0 - p.0, q.1 - p.1);
    let along = -dot(p, e);
    if along.signum() <= 0 {
        Fraction { num: dot(p, p), den: Int256::ONE }
    } else if along >= dot(e, e) {
        Fraction { num: dot(q, q), den: Int256::ONE }
    } else {
        to_line(p, q)
    }
}

/// Squared distance from an origin inside the polygon to its boundary, and whether one edge alone
/// is that near.
fn nearest_line(sum: &Sum) -> (Fraction, bool) {
    let mut edges = sum.edges().map(|(p, q)| to_line(p, q));
    let mut best = edges.next().expect("a sum with an interior has edges");
    let mut alone = true;
    for square in edges {
        match square.cmp(best) {
            core::cmp::Ordering::Less => (best, alone) = (square, true),
            core::cmp::Ordering::Equal => alone = false,
            core::cmp::Ordering::Greater => {}
        }
    }
    (best, alone)
}

/// Squared distance from the origin to the line through `p` and `q`.
fn to_line(p: Point, q: Point) -> Fraction {
    let e = (q.0 - p.0, q.1 - p.1);
    Fraction { num: orient(p, q, (0, 0)).squared(), den: dot(e, e) }
}

/// Every point of `b` belongs to `a`.
pub fn contains(a: &Figure, b: &Figure) -> bool {
    let ((corners, count), r) = (b.corners(), b.radius());
    let vertices = &corners[..count];
    match *a {
        Figure::Aabb { min, max } => {
            vertices.iter().all(|p| p.0 - r >= min.0 && p.1 - r >= min.1 && p.0 + r <= max.0 && p.1 + r <= max.1)
        }
        Figure::Circle { centre, radius } => vertices.iter().all(|p| {
            let d = (p.0 - centre.0, p.1 - centre.1);
            radius >= r && dot(d, d) <= Int256::product(radius - r, radius - r)
        }),
        Figure::Segment { .. } => {
            let point = |p: &Point| Figure::Circle { centre: *p, radius: 0 };
            r == 0 && vertices.iter().all(|p| Measure::new(a, &point(p)).place == Place::On)
        }
    }
}
