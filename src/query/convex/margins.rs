//! How far the sides of two boxes are from separating them.
//!
//! The sum of two boxes is its own mirror image, so two opposite sides are one question. Across
//! them, is the distance of the middles less than half of the two widths together?

use crate::num::{Raw, leading_zeros32};

/// For each of the four directions of sides: the sum of the widths of two parallelograms across it,
/// less twice the distance of their middles. `d` is twice the vector between the middles.
///
/// The products are below 2^61 for two sides, below 2^62 with `d`, and the sum of three below 2^63.
#[inline]
pub(super) fn exact_margins([u, v, s, t, d]: [Raw; 5]) -> [i64; 4] {
    // Positive for two sides of one parallelogram.
    let (own, others) = (u.cross(v), s.cross(t));
    let size = |e: Raw, f: Raw| e.cross(f).wrapping_abs();
    let (us, ut, vs, vt) = (size(u, s), size(u, t), size(v, s), size(v, t));
    let across_u = own + us + ut - size(u, d);
    let across_v = own + vs + vt - size(v, d);
    let across_s = others + us + vs - size(s, d);
    let across_t = others + ut + vt - size(t, d);
    [across_u, across_v, across_s, across_t]
}

/// Whether no side of two boxes has the other box beyond it.
#[inline(never)]
pub(super) fn all_meet<const CLOSED: bool>(sides: [Raw; 5]) -> bool {
    exact_margins(sides).iter().all(|m| if CLOSED { *m >= 0 } else { *m > 0 })
}

/// The bits of the sizes of both components, or of one less.
pub(super) const fn spread(v: Raw) -> u32 {
    ((v.x ^ (v.x >> 31)) | (v.y ^ (v.y >> 31))) as u32
}

/// How far to shift numbers that these bits bound, so they fit the given number of bits and a sign.
pub(super) const fn shift_to(count: u32, bits: u32) -> u32 {
    (32 - count).saturating_sub(leading_zeros32(bits)) & 31
}

pub(super) const fn short(v: Raw, shift: u32) -> Raw {
    Raw { x: v.x >> shift, y: v.y >> shift }
}

/// A cross product of components whose product is below 2^30.
pub(super) const fn short_cross(e: Raw, f: Raw) -> i32 {
    e.x.wrapping_mul(f.y).wrapping_sub(e.y.wrapping_mul(f.x))
}
