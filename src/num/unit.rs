//! Directions of length one.

use super::root::{leading_zeros32, rsqrt};
use super::{Axis, Fx, Vec2, umul, usqr};
use fixed::types::I2F30;

/// A direction of length one, rounded: signed 2.30 components.
///
/// Each component is within 1.5 raw (2^-30) of the exact value, so the length is within 3 parts in 10^9 of one.
/// Parallels to x and y are exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct UnitVec2 {
    x: I2F30,
    y: I2F30,
}

impl UnitVec2 {
    /// To the right.
    pub const X: Self = Self::from_raw(1 << 30, 0);

    const fn from_raw(x: i32, y: i32) -> Self {
        Self { x: I2F30::from_bits(x), y: I2F30::from_bits(y) }
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

    /// The bits of both components: 2^30 is one.
    #[must_use]
    pub const fn raw(self) -> (i32, i32) {
        (self.x.to_bits(), self.y.to_bits())
    }

    /// A vector of this direction and a length, each component rounded toward zero; a negative length reverses it.
    ///
    /// Never longer than asked by a raw unit or more, and mirrored directions give mirrored bits. Cost: two products, no division.
    ///
    /// ```
    /// use tilesat::{Axis, Fx, Vec2};
    /// assert_eq!(Axis::new(3, -4).unit().scaled(Fx::lit("10")), Vec2::from_raw((6 << 16) - 1, -(8 << 16) + 1));
    /// assert_eq!(Axis::NEG_X.unit().scaled(Fx::lit("2.5")), Vec2::new(Fx::lit("-2.5"), Fx::ZERO));
    /// ```
    #[must_use]
    pub const fn scaled(self, length: Fx) -> Vec2 {
        let (x, y) = self.raw();
        Vec2::from_raw(part(x, length.to_bits()), part(y, length.to_bits()))
    }
}

/// `unit * length / 2^30`, toward zero: |unit| is at most 2^30, so it is as large as the length at most, 2^31; that saturates where it is positive.
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
struct Normalised {
    x: u32,
    y: u32,
    /// Component / length in Q32 (Q33 where `halve` is set) is component * recip / 2^32.
    recip: u32,
    halve: bool,
}

/// Needs a nonzero axis. Inlined: as a call it costs 20 instructions more on a Cortex-M0, a fourteenth of the whole.
#[inline(always)]
const fn normalise(axis: Axis) -> Normalised {
    let (x, y) = (axis.x.unsigned_abs(), axis.y.unsigned_abs());
    // The larger magnitude goes to [2^30, 2^31); 2^31 itself (i32::MIN) is halved, which keeps the direction to 2^-31.
    let zeros = leading_zeros32(x | y);
    let (x, y) = if zeros == 0 { (x >> 1, y >> 1) } else { (x << (zeros - 1), y << (zeros - 1)) };
    let square = usqr(x).wrapping_add(usqr(y));
    // square is in [2^60, 2^63): a shift by 0 or 2 brings its top word into [2^30, 2^32). With h that word,
    // 1/sqrt(square) = recip / 2^63, or recip / 2^62 after the shift (recip = 2^47 / sqrt h).
    // In words, because a shift of a double word by one of two distances is compiled as one by a variable.
    let (hi, lo) = ((square >> 32) as u32, square as u32);
    let halve = hi >> 30 != 0;
    let h = if halve { hi } else { (hi << 2) | (lo >> 30) };
    Normalised { x, y, recip: rsqrt(h), halve }
}

/// Both components rounded to nearest; the root's error adds up to one unit to the half of rounding.
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
    /// `component * recip` shifted right by 32 or 33, to nearest. In words: a shift of a double word by a variable is a call on `ARMv6-M`.
    #[inline]
    const fn nearest(&self, component: u32) -> u32 {
        let product = umul(component, self.recip);
        let hi = (product >> 32) as u32;
        if self.halve { (hi + 1) >> 1 } else { hi + (product as u32 >> 31) }
    }

    /// An upper bound of the same with the exact reciprocal, at most 3 units above it.
    ///
    /// recip is at most 1.53 below the exact one (dropping the square's low bits only raised it), which is less than 2^32 / 2^31
    /// here: the exact product is below `hi + 2`, so half of it is at most `(hi + 3) >> 1`.
    #[inline]
    const fn ceil(&self, component: u32) -> u32 {
        let hi = (umul(component, self.recip) >> 32) as u32;
        if self.halve { (hi + 3) >> 1 } else { hi + 2 }
    }
}

#[cfg(test)]
mod tests {
    use super::Normalised;

    #[test]
    fn products_are_rounded_to_nearest() {
        for recip in [1 << 31, (1 << 31) + 1, 0xb504_f333, 0xdead_beef, u32::MAX] {
            for component in [1, 2, 3, 4, 5, 0x4000_0001, 0x5a82_799a, 0x7fff_ffff] {
                let product = u64::from(component) * u64::from(recip);
                for halve in [false, true] {
                    let got = Normalised { x: 0, y: 0, recip, halve }.nearest(component);
                    let shift = 32 + u32::from(halve);
                    assert_eq!(u64::from(got), (product + (1 << (shift - 1))) >> shift, "{component} {recip} {halve}");
                }
            }
        }
    }
}
