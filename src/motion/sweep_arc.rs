//! A moving circle against quarter arcs.
//!
//! The centre moves against an arc of another radius around the same centre: larger by its own radius outside of a convex arc, smaller
//! by it inside of a concave one. Only what happens in the closed quadrant counts; beyond its borders the neighbours of the arc are in charge.

use super::body::Entry;
use super::moment::{exit_time, ratio};
use super::sweep_vertex::{Crossing, direction, enters_where};
use crate::num::{Axis, Raw, Toi, less128, mul64, sqr64, usqr};

/// Entry of the point `m` (as seen from the arc's centre) moving by `d` into the disc of radius `r`, in the closed quadrant.
///
/// Who starts inside of the disc is on another side of the solid, and passes the quadrant's border inside or after leaving: no entry.
#[inline(never)]
pub(super) fn enter_quarter(m: Raw, r: i32, d: Raw, quadrant: Axis) -> Option<Entry> {
    let hit = Crossing::of(m, r, d)?;
    crosses_rim(m, r, d, quadrant, hit.cross).then(|| hit.entry(m, d))
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
    if !crosses_rim(end, r, back, quadrant, cross.wrapping_neg()) {
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

/// Whether the point enters the disc of radius `r` in the closed quadrant.
fn crosses_rim(m: Raw, r: i32, d: Raw, quadrant: Axis, cross: i64) -> bool {
    let (sx, sy) = (quadrant.x, quadrant.y);
    enters_where::<true>(m.x.wrapping_mul(sx), d.x.wrapping_mul(sx), d.x, d.y, cross, r)
        && enters_where::<true>(m.y.wrapping_mul(sy), d.y.wrapping_mul(sy), d.y, d.x, cross.wrapping_neg(), r)
}
