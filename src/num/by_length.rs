//! A quotient by the length of an axis, and the direction of the axis.

use super::direction::unit_nearest;
use super::inverse_root::{div_sqrt, div_sqrt_closely, near_quotient};
use super::{Axis, LONG, UnitVec2, umul};

/// [`div_sqrt`] by the length of an axis, and the axis' unit vector. For an axis that is not along
/// x or y, and has an opposite.
///
/// On chips both come from one reciprocal root. A component shifted by `half` is below 2^32,
/// because it is at most the length. [`Axis::unit`] shifts it by as much or by one less, and rounds
/// off as many bits less.
#[inline]
pub(crate) fn div_length(s: u64, axis: Axis) -> (u32, UnitVec2) {
    let n = axis.length_squared();
    if LONG {
        return (div_sqrt(s, n), unit_nearest(axis));
    }
    let (q, is_sure, inverse) = near_quotient(s, n);
    let nearest = |c: i32| {
        let size = (umul(c.unsigned_abs() << (inverse.half & 31), inverse.y as u32) >> 32) as u32;
        let size = (size.wrapping_add(1) >> 1) as i32;
        if c < 0 { size.wrapping_neg() } else { size }
    };
    (if is_sure { q } else { div_sqrt_closely(q, s, n) }, UnitVec2::from_raw(nearest(axis.x), nearest(axis.y)))
}
