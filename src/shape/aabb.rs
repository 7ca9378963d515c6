//! Boxes with sides along the axes.

use crate::error::{Quantity, RangeError};
use crate::num::{Raw, Vec2, check_coordinate};

/// An axis-aligned box, given by its two corners.
///
/// A box of no width or height is legal and acts as a segment or a point.
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
pub struct Aabb {
    min: Vec2,
    max: Vec2,
}

impl Aabb {
    /// A box from its corner with the smaller coordinates to the one with the larger ones.
    ///
    /// # Errors
    /// [`RangeError`] where a coordinate is outside of the [domain](crate::num::DOMAIN) or `min` is beyond `max`.
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
    /// [`RangeError`] where a half extent is negative or a corner is outside of the [domain](crate::num::DOMAIN).
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

    /// The middle; where a side is an odd number of raw units, the half unit is dropped toward the smaller coordinate.
    #[must_use]
    pub const fn centre(&self) -> Vec2 {
        let (lo, hi) = (self.lo(), self.hi());
        Vec2::from_raw((lo.x + hi.x) >> 1, (lo.y + hi.y) >> 1)
    }

    /// This box moved by `by`.
    ///
    /// # Errors
    /// [`RangeError`] where a corner would leave the [domain](crate::num::DOMAIN).
    pub const fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        Self::new(self.min.saturating_add(by), self.max.saturating_add(by))
    }

    /// This box itself; every shape has a bounding box.
    #[must_use]
    pub const fn aabb(&self) -> Self {
        *self
    }

    /// The point of the box that is nearest to `p`: `p` itself where it is inside. Exact.
    #[must_use]
    pub const fn closest_point(&self, p: Vec2) -> Vec2 {
        p.max(self.min).min(self.max)
    }

    /// The bounding box of two boxes.
    #[must_use]
    pub const fn union(&self, other: &Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    pub(crate) const fn lo(&self) -> Raw {
        Raw::of(self.min)
    }

    pub(crate) const fn hi(&self) -> Raw {
        Raw::of(self.max)
    }
}
