//! The definitions, in wide integers: which boxes touch, when, how far away.

use super::Mark;
use tilesat::broad::{Handle, Tag};
use tilesat::{Aabb, Vec2};

pub type P = (i64, i64);

pub const DOMAIN: i64 = 1 << 29;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rect {
    pub lo: P,
    pub hi: P,
}

pub fn point(v: Vec2) -> P {
    let (x, y) = v.raw();
    (x.into(), y.into())
}

impl Rect {
    pub fn of(b: &Aabb) -> Self {
        Self { lo: point(b.min()), hi: point(b.max()) }
    }

    pub fn side(&self) -> i64 {
        (self.hi.0 - self.lo.0).max(self.hi.1 - self.lo.1)
    }

    pub fn touches(&self, other: &Self) -> bool {
        let apart = |alo: i64, ahi: i64, blo: i64, bhi: i64| ahi - blo < 0 || bhi - alo < 0;
        !apart(self.lo.0, self.hi.0, other.lo.0, other.hi.0) && !apart(self.lo.1, self.hi.1, other.lo.1, other.hi.1)
    }

    pub fn moved(&self, d: P) -> Self {
        let add = |p: P| (p.0 + d.0, p.1 + d.1);
        Self { lo: add(self.lo), hi: add(self.hi) }
    }

    pub fn in_domain(&self) -> bool {
        [self.lo.0, self.lo.1, self.hi.0, self.hi.1].iter().all(|v| v.abs() < DOMAIN)
    }

    /// The squared distance from a point.
    pub fn square(&self, p: P) -> i128 {
        let nearest = (p.0.clamp(self.lo.0, self.hi.0), p.1.clamp(self.lo.1, self.hi.1));
        let (x, y) = (i128::from(p.0 - nearest.0), i128::from(p.1 - nearest.1));
        x * x + y * y
    }

    /// When this, moving by `d`, first touches another box, in parts of 2^30, rounded down.
    ///
    /// Whether it does, by separating axes: a segment from (0, 0) to `d` against the box of all
    /// differences of points. The time, by the last of the two components to enter that box.
    pub fn first_touch(&self, d: P, other: &Self) -> Option<u32> {
        let lo = (other.lo.0 - self.hi.0, other.lo.1 - self.hi.1);
        let hi = (other.hi.0 - self.lo.0, other.hi.1 - self.lo.1);
        let meets = |d: i64, lo: i64, hi: i64| d.min(0) <= hi && lo <= d.max(0);
        let cross = |p: P| i128::from(d.0) * i128::from(p.1) - i128::from(d.1) * i128::from(p.0);
        let corners = [lo, hi, (lo.0, hi.1), (hi.0, lo.1)].map(cross);
        let apart = corners.iter().all(|c| *c > 0) || corners.iter().all(|c| *c < 0);
        if !meets(d.0, lo.0, hi.0) || !meets(d.1, lo.1, hi.1) || apart {
            return None;
        }
        let entry = |d: i64, lo: i64, hi: i64| {
            let to = if lo > 0 { lo } else { hi.min(0) };
            if to == 0 { 0 } else { (i128::from(to.abs()) << 30) / i128::from(d.abs()) }
        };
        Some(entry(d.0, lo.0, hi.0).max(entry(d.1, lo.1, hi.1)) as u32)
    }
}

/// The root, rounded down.
pub fn root(square: i128) -> i64 {
    let (mut low, mut high) = (0i128, 1i128 << 40);
    while high - low > 1 {
        let mid = low.midpoint(high);
        if mid * mid <= square { low = mid } else { high = mid }
    }
    low as i64
}

#[derive(Clone, Copy, Debug)]
pub struct Body {
    pub handle: Handle,
    pub rect: Rect,
    pub mark: Mark,
}

impl Body {
    /// Its place in canonical order.
    pub fn rank(&self) -> (u32, usize) {
        (self.mark.key, self.handle.slot())
    }
}

/// Bodies in a list.
#[derive(Clone, Debug, Default)]
pub struct Model {
    pub bodies: Vec<Body>,
    /// Every handle so far.
    pub issued: Vec<Handle>,
}

impl Model {
    pub fn find(&self, handle: Handle) -> &Body {
        self.bodies.iter().find(|body| body.handle == handle).expect("a body that is there")
    }

    /// All pairs in canonical order.
    pub fn pairs(&self) -> Vec<(Handle, Handle)> {
        let mut pairs = Vec::new();
        for (i, a) in self.bodies.iter().enumerate() {
            for b in &self.bodies[i + 1..] {
                if a.mark.pairs_with(&b.mark) && a.rect.touches(&b.rect) {
                    pairs.push(if a.rank() < b.rank() { (a, b) } else { (b, a) });
                }
            }
        }
        pairs.sort_by_key(|(a, b)| (a.mark.key, b.mark.key, a.handle.slot(), b.handle.slot()));
        pairs.iter().map(|(a, b)| (a.handle, b.handle)).collect()
    }

    /// All bodies of a kind, in canonical order.
    pub fn all(&self, mut are: impl FnMut(&Body) -> bool) -> Vec<Handle> {
        let mut bodies: Vec<_> = self.bodies.iter().filter(|body| are(body)).collect();
        bodies.sort_by_key(|body| body.rank());
        bodies.iter().map(|body| body.handle).collect()
    }

    /// The bodies near a point, and their distances.
    pub fn near(&self, p: P, within: i64, mut wanted: impl FnMut(&Body) -> bool) -> Vec<(Handle, i64)> {
        let limit = i128::from(within) * i128::from(within);
        let mut near: Vec<_> = self.bodies.iter().filter(|b| b.rect.square(p) <= limit && wanted(b)).collect();
        near.sort_by_key(|b| (b.rect.square(p), b.rank()));
        near.iter().map(|b| (b.handle, root(b.rect.square(p)))).collect()
    }

    /// The bodies touched on a way, and the times.
    pub fn touched(&self, start: &Rect, d: P, mut wanted: impl FnMut(&Body) -> bool) -> Vec<(Handle, u32)> {
        let bodies = self.bodies.iter().filter(|body| wanted(body));
        let mut hits: Vec<_> =
            bodies.filter_map(|b| Some((start.first_touch(d, &b.rect)?, b.rank(), b.handle))).collect();
        hits.sort_unstable();
        hits.iter().map(|hit| (hit.2, hit.0)).collect()
    }
}
