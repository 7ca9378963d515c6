//! Moving boxes and segments against segments: a convex polygon that a point comes into, as the strips between its parallel sides.

use super::crossing::direction;
use super::kernel::{Course, Moment};
use crate::num::{Axis, Raw, Toi, less128, mul_div_wide, mul64, square_times, umul};
use crate::query::meet::{corners, cross_range};
use core::cmp::Ordering;

/// A straight side of any direction, met after `gap / speed` of the motion: `gap <= speed`, both below 2^62.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    pub(super) gap: u64,
    pub(super) speed: u64,
    /// Of the length that gap and speed are multiples of.
    pub(super) axis: Axis,
}

/// One strip, as a motion comes through it: where the moving and the resting shape are on an axis, and how fast the first one moves along it.
#[derive(Clone, Copy)]
struct Strip {
    /// How far it is to the near border, negative within; and to the far one.
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

    /// Whether a part of the motion is strictly within. Intervals of no length, both of them, have no between.
    const fn passes(&self) -> bool {
        self.gap < self.speed && self.leave > 0 && self.gap < self.leave
    }

    /// Whether the strip is left after an entry; no product where the motion ends first.
    fn outlasts(&self, entry: &Edge) -> bool {
        self.leave >= self.speed || less128(mul64(entry.gap, self.speed as u64), mul64(self.leave as u64, entry.speed))
    }
}

/// The latest entry into strips, if it comes before the earliest exit from one of them; inside where none is left to enter.
fn enter<const N: usize>(strips: [Strip; N]) -> Course<Edge> {
    let mut latest: Option<Edge> = None;
    for strip in &strips {
        if !strip.passes() {
            return Course::Free;
        }
        if strip.gap >= 0 {
            let entry = Edge { gap: strip.gap as u64, speed: strip.speed as u64, axis: strip.axis };
            latest = Some(latest.map_or(entry, |other| other.later(entry)));
        }
    }
    let Some(entry) = latest else { return Course::Inside };
    if strips.iter().all(|strip| strip.outlasts(&entry)) { Course::Meets(entry) } else { Course::Free }
}

impl Edge {
    /// Of two entries the later one; at one moment the one that opposes the motion more, then the one more along x, then the one that is
    /// on a definite side of the motion, which exchanging the shapes does not change.
    fn later(self, b: Self) -> Self {
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
        // Mirrored at the motion: the one from which a left turn leads to the other.
        let keep = order.then_with(|| self.axis.perp_dot(b.axis).cmp(&0));
        if keep.is_lt() { b } else { self }
    }

    /// `d * gap / speed`, rounded up in size where that leads to the side of `out`, else toward the start.
    ///
    /// The product with the floored time is the floor or one less, since |d| is below 2^30. The remainder is below twice the speed, so its
    /// low 64 bits are all of it.
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

impl Moment for Edge {
    fn exact_toi(&self, _: Raw) -> Toi {
        Toi::exact(mul_div_wide(self.gap, Toi::ONE.raw(), self.speed))
    }

    /// On the far side of the line of a slanted edge each component is rounded to the side that the normal points to; of one along
    /// x or y the distance is exact, because the gap divides by itself.
    fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        let slanted = self.axis.x != 0 && self.axis.y != 0;
        let out = if slanted { self.axis } else { Axis::new(0, 0) };
        let toi = self.exact_toi(d);
        let step = Raw { x: self.part(d.x, toi, out.x), y: self.part(d.y, toi, out.y) };
        (toi, step, direction(Raw { x: self.axis.x, y: self.axis.y }))
    }
}

/// What the box `lo..hi` that moves by `d` meets of the segment from `a` to `b`.
///
/// Strips across x, y and the segment: products of differences below 2^30, so below 2^61, and speeds below 2^60.
#[inline(never)]
pub(super) fn enter_segment(lo: Raw, hi: Raw, a: Raw, b: Raw, d: Raw) -> Course<Edge> {
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

/// What the segment `a` that moves by `d` meets of the segment `b`: strips across both.
#[inline(never)]
pub(super) fn enter_crossing(a: (Raw, Raw), b: (Raw, Raw), d: Raw) -> Course<Edge> {
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
