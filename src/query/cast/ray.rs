//! Rays against single shapes: the closed counterpart of casts.

use super::boxes::SideMoment;
use super::kernel::{CastHit, Inside};
use super::kernel::{InDomain, Moment, RayTarget};
use super::moment::{Crossing, direction};
use super::segments::EdgeMoment;
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, DOMAIN, Raw, Toi, Vec2, imul, mul_div};
use crate::query::meet;
use crate::shape::{Aabb, Circle, Segment};

impl Aabb {
    /// The first point of the closed box that a ray from `origin` along `motion` meets, or `None`
    /// if it ends before.
    ///
    /// Exact, by the rules of [`TileMap::cast_ray`](crate::TileMap::cast_ray). A ray that moves
    /// against the normal of a side hits it, ends and the very end of the motion included. Touching
    /// a corner is a hit, on the side across x. A start on the border is not inside: a ray that
    /// moves in hits at 0. Leaving, passing a corner and sliding along are not hits. A ray that
    /// starts on a box without width or height, and leaves its line, hits it, too.
    ///
    /// [`CastHit::displacement`] is the vector from `origin` to the point: exact along the axis,
    /// rounded toward the start along the side.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Inside, Vec2};
    /// let wall = Aabb::new(Vec2::from_ints(16, 0), Vec2::from_ints(32, 16))?;
    /// let from = Vec2::from_ints(0, 4);
    /// let hit = wall.cast_ray(from, Vec2::from_ints(64, 8), Inside::Ignore)?.unwrap();
    /// assert_eq!((from + hit.displacement, hit.axis), (Vec2::from_ints(16, 6), Axis::NEG_X));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
    #[doc(alias("raycast", "linecast"))]
    pub fn cast_ray(&self, origin: Vec2, motion: Vec2, inside: Inside) -> Result<Option<CastHit>, RangeError> {
        let (o, d) = checked(origin, motion)?;
        let (lo, hi) = (self.lo(), self.hi());
        if meet::circle_aabb::<false>(o, 0, lo, hi) {
            return Ok(at_start(motion, inside));
        }
        Ok(meet_side(o, d, lo, hi).map(|side| reached(&side, d)))
    }
}

impl Circle {
    /// The first point of the disc that a ray from `origin` along `motion` meets, or `None` if
    /// it ends before.
    ///
    /// Exact, by the rules of [`TileMap::cast_ray`](crate::TileMap::cast_ray). A hit is the point
    /// at which the ray enters the disc, even at the very end of the motion. A tangent is not a
    /// hit. A ray that starts on the rim and moves in hits at 0. A circle of radius zero is a
    /// point, which a ray through it hits.
    ///
    /// The time is a lower bound. It is early by less than a raw unit of travel for motions up to
    /// 4096 units, and by less than four for any. The point is outside the circle, less than 2 raw
    /// from it.
    ///
    /// ```
    /// use tilesat::{Axis, Circle, Fx, Inside, Vec2};
    /// let ball = Circle::new(Vec2::from_ints(8, 0), Fx::from_num(4))?;
    /// let ray = |y| ball.cast_ray(Vec2::from_ints(0, y), Vec2::from_ints(16, 0), Inside::Ignore);
    /// assert_eq!(ray(0)?.unwrap().axis, Axis::NEG_X);
    /// assert_eq!(ray(4)?, None); // a tangent
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
    #[doc(alias("raycast", "linecast"))]
    pub fn cast_ray(&self, origin: Vec2, motion: Vec2, inside: Inside) -> Result<Option<CastHit>, RangeError> {
        let (o, d) = checked(origin, motion)?;
        let (m, r) = (o.sub(self.c()), self.r());
        if meet::circle_circle::<false>(o, self.c(), r) {
            return Ok(at_start(motion, inside));
        }
        if r == 0 {
            return Ok(meet_point(m, d));
        }
        Ok(Crossing::touching(m, r, d).map(|crossing| {
            let (toi, step, axis) = crossing.contact(m, d);
            CastHit { toi, axis, displacement: step.vec2(), inside: false }
        }))
    }
}

