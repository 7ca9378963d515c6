//! Capsules: the closest points of two segments, after Ericson's *Real-Time Collision Detection*.

use crate::Scalar;
use crate::pair::within;
use crate::shape::{Contact, Segment, Vector};

/// A segment that has a length, and a radius.
#[derive(Clone, Copy, Debug)]
pub struct Capsule<S> {
    pub core: Segment<S>,
    pub r: S,
}

/// From the point of `a` that is nearest to `b` to that of `b`, and whether the segments cross.
#[inline]
fn between<S: Scalar>(a: &Segment<S>, b: &Segment<S>) -> (Vector<S>, bool) {
    let (u, v, w) = (a.b - a.a, b.b - b.a, a.a - b.a);
    let (uu, uv, vv) = (u.dot(u), u.dot(v), v.dot(v));
    let (uw, vw) = (u.dot(w), v.dot(w));
    let clamped = |s: S| s.most(S::ZERO).least(S::ONE);
    let square = uu * vv - uv * uv;
    let free = if square > S::ZERO { (uv * vw - uw * vv) / square } else { S::ZERO };
    let mut s = clamped(free);
    let mut t = (uv * s + vw) / vv;
    let crosses = square > S::ZERO && free == s && t >= S::ZERO && t <= S::ONE;
    if t < S::ZERO {
        (s, t) = (clamped(-uw / uu), S::ZERO);
    } else if t > S::ONE {
        (s, t) = (clamped((uv - uw) / uu), S::ONE);
    }
    (v * t - w - u * s, crosses)
}

#[inline]
pub fn capsule_capsule<S: Scalar>(a: &Capsule<S>, b: &Capsule<S>) -> bool {
    let (d, r) = (between(&a.core, &b.core).0, a.r + b.r);
    d.dot(d) <= r * r
}

/// The shorter way of a segment to one side of another's line, which it crosses.
#[inline]
fn aside<S: Scalar>(a: &Segment<S>, b: &Segment<S>) -> Contact<S> {
    let e = a.b - a.a;
    let length = e.dot(e).root();
    let normal = Vector { x: -e.y / length, y: e.x / length };
    let (p, q) = (normal.dot(b.a - a.a), normal.dot(b.b - a.a));
    let (up, down) = (-p.least(q), p.most(q));
    // Toward B: out of the other side.
    if up < down {
        Contact { depth: up, normal }
    } else {
        Contact { depth: down, normal: Vector { x: -normal.x, y: -normal.y } }
    }
}

#[inline]
pub fn contact_capsule_capsule<S: Scalar>(a: &Capsule<S>, b: &Capsule<S>) -> Option<Contact<S>> {
    let (d, crosses) = between(&a.core, &b.core);
    let r = a.r + b.r;
    if !crosses {
        return within(d, r);
    }
    let (of_a, of_b) = (aside(&a.core, &b.core), aside(&b.core, &a.core));
    let n = of_b.normal;
    let least = if of_a.depth <= of_b.depth { of_a } else { Contact { normal: Vector { x: -n.x, y: -n.y }, ..of_b } };
    Some(Contact { depth: least.depth + r, ..least })
}

/// The gap between two capsules.
#[inline]
pub fn distance_capsule_capsule<S: Scalar>(a: &Capsule<S>, b: &Capsule<S>) -> S {
    let d = between(&a.core, &b.core).0;
    (d.dot(d).root() - a.r - b.r).most(S::ZERO)
}
