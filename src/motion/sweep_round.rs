//! Sweeps a moving circle against convex corners of any angle, and against quarter arcs.

use super::body::Entry;
use crate::num::{Axis, Raw, Toi, less128, mul64, sqr64, umul, usqr};
use crate::query::cast::crossing::{Crossing, direction};
use crate::query::cast::moment::{exit_time, ratio};
use crate::query::cast::offset::offset;
use crate::query::cast::side::along;
use core::cmp::Ordering;

/// The entry of a crossing. A body that is over a corner or an arc from the start does not enter.
/// It passes such a one-way corner. Over a solid one it can be only if it started in the solid.
pub(super) fn entry(hit: &Crossing, m: Raw, d: Raw) -> Option<Entry> {
    if hit.starts_inside(m) {
        return None;
    }
    let (t, step, normal) = hit.contact(m, d);
    Some(Entry { num: t.raw(), den: Toi::ONE.raw(), normal, at_end: false, step: Some(step) })
}

/// Whether the corner is one of a block: its edges along x and y, across each other.
pub(super) const fn is_square(e_in: Axis, e_out: Axis) -> bool {
    is_unit(e_in) && is_unit(e_out) && e_in.x != e_out.x && e_in.y != e_out.y
}

const fn is_unit(e: Axis) -> bool {
    (e.x == 0 || e.y == 0) && e.x.wrapping_add(e.y).unsigned_abs() == 1
}

/// Entry of a point into the disc of radius `r`, inside a corner's open cone. `m` is the centre
/// relative to the corner, `d` its motion. The angle is below 180 degrees; cusps are included. On
/// the cone's borders, and outside of it, the faces are responsible.
#[inline(never)]
pub(super) fn sweep_cone(m: Raw, r: i32, d: Raw, e_in: Axis, e_out: Axis) -> Option<Entry> {
    if !comes_along(m, d, e_in) || !comes_along(m, d, e_out.reversed()) {
        return None;
    }
    let Some(hit) = &Crossing::of(m, r, d) else { return None };
    let inside = enters_along(m, d, e_in, hit.cross, r) && enters_along(m, d, e_out.reversed(), hit.cross, r);
    if inside { entry(hit, m, d) } else { None }
}

/// Whether a point is ever over each half-plane of a quadrant. If not, it enters nothing there, and
/// no product is needed.
pub(super) fn comes_to_quadrant(m: Raw, d: Raw, quadrant: Axis, closed: bool) -> bool {
    let comes = |m: i32, d: i32, sign: i32| {
        let far = if (d < 0) == (sign < 0) { m.wrapping_add(d) } else { m };
        let far = if sign < 0 { far.wrapping_neg() } else { far };
        far.wrapping_add(i32::from(closed)) > 0
    };
    comes(m.x, d.x, quadrant.x) && comes(m.y, d.y, quadrant.y)
}

/// Whether a point enters the disc around the origin in a quadrant, its borders included if
/// `closed`; `cross` is m x d.
#[inline(never)]
pub(super) fn enters_quadrant(m: Raw, r: i32, d: Raw, quadrant: Axis, cross: i64, closed: bool) -> bool {
    let flipped = |v: i32, sign: i32| if sign < 0 { v.wrapping_neg() } else { v };
    // Mirrored into the first quadrant: each mirror changes the sign of the moment.
    let (m, d, mirrored) = (
        Raw { x: flipped(m.x, quadrant.x), y: flipped(m.y, quadrant.y) },
        Raw { x: flipped(d.x, quadrant.x), y: flipped(d.y, quadrant.y) },
        (quadrant.x < 0) != (quadrant.y < 0),
    );
    let cross = if mirrored { cross.wrapping_neg() } else { cross };
    enters_where(m.x, d.x, d.y, cross, r, closed) && enters_where(m.y, d.y, d.x, cross.wrapping_neg(), r, closed)
}

/// Whether the point enters the disc at a moment T with `u > 0` (or `u >= 0` if `closed`), as `u`
/// runs from `u0` by `p`.
///
/// `q` is the other component of the motion. At the moment s with u = 0 the other coordinate is
/// -cross/p, so against the disc's radius:
/// |cross| ? r |p|, exactly, in 64 bits. The point approaches the disc's centre at s iff cross p q > 0.
#[inline(never)]
fn enters_where(u0: i32, p: i32, q: i32, cross: i64, r: i32, closed: bool) -> bool {
    // u >= 0 is u + 1 > 0.
    let first = u0.wrapping_add(i32::from(closed));
    let last = first.wrapping_add(p);
    if first > 0 && last > 0 {
        return true;
    }
    if first <= 0 && last <= 0 {
        return false;
    }
    let offset = cross.unsigned_abs().cmp(&umul(r.unsigned_abs(), p.unsigned_abs()));
    // p is not 0 here.
    let approaching = cross != 0 && q != 0 && (cross < 0) == ((p ^ q) < 0);
    in_time(offset, approaching, p > 0, closed)
}

