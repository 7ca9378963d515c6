//! Pairs: whether they overlap, and how. If a circle may be a point or a segment has no length,
//! touching counts as overlapping. Strictly, such shapes would overlap nothing.

use crate::Scalar;
use crate::shape::{Aabb, Circle, Contact, Segment, Vector};

#[inline]
pub fn circle_circle<S: Scalar>(a: &Circle<S>, b: &Circle<S>) -> bool {
    let (d, r) = (b.c - a.c, a.r + b.r);
    d.dot(d) <= r * r
}

#[inline]
pub fn circle_aabb<S: Scalar>(a: &Circle<S>, b: &Aabb<S>) -> bool {
    let d = a.c.clamped(b.lo, b.hi) - a.c;
    d.dot(d) <= a.r * a.r
}

/// The point of a segment that is nearest to `p`.
#[inline]
fn nearest<S: Scalar>(p: Vector<S>, s: &Segment<S>) -> Vector<S> {
    let e = s.b - s.a;
    let (along, square) = ((p - s.a).dot(e), e.dot(e));
    if along <= S::ZERO {
        s.a
    } else if along >= square {
        s.b
    } else {
        s.a + e * (along / square)
    }
}

#[inline]
pub fn circle_segment<S: Scalar>(a: &Circle<S>, b: &Segment<S>) -> bool {
    let d = nearest(a.c, b) - a.c;
    d.dot(d) <= a.r * a.r
}

#[inline]
pub fn aabb_aabb<S: Scalar>(a: &Aabb<S>, b: &Aabb<S>) -> bool {
    a.lo.x < b.hi.x && b.lo.x < a.hi.x && a.lo.y < b.hi.y && b.lo.y < a.hi.y
}

/// The three axes, from the middles.
#[inline]
pub fn aabb_segment<S: Scalar>(a: &Aabb<S>, b: &Segment<S>) -> bool {
    let half = S::of_raw(1 << 15);
    let (e, d) = ((a.hi - a.lo) * half, (b.b - b.a) * half);
    let m = (b.a + b.b) * half - (a.lo + a.hi) * half;
    let (w, h) = (d.x.magnitude(), d.y.magnitude());
    m.x.magnitude() <= e.x + w && m.y.magnitude() <= e.y + h && m.cross(d).magnitude() <= e.x * h + e.y * w
}

#[inline]
pub fn segment_segment<S: Scalar>(a: &Segment<S>, b: &Segment<S>) -> bool {
    let beside = |s: &Segment<S>, p: Vector<S>| (s.b - s.a).cross(p - s.a);
    let apart = |p: S, q: S| (p < S::ZERO && q > S::ZERO) || (p > S::ZERO && q < S::ZERO);
    apart(beside(a, b.a), beside(a, b.b)) && apart(beside(b, a.a), beside(b, a.b))
}

/// Two points `d` apart and the sum of the radii: nothing beyond it.
#[inline]
pub(crate) fn within<S: Scalar>(d: Vector<S>, r: S) -> Option<Contact<S>> {
    let square = d.dot(d);
    if square >= r * r {
        return None;
    }
    let distance = square.root();
    if distance > S::ZERO {
        Some(Contact { depth: r - distance, normal: Vector { x: d.x / distance, y: d.y / distance } })
    } else {
        Some(Contact { depth: r, normal: Vector { x: S::ONE, y: S::ZERO } })
    }
}

#[inline]
pub fn contact_circle_circle<S: Scalar>(a: &Circle<S>, b: &Circle<S>) -> Option<Contact<S>> {
    within(b.c - a.c, a.r + b.r)
}

#[inline]
pub fn contact_circle_segment<S: Scalar>(a: &Circle<S>, b: &Segment<S>) -> Option<Contact<S>> {
    within(nearest(a.c, b) - a.c, a.r)
}

/// The shorter of the ways out along an axis.
#[inline]
fn shorter<S: Scalar>(up: S, down: S) -> (S, S) {
    if up < down { (up, S::ONE) } else { (down, -S::ONE) }
}

/// The shorter of the ways out along x and y.
#[inline]
fn least_exit<S: Scalar>(x: (S, S), y: (S, S)) -> Contact<S> {
    if x.0 < y.0 {
        Contact { depth: x.0, normal: Vector { x: x.1, y: S::ZERO } }
    } else {
        Contact { depth: y.0, normal: Vector { x: S::ZERO, y: y.1 } }
    }
}

#[inline]
pub fn contact_circle_aabb<S: Scalar>(a: &Circle<S>, b: &Aabb<S>) -> Option<Contact<S>> {
    let d = a.c.clamped(b.lo, b.hi) - a.c;
    if d.x != S::ZERO || d.y != S::ZERO {
        return within(d, a.r);
    }
    let x = shorter(a.c.x + a.r - b.lo.x, b.hi.x - (a.c.x - a.r));
    let y = shorter(a.c.y + a.r - b.lo.y, b.hi.y - (a.c.y - a.r));
    Some(least_exit(x, y))
}

#[inline]
pub fn contact_aabb_aabb<S: Scalar>(a: &Aabb<S>, b: &Aabb<S>) -> Option<Contact<S>> {
    aabb_aabb(a, b)
        .then(|| least_exit(shorter(a.hi.x - b.lo.x, b.hi.x - a.lo.x), shorter(a.hi.y - b.lo.y, b.hi.y - a.lo.y)))
}

#[inline]
pub fn contact_aabb_segment<S: Scalar>(a: &Aabb<S>, b: &Segment<S>) -> Option<Contact<S>> {
    if !aabb_segment(a, b) {
        return None;
    }
    let lo = Vector { x: b.a.x.least(b.b.x), y: b.a.y.least(b.b.y) };
    let hi = Vector { x: b.a.x.most(b.b.x), y: b.a.y.most(b.b.y) };
    let flat = least_exit(shorter(a.hi.x - lo.x, hi.x - a.lo.x), shorter(a.hi.y - lo.y, hi.y - a.lo.y));
    let e = b.b - b.a;
    let length = e.dot(e).root();
    if length <= S::ZERO {
        return Some(flat);
    }
    let n = Vector { x: -e.y / length, y: e.x / length };
    let half = S::of_raw(1 << 15);
    let (middle, size) = ((a.lo + a.hi) * half, (a.hi - a.lo) * half);
    let reach = size.x * n.x.magnitude() + size.y * n.y.magnitude();
    let side = n.dot(b.a - middle);
    let depth = reach - side.magnitude();
    Some(if depth < flat.depth {
        Contact { depth, normal: if side < S::ZERO { Vector { x: -n.x, y: -n.y } } else { n } }
    } else {
        flat
    })
}