impl Segment {
    /// The first point of the segment that a ray from `origin` along `motion` meets, or `None`
    /// if it ends before.
    ///
    /// Exact and closed: ends and the very end of the motion count. The axis is that of the side
    /// from which the ray comes. A ray along the segment's line hits its end, with the axis along
    /// the segment. A segment has no inside: a ray that starts on it hits at 0, unless the ray runs
    /// along it.
    ///
    /// The point is rounded to the side from which the ray comes, each coordinate by less than one
    /// raw unit. It is exact along a segment's axis that is parallel to x or y. Cost: two or three
    /// long divisions, none for segments along x and y.
    ///
    /// ```
    /// use tilesat::{Segment, Vec2};
    /// let slope = Segment::new(Vec2::from_ints(0, 8), Vec2::from_ints(16, 0))?;
    /// let hit = slope.cast_ray(Vec2::from_ints(8, -8), Vec2::from_ints(0, 24))?.unwrap();
    /// assert_eq!((hit.displacement, hit.axis.x < 0 && hit.axis.y < 0), (Vec2::from_ints(0, 12), true));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
    #[doc(alias("raycast", "linecast"))]
    pub fn cast_ray(&self, origin: Vec2, motion: Vec2) -> Result<Option<CastHit>, RangeError> {
        let (o, d) = checked(origin, motion)?;
        Ok(meet_segment(o, d, self.ra(), self.rb()))
    }
}

impl RayTarget for Aabb {
    fn ray_hit(&self, origin: Vec2, motion: Vec2, inside: Inside) -> Result<Option<CastHit>, RangeError> {
        self.cast_ray(origin, motion, inside)
    }

    fn ray_toi(&self, _: Vec2, _: Raw) -> Option<Toi> {
        None
    }
}

impl RayTarget for Circle {
    fn ray_hit(&self, origin: Vec2, motion: Vec2, inside: Inside) -> Result<Option<CastHit>, RangeError> {
        self.cast_ray(origin, motion, inside)
    }

    fn ray_toi(&self, origin: Vec2, d: Raw) -> Option<Toi> {
        let m = Raw::of(origin).sub(self.c());
        if self.r() == 0 { None } else { Crossing::touching(m, self.r(), d).map(|crossing| crossing.exact_toi(m, d)) }
    }
}

/// The start and the motion of a ray, if both ends are in the domain. A sum that wraps is outside,
/// too: it is at least 2^30 from zero.
pub(in crate::query) fn checked(origin: Vec2, motion: Vec2) -> Result<(Raw, Raw), RangeError> {
    origin.check()?;
    let (o, d) = (Raw::of(origin), Raw::of(motion));
    let end = o.add(d);
    for (what, value) in [(Quantity::EndX, end.x), (Quantity::EndY, end.y)] {
        if value <= -DOMAIN || value >= DOMAIN {
            return Err(RangeError { what, value });
        }
    }
    Ok((o, d))
}

pub(in crate::query) fn at_start(motion: Vec2, inside: Inside) -> Option<CastHit> {
    matches!(inside, Inside::Hit).then(|| CastHit::at_start(motion))
}

pub(in crate::query) fn reached(moment: &impl Moment, d: Raw) -> CastHit {
    let (toi, step, axis) = moment.contact(d);
    CastHit { toi, axis, displacement: step.vec2(), inside: false }
}

/// The side of a closed box that a ray meets. At a corner it meets two, and the one across x wins.
fn meet_side(o: Raw, d: Raw, lo: Raw, hi: Raw) -> Option<SideMoment> {
    let (x, y) = (Line { o: o.x, d: d.x, lo: lo.x, hi: hi.x }, Line { o: o.y, d: d.y, lo: lo.y, hi: hi.y });
    x.met(&y, Axis::new(1, 0)).or_else(|| y.met(&x, Axis::new(0, 1)))
}

/// One component of a ray and of a box.
struct Line {
    o: i32,
    d: i32,
    lo: i32,
    hi: i32,
}

