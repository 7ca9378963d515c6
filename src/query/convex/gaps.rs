//! How far two shapes are apart, by floats: for 64-bit processors.
//!
//! If two shapes do not overlap, an end or a corner of one and a side of the other are nearest. So
//! the distance is the least one of a few points and segments. For short vectors all products are
//! exact, and only a square of them or a quotient rounds.

use super::float_margins::are_short;
use super::two_floats::TwoFloats as Two;
use crate::num::{Raw, add128, less128, mul64, sqr64, usqr};
use crate::shape::Convex;

/// Two points, each before a segment.
#[derive(Clone, Copy)]
struct TwoGaps {
    /// How far the points are from the lines, and their feet beyond the ends: times the lengths.
    height: Two,
    beyond: Two,
    len2: Two,
}

impl TwoGaps {
    /// The squares of the distances, nearly: four roundings of 2^-53.
    #[inline(always)]
    fn squares(&self) -> Two {
        self.height.times(self.height).add(self.beyond.times(self.beyond)).over(self.len2)
    }

    /// Whether one of the points is nearer than a radius, which floats decide for others.
    #[inline(always)]
    #[expect(clippy::float_arithmetic, reason = "where the rounding could matter, integers decide")]
    fn is_within(&self, radius: u32) -> bool {
        let Two(squares) = self.squares();
        let limit = f64::from(radius) * f64::from(radius) * (1.0 + f64::EPSILON * 16.0);
        let ([h, i], [b, c], [l, m]) = (self.height.0, self.beyond.0, self.len2.0);
        (squares[0] <= limit && is_below(h, b, l, radius)) || (squares[1] <= limit && is_below(i, c, m, radius))
    }
}

/// Whether a hypotenuse is below a radius times a root. Exact: both sides are below 2^53, and the
/// square of the root is below 2^50.
#[inline(never)]
fn is_below(height: f64, beyond: f64, len2: f64, radius: u32) -> bool {
    let square = |x: f64| sqr64(x as i64 as u64);
    less128(add128(square(height.abs()), square(beyond)), mul64(usqr(radius), len2 as i64 as u64))
}

/// Points and segments of two shapes. Some two of them are nearest to each other.
pub(super) struct Gaps<const N: usize> {
    gaps: [TwoGaps; N],
    /// Whether the shapes have a point in common.
    meet: bool,
}

#[expect(clippy::float_arithmetic, reason = "where the rounding could matter, integers decide")]
impl<const N: usize> Gaps<N> {
    #[inline(always)]
    fn least_square(&self) -> f64 {
        let squares = self.gaps.map(|gap| gap.squares());
        squares.into_iter().reduce(Two::less).map_or(0.0, Two::least)
    }

    #[inline(always)]
    fn is_within(&self, radius: u32) -> bool {
        self.gaps.iter().any(|gap| gap.is_within(radius))
    }

    /// The distance, rounded down.
    #[inline(always)]
    pub(super) fn distance(&self) -> u32 {
        // Distances are below 2^25, and roots are off by less than 2^-42 of that.
        const NEARLY: f64 = 1.0 / (1 << 14) as f64;
        let root = root(self.least_square());
        let near = (root + 0.5) as i32;
        let off = root - f64::from(near);
        let is_below = if off.abs() > NEARLY { off < 0.0 } else { self.is_within(near as u32) };
        // No branch: whether they meet is hard to predict.
        (near as u32).wrapping_sub(u32::from(is_below)) & u32::from(self.meet).wrapping_sub(1)
    }
}

/// The root of a positive number.
#[cfg(all(feature = "libm", target_arch = "x86_64", not(tilesat_split)))]
#[inline(always)]
fn root(x: f64) -> f64 {
    libm::sqrt(x)
}

/// The root of a positive number, nearly: as in [`isqrt64`](crate::num::isqrt64), within 2^-44.
#[cfg(not(all(feature = "libm", target_arch = "x86_64", not(tilesat_split))))]
#[expect(clippy::float_arithmetic, reason = "where the rounding could matter, integers decide")]
#[inline(always)]
fn root(x: f64) -> f64 {
    let mut root = f64::from_bits((x.to_bits() >> 1).wrapping_add(0x1ff7_a3be_a91d_9b1b));
    root = 0.5 * (root + x / root);
    root = 0.5 * (root + x / root);
    0.5 * (root + x / root)
}

/// A box in any direction and a circle's middle.
struct BoxGaps {
    gaps: Gaps<1>,
    area: f64,
    /// The square of the way between the middles.
    way2: f64,
}

#[expect(clippy::float_arithmetic, reason = "exact for short vectors, and else bounded")]
impl BoxGaps {
    #[inline(always)]
    fn of(of: [Raw; 3], point: Raw) -> Self {
        let [u, v, middle] = of;
        let (u, v, d) = (Two::of(u), Two::of(v), Two::of(point.sub(middle)));
        let (across, along) = (Two::crosses([u, v], d), Two::dots([u, v], d));
        let (area, both, len2) = (u.cross(v), u.dot(v), Two([u.dot(u), v.dot(v)]));
        // The nearer ones of each two sides. That along `u` is on the side of `v` if the point is
        // on the left of `u`, and that along `v` on the side of `u` if it is on the right.
        let feet = along.sub(Two([both, -both]).signed_by(across));
        let height = across.size().sub(Two::both(area));
        let gaps = [TwoGaps { height, beyond: feet.size().sub(len2).positive(), len2 }];
        Self { gaps: Gaps { gaps, meet: height.most() <= 0.0 }, area, way2: d.dot(d) }
    }

