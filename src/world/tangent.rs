//! A line that solid touches and does not cross.

use super::cell::Cell;
use crate::num::{Axis, LONG, Raw, umul};

/// A line that the solid of a cell touches and does not cross. Its front is where `n . (x - at)`
/// is above `reach`.
///
/// Public in a private module, because a sealed trait names it.
#[derive(Clone, Copy, Debug)]
pub struct Tangent {
    /// A point of the line if `reach` is zero, otherwise the centre of an arc that it touches.
    pub(crate) at: Raw,
    /// To the front.
    pub(crate) normal: Axis,
    /// The cell that touches it.
    pub(crate) cell: Cell,
    /// Not negative: at most the radius of the arc times the length of the normal.
    pub(crate) reach: i64,
}

impl Tangent {
    /// The line across `normal` through a point.
    pub(crate) const fn through(at: Raw, normal: Axis, cell: Cell) -> Self {
        Self { at, normal, cell, reach: 0 }
    }

    /// The tangent across `normal` of the disc around `at`, or a parallel of it nearer to `at`.
    pub(crate) fn of_disc(at: Raw, radius: i32, normal: Axis, cell: Cell) -> Self {
        let longest = normal.x.unsigned_abs().max(normal.y.unsigned_abs());
        Self { at, normal, cell, reach: umul(radius.unsigned_abs(), longest) as i64 }
    }

    /// Whether a point is not in front of the line.
    pub(super) fn has_behind(&self, p: Raw) -> bool {
        let (way, n) = (p.sub(self.at), self.normal);
        // Mostly it is behind along x and along y, and needs no product.
        let is_back = |way: i32, n: i32| way == 0 || (way ^ n) < 0;
        (!LONG && is_back(way.x, n.x) && is_back(way.y, n.y)) || n.dot_vec(way.vec2()) <= self.reach
    }
}
