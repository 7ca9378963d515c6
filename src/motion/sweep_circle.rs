//! A moving circle against the faces and corners of blocks.

use super::body::{Entry, kernel::Kernel};
use super::sweep_box::{Face, over, sweep_face};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, MOTION, Raw, Toi, imul, isqrt64_ceil, less128, mul_div, mul64, sqr64, usqr};
use crate::shape::{Aabb, Circle};
use crate::world::{Feature, Geometry, World};

impl Kernel for Circle {
    const MEETS_CORNERS: bool = true;

    fn bounds(&self) -> Aabb {
        self.aabb()
    }

    fn check_size(&self) -> Result<(), RangeError> {
        if self.r() < MOTION { Ok(()) } else { Err(RangeError { what: Quantity::BodySize, value: self.r() }) }
    }

    fn shifted(&self, d: Raw) -> Self {
        Self::from_raw_unchecked(self.c().add(d), self.r())
    }

    fn sweep(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let (c, r) = (self.c(), self.r());
        match feature.geometry {
            Geometry::Face { a, dir, len, joined } => {
                let face = Face::new(Raw::of(a), dir, len, joined);
                // A circle without radius is a box without size: it may touch a face's free end and pass.
                if r == 0 { sweep_face(c, c, d, &face) } else { sweep_disc_face(c, r, d, &face) }
            }
            Geometry::Vertex { p, e_in, e_out } => sweep_vertex(c.sub(Raw::of(p)), r, d, e_in, e_out),
        }
    }

    fn overlaps_world<W: World>(&self, world: &W) -> bool {
        world.overlaps_circle(self)
    }
}

/// As [`sweep_face`], for the point of the disc that faces the wall: it must meet the closed face.
fn sweep_disc_face(c: Raw, r: i32, d: Raw, face: &Face) -> Option<Entry> {
    let (speed, along) = face.split(d);
    let into = face.away(speed).wrapping_neg();
    if into <= 0 {
        return None;
    }
    let (c_n, c_t) = face.split(c);
    let gap = face.in_front(c_n).wrapping_sub(r);
    if gap < 0 || gap >= into {
        return None;
    }
    let over_lo = over(c_t.wrapping_sub(face.lo), along, gap, into);
    let over_hi = over(face.hi.wrapping_sub(c_t), along.wrapping_neg(), gap, into);
    (over_lo >= 0 && over_hi >= 0).then_some(Entry {
        num: gap as u32,
        den: into as u32,
        normal: face.normal,
        at_end: false,
        step: None,
    })
}

/// Entry of the point `m` (centre relative to the corner) moving by `d` into the disc of radius `r`, inside the corner's open cone.
///
/// Whether it enters is decided without root or division: |m + d| < r, or a closest approach inside the motion that is nearer than
/// r (numerics: cross^2 < r^2 |d|^2, 124 bits). On the cone's borders, and outside of it, the faces are in charge.
fn sweep_vertex(m: Raw, r: i32, d: Raw, e_in: Axis, e_out: Axis) -> Option<Entry> {
    let b = m.dot(d).wrapping_neg();
    if b <= 0 {
        return None;
    }
    let (rr, a, cross) = (usqr(r as u32), d.len2(), m.cross(d));
    let passes_inside = (b as u64) < a && less128(sqr64(cross.unsigned_abs()), mul64(rr, a));
    if !passes_inside && m.add(d).len2() >= rr {
        return None;
    }
    // A block's cone is a quadrant: m.e_in > 0 and m.e_out < 0 are one condition a component.
    let (sx, sy) = (e_in.x.wrapping_sub(e_out.x), e_in.y.wrapping_sub(e_out.y));
    let in_x = enters_where_positive(m.x.wrapping_mul(sx), d.x.wrapping_mul(sx), d.x, d.y, cross, r);
    let in_y = enters_where_positive(m.y.wrapping_mul(sy), d.y.wrapping_mul(sy), d.y, d.x, cross.wrapping_neg(), r);
    if !in_x || !in_y {
        return None;
    }
    let t = entry_time(m.len2().saturating_sub(rr), b as u64, mul64(rr, a), cross);
    let step = Raw { x: outward_part(m.x, d.x, t), y: outward_part(m.y, d.y, t) };
    let at = m.add(step);
    Some(Entry { num: t.raw(), den: Toi::ONE.raw(), normal: Axis::new(at.x, at.y), at_end: false, step: Some(step) })
}

