//! Exact check of a rounded pair of closest points.
//!
//! The difference of the exact closest points is the nearest point of the sum, and unique. The
//! points themselves are not unique if two sides face each other in parallel. Then they are a
//! family over one parameter, and some member must round to the checked points.

use super::figure::{Figure, Point};
use super::int256::Int256;
use super::nearest::{Exact2, is_nearest_on_arm, nearest_point};
use super::sum::{Sum, dot};

/// A fraction of any sign with a positive denominator.
#[derive(Clone, Copy)]
struct Signed {
    num: Int256,
    den: Int256,
}

impl Signed {
    fn new(num: Int256, den: Int256) -> Self {
        if den.signum() < 0 { Self { num: -num, den: -den } } else { Self { num, den } }
    }

    fn at_most(self, other: Self) -> bool {
        self.num * other.den <= other.num * self.den
    }
}

/// The parameters `t` that are still possible.
struct Window {
    from: Vec<Signed>,
    to: Vec<Signed>,
    empty: bool,
}

impl Window {
    fn bound(&mut self, low: Signed, high: Signed) {
        let (low, high) = if low.at_most(high) { (low, high) } else { (high, low) };
        self.from.push(low);
        self.to.push(high);
    }

    /// `n` is at most one half from `base / den + t e`.
    fn component(&mut self, n: i64, base: Int256, den: Int256, e: i64) {
        // 2 (n den - base) -+ den = 2 t e den
        let middle = Int256::new(2) * (Int256::new(n) * den - base);
        if e == 0 {
            self.empty |= middle.abs() > den;
        } else {
            let scale = Int256::new(2 * e) * den;
            self.bound(Signed::new(middle - den, scale), Signed::new(middle + den, scale));
        }
    }

    fn point(&mut self, p: Point, base: Exact2, e: Point) {
        self.component(p.0, base.x, base.den, e.0);
        self.component(p.1, base.y, base.den, e.1);
    }

    fn is_possible(&self) -> bool {
        !self.empty && self.from.iter().all(|low| self.to.iter().all(|high| low.at_most(*high)))
    }
}

/// The vertices that reach farthest along `u`: one, or the two of a side.
fn face(figure: &Figure, u: Point) -> Vec<Point> {
    let mut vertices = figure.vertices();
    vertices.dedup();
    let most = vertices.iter().map(|p| dot(u, *p)).max();
    vertices.retain(|p| Some(dot(u, *p)) == most);
    vertices.sort_unstable();
    vertices.dedup();
    vertices
}

/// `p` of A and `q` of B are closest points of disjoint shapes, each component rounded to nearest.
pub fn are_closest_points(a: &Figure, b: &Figure, p: Point, q: Point) -> bool {
    let nearest = nearest_point(&Sum::new(a, b));
    // The sum holds a - b: its nearest point w leads from B's core to A's.
    let (w, u) = (nearest.at, (-nearest.toward.0, -nearest.toward.1));
    let (face_a, face_b) = (face(a, u), face(b, (-u.0, -u.1)));
    let (base, e) = match (&*face_a, &*face_b) {
        ([one], _) => (Exact2::lattice(*one), (0, 0)),
        (_, [one]) => (w.plus(*one), (0, 0)),
        _ => (Exact2::lattice(face_a[0]), (face_a[1].0 - face_a[0].0, face_a[1].1 - face_a[0].1)),
    };
    let mut window = Window { from: Vec::new(), to: Vec::new(), empty: false };
    if e != (0, 0) {
        // Both faces are sides across w: B's ends project onto A's side by t = (b - a0).e / e.e.
        let square = dot(e, e);
        let project = |b: Point| Signed::new(dot((b.0 - face_a[0].0, b.1 - face_a[0].1), e), square);
        window.bound(project(face_b[0]), project(face_b[face_b.len() - 1]));
        window.bound(Signed::new(Int256::ZERO, Int256::ONE), Signed::new(Int256::ONE, Int256::ONE));
    }
    // B's core point is A's minus w.
    let difference = |x: Int256, y: Int256| x * w.den - y * base.den;
    let other = Exact2 { x: difference(base.x, w.x), y: difference(base.y, w.y), den: base.den * w.den };
    let square = dot(u, u);
    let mut round = |figure: &Figure, at: Point, core: Exact2, u: Point| {
        if let Figure::Circle { centre, radius } = *figure {
            is_nearest_on_arm(at.0 - centre.0, u.0, radius, square)
                && is_nearest_on_arm(at.1 - centre.1, u.1, radius, square)
        } else {
            window.point(at, core, e);
            true
        }
    };
    round(a, p, base, u) && round(b, q, other, (-u.0, -u.1)) && window.is_possible()
}
