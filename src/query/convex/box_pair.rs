//! Two boxes in any direction, by their sides alone, without corners.

use super::margins::all_meet;
use super::{float_margins, short_boxes};
use crate::num::{LONG, Raw};
use crate::shape::Convex;

/// Two sides and the middle of each of two sharp boxes, or half of the sides.
pub(super) struct BoxPair {
    pub(super) a: [Raw; 3],
    pub(super) b: [Raw; 3],
    /// Whether these are half sides and the middles. Else they are sides, and twice the middles.
    pub(super) is_half: bool,
}

impl BoxPair {
    /// False if the types of the shapes exclude it, or both are upright boxes.
    #[inline(always)]
    pub(super) fn may_be(a: &impl Convex, b: &impl Convex) -> bool {
        let is_sharp = a.ends().is_none() && b.ends().is_none();
        is_sharp && (a.half_sides().is_some() || b.half_sides().is_some())
    }

    /// None for other shapes.
    #[inline(always)]
    pub(super) fn of(a: &impl Convex, b: &impl Convex) -> Option<Self> {
        if a.half_sides().is_none() || b.half_sides().is_none() {
            return Some(Self { a: a.box_sides()?, b: b.box_sides()?, is_half: false });
        }
        if (a.rounding() | b.rounding()) != 0 {
            return None;
        }
        Some(Self { a: a.half_sides()?, b: b.half_sides()?, is_half: true })
    }

    /// Two sides of each and the way between the middles, at one scale.
    #[inline(always)]
    pub(super) const fn sides(&self) -> [Raw; 5] {
        let ([u, v, p], [s, t, q]) = (self.a, self.b);
        [u, v, s, t, q.sub(p)]
    }

    /// Whether they overlap, or touch; none if they nearly touch.
    #[inline(always)]
    pub(super) fn meet<const CLOSED: bool>(&self) -> Option<bool> {
        let sides = self.sides();
        if LONG { float_margins::meet::<CLOSED>(sides) } else { short_boxes::meet(sides) }
    }

    /// Whether they overlap, or touch; none for boxes without area.
    #[inline]
    pub(super) fn meet_exactly<const CLOSED: bool>(&self) -> Option<bool> {
        let sides = self.sides();
        // The margin across a side of no length is zero, and says nothing.
        sides.iter().take(4).all(|e| !e.is_zero()).then(|| all_meet::<CLOSED>(sides))
    }
}
