//! A closed piece of the plane: a convex polygon, a quarter disc, or a square without one.

pub type Point = (i128, i128);

fn sub(a: Point, b: Point) -> Point {
    (a.0 - b.0, a.1 - b.1)
}

fn cross(a: Point, b: Point) -> i128 {
    a.0 * b.1 - a.1 * b.0
}

fn dot(a: Point, b: Point) -> i128 {
    a.0 * b.0 + a.1 * b.1
}

fn len2(a: Point) -> i128 {
    dot(a, a)
}

#[derive(Clone, Debug)]
pub enum Region {
    /// Corners, in either turn.
    Polygon(Vec<Point>),
    /// The disc around `centre` through the corners beside it of the square between `centre` and
    /// `far`, in that square. With `outside`, the square minus the open disc.
    Arc { centre: Point, far: Point, outside: bool },
}

pub fn rectangle(lo: Point, hi: Point) -> Region {
    Region::Polygon(vec![lo, (hi.0, lo.1), hi, (lo.0, hi.1)])
}

impl Region {
    pub fn map(&self, f: impl Fn(Point) -> Point) -> Self {
        match self {
            Self::Polygon(points) => Self::Polygon(points.iter().map(|&p| f(p)).collect()),
            &Self::Arc { centre, far, outside } => Self::Arc { centre: f(centre), far: f(far), outside },
        }
    }

    /// The straight parts of the border.
    fn edges(&self) -> Vec<(Point, Point)> {
        match self {
            Self::Polygon(points) => points.iter().zip(points.iter().cycle().skip(1)).map(|(&a, &b)| (a, b)).collect(),
            &Self::Arc { centre: c, far: f, outside } => {
                let corner = if outside { f } else { c };
                vec![((c.0, f.1), corner), (corner, (f.0, c.1))]
            }
        }
    }

    /// Its corners, and the centre of its arc. A passing shape is nearest to these where its own
    /// centre or corner is level with one of them.
    pub fn marks(&self) -> Vec<Point> {
        match self {
            Self::Polygon(points) => points.clone(),
            &Self::Arc { centre: c, far: f, .. } => vec![c, (c.0, f.1), f, (f.0, c.1)],
        }
    }

    pub fn contains(&self, p: Point) -> bool {
        match self {
            Self::Polygon(_) => {
                let turns: Vec<i128> = self.edges().iter().map(|&(a, b)| cross(sub(b, a), sub(p, a))).collect();
                turns.iter().all(|&t| t >= 0) || turns.iter().all(|&t| t <= 0)
            }
            &Self::Arc { centre, far, outside } => {
                let in_square = rectangle(centre, far).contains(p);
                let (d, r) = (len2(sub(p, centre)), (far.0 - centre.0).pow(2));
                in_square && if outside { d >= r } else { d <= r }
            }
        }
    }

    /// Whether the square of the distance from `p` to the border is below `r` squared, or equal
    /// where `closed`.
    pub fn border_within(&self, p: Point, r: i128, closed: bool) -> bool {
        let less = |a: i128, b: i128| a < b || (closed && a == b);
        let straight = self.edges().iter().any(|&(a, b)| {
            let (e, m) = (sub(b, a), sub(p, a));
            if dot(m, e) <= 0 {
                less(len2(m), r * r)
            } else if dot(m, e) >= len2(e) {
                less(len2(sub(p, b)), r * r)
            } else {
                less(cross(e, m).pow(2), r * r * len2(e))
            }
        });
        straight
            || match self {
                Self::Polygon(_) => false,
                &Self::Arc { centre, far, .. } => {
                    // Toward the arc: |d - S| against r; the ends of the arc are ends of edges.
                    let (m, q) = (sub(p, centre), sub(far, centre));
                    let (d2, side) = (len2(m), q.0.abs());
                    let beyond = match side - r {
                        inner if inner < 0 => true,
                        inner if closed => d2 >= inner * inner,
                        inner => d2 > inner * inner,
                    };
                    m.0 * q.0 >= 0 && m.1 * q.1 >= 0 && less(d2, (side + r).pow(2)) && beyond
                }
            }
    }

    /// Whether a closed box has a point in it. With `area`, whether the common part has an area.
    /// All coordinates are even.
    pub fn meets_box(&self, lo: Point, hi: Point, area: bool) -> bool {
        match self {
            Self::Polygon(points) => {
                let mut rest = points.clone();
                for (side, axis, from) in [(lo.0, 0, 1), (hi.0, 0, -1), (lo.1, 1, 1), (hi.1, 1, -1)] {
                    rest = clip(&rest, |p| from * (if axis == 0 { p.0 } else { p.1 } - side));
                }
                let twice: i128 = rest.iter().zip(rest.iter().cycle().skip(1)).map(|(&a, &b)| cross(a, b)).sum();
                if area { twice != 0 } else { !rest.is_empty() }
            }
            &Self::Arc { centre, far, outside } => {
                let cut = |a: i128, b: i128, c: i128, f: i128| (a.max(c.min(f)), b.min(c.max(f)));
                let (x0, x1) = cut(lo.0, hi.0, centre.0, far.0);
                let (y0, y1) = cut(lo.1, hi.1, centre.1, far.1);
                if x0 > x1 || y0 > y1 || (area && (x0 == x1 || y0 == y1)) {
                    return false;
                }
                let corners = [(x0, y0), (x0, y1), (x1, y0), (x1, y1)].map(|p| len2(sub(p, centre)));
                let r = (far.0 - centre.0).pow(2);
                match (outside, area) {
                    (false, true) => corners.iter().any(|&d| d < r),
                    (false, false) => corners.iter().any(|&d| d <= r),
                    (true, true) => corners.iter().any(|&d| d > r),
                    (true, false) => corners.iter().any(|&d| d >= r),
                }
            }
        }
    }

    /// Where the border may cross the line of points with the coordinate `at` on an axis: their
    /// other coordinates, rounded to both sides.
    pub fn crossings(&self, at: i128, along_x: bool) -> Vec<i128> {
        let split = |p: Point| if along_x { (p.1 - at, p.0) } else { (p.0 - at, p.1) };
        let mut out = Vec::new();
        for (a, b) in self.edges() {
            let ((da, ua), (db, ub)) = (split(a), split(b));
            out.extend([ua, ub]);
            if (da < 0) != (db < 0) {
                let u = ua + (ub - ua) * da / (da - db);
                out.extend([u - 1, u, u + 1]);
            }
        }
        if let &Self::Arc { centre, far, .. } = self {
            let (d, u) = split(centre);
            let rest = (far.0 - centre.0).pow(2) - d * d;
            if rest >= 0 {
                let root = rest.isqrt();
                out.extend([u - root - 1, u - root, u + root, u + root + 1]);
            }
        }
        out
    }
}

/// The part of a convex polygon with a height of 0 or more. Crossings of slopes 1, 2 and 1/2 with
/// lines of even coordinates are integers.
fn clip(points: &[Point], height: impl Fn(Point) -> i128) -> Vec<Point> {
    let mut out = Vec::new();
    for (&a, &b) in points.iter().zip(points.iter().cycle().skip(1)) {
        let (h, k) = (height(a), height(b));
        if h >= 0 {
            out.push(a);
        }
        if (h < 0) != (k < 0) && h != 0 && k != 0 {
            let part = |u: i128, v: i128| {
                assert_eq!((v - u) * h % (h - k), 0);
                u + (v - u) * h / (h - k)
            };
            out.push((part(a.0, b.0), part(a.1, b.1)));
        }
    }
    out
}
