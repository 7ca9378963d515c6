//! A moving box, segment or circle against a segment. With a circle, its centre enters a capsule.

use super::boxes::{self, Rounded};
use super::kernel::{Course, Moment};
use super::moment::direction;
use super::moment::{Pass, corner_contact, gap_time, is_below, last_before, pass, passes_in_time};
use crate::num::{Axis, LONG, Raw, Toi, add128, less128, mul_div_wide, mul64, sqr64, square_times, umul, usqr};
use crate::query::meet::{Offset, circle_circle, corners, cross_range};
use crate::shape::{Circle, Segment};
use core::cmp::Ordering;

/// A straight side of any direction, met after `gap / speed` of the motion: `gap <= speed`, both
/// below 2^62.
#[derive(Clone, Copy, Debug)]
pub struct EdgeMoment {
    pub(in crate::query) gap: u64,
    pub(in crate::query) speed: u64,
    /// The length whose multiples are gap and speed.
    pub(in crate::query) axis: Axis,
}

/// One strip, as a motion crosses it: the intervals of both shapes on an axis, and the speed along
/// it.
#[derive(Clone, Copy)]
struct Strip {
    /// The distance to the near border, negative inside; and to the far one.
    gap: i64,
    leave: i64,
    /// Not negative.
    speed: i64,
    /// Against the motion.
    axis: Axis,
}

impl Strip {
    fn new(axis: Axis, moving: (i64, i64), resting: (i64, i64), speed: i64) -> Self {
        if speed < 0 {
            let (gap, leave) = (moving.0.wrapping_sub(resting.1), moving.1.wrapping_sub(resting.0));
            Self { gap, leave, speed: speed.wrapping_neg(), axis }
        } else {
            let (gap, leave) = (resting.0.wrapping_sub(moving.1), resting.1.wrapping_sub(moving.0));
            Self { gap, leave, speed, axis: axis.reversed() }
        }
    }

    /// Whether a part of the motion is strictly within. Two intervals of no length have no inside.
    const fn passes(&self) -> bool {
        self.gap < self.speed && self.leave > 0 && self.gap < self.leave
    }

    /// Whether the strip is left after an entry; no product where the motion ends first.
    fn outlasts(&self, entry: &EdgeMoment) -> bool {
        self.leave >= self.speed || less128(mul64(entry.gap, self.speed as u64), mul64(self.leave as u64, entry.speed))
    }
}

/// The latest entry into strips, if it comes before the earliest exit from one of them; inside
/// where none is left to enter.
fn enter<const N: usize>(strips: [Strip; N]) -> Course<EdgeMoment> {
    let mut latest: Option<EdgeMoment> = None;
    for strip in &strips {
        if !strip.passes() {
            return Course::Free;
        }
        if strip.gap >= 0 {
            let entry = EdgeMoment { gap: strip.gap as u64, speed: strip.speed as u64, axis: strip.axis };
            latest = Some(latest.map_or(entry, |other| other.later(entry)));
        }
    }
    let Some(entry) = latest else { return Course::Inside };
    if strips.iter().all(|strip| strip.outlasts(&entry)) { Course::Meets(entry) } else { Course::Free }
}

impl EdgeMoment {
    /// The later of two entries. At one moment, the one that opposes the motion more, then the one
    /// more along x. Then one on a definite side of the motion, the same for exchanged shapes.
    pub(in crate::query) fn later(self, b: Self) -> Self {
        match mul64(self.gap, b.speed).cmp(&mul64(b.gap, self.speed)) {
            Ordering::Less => b,
            Ordering::Greater => self,
            Ordering::Equal => self.more_opposed(b),
        }
    }

    #[inline(never)]
    fn more_opposed(self, b: Self) -> Self {
        let part = |e: &Self, other: &Self| square_times(e.speed, other.axis.length_squared());
        let flat =
            |e: &Self, other: &Self| mul64(u64::from(e.axis.x.unsigned_abs()), u64::from(other.axis.y.unsigned_abs()));
        let order = part(&self, &b).cmp(&part(&b, &self)).then_with(|| flat(&self, &b).cmp(&flat(&b, &self)));
        // Mirrored at the motion: the edge from which a left turn leads to the other.
        let keep = order.then_with(|| self.axis.perp_dot(b.axis).cmp(&0));
        if keep.is_lt() { b } else { self }
    }

