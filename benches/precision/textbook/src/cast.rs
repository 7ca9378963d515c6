//! Motions: the time at which a shape first meets another, as a fraction of the motion.

use crate::Scalar;
use crate::shape::{Aabb, Circle, Segment, Vector};

/// The first root of the quadratic for a point `m` from the centre of a disc, moved by `d`.
#[inline]
fn disc<S: Scalar>(m: Vector<S>, d: Vector<S>, r: S) -> Option<S> {
    let (a, b, c) = (d.dot(d), m.dot(d), m.dot(m) - r * r);
    if b >= S::ZERO || a <= S::ZERO {
        return None;
    }
    let square = b * b - a * c;
    if square <= S::ZERO {
        return None;
    }
    let t = (-b - square.root()) / a;
    (t < S::ONE).then(|| t.most(S::ZERO))
}

#[inline]
pub fn circle_circle<S: Scalar>(a: &Circle<S>, b: &Circle<S>, d: Vector<S>) -> Option<S> {
    disc(a.c - b.c, d, a.r + b.r)
}

/// The times at which a point is inside an interval.
#[inline]
fn slab<S: Scalar>(p: S, d: S, lo: S, hi: S) -> Option<(S, S)> {
    if d > S::ZERO {
        Some(((lo - p) / d, (hi - p) / d))
    } else if d < S::ZERO {
        Some(((hi - p) / d, (lo - p) / d))
    } else {
        (p > lo && p < hi).then_some((-S::NEVER, S::NEVER))
    }
}

/// The time at which a point enters a box, if it is within the motion.
#[inline]
fn enter<S: Scalar>(p: Vector<S>, d: Vector<S>, lo: Vector<S>, hi: Vector<S>) -> Option<S> {
    let (x, y) = (slab(p.x, d.x, lo.x, hi.x)?, slab(p.y, d.y, lo.y, hi.y)?);
    let (from, to) = (x.0.most(y.0), x.1.least(y.1));
    (from < to && to > S::ZERO && from < S::ONE).then(|| from.most(S::ZERO))
}

#[inline]
pub fn aabb_aabb<S: Scalar>(a: &Aabb<S>, b: &Aabb<S>, d: Vector<S>) -> Option<S> {
    enter(a.lo, d, b.lo - (a.hi - a.lo), b.hi)
}

/// The facing side, moved out by the radius. Beyond its ends the discs around them.
#[inline]
pub fn circle_segment<S: Scalar>(a: &Circle<S>, b: &Segment<S>, d: Vector<S>) -> Option<S> {
    let (e, m) = (b.b - b.a, a.c - b.a);
    let (aside, toward, square) = (e.cross(m), e.cross(d), e.dot(e));
    let off = a.r * square.root();
    let gap = aside.magnitude() - off;
    if gap >= S::ZERO {
        let speed = if aside > S::ZERO { -toward } else { toward };
        if speed <= S::ZERO {
            return None;
        }
        let t = gap / speed;
        if t >= S::ONE {
            return None;
        }
        let along = (m + d * t).dot(e);
        if along >= S::ZERO && along <= square {
            return Some(t);
        }
    }
    let (first, second) = (disc(m, d, a.r), disc(a.c - b.b, d, a.r));
    match (first, second) {
        (Some(t), Some(u)) => Some(t.least(u)),
        _ => first.or(second),
    }
}

/// The box grown by the radius. If the point meets its corner: the disc around the box's own
/// corner.
#[inline]
pub fn circle_aabb<S: Scalar>(a: &Circle<S>, b: &Aabb<S>, d: Vector<S>) -> Option<S> {
    let r = Vector { x: a.r, y: a.r };
    let t = enter(a.c, d, b.lo - r, b.hi + r)?;
    let at = a.c + d * t;
    let near = at.clamped(b.lo, b.hi);
    if near.x == at.x || near.y == at.y {
        return Some(t);
    }
    // It may pass one corner and meet the next one.
    let corners = [b.lo, Vector { x: b.hi.x, y: b.lo.y }, Vector { x: b.lo.x, y: b.hi.y }, b.hi];
    let mut first = None;
    for corner in corners {
        let Some(t) = disc(a.c - corner, d, a.r) else { continue };
        if first.is_none_or(|f| t < f) {
            first = Some(t);
        }
    }
    let flat = |lo: Vector<S>, hi: Vector<S>| enter(a.c, d, lo, hi);
    let wide = flat(Vector { x: b.lo.x - a.r, y: b.lo.y }, Vector { x: b.hi.x + a.r, y: b.hi.y });
    let high = flat(Vector { x: b.lo.x, y: b.lo.y - a.r }, Vector { x: b.hi.x, y: b.hi.y + a.r });
    for t in [wide, high].into_iter().flatten() {
        if first.is_none_or(|f| t < f) {
            first = Some(t);
        }
    }
    first
}
