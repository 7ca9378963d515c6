//! Classes of pairs of convex shapes. Boxes and capsules point along Pythagorean triples. So their
//! corners are whole numbers, and floats get the same corners.

use tilesat_judge::convex::generate::touch;
use tilesat_judge::convex::shape::{Kind, Shape, hull, sum};
use tilesat_judge::oracle::figure::Point;
use tilesat_judge::oracle::generate::UNIT;
use tilesat_judge::oracle::measure::Measure;
use tilesat_judge::{Random, gcd};

pub type Pair = (Shape, Shape);

/// The circle comes first: Chipmunk2D swaps others.
pub const KINDS: [(Kind, Kind); 4] = [
    (Kind::Turned, Kind::Turned),
    (Kind::Polygon, Kind::Polygon),
    (Kind::Capsule, Kind::Capsule),
    (Kind::Circle, Kind::Turned),
];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Anywhere in an ordinary scene. Half of them overlap.
    Half,
    /// The bounding boxes overlap.
    Boxes,
    /// Touching exactly, or then moved by up to 2 raw units.
    Touching,
    /// All of these, 8000 pixels from the origin.
    Far,
}

pub const CLASSES: [Class; 4] = [Class::Half, Class::Boxes, Class::Touching, Class::Far];

const SEED: u64 = 0xc0_4e0e;

impl Class {
    pub fn name(self) -> &'static str {
        match self {
            Self::Half => "uniform 50 % hits",
            Self::Boxes => "boxes overlap",
            Self::Touching => "within 2 raw of touching",
            Self::Far => "8000 px from the origin",
        }
    }

    pub fn pairs(self, kinds: (Kind, Kind), n: usize) -> Vec<Pair> {
        let mut r = Random::new(SEED ^ (kinds.0 as u64) << 32 ^ (kinds.1 as u64) << 40 ^ (self as u64) << 48);
        (0..n).map(|_| self.pair(&mut r, kinds)).collect()
    }

    fn pair(self, r: &mut Random, kinds: (Kind, Kind)) -> Pair {
        match self {
            Self::Half => {
                let hit = r.one_in(2);
                near(r, kinds, 130, |a, b| overlaps(a, b) == hit)
            }
            Self::Boxes => near(r, kinds, 100, boxes_overlap),
            Self::Touching => {
                let (a, b) = near(r, kinds, 100, |_, _| true);
                let (a, b) = if a.radius() + b.radius() > 0 { touch_round(r, a, b) } else { touch(r, a, b) };
                if r.one_in(2) { (a, b) } else { (a.moved((r.around(2), r.around(2))), b) }
            }
            Self::Far => {
                let class = [Self::Half, Self::Boxes, Self::Touching][r.below(3) as usize];
                let (a, b) = class.pair(r, kinds);
                let by = (r.sign() * 8000 * UNIT, r.sign() * 8000 * UNIT);
                (a.moved(by), b.moved(by))
            }
        }
    }
}

fn overlaps(a: &Shape, b: &Shape) -> bool {
    Measure::of(&sum(a, b)).overlaps()
}

/// The bounding box.
fn bounds(shape: &Shape) -> (Point, Point) {
    let (corners, r) = (shape.vertices(), shape.radius());
    let all = |of: fn(&Point) -> i64| corners.iter().map(of);
    let (x, y) = (all(|p| p.0), all(|p| p.1));
    let least = (x.clone().min().unwrap_or(0) - r, y.clone().min().unwrap_or(0) - r);
    (least, (x.max().unwrap_or(0) + r, y.max().unwrap_or(0) + r))
}

fn boxes_overlap(a: &Shape, b: &Shape) -> bool {
    let ((p, q), (s, t)) = (bounds(a), bounds(b));
    p.0 < t.0 && s.0 < q.0 && p.1 < t.1 && s.1 < q.1
}

/// A pair whose middles are at most `share` percent of the distance apart at which their boxes
/// would touch, and that fits.
fn near(r: &mut Random, kinds: (Kind, Kind), share: i64, fits: impl Fn(&Shape, &Shape) -> bool) -> Pair {
    loop {
        let c = (r.around(64 * UNIT), r.around(64 * UNIT));
        let (a, b) = (around(r, kinds.0, c), around(r, kinds.1, c));
        let ((p, q), (s, t)) = (bounds(&a), bounds(&b));
        let half = ((q.0 - p.0 + t.0 - s.0) / 2, (q.1 - p.1 + t.1 - s.1) / 2);
        let b = b.moved((r.around(half.0 * share / 100), r.around(half.1 * share / 100)));
        if fits(&a, &b) {
            return (a, b);
        }
    }
}

/// A direction, and its whole length below 3300: a reduced Pythagorean triple.
fn triple(r: &mut Random) -> (Point, i64) {
    let (m, n) = (r.within(1, 40), r.within(0, 40));
    let (x, y) = (m * m - n * n, 2 * m * n);
    let g = gcd(x, y).max(1);
    let (x, y, h) = (x / g * r.sign(), y / g * r.sign(), (m * m + n * n) / g);
    if r.one_in(2) { ((x, y), h) } else { ((y, x), h) }
}