impl Line {
    /// The side across this component, if the ray meets it between its ends.
    fn met(&self, across: &Self, axis: Axis) -> Option<SideMoment> {
        let (gap, speed) = if self.d < 0 {
            (self.o.wrapping_sub(self.hi), self.d.wrapping_neg())
        } else {
            (self.lo.wrapping_sub(self.o), self.d)
        };
        if speed == 0 || gap < 0 || gap > speed {
            return None;
        }
        let meets = if gap == 0 {
            self.lo == self.hi && across.holds(0, 1) || across.goes_in()
        } else {
            across.holds(gap, speed)
        };
        let axis = if self.d < 0 { axis } else { axis.reversed() };
        meets.then_some(SideMoment { gap: gap as u32, speed: speed as u32, axis })
    }

    /// Whether the ray is between the ends at `num / den`: differences and motions below 2^30 give
    /// sums of products below 2^61.
    fn holds(&self, num: i32, den: i32) -> bool {
        let way = imul(self.d, num);
        let at = |end: i32| imul(self.o.wrapping_sub(end), den).wrapping_add(way);
        at(self.lo) >= 0 && at(self.hi) <= 0
    }

    /// Whether it is strictly between them just after the start.
    const fn goes_in(&self) -> bool {
        let from_lo = self.o > self.lo || (self.o == self.lo && self.d > 0);
        let from_hi = self.o < self.hi || (self.o == self.hi && self.d < 0);
        from_lo && from_hi && self.lo < self.hi
    }
}

/// A ray from `m` that passes through the origin.
pub(in crate::query) fn meet_point(m: Raw, d: Raw) -> Option<CastHit> {
    let b = m.dot(d).wrapping_neg();
    if m.cross(d) != 0 || d.is_zero() || b < 0 || b as u64 > d.len2() {
        return None;
    }
    Some(on_line(m, d))
}

/// The hit at the origin of a ray from `m` that leads there.
fn on_line(m: Raw, d: Raw) -> CastHit {
    let (gap, speed) = if d.x == 0 { (m.y, d.y) } else { (m.x, d.x) };
    let toi = Toi::exact(mul_div(gap.unsigned_abs(), Toi::ONE.raw(), speed.unsigned_abs()));
    CastHit { toi, axis: direction(d.reversed()), displacement: m.reversed().vec2(), inside: false }
}

/// A ray against a segment.
pub(in crate::query) fn meet_segment(o: Raw, d: Raw, a: Raw, b: Raw) -> Option<CastHit> {
    if a.x == b.x || a.y == b.y {
        let (lo, hi) = meet::corners(a, b);
        return meet_side(o, d, lo, hi).map(|side| reached(&side, d));
    }
    meet_slope(o, d, a, b)
}

/// A ray against a slanted segment. Products of differences and motions below 2^30: below 2^61.
fn meet_slope(o: Raw, d: Raw, a: Raw, b: Raw) -> Option<CastHit> {
    let (e, m) = (b.sub(a), o.sub(a));
    let (height, into) = (e.cross(m), e.cross(d).wrapping_neg());
    if into == 0 {
        if height != 0 || d.is_zero() {
            return None;
        }
        // Along the line: the end that comes first, if the ray is before it.
        let n = if e.dot(d) > 0 { m } else { o.sub(b) };
        return (n.dot(d) < 0).then(|| meet_point(n, d)).flatten();
    }
    let rises = into < 0;
    let (gap, speed) = if rises { (height.wrapping_neg(), into.wrapping_neg()) } else { (height, into) };
    let (past_a, past_b) = (m.cross(d), o.sub(b).cross(d));
    let between = (past_a <= 0 && past_b >= 0) || (past_a >= 0 && past_b <= 0);
    if gap < 0 || gap > speed || !between {
        return None;
    }
    let left = Axis::new(e.y.wrapping_neg(), e.x);
    let axis = if rises { left.reversed() } else { left };
    Some(reached(&EdgeMoment { gap: gap as u64, speed: speed as u64, axis }, d))
}
