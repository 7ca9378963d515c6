//! Decides exactly how two edges meet.
//!
//! Raw coordinates of a file stay below 2^37 (a million pixels and offsets). Products stay below
//! 2^76, far from the ends of `i128`.

pub type Point = (i64, i64);

/// A straight piece of an outline or of a tile layer's surface. If it has a solid side, that is
/// right of its way (y down).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edge {
    pub a: Point,
    pub b: Point,
    /// The outline. `None` is the tile layer.
    pub outline: Option<usize>,
    /// The number of the edge in its outline.
    pub number: usize,
    pub side: Side,
}

/// The side that blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The surface of a solid or of a hole.
    Solid,
    /// Both sides.
    Wall,
    OneWay,
}

impl Edge {
    pub fn dir(&self) -> (i128, i128) {
        (i128::from(self.b.0 - self.a.0), i128::from(self.b.1 - self.a.1))
    }

    pub fn normal(&self) -> (i128, i128) {
        let (x, y) = self.dir();
        (y, -x)
    }

    #[must_use]
    pub fn reversed(self) -> Self {
        Self { a: self.b, b: self.a, ..self }
    }

    pub fn middle(&self) -> Point {
        ((self.a.0 + self.b.0).div_euclid(2), (self.a.1 + self.b.1).div_euclid(2))
    }

    pub fn length_squared(&self) -> i128 {
        let (x, y) = self.dir();
        x * x + y * y
    }
}

/// How two edges of positive length meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Meeting {
    /// Not at all, or in a common end.
    Apart,
    SharedEnd(Point),
    /// In one point within both, rounded to raw units.
    Cross(Point),
    /// An end of one within the other.
    Tee(Point),
    /// Along this common piece.
    Overlap {
        at: Point,
        reversed: bool,
        whole: bool,
    },
}

/// Positive if c lies right of the way from a to b, seen with y down.
pub fn orient(a: Point, b: Point, c: Point) -> i128 {
    let (bx, by) = (i128::from(b.0 - a.0), i128::from(b.1 - a.1));
    let (cx, cy) = (i128::from(c.0 - a.0), i128::from(c.1 - a.1));
    bx * cy - by * cx
}

pub fn meet(s: &Edge, t: &Edge) -> Meeting {
    let (c, d) = (orient(s.a, s.b, t.a), orient(s.a, s.b, t.b));
    let (a, b) = (orient(t.a, t.b, s.a), orient(t.a, t.b, s.b));
    if c == 0 && d == 0 {
        return on_one_line(s, t);
    }
    if a.signum() * b.signum() < 0 && c.signum() * d.signum() < 0 {
        // At c / (c - d) of t.
        let part = |from: i64, to: i64| i128::from(from) + nearest(i128::from(to - from) * c, c - d);
        return Meeting::Cross((part(t.a.0, t.b.0) as i64, part(t.a.1, t.b.1) as i64));
    }
    let ends = [(s.a, t.a), (s.a, t.b), (s.b, t.a), (s.b, t.b)];
    if let Some((shared, _)) = ends.into_iter().find(|(p, q)| p == q) {
        return Meeting::SharedEnd(shared);
    }
    let tees = [(t.a, s, c), (t.b, s, d), (s.a, t, a), (s.b, t, b)];
    let tee = tees.into_iter().find(|(p, edge, side)| *side == 0 && within(*p, edge));
    tee.map_or(Meeting::Apart, |(p, ..)| Meeting::Tee(p))
}

fn on_one_line(s: &Edge, t: &Edge) -> Meeting {
    // Points of one line in the order of their coordinates, x first.
    let order = |e: &Edge| (e.a.min(e.b), e.a.max(e.b));
    let ((s_lo, s_hi), (t_lo, t_hi)) = (order(s), order(t));
    let (lo, hi) = (s_lo.max(t_lo), s_hi.min(t_hi));
    match lo.cmp(&hi) {
        std::cmp::Ordering::Greater => Meeting::Apart,
        std::cmp::Ordering::Equal => Meeting::SharedEnd(lo),
        std::cmp::Ordering::Less => {
            Meeting::Overlap { at: lo, reversed: (s.a < s.b) != (t.a < t.b), whole: (s_lo, s_hi) == (t_lo, t_hi) }
        }
    }
}

/// Whether a point on the line of an edge lies on the edge.
fn within(p: Point, edge: &Edge) -> bool {
    let between = |v: i64, a: i64, b: i64| a.min(b) <= v && v <= a.max(b);
    between(p.0, edge.a.0, edge.b.0) && between(p.1, edge.a.1, edge.b.1)
}

fn nearest(numerator: i128, denominator: i128) -> i128 {
    let (n, d) = if denominator < 0 { (-numerator, -denominator) } else { (numerator, denominator) };
    (2 * n + d).div_euclid(2 * d)
}

/// More comparisons would take a second, for a polygon that is too large for a map anyway.
const MOST_COMPARED: usize = 1 << 24;

/// Where a closed way first crosses or touches itself, of the meetings that count, and the numbers
/// of the two edges.
pub fn crossing(points: &[Point], counts: impl Fn(&Meeting) -> bool) -> Option<(usize, usize, Point)> {
    let ends = points.iter().zip(points.iter().cycle().skip(1)).zip(0..);
    let edge = |((&a, &b), number)| Edge { a, b, outline: None, number, side: Side::Solid };
    let mut edges: Vec<Edge> = ends.map(edge).collect();
    edges.sort_by_key(|edge| edge.a.min(edge.b));
    let mut compared = 0;
    for (i, s) in edges.iter().enumerate() {
        let right = s.a.0.max(s.b.0);
        for t in edges[i + 1..].iter().take_while(|t| t.a.0.min(t.b.0) <= right) {
            compared += 1;
            if compared > MOST_COMPARED {
                return None;
            }
            let (from, to) = (s.number.min(t.number), s.number.max(t.number));
            if to - from == 1 || (from, to + 1) == (0, points.len()) {
                continue;
            }
            match meet(s, t) {
                meeting @ (Meeting::Cross(at) | Meeting::Tee(at)) if counts(&meeting) => return Some((from, to, at)),
                _ => {}
            }
        }
    }
    None
}

/// Whether an edge separates two points: they lie on different sides of its line, and the way
/// between them crosses the edge.
pub fn hides(edge: &Edge, p: Point, q: Point) -> bool {
    let split = orient(edge.a, edge.b, p).signum() * orient(edge.a, edge.b, q).signum() < 0;
    split && orient(p, q, edge.a).signum() * orient(p, q, edge.b).signum() <= 0
}

/// Twice the area, positive if the solid lies right of the way (y down).
pub fn doubled_area(points: &[Point]) -> i128 {
    let Some(&origin) = points.first() else { return 0 };
    points.windows(2).map(|pair| orient(origin, pair[0], pair[1])).sum()
}

/// How often a polygon winds around a point that is not on it. The point has doubled coordinates.
pub fn winding(points: &[Point], p: Point) -> i32 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(&a, &b)| crossed(a, b, p)).sum()
}

/// How an edge crosses the ray from a point of doubled coordinates along x. It is 1 if the point is
/// right of its way, else -1.
pub fn crossed(a: Point, b: Point, p: Point) -> i32 {
    let double = |q: Point| (2 * q.0, 2 * q.1);
    let (a, b) = (double(a), double(b));
    if (a.1 <= p.1) == (b.1 <= p.1) {
        return 0;
    }
    let side = orient(a, b, p);
    i32::from(a.1 <= p.1 && side > 0) - i32::from(a.1 > p.1 && side < 0)
}
