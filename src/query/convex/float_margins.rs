//! Whether two boxes in any direction overlap, by floats: for 64-bit processors.
//!
//! Such a processor computes with two floats at a time, and converts two words at a time. So this
//! takes half of the instructions of products in double words.

use super::margins::spread;
use super::two_floats::TwoFloats as Two;
use crate::num::Raw;

/// How far margins are off. Sides are below 2^30 and the way is below 2^31. A product with the way
/// is off by 2^7 and their difference by 2^9, one of two sides by 2^8. The sums round by 2^8, 2^8
/// and 2^9. Together that is less than this.
pub(super) const OFF: f64 = 4096.0;

/// A share of a quotient of a square that three roundings of 2^-53 each cannot make up.
pub(super) const SHORT: f64 = 1.0 - f64::EPSILON * 16.0;

/// Whether vectors with this sum of square lengths are shorter than 2^25. Then products of two are
/// below 2^49, and sums of eight products are below 2^52: floats are exact.
#[inline(always)]
pub(super) fn are_short(sum: f64) -> bool {
    sum < 1_125_899_906_842_624.0
}

/// [`exact_margins`](super::margins::exact_margins), nearly: without the areas, which are of two
/// margins each.
pub(super) struct FloatMargins {
    pub(super) of_a: Two,
    pub(super) of_b: Two,
    pub(super) areas: Two,
}

#[expect(clippy::float_arithmetic, reason = "errors are bounded where the results are compared")]
impl FloatMargins {
    /// From two sides of each box and the way between the middles, or from half of all.
    #[inline(always)]
    pub(super) fn of(sides: [Raw; 5]) -> Self {
        let [u, v, s, t, d] = sides.map(Two::of);
        let (with_s, with_t) = (Two::crosses([u, v], s).size(), Two::crosses([u, v], t).size());
        let areas = Two([u.cross(v), s.cross(t)]);
        let of_a = with_s.add(with_t).sub(Two::crosses([u, v], d).size());
        let Two([us, vs]) = with_s;
        let Two([ut, vt]) = with_t;
        let of_b = Two([us + vs, ut + vt]).sub(Two::crosses([s, t], d).size());
        Self { of_a, of_b, areas }
    }

    #[inline(always)]
    pub(super) fn least(&self) -> f64 {
        Two([self.of_a.least(), self.of_b.least()]).add(self.areas).least()
    }
}

/// Whether two boxes overlap, or touch. None for a box without area, and if the floats are too
/// short. From two sides of each and the way between the middles, or from half of all.
#[inline(always)]
#[expect(clippy::float_arithmetic, reason = "a sign")]
pub(super) fn meet<const CLOSED: bool>(sides: [Raw; 5]) -> Option<bool> {
    let margins = FloatMargins::of(sides);
    let (margin, area) = (margins.least(), margins.areas.least());
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
