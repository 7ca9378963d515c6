//! The kernels' form of every convex shape: corners, and a radius around them.

use super::any::each;
use super::{Aabb, AnyShape, Capsule, Circle, ConvexPolygon, OrientedBox, Segment};
use crate::num::{Raw, Vec2};
use core::ops::Deref;

/// A shape as the hull of its corners, grown by a radius.
///
/// Corners are strictly convex and counter-clockwise (y up): two are a segment, one is a point. A
/// corner and the radius together stay inside the domain.
///
/// Public in a private module, because a sealed trait rests on it.
pub trait Convex: Sized {
    /// The corners, computed or lent.
    type Corners<'a>: Deref<Target = [Vec2]>
    where
        Self: 'a;

    fn outline(&self) -> Self::Corners<'_>;

    /// The corners, if the shape stores them.
    #[inline]
    fn stored_corners(&self) -> Option<&[Vec2]> {
        None
    }

    /// The radius, raw and not negative; 0 for sharp shapes.
    #[inline]
    fn rounding(&self) -> i32 {
        0
    }

    /// Two sides and twice the middle of a sharp box with area; none for other shapes.
    #[inline]
    fn box_sides(&self) -> Option<[Raw; 3]> {
        None
    }

    /// Two half sides and the middle of a box in any direction; none for other shapes.
    #[inline]
    fn half_sides(&self) -> Option<[Raw; 3]> {
        None
    }

    /// The middle of a circle; none for other shapes.
    #[inline]
    fn point(&self) -> Option<Raw> {
        None
    }

    /// The ends of a shape whose core is a segment; none for other shapes.
    #[inline]
    fn ends(&self) -> Option<[Raw; 2]> {
        None
    }

    /// The shape at another position, even outside of the domain.
    fn shifted(&self, by: Raw) -> Self;
}

/// At most four corners.
#[derive(Clone, Copy, Debug)]
pub struct Few {
    points: [Vec2; 4],
    count: usize,
}

impl Few {
    const fn one(p: Vec2) -> Self {
        Self { points: [p; 4], count: 1 }
    }

    /// Equal ends are one point. Others are put in lexicographic order, so reversing them changes
    /// nothing.
    fn line(a: Vec2, b: Vec2) -> Self {
        let (a, b) = if b.raw() < a.raw() { (b, a) } else { (a, b) };
        Self { points: [a, b, a, b], count: if a == b { 1 } else { 2 } }
    }

    /// The parallelogram `at + {0, u} + {0, v}`, with `v` on the left of `u`; if one of them is
    /// zero, a segment or a point.
    fn parallelogram(at: Raw, u: Raw, v: Raw) -> Self {
        let (b, c) = (at.add(u), at.add(v));
        if u.is_zero() || v.is_zero() {
            return Self::line(at.vec2(), if u.is_zero() { c.vec2() } else { b.vec2() });
        }
        Self { points: [at, b, b.add(v), c].map(Raw::vec2), count: 4 }
    }
}

impl Deref for Few {
    type Target = [Vec2];

    #[inline]
    fn deref(&self) -> &[Vec2] {
        self.points.get(..self.count).unwrap_or(&self.points)
    }
}

impl Convex for Aabb {
    type Corners<'a> = Few;

    #[inline]
    fn outline(&self) -> Few {
        let size = self.hi().sub(self.lo());
        Few::parallelogram(self.lo(), Raw { x: size.x, y: 0 }, Raw { x: 0, y: size.y })
    }

    #[inline]
    fn box_sides(&self) -> Option<[Raw; 3]> {
        let size = self.hi().sub(self.lo());
        let has_area = size.x != 0 && size.y != 0;
        has_area.then(|| [Raw { x: size.x, y: 0 }, Raw { x: 0, y: size.y }, self.lo().add(self.hi())])
    }

    fn shifted(&self, by: Raw) -> Self {
        Self::from_raw_unchecked(self.lo().add(by), self.hi().add(by))
    }
}

impl Convex for Circle {
    type Corners<'a> = Few;

    #[inline]
    fn outline(&self) -> Few {
        Few::one(self.centre())
    }

    #[inline]
    fn point(&self) -> Option<Raw> {
        Some(self.c())
    }

    #[inline]
    fn rounding(&self) -> i32 {
        self.r()
    }

    #[inline]
    fn ends(&self) -> Option<[Raw; 2]> {
        Some([self.c(), self.c()])
    }

    fn shifted(&self, by: Raw) -> Self {
        Self::from_raw_unchecked(self.c().add(by), self.r())
    }
}

impl Convex for Segment {
    type Corners<'a> = Few;

