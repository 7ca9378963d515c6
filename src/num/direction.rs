//! Directions: two integers, always exact, or a vector of length one; and vectors of a given
//! length, rounded to the nearest lattice point.

use super::quotient::{leading_zeros32, rsqrt};
use super::{Fx, Raw, Vec2, div_sqrt, imul, mul_div_wide, umul, usqr};
use core::ops::Neg;
use fixed::types::I2F30;

/// An exact direction: two integers at any common scale.
///
/// Normals have this type, because a unit vector cannot be exact. `(1, 2)` is the direction of a
/// slope, but no fixed-point vector is exactly `(1, 2) / sqrt(5)`. Call [`Axis::unit`] if you need
/// the rounded unit vector.
///
/// Keep both components above `i32::MIN`, which has no opposite. [`perp`](Self::perp) and
/// [`reversed`](Self::reversed) leave it unchanged. [`OrientedBox::new`](crate::OrientedBox::new)
/// refuses such a direction. [`Mover::platformer`](crate::Mover::platformer) uses `-i32::MAX`
/// instead. Products, [`unit`](Self::unit) and the functions of
/// [`response`](crate::motion::response) need no opposite.
///
/// ```
/// use tilesat::Axis;
/// let slope = Axis::new(1, 2);
/// assert_eq!(slope.perp(), Axis::new(-2, 1));
/// assert_eq!(slope.unit().raw(), (480_191_942, 960_383_884));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias("normal", "direction"))]
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
    /// Against y: up on a screen.
    pub const NEG_Y: Self = Self::new(0, -1);

    /// A direction from its components.
    #[must_use]
    pub const fn new(x: i32, y: i32) -> Self {
        Self { x, y }
    }

    /// The direction of a vector, exact; as `Axis::from`, usable in constants.
    ///
    /// The zero vector gives the zero axis, and a component of `Fx::MIN` one without an opposite.
    ///
    /// ```
    /// use tilesat::{Axis, Vec2, fx};
    /// let aim = Axis::of(Vec2::from_ints(45, 19) - Vec2::from_ints(75, 59));
    /// assert_eq!(aim, Axis::new(-30 << 16, -40 << 16));
    /// assert!(aim.perp_dot(Axis::X) > 0);
    /// ```
    #[must_use]
    pub const fn of(v: Vec2) -> Self {
        let (x, y) = v.raw();
        Self::new(x, y)
    }

    /// The dot product; exact, unless all four components are `i32::MIN`.
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

    /// The perpendicular dot product `x1 y2 - y1 x2`; exact.
    ///
    /// ```
    /// use tilesat::Axis;
    /// assert!(Axis::X.perp_dot(Axis::Y) > 0 && Axis::X.perp_dot(Axis::Y.reversed()) < 0);
    /// ```
    #[must_use]
    #[doc(alias = "cross")]
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
        self.dot(Self::of(v))
    }

    /// How fast a velocity points against this direction: the speed at which a body hits a surface
    /// with this normal.
    ///
    /// It is zero if the velocity points along the surface or away from it. It is rounded to
    /// nearest, half a raw unit up, and exact along x and y. Speeds of 2^30 raw and more, which no
    /// motion has, give `Fx::MAX`.
    ///
    /// ```
    /// use tilesat::{Axis, Fx, Vec2};
    /// let falls = Vec2::from_ints(3, 4);
    /// assert_eq!(Axis::NEG_Y.approach(falls), Fx::from_num(4));
    /// assert_eq!(Axis::new(-3, -4).approach(falls), Fx::from_num(5));
    /// assert_eq!(Axis::Y.approach(falls), Fx::ZERO);
    /// ```
    #[must_use]
    pub const fn approach(self, velocity: Vec2) -> Fx {
        let along = self.dot_vec(velocity);
        if along >= 0 {
            return Fx::ZERO;
        }
        // For a normal of 1, as at blocks, the quotient is the product.
        let against = along.unsigned_abs();
        let speed = match self.length_squared() {
            1 => against,
            square => {
                let twice = div_sqrt(against << 1, square) as u64;
                (twice + 1) >> 1
            }
        };
        Fx::from_bits(if speed < 1 << 30 { speed as i32 } else { i32::MAX })
    }

    /// This direction turned by a right angle: `(-y, x)`.
    ///
    /// `y` must be above `i32::MIN`.
    #[must_use]
    pub const fn perp(self) -> Self {
        Self::new(self.y.wrapping_neg(), self.x)
    }

    /// The opposite direction.
    ///
    /// The components must be above `i32::MIN`.
    #[must_use]
    pub const fn reversed(self) -> Self {
        Self::new(self.x.wrapping_neg(), self.y.wrapping_neg())
    }

    /// Whether no component is `i32::MIN`, which has no opposite.
    pub(crate) const fn has_opposite(self) -> bool {
        self.x != i32::MIN && self.y != i32::MIN
    }

    /// The nearest axis that [has an opposite](Self::has_opposite).
    pub(crate) const fn with_opposite(self) -> Self {
        // `i32::MIN` saturates to `i32::MAX`, and comes back as the opposite of that.
        Self::new(self.x.saturating_neg().wrapping_neg(), self.y.saturating_neg().wrapping_neg())
    }

    /// Whether both components are zero.
    ///
    /// This crate never returns such an axis.
    #[must_use]
    pub const fn is_zero(self) -> bool {
        self.x == 0 && self.y == 0
    }

    /// The unit vector of this direction.
    ///
    /// Each component is within 1.5 * 2^-30 of the exact value. The zero axis gives +x. Mirrored
    /// axes give mirrored bits. Axes along x or y are exact. Cost: one reciprocal root and no
    /// division, about 250 instructions on a Cortex-M0.
    ///
    /// ```
    /// use tilesat::{Axis, Vec2, fx};
    /// assert_eq!(Axis::new(0, -3).unit().scaled(fx!(1.5)), Vec2::new(fx!(0), fx!(-1.5)));
    /// ```
    #[must_use]
    pub const fn unit(self) -> UnitVec2 {
        unit_nearest(self)
    }

    /// The square of the length; exact.
    #[must_use]
    pub const fn length_squared(self) -> u64 {
        super::norm(self.x, self.y)
    }
}

