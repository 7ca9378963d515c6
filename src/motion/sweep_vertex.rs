//! A moving circle against convex corners of any angle.

use super::body::Entry;
use super::moment::entry_time;
use super::sweep_slope::offset_to_radius;
use crate::num::{Axis, Raw, Toi, imul, less128, mul64, sqr64, usqr};
use core::cmp::Ordering;

/// A motion that enters a disc around the origin: what its moment is computed from.
pub(super) struct Crossing {
    rr: u64,
    /// |d|^2.
    a: u64,
    /// -m.d, positive.
    b: u64,
    pub(super) cross: i64,
}

impl Crossing {
    /// Of the point `m` that moves by `d` into the disc of radius `r`.
    ///
    /// Decided without root or division: |m + d| < r, or a closest approach inside the motion that is nearer than r (numerics:
    /// cross^2 < r^2 |d|^2, 124 bits).
    #[inline]
    pub(super) fn of(m: Raw, r: i32, d: Raw) -> Option<Self> {
        let b = m.dot(d).wrapping_neg();
        if b <= 0 {
            return None;
        }
        let (rr, a, cross) = (usqr(r as u32), d.len2(), m.cross(d));
        let passes_inside = (b as u64) < a && less128(sqr64(cross.unsigned_abs()), mul64(rr, a));
        if !passes_inside && m.add(d).len2() >= rr {
            return None;
        }
        Some(Self { rr, a, b: b as u64, cross })
    }

    /// The entry, its displacement rounded away from the centre.
    pub(super) fn entry(&self, m: Raw, d: Raw) -> Entry {
        let t = entry_time(m.len2().saturating_sub(self.rr), self.b, mul64(self.rr, self.a), self.cross);
        let step = Raw { x: t.of_raw_beside(m.x, d.x, true), y: t.of_raw_beside(m.y, d.y, true) };
        let normal = direction(m.add(step));
        Entry { num: t.raw(), den: Toi::ONE.raw(), normal, at_end: false, step: Some(step) }
    }
}

/// The direction of a point from the origin: along x or y it has one length, whatever the radius.
pub(super) fn direction(m: Raw) -> Axis {
    if m.x == 0 || m.y == 0 { Axis::new(m.x.signum(), m.y.signum()) } else { Axis::new(m.x, m.y) }
}

/// Whether the corner is one of a block: its edges along x and y, across each other.
pub(super) const fn is_square(e_in: Axis, e_out: Axis) -> bool {
    is_unit(e_in) && is_unit(e_out) && e_in.x != e_out.x && e_in.y != e_out.y
}

const fn is_unit(e: Axis) -> bool {
    (e.x == 0 || e.y == 0) && e.x.wrapping_add(e.y).unsigned_abs() == 1
}

/// Entry of the point `m` (centre relative to the corner) moving by `d` into the disc of radius `r`, inside the open cone of a block's corner.
///
/// On the cone's borders, and outside of it, the faces are in charge.
#[inline]
pub(super) fn sweep_square(m: Raw, r: i32, d: Raw, e_in: Axis, e_out: Axis) -> Option<Entry> {
    let hit = Crossing::of(m, r, d)?;
    // The cone is a quadrant: m.e_in > 0 and m.e_out < 0 are one condition a component.
    let (sx, sy) = (e_in.x.wrapping_sub(e_out.x), e_in.y.wrapping_sub(e_out.y));
    let in_x = enters_where::<false>(m.x.wrapping_mul(sx), d.x.wrapping_mul(sx), d.x, d.y, hit.cross, r);
    let in_y = enters_where::<false>(m.y.wrapping_mul(sy), d.y.wrapping_mul(sy), d.y, d.x, hit.cross.wrapping_neg(), r);
    (in_x && in_y).then(|| hit.entry(m, d))
}

/// The same for a corner of any angle below 180 degrees, cusps included.
#[inline(never)]
pub(super) fn sweep_cone(m: Raw, r: i32, d: Raw, e_in: Axis, e_out: Axis) -> Option<Entry> {
    let hit = Crossing::of(m, r, d)?;
    let inside = enters_along(m, d, e_in, hit.cross, r) && enters_along(m, d, e_out.reversed(), hit.cross, r);
    inside.then(|| hit.entry(m, d))
}

/// Whether the point enters the disc at a moment T with `u > 0` (or `u >= 0` where `CLOSED`), where `u` runs from `u0` by `du`.
///
/// `p` is the component of the motion that moves u, `q` the other one. At the moment s with u = 0 the other
/// coordinate is -cross/p, so against the disc's radius: |cross| ? r |p|, exactly, in 64 bits. The point approaches the disc's
/// centre at s iff cross p q > 0.
#[inline]
pub(super) fn enters_where<const CLOSED: bool>(u0: i32, du: i32, p: i32, q: i32, cross: i64, r: i32) -> bool {
    let u1 = u0.wrapping_add(du);
    let inside = |u: i32| u > 0 || (CLOSED && u == 0);
    if inside(u0) && inside(u1) {
        return true;
    }
    if !inside(u0) && !inside(u1) {
        return false;
    }
    let (distance, rim) = (cross.unsigned_abs(), imul(r, p).unsigned_abs());
    let approaching = cross.signum() * i64::from(p.signum()) * i64::from(q.signum()) > 0;
    in_time::<CLOSED>(distance.cmp(&rim), approaching, du > 0)
}

/// The same with u = e . m for any direction: at the moment s the point is on the line across e, `|cross| |e| / |e.d|` from the centre.
fn enters_along(m: Raw, d: Raw, e: Axis, cross: i64, r: i32) -> bool {
    let (m, v) = (Axis::new(m.x, m.y), Axis::new(d.x, d.y));
    let (u0, du) = (e.dot(m), e.dot(v));
    let u1 = u0.wrapping_add(du);
    if u0 > 0 && u1 > 0 {
        return true;
    }
    if u0 <= 0 && u1 <= 0 {
        return false;
    }
    // There m = n cross / du, with n = (e.y, -e.x).
    let approaching = cross.signum() * e.perp_dot(v).signum() * du.signum() > 0;
    in_time::<false>(offset_to_radius(cross, e, r, du), approaching, du > 0)
}

/// Whether the entry into the disc is after s where `rising`, else before it; where `CLOSED` at s will do.
///
/// Inside the disc at s: T < s. On its rim: T = s while approaching, else T < s. Outside: T > s while approaching, else T < s.
fn in_time<const CLOSED: bool>(offset: Ordering, approaching: bool, rising: bool) -> bool {
    if rising {
        approaching && if CLOSED { offset.is_ge() } else { offset.is_gt() }
    } else {
        !approaching || if CLOSED { offset.is_le() } else { offset.is_lt() }
    }
}