/// Whether the point enters the disc at a moment T with `u > 0`, where `u` runs from `u0` by `du`.
///
/// `p` is the component of the motion that moves u, `q` the other one. At the moment s with u = 0 the other
/// coordinate is -cross/p, so against the disc's radius: |cross| ? r |p|, exactly, in 64 bits. The point approaches the disc's
/// centre at s iff cross p q > 0. Inside the disc at s: T < s. On its rim: T = s while approaching, else T < s. Outside: T > s
/// while approaching, else T < s.
fn enters_where_positive(u0: i32, du: i32, p: i32, q: i32, cross: i64, r: i32) -> bool {
    let u1 = u0.wrapping_add(du);
    if u0 > 0 && u1 > 0 {
        return true;
    }
    if u0 <= 0 && u1 <= 0 {
        return false;
    }
    let (distance, rim) = (cross.unsigned_abs(), imul(r, p).unsigned_abs());
    let approaching = cross.signum() * i64::from(p.signum()) * i64::from(q.signum()) > 0;
    if du > 0 {
        // T > s
        distance > rim && approaching
    } else {
        // T < s
        distance < rim || !approaching
    }
}

/// A lower bound of the entry time in Q30: T = c / (b + sqrt(r^2 a - cross^2)), with c = |m|^2 - r^2 and b = -m.d.
///
/// This form has no cancellation. The root and the denominator are rounded up, the numerator and the quotient down, so T is never
/// late. Each step keeps 31 bits or whole raw units: it is early by less than a raw unit of way.
#[inline(never)]
fn entry_time(c: u64, b: u64, rra: (u64, u64), cross: i64) -> Toi {
    let square = sqr64(cross.unsigned_abs());
    let (lo, borrow) = rra.1.overflowing_sub(square.1);
    let hi = rra.0.wrapping_sub(square.0).wrapping_sub(u64::from(borrow));
    let den = b.wrapping_add(root_up(hi, lo));
    let shift = (64 - den.leading_zeros()).saturating_sub(31);
    let den = ((den >> shift) as u32).wrapping_add(1);
    let num = ((c >> shift) as u32).min(den);
    Toi::clamped(mul_div(num, Toi::ONE.raw(), den))
}

/// An upper bound of the square root of a 128-bit number below 2^116, within one part in 2^31 (exact ceiling below 2^64).
fn root_up(hi: u64, lo: u64) -> u64 {
    if hi == 0 {
        return u64::from(isqrt64_ceil(lo));
    }
    // The least even shift that leaves 64 bits.
    let shift = (65 - hi.leading_zeros()) & !1;
    let top = (hi << (64 - shift)) | (lo >> shift);
    u64::from(isqrt64_ceil(top.saturating_add(1))) << (shift / 2)
}

/// The part `t` of a component `d`, rounded so that `m` plus it is no nearer to zero than the exact sum.
///
/// While the sum is still on the side that `d` comes from, rounding toward zero keeps it back; beyond zero rounding up carries it on.
fn outward_part(m: i32, d: i32, t: Toi) -> i32 {
    let part = t.of_raw(d);
    let at = m.wrapping_add(part);
    let short = crate::num::umul(d.unsigned_abs(), t.raw()) & u64::from(Toi::ONE.raw() - 1) != 0;
    if short && (at == 0 || (at > 0) == (d > 0)) { part.wrapping_add(d.signum()) } else { part }
}
