//! Whether two boxes in any direction overlap, by the leading bits of their sides: for chips.
//!
//! Products of words take a fifth of exact ones on a Cortex-M0, and half on a Cortex-M3.

use super::margins::{short, short_cross};
use crate::num::{Raw, leading_zeros32};

/// The size of a number, or one less: one instruction less than the size.
#[inline(always)]
const fn nearly_size(n: i32) -> i32 {
    n ^ (n >> 31)
}

/// Whether two boxes overlap; none if they nearly touch. From two sides of each and the way between
/// the middles, or from half of all: below 2^30, and below 2^31.
#[inline(always)]
pub(super) fn meet([u, v, s, t, d]: [Raw; 5]) -> Option<bool> {
    // For the sum `l` of the sizes of four components, products with `d` are up to 2 l^2.
    const BITS: u32 = 14;
    // A component loses less than one. So a product of two sides is off by less than the sum of
    // their components and two. With those of `d`, these are less than 10 l in the sum of four.
    const OFF: i32 = 11 << BITS;
    // Below 2^31: both bounding boxes are in the domain, or twice as large.
    let reach = |[a, b, c, e]: [i32; 4]| {
        let size = |n: i32| nearly_size(n) as u32;
        size(a).wrapping_add(size(b)).wrapping_add(size(c)).wrapping_add(size(e))
    };
    let (x, y) = (reach([u.x, v.x, s.x, t.x]), reach([u.y, v.y, s.y, t.y]));
    // Each sum may lack 4. Then the bounding boxes are apart.
    if nearly_size(d.x) as u32 > x.wrapping_add(4) || nearly_size(d.y) as u32 > y.wrapping_add(4) {
        return Some(false);
    }
    let shift = (32 - BITS - leading_zeros32(x | y | 1 << (BITS - 1))) & 31;
    let [u, v, s, t, d] = [u, v, s, t, d].map(|e| short(e, shift));
    let size = |e: Raw, f: Raw| nearly_size(short_cross(e, f));
    let unless_near = |m: i32| if m < -2 * OFF { Some(false) } else { None };
    // The margins of `exact_margins`, less OFF. Each is used at once: with all four at hand, a
    // Cortex-M3 takes 135 instructions instead of 124.
    let own = short_cross(u, v) - OFF;
    let (us, ut) = (size(u, s), size(u, t));
    let across_u = own - size(u, d) + us + ut;
    if across_u < 0 {
        return unless_near(across_u);
    }
    let (vs, vt) = (size(v, s), size(v, t));
    let across_v = own - size(v, d) + vs + vt;
    if across_v < 0 {
        return unless_near(across_v);
    }
    let others = short_cross(s, t) - OFF;
    let across_s = others - size(s, d) + us + vs;
    if across_s < 0 {
        return unless_near(across_s);
    }
    let across_t = others - size(t, d) + ut + vt;
    if across_t < 0 { unless_near(across_t) } else { Some(true) }
}
