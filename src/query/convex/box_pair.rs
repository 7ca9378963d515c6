//! Whether two boxes in any direction overlap, without corners.

use super::margins::all_meet;
use super::{float_margins, short_boxes};
use crate::num::{LONG, Raw};
use crate::shape::Convex;

/// Whether two sharp boxes overlap, or touch; none for other shapes, and for boxes without area.
#[inline(always)]
pub(super) fn meet<const CLOSED: bool>(a: &impl Convex, b: &impl Convex) -> Option<bool> {
    if (a.rounding() | b.rounding()) != 0 {
        return None;
    }
    let sides = sides(a, b)?;
    let settled = if LONG { float_margins::meet::<CLOSED>(sides) } else { short_boxes::meet(sides) };
    // The margin across a side of no length is zero, and says nothing.
    settled.or_else(|| sides.iter().take(4).all(|e| !e.is_zero()).then(|| all_meet::<CLOSED>(sides)))
}

/// Two sides of each box and the way between the middles, or half of all.
#[inline(always)]
pub(super) fn sides(a: &impl Convex, b: &impl Convex) -> Option<[Raw; 5]> {
    let ([u, v, p], [s, t, q]) = match (a.half_sides(), b.half_sides()) {
        (Some(a), Some(b)) => (a, b),
        _ => (a.box_sides()?, b.box_sides()?),
    };
    Some([u, v, s, t, q.sub(p)])
}
