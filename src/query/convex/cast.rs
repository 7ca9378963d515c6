//! When a moving shape starts to overlap another one.
//!
//! Relative to B, the motion of A moves the origin against the sum. Without radii it enters where
//! it is last before one of the sides, if it has not left another one by then. With radii it enters
//! through a side moved out by them, between its ends, or else through the disc around a corner.

use super::across::over;
use super::short_place::place_of;
use super::walk::{Core, PolygonSide, SideWalk};
use crate::num::{Axis, Raw, Toi, less128, mul64, umul};
use crate::query::cast::kernel::{Course, Moment};
use crate::query::cast::moment::{Disc, is_below, meet_disc, meets_beyond, reach};
use crate::query::cast::segments::{EdgeMoment, Slope};

/// The part of the sum through which a motion enters.
#[derive(Clone, Copy, Debug)]
pub enum ConvexGate {
    /// A straight side at a rational moment.
    Edge(EdgeMoment),
    /// A slanted side, moved out by the radii.
    Slope(Slope),
    /// The arc around a corner.
    Disc(Disc),
}

impl Moment for ConvexGate {
    fn exact_toi(&self, d: Raw) -> Toi {
        match self {
            Self::Edge(edge) => edge.exact_toi(d),
            Self::Slope(slope) => slope.exact_toi(),
            Self::Disc(disc) => disc.exact_toi(d),
        }
    }

    fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        match self {
            Self::Edge(edge) => edge.contact(d),
            Self::Slope(slope) => slope.contact(d),
            Self::Disc(disc) => disc.contact(d),
        }
    }
}

/// The hit of A on B when it moves by `d`, below 2^29 per component.
pub(super) fn enter(a: Core<'_>, b: Core<'_>, d: Raw) -> Course<ConvexGate> {
    let radius = a.radius.wrapping_add(b.radius);
    if radius == 0 {
        sharp(a, b, d).map(ConvexGate::Edge)
    } else if place_of(a, b).within::<false>(radius) {
        Course::Inside
    } else {
        rounded(a, b, radius, d).map_or(Course::Free, Course::Meets)
    }
}

/// The direction out of B across a side of the sum, and how fast the origin enters by it: below
/// 2^61.
pub(super) const fn inward(side: &PolygonSide, d: Raw) -> (Axis, i64) {
    (Axis::new(side.edge.y.wrapping_neg(), side.edge.x), d.cross(side.edge))
}

fn sharp(a: Core<'_>, b: Core<'_>, d: Raw) -> Course<EdgeMoment> {
    let (mut entry, mut exit): (Option<EdgeMoment>, Option<(u64, u64)>) = (None, None);
    let mut has_area = false;
    for side in SideWalk::new(a, b) {
        has_area = true;
        let height = side.height();
        let (axis, speed) = inward(&side, d);
        if speed > 0 && height <= 0 {
            let gap = height.unsigned_abs();
            if gap >= speed as u64 {
                return Course::Free;
            }
            let edge = EdgeMoment { gap, speed: speed as u64, axis };
            entry = Some(entry.map_or(edge, |other| other.later(edge)));
        } else if height <= 0 {
            return Course::Free;
        } else if speed < 0 {
            let left = (height as u64, speed.unsigned_abs());
            // The earlier one: both products are below 2^123.
            if exit.is_none_or(|kept| less128(mul64(left.0, kept.1), mul64(kept.0, left.1))) {
                exit = Some(left);
            }
        }
    }
    match (entry, exit) {
        (None, _) => {
            if has_area {
                Course::Inside
            } else {
                Course::Free
            }
        }
        (Some(entry), Some((gap, speed))) if !less128(mul64(entry.gap, speed), mul64(gap, entry.speed)) => Course::Free,
        (Some(entry), _) => Course::Meets(entry),
    }
}

/// For shapes that do not overlap.
fn rounded(a: Core<'_>, b: Core<'_>, radius: i32, d: Raw) -> Option<ConvexGate> {
    let walk = SideWalk::new(a, b);
    let mut first: Option<(Toi, Disc)> = None;
    let mut around = |m: Raw| {
        if let Some(disc) = meet_disc(m, radius, d) {
            let toi = disc.contact(d).0;
            if first.is_none_or(|kept| is_earlier((toi, disc), kept, d)) {
                first = Some((toi, disc));
            }
        }
    };
    around(walk.corner().at);
    for side in walk {
        if let Some(gate) = through(&side, radius, d) {
            return Some(gate);
        }
        around(side.from);
    }
    first.map(|(_, disc)| ConvexGate::Disc(disc))
}

