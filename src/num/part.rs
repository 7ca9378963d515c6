//! Fractions from 0 to 1 in steps of 2^-30: parts of a motion, and shares.

use super::{Fx, LONG, Raw, SPLIT, Vec2, mul_div, mul64, umul};

/// A fraction of a motion: 0 at its start, 1 at its end, in steps of 2^-30.
///
/// Rounded down: a body that moves by it is never late.
///
/// ```
/// use tilesat::Toi;
/// assert_eq!(Toi::ONE.to_fx(), 1);
/// assert!(Toi::from_raw(1 << 29).unwrap() < Toi::ONE);
/// assert_eq!(Toi::from_raw((1 << 30) + 1), None);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[doc(alias("TOI", "time of impact", "fraction"))]
pub struct Toi(u32);

impl Toi {
    /// The start of the motion.
    pub const ZERO: Self = Self(0);
    /// The end of the motion.
    pub const ONE: Self = Self(1 << 30);

    /// From parts in 2^30; `None` above one.
    #[must_use]
    pub const fn from_raw(raw: u32) -> Option<Self> {
        if raw <= Self::ONE.0 { Some(Self(raw)) } else { None }
    }

    /// From parts in 2^30 that are at most one by construction.
    pub(crate) const fn exact(raw: u32) -> Self {
        Self(raw)
    }

    /// From parts in 2^30 that the caller has bounded.
    pub(crate) const fn clamped(raw: u32) -> Self {
        Self(if raw < Self::ONE.0 { raw } else { Self::ONE.0 })
    }

    /// In parts of 2^30.
    #[must_use]
    pub const fn raw(self) -> u32 {
        self.0
    }

    /// As 16.16, rounded down.
    #[must_use]
    pub const fn to_fx(self) -> Fx {
        Fx::from_bits((self.0 >> 14) as i32)
    }

    /// This fraction as floating point, for drawing: rounded to nearest, ties to even.
    ///
    /// It is in `0.0..=1.0`, and within 2^-25 of this fraction, because an `f32` has 24 bits. A
    /// fraction just below one may round up to `1.0`. It cannot fail.
    ///
    /// ```
    /// use tilesat::Toi;
    /// let hit = Toi::from_raw(3 << 28).unwrap();
    /// assert_eq!((hit.to_f32(), Toi::ONE.to_f32()), (0.75, 1.0));
    /// ```
    #[must_use]
    pub fn to_f32(self) -> f32 {
        fixed::types::U2F30::from_bits(self.0).to_num()
    }

    /// This fraction of a motion, each component rounded toward zero.
    #[must_use]
    pub const fn of(self, motion: Vec2) -> Vec2 {
        let d = Raw::of(motion);
        Raw { x: self.of_raw(d.x), y: self.of_raw(d.y) }.vec2()
    }

    pub(crate) const fn of_raw(self, d: i32) -> i32 {
        if self.0 == Self::ONE.0 {
            return d;
        }
        let part = (super::umul(d.unsigned_abs(), self.0) >> 30) as i32;
        if d < 0 { part.wrapping_neg() } else { part }
    }

    /// This part of a component `d`, rounded. The sum of `m` and the part is no nearer to zero than
    /// the exact sum if `away` is true, else no farther.
    ///
    /// While the sum is on the side from which `d` comes, rounding toward zero keeps it away. On
    /// zero and beyond, one more unit does.
    #[inline]
    pub(crate) const fn of_raw_beside(self, m: i32, d: i32, away: bool) -> i32 {
        if LONG {
            // For positive sums, away from zero is up; the sum and the part lose the same fraction.
            let part = (d as i64).wrapping_mul(self.0 as i64);
            let sum = ((m as i64) << 30).wrapping_add(part);
            let up = if (sum > 0) == away { (1 << 30) - 1 } else { 0 };
            return (part.wrapping_add(up) >> 30) as i32;
        }
        self.of_words_beside(m, d, away)
    }

