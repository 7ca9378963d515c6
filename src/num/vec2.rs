//! Vectors of the world's scalars, and the domain that they keep to: inside it no kernel can wrap, and constructors let nothing else in.

use super::{Fx, imul};
use crate::error::{Quantity, RangeError};
use core::ops::{Add, AddAssign, Neg, Sub, SubAssign};

/// A position or displacement in units.
///
/// Names are glam's where glam has them. `+`, `-` and negation saturate at the ends of 16.16, far outside of the [domain](super::DOMAIN).
///
/// ```
/// use tilesat::Vec2;
/// let v = Vec2::from_ints(3, 4);
/// assert_eq!(v.dot(v), 25 << 32);
/// assert_eq!(v.length(), 5);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Vec2 {
    /// Horizontal component; grows to the right.
    pub x: Fx,
    /// Vertical component; grows as the caller likes (rows of a tile map follow it).
    pub y: Fx,
}

impl Vec2 {
    /// The origin.
    pub const ZERO: Self = Self::from_raw(0, 0);

    /// A vector from its components.
    #[must_use]
    pub const fn new(x: Fx, y: Fx) -> Self {
        Self { x, y }
    }

    /// A vector from the bits of its components: any fixed-point format may be fed this way, with results in the same format.
    #[must_use]
    pub const fn from_raw(x: i32, y: i32) -> Self {
        Self { x: Fx::from_bits(x), y: Fx::from_bits(y) }
    }

    /// A vector of whole units. Exact.
    #[must_use]
    pub const fn from_ints(x: i16, y: i16) -> Self {
        Self::from_raw((x as i32) << 16, (y as i32) << 16)
    }

    /// A vector from floating point, each component rounded to nearest; `None` where a component is not finite or does not fit 16.16.
    ///
    /// Never used by a query. Needs the feature `libm`.
    #[cfg(feature = "libm")]
    #[must_use]
    #[expect(clippy::float_arithmetic, reason = "this is the conversion from floating point")]
    pub fn from_f32(x: f32, y: f32) -> Option<Self> {
        // f32 has 24 bits and the scale is a power of two: the product is exact, only `rintf` rounds.
        let raw = |v: f32| {
            let scaled = libm::rintf(v * 65536.0);
            (-2_147_483_648.0..2_147_483_648.0).contains(&scaled).then_some(scaled as i32)
        };
        Some(Self::from_raw(raw(x)?, raw(y)?))
    }

    /// The bits of both components.
    #[must_use]
    pub const fn raw(self) -> (i32, i32) {
        (self.x.to_bits(), self.y.to_bits())
    }

    /// The dot product in square raw units, exact in 64 bits where both vectors are differences inside the domain.
    #[must_use]
    pub const fn dot(self, rhs: Self) -> i64 {
        imul(self.x.to_bits(), rhs.x.to_bits()).wrapping_add(imul(self.y.to_bits(), rhs.y.to_bits()))
    }

    /// The perpendicular dot product `x1 y2 - y1 x2` in square raw units; positive where `rhs` is counter-clockwise of `self` (y up).
    #[must_use]
    pub const fn perp_dot(self, rhs: Self) -> i64 {
        imul(self.x.to_bits(), rhs.y.to_bits()).wrapping_sub(imul(self.y.to_bits(), rhs.x.to_bits()))
    }

    /// The square of the length in square raw units, exact.
    #[must_use]
    pub const fn length_squared(self) -> u64 {
        let (x, y) = self.raw();
        super::usqr(x.unsigned_abs()).wrapping_add(super::usqr(y.unsigned_abs()))
    }

    /// The length, rounded down to a raw unit; saturates above 32767 units.
    ///
    /// Cost: one square root, about 300 instructions on a Cortex-M0.
    #[must_use]
    pub const fn length(self) -> Fx {
        let root = super::isqrt64(self.length_squared());
        Fx::from_bits(if root > i32::MAX as u32 { i32::MAX } else { root as i32 })
    }

    /// The smaller of each component.
    #[must_use]
    pub const fn min(self, rhs: Self) -> Self {
        let ((ax, ay), (bx, by)) = (self.raw(), rhs.raw());
        Self::from_raw(if ax < bx { ax } else { bx }, if ay < by { ay } else { by })
    }

    /// The larger of each component.
    #[must_use]
    pub const fn max(self, rhs: Self) -> Self {
        let ((ax, ay), (bx, by)) = (self.raw(), rhs.raw());
        Self::from_raw(if ax > bx { ax } else { bx }, if ay > by { ay } else { by })
    }

    /// `self + rhs`, each component saturating; as `+`, usable in constants.
    #[must_use]
    pub const fn saturating_add(self, rhs: Self) -> Self {
        Self { x: self.x.saturating_add(rhs.x), y: self.y.saturating_add(rhs.y) }
    }
}

impl Add for Vec2 {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        self.saturating_add(rhs)
    }
}