    /// `d * gap / speed`, rounded up in size where that leads to the side of `out`, else toward the
    /// start.
    ///
    /// The product with the floored time is the floor or one less, since |d| is below 2^30. The
    /// remainder is below twice the speed, so its low 64 bits are all of it.
    fn part(&self, d: i32, toi: Toi, out: i32) -> i32 {
        let size = d.unsigned_abs();
        let part = (umul(size, toi.raw()) >> 30) as u32;
        let rest = self.gap.wrapping_mul(u64::from(size)).wrapping_sub(self.speed.wrapping_mul(u64::from(part)));
        let (part, rest) =
            if rest >= self.speed { (part.wrapping_add(1), rest.wrapping_sub(self.speed)) } else { (part, rest) };
        let up = rest != 0 && out != 0 && (out < 0) == (d < 0);
        let part = part.wrapping_add(u32::from(up)) as i32;
        if d < 0 { part.wrapping_neg() } else { part }
    }
}

impl Moment for EdgeMoment {
    fn exact_toi(&self, _: Raw) -> Toi {
        Toi::exact(mul_div_wide(self.gap, Toi::ONE.raw(), self.speed))
    }

    /// At a slanted edge each component is rounded to the side that the normal points to. At one
    /// along x or y the distance is exact, because the gap divides by itself.
    fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        let slanted = self.axis.x != 0 && self.axis.y != 0;
        let out = if slanted { self.axis } else { Axis::new(0, 0) };
        let toi = self.exact_toi(d);
        let step = Raw { x: self.part(d.x, toi, out.x), y: self.part(d.y, toi, out.y) };
        (toi, step, direction(Raw { x: self.axis.x, y: self.axis.y }))
    }
}

/// The side of the segment from `a` to `b` that the box `lo..hi` meets when it moves by `d`.
///
/// Strips across x, y and the segment: products of differences below 2^30, so below 2^61, and
/// speeds below 2^60.
#[inline(never)]
pub(super) fn enter_segment(lo: Raw, hi: Raw, a: Raw, b: Raw, d: Raw) -> Course<EdgeMoment> {
    let ((slo, shi), e) = (corners(a, b), b.sub(a));
    let straight = |axis: Axis, lo: i32, hi: i32, slo: i32, shi: i32, d: i32| {
        Strip::new(axis, (i64::from(lo), i64::from(hi)), (i64::from(slo), i64::from(shi)), i64::from(d))
    };
    let x = straight(Axis::X, lo.x, hi.x, slo.x, shi.x, d.x);
    let y = straight(Axis::Y, lo.y, hi.y, slo.y, shi.y, d.y);
    if !x.passes() || !y.passes() {
        return Course::Free;
    }
    if e.x == 0 || e.y == 0 {
        return enter([x, y]);
    }
    let across = Strip::new(normal(e), cross_range(a, e, lo, hi), (0, 0), e.cross(d));
    enter([x, y, across])
}

/// The hit of the segment `a`, which moves by `d`, on the segment `b`: strips across both.
#[inline(never)]
pub(super) fn enter_crossing(a: (Raw, Raw), b: (Raw, Raw), d: Raw) -> Course<EdgeMoment> {
    let (e, f) = (a.1.sub(a.0), b.1.sub(b.0));
    let range = |e: Raw, from: Raw, of: (Raw, Raw)| {
        let (p, q) = (e.cross(of.0.sub(from)), e.cross(of.1.sub(from)));
        if p < q { (p, q) } else { (q, p) }
    };
    enter([
        Strip::new(normal(e), (0, 0), range(e, a.0, b), e.cross(d)),
        Strip::new(normal(f), range(f, b.0, a), (0, 0), f.cross(d)),
    ])
}

/// The direction in which `e x v` grows, in the same unit.
const fn normal(e: Raw) -> Axis {
    Axis::new(e.y.wrapping_neg(), e.x)
}

/// The part of a capsule that a point meets.
#[derive(Clone, Copy, Debug)]
pub enum CapsuleMoment {
    /// A slanted side.
    Slope(Slope),
    /// A side of a segment along x or y, or the disc around an end.
    Rounded(Rounded),
}

