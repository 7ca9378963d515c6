//! Shapes: small `Copy` values with private fields and checked constructors. A shape that exists is
//! inside the domain.

mod any;
mod capsule;
mod compound;
mod corners;
mod oriented_box;
mod parts;
mod polygon;
#[cfg(feature = "serde")]
mod stored;

use crate::error::{Quantity, RangeError};
use crate::num::{Fx, Raw, Vec2, check_coordinate, check_radius};

pub use any::AnyShape;
pub use capsule::Capsule;
pub(crate) use compound::kernel;
pub use compound::{Compound, CompoundError, Single};
pub(crate) use corners::Convex;
pub use oriented_box::OrientedBox;
pub use parts::{ConvexParts, PartsError};
pub use polygon::ConvexPolygon;

/// An axis-aligned box, given by its two corners.
///
/// A box without width or height is legal and acts as a segment or a point.
///
/// ```text
///  min +--------+
///      |        |      y may grow down (as here) or up
///      +--------+ max
/// ```
///
/// ```
/// use tilesat::{Aabb, Vec2};
/// let player = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(10, 14))?;
/// assert_eq!(player.size(), Vec2::from_ints(10, 14));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias("AABB", "Rect", "bounding box", "Cuboid"))]
pub struct Aabb {
    min: Vec2,
    max: Vec2,
}

impl Aabb {
    /// A box from its corner with the smaller coordinates to the one with the larger ones.
    ///
    /// # Errors
    /// [`RangeError`] if a coordinate is outside the [domain](crate::num::DOMAIN) or `min` is
    /// beyond `max`.
    ///
    /// ```
    /// use tilesat::{Aabb, Quantity, Vec2};
    /// let hero = Aabb::new(Vec2::from_ints(4, 30), Vec2::from_ints(14, 44))?;
    /// let swapped = Aabb::new(Vec2::from_ints(14, 30), Vec2::from_ints(4, 44));
    /// assert_eq!(swapped.unwrap_err().what, Quantity::Width);
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    pub const fn new(min: Vec2, max: Vec2) -> Result<Self, RangeError> {
        if let Err(e) = check_coordinate(min) {
            return Err(e);
        }
        if let Err(e) = check_coordinate(max) {
            return Err(e);
        }
        let (lo, hi) = (Raw::of(min), Raw::of(max));
        if lo.x > hi.x {
            return Err(RangeError { what: Quantity::Width, value: hi.x - lo.x });
        }
        if lo.y > hi.y {
            return Err(RangeError { what: Quantity::Height, value: hi.y - lo.y });
        }
        Ok(Self { min, max })
    }

    /// A box from its centre and half its size; exact.
    ///
    /// # Errors
    /// [`RangeError`] if a half extent is negative or a corner is outside the
    /// [domain](crate::num::DOMAIN).
    ///
    /// ```
    /// use tilesat::{Aabb, Vec2};
    /// let chest = Aabb::from_centre(Vec2::from_ints(50, 50), Vec2::from_ints(5, 4))?;
    /// assert_eq!((chest.min(), chest.max()), (Vec2::from_ints(45, 46), Vec2::from_ints(55, 54)));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[doc(alias("from_center", "half_extents"))]
    pub const fn from_centre(centre: Vec2, half: Vec2) -> Result<Self, RangeError> {
        if let Err(e) = check_coordinate(centre) {
            return Err(e);
        }
        let (c, h) = (Raw::of(centre), Raw::of(half));
        if h.x < 0 || h.x >= crate::num::DOMAIN {
            return Err(RangeError { what: Quantity::HalfExtent, value: h.x });
        }
        if h.y < 0 || h.y >= crate::num::DOMAIN {
            return Err(RangeError { what: Quantity::HalfExtent, value: h.y });
        }
        Self::new(c.sub(h).vec2(), c.add(h).vec2())
    }

