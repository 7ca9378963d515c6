//! A moving circle against a segment: a capsule that its centre comes into.

use super::boxes::enter_box;
use super::circles::{Disc, meet_disc};
use super::kernel::{Course, Moment};
use super::moment::{gap_time, last_before};
use super::rounded::{Rounded, enter_rounded, grown};
use super::side::{along, is_below, meets_beyond, reach};
use crate::num::{Axis, Raw, Toi, add128, less128, mul64, sqr64, umul};
use crate::query::meet::corners;

/// The part of a capsule that a point meets.
#[derive(Clone, Copy, Debug)]
pub enum Capsule {
    /// A slanted side.
    Slope(Slope),
    /// The disc around an end.
    End(Disc),
    /// Of a segment along x or y.
    Straight(Rounded),
}

/// A line that a point comes near to: its height above it falls from `gap` by `into`, in units of the axis' length, to the root of `reach`.
#[derive(Clone, Copy, Debug)]
pub struct Slope {
    gap: u64,
    into: u64,
    reach: (u64, u64),
    axis: Axis,
}

/// Where the circle of radius `r` around `c` that moves by `d` starts to overlap the segment from `a` to `b`, where it does not overlap already.
///
/// As for a [rounded box](enter_rounded), the capsule lies in a strip, which the motion enters beside the segment itself, or beyond an
/// end. From there, and from a start in the strip, it meets the disc around that end or nothing. A circle of radius zero overlaps no segment.
#[inline]
pub(super) fn enter_capsule(c: Raw, r: i32, a: Raw, b: Raw, d: Raw) -> Option<Capsule> {
    if r == 0 {
        return None;
    }
    let (lo, hi) = corners(a, b);
    if a.x == b.x || a.y == b.y {
        return enter_rounded(c, r, lo, hi, d).map(Capsule::Straight);
    }
    // Most misses do not come into the capsule's bounding box.
    let (far_lo, far_hi) = grown(lo, hi, r);
    if matches!(enter_box(c, c, far_lo, far_hi, d), Course::Free) {
        return None;
    }
    // From the end that has the point on the outer side of its edge, as a face has it.
    let (a, b) = if b.sub(a).cross(c.sub(a)) > 0 { (b, a) } else { (a, b) };
    let (e, m) = (b.sub(a), c.sub(a));
    let (dir, normal) = (Axis::new(e.x, e.y), Axis::new(e.y, e.x.wrapping_neg()));
    let (gap, into, reach) = (along(normal, m) as u64, along(normal, d).wrapping_neg(), reach(r, dir));
    let end = if is_below(gap, reach) {
        // In the strip already, and beyond an end.
        if along(dir, m) < 0 { a } else { b }
    } else {
        let left = (gap as i64).wrapping_sub(into);
        if into <= 0 || (left >= 0 && !is_below(left as u64, reach)) {
            return None;
        }
        if !meets_beyond(m, d, dir, false, r) {
            a
        } else if !meets_beyond(c.sub(b), d, dir, true, r) {
            b
        } else {
            return Some(Capsule::Slope(Slope { gap, into: into as u64, reach, axis: normal }));
        }
    };
    meet_disc(c.sub(end), r, d).map(Capsule::End)
}

impl Slope {
    /// The exact floor.
    ///
    /// At a moment T, in parts of 2^30, the height is g + f / 2^30 with g the whole part of `gap - into T / 2^30`. It is below the
    /// root of the reach where g^2 + 2 g f / 2^30 + f^2 / 2^60 is below the reach: where not already its whole parts tell, what is left of
    /// the reach is at most 2 g, so in parts of 2^60 all sides are below 2^123.
    fn exact_toi(&self) -> Toi {
        last_before(self.bound(), |t| {
            // into * T in parts of 2^30: into below 2^61, split so that the whole part comes out.
            let (high, low) = mul64(self.into, u64::from(t));
            let (whole, part) = ((high << 34) | (low >> 30), (low & ((1 << 30) - 1)) as u32);
            let (g, f) = if part == 0 {
                (self.gap.wrapping_sub(whole), 0)
            } else {
                (self.gap.wrapping_sub(whole).wrapping_sub(1), (1u32 << 30).wrapping_sub(part))
            };
            // Beyond the line itself.
            if g >> 63 != 0 {
                return true;
            }
            let square = sqr64(g);
            if !less128(square, self.reach) {
                return false;
            }
            let left = crate::num::sub128(self.reach, square);
            // (g + 1)^2 does not exceed the reach, and f / 2^30 is less than one.
            if left.0 != 0 || left.1 > g << 1 {
                return true;
            }
            let gained = add128(mul64(g << 1, umul(f, 1 << 30)), (0, umul(f, f)));
            less128(gained, mul64(left.1, 1 << 60))
        })
    }

    fn bound(&self) -> Toi {
        gap_time(self.gap, self.into, self.reach)
    }

    /// Each component rounded to the side that the normal points to: the height only gains.
    fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        let t = self.bound();
        let outward = |out: i32, d: i32| {
            let part = t.of_raw(d);
            let short = umul(d.unsigned_abs(), t.raw()) & u64::from(Toi::ONE.raw() - 1) != 0;
            if short && (out < 0) == (d < 0) { part.wrapping_add(d.signum()) } else { part }
        };
        (t, Raw { x: outward(self.axis.x, d.x), y: outward(self.axis.y, d.y) }, self.axis)
    }
}

impl Moment for Capsule {
    fn toi(&self) -> Toi {
        match self {
            Self::Slope(slope) => slope.bound(),
            Self::End(disc) => disc.toi(),
            Self::Straight(part) => part.toi(),
        }
    }

    fn exact_toi(&self, d: Raw) -> Toi {
        match self {
            Self::Slope(slope) => slope.exact_toi(),
            Self::End(disc) => disc.exact_toi(d),
            Self::Straight(part) => part.exact_toi(d),
        }
    }

    fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        match self {
            Self::Slope(slope) => slope.contact(d),
            Self::End(disc) => disc.contact(d),
            Self::Straight(part) => part.contact(d),
        }
    }
}
