//! The exit over a side of the sum of two shapes.

use super::walk::PolygonSide;
use crate::num::{Axis, Raw};
use crate::query::contact::Contact;

/// The axis out of the sum over the line along `e` through `at`, and how far the origin is behind
/// it, times the axis' length.
///
/// Along x and y the axis has length one, and the height divides by the side's length.
#[inline]
pub(super) const fn over(e: Raw, at: Raw) -> (Axis, i64) {
    if e.y == 0 {
        let sign = e.x.signum();
        (Axis::new(0, sign.wrapping_neg()), (sign.wrapping_mul(at.y) as i64).wrapping_neg())
    } else if e.x == 0 {
        let sign = e.y.signum();
        (Axis::new(sign, 0), sign.wrapping_mul(at.x) as i64)
    } else {
        let n = normal(e);
        (Axis::new(n.x, n.y), e.cross(at.reversed()))
    }
}

/// Out of the sum, and from B to A.
pub(super) const fn normal(edge: Raw) -> Raw {
    Raw { x: edge.y, y: edge.x.wrapping_neg() }
}

/// The contact across a side that only one shape has: the deepest point is the corner of the other
/// one that it moves along.
#[inline]
pub(super) const fn across(side: &PolygonSide, a: Raw, b: Raw) -> Contact {
    let (axis, overlap) = over(side.edge, side.from);
    if side.of_a { Contact::new(axis, overlap, b).on_b() } else { Contact::new(axis, overlap, a) }
}
