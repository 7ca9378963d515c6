//! Vectors: constructors, conversions, products and operators.

use super::{Fx, imul, mul_div, umul};
use crate::error::{Quantity, RangeError};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A position or displacement in units.
///
/// Methods have the names of glam, if glam has them. Operators never panic and never wrap: they
/// saturate at the ends of 16.16, far outside the [domain](super::DOMAIN). The `checked_` methods
/// return `None` instead.
///
/// | operator | rounding | overflow, and division by zero |
/// |---|---|---|
/// | `+` `-` negation, `*` with an integer | exact | saturates |
/// | `*` `/` with an [`Fx`], `/` with an integer | toward zero, so mirrored vectors give mirrored results | saturates toward the sign; `0 / 0` is 0 |
///
/// An [`Fx`] by itself is different: [its own operators](Fx#overflow) panic or wrap.
///
/// ```
/// use tilesat::{Fx, Vec2, fx};
/// let v = Vec2::from_ints(3, 4);
/// assert_eq!(v.dot(v), 25 << 32);
/// assert_eq!(v.length(), 5);
/// assert_eq!(v * fx!(0.5), Vec2::new(fx!(1.5), fx!(2)));
/// assert_eq!((2 * v, v / 2), (Vec2::from((6, 8)), Vec2::new(fx!(1.5), fx!(2))));
/// assert_eq!(v * fx!(20000), Vec2::new(Fx::MAX, Fx::MAX));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[doc(alias("vector", "Point"))]
pub struct Vec2 {
    /// Horizontal component; grows to the right.
    pub x: Fx,
    /// Vertical component. You choose whether it grows down or up; rows of a tile map follow it.
    pub y: Fx,
}

impl Vec2 {
    /// The origin.
    pub const ZERO: Self = Self::from_raw(0, 0);
    /// One unit to the right.
    pub const X: Self = Self::from_ints(1, 0);
    /// One unit in the direction in which y grows.
    pub const Y: Self = Self::from_ints(0, 1);
    /// One unit to the left.
    pub const NEG_X: Self = Self::from_ints(-1, 0);
    /// One unit against y: up on a screen.
    pub const NEG_Y: Self = Self::from_ints(0, -1);

    /// A vector from its components.
    #[must_use]
    pub const fn new(x: Fx, y: Fx) -> Self {
        Self { x, y }
    }

    /// A vector from the bits of its components.
    ///
    /// You may pass the bits of any fixed-point format; results are then in that format.
    #[must_use]
    pub const fn from_raw(x: i32, y: i32) -> Self {
        Self { x: Fx::from_bits(x), y: Fx::from_bits(y) }
    }

    /// A vector of whole units; exact.
    #[must_use]
    pub const fn from_ints(x: i16, y: i16) -> Self {
        Self::from_raw((x as i32) << 16, (y as i32) << 16)
    }

    /// A vector from floating point, each component rounded to nearest, ties to even.
    ///
    /// It is `None` if a component is not finite or does not fit 16.16: not every `f32` is a
    /// vector. [`to_f32`](Self::to_f32) cannot fail. No query uses this function. It computes with
    /// integers only, so a chip without an FPU links no floating-point routine.
    ///
    /// ```
    /// use tilesat::{Vec2, fx};
    /// assert_eq!(Vec2::from_f32(12.5, -0.25), Some(Vec2::new(fx!(12.5), fx!(-0.25))));
    /// assert_eq!((Vec2::from_f32(f32::NAN, 0.0), Vec2::from_f32(0.0, 40_000.0)), (None, None));
    /// ```
    #[must_use]
    pub fn from_f32(x: f32, y: f32) -> Option<Self> {
        Some(Self { x: Fx::checked_from_num(x)?, y: Fx::checked_from_num(y)? })
    }

    /// Both components as floating point, for drawing: rounded to nearest, ties to even.
    ///
    /// Exact below 256 units: an `f32` has 24 bits. A tuple, which other crates' vectors take:
    /// `glam::Vec2::from(v.to_f32())`.
    ///
    /// ```
    /// assert_eq!(tilesat::Vec2::from_ints(3, -4).to_f32(), (3.0, -4.0));
    /// ```
    #[must_use]
    pub fn to_f32(self) -> (f32, f32) {
        (self.x.to_num(), self.y.to_num())
    }