/// The product of two words, the first of which is often 1 or -1.
#[inline]
const fn times(a: i32, b: i32) -> i64 {
    match a {
        1 => b as i64,
        -1 => (b as i64).wrapping_neg(),
        _ => imul(a, b),
    }
}

/// The direction of a vector, exact: [`Axis::of`].
impl From<Vec2> for Axis {
    fn from(v: Vec2) -> Self {
        Self::of(v)
    }
}

impl Neg for Axis {
    type Output = Self;
    fn neg(self) -> Self {
        self.reversed()
    }
}

/// A direction of length one, rounded: signed 2.30 components.
///
/// Each component is within 1.5 * 2^-30 of the exact value, so the length is within 3 parts in
/// 10^9 of one. Directions along x and y are exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias("normalized", "unit vector"))]
pub struct UnitVec2 {
    x: I2F30,
    y: I2F30,
}

impl UnitVec2 {
    /// To the right.
    pub const X: Self = Self::from_raw(1 << 30, 0);

    pub(crate) const fn from_raw(x: i32, y: i32) -> Self {
        Self { x: I2F30::from_bits(x), y: I2F30::from_bits(y) }
    }

    /// The unit vector of an axis of length one along x or y.
    #[inline(always)]
    pub(crate) const fn along(axis: Axis) -> Self {
        Self::from_raw(axis.x.wrapping_mul(1 << 30), axis.y.wrapping_mul(1 << 30))
    }

    /// Its components in one word, x in the low half.
    pub(crate) const fn packed(self) -> u64 {
        self.x.to_bits() as u32 as u64 | (self.y.to_bits() as u32 as u64) << 32
    }

    /// From its components in one word.
    #[inline(always)]
    pub(crate) const fn unpacked(both: u64) -> Self {
        Self::from_raw(both as i32, (both >> 32) as i32)
    }

