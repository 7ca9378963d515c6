//! Ratios of game rules: friction, restitution, drag, shares of a push.

use super::{mul_div, mul64, umul};

/// A number from 0 to 1 in steps of 2^-30: friction, restitution, drag, or who takes which share of a push.
///
/// `new` rounds to the nearest step, so a ratio is off by at most 2^-31; 0, 1 and fractions of powers of two are exact, and
/// `new(a, c)` and `new(b, c)` with a + b = c < 2^31 are each other's [`complement`](Self::complement). What a ratio is *of* is rounded toward zero, the
/// same for both signs.
///
/// ```
/// use tilesat::{Fx, Ratio};
/// const GRIP: Ratio = Ratio::percent(30).unwrap();
/// assert_eq!(GRIP, Ratio::new(3, 10).unwrap());
/// assert_eq!(Ratio::HALF.of(Fx::from_bits(-7)).to_bits(), -3);
/// assert_eq!(Ratio::new(1, 3).unwrap().complement(), Ratio::new(2, 3).unwrap());
/// assert_eq!((Ratio::new(4, 3), Ratio::new(0, 0)), (None, None));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Ratio(u32);

impl Ratio {
    /// Nothing.
    pub const ZERO: Self = Self(0);
    /// One half; exact.
    pub const HALF: Self = Self(1 << 29);
    /// The whole; exact.
    pub const ONE: Self = Self(1 << 30);

    /// `num / den` to nearest, halves up; `None` above one, or where `den` is zero.
    ///
    /// Cost: no division instruction, some 200 instructions on a Cortex-M0; none in a constant.
    #[must_use]
    pub const fn new(num: u32, den: u32) -> Option<Self> {
        if den == 0 || num > den {
            return None;
        }
        let floor = mul_div(num, Self::ONE.0, den);
        let rest = umul(num, Self::ONE.0).wrapping_sub(umul(floor, den));
        Some(Self(floor.wrapping_add((rest >= den as u64 - rest) as u32)))
    }

    /// Hundredths, to nearest; `None` above 100.
    #[must_use]
    pub const fn percent(hundredths: u8) -> Option<Self> {
        Self::new(hundredths as u32, 100)
    }

    /// From parts in 2^30; `None` above one.
    #[must_use]
    pub const fn from_raw(raw: u32) -> Option<Self> {
        if raw <= Self::ONE.0 { Some(Self(raw)) } else { None }
    }

    /// In parts of 2^30.
    #[must_use]
    pub const fn raw(self) -> u32 {
        self.0
    }

    /// One less this; exact.
    #[must_use]
    pub const fn complement(self) -> Self {
        Self(Self::ONE.0 - self.0)
    }

    /// This part of a length, rounded toward zero.
    #[must_use]
    pub const fn of(self, length: super::Fx) -> super::Fx {
        super::Fx::from_bits(self.of_raw(length.to_bits()))
    }

    /// This part of a raw number, rounded toward zero.
    pub(crate) const fn of_raw(self, d: i32) -> i32 {
        let part = (umul(d.unsigned_abs(), self.0) >> 30) as i32;
        if d < 0 { part.wrapping_neg() } else { part }
    }

    /// This part of a raw number, rounded away from zero.
    pub(crate) const fn of_raw_up(self, d: i32) -> i32 {
        let part = (umul(d.unsigned_abs(), self.0).wrapping_add(Self::ONE.0 as u64 - 1) >> 30) as i32;
        if d < 0 { part.wrapping_neg() } else { part }
    }

    /// This part of a wide number, rounded down.
    pub(crate) const fn of_wide(self, n: u64) -> u64 {
        let (hi, lo) = mul64(n, self.0 as u64);
        (hi << 34) | (lo >> 30)
    }

    /// This part of a wide number, rounded up.
    pub(crate) const fn of_wide_up(self, n: u64) -> u64 {
        let short = n.wrapping_mul(self.0 as u64) & (Self::ONE.0 as u64 - 1) != 0;
        self.of_wide(n).wrapping_add(short as u64)
    }
}
