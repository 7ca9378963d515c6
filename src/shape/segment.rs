//! Line segments.

use super::Aabb;
use crate::error::RangeError;
use crate::num::{Raw, Vec2, check_coordinate};

/// A line segment between two points; it has no inside and no side.
///
/// Equal ends are legal and act as a point. Reversing the ends changes no result, save the documented degenerate axes.
///
/// ```
/// use tilesat::{Segment, Vec2};
/// let wall = Segment::new(Vec2::from_ints(0, 0), Vec2::from_ints(3, 4))?;
/// assert_eq!((wall.b() - wall.a()).length(), 5);
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Segment {
    a: Vec2,
    b: Vec2,
}

impl Segment {
    /// A segment from its two ends.
    ///
    /// # Errors
    /// [`RangeError`] where a coordinate is outside of the [domain](crate::num::DOMAIN).
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
    /// [`RangeError`] where an end would leave the [domain](crate::num::DOMAIN).
    pub const fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        Self::new(self.a.saturating_add(by), self.b.saturating_add(by))
    }

    /// The bounding box; exact.
    #[must_use]
    pub const fn aabb(&self) -> Aabb {
        Aabb::from_raw_unchecked(Raw::of(self.a.min(self.b)), Raw::of(self.a.max(self.b)))
    }

    /// The point of the segment that is nearest to `p`.
    ///
    /// Each component is the exact one rounded to nearest, halves toward `p`, so the point may be half a raw unit off the segment. Reversing the
    /// segment changes nothing, mirrored points give mirrored bits. `p` may be anywhere. Exact and cheap for segments along x or
    /// y and where an end is nearest; else two long divisions, some 2050 instructions on a Cortex-M0.
    ///
    /// ```
    /// use tilesat::{Segment, Vec2};
    /// let slope = Segment::new(Vec2::from_ints(0, 0), Vec2::from_ints(20, 10))?;
    /// assert_eq!(slope.closest_point(Vec2::from_ints(5, 15)), Vec2::from_ints(10, 5));
    /// assert_eq!(slope.closest_point(Vec2::from_ints(-3, 0)), slope.a());
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub const fn closest_point(&self, p: Vec2) -> Vec2 {
        crate::query::closest::on_segment(Raw::of(p), self.ra(), self.rb()).vec2()
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