    /// A box from its corner with the smaller coordinates and its size; exact.
    ///
    /// # Errors
    /// [`RangeError`] if a size is negative, or a corner is outside the
    /// [domain](crate::num::DOMAIN).
    ///
    /// ```
    /// use tilesat::{Aabb, Vec2};
    /// // A hero of 10 x 14 whose feet are in the middle of the spawn's lower edge (y down).
    /// let (feet, size) = (Vec2::from_ints(24, 144), Vec2::from_ints(10, 14));
    /// let hero = Aabb::from_size(feet - Vec2::new(size.x / 2, size.y), size)?;
    /// assert_eq!((hero.min(), hero.max()), (Vec2::from_ints(19, 130), Vec2::from_ints(29, 144)));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    pub const fn from_size(min: Vec2, size: Vec2) -> Result<Self, RangeError> {
        let (lo, size) = (Raw::of(min), Raw::of(size));
        if size.x < 0 {
            return Err(RangeError { what: Quantity::Width, value: size.x });
        }
        if size.y < 0 {
            return Err(RangeError { what: Quantity::Height, value: size.y });
        }
        // A sum that does not fit saturates, beyond the domain.
        let max = Vec2::from_raw(lo.x.saturating_add(size.x), lo.y.saturating_add(size.y));
        Self::new(min, max)
    }

    /// For corners that the caller has checked.
    pub(crate) const fn from_raw_unchecked(min: Raw, max: Raw) -> Self {
        Self { min: min.vec2(), max: max.vec2() }
    }

    /// The corner with the smaller coordinates.
    #[must_use]
    pub const fn min(&self) -> Vec2 {
        self.min
    }

    /// The corner with the larger coordinates.
    #[must_use]
    pub const fn max(&self) -> Vec2 {
        self.max
    }

    /// Width and height; exact.
    #[must_use]
    pub const fn size(&self) -> Vec2 {
        self.hi().sub(self.lo()).vec2()
    }

    /// The middle of the box.
    ///
    /// If a side is an odd number of raw units, it is rounded toward the smaller coordinate.
    #[must_use]
    #[doc(alias = "center")]
    pub const fn centre(&self) -> Vec2 {
        let (lo, hi) = (self.lo(), self.hi());
        Vec2::from_raw((lo.x + hi.x) >> 1, (lo.y + hi.y) >> 1)
    }

    /// This box moved by `by`.
    ///
    /// ```
    /// use tilesat::{Aabb, Vec2};
    /// let hero = Aabb::from_size(Vec2::from_ints(8, 4), Vec2::from_ints(10, 12))?;
    /// let ahead = hero.translated(Vec2::from_ints(16, 0))?;
    /// assert_eq!((ahead.min(), ahead.centre()), (Vec2::from_ints(24, 4), Vec2::from_ints(29, 10)));
    /// assert!(hero.translated(Vec2::from_ints(8180, 0)).is_err()); // the domain ends at 8192
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if a corner would leave the [domain](crate::num::DOMAIN).
    pub const fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        Self::new(self.min.saturating_add(by), self.max.saturating_add(by))
    }

    /// This box itself; every shape has a bounding box.
    #[must_use]
    pub const fn aabb(&self) -> Self {
        *self
    }

    /// The point of the box that is nearest to `p`, exactly: `p` itself if it is inside.
    #[must_use]
    pub const fn closest_point(&self, p: Vec2) -> Vec2 {
        p.max(self.min).min(self.max)
    }

    /// The bounding box of two boxes.
    ///
    /// ```
    /// use tilesat::{Aabb, Vec2};
    /// let unit = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 1, 1));
    /// assert_eq!(unit(0)?.union(&unit(7)?).size(), Vec2::from_ints(8, 1));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub const fn union(&self, other: &Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The box that two boxes have in common; `None` if they do not even touch. If they only touch,
    /// it has no area.
    ///
    /// ```
    /// use tilesat::{Aabb, Vec2};
    /// let square = |x, side| Aabb::from_size(Vec2::from_ints(x, 0), Vec2::from_ints(side, side));
    /// assert_eq!(square(0, 4)?.intersection(&square(3, 9)?), Some(Aabb::new(Vec2::from_ints(3, 0), Vec2::from_ints(4, 4))?));
    /// assert_eq!(square(0, 4)?.intersection(&square(4, 4)?).map(|edge| edge.size()), Some(Vec2::from_ints(0, 4)));
    /// assert_eq!(square(0, 4)?.intersection(&square(5, 4)?), None);
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    #[doc(alias("overlap area", "clip"))]
    pub const fn intersection(&self, other: &Self) -> Option<Self> {
        let common = Self { min: self.min.max(other.min), max: self.max.min(other.max) };
        let (lo, hi) = (common.lo(), common.hi());
        if lo.x <= hi.x && lo.y <= hi.y { Some(common) } else { None }
    }

    /// This box with each side moved out by `by`, or in if it is negative; exact. Use it for the
    /// reach of a hand, an explosion, or a camera's margin.
    ///
    /// ```
    /// use tilesat::{Aabb, Vec2, fx};
    /// let hero = Aabb::from_size(Vec2::from_ints(8, 4), Vec2::from_ints(10, 12))?;
    /// let reach = hero.grown(fx!(4))?;
    /// assert_eq!((reach.min(), reach.size()), (Vec2::from_ints(4, 0), Vec2::from_ints(18, 20)));
    /// assert_eq!(reach.grown(fx!(-4))?, hero);
    /// assert!(hero.grown(fx!(-5.5)).is_err()); // nothing would be left
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if a corner would leave the [domain](crate::num::DOMAIN), or if a side would
    /// be negative.
    #[doc(alias("grow", "inflate", "loosened", "expand"))]
    pub const fn grown(&self, by: Fx) -> Result<Self, RangeError> {
        let by = Vec2::new(by, by);
        Self::new(self.min.saturating_sub(by), self.max.saturating_add(by))
    }

    pub(crate) const fn lo(&self) -> Raw {
        Raw::of(self.min)
    }

    pub(crate) const fn hi(&self) -> Raw {
        Raw::of(self.max)
    }
}