    /// Horizontal component, in `-1..=1`.
    #[must_use]
    pub const fn x(self) -> I2F30 {
        self.x
    }

    /// Vertical component, in `-1..=1`.
    #[must_use]
    pub const fn y(self) -> I2F30 {
        self.y
    }

    /// The bits of the two components: 2^30 is one.
    #[must_use]
    pub const fn raw(self) -> (i32, i32) {
        (self.x.to_bits(), self.y.to_bits())
    }

    /// Both components as floating point, for drawing: rounded to nearest, ties to even.
    ///
    /// The components are in `-1.0..=1.0`. An `f32` has 24 bits, so each is within 2^-25 of the
    /// fixed-point one. It cannot fail.
    ///
    /// ```
    /// use tilesat::Axis;
    /// assert_eq!(Axis::new(0, -3).unit().to_f32(), (0.0, -1.0));
    /// assert_eq!(Axis::new(3, 4).unit().to_f32(), (0.6, 0.8));
    /// ```
    #[must_use]
    pub fn to_f32(self) -> (f32, f32) {
        (self.x.to_num(), self.y.to_num())
    }

    /// The vector with this direction and the given length, each component rounded toward zero.
    ///
    /// A negative length reverses it. It exceeds the length by less than a raw unit. Mirrored
    /// directions give mirrored bits. Cost: two products, no division.
    ///
    /// ```
    /// use tilesat::{Axis, Fx, Vec2, fx};
    /// assert_eq!(Axis::new(3, -4).unit().scaled(fx!(10)), Vec2::from_raw((6 << 16) - 1, -(8 << 16) + 1));
    /// assert_eq!(Axis::NEG_X.unit().scaled(fx!(2.5)), Vec2::new(fx!(-2.5), Fx::ZERO));
    /// ```
    #[must_use]
    pub const fn scaled(self, length: Fx) -> Vec2 {
        let (x, y) = self.raw();
        Vec2::from_raw(part(x, length.to_bits()), part(y, length.to_bits()))
    }
}

/// `unit * length / 2^30`, rounded toward zero. |unit| is at most 2^30, so the result is at most as
/// large as the length. A positive 2^31 saturates.
const fn part(unit: i32, length: i32) -> i32 {
    let size = (umul(unit.unsigned_abs(), length.unsigned_abs()) >> 30) as u32;
    if (unit < 0) != (length < 0) {
        (size as i32).wrapping_neg()
    } else if size > i32::MAX as u32 {
        i32::MAX
    } else {
        size as i32
    }
}

/// The magnitudes of an axis scaled up together, and the reciprocal of their length.
pub(super) struct Normalised {
    pub(super) x: u32,
    pub(super) y: u32,
    /// Component / length in Q32 (Q33 where `halve` is set) is component * recip / 2^32.
    pub(super) recip: u32,
    pub(super) halve: bool,
}

/// Needs a nonzero axis. Inlined: as a call it costs 20 instructions more on a Cortex-M0, a
/// fourteenth of the whole.
#[inline(always)]
const fn normalise(axis: Axis) -> Normalised {
    let (x, y) = (axis.x.unsigned_abs(), axis.y.unsigned_abs());
    // The larger magnitude goes to [2^30, 2^31); 2^31 itself (i32::MIN) is halved, which keeps the
    // direction to 2^-31.
    let zeros = leading_zeros32(x | y);
    let (x, y) = if zeros == 0 { (x >> 1, y >> 1) } else { (x << (zeros - 1), y << (zeros - 1)) };
    let square = usqr(x).wrapping_add(usqr(y));
    // square is in [2^60, 2^63): a shift by 0 or 2 brings its top word into [2^30, 2^32). With h
    // that word, 1/sqrt(square) = recip / 2^63, or recip / 2^62 after the shift (recip = 2^47 /
    // sqrt h). In words, because a shift of a double word by one of two distances is compiled as
    // one by a variable.
    let (hi, lo) = ((square >> 32) as u32, square as u32);
    let halve = hi >> 30 != 0;
    let h = if halve { hi } else { (hi << 2) | (lo >> 30) };
    Normalised { x, y, recip: rsqrt(h), halve }
}

