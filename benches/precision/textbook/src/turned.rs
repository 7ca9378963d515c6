//! Boxes in any direction. The four axes of two such boxes are those of their sides.

use crate::Scalar;
use crate::pair;
use crate::shape::{Aabb, Circle, Contact, Vector};

/// A box with everything that its queries take from it. A game makes it when the box turns.
#[derive(Clone, Copy, Debug)]
pub struct Turned<S> {
    pub c: Vector<S>,
    /// From the middle to a side, and to the next one.
    pub along: Vector<S>,
    pub across: Vector<S>,
    /// The unit vector along the first.
    pub unit: Vector<S>,
    /// The lengths of both.
    pub half: Vector<S>,
}

/// Whether a side of `a` separates it from `b`, which is `d` from it. Vectors of the sides need no
/// root, and in small scenes no rounding in f64.
#[inline]
fn separates<S: Scalar>(a: &Turned<S>, b: &Turned<S>, d: Vector<S>) -> bool {
    let beyond = |axis: Vector<S>| {
        let reach = axis.dot(axis) + axis.dot(b.along).magnitude() + axis.dot(b.across).magnitude();
        d.dot(axis).magnitude() >= reach
    };
    beyond(a.along) || beyond(a.across)
}

#[inline]
pub fn turned_turned<S: Scalar>(a: &Turned<S>, b: &Turned<S>) -> bool {
    let d = b.c - a.c;
    !separates(a, b, d) && !separates(b, a, d)
}

/// A vector as seen along a box, and back.
#[inline]
fn seen<S: Scalar>(v: Vector<S>, unit: Vector<S>) -> Vector<S> {
    Vector { x: v.dot(unit), y: unit.cross(v) }
}

#[inline]
fn unseen<S: Scalar>(v: Vector<S>, unit: Vector<S>) -> Vector<S> {
    Vector { x: v.x * unit.x - v.y * unit.y, y: v.x * unit.y + v.y * unit.x }
}

/// The projections of a box onto another's axes differ only by the cosine and the sine between
/// them.
#[inline]
pub fn contact_turned_turned<S: Scalar>(a: &Turned<S>, b: &Turned<S>) -> Option<Contact<S>> {
    let d = b.c - a.c;
    let (cos, sin) = (a.unit.dot(b.unit).magnitude(), a.unit.cross(b.unit).magnitude());
    let overlap = |d: Vector<S>, own: Vector<S>, other: Vector<S>| Vector {
        x: own.x + other.x * cos + other.y * sin - d.x.magnitude(),
        y: own.y + other.x * sin + other.y * cos - d.y.magnitude(),
    };
    let in_a = seen(d, a.unit);
    let first = overlap(in_a, a.half, b.half);
    if first.x <= S::ZERO || first.y <= S::ZERO {
        return None;
    }
    let in_b = seen(d, b.unit);
    let second = overlap(in_b, b.half, a.half);
    if second.x <= S::ZERO || second.y <= S::ZERO {
        return None;
    }
    // The least of each box, then of both.
    let least = |depth: Vector<S>, d: Vector<S>, unit: Vector<S>| {
        if depth.x < depth.y { (depth.x, d.x, unit) } else { (depth.y, d.y, Vector { x: -unit.y, y: unit.x }) }
    };
    let (one, two) = (least(first, in_a, a.unit), least(second, in_b, b.unit));
    let (depth, side, axis) = if one.0 <= two.0 { one } else { two };
    Some(Contact { depth, normal: if side < S::ZERO { Vector { x: -axis.x, y: -axis.y } } else { axis } })
}

/// A circle and a box, as seen along the box.
#[inline]
fn along_box<S: Scalar>(a: &Circle<S>, b: &Turned<S>) -> (Circle<S>, Aabb<S>) {
    let lo = Vector { x: -b.half.x, y: -b.half.y };
    (Circle { c: seen(a.c - b.c, b.unit), r: a.r }, Aabb { lo, hi: b.half })
}

#[inline]
pub fn circle_turned<S: Scalar>(a: &Circle<S>, b: &Turned<S>) -> bool {
    let (a, b) = along_box(a, b);
    pair::circle_aabb(&a, &b)
}

#[inline]
pub fn contact_circle_turned<S: Scalar>(a: &Circle<S>, b: &Turned<S>) -> Option<Contact<S>> {
    let (circle, flat) = along_box(a, b);
    pair::contact_circle_aabb(&circle, &flat).map(|c| Contact { normal: unseen(c.normal, b.unit), ..c })
}

/// The gap between a circle and a box.
#[inline]
pub fn distance_circle_turned<S: Scalar>(a: &Circle<S>, b: &Turned<S>) -> S {
    let (a, b) = along_box(a, b);
    let d = a.c.clamped(b.lo, b.hi) - a.c;
    (d.dot(d).root() - a.r).most(S::ZERO)
}

/// The least square of the distance from a corner of `b` to `a`.
#[inline]
fn corners_apart<S: Scalar>(a: &Turned<S>, b: &Turned<S>) -> S {
    let lo = Vector { x: -a.half.x, y: -a.half.y };
    let (c, u, v) = (seen(b.c - a.c, a.unit), seen(b.along, a.unit), seen(b.across, a.unit));
    let apart = |p: Vector<S>| {
        let d = p.clamped(lo, a.half) - p;
        d.dot(d)
    };
    let (p, q) = (c + u, c - u);
    apart(p + v).least(apart(p - v)).least(apart(q + v)).least(apart(q - v))
}

/// The gap between two boxes: from a corner of one of them.
#[inline]
pub fn distance_turned_turned<S: Scalar>(a: &Turned<S>, b: &Turned<S>) -> S {
    if turned_turned(a, b) { S::ZERO } else { corners_apart(a, b).least(corners_apart(b, a)).root() }
}