/// A circle, given by its centre and radius.
///
/// A radius of zero is legal and acts as a point.
///
/// ```
/// use tilesat::{Circle, Fx, Vec2};
/// let ball = Circle::new(Vec2::from_ints(100, 50), Fx::from_num(8))?;
/// assert_eq!(ball.aabb().min(), Vec2::from_ints(92, 42));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias("Ball", "Disc"))]
pub struct Circle {
    centre: Vec2,
    radius: Fx,
}

impl Circle {
    /// A circle from its centre and radius.
    ///
    /// # Errors
    /// [`RangeError`] if the radius is negative, or the centre, the radius or a point of the circle
    /// is outside the [domain](crate::num::DOMAIN).
    pub const fn new(centre: Vec2, radius: Fx) -> Result<Self, RangeError> {
        if let Err(e) = check_coordinate(centre) {
            return Err(e);
        }
        if let Err(e) = check_radius(radius) {
            return Err(e);
        }
        let (c, r) = (Raw::of(centre), radius.to_bits());
        // The farther end in each direction: below 2^30.
        let (x, y) = (if c.x < 0 { c.x - r } else { c.x + r }, if c.y < 0 { c.y - r } else { c.y + r });
        match check_coordinate(Vec2::from_raw(x, y)) {
            Ok(()) => Ok(Self { centre, radius }),
            Err(e) => Err(e),
        }
    }

    /// The centre.
    #[must_use]
    #[doc(alias = "center")]
    pub const fn centre(&self) -> Vec2 {
        self.centre
    }

    /// The radius, not negative.
    #[must_use]
    pub const fn radius(&self) -> Fx {
        self.radius
    }

    /// This circle moved by `by`.
    ///
    /// ```
    /// use tilesat::{Circle, Vec2, fx};
    /// let ball = Circle::new(Vec2::from_ints(20, 30), fx!(4))?;
    /// let next = ball.translated(Vec2::from_ints(3, -2))?;
    /// assert_eq!((next.centre(), next.radius()), (Vec2::from_ints(23, 28), fx!(4)));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if it would leave the [domain](crate::num::DOMAIN).
    pub const fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        Self::new(self.centre.saturating_add(by), self.radius)
    }

    /// The bounding box; exact.
    #[must_use]
    pub const fn aabb(&self) -> Aabb {
        let (c, r) = (self.c(), self.r());
        Aabb::from_raw_unchecked(Raw { x: c.x - r, y: c.y - r }, Raw { x: c.x + r, y: c.y + r })
    }

    /// For a centre and radius that the caller has checked.
    pub(crate) const fn from_raw_unchecked(centre: Raw, radius: i32) -> Self {
        Self { centre: centre.vec2(), radius: Fx::from_bits(radius) }
    }

    pub(crate) const fn c(&self) -> Raw {
        Raw::of(self.centre)
    }

    pub(crate) const fn r(&self) -> i32 {
        self.radius.to_bits()
    }
}

/// A line segment between two points; it has no inside and no side.
///
/// Equal ends are legal and act as a point. Reversing the ends changes no result, except the
/// documented degenerate axes.
///
/// ```
/// use tilesat::{Segment, Vec2};
/// let wall = Segment::new(Vec2::from_ints(0, 0), Vec2::from_ints(3, 4))?;
/// assert_eq!((wall.b() - wall.a()).length(), 5);
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias("Line", "Edge"))]
pub struct Segment {
    a: Vec2,
    b: Vec2,
}

impl Segment {
    /// A segment from its two ends.
    ///
    /// # Errors
    /// [`RangeError`] if a coordinate is outside the [domain](crate::num::DOMAIN).
    pub const fn new(a: Vec2, b: Vec2) -> Result<Self, RangeError> {
        match check_coordinate(a) {
            Ok(()) => match check_coordinate(b) {
                Ok(()) => Ok(Self { a, b }),
                Err(e) => Err(e),
            },
            Err(e) => Err(e),
        }
    }

    /// The first end.
    #[must_use]
    pub const fn a(&self) -> Vec2 {
        self.a
    }

    /// The second end.
    #[must_use]
    pub const fn b(&self) -> Vec2 {
        self.b
    }

    /// This segment moved by `by`.
    ///
    /// # Errors
    /// [`RangeError`] if an end would leave the [domain](crate::num::DOMAIN).
    pub const fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        Self::new(self.a.saturating_add(by), self.b.saturating_add(by))
    }

    /// The bounding box; exact.
    #[must_use]
    pub const fn aabb(&self) -> Aabb {
        Aabb::from_raw_unchecked(Raw::of(self.a.min(self.b)), Raw::of(self.a.max(self.b)))
    }

    pub(crate) const fn ra(&self) -> Raw {
        Raw::of(self.a)
    }

    pub(crate) const fn rb(&self) -> Raw {
        Raw::of(self.b)
    }

    /// From the first end to the second: below 2^30 per component.
    pub(crate) const fn edge(&self) -> Raw {
        self.rb().sub(self.ra())
    }
}