/// The unit vector, both components rounded to nearest. The root's error adds up to one unit to the
/// half unit of rounding.
#[inline(never)]
pub(super) const fn unit_nearest(axis: Axis) -> UnitVec2 {
    if axis.y == 0 {
        return UnitVec2::from_raw(if axis.x < 0 { -(1 << 30) } else { 1 << 30 }, 0);
    }
    if axis.x == 0 {
        return UnitVec2::from_raw(0, if axis.y < 0 { -(1 << 30) } else { 1 << 30 });
    }
    let n = normalise(axis);
    let (x, y) = (n.nearest(n.x) as i32, n.nearest(n.y) as i32);
    UnitVec2::from_raw(if axis.x < 0 { -x } else { x }, if axis.y < 0 { -y } else { y })
}

/// The magnitudes of the unit vector in Q30, never below the exact ones and at most 3 units above.
#[inline(never)]
pub(crate) const fn unit_ceil(axis: Axis) -> (u32, u32) {
    let n = normalise(axis);
    (n.ceil(n.x), n.ceil(n.y))
}

impl Normalised {
    /// `component * recip` shifted right by 32 or 33, to nearest. In words: a shift of a double
    /// word by a variable is a call on `ARMv6-M`.
    #[inline]
    pub(super) const fn nearest(&self, component: u32) -> u32 {
        let product = umul(component, self.recip);
        let hi = (product >> 32) as u32;
        if self.halve { (hi + 1) >> 1 } else { hi + (product as u32 >> 31) }
    }

    /// An upper bound of the shifted product with the exact reciprocal, at most 3 units above it.
    ///
    /// `recip` is at most 1.53 below the exact reciprocal; dropping the square's low bits only
    /// raised it. The component is below 2^31, so the shifted product loses less than 1 by that.
    /// The exact product is therefore below `hi + 2`, and half of it is at most `(hi + 3) >> 1`.
    #[inline]
    const fn ceil(&self, component: u32) -> u32 {
        let hi = (umul(component, self.recip) >> 32) as u32;
        if self.halve { (hi + 3) >> 1 } else { hi + 2 }
    }
}

/// `n * s / d` to nearest, halves toward zero; for `|s| < 2^63`, `d > 0` below 2^63 and a result
/// below 2^32 in size.
///
/// The result is taken modulo 2^32: it may be added to a coordinate that is farther away than an
/// `i32` says.
pub(crate) const fn scaled(n: i32, s: i64, d: u64) -> i32 {
    let (k, a) = (n.unsigned_abs(), s.unsigned_abs());
    let floor = mul_div_wide(a, k, d);
    // The remainder is below d, so its low 64 bits are all of it.
    let rest = a.wrapping_mul(k as u64).wrapping_sub(d.wrapping_mul(floor as u64));
    let nearest = floor.wrapping_add((rest > d.wrapping_sub(rest)) as u32) as i32;
    if (n < 0) == (s < 0) { nearest } else { nearest.wrapping_neg() }
}

/// `v r / |v|` to nearest, for one magnitude `v` of a vector with the square `d > 0`, and a radius
/// `r` below 2^29.
///
/// There are no halves: 2 v r / |v| is odd for no integers, because a primitive Pythagorean triple
/// has an odd hypotenuse.
pub(crate) const fn on_circle(v: u32, r: u32, d: u64) -> u32 {
    // 2x + 1 rounded down and halved is x to nearest; |v| <= 2^32 and r < 2^29 keep the product
    // below 2^63.
    div_sqrt(umul(v, r) << 1, d).wrapping_add(1) >> 1
}

/// [`on_circle`] for both components of a difference inside the domain that is not zero.
pub(crate) const fn toward(v: Raw, r: i32) -> Raw {
    let d = v.len2();
    let (x, y) = (on_circle(v.x.unsigned_abs(), r as u32, d) as i32, on_circle(v.y.unsigned_abs(), r as u32, d) as i32);
    Raw { x: if v.x < 0 { x.wrapping_neg() } else { x }, y: if v.y < 0 { y.wrapping_neg() } else { y } }
}
