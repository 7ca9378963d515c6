//! A moving circle against quarter arcs.
//!
//! The centre moves against an arc of another radius around the same centre: larger by its own radius outside of a convex arc, smaller
//! by it inside of a concave one. Only what happens in the closed quadrant counts; beyond its borders the neighbours of the arc are in charge.

use super::body::Entry;
use super::sweep_vertex::{comes_to_quadrant, enters_quadrant, entry};
use crate::num::{Axis, Raw, Toi, less128, mul64, sqr64, usqr};
use crate::query::cast::crossing::{Crossing, direction};
use crate::query::cast::moment::{exit_time, ratio};

/// Entry of the point `m` (as seen from the arc's centre) moving by `d` into the disc of radius `r`, in the quadrant, which is `closed` or not.
///
/// Who starts inside of the disc is on another side of the solid, and passes the quadrant's border inside or after leaving: no entry.
#[inline(never)]
pub(super) fn enter_quarter(m: Raw, r: i32, d: Raw, quadrant: Axis, closed: bool) -> Option<Entry> {
    if !comes_to_quadrant(m, d, quadrant, closed) {
        return None;
    }
    let Some(hit) = &Crossing::of(m, r, d) else { return None };
    if enters_quadrant(m, r, d, quadrant, hit.cross, closed) { entry(hit, m, d) } else { None }
}

/// The point `m` leaving the disc of radius `r` by `d`, in the closed quadrant.
///
/// It leaves where the reversed motion enters. A motion that only touches the disc, as from a floor into a quarter pipe, leaves it
/// there; on the border of the quadrant it does so only if it goes on into the quadrant, not if it comes out of it.
#[inline(never)]
pub(super) fn leave_quarter(m: Raw, r: i32, d: Raw, quadrant: Axis) -> Option<Entry> {
    let (end, rr) = (m.add(d), usqr(r as u32));
    if end.len2() <= rr {
        return None;
    }
    let (a, b, cross) = (d.len2(), m.dot(d).wrapping_neg(), m.cross(d));
    let (rra, square) = (mul64(rr, a), sqr64(cross.unsigned_abs()));
    let inner = rr.checked_sub(m.len2());
    let passes = b > 0 && (b as u64) < a && !less128(rra, square);
    if inner.is_none() && !passes {
        return None;
    }
    let back = Raw { x: d.x.wrapping_neg(), y: d.y.wrapping_neg() };
    // Reversed, the same line has the opposite moment: (m + d) x -d = -(m x d). A tangent does not approach, so it is taken where it goes on
    // into the quadrant and not where it comes out.
    if !enters_quadrant(end, r, back, quadrant, cross.wrapping_neg(), true) {
        return None;
    }
    let t = exit_time(inner.unwrap_or(0), b, a, rra, cross);
    let step = Raw { x: t.of_raw_beside(m.x, d.x, false), y: t.of_raw_beside(m.y, d.y, false) };
    let at = m.add(step);
    // In a pipe as wide as the body the centre itself may be the nearest place of the lattice.
    let normal = if at.is_zero() { back } else { Raw { x: at.x.wrapping_neg(), y: at.y.wrapping_neg() } };
    let normal = direction(normal);
    Some(Entry { num: t.raw(), den: Toi::ONE.raw(), normal, at_end: true, step: Some(step) })
}

/// The same for the corner of a box. Exactly through an end of the arc and out of its quarter it passes: what the arc bounds ends there as well.
/// A circle does not, it reaches farther to the side.
pub(super) fn leave_by_corner(m: Raw, r: i32, d: Raw, quadrant: Axis) -> Option<Entry> {
    let passes = |x: i32, y: i32, along: i32| {
        let end = Raw { x: x.wrapping_mul(r), y: y.wrapping_mul(r) };
        along <= 0 && end.sub(m).cross(d) == 0 && end.dot(d) > 0
    };
    let (x, y) = (quadrant.x, quadrant.y);
    let passes = passes(0, y, d.x.wrapping_mul(x)) || passes(x, 0, d.y.wrapping_mul(y));
    if passes { None } else { leave_quarter(m, r, d, quadrant) }
}

/// The same where the disc is a point: a body as wide as the pipe comes to its centre, touches all of it, and goes on against an end.
#[inline(never)]
pub(super) fn leave_centre(m: Raw, d: Raw, quadrant: Axis) -> Option<Entry> {
    let (a, b) = (d.len2(), m.dot(d).wrapping_neg());
    if m.cross(d) != 0 || b < 0 || b as u64 >= a {
        return None;
    }
    let against = |side: i32, d: i32| if side.wrapping_mul(d) > 0 { side.wrapping_neg() } else { 0 };
    let normal = Axis::new(against(quadrant.x, d.x), against(quadrant.y, d.y));
    if normal.is_zero() {
        return None;
    }
    let t = ratio(b as u64, a);
    let step = Raw { x: m.x.wrapping_neg(), y: m.y.wrapping_neg() };
    Some(Entry { num: t.raw(), den: Toi::ONE.raw(), normal, at_end: true, step: Some(step) })
}
