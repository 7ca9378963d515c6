//! Overlap and touch of bodies with a level of all shapes.

use super::level::{Level, Piece};
use super::region::{Point, Region};

#[derive(Clone, Copy, Debug)]
pub enum Body {
    /// Corners.
    Box { lo: (i64, i64), hi: (i64, i64) },
    /// Centre and radius.
    Circle { c: (i64, i64), r: i64 },
}

fn times(p: (i64, i64), k: i128) -> Point {
    (i128::from(p.0) * k, i128::from(p.1) * k)
}

/// Coordinates below 2^30 times this: products of differences below 2^120.
const FINE: i128 = 1 << 28;

/// A level's pieces on the three scales that the judge needs.
pub struct Judge {
    raw: Vec<Piece>,
    even: Vec<Piece>,
    fine: Vec<Piece>,
}

impl Judge {
    pub fn new(level: &Level) -> Self {
        Self { raw: level.pieces(1), even: level.pieces(4), fine: level.pieces(FINE) }
    }

    pub fn overlaps(&self, body: Body) -> bool {
        match body {
            Body::Circle { c, r: 0 } => self.inside(times(c, FINE)),
            Body::Circle { c, r } => self.circle(c, r, false),
            Body::Box { lo, hi } if lo.0 < hi.0 && lo.1 < hi.1 => self.boxed(lo, hi, true),
            Body::Box { lo, hi } => self.thin(times(lo, FINE), times(hi, FINE)),
        }
    }

    pub fn touches(&self, body: Body) -> bool {
        match body {
            Body::Circle { c, r } => self.circle(c, r, true),
            Body::Box { lo, hi } => self.boxed(lo, hi, false),
        }
    }

    /// By the distance to the border, or as a part of the inside.
    fn circle(&self, c: (i64, i64), r: i64, closed: bool) -> bool {
        let p = times(c, 1);
        self.raw.iter().filter_map(|t| t.solid.as_ref()).any(|s| s.contains(p) || s.border_within(p, r.into(), closed))
    }

    /// By the part of the solid that is left when it is clipped to the box.
    fn boxed(&self, lo: (i64, i64), hi: (i64, i64), area: bool) -> bool {
        let (lo, hi) = (times(lo, 4), times(hi, 4));
        self.even.iter().filter_map(|t| t.solid.as_ref()).any(|s| s.meets_box(lo, hi, area))
    }

    /// Whether a point is in the inside of the union.
    pub fn is_inside(&self, p: (i64, i64)) -> bool {
        self.inside(times(p, FINE))
    }

    /// Whether the surface is nearer to a point than `r`; with `closed`, at most that far. From
    /// outside it is the solid, from inside the rest.
    pub fn surface_within(&self, p: (i64, i64), r: i64, closed: bool) -> bool {
        let (inside, p, r) = (self.is_inside(p), times(p, 1), i128::from(r));
        let other = self.raw.iter().filter_map(|t| if inside { t.rest.as_ref() } else { t.solid.as_ref() });
        other.into_iter().any(|s| (s.contains(p) && (closed || r > 0)) || s.border_within(p, r, closed))
    }

    /// Whether both the solid and the rest are at most `r` from a point.
    pub fn near_surface(&self, p: (i64, i64), r: i64) -> bool {
        let (p, r) = (times(p, 1), i128::from(r));
        let near = |region: Option<&Region>| region.is_some_and(|s| s.contains(p) || s.border_within(p, r, true));
        self.raw.iter().any(|t| near(t.solid.as_ref())) && self.raw.iter().any(|t| near(t.rest.as_ref()))
    }

    /// The inside of the union is the set of points in no closed rest.
    fn inside(&self, p: Point) -> bool {
        !self.fine.iter().filter_map(|t| t.rest.as_ref()).any(|rest| rest.contains(p))
    }

    /// By points on, beside and between all positions where the segment may leave or enter a rest.
    /// An arc meets it at an irrational position, but not less than 2^-25 raw from a side of its
    /// cell unless on it: S - sqrt(S^2 - w^2) >= w^2 / 2S. So a point 2^-28 from there decides.
    fn thin(&self, lo: Point, hi: Point) -> bool {
        let along_x = lo.1 == hi.1;
        let (at, first, last) = if along_x { (lo.1, lo.0, hi.0) } else { (lo.0, lo.1, hi.1) };
        let mut events: Vec<i128> =
            self.fine.iter().filter_map(|t| t.rest.as_ref()).flat_map(|r| r.crossings(at, along_x)).collect();
        events.extend([first, last]);
        events.sort_unstable();
        events.dedup();
        let middles: Vec<i128> = events.windows(2).map(|w| i128::midpoint(w[0], w[1])).collect();
        let samples = events.iter().flat_map(|&e| [e - 1, e, e + 1]).chain(middles);
        let mut samples = samples.filter(|&u| first <= u && u <= last);
        samples.any(|u| self.inside(if along_x { (u, at) } else { (at, u) }))
    }
}
