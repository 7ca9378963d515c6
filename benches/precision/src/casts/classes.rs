//! Classes of motions of one shape toward another. None starts with an overlap.

use super::truth::Truth;
use tilesat_judge::Random;
use tilesat_judge::oracle::figure::{Figure, Kind, Point};
use tilesat_judge::oracle::generate::UNIT;

/// A moves by `d`. B stays.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    pub a: Figure,
    pub b: Figure,
    pub d: Point,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Anywhere in a scene. Half of them hit.
    Uniform,
    /// Toward the middle.
    HeadOn,
    /// Past a corner, an end or a side of the circle, within 2 raw units of touching it.
    Grazing,
    /// The same, 8000 pixels from the origin.
    Far,
}

pub const CLASSES: [Class; 4] = [Class::Uniform, Class::HeadOn, Class::Grazing, Class::Far];

pub const KINDS: [(Kind, Kind); 4] =
    [(Kind::Circle, Kind::Circle), (Kind::Circle, Kind::Aabb), (Kind::Circle, Kind::Segment), (Kind::Aabb, Kind::Aabb)];

impl Class {
    pub fn name(self) -> &'static str {
        match self {
            Self::Uniform => "uniform 50 % hits",
            Self::HeadOn => "head-on",
            Self::Grazing => "grazing",
            Self::Far => "grazing 8000 px from the origin",
        }
    }

    pub fn cases(self, kinds: (Kind, Kind), n: usize) -> Vec<Case> {
        let mut r = Random::new(0xca57 ^ (kinds.0 as u64) << 16 ^ (kinds.1 as u64) << 20 ^ (self as u64) << 24);
        (0..n).map(|_| self.case(&mut r, kinds)).collect()
    }

    fn case(self, r: &mut Random, kinds: (Kind, Kind)) -> Case {
        let hit = r.one_in(2);
        loop {
            let case = match self {
                Self::Uniform => {
                    let d = (r.around(64 * UNIT), r.around(64 * UNIT));
                    Some(apart(r, kinds, |_, _| d))
                }
                Self::HeadOn => {
                    let part = r.within(8, 32);
                    Some(apart(r, kinds, |a, b| ((b.0 - a.0) * part / 16, (b.1 - a.1) * part / 16)))
                }
                Self::Grazing => grazing(r, kinds),
                Self::Far => grazing(r, kinds).map(|c| {
                    let by = (r.sign() * 8000 * UNIT, r.sign() * 8000 * UNIT);
                    Case { a: c.a.moved(by), b: c.b.moved(by), d: c.d }
                }),
            };
            let Some(case) = case.filter(|c| c.a.in_domain() && c.b.in_domain()) else { continue };
            if Truth::starts_apart(&case) && (self != Self::Uniform || Truth::new(&case).toi.is_some() == hit) {
                return case;
            }
        }
    }
}

fn half(r: &mut Random) -> i64 {
    r.within(2 * UNIT, 16 * UNIT)
}

/// A shape around a point, and its extent.
fn around(r: &mut Random, kind: Kind, c: Point) -> (Figure, Point) {
    if kind == Kind::Circle {
        let radius = half(r);
        return (Figure::Circle { centre: c, radius }, (radius, radius));
    }
    let (w, h) = (half(r), half(r));
    if kind == Kind::Segment {
        let up = r.sign();
        return (Figure::Segment { a: (c.0 - w, c.1 - up * h), b: (c.0 + w, c.1 + up * h) }, (w, h));
    }
    (Figure::Aabb { min: (c.0 - w, c.1 - h), max: (c.0 + w, c.1 + h) }, (w, h))
}

/// Shapes whose boxes are up to 48 pixels apart, and the motion that their middles make.
fn apart(r: &mut Random, kinds: (Kind, Kind), motion: impl Fn(Point, Point) -> Point) -> Case {
    let c = (r.around(64 * UNIT), r.around(64 * UNIT));
    let (b, reach) = around(r, kinds.1, c);
    let (a, own) = around(r, kinds.0, (0, 0));
    let gap = r.within(0, 48 * UNIT);
    let (w, h) = (reach.0 + own.0 + gap, reach.1 + own.1 + gap);
    let off = if r.one_in(2) { (r.sign() * w, r.around(h)) } else { (r.around(w), r.sign() * h) };
    let at = (c.0 + off.0, c.1 + off.1);
    Case { a: a.moved(at), b, d: motion(at, c) }
}

/// A way past the nearest feature. The direction is Pythagorean, so the touch is exact before it
/// moves by 2 raw.
fn grazing(r: &mut Random, kinds: (Kind, Kind)) -> Option<Case> {
    let (m, n) = (r.within(2, 20), r.within(1, 19));
    if n >= m {
        return None;
    }
    let (p, q, h) = (m * m - n * n, 2 * m * n, m * m + n * n);
    let (p, q) = if r.one_in(2) { (p, q) } else { (q, p) };
    let (p, q) = (r.sign() * p, r.sign() * q);
    // The unit vector across the way is (-q, p) / h, or the other side.
    let side = r.sign();
    let n = (-q * side, p * side);
    let (on, back) = (r.within(1, 48 * UNIT / h), r.within(1, 48 * UNIT / h));
    let d = (p * (on + back), q * (on + back));
    let from = (r.around(64 * UNIT), r.around(64 * UNIT));
    let jitter = (r.around(2), r.around(2));
    // Position where A's reference passes B's: `radius` across.
    let start = |x: Point| (x.0 - p * back + jitter.0, x.1 - q * back + jitter.1);
    let steps = r.within(4 * UNIT / h, 16 * UNIT / h);
    let radius = steps * h;
    let across = (n.0 * steps, n.1 * steps);
    // A box behind its corner at the origin, as seen across the way. A segment behind its end.
    let back_of = |r: &mut Random| (-n.0.signum() * half(r), -n.1.signum() * half(r));
    let behind = |r: &mut Random| {
        let corner = back_of(r);
        Figure::Aabb { min: (corner.0.min(0), corner.1.min(0)), max: (corner.0.max(0), corner.1.max(0)) }
    };
    let (a, b) = match kinds {
        (Kind::Circle, Kind::Circle) => {
            let part = r.within(1, radius - 1);
            let a = Figure::Circle { centre: start(across), radius: part };
            (a, Figure::Circle { centre: (0, 0), radius: radius - part })
        }
        (Kind::Circle, Kind::Segment) => {
            (Figure::Circle { centre: start(across), radius }, Figure::Segment { a: (0, 0), b: back_of(r) })
        }
        (Kind::Circle, _) => (Figure::Circle { centre: start(across), radius }, behind(r)),
        _ => {
            let b = behind(r);
            // The corner of A that faces B passes B's corner.
            let size = (half(r), half(r));
            let to = (n.0.signum() * size.0, n.1.signum() * size.1);
            let corner = start((0, 0));
            let far = (corner.0 + to.0, corner.1 + to.1);
            let min = (corner.0.min(far.0), corner.1.min(far.1));
            (Figure::Aabb { min, max: (corner.0.max(far.0), corner.1.max(far.1)) }, b)
        }
    };
    Some(Case { a: a.moved(from), b: b.moved(from), d })
}