    #[inline(always)]
    fn between(a: &impl Convex, b: &impl Convex) -> Option<Self> {
        if let (Some(of), Some(point)) = (a.half_sides(), b.point()) {
            Some(Self::of(of, point))
        } else if let (Some(point), Some(of)) = (a.point(), b.half_sides()) {
            Some(Self::of(of, point))
        } else {
            None
        }
    }

    /// Whether the point is nearer than a radius. `None` without a radius, if the point is nearly
    /// as far, and for a box without area.
    ///
    /// Half sides are below 2^29 and the way is below 2^31. A product of two vectors is off by less
    /// than 2^-51 of the product of their lengths. So heights and feet, over the length of the
    /// side, are off by far less than a 16th of a raw unit.
    #[inline(always)]
    fn meet(&self, radius: i32) -> Option<bool> {
        let [TwoGaps { height, beyond, len2 }] = self.gaps.gaps;
        let squares = height.times(height).add(beyond.times(beyond));
        let above = |radius: f64| squares.sub(len2.times(Two::both(radius * radius))).least();
        let near = self.gaps.meet | (above(f64::from(radius) - 1.0 / 16.0) < 0.0);
        let far = above(f64::from(radius) + 1.0 / 16.0) > 0.0;
        (len2.least() > 0.0 && radius > 0 && (near | far)).then_some(near)
    }
}

/// Two segments that are no points.
#[inline(always)]
#[expect(clippy::float_arithmetic, reason = "exact for short vectors")]
fn of_segments([p, q]: [Raw; 2], [s, t]: [Raw; 2]) -> Option<Gaps<2>> {
    let (e, f, way) = (Two::of(q.sub(p)), Two::of(t.sub(s)), Two::of(s.sub(p)));
    let (turn, both, len2) = (e.cross(f), e.dot(f), Two([e.dot(e), f.dot(f)]));
    // The first ends: that of B over A, and that of A over B.
    let (across, along) = (Two::crosses([e, f], way), Two::dots([e, f], way));
    let first = (Two([across.0[0], -across.0[1]]), Two([along.0[0], -along.0[1]]));
    let last = (first.0.add(Two([turn, -turn])), first.1.add(Two::both(both)));
    let half = len2.times(Two::both(0.5));
    let gap = |(height, foot): (Two, Two)| TwoGaps { height, beyond: foot.sub(half).size().sub(half).positive(), len2 };
    let sides = first.0.times(last.0);
    let meet = sides.most() < 0.0;
    let is_short = are_short(len2.0[0] + len2.0[1] + way.dot(way));
    (len2.least() > 0.0 && is_short).then_some(Gaps { gaps: [gap(first), gap(last)], meet })
}

/// A circle and a box in any direction. None for other shapes, and for long vectors.
#[inline(always)]
#[expect(clippy::float_arithmetic, reason = "nearly")]
pub(super) fn of_box_point(a: &impl Convex, b: &impl Convex) -> Option<Gaps<1>> {
    let BoxGaps { gaps, area, way2 } = BoxGaps::between(a, b)?;
    let Two([p, q]) = gaps.gaps[0].len2;
    (area > 0.0 && are_short(p + q + way2)).then_some(gaps)
}

/// Whether a circle and a box in any direction overlap. None for other shapes, and where the
/// rounding could matter.
#[inline(always)]
pub(super) fn box_point_meet(a: &impl Convex, b: &impl Convex) -> Option<bool> {
    BoxGaps::between(a, b)?.meet(a.rounding().wrapping_add(b.rounding()))
}

/// Two capsules or segments with a length.
#[inline(always)]
pub(super) fn of_capsules(a: &impl Convex, b: &impl Convex) -> Option<Gaps<2>> {
    if a.point().is_some() || b.point().is_some() {
        return None;
    }
    of_segments(a.ends()?, b.ends()?)
}

/// The gaps between two sides of a box and the corners of another box that are nearest to their
/// lines. The second number is zero if a side of one box is parallel to a side of the other.
///
/// `sides` are of the first box, and the next two of the other. `way` leads from the middle of the
/// first box to that of the other.
#[inline(always)]
#[expect(clippy::float_arithmetic, reason = "exact for short vectors")]
fn before(sides: [Two; 2], [s, t]: [Two; 2], way: Two) -> (TwoGaps, f64) {
    let [u, v] = sides;
    let (across, along) = (Two::crosses(sides, way), Two::dots(sides, way));
    let (with_s, with_t) = (Two::crosses(sides, s), Two::crosses(sides, t));
    let (area, both, len2) = (u.cross(v), u.dot(v), Two([u.dot(u), v.dot(v)]));
    // Of each two corners, the one on the way back.
    let corner = |e: Two, with_e: Two| Two::dots(sides, e).signed_by(with_e).signed_by(across);
    let feet = along.sub(corner(s, with_s)).sub(corner(t, with_t)).sub(Two([both, -both]).signed_by(across));
    let height = across.size().sub(with_s.size()).sub(with_t.size()).sub(Two::both(area));
    let parallel = with_s.size().less(with_t.size()).least();
    (TwoGaps { height, beyond: feet.size().sub(len2).positive(), len2 }, parallel)
}

/// Two boxes that do not touch, without parallel sides. From two sides of each and the way between
/// the middles, or from half of all.
#[inline(always)]
#[expect(clippy::float_arithmetic, reason = "exact for short vectors")]
pub(super) fn of_boxes(sides: [Raw; 5]) -> Option<Gaps<2>> {
    let [u, v, s, t, way] = sides.map(Two::of);
    let ((of_a, parallel), (of_b, _)) = (before([u, v], [s, t], way), before([s, t], [u, v], way.reversed()));
    let sum = of_a.len2.add(of_b.len2);
    let is_short = are_short(sum.0[0] + sum.0[1] + way.dot(way));
    (parallel > 0.0 && is_short).then_some(Gaps { gaps: [of_a, of_b], meet: false })
}