impl Sub for Vec2 {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Self { x: self.x.saturating_sub(rhs.x), y: self.y.saturating_sub(rhs.y) }
    }
}

impl AddAssign for Vec2 {
    fn add_assign(&mut self, rhs: Self) {
        *self = *self + rhs;
    }
}

impl SubAssign for Vec2 {
    fn sub_assign(&mut self, rhs: Self) {
        *self = *self - rhs;
    }
}

impl Neg for Vec2 {
    type Output = Self;
    fn neg(self) -> Self {
        Self { x: self.x.saturating_neg(), y: self.y.saturating_neg() }
    }
}

impl From<(Fx, Fx)> for Vec2 {
    fn from((x, y): (Fx, Fx)) -> Self {
        Self { x, y }
    }
}

impl From<[Fx; 2]> for Vec2 {
    fn from([x, y]: [Fx; 2]) -> Self {
        Self { x, y }
    }
}

impl From<Vec2> for [Fx; 2] {
    fn from(v: Vec2) -> Self {
        [v.x, v.y]
    }
}

/// Raw coordinates, or a difference of two inside the domain: the kernels' operand.
///
/// Public in a private module, because methods of sealed traits take it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Raw {
    pub(crate) x: i32,
    pub(crate) y: i32,
}

impl Raw {
    pub(crate) const ZERO: Self = Self { x: 0, y: 0 };

    pub(crate) const fn of(v: Vec2) -> Self {
        Self { x: v.x.to_bits(), y: v.y.to_bits() }
    }

    pub(crate) const fn vec2(self) -> Vec2 {
        Vec2::from_raw(self.x, self.y)
    }

    pub(crate) const fn add(self, o: Self) -> Self {
        Self { x: self.x.wrapping_add(o.x), y: self.y.wrapping_add(o.y) }
    }

    /// Both operands inside the domain: the difference is below 2^30.
    pub(crate) const fn sub(self, o: Self) -> Self {
        Self { x: self.x.wrapping_sub(o.x), y: self.y.wrapping_sub(o.y) }
    }

    pub(crate) const fn reversed(self) -> Self {
        Self { x: self.x.wrapping_neg(), y: self.y.wrapping_neg() }
    }

    /// Operands below 2^30: each product is below 2^60, the sum below 2^61.
    pub(crate) const fn dot(self, o: Self) -> i64 {
        super::dot(self.x, o.x, self.y, o.y)
    }

    /// [`dot`](Self::dot) and [`cross`](Self::cross): where a product is a call, three of them do (Gauss). Operands and their sums below 2^31.
    #[inline]
    pub(crate) const fn dot_cross(self, o: Self) -> (i64, i64) {
        if !super::SPLIT {
            return (self.dot(o), self.cross(o));
        }
        let both = imul(o.x, self.x.wrapping_sub(self.y));
        let (dot, cross) = (imul(self.y, o.x.wrapping_add(o.y)), imul(self.x, o.y.wrapping_sub(o.x)));
        (both.wrapping_add(dot), both.wrapping_add(cross))
    }

    pub(crate) const fn cross(self, o: Self) -> i64 {
        super::dot(self.x, o.y, self.y.wrapping_neg(), o.x)
    }

    pub(crate) const fn len2(self) -> u64 {
        super::norm(self.x, self.y)
    }

    pub(crate) const fn is_zero(self) -> bool {
        self.x == 0 && self.y == 0
    }
}

/// Every coordinate, radius and half extent has a raw absolute value below this, 2^29: 8192 units in 16.16.
///
/// Differences then need 31 bits, products of differences 62, and every predicate fits a signed 64-bit or one
/// unsigned 128-bit comparison.
pub const DOMAIN: i32 = 1 << 29;

/// A motion call takes components, and bodies with extents, below this raw value, 2^28: 4096 units in 16.16.
pub const MOTION: i32 = 1 << 28;

pub(crate) const fn check_coordinate(v: Vec2) -> Result<(), RangeError> {
    match check(v.x, -DOMAIN, DOMAIN, Quantity::X) {
        Ok(()) => check(v.y, -DOMAIN, DOMAIN, Quantity::Y),
        bad => bad,
    }
}

pub(crate) const fn check_radius(r: Fx) -> Result<(), RangeError> {
    check(r, -1, DOMAIN, Quantity::Radius)
}

pub(crate) const fn check_length(length: Fx) -> Result<(), RangeError> {
    check(length, -1, DOMAIN, Quantity::Length)
}

pub(crate) const fn check_motion(v: Vec2, limit: i32) -> Result<(), RangeError> {
    match check(v.x, -limit, limit, Quantity::MotionX) {
        Ok(()) => check(v.y, -limit, limit, Quantity::MotionY),
        bad => bad,
    }
}

/// Refuses values outside of the open interval.
const fn check(v: Fx, above: i32, below: i32, what: Quantity) -> Result<(), RangeError> {
    let value = v.to_bits();
    if above < value && value < below { Ok(()) } else { Err(RangeError { what, value }) }
}
