//! A moving box, or a circle, against a box: with a circle its corners are round.

use super::kernel::{Course, Moment};
use super::moment::{Disc, corner_contact, enters, meet_disc};
use crate::num::{Axis, Raw, Toi, fraction, imul, umul};
use crate::query::Overlaps;
use crate::query::meet::corners;
use crate::shape::{Aabb, Circle, Segment};

/// A straight side along x or y, met after `gap / speed` of the motion: `gap <= speed`, below 2^30.
#[derive(Clone, Copy, Debug)]
pub struct SideMoment {
    pub(super) gap: u32,
    pub(super) speed: u32,
    /// A unit axis, against the motion.
    pub(super) axis: Axis,
}

/// One component of a motion toward an interval.
#[derive(Clone, Copy)]
pub(crate) struct Span {
    /// The distance to the interval's near end, negative inside, and to its far end. The first is
    /// never the larger one.
    pub(crate) gap: i32,
    pub(crate) leave: i32,
    /// Not negative.
    pub(crate) speed: i32,
}

impl Span {
    /// From differences inside the domain and a motion between two points in it: all below 2^30.
    pub(crate) const fn new(alo: i32, ahi: i32, blo: i32, bhi: i32, d: i32) -> Self {
        if d < 0 {
            Self { gap: alo.wrapping_sub(bhi), leave: ahi.wrapping_sub(blo), speed: d.wrapping_neg() }
        } else {
            Self { gap: blo.wrapping_sub(ahi), leave: bhi.wrapping_sub(alo), speed: d }
        }
    }

    /// Whether a part of the motion is strictly between the ends. If both intervals have no length,
    /// nothing is between them.
    const fn passes(self) -> bool {
        self.gap < self.speed && self.leave > 0 && self.gap < self.leave
    }

    /// Whether this span is left after the other one is entered:
    /// `leave / speed > other.gap / other.speed`.
    ///
    /// Gaps and speeds below 2^30 give products below 2^60. No product where the motion ends first.
    const fn outlasts(self, other: Self) -> bool {
        self.leave >= self.speed
            || umul(self.leave as u32, other.speed as u32) > umul(other.gap as u32, self.speed as u32)
    }
}

/// The side of the box `blo..bhi` that the box `alo..ahi` meets when it moves by `d`.
///
/// Boxes overlap before the motion if they are within both spans. No motion leaves a span from
/// there without a part of it inside.
#[inline(always)]
pub(super) fn enter_box(alo: Raw, ahi: Raw, blo: Raw, bhi: Raw, d: Raw) -> Course<SideMoment> {
    let (x, y) = (Span::new(alo.x, ahi.x, blo.x, bhi.x, d.x), Span::new(alo.y, ahi.y, blo.y, bhi.y, d.y));
    if !x.passes() || !y.passes() {
        Course::Free
    } else if x.gap < 0 && y.gap < 0 {
        Course::Inside
    } else {
        Course::of(later(x, y, d))
    }
}

/// The side through which the box `alo..ahi` that moves by `d` starts to overlap the box
/// `blo..bhi`, if it does not overlap already.
#[inline]
pub(super) fn meet_box(alo: Raw, ahi: Raw, blo: Raw, bhi: Raw, d: Raw) -> Option<SideMoment> {
    let (x, y) = (Span::new(alo.x, ahi.x, blo.x, bhi.x, d.x), Span::new(alo.y, ahi.y, blo.y, bhi.y, d.y));
    if x.passes() && y.passes() { later(x, y, d) } else { None }
}

/// The side of the span that is entered later. At least one of the two is not entered yet.
///
/// The motion is strictly within both spans at one time if the later entry comes before the earlier
/// exit. If two entries are at the same moment, corner to corner, it is the one that opposes the
/// motion more, x on a tie.
#[inline(always)]
fn later(x: Span, y: Span, d: Raw) -> Option<SideMoment> {
    let x_later = if x.gap < 0 {
        false
    } else if y.gap < 0 {
        true
    } else {
        let (by_x, by_y) = (umul(x.gap as u32, y.speed as u32), umul(y.gap as u32, x.speed as u32));
        by_x > by_y || (by_x == by_y && x.speed >= y.speed)
    };
    let (first, other, axis) = if x_later {
        (x, y, Axis::new(if d.x < 0 { 1 } else { -1 }, 0))
    } else {
        (y, x, Axis::new(0, if d.y < 0 { 1 } else { -1 }))
    };
    other.outlasts(first).then_some(SideMoment { gap: first.gap as u32, speed: first.speed as u32, axis })
}