/// A shape around a point, 2 to 16 pixels from its middle to its sides, corners or ends.
fn around(r: &mut Random, kind: Kind, c: Point) -> Shape {
    let length = |r: &mut Random| r.within(2 * UNIT, 16 * UNIT);
    match kind {
        Kind::Circle => Shape::Circle { centre: c, radius: length(r) },
        Kind::Turned => {
            let (direction, h) = triple(r);
            let half = (length(r) / h * h, length(r) / h * h);
            Shape::Turned { centre: c, half, direction, radius: 0 }
        }
        Kind::Capsule => {
            let (d, h) = triple(r);
            let k = length(r) / h;
            let (a, b) = ((c.0 - k * d.0, c.1 - k * d.1), (c.0 + k * d.0, c.1 + k * d.1));
            Shape::Capsule { a, b, radius: r.within(UNIT, 8 * UNIT) }
        }
        _ => quad(r, c),
    }
}

/// Four corners, one in each quadrant around the middle, and no sides that are parallel.
fn quad(r: &mut Random, c: Point) -> Shape {
    loop {
        let mut length = || r.within(2 * UNIT, 16 * UNIT);
        let corners = [(1, 1), (-1, 1), (-1, -1), (1, -1)].map(|(x, y)| (c.0 + x * length(), c.1 + y * length()));
        let side = |i: usize| (corners[(i + 1) % 4].0 - corners[i].0, corners[(i + 1) % 4].1 - corners[i].1);
        let parallel = |p: Point, q: Point| p.0 * q.1 == p.1 * q.0;
        if hull(&corners).len() == 4 && !parallel(side(0), side(2)) && !parallel(side(1), side(3)) {
            return Shape::polygon(&corners, 0);
        }
    }
}

/// A normal of a shape's sides.
fn normal(r: &mut Random, shape: &Shape) -> Option<Point> {
    let across = |d: Point| (-d.1, d.0);
    match *shape {
        Shape::Turned { direction, .. } => Some(if r.one_in(2) { direction } else { across(direction) }),
        Shape::Capsule { a, b, .. } => {
            let e = (b.0 - a.0, b.1 - a.1);
            let g = gcd(e.0, e.1);
            Some(across((e.0 / g, e.1 / g)))
        }
        _ => None,
    }
}

/// Makes A's radius fit, and moves it, so that they touch exactly: along the normal of a side, or
/// along any triple, which mostly meets a corner. A circle has no side.
fn touch_round(r: &mut Random, a: Shape, b: Shape) -> Pair {
    let shape = if r.one_in(2) { &a } else { &b };
    let side = normal(r, shape).filter(|_| r.one_in(2));
    let (x, y) = side.unwrap_or_else(|| triple(r).0);
    let (x, y) = if side.is_some() && r.one_in(2) { (-x, -y) } else { (x, y) };
    let h = (x * x + y * y).isqrt();
    let over = (a.radius() + b.radius()) % h;
    let a = match a {
        Shape::Circle { centre, radius } => Shape::Circle { centre, radius: radius - over },
        Shape::Capsule { a, b, radius } => Shape::Capsule { a, b, radius: radius - over },
        other => other,
    };
    let all = sum(&a, &b);
    let along = |p: &Point| p.0 * x + p.1 * y;
    let most = all.points().iter().map(along).max().unwrap_or(0);
    let mut farthest = all.points().iter().copied().filter(|p| along(p) == most);
    let p = farthest.next().unwrap_or((0, 0));
    let e = farthest.next().map_or((0, 0), |q| (q.0 - p.0, q.1 - p.1));
    let g = gcd(e.0, e.1).max(1);
    let (k, n) = (r.within(0, g), all.radius / h);
    (a.moved((-(p.0 + e.0 / g * k) - n * x, -(p.1 + e.1 / g * k) - n * y)), b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn classes_are_what_they_say() {
        for kinds in KINDS {
            for class in CLASSES {
                let pairs = class.pairs(kinds, 2_000);
                assert!(pairs.iter().all(|(a, b)| a.in_domain() && b.in_domain()), "{kinds:?} {class:?}");
                let count =
                    |of: fn(&Measure) -> bool| pairs.iter().filter(|(a, b)| of(&Measure::of(&sum(a, b)))).count();
                let (hits, touching) = (count(Measure::overlaps), count(|m| m.touches() && !m.overlaps()));
                match class {
                    Class::Half => assert!(hits.abs_diff(1_000) < 100, "{kinds:?}: {hits}"),
                    Class::Boxes => assert!(pairs.iter().all(|(a, b)| boxes_overlap(a, b))),
                    Class::Touching => assert!(touching > 1_000, "{kinds:?}: {touching}"),
                    Class::Far => assert!((200..500).contains(&touching), "{kinds:?}: {touching}"),
                }
            }
        }
    }

    /// A box's sides are whole numbers and exactly across each other, so floats get the same box.
    #[test]
    fn boxes_are_rectangles_with_whole_corners() {
        let mut r = Random::new(7);
        for _ in 0..2_000 {
            let shape = around(&mut r, Kind::Turned, (0, 0));
            let Shape::Turned { half, direction: d, .. } = shape else { panic!("{shape:?} is no box") };
            let h = (d.0 * d.0 + d.1 * d.1).isqrt();
            assert_eq!(h * h, d.0 * d.0 + d.1 * d.1);
            let (k, l) = (half.0 / h, half.1 / h);
            let corner = (k * d.0 - l * d.1, k * d.1 + l * d.0);
            assert!(shape.vertices().contains(&corner), "{shape:?}");
        }
    }
}
