//! Whether two quads are apart along x or y: their first test on chips.

use crate::num::{Raw, Vec2};
use crate::shape::Convex;

/// Two sharp polygons with four corners each.
pub(super) struct Quads<'a> {
    pub(super) a: &'a [Vec2; 4],
    pub(super) b: &'a [Vec2; 4],
}

impl<'a> Quads<'a> {
    /// None for other shapes.
    #[inline]
    pub(super) fn of(a: &'a impl Convex, b: &'a impl Convex) -> Option<Self> {
        let is_sharp = a.rounding() | b.rounding() == 0;
        let (a, b) = (a.stored_corners()?.try_into().ok()?, b.stored_corners()?.try_into().ok()?);
        is_sharp.then_some(Self { a, b })
    }

    /// Whether one quad ends before the other begins, along the axis on which their first corners
    /// are farther apart. That is a third of the comparisons of two bounding boxes, and it settles
    /// most of what these would.
    #[inline]
    pub(super) fn are_apart<const CLOSED: bool>(&self) -> bool {
        let way = Raw::of(self.b[0]).sub(Raw::of(self.a[0]));
        if way.x.unsigned_abs() > way.y.unsigned_abs() {
            self.is_gap::<CLOSED>(way.x < 0, |p| p.x.to_bits())
        } else {
            self.is_gap::<CLOSED>(way.y < 0, |p| p.y.to_bits())
        }
    }

    #[inline]
    fn is_gap<const CLOSED: bool>(&self, swap: bool, along: impl Fn(&Vec2) -> i32) -> bool {
        let (first, last) = if swap { (self.b, self.a) } else { (self.a, self.b) };
        let end = first.iter().map(&along).fold(i32::MIN, i32::max);
        let begin = last.iter().map(&along).fold(i32::MAX, i32::min);
        end < begin || (!CLOSED && end == begin)
    }
}
