//! Exact checks of rounded points.

use super::figure::{Figure, Point};
use super::int256::Int256;
use super::measure::to_edge;
use super::sum::{Place, Sum, dot};

/// An exact vector: two integers over one denominator.
#[derive(Clone, Copy, Debug)]
pub struct Exact2 {
    pub x: Int256,
    pub y: Int256,
    pub den: Int256,
}

impl Exact2 {
    pub fn lattice(p: Point) -> Self {
        Self { x: Int256::new(p.0), y: Int256::new(p.1), den: Int256::ONE }
    }

    /// This vector plus a lattice point.
    pub fn plus(self, p: Point) -> Self {
        Self { x: self.x + Int256::new(p.0) * self.den, y: self.y + Int256::new(p.1) * self.den, ..self }
    }
}

/// The nearest point of a polygon, and an integer vector from the origin towards it.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    pub at: Exact2,
    pub toward: Point,
}

/// The point of the polygon that is nearest to the origin, for an origin outside. There is only
/// one.
pub fn nearest_point(sum: &Sum) -> Nearest {
    let (p, q) =
        sum.edges().min_by(|x, y| to_edge(x.0, x.1).cmp(to_edge(y.0, y.1))).expect("a sum has at least one edge");
    let e = (q.0 - p.0, q.1 - p.1);
    let (along, square) = (-dot(p, e), dot(e, e));
    let vertex = |p: Point| Nearest { at: Exact2::lattice(p), toward: p };
    if along.signum() <= 0 {
        return vertex(p);
    }
    if along >= square {
        return vertex(q);
    }
    let at = |p: i64, e: i64| Int256::new(p) * square + Int256::new(e) * along;
    // A flat sum has its edge in both directions: the side is taken from the edge, not from the
    // order of the polygon.
    let normal = if dot(p, (e.1, -e.0)).signum() > 0 { (e.1, -e.0) } else { (-e.1, e.0) };
    Nearest { at: Exact2 { x: at(p.0, e.0), y: at(p.1, e.1), den: square }, toward: normal }
}

/// `n` is at most one half from `num / den`.
pub fn is_nearest(n: i64, num: Int256, den: Int256) -> bool {
    let twice = Int256::new(2);
    (twice * (Int256::new(n) * den - num)).abs() <= den
}

/// `n` is at most one half from `d * r / sqrt(square)`.
pub fn is_nearest_on_arm(n: i64, d: i64, r: i64, square: Int256) -> bool {
    let k = n.abs();
    let exact = Int256::product(2 * d, r).squared();
    let bound = |m: i64| Int256::product(m, m) * square;
    let sign = n == 0 || r == 0 || n.signum() == d.signum();
    sign && exact <= bound(2 * k + 1) && (k == 0 || exact >= bound(2 * k - 1))
}

/// `x` is the point of `figure` nearest to `p`, each component rounded to nearest, either way on a
/// tie.
pub fn is_closest_point(figure: &Figure, p: Point, x: Point) -> bool {
    if let Figure::Circle { centre, radius } = *figure {
        let d = (p.0 - centre.0, p.1 - centre.1);
        let square = dot(d, d);
        return if square <= Int256::product(radius, radius) {
            x == p
        } else {
            is_nearest_on_arm(x.0 - centre.0, d.0, radius, square)
                && is_nearest_on_arm(x.1 - centre.1, d.1, radius, square)
        };
    }
    let sum = Sum::new(figure, &Figure::Circle { centre: p, radius: 0 });
    if sum.place() != Place::Outside {
        return x == p;
    }
    let v = nearest_point(&sum).at;
    is_nearest(x.0 - p.0, v.x, v.den) && is_nearest(x.1 - p.1, v.y, v.den)
}