/// Whether `u = e . m` is ever positive.
pub(super) fn comes_along(m: Raw, d: Raw, e: Axis) -> bool {
    let u = along(e, m);
    u > 0 || u.wrapping_add(along(e, d)) > 0
}

/// [`enters_where`] with u = e . m, for any direction. At the moment s the point is on the line
/// across e, `|cross| |e| / |e.d|` from the centre.
#[inline(never)]
pub(super) fn enters_along(m: Raw, d: Raw, e: Axis, cross: i64, r: i32) -> bool {
    let (u0, du) = (along(e, m), along(e, d));
    let u1 = u0.wrapping_add(du);
    if u0 > 0 && u1 > 0 {
        return true;
    }
    if u0 <= 0 && u1 <= 0 {
        return false;
    }
    // There m = n cross / du, with n = (e.y, -e.x); du is not 0.
    let turn = along(e.perp(), d);
    let approaching = cross != 0 && turn != 0 && (cross < 0) ^ (turn < 0) == (du < 0);
    in_time(offset(cross, e, r, du), approaching, du > 0, false)
}

/// Whether the entry into the disc is after s if `rising`, otherwise before it. If `closed`, at s
/// is enough.
///
/// Inside the disc at s: T < s. On its rim: T = s while approaching, else T < s. Outside: T > s
/// while approaching, else T < s.
fn in_time(offset: Ordering, approaching: bool, rising: bool, closed: bool) -> bool {
    let at_once = closed && offset.is_eq();
    if rising { approaching && (offset.is_gt() || at_once) } else { !approaching || offset.is_lt() || at_once }
}

/// Entry of the point `m`, relative to an arc's centre, that moves by `d` into the disc of radius
/// `r`. Only in the quadrant, with its borders if `closed`.
///
/// A point that starts inside of the disc is on another side of the solid. It passes the quadrant's
/// border inside, or after leaving: no entry.
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
/// It leaves where the reversed motion enters. A motion that only touches the disc, as from a floor
/// into a quarter pipe, leaves it there. On the border of the quadrant it leaves only if it
/// continues into the quadrant, not if it comes out of it.
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
    let back = d.reversed();
    // Reversed, the same line has the opposite moment: (m + d) x -d = -(m x d). A tangent does not
    // approach. It counts if it continues into the quadrant, and not if it comes out.
    if !enters_quadrant(end, r, back, quadrant, cross.wrapping_neg(), true) {
        return None;
    }
    let t = exit_time(inner.unwrap_or(0), b, a, rra, cross);
    let step = Raw { x: t.of_raw_beside(m.x, d.x, false), y: t.of_raw_beside(m.y, d.y, false) };
    let at = m.add(step);
    // In a pipe as wide as the body, the centre itself may be the nearest lattice point.
    let normal = if at.is_zero() { back } else { Raw { x: at.x.wrapping_neg(), y: at.y.wrapping_neg() } };
    let normal = direction(normal);
    Some(Entry { num: t.raw(), den: Toi::ONE.raw(), normal, at_end: true, step: Some(step) })
}

/// [`leave_quarter`] for the corner of a box. It passes exactly through an end of the arc and out
/// of its quarter, because the solid that the arc bounds ends there too. A circle does not pass: it
/// reaches farther to the side.
pub(super) fn leave_by_corner(m: Raw, r: i32, d: Raw, quadrant: Axis) -> Option<Entry> {
    let passes = |x: i32, y: i32, along: i32| {
        let end = Raw { x: x.wrapping_mul(r), y: y.wrapping_mul(r) };
        along <= 0 && end.sub(m).cross(d) == 0 && end.dot(d) > 0
    };
    let (x, y) = (quadrant.x, quadrant.y);
    let passes = passes(0, y, d.x.wrapping_mul(x)) || passes(x, 0, d.y.wrapping_mul(y));
    if passes { None } else { leave_quarter(m, r, d, quadrant) }
}

/// [`leave_quarter`] if the disc is a point. A body as wide as the pipe reaches its centre, touches
/// all of it, and moves on against an end.
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

/// Leaves a pipe: the disc of the radius `room` that the pipe leaves to a body's centre.
#[inline]
pub(super) fn leave_pipe(m: Raw, room: i32, d: Raw, quadrant: Axis) -> Option<Entry> {
    match room.cmp(&0) {
        Ordering::Greater => leave_quarter(m, room, d, quadrant),
        Ordering::Equal => leave_centre(m, d, quadrant),
        // It meets the arc's ends first.
        Ordering::Less => None,
    }
}