    /// The part in 32-bit words. A separate function, because each hit of a corner or an arc calls
    /// it twice.
    #[inline(never)]
    const fn of_words_beside(self, m: i32, d: i32, away: bool) -> i32 {
        let product = super::umul(d.unsigned_abs(), self.0);
        let part = (product >> 30) as i32;
        let part = if d < 0 { part.wrapping_neg() } else { part };
        let at = m.wrapping_add(part);
        let short = product as u32 & (Self::ONE.0 - 1) != 0;
        let outward = at == 0 || (at > 0) == (d > 0);
        if short && outward == away { part.wrapping_add(d.signum()) } else { part }
    }
}

/// A number from 0 to 1 in steps of 2^-30: friction, restitution, drag, or the shares of a push.
///
/// `new` rounds to the nearest step: a ratio is off by at most 2^-31. 0, 1 and fractions of powers
/// of two are exact. `new(a, c)` and `new(b, c)` with a + b = c < 2^31 are each other's
/// [`complement`](Self::complement). A number multiplied by a ratio is rounded toward zero, the
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
    /// Zero; exact.
    pub const ZERO: Self = Self(0);
    /// One half; exact.
    pub const HALF: Self = Self(1 << 29);
    /// The whole; exact.
    pub const ONE: Self = Self(1 << 30);

    /// `num / den`, rounded to nearest, halves up; `None` if it is above one, or `den` is zero.
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

    /// A ratio of `n` hundredths, rounded to nearest; `None` above 100.
    ///
    /// ```
    /// use tilesat::{Ratio, fx};
    /// assert_eq!(Ratio::percent(25).map(|quarter| quarter.of(fx!(8))), Some(fx!(2)));
    /// assert_eq!(Ratio::percent(101), None);
    /// ```
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

    /// One minus this ratio; exact.
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

/// The floor of `num / den` in parts of 2^30, for `0 < num <= den < 2^31`.
#[inline]
pub(crate) fn fraction(num: u32, den: u32) -> u32 {
    if LONG { (u64::from(num) << 30).checked_div(u64::from(den)).unwrap_or(0) as u32 } else { by_digits(num, den) }
}

/// Long division in three digits of ten bits, each from a 16-bit reciprocal that is never too
/// large.
///
/// A digit is short by less than 0.11 before it is floored. The remainder loses its low 15 bits,
/// which adds 2^-5, and so does the divisor. The reciprocal adds 2^10 times 2^-14.4. So the digit
/// is right or one too small, and the remainder, below `2 den`, decides.
#[inline]
pub(super) fn by_digits(num: u32, den: u32) -> u32 {
    let (mut rest, mut den) = (num, den);
    if SPLIT {
        // No instruction counts leading zeros there.
        while den < 1 << 30 {
            den <<= 1;
            rest <<= 1;
        }
    } else {
        let shift = den.leading_zeros().wrapping_sub(1) & 31;
        den <<= shift;
        rest <<= shift;
    }
    // 2^31 / d for d in 2^15..=2^16: the line 48/17 - 32/17 d is off by 1/17 at most, and each step
    // of Newton squares that.
    let d = (den >> 15).wrapping_add(1);
    let r = 92_521u32.wrapping_sub(d.wrapping_mul(61_681) >> 16);
    let e = (1u32 << 31).wrapping_sub(d.wrapping_mul(r)) as i32;
    let r = r.wrapping_add(((r as i32).wrapping_mul(e >> 12) >> 19) as u32);
    let e = (1u32 << 31).wrapping_sub(d.wrapping_mul(r)) as i32;
    let r = r.wrapping_add(((r as i32).wrapping_mul(e >> 8) >> 23) as u32);
    let (mut q, mut digits) = (0u32, 3);
    while digits != 0 {
        let digit = (rest >> 15).wrapping_mul(r) >> 21;
        rest = (rest << 10).wrapping_sub(digit.wrapping_mul(den));
        q = (q << 10).wrapping_add(digit);
        if rest >= den {
            rest = rest.wrapping_sub(den);
            q = q.wrapping_add(1);
        }
        digits -= 1;
    }
    q
}
