//! A ray against a quarter of a circle: exactly whether it meets it, without root or division; then when, from below.

use super::piece::{Time, Touch};
use crate::num::{Axis, Raw, Toi, imul, less128, mul_div, mul64, root128_down, root128_up, sqr64, sub128, usqr};

/// How a ray from `m` (relative to the centre) by `d` meets the closed quarter in the quadrant of `q` from its free side: the entry into the
/// disc where it is `convex`, else the exit from it.
///
/// Tangents do not meet a convex arc. They leave a concave one where they start on it, and where they come along the line on which it ends and go
/// on into its cell.
///
/// Radii are at most 2^24, components below 2^30: squares of cross products, and r^2 |d|^2, are below 2^122.
#[inline(never)]
pub(in crate::world) fn meet(m: Raw, d: Raw, radius: i32, q: Axis, convex: bool) -> Option<Touch> {
    let (m, d) = (turned(m, q), turned(d, q));
    let r = radius as u32;
    let rr = usqr(r);
    let outside = m.len2() >= rr;
    let on_rim = m.len2() == rr;
    let end_square = m.add(d).len2();
    let (b, a) = (m.dot(d).wrapping_neg(), d.len2());
    // The moment of the closest approach is b / a.
    let approaches = b > 0;
    let passes = approaches && b as u64 <= a;
    let happens = if convex {
        outside && approaches && (passes || end_square <= rr)
    } else {
        end_square >= rr && a != 0 && (!outside || on_rim || passes)
    };
    if !happens {
        return None;
    }
    if !convex && on_rim && !approaches {
        return (m.x >= 0 && m.y >= 0).then(|| at(0, 1, inward(m, q)));
    }
    let cross = m.cross(d);
    if !less128(sqr64(cross.unsigned_abs()), mul64(rr, a)) {
        return if convex { None } else { along_the_end(m, d, radius, q) };
    }
    let at_x = sign_at(m.x, d.x, d.y, cross, radius, convex);
    let at_y = sign_at(m.y, d.y, d.x, cross.wrapping_neg(), radius, convex);
    if at_x < 0 || at_y < 0 {
        return None;
    }
    if at_x != 0 && at_y != 0 {
        return Some(Touch { time: None, normal: Axis::new(0, 0) });
    }
    let end = if at_x == 0 { Raw { x: 0, y: radius } } else { Raw { x: radius, y: 0 } };
    Some(at_end(m, d, end, q, convex))
}

/// The contact at an end of the arc, which the ray passes.
fn at_end(m: Raw, d: Raw, end: Raw, q: Axis, convex: bool) -> Touch {
    let way = end.sub(m);
    let (num, den) = if d.x == 0 { (way.y, d.y) } else { (way.x, d.x) };
    let inward = inward(end, q);
    let normal = if convex { inward.reversed() } else { inward };
    at(num.unsigned_abs(), den.unsigned_abs(), normal)
}

/// At a fraction of the motion: both below 2^30.
fn at(num: u32, den: u32, normal: Axis) -> Touch {
    Touch { time: Some(Time { num: u64::from(num), den: u64::from(den) }), normal }
}

/// A ray that touches a concave arc at its end along the cell's side: met where it goes on into the cell.
fn along_the_end(m: Raw, d: Raw, r: i32, q: Axis) -> Option<Touch> {
    let reaches = |v: i32, d: i32| d > 0 && v <= 0 && v.wrapping_add(d) >= 0;
    if m.x == r && d.x == 0 && reaches(m.y, d.y) {
        Some(at_end(m, d, Raw { x: r, y: 0 }, q, false))
    } else if m.y == r && d.y == 0 && reaches(m.x, d.x) {
        Some(at_end(m, d, Raw { x: 0, y: r }, q, false))
    } else {
        None
    }
}

/// A vector in the frame where the arc's quadrant is that of positive coordinates, and back.
fn turned(v: Raw, q: Axis) -> Raw {
    Raw { x: v.x.wrapping_mul(q.x), y: v.y.wrapping_mul(q.y) }
}

/// The direction from a point on the arc toward the centre, of one axis where it is an end.
fn inward(m: Raw, q: Axis) -> Axis {
    let v = turned(m, q);
    if v.x == 0 || v.y == 0 { Axis::new(v.x.signum(), v.y.signum()).reversed() } else { Axis::new(v.x, v.y).reversed() }
}

/// The sign of the coordinate u at the moment T at which the ray crosses the circle, inward for `entry`, else outward.
///
/// `u` runs from `u0` by `p`, the other coordinate by `q`. At the moment s with u = 0 the other one is -cross/p, so against the radius:
/// |cross| ? r |p|, in 64 bits; and the ray approaches the centre then iff cross p q > 0. Outside of the disc at s: T > s while
/// approaching, else T < s. Inside: the entry is before s, the exit after it. On the rim: s is the entry while approaching, else the exit.
fn sign_at(u0: i32, p: i32, q: i32, cross: i64, r: i32, entry: bool) -> i32 {
    if p == 0 {
        return u0.signum();
    }
    let (distance, rim) = (cross.unsigned_abs(), imul(r, p).unsigned_abs());
    let approaching = (cross > 0) == ((p > 0) == (q > 0)) && cross != 0 && q != 0;
    let after = if distance > rim {
        if approaching { 1 } else { -1 }
    } else if distance < rim {
        if entry { -1 } else { 1 }
    } else if approaching == entry {
        0
    } else if entry {
        -1
    } else {
        1
    };
    if p > 0 { after } else { -after }
}

/// When and where a ray meets an arc within it, if [`meet`] says that it does: a lower bound of the time, and the way from the start,
/// rounded so that it ends on the free side.
#[inline(never)]
pub(in crate::world) fn contact(m: Raw, d: Raw, radius: i32, convex: bool) -> (Toi, Raw) {
    let toi = time(m, d, radius as u32, convex);
    (toi, Raw { x: toi.of_raw_beside(m.x, d.x, convex), y: toi.of_raw_beside(m.y, d.y, convex) })
}

/// T = (b -+ root) / a with root = sqrt(r^2 a - cross^2), b = -m.d: of the entry, c / (b + root) with c = |m|^2 - r^2, which has no cancellation; of
/// the exit (b + root) / a, or -c / (root - b) where b < 0 (from inside, moving away from the centre).
///
/// Numerators are rounded down, denominators up, in 31 bits: with the quotient's floor, early by less than 3 parts in 2^30 of the motion. Where all are
/// smaller, the root is off by less than one: of the entry that is c / (b + root)^2, and c <= b^2 / |d|^2, so 1 / |d| of way; of the exit as
/// much. Together less than a raw unit of way for motions up to 4096 units.
fn time(m: Raw, d: Raw, r: u32, convex: bool) -> Toi {
    let (rr, a) = (usqr(r), d.len2());
    let square = sub128(mul64(rr, a), sqr64(m.cross(d).unsigned_abs()));
    let b = m.dot(d).wrapping_neg();
    let (num, den) = if convex || b < 0 {
        (m.len2().abs_diff(rr), b.unsigned_abs().wrapping_add(root128_up(square)))
    } else {
        ((b as u64).wrapping_add(root128_down(square)), a)
    };
    let shift = (64 - den.leading_zeros()).saturating_sub(31);
    // Only a shift drops bits that have to be made up for.
    let den = ((den >> shift) as u32).wrapping_add(u32::from(shift != 0));
    let num = ((num >> shift) as u32).min(den);
    Toi::clamped(mul_div(num, Toi::ONE.raw(), den))
}