    /// The pixel that holds the point: whole units, rounded toward negative infinity.
    ///
    /// ```
    /// use tilesat::{Vec2, fx};
    /// assert_eq!(Vec2::new(fx!(2.9), fx!(-0.1)).to_ints(), (2, -1));
    /// ```
    #[must_use]
    pub const fn to_ints(self) -> (i32, i32) {
        (self.x.to_bits() >> 16, self.y.to_bits() >> 16)
    }

    /// The bits of the two components.
    #[must_use]
    pub const fn raw(self) -> (i32, i32) {
        (self.x.to_bits(), self.y.to_bits())
    }

    /// The dot product in square raw units, unlike glam's: `1 << 32` is a square unit.
    ///
    /// Exact for differences of points inside the domain.
    #[must_use]
    pub const fn dot(self, rhs: Self) -> i64 {
        imul(self.x.to_bits(), rhs.x.to_bits()).wrapping_add(imul(self.y.to_bits(), rhs.y.to_bits()))
    }

    /// The perpendicular dot product `x1 y2 - y1 x2` in square raw units, unlike glam's.
    ///
    /// Positive if `rhs` is counter-clockwise of `self` with y up, and clockwise on a screen. Exact
    /// for differences of points inside the domain.
    ///
    /// ```
    /// use tilesat::Vec2;
    /// let (aim, enemy) = (Vec2::from_raw(4, 0), Vec2::from_raw(1, 3));
    /// assert_eq!((aim.dot(enemy), aim.perp_dot(enemy)), (4, 12)); // ahead, and toward +y
    /// ```
    #[must_use]
    #[doc(alias = "cross")]
    pub const fn perp_dot(self, rhs: Self) -> i64 {
        imul(self.x.to_bits(), rhs.y.to_bits()).wrapping_sub(imul(self.y.to_bits(), rhs.x.to_bits()))
    }

    /// The square of the length in square raw units, unlike glam's; exact.
    #[must_use]
    pub const fn length_squared(self) -> u64 {
        let (x, y) = self.raw();
        super::usqr(x.unsigned_abs()).wrapping_add(super::usqr(y.unsigned_abs()))
    }

    /// The length, rounded down to a raw unit; saturates above 32 767 units.
    ///
    /// Cost: one square root, about 300 instructions on a Cortex-M0.
    #[must_use]
    #[doc(alias = "magnitude")]
    pub const fn length(self) -> Fx {
        let root = super::isqrt64(self.length_squared());
        Fx::from_bits(if root > i32::MAX as u32 { i32::MAX } else { root as i32 })
    }

    /// `self + rhs`, each component saturating; as `+`, usable in constants.
    #[must_use]
    pub const fn saturating_add(self, rhs: Self) -> Self {
        Self { x: self.x.saturating_add(rhs.x), y: self.y.saturating_add(rhs.y) }
    }

    /// `self - rhs`, each component saturating; as `-`, usable in constants.
    #[must_use]
    pub const fn saturating_sub(self, rhs: Self) -> Self {
        Self { x: self.x.saturating_sub(rhs.x), y: self.y.saturating_sub(rhs.y) }
    }

    /// `self * factor`, each component rounded toward zero and saturating; as `*`, usable in
    /// constants.
    ///
    /// ```
    /// use tilesat::{Fx, Vec2, fx};
    /// const THROW: Vec2 = Vec2::from_ints(3, -4).saturating_mul(fx!(1.5));
    /// assert_eq!(THROW, Vec2::new(fx!(4.5), fx!(-6)));
    /// assert_eq!(Vec2::from_ints(30000, 0).saturating_mul(fx!(2)).x, Fx::MAX);
    /// ```
    #[must_use]
    pub const fn saturating_mul(self, factor: Fx) -> Self {
        let (x, y) = self.raw();
        Self::from_raw(saturated(product(x, factor)), saturated(product(y, factor)))
    }

    /// `self / divisor`, each component rounded toward zero and saturating; as `/`, usable in
    /// constants.
    ///
    /// Division by zero saturates as well: toward the sign of the component, and zero stays zero.
    #[must_use]
    pub const fn saturating_div(self, divisor: Fx) -> Self {
        let (x, y) = self.raw();
        Self::from_raw(saturated(quotient(x, divisor)), saturated(quotient(y, divisor)))
    }