impl Moment for SideMoment {
    #[inline]
    fn exact_toi(&self, _: Raw) -> Toi {
        Toi::exact(if self.gap == 0 { 0 } else { fraction(self.gap, self.speed) })
    }

    /// Exact on the side's axis, and rounded toward the start on the other one. The box ends on the
    /// side's line, so it does not overlap.
    #[inline]
    fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        let toi = self.exact_toi(d);
        let gap = self.gap as i32;
        let step = if self.axis.x != 0 {
            Raw { x: with_sign(gap, d.x), y: self.part(d.y, toi) }
        } else {
            Raw { x: self.part(d.x, toi), y: with_sign(gap, d.y) }
        };
        (toi, step, self.axis)
    }
}

impl SideMoment {
    /// `d * gap / speed`, rounded toward zero.
    ///
    /// The product with the floored time is that or one less, since |d| is below 2^30: the
    /// remainder, below twice the speed, decides.
    const fn part(&self, d: i32, toi: Toi) -> i32 {
        let size = d.unsigned_abs();
        let part = (umul(size, toi.raw()) >> 30) as u32;
        let rest = size.wrapping_mul(self.gap).wrapping_sub(part.wrapping_mul(self.speed));
        with_sign(part.wrapping_add((rest >= self.speed) as u32) as i32, d)
    }
}

/// A magnitude with the sign of `of`.
const fn with_sign(size: i32, of: i32) -> i32 {
    if of < 0 { size.wrapping_neg() } else { size }
}

/// The part of a rounded box that a point meets.
#[derive(Clone, Copy, Debug)]
pub enum Rounded {
    /// A straight side, the box's own moved out by the radius.
    Side(SideMoment),
    /// The disc around a corner.
    Corner(Disc),
}

/// The only part of a rounded box through which a motion can enter.
#[derive(Clone, Copy)]
pub(super) enum BoxGate {
    /// A side, through which it enters.
    Side(SideMoment),
    /// The disc around a corner.
    Corner(Raw),
}

impl BoxGate {
    /// The part of it that a circle meets when it moves by `d`.
    #[inline]
    pub(super) fn enter(self, circle: &Circle, d: Raw) -> Option<Rounded> {
        match self {
            Self::Side(side) => Some(Rounded::Side(side)),
            Self::Corner(corner) => meet_disc(circle.c().sub(corner), circle.r(), d).map(Rounded::Corner),
        }
    }

    /// When and where it meets that, as [`Moment::contact`].
    #[inline]
    pub(super) fn contact(self, circle: &Circle, d: Raw) -> Option<(Toi, Raw, Axis)> {
        match self {
            Self::Side(side) => Some(side.contact(d)),
            Self::Corner(corner) => corner_contact(circle.c().sub(corner), circle.r(), d),
        }
    }

    /// Whether it meets any.
    #[inline]
    pub(super) fn hits(self, circle: &Circle, d: Raw) -> bool {
        match self {
            Self::Side(_) => true,
            Self::Corner(corner) => enters(circle.c().sub(corner), circle.r(), d),
        }
    }
}

/// Where a circle that moves by `d` can start to overlap a box that it does not overlap yet. A
/// separate call: its stack is free again before the test of a disc.
#[inline(never)]
pub(super) fn gate(circle: &Circle, b: &Aabb, d: Raw) -> Option<BoxGate> {
    gate_here(circle, b, d)
}

