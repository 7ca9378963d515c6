//! Numbers of a level file, exact until one rounding.
//!
//! Readers of levels commonly store coordinates as `f32`. Its 24 bits are fewer than the 29 of a
//! raw coordinate. All digits matter for whether a point lies on the raw lattice, and for its
//! distance.

use std::ops::{Add, Neg, Sub};

/// A count of 1e-26 pixels. Values below 1e6 pixels, scaled by 2^16, stay below 2^123.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Decimal(i128);

const PLACES: i32 = 26;
const ONE: i128 = 10i128.pow(PLACES as u32);
/// Far beyond the domain: a sum of several is still outside.
const LIMIT: i128 = 1_000_000 * ONE;

impl Decimal {
    pub const ZERO: Self = Self(0);

    /// `-12.5`, `3`, `.5`, `1.2e-05`. Cuts digits after 26 places. `None` for anything else, and
    /// from a million on.
    pub fn parse(text: &[u8]) -> Option<Self> {
        let text = std::str::from_utf8(text).ok()?.trim();
        let (number, exponent) = match text.split_once(['e', 'E']) {
            Some((number, exponent)) => (number, exponent.parse::<i32>().ok()?),
            None => (text, 0),
        };
        let (negative, digits) = match number.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, number.strip_prefix('+').unwrap_or(number)),
        };
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        if whole.is_empty() && fraction.is_empty() || exponent.unsigned_abs() > 400 {
            return None;
        }
        let mut value = 0i128;
        // The weight of the first digit. Each following weight is one lower.
        let mut place = exponent.checked_add(i32::try_from(whole.len()).ok()?)?;
        for digit in whole.bytes().chain(fraction.bytes()) {
            let digit = i128::from(char::from(digit).to_digit(10)?);
            place -= 1;
            if digit != 0 && place > 6 {
                return None;
            }
            if (-PLACES..=6).contains(&place) {
                value += digit * 10i128.pow((place + PLACES) as u32);
            }
        }
        (value < LIMIT).then_some(Self(if negative { -value } else { value }))
    }

    /// The same. A number from a million on is a million.
    pub fn saturated(text: &[u8]) -> Option<Self> {
        let is_number = text.iter().all(|byte| b"+-.eE0123456789 \t".contains(byte));
        let far = || std::str::from_utf8(text).ok()?.trim().parse::<f64>().ok().filter(|v| v.abs() >= 1e6);
        let end = |v: f64| Self(if v < 0.0 { -LIMIT } else { LIMIT });
        Self::parse(text).or_else(|| far().filter(|_| is_number).map(end))
    }

    /// Whether it is a million or more.
    pub fn is_far(self) -> bool {
        self.0.abs() >= LIMIT
    }

    /// A whole number of pixels. Saturates.
    pub fn whole(value: i64) -> Self {
        Self(i128::from(value).saturating_mul(ONE).clamp(-LIMIT, LIMIT))
    }

    /// Times a fraction below 2^16, cut off after 26 places. Saturates.
    #[must_use]
    pub fn scaled(self, numerator: u32, denominator: u32) -> Self {
        let (n, d) = (i128::from(numerator), i128::from(denominator.max(1)));
        let whole = (self.0 / d).saturating_mul(n);
        Self(whole.saturating_add(self.0 % d * n / d).clamp(-LIMIT, LIMIT))
    }

    /// For a point of a rotated object, which is not a decimal. Saturates.
    #[allow(clippy::cast_precision_loss, reason = "sines are not decimals")]
    pub fn from_f64(value: f64) -> Self {
        Self(((value * ONE as f64) as i128).clamp(-LIMIT, LIMIT))
    }

    /// The nearest float.
    #[allow(clippy::cast_precision_loss, reason = "sines are not decimals")]
    pub fn to_f64(self) -> f64 {
        self.0 as f64 / ONE as f64
    }

    /// The nearest raw unit, halves up: a shifted level keeps its shape.
    pub fn raw(self) -> i64 {
        let scaled = self.0 << 16;
        (scaled + ONE / 2).div_euclid(ONE) as i64
    }

    /// The error of [`raw`](Self::raw), in thousandths of a raw unit, rounded up.
    pub fn off_lattice(self) -> i64 {
        let error = ((self.0 << 16) - i128::from(self.raw()) * ONE).abs();
        let thousandth = ONE / 1000;
        ((error + thousandth - 1) / thousandth) as i64
    }
}

impl Add for Decimal {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Self((self.0 + rhs.0).clamp(-LIMIT, LIMIT))
    }
}

impl Sub for Decimal {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        self + -rhs
    }
}

impl Neg for Decimal {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}