    /// `self + rhs`; `None` if a component does not fit 16.16.
    ///
    /// ```
    /// use tilesat::Vec2;
    /// let (far, step) = (Vec2::from_ints(32_000, 0), Vec2::from_ints(1_000, 5));
    /// assert_eq!(far.checked_add(step), None); // `far + step` saturates
    /// assert_eq!(far.checked_sub(step), Some(Vec2::from_ints(31_000, -5)));
    /// ```
    #[must_use]
    pub const fn checked_add(self, rhs: Self) -> Option<Self> {
        both(self.x.checked_add(rhs.x), self.y.checked_add(rhs.y))
    }

    /// `self - rhs`; `None` if a component does not fit 16.16.
    #[must_use]
    pub const fn checked_sub(self, rhs: Self) -> Option<Self> {
        both(self.x.checked_sub(rhs.x), self.y.checked_sub(rhs.y))
    }

    /// `self * factor`, each component rounded toward zero; `None` if one does not fit 16.16.
    ///
    /// ```
    /// use tilesat::{Vec2, fx};
    /// assert_eq!(Vec2::from_ints(3, -4).checked_mul(fx!(0.5)), Some(Vec2::new(fx!(1.5), fx!(-2))));
    /// assert_eq!(Vec2::from_ints(300, 0).checked_mul(fx!(300)), None);
    /// ```
    #[must_use]
    pub const fn checked_mul(self, factor: Fx) -> Option<Self> {
        let (x, y) = self.raw();
        both(fitting(product(x, factor)), fitting(product(y, factor)))
    }

    /// `self / divisor`, each component rounded toward zero; `None` if one does not fit 16.16,
    /// or the divisor is zero.
    ///
    /// ```
    /// use tilesat::{Fx, Vec2, fx};
    /// let way = Vec2::from_ints(30, -9);
    /// assert_eq!(way.checked_div(fx!(12)), Some(Vec2::new(fx!(2.5), fx!(-0.75)))); // per frame, in 12 frames
    /// assert_eq!(way.checked_div(Fx::ZERO), None);
    /// ```
    #[must_use]
    pub const fn checked_div(self, divisor: Fx) -> Option<Self> {
        if divisor.to_bits() == 0 {
            return None;
        }
        let (x, y) = self.raw();
        both(fitting(quotient(x, divisor)), fitting(quotient(y, divisor)))
    }
}

/// Sign and size of a product. The size is below 2^46; what exceeds a word is cut to all ones,
/// which fits no component.
const fn product(component: i32, factor: Fx) -> (bool, u32) {
    let factor = factor.to_bits();
    let size = umul(component.unsigned_abs(), factor.unsigned_abs()) >> 16;
    ((component < 0) != (factor < 0), if size > u32::MAX as u64 { u32::MAX } else { size as u32 })
}

/// Sign and size of a quotient, all ones where it exceeds a word or the divisor is zero.
const fn quotient(component: i32, divisor: Fx) -> (bool, u32) {
    let divisor = divisor.to_bits();
    let size = if component == 0 { 0 } else { mul_div(component.unsigned_abs(), 1 << 16, divisor.unsigned_abs()) };
    ((component < 0) != (divisor < 0), size)
}

const fn fitting((negative, size): (bool, u32)) -> Option<Fx> {
    let value = if negative { 0i32.checked_sub_unsigned(size) } else { 0i32.checked_add_unsigned(size) };
    match value {
        Some(value) => Some(Fx::from_bits(value)),
        None => None,
    }
}

const fn saturated((negative, size): (bool, u32)) -> i32 {
    if negative { 0i32.saturating_sub_unsigned(size) } else { 0i32.saturating_add_unsigned(size) }
}

const fn both(x: Option<Fx>, y: Option<Fx>) -> Option<Vec2> {
    match (x, y) {
        (Some(x), Some(y)) => Some(Vec2 { x, y }),
        _ => None,
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
        self.saturating_sub(rhs)
    }
}

impl Mul<Fx> for Vec2 {
    type Output = Self;
    fn mul(self, factor: Fx) -> Self {
        self.saturating_mul(factor)
    }
}

impl Div<Fx> for Vec2 {
    type Output = Self;
    fn div(self, divisor: Fx) -> Self {
        self.saturating_div(divisor)
    }
}

