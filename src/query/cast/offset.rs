//! How far from a point a motion passes it, compared with a radius.

use crate::num::{Axis, cmp_squares, umul, usqr};
use core::cmp::Ordering;

/// Compares the distance from a point at the moment when a motion passes it squarely, `|cross|
/// sqrt(len2) / |du|`, with the radius. `len2` is the square of the length of the direction across
/// which the distance is.
///
/// |cross| is below 2^60, `len2` below 2^61: exact in 192 bits.
#[inline]
pub(super) fn offset_to_radius(cross: i64, len2: u64, r: i32, du: i64) -> Ordering {
    cmp_squares((cross.unsigned_abs(), len2), (du.unsigned_abs(), usqr(r.unsigned_abs())))
}

/// As [`offset_to_radius`], but mostly with one product if `|e|` is 1 or the root of 2 or 5. It
/// bounds the length of the offset by two sums of its halves.
pub(crate) fn offset(cross: i64, e: Axis, r: i32, du: i64) -> Ordering {
    let (size, speed) = (cross.unsigned_abs(), du.unsigned_abs());
    if speed >> 32 == 0 && e.x.unsigned_abs().max(e.y.unsigned_abs()) <= 2 {
        let (short, long) = match e.x.wrapping_mul(e.x).wrapping_add(e.y.wrapping_mul(e.y)) {
            1 => (size, size),
            // 45/32 < sqrt(2) < 23/16, and 71/32 < sqrt(5) < 9/4, for sizes below 2^60. The 4 makes
            // up for the bits that the shifts drop.
            2 => (size + (size >> 2) + (size >> 3) + (size >> 5), size + (size >> 1) - (size >> 4) + 4),
            5 => (2 * size + (size >> 3) + (size >> 4) + (size >> 5), 2 * size + (size >> 2) + 4),
            _ => (0, u64::MAX),
        };
        let radius = umul(r.unsigned_abs(), speed as u32);
        if short > radius {
            return Ordering::Greater;
        }
        if long < radius {
            return Ordering::Less;
        }
    }
    offset_to_radius(cross, e.length_squared(), r, du)
}

#[cfg(test)]
mod tests {
    use super::{Axis, offset, offset_to_radius};

    /// Around an offset equal to the radius, by parts of it and by raw units: the bounds agree with
    /// exact squares.
    #[test]
    #[allow(clippy::cast_precision_loss, reason = "only to come near the edge")]
    fn bounds_of_offsets_are_on_both_sides() {
        for (x, y) in [(1, 0), (0, -1), (1, 1), (-1, 1), (2, 1), (1, -2), (-2, -1), (2, 2), (3, 1), (70_001, -13)] {
            let e = Axis::new(x, y);
            let length = (e.length_squared() as f64).sqrt();
            for r in [0, 1, 7, 655_361, (1 << 28) - 1] {
                for du in [1, -3, 65_537, -2_621_443, (1 << 29) + 5, 1 << 31] {
                    let edge = (f64::from(r) * (du as f64).abs() / length) as i64;
                    let near = (-128..=128).flat_map(|k| [edge + edge / 64 * k, edge + edge / 8192 * k, edge + k]);
                    for cross in near {
                        let wanted = offset_to_radius(cross, e.length_squared(), r, du);
                        assert_eq!(offset(cross, e, r, du), wanted, "{cross} {e:?} {r} {du}");
                    }
                }
            }
        }
    }
}
