//! A moving circle against a straight face of any direction.

use super::body::Entry;
use super::moment::gap_time;
use crate::num::{Axis, Raw, Toi, imul, less128, mul64, mul128, sqr64, usqr};
use core::cmp::Ordering;

/// Entry of the disc of radius `r` around `c` through the face from `a` along `dir`, `len` times.
///
/// In units of |dir|: the centre's height over the face's line, `gap`, is an integer, and it is compared with r |dir| by squares. The
/// disc must start entirely in front, end nearer than its radius, and meet the closed face with the point that is nearest to the line.
/// Heights are below 2^61, their squares below 2^122.
#[inline(never)]
pub(super) fn sweep_disc_slope(c: Raw, r: i32, d: Raw, a: Raw, dir: Axis, len: i32) -> Option<Entry> {
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
    if !meets_beyond(m, d, dir, false, r) || !meets_beyond(end, d, dir, true, r) {
        return None;
    }
    let time = gap_time(gap as u64, into as u64, reach);
    Some(Entry { num: time.raw(), den: Toi::ONE.raw(), normal, at_end: false, step: None })
}

/// `dir . v`; for the slopes of tiles, whose components are at most 2, with two products of words: |v| is below 2^30.
fn along(dir: Axis, v: Raw) -> i64 {
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
fn reach(r: i32, dir: Axis) -> (u64, u64) {
    let rr = usqr(r.unsigned_abs());
    match dir.length_squared() {
        2 => (0, rr << 1),
        5 => (0, (rr << 2).wrapping_add(rr)),
        nn => mul64(rr, nn),
    }
}

/// Whether the square of a height is less than `reach`.
fn is_below(height: u64, reach: (u64, u64)) -> bool {
    if height >> 32 == 0 {
        return reach.0 != 0 || usqr(height as u32) < reach.1;
    }
    less128(sqr64(height), reach)
}

/// Whether, at the moment T when the disc meets the face's line, the centre is not before an end: `u = dir . m(T) >= 0` for the start
/// with `m` the centre as seen from it, the same with -dir for the face's end (`at_end`).
///
/// At the moment s with u = 0 the height is |dir|^2 (m x d) / du, and it falls: T is later than s where that is more than r |dir|.
fn meets_beyond(m: Raw, d: Raw, dir: Axis, at_end: bool, r: i32) -> bool {
    let dir = if at_end { dir.reversed() } else { dir };
    let (u, du) = (along(dir, m), along(dir, d));
    let beyond = u.wrapping_add(du);
    if u >= 0 && beyond >= 0 {
        return true;
    }
    if u < 0 && beyond < 0 {
        return false;
    }
    let cross = if at_end { m.cross(d).wrapping_neg() } else { m.cross(d) };
    if du > 0 {
        // s <= T
        cross >= 0 && offset_to_radius(cross, dir, r, du).is_ge()
    } else {
        // T <= s
        cross >= 0 || offset_to_radius(cross, dir, r, du).is_le()
    }
}

/// Compares the distance from a point at the moment when a motion passes it squarely, `|cross| |dir| / |du|`, with the radius.
///
/// |cross| is below 2^60, the square of |dir| below 2^61: exact in 192 bits.
#[inline(never)]
pub(super) fn offset_to_radius(cross: i64, dir: Axis, r: i32, du: i64) -> Ordering {
    let offset = mul128(sqr64(cross.unsigned_abs()), dir.length_squared());
    offset.cmp(&mul128(sqr64(du.unsigned_abs()), usqr(r.unsigned_abs())))
}
