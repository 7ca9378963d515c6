//! Whether two boxes in any direction overlap, by floats: for 64-bit processors.
//!
//! Such a processor computes with two floats at a time, and converts two words at a time. So this
//! takes half of the instructions of products in double words.

use super::margins::spread;
use super::two_floats::TwoFloats as Two;
use crate::num::Raw;

/// The least of the margins of two boxes, and the smaller one of their areas, nearly: see
/// [`margins`](super::margins::margins).
#[inline(always)]
#[expect(clippy::float_arithmetic, reason = "errors are bounded where the results are compared")]
fn least_margin(sides: [Raw; 5]) -> (f64, f64) {
    let [u, v, s, t, d] = sides.map(Two::of);
    let (with_s, with_t) = (Two::crosses([u, v], s).size(), Two::crosses([u, v], t).size());
    let across_own = with_s.add(with_t).sub(Two::crosses([u, v], d).size());
    let Two([us, vs]) = with_s;
    let Two([ut, vt]) = with_t;
    let across_others = Two([us + vs, ut + vt]).sub(Two::crosses([s, t], d).size());
    let areas = Two([u.cross(v), s.cross(t)]);
    (Two([across_own.least(), across_others.least()]).add(areas).least(), areas.least())
}

/// Whether two boxes overlap, or touch. None for a box without area, and if the floats are too
/// short. From two sides of each and the way between the middles, or from half of all.
#[inline(always)]
pub(super) fn meet<const CLOSED: bool>(sides: [Raw; 5]) -> Option<bool> {
    // Sides are below 2^30 and `d` is below 2^31. A product with `d` is off by 2^7 and their
    // difference by 2^9, one of two sides by 2^8. The sums round by 2^8, 2^8 and 2^9. Together
    // that is less than this.
    const OFF: f64 = (1 << 12) as f64;
    let (margin, area) = least_margin(sides);
    if margin > OFF {
        return Some(true);
    } else if margin < -OFF {
        return Some(false);
    }
    // If the vectors are short, all of it is exact: products are below 2^51, and sums of two
    // products from each of four terms below 2^53. The margin across a side of no length is zero,
    // and says nothing.
    let bits = sides.iter().fold(0, |bits, e| bits | spread(*e));
    (area > 0.0 && bits >> 25 == 0).then_some(if CLOSED { margin >= 0.0 } else { margin > 0.0 })
}
