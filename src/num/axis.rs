//! Directions as exact integers.

use super::{UnitVec2, Vec2, imul};
use core::ops::Neg;

/// An exact direction: two integers of any common scale.
///
/// Contacts and faces carry their normals this way, because a unit vector cannot be exact: `(1, 2)` is the direction of a
/// slope, `(1, 2)/sqrt(5)` is not on any lattice. [`Axis::unit`] rounds it when a unit vector is wanted.
///
/// ```
/// use tilesat::Axis;
/// let slope = Axis::new(1, 2);
/// assert_eq!(slope.perp(), Axis::new(-2, 1));
/// assert_eq!(slope.unit().raw(), (480_191_942, 960_383_884));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Axis {
    /// Horizontal component.
    pub x: i32,
    /// Vertical component.
    pub y: i32,
}

impl Axis {
    /// To the right.
    pub const X: Self = Self::new(1, 0);
    /// The direction in which y grows.
    pub const Y: Self = Self::new(0, 1);
    /// To the left.
    pub const NEG_X: Self = Self::new(-1, 0);
    /// Against y: upwards on a screen.
    pub const NEG_Y: Self = Self::new(0, -1);

    /// A direction from its components.
    #[must_use]
    pub const fn new(x: i32, y: i32) -> Self {
        Self { x, y }
    }

    /// The dot product; exact where the components are below 2^31 in size and their products' sum fits 63 bits, as all axes of this crate do.
    #[must_use]
    pub const fn dot(self, rhs: Self) -> i64 {
        // Across a face along an axis: one product, or none.
        if self.x == 0 {
            return times(self.y, rhs.y);
        }
        if self.y == 0 {
            return times(self.x, rhs.x);
        }
        super::dot(self.x, rhs.x, self.y, rhs.y)
    }

    /// The perpendicular dot product `x1 y2 - y1 x2`.
    #[must_use]
    pub const fn perp_dot(self, rhs: Self) -> i64 {
        if self.x == 0 {
            return times(self.y, rhs.x).wrapping_neg();
        }
        if self.y == 0 {
            return times(self.x, rhs.y);
        }
        imul(self.x, rhs.y).wrapping_sub(imul(self.y, rhs.x))
    }

    /// The dot product with a vector, in units of this axis' scale times raw.
    #[must_use]
    pub const fn dot_vec(self, v: Vec2) -> i64 {
        let (x, y) = v.raw();
        self.dot(Self::new(x, y))
    }

    /// This direction turned by a right angle: `(-y, x)`.
    #[must_use]
    pub const fn perp(self) -> Self {
        Self::new(self.y.wrapping_neg(), self.x)
    }

    /// The opposite direction.
    #[must_use]
    pub const fn reversed(self) -> Self {
        Self::new(self.x.wrapping_neg(), self.y.wrapping_neg())
    }

    /// Whether both components are zero; no result of this crate is.
    #[must_use]
    pub const fn is_zero(self) -> bool {
        self.x == 0 && self.y == 0
    }

    /// The unit vector of this direction, within 1.5 raw units of 2^-30 per component; the zero axis gives +x.
    ///
    /// Mirrored axes give mirrored bits, parallels to x or y are exact. Cost: one reciprocal root, no division; about 250
    /// instructions on a Cortex-M0.
    #[must_use]
    pub const fn unit(self) -> UnitVec2 {
        super::unit::unit_nearest(self)
    }

    /// The square of the length, exact for components below 2^31.
    #[must_use]
    pub const fn length_squared(self) -> u64 {
        super::norm(self.x, self.y)
    }
}

/// The product, of which the first factor often is a unit.
#[inline]
const fn times(a: i32, b: i32) -> i64 {
    match a {
        1 => b as i64,
        -1 => (b as i64).wrapping_neg(),
        _ => imul(a, b),
    }
}

impl Neg for Axis {
    type Output = Self;
    fn neg(self) -> Self {
        self.reversed()
    }
}