/// The earlier of two discs, each with a lower bound of its moment that is early by less than four
/// raw units of way. Exact if these do not decide. At one moment it is the one with the lower
/// bound, then as [`Disc::order`]: none of it depends on which shape is A.
pub(super) fn is_earlier((s, a): (Toi, Disc), (t, b): (Toi, Disc), d: Raw) -> bool {
    let way = d.x.unsigned_abs().max(d.y.unsigned_abs());
    if umul(s.raw().abs_diff(t.raw()), way) >> 32 == 0 {
        let key = |at: Toi, disc: Disc| (disc.exact_toi(d), at, disc.order());
        key(s, a) < key(t, b)
    } else {
        s < t
    }
}

/// The side moved out by the radii, where the origin comes through it between its ends.
fn through(side: &PolygonSide, radius: i32, d: Raw) -> Option<ConvexGate> {
    let height = side.height();
    let (axis, speed) = inward(side, d);
    if height > 0 || speed <= 0 {
        return None;
    }
    let (gap, into, reach) = (height.unsigned_abs(), speed as u64, reach(radius, axis));
    // Already beside the shape, or not near it at the end.
    if is_below(gap, reach) || (gap >= into && !is_below(gap.wrapping_sub(into), reach)) {
        return None;
    }
    // Relative to the side's ends, in B's sense of direction.
    let dir = Axis::new(side.edge.x.wrapping_neg(), side.edge.y.wrapping_neg());
    if !meets_beyond(side.from, d, dir, false, radius) || !meets_beyond(side.from.add(side.edge), d, dir, true, radius)
    {
        return None;
    }
    if axis.x != 0 && axis.y != 0 {
        return Some(ConvexGate::Slope(Slope::new(gap, into, reach, axis)));
    }
    Some(straight(side, radius, d))
}

/// A side along x or y, where the root is whole: the gap in raw units less the radii, which is not
/// negative.
pub(super) fn straight(side: &PolygonSide, radius: i32, d: Raw) -> ConvexGate {
    let (out, overlap) = over(side.edge, side.from);
    let gap = overlap.wrapping_neg().wrapping_sub(i64::from(radius)) as u64;
    let speed = if out.x == 0 { d.y } else { d.x };
    ConvexGate::Edge(EdgeMoment { gap, speed: u64::from(speed.unsigned_abs()), axis: out.reversed() })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test")]
mod tests {
    use super::{is_earlier, meet_disc};
    use crate::num::Raw;
    use crate::query::cast::kernel::Moment;
    use tilesat_judge::{Random, cases, enough};

    /// Two discs that a motion enters within a few raw units of travel, and others. The bounds of
    /// their moments are often in the wrong order, but the answer never is.
    #[test]
    fn of_two_discs_the_earlier_one() {
        let mut r = Random::new(61);
        let (mut near, mut wrong, mut equal) = (0u64, 0u64, 0u64);
        for k in 0..cases(40_000) {
            let size = 1 << r.within(4, 27);
            let radius = 1 + r.magnitude(size / 4) as i32;
            let raw = |p: (i64, i64)| Raw { x: p.0 as i32, y: p.1 as i32 };
            let d = (r.around(size), r.around(size));
            // Through the disc, by a part of the way.
            let (back, aside) = (r.within(1, 1 << 10), i64::from(radius));
            let m = (r.around(aside) - ((d.0 * back) >> 10), r.around(aside) - ((d.1 * back) >> 10));
            let apart = if k % 8 == 0 { size } else { r.within(0, 3) };
            let n = (m.0 + r.around(apart), m.1 + r.around(apart));
            let (m, n, d) = (raw(m), raw(n), raw(d));
            // Outside of both before.
            let outside = |m: Raw| m.len2() >= (i64::from(radius) * i64::from(radius)) as u64;
            let (Some(a), Some(b)) = (meet_disc(m, radius, d), meet_disc(n, radius, d)) else { continue };
            if !outside(m) || !outside(n) {
                continue;
            }
            let (s, t) = (a.contact(d).0, b.contact(d).0);
            let exact = a.exact_toi(d).cmp(&b.exact_toi(d));
            let first = is_earlier((s, a), (t, b), d);
            assert_eq!(first, exact.then((s, a.order()).cmp(&(t, b.order()))).is_lt(), "{m:?} {n:?} {radius} by {d:?}");
            assert!(!first || exact.is_le());
            near += 1;
            wrong += u64::from(s.cmp(&t) != exact);
            equal += u64::from(exact.is_eq());
        }
        assert!(enough(near > cases(40_000) / 40 && wrong > 0 && equal > 10), "{near} {wrong} {equal}");
    }
}