/// [`gate`] without a call.
///
/// The rounded box lies in the box grown by r. If a motion enters that beside a side of the box
/// itself, it has met the rounded box. Else it is in the square of radius r beside one corner, and
/// leaves it through the corner's disc, or leaves the grown box. So one disc is enough. The same
/// holds for a start in the grown box.
///
/// ```text
///       .-------------.        ,  the square of a corner
///     ,   +---------+  `
///     |   |   box   |   |
///     '   +---------+  ,
///       `-------------'
/// ```
#[inline(always)]
pub(super) fn gate_here(circle: &Circle, b: &Aabb, d: Raw) -> Option<BoxGate> {
    let (c, r, lo, hi) = (circle.c(), circle.r(), b.lo(), b.hi());
    let (far_lo, far_hi) = grown(lo, hi, r);
    let within = c.x > far_lo.x && c.x < far_hi.x && c.y > far_lo.y && c.y < far_hi.y;
    let corner = if within {
        Raw { x: if c.x < lo.x { lo.x } else { hi.x }, y: if c.y < lo.y { lo.y } else { hi.y } }
    } else {
        let side = meet_box(c, c, far_lo, far_hi, d)?;
        // A circle of no radius has no corners to meet: its grown box is the box, and that is open.
        let beyond = if r == 0 { 0 } else { side.beyond(c, lo, hi, d) };
        if beyond == 0 {
            return Some(BoxGate::Side(side));
        }
        side.corner(lo, hi, beyond)
    };
    Some(BoxGate::Corner(corner))
}

/// When and where a circle meets a segment along x or y: a box of no width.
#[cfg_attr(target_pointer_width = "64", inline(never))]
#[cfg_attr(not(target_pointer_width = "64"), inline)]
pub(super) fn straight_contact(circle: &Circle, s: &Segment, d: Raw) -> Course<(Toi, Raw, Axis)> {
    straight(circle, s, d).then(|gate| gate.contact(circle, d))
}

/// Where a circle can meet a segment along x or y.
#[inline(always)]
pub(super) fn straight(circle: &Circle, s: &Segment, d: Raw) -> Course<BoxGate> {
    if circle.overlaps(s) {
        return Course::Inside;
    }
    let (lo, hi) = corners(s.ra(), s.rb());
    Course::of(gate(circle, &Aabb::from_raw_unchecked(lo, hi), d))
}

/// Whether the motion enters the capsule's bounding box, or starts in it. Most misses do neither.
#[inline(never)]
pub(super) fn comes_near(circle: &Circle, a: Raw, b: Raw, d: Raw) -> bool {
    let (lo, hi) = corners(a, b);
    let (c, (far_lo, far_hi)) = (circle.c(), grown(lo, hi, circle.r()));
    !matches!(enter_box(c, c, far_lo, far_hi, d), Course::Free)
}

/// A box with its sides moved out, by a length below 2^29.
const fn grown(lo: Raw, hi: Raw, by: i32) -> (Raw, Raw) {
    let by = Raw { x: by, y: by };
    (lo.sub(by), hi.add(by))
}

impl SideMoment {
    /// On which side of the box the point `c` is, along this side, when it meets it: -1, 0 (ends
    /// included), 1.
    ///
    /// Offsets and speeds below 2^30: sums of two products below 2^61.
    fn beyond(&self, c: Raw, lo: Raw, hi: Raw, d: Raw) -> i32 {
        let (c, lo, hi, d) = if self.axis.x != 0 { (c.y, lo.y, hi.y, d.y) } else { (c.x, lo.x, hi.x, d.x) };
        let way = imul(d, self.gap as i32);
        let at = |end: i32| imul(c.wrapping_sub(end), self.speed as i32).wrapping_add(way);
        if at(lo) < 0 { -1 } else { i32::from(at(hi) > 0) }
    }

    /// The corner of the box at an end of this side.
    fn corner(&self, lo: Raw, hi: Raw, end: i32) -> Raw {
        let along = |lo: i32, hi: i32, sign: i32| if sign < 0 { lo } else { hi };
        if self.axis.x != 0 {
            Raw { x: along(lo.x, hi.x, self.axis.x), y: along(lo.y, hi.y, end) }
        } else {
            Raw { x: along(lo.x, hi.x, end), y: along(lo.y, hi.y, self.axis.y) }
        }
    }
}

impl Moment for Rounded {
    fn exact_toi(&self, d: Raw) -> Toi {
        match self {
            Self::Side(side) => side.exact_toi(d),
            Self::Corner(disc) => disc.exact_toi(d),
        }
    }

    fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        match self {
            Self::Side(side) => side.contact(d),
            Self::Corner(disc) => disc.contact(d),
        }
    }
}
