//! Whether two boxes in any direction overlap, by the leading bits of their sides: for chips.
//!
//! Products of words take a fifth of exact ones on a Cortex-M0, and half on a Cortex-M3.

use super::margins::{margins, short, short_cross};
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
    let shift = (32 - BITS).saturating_sub(leading_zeros32(x | y)) & 31;
    let sides = [u, v, s, t, d].map(|e| short(e, shift));
    let [p, q, r, w] = margins(sides, short_cross, nearly_size).map(|m| m.wrapping_sub(OFF));
    if (p | q | r | w) >= 0 {
        return Some(true);
    }
    let is_beyond = |m: i32| m < -2 * OFF;
    if is_beyond(p) || is_beyond(q) || is_beyond(r) || is_beyond(w) { Some(false) } else { None }
}
