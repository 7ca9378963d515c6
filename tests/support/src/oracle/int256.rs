//! A signed integer of 256 bits: just enough arithmetic to compare squared distances as fractions.

use core::ops::{Add, Mul, Neg, Sub};

/// Two's complement, `hi * 2^128 + lo`. The derived order is the numeric order because `hi` carries
/// the sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Int256 {
    hi: i128,
    lo: u128,
}

impl Int256 {
    pub const ZERO: Self = Self { hi: 0, lo: 0 };
    pub const ONE: Self = Self { hi: 0, lo: 1 };

    pub const fn new(value: i64) -> Self {
        Self::from_i128(value as i128)
    }

    pub const fn from_i128(value: i128) -> Self {
        Self { hi: value >> 127, lo: value as u128 }
    }

    /// The exact product of two 64-bit integers.
    pub const fn product(a: i64, b: i64) -> Self {
        Self::from_i128(a as i128 * b as i128)
    }

    /// -1, 0 or 1.
    pub const fn signum(self) -> i32 {
        if self.hi < 0 {
            -1
        } else if self.hi == 0 && self.lo == 0 {
            0
        } else {
            1
        }
    }

    pub fn abs(self) -> Self {
        if self.hi < 0 { -self } else { self }
    }

    pub fn squared(self) -> Self {
        self * self
    }

    /// The value when it fits 128 bits; the product of two such values needs one multiplication
    /// less.
    const fn narrow(self) -> Option<i128> {
        if self.hi == (self.lo as i128) >> 127 { Some(self.lo as i128) } else { None }
    }

    /// The value when it fits 64 bits: products of two such values, which most are, need no check.
    const fn word(self) -> Option<i64> {
        let word = self.lo as i64;
        if self.lo as i128 == word as i128 && self.hi == (word >> 63) as i128 { Some(word) } else { None }
    }

    fn long_product(self, other: Self) -> Self {
        if let (Some(a), Some(b)) = (self.narrow(), other.narrow())
            && let Some(p) = a.checked_mul(b)
        {
            return Self::from_i128(p);
        }
        let negative = (self.hi < 0) != (other.hi < 0);
        let (a, b) = (self.abs(), other.abs());
        // Each operand is hi * 2^128 + lo; hi * hi would be 2^256.
        assert!(a.hi == 0 || b.hi == 0, "Int256 product overflows");
        let (carry, lo) = wide(a.lo, b.lo);
        let cross = match (a.hi, b.hi) {
            (0, 0) => 0,
            (h, 0) => checked(h, b.lo),
            (_, h) => checked(h, a.lo),
        };
        let hi = carry.checked_add(cross).and_then(|h| i128::try_from(h).ok());
        let magnitude = Self { hi: hi.expect("Int256 product overflows"), lo };
        if negative { -magnitude } else { magnitude }
    }

    /// Four limbs of 64 bits, least significant first.
    pub const fn limbs(self) -> [u64; 4] {
        [self.lo as u64, (self.lo >> 64) as u64, self.hi as u64, (self.hi >> 64) as u64]
    }
}

impl Add for Int256 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (lo, carry) = self.lo.overflowing_add(other.lo);
        let (hi, over) = self.hi.overflowing_add(other.hi);
        let (hi, over_carry) = hi.overflowing_add(i128::from(carry));
        // Both may overflow only in opposite directions, which leaves the sum representable.
        assert!(over == over_carry, "Int256 sum overflows");
        Self { hi, lo }
    }
}

impl Neg for Int256 {
    type Output = Self;
    fn neg(self) -> Self {
        let (lo, borrow) = 0u128.overflowing_sub(self.lo);
        let hi = (!self.hi).wrapping_add(i128::from(!borrow));
        assert!(self.hi != i128::MIN || self.lo != 0, "Int256 negation overflows");
        Self { hi, lo }
    }
}

impl Sub for Int256 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Int256 {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        match (self.word(), other.word()) {
            (Some(a), Some(b)) => Self::product(a, b),
            _ => self.long_product(other),
        }
    }
}

fn checked(hi: i128, lo: u128) -> u128 {
    u128::try_from(hi).ok().and_then(|h| h.checked_mul(lo)).expect("Int256 product overflows")
}

/// `(high, low)` halves of the product of two unsigned 128-bit integers.
const fn wide(a: u128, b: u128) -> (u128, u128) {
    const LOW: u128 = u64::MAX as u128;
    let (ah, al, bh, bl) = (a >> 64, a & LOW, b >> 64, b & LOW);
    let (ll, lh, hl, hh) = (al * bl, al * bh, ah * bl, ah * bh);
    let mid = (ll >> 64) + (lh & LOW) + (hl & LOW);
    (hh + (lh >> 64) + (hl >> 64) + (mid >> 64), (mid << 64) | (ll & LOW))
}
