//! A moving circle against a straight face of any direction.

use super::body::Entry;
use super::sweep_box::Face;
use crate::num::{Axis, Raw, Toi, leading_zeros64};
use crate::query::cast::moment::gap_time;
use crate::query::cast::side::{along, is_below, meets_beyond, reach};

/// Entry of the disc of radius `r` around `c` through the face; of a point, such as the corner of a box, where that is 0.
///
/// In units of |dir|: the centre's height over the face's line, `gap`, is an integer, and it is compared with r |dir| by squares. The
/// disc must start entirely in front, end nearer than its radius, and meet the closed face with the point that is nearest to the line.
/// Heights are below 2^61, their squares below 2^122.
///
/// A point passes over the part of the slope on whose side of an end the line of its motion runs: with m from the end to the point, `sign(m x d)`,
/// for any direction of the slope (the time of crossing cancels out). What an end means is as [`sweep_face`](super::sweep_box::sweep_face) has it: the
/// corner of a box enters there where it moves over the face. With the motion into the face, that is into the direction, along x or y, of the next
/// part of the surface on which the box could be too. A box without width or height has none: it may be stopped by an acute corner that it only grazes.
///
/// ```text
///      +----+          |m|, |d| below 2^30 and 2^28, |dir| below 2^30: products below 2^59 and 2^61
///      |box |
///      +----x  corner
///         \  `.
///   a +---..\__>d      dir
///       solid `---..
/// ```
#[inline(never)]
pub(super) fn sweep_slope(c: Raw, r: i32, d: Raw, face: &Face) -> Option<Entry> {
    let Face { a, dir, len, joined } = *face;
    let normal = Axis::new(dir.y, dir.x.wrapping_neg());
    let into = along(normal, d).wrapping_neg();
    if into <= 0 {
        return None;
    }
    let m = c.sub(a);
    let gap = along(normal, m);
    if gap < 0 {
        return None;
    }
    let left = gap.wrapping_sub(into);
    let reach = reach(r, dir);
    if is_below(gap as u64, reach) || (left >= 0 && !is_below(left as u64, reach)) {
        return None;
    }
    let end = Raw { x: m.x.wrapping_sub(dir.x.wrapping_mul(len)), y: m.y.wrapping_sub(dir.y.wrapping_mul(len)) };
    if r != 0 {
        if !meets_beyond(m, d, dir, false, r) || !meets_beyond(end, d, dir, true, r) {
            return None;
        }
        let time = gap_time(gap as u64, into as u64, reach);
        return Some(Entry { num: time.raw(), den: Toi::ONE.raw(), normal, at_end: false, step: None });
    }
    let (over_start, over_end) = (m.cross(d), end.cross(d).wrapping_neg());
    let forth = along(dir, d);
    let meets = |over: i64, moving_over: bool, joined: bool| over > 0 || (over == 0 && (moving_over || joined));
    if !meets(over_start, forth > 0, joined[0]) || !meets(over_end, forth < 0, joined[1]) {
        return None;
    }
    let at_end = (over_start == 0 && !joined[0]) || (over_end == 0 && !joined[1]);
    let (num, den) = fraction(gap as u64, into as u64);
    Some(Entry { num, den, normal, at_end, step: None })
}

/// `num / den` with a divisor that fits an [`Entry`]: exact where it does already, as for all slopes of tiles, else less by one part in 2^29.
fn fraction(num: u64, den: u64) -> (u32, u32) {
    let shift = (64 - leading_zeros64(den)).saturating_sub(30);
    if shift == 0 { (num as u32, den as u32) } else { ((num >> shift) as u32, ((den >> shift) as u32).wrapping_add(1)) }
}
