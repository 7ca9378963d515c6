//! Circles.

use super::Aabb;
use crate::error::RangeError;
use crate::num::{Fx, Raw, Vec2, check_coordinate, check_radius};

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
pub struct Circle {
    centre: Vec2,
    radius: Fx,
}

impl Circle {
    /// A circle from its centre and radius.
    ///
    /// # Errors
    /// [`RangeError`] where the radius is negative, or the centre, the radius or a point of the circle is outside of the
    /// [domain](crate::num::DOMAIN).
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
    /// # Errors
    /// [`RangeError`] where it would leave the [domain](crate::num::DOMAIN).
    pub const fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        Self::new(self.centre.saturating_add(by), self.radius)
    }

    /// The bounding box; exact.
    #[must_use]
    pub const fn aabb(&self) -> Aabb {
        let (c, r) = (self.c(), self.r());
        Aabb::from_raw_unchecked(Raw { x: c.x - r, y: c.y - r }, Raw { x: c.x + r, y: c.y + r })
    }

    /// The point of the disc that is nearest to `p`: `p` itself where it is inside.
    ///
    /// Each component is the exact one rounded to nearest, so the point may be half a raw unit outside of the circle; mirrored points
    /// give mirrored bits. `p` may be anywhere. Cost: two quotients by a root, some 1150 instructions on a Cortex-M0.
    ///
    /// ```
    /// use tilesat::{Circle, Fx, Vec2};
    /// let ball = Circle::new(Vec2::from_ints(0, 0), Fx::from_num(5))?;
    /// assert_eq!(ball.closest_point(Vec2::from_ints(6, -8)), Vec2::from_ints(3, -4));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub const fn closest_point(&self, p: Vec2) -> Vec2 {
        crate::query::closest::on_disc(Raw::of(p), self.c(), self.r()).vec2()
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
