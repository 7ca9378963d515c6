//! The number formats of the textbook engine.

use std::ops::{Add, Div, Mul, Neg, Sub};

pub trait Scalar:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    fn of_raw(raw: i32) -> Self;
    fn px(self) -> f64;
    fn root(self) -> Self;

    /// From 1/256.
    fn of_256(n: i32) -> Self {
        Self::of_raw(n << 8)
    }
}

impl Scalar for f32 {
    fn of_raw(raw: i32) -> Self {
        (f64::from(raw) / 65536.0) as Self
    }

    fn px(self) -> f64 {
        self.into()
    }

    fn root(self) -> Self {
        self.sqrt()
    }
}

/// I16F16 as games without a library use it: each product is cut to 32 bits at once, rounds down
/// and wraps.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Q16(i32);

impl Add for Q16 {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self(self.0.wrapping_add(o.0))
    }
}

impl Sub for Q16 {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self(self.0.wrapping_sub(o.0))
    }
}

impl Mul for Q16 {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self(((i64::from(self.0) * i64::from(o.0)) >> 16) as i32)
    }
}

impl Div for Q16 {
    type Output = Self;
    /// A quotient by zero is zero, the usual guard.
    #[allow(clippy::suspicious_arithmetic_impl, reason = "the binary point")]
    fn div(self, o: Self) -> Self {
        Self((i64::from(self.0) * 65536).checked_div(o.0.into()).unwrap_or(0) as i32)
    }
}

impl Neg for Q16 {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.wrapping_neg())
    }
}

impl Scalar for Q16 {
    fn of_raw(raw: i32) -> Self {
        Self(raw)
    }

    fn px(self) -> f64 {
        f64::from(self.0) / 65536.0
    }

    fn root(self) -> Self {
        Self(((self.0.max(0) as u64) << 16).isqrt() as i32)
    }
}
