//! The flat side of a grown segment, or of a slope: when a disc comes to its line, and whether it meets it between its ends.

use crate::num::{Axis, Raw, cmp_squares, imul, less128, mul64, sqr64, usqr};
use core::cmp::Ordering;

/// `dir . v`; for the slopes of tiles, whose components are at most 2, with two products of words: |v| is below 2^30.
pub(crate) fn along(dir: Axis, v: Raw) -> i64 {
    if is_small(dir) {
        i64::from(dir.x.wrapping_mul(v.x)).wrapping_add(i64::from(dir.y.wrapping_mul(v.y)))
    } else {
        imul(dir.x, v.x).wrapping_add(imul(dir.y, v.y))
    }
}

const fn is_small(dir: Axis) -> bool {
    dir.x.wrapping_add(2) as u32 <= 4 && dir.y.wrapping_add(2) as u32 <= 4
}

/// The square of r |dir|.
pub(crate) fn reach(r: i32, dir: Axis) -> (u64, u64) {
    let rr = usqr(r.unsigned_abs());
    match dir.length_squared() {
        2 => (0, rr << 1),
        5 => (0, usqr(r.unsigned_abs() << 1).wrapping_add(rr)),
        nn => mul64(rr, nn),
    }
}

/// Whether the square of a height is less than `reach`.
pub(crate) fn is_below(height: u64, reach: (u64, u64)) -> bool {
    if height >> 32 == 0 {
        return reach.0 != 0 || usqr(height as u32) < reach.1;
    }
    less128(sqr64(height), reach)
}

/// Whether, at the moment T when the disc meets the face's line, the centre is not before an end: `u = dir . m(T) >= 0` for the start
/// with `m` the centre as seen from it, the same with -dir for the face's end (`at_end`).
#[inline]
pub(crate) fn meets_beyond(m: Raw, d: Raw, dir: Axis, at_end: bool, r: i32) -> bool {
    match pass(m, d, dir, at_end) {
        Pass::Never(beyond) => beyond,
        Pass::At { cross, du } => {
            let order = offset_to_radius(cross, dir, r, du);
            // s <= T on the way to the face, else T <= s.
            if du > 0 { order.is_ge() } else { order.is_le() }
        }
    }
}

/// When a motion passes an end of a face squarely.
enum Pass {
    /// Whether it is beyond at T, whatever the radius.
    Never(bool),
    /// At the moment s with u = 0 the height is |dir|^2 cross / du, and it falls: T is later than s where that is more than r |dir|.
    At { cross: i64, du: i64 },
}

/// Where the multiplications are calls, one of its own, whose stack is free again when squares are compared.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
fn pass(m: Raw, d: Raw, dir: Axis, at_end: bool) -> Pass {
    let dir = if at_end { dir.reversed() } else { dir };
    let (u, du) = (along(dir, m), along(dir, d));
    let beyond = u.wrapping_add(du);
    if u >= 0 && beyond >= 0 {
        return Pass::Never(true);
    }
    if u < 0 && beyond < 0 {
        return Pass::Never(false);
    }
    let cross = if at_end { m.cross(d).wrapping_neg() } else { m.cross(d) };
    // Below the line at s: T is before that.
    if (du > 0) == (cross < 0) { Pass::Never(du <= 0) } else { Pass::At { cross, du } }
}

/// Compares the distance from a point at the moment when a motion passes it squarely, `|cross| |dir| / |du|`, with the radius.
///
/// |cross| is below 2^60, the square of |dir| below 2^61: exact in 192 bits.
pub(crate) fn offset_to_radius(cross: i64, dir: Axis, r: i32, du: i64) -> Ordering {
    cmp_squares((cross.unsigned_abs(), dir.length_squared()), (du.unsigned_abs(), usqr(r.unsigned_abs())))
}

#[cfg(test)]
mod tests {
    use super::is_below;

    #[test]
    fn heights_are_below_a_root_that_is_larger() {
        for height in [1u64, 5, 25 << 20, 1 << 31, u64::from(u32::MAX), 1 << 32, 3 << 32, (1 << 61) - 1] {
            let square = u128::from(height).pow(2);
            for (reach, below) in
                [(square - 1, false), (square, false), (square + 1, true), (1, false), (1 << 123, true)]
            {
                assert_eq!(is_below(height, ((reach >> 64) as u64, reach as u64)), below, "{height} {reach}");
            }
        }
        assert!(is_below(0, (0, 1)) && !is_below(0, (0, 0)));
    }
}
