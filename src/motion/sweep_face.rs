//! Sweeps a box or a circle against straight faces: along x and y, and in any direction.

use super::body::Entry;
use crate::num::{Axis, Raw, Toi, leading_zeros64};
use crate::query::cast::moment::gap_time;
use crate::query::cast::side::{along, is_below, meets_beyond, reach};

/// A [`Geometry::Face`](crate::world::Geometry::Face).
pub(super) struct Face {
    pub(super) a: Raw,
    pub(super) dir: Axis,
    pub(super) len: i32,
    pub(super) joined: [bool; 2],
}

/// Entry of the box `lo..hi`, grown by `r` all around, that moves by `d` through a face along x or
/// y. None if the motion would not start to overlap beyond it.
///
/// With gap g >= 0 and speed s > 0 into the face, the entry time is g/s. The motion overlaps beyond
/// the face only if it continues after touching (g < s). At that moment the box must span a part of
/// the face strictly, or touch the face's end while moving over it. A box without width may also
/// touch an end beyond which the solid continues. (A box with width then spans a part of what
/// continues.) For a disc, the point nearest to the line must meet the closed face; for a capsule,
/// one of these points.
#[inline(never)]
pub(super) fn sweep_face((lo, hi): (Raw, Raw), r: i32, d: Raw, face: &Face) -> Option<Entry> {
    let Face { a, dir, len, joined } = *face;
    // (across the face, along it)
    let split = |v: Raw| if dir.x == 0 { (v.x, v.y) } else { (v.y, v.x) };
    let outward = dir.y.wrapping_sub(dir.x);
    let (speed, along) = split(d);
    let into = if outward < 0 { speed } else { speed.wrapping_neg() };
    if into <= 0 {
        return None;
    }
    let ((lo_n, lo_t), (hi_n, hi_t), (at, start)) = (split(lo), split(hi), split(a));
    let gap = if outward < 0 { at.wrapping_sub(hi_n) } else { lo_n.wrapping_sub(at) }.wrapping_sub(r);
    if gap < 0 || gap >= into {
        return None;
    }
    let (first, last) = (lo_t.wrapping_sub(start), hi_t.wrapping_sub(start));
    let (first, last, along) = if dir.x.wrapping_add(dir.y) > 0 {
        (first, last, along)
    } else {
        (last.wrapping_neg(), first.wrapping_neg(), along.wrapping_neg())
    };
    let over_start = over(last, along, gap, into);
    let over_end = over(len.wrapping_sub(first), along.wrapping_neg(), gap, into);
    let (thin, round) = (lo_t == hi_t, r != 0);
    let meets = |over: i32, moving_over: bool, joined: bool| {
        over > 0 || (over == 0 && (moving_over || round || (thin && joined)))
    };
    let spans = meets(over_start, along > 0, joined[0]) && meets(over_end, along < 0, joined[1]);
    let at_end = !round && ((over_start == 0 && !joined[0]) || (over_end == 0 && !joined[1]));
    let normal = crate::world::normal(dir);
    spans.then_some(Entry { num: gap as u32, den: into as u32, normal, at_end, step: None })
}

/// A number with the sign of `reach + along * gap / into`, for `0 <= gap < into`: how far a body is
/// over a face's end when it meets the face's line.
///
/// If the sign is the same at both ends of the motion, that is the answer, without a product.
/// Otherwise differences are below 2^31 and speeds below 2^30, so the products are below 2^61.
pub(super) fn over(reach: i32, along: i32, gap: i32, into: i32) -> i32 {
    let end = reach.wrapping_add(along);
    if gap == 0 || ((reach ^ end) >= 0 && (reach == 0) == (end == 0)) {
        return reach;
    }
    Raw { x: reach, y: along }.dot(Raw { x: into, y: gap }).signum() as i32
}

/// Entry of the disc of radius `r` around `c` through the face. Radius 0 is a point, such as the
/// corner of a box.
///
/// In units of |dir|, the centre's height over the face's line, `gap`, is an integer. It is
/// compared with r |dir| by squares. The disc must start entirely in front, end nearer than its
/// radius, and meet the closed face with its point nearest to the line. Heights are below 2^61,
/// their squares below 2^122.
///
/// A point passes over the part of the slope on the side of an end where the line of its motion
/// runs. With m from the end to the point, that side is `sign(m x d)`, for any direction of the
/// slope: the time of crossing cancels out. An end counts as in [`sweep_face`]. The corner of a box
/// enters there if it moves over the face. The motion into the face then leads along x or y into
/// the next part of the surface that the box could be on, too. A box without width or height has no
/// such part: an acute corner that it only grazes may stop it.
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
    let normal = crate::world::normal(dir);
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

/// `num / den` with a divisor that fits an [`Entry`]. Exact if it already fits, as for all slopes
/// of tiles; otherwise less by one part in 2^29.
pub(super) fn fraction(num: u64, den: u64) -> (u32, u32) {
    let shift = (64 - leading_zeros64(den)).saturating_sub(30);
    if shift == 0 { (num as u32, den as u32) } else { ((num >> shift) as u32, ((den >> shift) as u32).wrapping_add(1)) }
}
