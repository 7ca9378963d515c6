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

#[cfg(test)]
mod tests {
    use super::Ratio;

    /// 0, powers of two and what is beside them, and all ones.
    fn near_powers(bits: u32) -> impl Iterator<Item = u64> {
        (0..bits).flat_map(|k| [(1 << k) - 1, 1 << k, (1u64 << k).wrapping_add(1)]).chain([u64::MAX >> (64 - bits)])
    }

    #[test]
    fn parts_are_rounded_to_their_sides() {
        let one = u128::from(Ratio::ONE.raw());
        for raw in near_powers(31).filter(|&raw| u128::from(raw) <= one).chain([1_000_000_007, 333_333_333]) {
            let ratio = Ratio(raw as u32);
            for n in near_powers(64).chain([0x1234_5678_9abc_def0]) {
                let (product, d) = (u128::from(n) * u128::from(raw), n as i32);
                assert_eq!(u128::from(ratio.of_wide(n)), product / one, "{n} {raw}");
                assert_eq!(u128::from(ratio.of_wide_up(n)), product.div_ceil(one), "{n} {raw}");
                let size = (u128::from(d.unsigned_abs()) * u128::from(raw)).div_ceil(one) as i32;
                assert_eq!(ratio.of_raw_up(d), if d < 0 { size.wrapping_neg() } else { size }, "{d} {raw}");
            }
        }
    }
}
