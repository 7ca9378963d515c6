//! What the reciprocal of an axis' length gives: its unit vector, and quotients by the length.

use super::direction::unit_nearest;
use super::inverse_root::{InverseRoot, div_sqrt, div_sqrt_closely, near_quotient};
use super::{Axis, LONG, UnitVec2, umul};

/// [`unit_nearest`] by the reciprocal of the axis' length; for components below 2^30, neither of
/// them zero.
///
/// Its `normalise` shifts the components, squares them, and rounds off 32 or 33 bits of the
/// products. Here they are shifted by one more in the first case, less one in both, and 32 bits are
/// rounded off. A component is at most the length: the products are at most 2^62 and a rounding
/// error. For a product below zero, halves are rounded the other way. Only for 2^30, its `rsqrt` is
/// one less than this reciprocal: by a quarter of the last place.
///
/// On chips in words: a component shifted by `half` is below 2^32, because it is at most the
/// length.
#[inline(always)]
pub(crate) const fn unit_by(axis: Axis, inverse: InverseRoot) -> UnitVec2 {
    if !LONG {
        return UnitVec2::from_raw(nearest_in_words(axis.x, inverse), nearest_in_words(axis.y, inverse));
    }
    let factor = (inverse.y as i64) << (inverse.half.wrapping_sub(1) & 63);
    UnitVec2::from_raw(nearest_by(axis.x as i64, factor), nearest_by(axis.y as i64, factor))
}

#[inline(always)]
const fn nearest_by(component: i64, factor: i64) -> i32 {
    (component.wrapping_mul(factor).wrapping_add((1 << 31) + (component >> 63)) >> 32) as i32
}

#[inline(always)]
const fn nearest_in_words(component: i32, inverse: InverseRoot) -> i32 {
    let twice = (umul(component.unsigned_abs() << (inverse.half & 31), inverse.y as u32) >> 32) as u32;
    let size = (twice.wrapping_add(1) >> 1) as i32;
    if component < 0 { size.wrapping_neg() } else { size }
}

/// [`div_sqrt`] by the length of an axis, and the axis' unit vector. For an axis that is not along
/// x or y, and has an opposite.
///
/// On chips both come from one reciprocal root.
#[inline]
pub(crate) fn div_length(s: u64, axis: Axis) -> (u32, UnitVec2) {
    let n = axis.length_squared();
    if LONG {
        return (div_sqrt(s, n), unit_nearest(axis));
    }
    let (q, is_sure, inverse) = near_quotient(s, n);
    (if is_sure { q } else { div_sqrt_closely(q, s, n) }, unit_by(axis, inverse))
}