/// A line that a point approaches, in units of the axis' length. The height of the point above it
/// falls from `gap` by `into`, to the root of `reach`.
#[derive(Clone, Copy, Debug)]
pub struct Slope {
    gap: u64,
    into: u64,
    reach: (u64, u64),
    axis: Axis,
}

/// The only part of a capsule through which a motion can enter.
pub(super) enum CapsuleGate {
    /// A slanted side, through which it enters.
    Slope(Slope),
    /// A side or end as of a box.
    Rounded(boxes::BoxGate),
}

impl CapsuleGate {
    /// The part of it that a circle meets when it moves by `d`.
    #[inline]
    pub(super) fn enter(self, circle: &Circle, d: Raw) -> Option<CapsuleMoment> {
        match self {
            Self::Slope(slope) => Some(CapsuleMoment::Slope(slope)),
            Self::Rounded(gate) => gate.enter(circle, d).map(CapsuleMoment::Rounded),
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

/// Where a circle that moves by `d` can start to overlap a segment, if it does not overlap it yet.
#[inline]
pub(super) fn gate(circle: &Circle, s: &Segment, d: Raw) -> Course<CapsuleGate> {
    match facing(circle, s, d) {
        FacedSegment::Away => Course::Free,
        FacedSegment::Straight => straight_gate(circle, s, d),
        FacedSegment::Slanted(slanted) => slanted.part(d).map(|part| match part {
            SidePart::Slope { into } => CapsuleGate::Slope(slanted.slope(into)),
            SidePart::End(end) => CapsuleGate::Rounded(boxes::BoxGate::Corner(end)),
        }),
    }
}

/// When and where it does, as [`Moment::contact`].
#[inline]
pub(super) fn contact(circle: &Circle, s: &Segment, d: Raw) -> Course<(Toi, Raw, Axis)> {
    match facing(circle, s, d) {
        FacedSegment::Away => Course::Free,
        FacedSegment::Straight => boxes::straight_contact(circle, s, d),
        FacedSegment::Slanted(slanted) => slanted.part(d).then(|part| match part {
            SidePart::Slope { into } => Some(slanted.slope(into).contact(d)),
            SidePart::End(end) => corner_contact(circle.c().sub(end), circle.r(), d),
        }),
    }
}

/// A segment that a circle meets.
enum FacedSegment {
    /// It overlaps nothing: it has no radius, or does not come near.
    Away,
    /// Along x or y, like a box of no width.
    Straight,
    Slanted(Slanted),
}

#[inline(always)]
fn facing(circle: &Circle, s: &Segment, d: Raw) -> FacedSegment {
    let (a, b) = (s.ra(), s.rb());
    if circle.r() == 0 {
        FacedSegment::Away
    } else if a.x == b.x || a.y == b.y {
        FacedSegment::Straight
    // If products are cheap, the strip rejects as much at a lower cost.
    } else if !LONG && !boxes::comes_near(circle, a, b, d) {
        FacedSegment::Away
    } else {
        FacedSegment::Slanted(Slanted::new(circle, a, b))
    }
}

/// A call on 64-bit processors: it would take the registers of the slanted ones.
#[cfg_attr(target_pointer_width = "64", inline(never))]
#[cfg_attr(not(target_pointer_width = "64"), inline)]
fn straight_gate(circle: &Circle, s: &Segment, d: Raw) -> Course<CapsuleGate> {
    boxes::straight(circle, s, d).map(CapsuleGate::Rounded)
}

/// A slanted segment as the centre of a circle sees it.
///
/// As for a [rounded box](boxes::gate), the capsule lies in the strip around the segment's line. A
/// motion that starts outside enters the strip beside the segment itself, or beyond an end. From
/// there, and from a start in the strip, it meets the disc around that end or nothing.
#[derive(Clone, Copy)]
struct Slanted {
    c: Raw,
    r: i32,
    a: Raw,
    b: Raw,
    e: Offset,
    m: Offset,
    /// The height above the line and the foot on it, in units of the edge's length.
    cross: i64,
    u: i64,
    len2: u64,
    reach: (u64, u64),
}

/// The only part of a slanted capsule through which a motion can enter.
enum SidePart {
    /// The side, through which it enters: this much of the motion leads to the line.
    Slope { into: u64 },
    /// The disc around an end.
    End(Raw),
}

impl Slanted {
    #[inline(always)]
    fn new(circle: &Circle, a: Raw, b: Raw) -> Self {
        let (c, r, e) = (circle.c(), circle.r(), Offset::between(a, b));
        let m = Offset::between(a, c);
        let len2 = e.len2();
        Self { c, r, a, b, e, m, cross: e.cross(m), u: e.dot(m), len2, reach: mul64(usqr(r as u32), len2) }
    }

    /// The outer side of the edge is the circle's.
    #[inline(always)]
    const fn is_left(&self) -> bool {
        self.cross > 0
    }

    #[inline(always)]
    fn part(&self, d: Raw) -> Course<SidePart> {
        let Self { c, r, a, b, e, m, cross, u, len2, reach } = *self;
        let gap = cross.unsigned_abs();
        if is_below(gap, reach) {
            // In the strip: over the segment, or the disc around the nearer end decides.
            let end = if u <= 0 {
                a
            } else if u as u64 >= len2 {
                b
            } else {
                return Course::Inside;
            };
            return if circle_circle::<false>(c, end, r) { Course::Inside } else { Course::Meets(SidePart::End(end)) };
        }
        let (left, d) = (self.is_left(), Offset::of_raw(d));
        let turn = e.cross(d);
        let into = if left { turn.wrapping_neg() } else { turn };
        let rest = (gap as i64).wrapping_sub(into);
        if into <= 0 || (rest >= 0 && !is_below(rest as u64, reach)) {
            return Course::Free;
        }
        let du = e.dot(d);
        // Relative to an end; `turned` if the outer side is then on the right.
        let meets = |u: i64, du: i64, from: Offset, turned: bool| {
            let cross = || {
                let cross = from.cross(d);
                if turned { cross.wrapping_neg() } else { cross }
            };
            match pass(u, du, cross) {
                Pass::Never(beyond) => beyond,
                Pass::At { cross, du } => passes_in_time(cross, du, len2, r),
            }
        };
        Course::Meets(if !meets(u, du, m, left) {
            SidePart::End(a)
        } else if !meets((len2 as i64).wrapping_sub(u), du.wrapping_neg(), m.sub(e), !left) {
            SidePart::End(b)
        } else {
            SidePart::Slope { into: into as u64 }
        })
    }

    #[inline(always)]
    fn slope(&self, into: u64) -> Slope {
        let Raw { x, y } = self.e.raw();
        let axis = Axis::new(y, x.wrapping_neg());
        let axis = if self.is_left() { axis.reversed() } else { axis };
        Slope { gap: self.cross.unsigned_abs(), into, reach: self.reach, axis }
    }
}

impl Slope {
    /// A side whose height falls to the root of `reach`, all below 2^62 (the reach 2^124), between
    /// its ends.
    pub(in crate::query) const fn new(gap: u64, into: u64, reach: (u64, u64), axis: Axis) -> Self {
        Self { gap, into, reach, axis }
    }

    /// The exact floor.
    ///
    /// At a moment T, in parts of 2^30, the height is g + f / 2^30, and g the whole part of
    /// `gap - into T / 2^30`. Its square g^2 + 2 g f / 2^30 + f^2 / 2^60 must be below the reach.
    /// If g does not decide, the rest of the reach is at most 2 g: in parts of 2^60 all is below
    /// 2^123.
    pub(in crate::query) fn exact_toi(&self) -> Toi {
        last_before(self.bound(), |t| {
            // into * T in parts of 2^30: into is below 2^61, and split to leave the whole part.
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
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    pub(in crate::query) fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        let t = self.bound();
        let outward = |out: i32, d: i32| {
            if LONG {
                // To the normal's side is up or down, whatever the sign of the motion.
                let up = if out > 0 { i64::from(Toi::ONE.raw() - 1) } else { 0 };
                return (i64::from(d).wrapping_mul(i64::from(t.raw())).wrapping_add(up) >> 30) as i32;
            }
            let part = t.of_raw(d);
            let short = umul(d.unsigned_abs(), t.raw()) & u64::from(Toi::ONE.raw() - 1) != 0;
            if short && (out < 0) == (d < 0) { part.wrapping_add(d.signum()) } else { part }
        };
        (t, Raw { x: outward(self.axis.x, d.x), y: outward(self.axis.y, d.y) }, self.axis)
    }
}

impl Moment for CapsuleMoment {
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
