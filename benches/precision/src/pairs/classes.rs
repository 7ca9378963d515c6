//! Classes of pairs: plain ones, in which no number format is ever wrong, and hard ones.

use tilesat_judge::Random;
use tilesat_judge::oracle::figure::{Figure, Kind, Point};
use tilesat_judge::oracle::generate::{self, Pairs, UNIT};
use tilesat_judge::oracle::measure::Measure;

pub type Pair = (Figure, Figure);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Anywhere in an ordinary scene. A given percentage overlaps.
    Hits(u8),
    /// The bounding boxes overlap.
    Boxes,
    /// Within 2 raw units of touching.
    Near,
    /// Touching exactly.
    Exact,
    /// All of these, 8000 pixels from the origin.
    Far,
    /// Up to the ends of the domain, with extremes and long touching shapes.
    Domain,
    /// The square of the distance is within 1 of the square of the radii.
    Square,
}

pub const CLASSES: [Class; 9] = [
    Class::Hits(10),
    Class::Hits(50),
    Class::Hits(90),
    Class::Boxes,
    Class::Near,
    Class::Exact,
    Class::Far,
    Class::Domain,
    Class::Square,
];

impl Class {
    pub fn name(self) -> &'static str {
        match self {
            Self::Hits(10) => "uniform 10 % hits",
            Self::Hits(50) => "uniform 50 % hits",
            Self::Hits(_) => "uniform 90 % hits",
            Self::Boxes => "boxes overlap",
            Self::Near => "within 2 raw of touching",
            Self::Exact => "touching exactly",
            Self::Far => "8000 px from the origin",
            Self::Domain => "whole domain",
            Self::Square => "d^2 within 1 of R^2",
        }
    }

    /// `n` pairs. Empty if the class does not apply to such shapes.
    pub fn pairs(self, kinds: (Kind, Kind), n: usize) -> Vec<Pair> {
        let stream = |class| {
            let mut pairs = Pairs::new(kinds, class, SEED);
            (0..n).map(|_| pairs.next()).collect()
        };
        let mut r =
            Random::new(SEED ^ (kinds.0 as u64) << 8 ^ (kinds.1 as u64) << 12 ^ (self.name().len() as u64) << 16);
        match self {
            Self::Hits(share) => (0..n).map(|_| hit_or_miss(&mut r, kinds, share)).collect(),
            Self::Boxes => (0..n).map(|_| boxes(&mut r, kinds)).collect(),
            Self::Near => stream(generate::Class::Near),
            Self::Exact => stream(generate::Class::Exact),
            Self::Far => stream(generate::Class::Far),
            Self::Domain => stream(generate::Class::Domain),
            Self::Square if kinds.0 == Kind::Circle => (0..n).map(|_| square(&mut r, kinds.1)).collect(),
            Self::Square => Vec::new(),
        }
    }
}

const SEED: u64 = 0x7e57_0001;

/// A shape around a point, 2 to 16 pixels from its middle to its sides or ends.
fn around(r: &mut Random, kind: Kind, c: Point) -> (Figure, Point) {
    let mut half = || r.within(2 * UNIT, 16 * UNIT);
    match kind {
        Kind::Circle => {
            let radius = half();
            (Figure::Circle { centre: c, radius }, (radius, radius))
        }
        Kind::Aabb => {
            let (w, h) = (half(), half());
            (Figure::Aabb { min: (c.0 - w, c.1 - h), max: (c.0 + w, c.1 + h) }, (w, h))
        }
        Kind::Segment => {
            let (w, h) = (half(), half());
            let up = r.sign();
            (Figure::Segment { a: (c.0 - w, c.1 - up * h), b: (c.0 + w, c.1 + up * h) }, (w, h))
        }
    }
}

/// A pair whose middles are at most `share` percent of the distance apart at which their boxes
/// would touch.
fn pair(r: &mut Random, kinds: (Kind, Kind), share: i64) -> Pair {
    let c = (r.around(64 * UNIT), r.around(64 * UNIT));
    let (a, m) = around(r, kinds.0, c);
    let (b, k) = around(r, kinds.1, c);
    let by = (r.around((m.0 + k.0) * share / 100), r.around((m.1 + k.1) * share / 100));
    (a, b.moved(by))
}

fn hit_or_miss(r: &mut Random, kinds: (Kind, Kind), share: u8) -> Pair {
    let hit = r.below(100) < i64::from(share);
    loop {
        let p = pair(r, kinds, 130);
        if Measure::new(&p.0, &p.1).overlaps() == hit {
            return p;
        }
    }
}

/// Middles closer than the sum of the half sides.
fn boxes(r: &mut Random, kinds: (Kind, Kind)) -> Pair {
    pair(r, kinds, 100)
}