    #[inline]
    fn outline(&self) -> Few {
        Few::line(self.a(), self.b())
    }

    #[inline]
    fn ends(&self) -> Option<[Raw; 2]> {
        Some([self.ra(), self.rb()])
    }

    fn shifted(&self, by: Raw) -> Self {
        Self { a: self.ra().add(by).vec2(), b: self.rb().add(by).vec2() }
    }
}

impl Convex for Capsule {
    type Corners<'a> = Few;

    #[inline]
    fn outline(&self) -> Few {
        Few::line(self.a(), self.b())
    }

    #[inline]
    fn rounding(&self) -> i32 {
        self.radius().to_bits()
    }

    #[inline]
    fn ends(&self) -> Option<[Raw; 2]> {
        Some([Raw::of(self.a()), Raw::of(self.b())])
    }

    fn shifted(&self, by: Raw) -> Self {
        Self::from_raw_unchecked(Raw::of(self.a()).add(by), Raw::of(self.b()).add(by), self.radius())
    }
}

impl Convex for OrientedBox {
    type Corners<'a> = Few;

    #[inline]
    fn outline(&self) -> Few {
        // Half of a side is below 2^29, and the corners are inside the domain: whole sides are
        // below 2^30.
        let (u, v) = (Raw::of(self.along()), Raw::of(self.across()));
        Few::parallelogram(Raw::of(self.centre()).sub(u).sub(v), u.add(u), v.add(v))
    }

    #[inline]
    fn box_sides(&self) -> Option<[Raw; 3]> {
        let (u, v, c) = (Raw::of(self.along()), Raw::of(self.across()), Raw::of(self.centre()));
        let is_plain = self.rounding() == 0 && !u.is_zero() && !v.is_zero();
        is_plain.then(|| [u, v, c].map(|p| p.add(p)))
    }

    #[inline]
    fn half_sides(&self) -> Option<[Raw; 3]> {
        Some([self.along(), self.across(), self.centre()].map(Raw::of))
    }

    #[inline]
    fn rounding(&self) -> i32 {
        self.radius().to_bits()
    }

    fn shifted(&self, by: Raw) -> Self {
        self.moved_to(Raw::of(self.centre()).add(by).vec2())
    }
}

/// The corners of a shape of any kind.
#[derive(Clone, Copy, Debug)]
pub enum AnyCorners<'a> {
    Few(Few),
    Lent(&'a [Vec2]),
}

impl Deref for AnyCorners<'_> {
    type Target = [Vec2];

    #[inline]
    fn deref(&self) -> &[Vec2] {
        match self {
            Self::Few(few) => few,
            Self::Lent(lent) => lent,
        }
    }
}

impl<const N: usize> Convex for AnyShape<N> {
    type Corners<'a> = AnyCorners<'a>;

    /// A call: each pair with it has one, not six.
    #[inline(never)]
    fn outline(&self) -> AnyCorners<'_> {
        match self {
            Self::Aabb(it) => AnyCorners::Few(it.outline()),
            Self::Circle(it) => AnyCorners::Few(it.outline()),
            Self::Segment(it) => AnyCorners::Few(it.outline()),
            Self::Capsule(it) => AnyCorners::Few(it.outline()),
            Self::OrientedBox(it) => AnyCorners::Few(it.outline()),
            Self::Polygon(it) => AnyCorners::Lent(it.outline()),
        }
    }

    #[inline]
    fn rounding(&self) -> i32 {
        each!(self, |it| it.rounding())
    }

    fn shifted(&self, by: Raw) -> Self {
        match self {
            Self::Aabb(it) => Self::Aabb(it.shifted(by)),
            Self::Circle(it) => Self::Circle(it.shifted(by)),
            Self::Segment(it) => Self::Segment(it.shifted(by)),
            Self::Capsule(it) => Self::Capsule(it.shifted(by)),
            Self::OrientedBox(it) => Self::OrientedBox(it.shifted(by)),
            Self::Polygon(it) => Self::Polygon(it.shifted(by)),
        }
    }
}

impl<const N: usize> Convex for ConvexPolygon<N> {
    type Corners<'a> = &'a [Vec2];

    #[inline]
    fn outline(&self) -> &[Vec2] {
        self.vertices()
    }

    #[inline]
    fn stored_corners(&self) -> Option<&[Vec2]> {
        Some(self.vertices())
    }

    #[inline]
    fn rounding(&self) -> i32 {
        self.radius().to_bits()
    }

    fn shifted(&self, by: Raw) -> Self {
        self.moved_by(by)
    }
}