/// Exact, or saturates.
impl Mul<i32> for Vec2 {
    type Output = Self;
    fn mul(self, factor: i32) -> Self {
        let (x, y) = self.raw();
        Self::from_raw(x.saturating_mul(factor), y.saturating_mul(factor))
    }
}

/// Rounded toward zero; division by zero as in [`saturating_div`](Vec2::saturating_div).
impl Div<i32> for Vec2 {
    type Output = Self;
    fn div(self, divisor: i32) -> Self {
        if divisor == 0 {
            return self.saturating_div(Fx::ZERO);
        }
        let part = |v: i32| v.checked_div(divisor).unwrap_or(i32::MAX); // i32::MIN / -1
        let (x, y) = self.raw();
        Self::from_raw(part(x), part(y))
    }
}

impl Mul<Vec2> for Fx {
    type Output = Vec2;
    fn mul(self, rhs: Vec2) -> Vec2 {
        rhs * self
    }
}

impl Mul<Vec2> for i32 {
    type Output = Vec2;
    fn mul(self, rhs: Vec2) -> Vec2 {
        rhs * self
    }
}

macro_rules! assigned {
    ($($Trait:ident<$Rhs:ty> $method:ident $operator:tt),+) => {
        $(impl $Trait<$Rhs> for Vec2 {
            fn $method(&mut self, rhs: $Rhs) {
                *self = *self $operator rhs;
            }
        })+
    };
}
assigned! {
    AddAssign<Self> add_assign +, SubAssign<Self> sub_assign -,
    MulAssign<Fx> mul_assign *, DivAssign<Fx> div_assign /, MulAssign<i32> mul_assign *, DivAssign<i32> div_assign /
}

impl Neg for Vec2 {
    type Output = Self;
    fn neg(self) -> Self {
        Self { x: self.x.saturating_neg(), y: self.y.saturating_neg() }
    }
}

/// The options for width, precision and sign apply to each component, as with a tuple.
///
/// ```
/// let v = tilesat::Vec2::from_ints(1, -2);
/// assert_eq!(format!("{v}, {v:.2}, {v:4.1}"), "(1, -2), (1.00, -2.00), ( 1.0, -2.0)");
/// ```
impl core::fmt::Display for Vec2 {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        for (before, component) in [("(", self.x), (", ", self.y)] {
            f.write_str(before).and_then(|()| component.fmt(f))?;
        }
        f.write_str(")")
    }
}

impl From<(Fx, Fx)> for Vec2 {
    fn from((x, y): (Fx, Fx)) -> Self {
        Self { x, y }
    }
}

/// A vector of whole units; exact.
impl From<(i16, i16)> for Vec2 {
    fn from((x, y): (i16, i16)) -> Self {
        Self::from_ints(x, y)
    }
}

/// A vector of whole units.
///
/// It fails if one does not fit 16.16 (-32 768 to 32 767). The value of the error is then the end
/// of the range that it exceeds.
///
/// ```
/// use tilesat::{Quantity, Vec2};
/// let at = |x: i32, y: i32| Vec2::try_from((x, y));
/// assert_eq!(at(3, -4), Ok(Vec2::from_ints(3, -4)));
/// let error = at(70_000, 0).unwrap_err(); // `70_000_i32 as i16` is 4464
/// assert!(error.what == Quantity::X && error.to_string().starts_with("X does not fit"));
/// ```
impl TryFrom<(i32, i32)> for Vec2 {
    type Error = RangeError;
    fn try_from((x, y): (i32, i32)) -> Result<Self, RangeError> {
        let fx = |v: i32, what| {
            let whole =
                i16::try_from(v).map_err(|_| RangeError { what, value: if v < 0 { i32::MIN } else { i32::MAX } });
            whole.map(Fx::from_num)
        };
        Ok(Self { x: fx(x, Quantity::X)?, y: fx(y, Quantity::Y)? })
    }
}

impl From<[Fx; 2]> for Vec2 {
    fn from([x, y]: [Fx; 2]) -> Self {
        Self { x, y }
    }
}

impl From<Vec2> for (Fx, Fx) {
    fn from(v: Vec2) -> Self {
        (v.x, v.y)
    }
}

impl From<Vec2> for [Fx; 2] {
    fn from(v: Vec2) -> Self {
        [v.x, v.y]
    }
}