/// Numbers x, y, R with x^2 + y^2 - R^2 = -1, 0 or 1, of any size that leaves room in the domain.
fn nearly_right(r: &mut Random) -> (Point, i64) {
    // Of 2^16 to 2^28: the first sixteen bits are pixels.
    let most = 1i64 << r.within(17, 28);
    // Chosen once: most tries for -1 fail.
    let kind = r.below(3);
    loop {
        let (x, y, radius) = match kind {
            // (R - x)(R + x) = (y - 1)(y + 1) with R - x = 2 p, y - 1 = 2 p k.
            0 => {
                let p = r.within(1, 1 << 12);
                let k = r.within(1, (most / p).isqrt().max(1));
                (k * (p * k + 1) - p, 2 * p * k + 1, p + k * (p * k + 1))
            }
            // (R - x)(R + x) = y^2 + 1 = (a^2 + b^2)(c^2 + e^2) with y = a c + b e, a e - b c = 1.
            1 => {
                let (a, b) = (r.within(1, most.isqrt()), r.within(1, most.isqrt()));
                let Some((c, e)) = unit_cross(a, b) else { continue };
                let (u, v) = (a * a + b * b, c * c + e * e);
                if (u + v) % 2 != 0 {
                    continue;
                }
                ((v - u).abs() / 2, a * c + b * e, (u + v) / 2)
            }
            _ => {
                let (m, n) = (r.within(2, most.isqrt()), r.within(1, most.isqrt()));
                ((m * m - n * n).abs(), 2 * m * n, m * m + n * n)
            }
        };
        if radius < most && radius > 2 && x > 0 && y > 0 {
            let (x, y) = if r.one_in(2) { (x, y) } else { (y, x) };
            return ((r.sign() * x, r.sign() * y), radius);
        }
    }
}

/// The least positive `(c, e)` with `a e - b c = 1`.
fn unit_cross(a: i64, b: i64) -> Option<(i64, i64)> {
    let (mut r0, mut r1, mut s0, mut s1) = (a, b, 1, 0);
    while r1 != 0 {
        let q = r0 / r1;
        (r0, r1) = (r1, r0 - q * r1);
        (s0, s1) = (s1, s0 - q * s1);
    }
    if r0 != 1 {
        return None;
    }
    // a s0 = 1 modulo b.
    let e = s0.rem_euclid(b);
    let c = (a * e - 1) / b;
    (c > 0 && e > 0).then_some((c, e))
}

/// A circle that almost touches the nearest point of the other shape: a centre, a corner, an end.
fn square(r: &mut Random, other: Kind) -> Pair {
    loop {
        let ((x, y), radius) = nearly_right(r);
        let from = (r.around(64 * UNIT), r.around(64 * UNIT));
        // The rest of the shape is behind that point.
        let mut behind = |v: i64| -v.signum() * r.within(1, 64 * UNIT);
        let back = (behind(x), behind(y));
        let (a, b) = match other {
            Kind::Circle => {
                let part = r.within(0, radius);
                (
                    Figure::Circle { centre: (x, y), radius: part },
                    Figure::Circle { centre: (0, 0), radius: radius - part },
                )
            }
            Kind::Aabb => (Figure::Circle { centre: (x, y), radius }, generate::aabb((0, 0), back)),
            Kind::Segment => (Figure::Circle { centre: (x, y), radius }, Figure::Segment { a: (0, 0), b: back }),
        };
        let (a, b) = (a.moved(from), b.moved(from));
        if a.in_domain() && b.in_domain() {
            return (a, b);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tilesat_judge::oracle::figure::PAIRS;

    #[test]
    fn squares_are_within_one() {
        let mut r = Random::new(1);
        let mut seen = [0; 3];
        for _ in 0..20_000 {
            let ((x, y), radius) = nearly_right(&mut r);
            let off = i128::from(x) * i128::from(x) + i128::from(y) * i128::from(y) - i128::from(radius).pow(2);
            seen[usize::try_from(off + 1).unwrap()] += 1;
        }
        assert!(seen.iter().all(|&n| n > 6_000), "{seen:?}");
    }

    #[test]
    fn classes_are_what_they_say() {
        for kinds in PAIRS {
            for class in CLASSES {
                let pairs = class.pairs(kinds, 2_000);
                assert!(pairs.iter().all(|(a, b)| a.in_domain() && b.in_domain()));
                assert!(pairs.iter().all(|(a, b)| (a.kind(), b.kind()) == kinds));
                let hits = pairs.iter().filter(|(a, b)| Measure::new(a, b).overlaps()).count();
                if let Class::Hits(share) = class {
                    assert!(hits.abs_diff(20 * usize::from(share)) < 120, "{kinds:?} {share}: {hits}");
                }
                if class == Class::Exact {
                    assert!(pairs.iter().all(|(a, b)| Measure::new(a, b).touches()) && hits == 0, "{kinds:?}");
                }
            }
        }
    }
}
