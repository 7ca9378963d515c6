//! Decides whether a part of a motion starts an overlap.

use super::number::{Number, V};
use crate::oracle::figure::{Figure, Point};

/// Parts of a motion, as the library counts them.
pub const ONE: i64 = 1 << 30;

/// The positions of the origin at which A overlaps B: a convex polygon grown by a radius.
#[derive(Clone, Debug)]
pub struct Forbidden {
    /// Turning from x toward y; one or two points where it has no area.
    pub hull: Vec<Point>,
    pub radius: i64,
}

fn turn(a: Point, b: Point, c: Point) -> i128 {
    let (e, f) = ((b.0 - a.0, b.1 - a.1), (c.0 - a.0, c.1 - a.1));
    i128::from(e.0) * i128::from(f.1) - i128::from(e.1) * i128::from(f.0)
}

/// Andrew's monotone chain, collinear points dropped.
fn hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_unstable();
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let chain = |points: &mut dyn Iterator<Item = Point>| {
        let mut out: Vec<Point> = Vec::new();
        for p in points {
            while out.len() > 1 && turn(out[out.len() - 2], out[out.len() - 1], p) <= 0 {
                out.pop();
            }
            out.push(p);
        }
        out.pop();
        out
    };
    let mut all = chain(&mut points.iter().copied());
    all.extend(chain(&mut points.iter().rev().copied()));
    all
}

impl Forbidden {
    pub fn new(a: &Figure, b: &Figure) -> Self {
        let (a_points, b_points) = (a.vertices(), b.vertices());
        let differences = a_points.iter().flat_map(|p| b_points.iter().map(move |q| (q.0 - p.0, q.1 - p.1)));
        Self { hull: hull(differences.collect()), radius: a.radius() + b.radius() }
    }

    fn edges(&self) -> impl Iterator<Item = (Point, Point)> + '_ {
        let n = self.hull.len();
        (0..n).map(move |i| (self.hull[i], self.hull[(i + 1) % n]))
    }

    /// Whether the path from the origin up to `time / 2^30` of `d` has a point in the open set.
    pub fn met<N: Number>(&self, d: Point, time: i64) -> bool {
        if self.radius == 0 { self.passes_inside::<N>(d, time) } else { self.nearer::<N>(d, time, self.radius) }
    }

    /// Whether a place is in the open set.
    pub fn holds<N: Number>(&self, p: Point) -> bool {
        if self.radius == 0 {
            self.is_strictly_inside::<N>(p)
        } else {
            self.moved(p).nearer::<N>((0, 0), 0, self.radius)
        }
    }

    /// Whether a point is nearer to the polygon than a distance.
    pub fn is_near<N: Number>(&self, p: Point, distance: i64) -> bool {
        self.moved(p).nearer::<N>((0, 0), 0, distance)
    }

    /// Whether the path has a point in the closed set.
    pub fn touched<N: Number>(&self, d: Point, time: i64) -> bool {
        self.is_strictly_inside::<N>((0, 0))
            || self.edges().any(|(a, b)| near_side::<N>(d, time, a, b, self.radius, true))
    }

    /// The scene relative to another position.
    pub fn moved(&self, p: Point) -> Self {
        Self { hull: self.hull.iter().map(|v| (v.0 - p.0, v.1 - p.1)).collect(), radius: self.radius }
    }

    fn is_strictly_inside<N: Number>(&self, p: Point) -> bool {
        self.hull.len() > 2
            && self
                .edges()
                .all(|(a, b)| V::<N>::of((b.0 - a.0, b.1 - a.1)).cross(&V::of((p.0 - a.0, p.1 - a.1))) > N::zero())
    }

    /// Clips the path by the open half-planes of the edges: inside each while `rise s > wanted`,
    /// with s in parts of 2^30.
    fn passes_inside<N: Number>(&self, d: Point, time: i64) -> bool {
        if self.hull.len() < 3 {
            return false;
        }
        let (mut from, mut to) = ((N::zero(), N::of(1)), (N::of(time), N::of(1)));
        for (a, b) in self.edges() {
            let e = V::<N>::of((b.0 - a.0, b.1 - a.1));
            let (rise, wanted) = (e.cross(&V::of(d)), e.cross(&V::of(a)) * N::of(ONE));
            if rise > N::zero() {
                if wanted.clone() * from.1.clone() > from.0.clone() * rise.clone() {
                    from = (wanted, rise);
                }
            } else if rise < N::zero() {
                let (wanted, fall) = (N::zero() - wanted, N::zero() - rise);
                if wanted.clone() * to.1.clone() < to.0.clone() * fall.clone() {
                    to = (wanted, fall);
                }
            } else if wanted >= N::zero() {
                return false;
            }
        }
        from.0 * to.1 < to.0 * from.1
    }

    /// Whether the path and the polygon are nearer than a distance. Two convex sets are near if one
    /// contains a point of the other, or two of their sides are near.
    fn nearer<N: Number>(&self, d: Point, time: i64, distance: i64) -> bool {
        self.is_strictly_inside::<N>((0, 0))
            || self.edges().any(|(a, b)| near_side::<N>(d, time, a, b, distance, false))
    }
}

/// Whether the path from the origin to `d time / 2^30` is nearer to the segment from `a` to `b`
/// than a distance. With `closed`, at most that far. Everything times 2^30.
fn near_side<N: Number>(d: Point, time: i64, a: Point, b: Point, distance: i64, closed: bool) -> bool {
    let (one, t) = (N::of(ONE), N::of(time));
    let (way, e) = (V::<N>::of(d), V::<N>::of((b.0 - a.0, b.1 - a.1)));
    let (start, end) = (V::<N>::of((0, 0)), way.times(&t));
    let (a, b) = (V::<N>::of(a).times(&one), V::<N>::of(b).times(&one));
    let limit = (N::of(distance) * one.clone()).square();
    // The point against the segment from `from` to `to` along `along`.
    let near = |p: &V<N>, from: &V<N>, to: &V<N>, along: &V<N>| {
        let (m, n) = (p.minus(from), p.minus(to));
        let below = |a: N, b: N| if closed { a <= b } else { a < b };
        if m.dot(along) <= N::zero() {
            below(m.dot(&m), limit.clone())
        } else if n.dot(along) >= N::zero() {
            below(n.dot(&n), limit.clone())
        } else {
            below(m.cross(along).square(), limit.clone() * along.dot(along))
        }
    };
    let sides = |along: &V<N>, from: &V<N>, p: &V<N>, q: &V<N>| {
        let (s, u) = (along.cross(&p.minus(from)), along.cross(&q.minus(from)));
        (s <= N::zero() && u >= N::zero()) || (s >= N::zero() && u <= N::zero())
    };
    let crosses = way.cross(&e) != N::zero() && sides(&way, &start, &a, &b) && sides(&e, &a, &start, &end);
    crosses
        || near(&a, &start, &end, &way)
        || near(&b, &start, &end, &way)
        || near(&start, &a, &b, &e)
        || near(&end, &a, &b, &e)
}
