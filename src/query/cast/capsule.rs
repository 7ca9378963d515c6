//! A moving circle against a segment: a capsule that its centre comes into.

use super::boxes::enter_box;
use super::kernel::{Course, Moment};
use super::moment::{gap_time, last_before};
use super::rounded::{self, Rounded, grown};
use super::side::{along, is_below, meets_beyond, reach};
use crate::num::{Axis, Raw, Toi, add128, less128, mul64, sqr64, umul};
use crate::query::meet::corners;
use crate::shape::{Aabb, Circle, Segment};

/// The part of a capsule that a point meets.
#[derive(Clone, Copy, Debug)]
pub enum Capsule {
    /// A slanted side.
    Slope(Slope),
    /// A side of a segment along x or y, or the disc around an end.
    Rounded(Rounded),
}

/// A line that a point comes near to: its height above it falls from `gap` by `into`, in units of the axis' length, to the root of `reach`.
#[derive(Clone, Copy, Debug)]
pub struct Slope {
    gap: u64,
    into: u64,
    reach: (u64, u64),
    axis: Axis,
}

/// The only part of a capsule that a motion can come in through.
pub(super) enum Gate {
    /// A slanted side, which it does come through.
    Slope(Slope),
    /// A side or end as of a box.
    Rounded(rounded::Gate),
}

impl Gate {
    /// What a circle that moves by `d` meets of it.
    #[inline]
    pub(super) fn enter(self, circle: &Circle, d: Raw) -> Option<Capsule> {
        match self {
            Self::Slope(slope) => Some(Capsule::Slope(slope)),
            Self::Rounded(gate) => gate.enter(circle, d).map(Capsule::Rounded),
        }
    }

    /// Whether it meets any.
    #[inline]
    pub(super) fn hits(self, circle: &Circle, d: Raw) -> bool {
        match self {
            Self::Slope(_) => true,
            Self::Rounded(gate) => gate.hits(circle, d),
        }
    }
}

/// Where a circle that moves by `d` can start to overlap a segment, where it does not overlap already.
///
/// A circle of radius zero overlaps no segment.
#[inline]
pub(super) fn gate(circle: &Circle, s: &Segment, d: Raw) -> Option<Gate> {
    if circle.r() == 0 {
        return None;
    }
    let (a, b) = (s.ra(), s.rb());
    let (lo, hi) = corners(a, b);
    if a.x == b.x || a.y == b.y {
        return rounded::gate(circle, &Aabb::from_raw_unchecked(lo, hi), d).map(Gate::Rounded);
    }
    if !comes_near(circle, lo, hi, d) {
        return None;
    }
    // From the end that has the point on the outer side of its edge, as a face has it.
    let edge = if b.sub(a).cross(circle.c().sub(a)) > 0 { (b, a) } else { (a, b) };
    let slope = enter_strip(circle, edge, d)?;
    let end = |end: Raw| Some(Gate::Rounded(rounded::Gate::Corner(end)));
    let (c, dir) = (circle.c(), slope.axis.perp());
    if slope.into == 0 {
        // It starts beyond an end, since it does not overlap the segment.
        end(if along(dir, c.sub(edge.0)) < 0 { edge.0 } else { edge.1 })
    } else if !meets_beyond(c.sub(edge.0), d, dir, false, circle.r()) {
        end(edge.0)
    } else if !meets_beyond(c.sub(edge.1), d, dir, true, circle.r()) {
        end(edge.1)
    } else {
        Some(Gate::Slope(slope))
    }
}

/// Whether the motion comes into the capsule's bounding box, which most misses do not.
#[inline(never)]
fn comes_near(circle: &Circle, lo: Raw, hi: Raw, d: Raw) -> bool {
    let (c, (far_lo, far_hi)) = (circle.c(), grown(lo, hi, circle.r()));
    !matches!(enter_box(c, c, far_lo, far_hi, d), Course::Free)
}

/// How a motion enters the strip around the line of a slanted segment, whose outer side is the circle's, if it does; by no speed where it starts there.
///
/// As for a [rounded box](rounded::gate), the capsule lies in that strip, which the motion enters beside the segment itself, or beyond an
/// end. From there, and from a start in the strip, it meets the disc around that end or nothing.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
fn enter_strip(circle: &Circle, (a, b): (Raw, Raw), d: Raw) -> Option<Slope> {
    let e = b.sub(a);
    let axis = Axis::new(e.y, e.x.wrapping_neg());
    let (gap, into, reach) =
        (along(axis, circle.c().sub(a)) as u64, along(axis, d).wrapping_neg(), reach(circle.r(), axis));
    if is_below(gap, reach) {
        return Some(Slope { gap, into: 0, reach, axis });
    }
    let left = (gap as i64).wrapping_sub(into);
    if into <= 0 || (left >= 0 && !is_below(left as u64, reach)) {
        return None;
    }
    Some(Slope { gap, into: into as u64, reach, axis })
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
    fn exact_toi(&self, d: Raw) -> Toi {
        match self {
            Self::Slope(slope) => slope.exact_toi(),
            Self::Rounded(part) => part.exact_toi(d),
        }
    }

    fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        match self {
            Self::Slope(slope) => slope.contact(d),
            Self::Rounded(part) => part.contact(d),
        }
    }
}
