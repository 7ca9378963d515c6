//! Number formats.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number as in the formulas. Lengths are in pixels, 65 536 raw units each.
pub trait Scalar:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    const ZERO: Self;
    const ONE: Self;

    /// The format's nearest to a raw length.
    fn of_raw(raw: i32) -> Self;
    fn px(self) -> f64;
    fn root(self) -> Self;
    /// The largest integer not above, for cells.
    fn floor(self) -> i32;
    fn of_int(n: i32) -> Self;
    /// Greater than all times of a motion.
    const NEVER: Self;

    fn least(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    fn most(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    fn magnitude(self) -> Self {
        if self < Self::ZERO { -self } else { self }
    }
}

macro_rules! float {
    ($t:ty, $root:expr, $floor:expr) => {
        impl Scalar for $t {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const NEVER: Self = Self::INFINITY;

            #[inline]
            fn of_raw(raw: i32) -> Self {
                (f64::from(raw) / 65536.0) as Self
            }

            #[inline]
            fn px(self) -> f64 {
                self.into()
            }

            #[inline]
            fn root(self) -> Self {
                $root(self)
            }

            #[inline]
            fn floor(self) -> i32 {
                $floor(self)
            }

            #[inline]
            fn of_int(n: i32) -> Self {
                n as Self
            }
        }
    };
}

/// The host's baseline has no rounding instruction. Games use a cast and a correction.
macro_rules! floor {
    ($t:ty) => {
        |v: $t| {
            let n = v as i32;
            if (n as $t) > v { n - 1 } else { n }
        }
    };
}

float!(f32, root32, floor!(f32));
float!(f64, root64, floor!(f64));

#[cfg(not(target_os = "none"))]
#[inline]
fn root32(v: f32) -> f32 {
    extern crate std;
    v.sqrt()
}

#[cfg(not(target_os = "none"))]
#[inline]
fn root64(v: f64) -> f64 {
    extern crate std;
    v.sqrt()
}

/// The form without a standard library, even with an FPU: the instruction has no stable name there.
#[cfg(target_os = "none")]
#[inline]
fn root32(v: f32) -> f32 {
    libm::sqrtf(v)
}

#[cfg(target_os = "none")]
#[inline]
fn root64(v: f64) -> f64 {
    libm::sqrt(v)
}

/// Q16.16 as in games without a library: every product is cut to 32 bits at once, rounds down and
/// wraps.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Q16(i32);

/// Q16.16 in registers of 64 bits: the same rounding, but nothing wraps.
#[derive(Clone, Copy, Debug)]
pub struct Wide(i64);

impl PartialEq for Wide {
    #[inline]
    fn eq(&self, o: &Self) -> bool {
        self.0 == o.0
    }
}

impl PartialOrd for Wide {
    #[inline]
    fn partial_cmp(&self, o: &Self) -> Option<Ordering> {
        Some(self.0.cmp(&o.0))
    }
}

macro_rules! fixed {
    ($t:ident, $word:ty, |$a:ident, $b:ident| $product:expr, |$n:ident, $d:ident| $quotient:expr, |$v:ident| $root:expr) => {
        impl Add for $t {
            type Output = Self;
            #[inline]
            fn add(self, o: Self) -> Self {
                Self(self.0.wrapping_add(o.0))
            }
        }

        impl Sub for $t {
            type Output = Self;
            #[inline]
            fn sub(self, o: Self) -> Self {
                Self(self.0.wrapping_sub(o.0))
            }
        }

        impl Neg for $t {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self {
                Self(self.0.wrapping_neg())
            }
        }

        impl Mul for $t {
            type Output = Self;
            #[inline]
            #[allow(clippy::suspicious_arithmetic_impl, reason = "the binary point")]
            fn mul(self, o: Self) -> Self {
                let ($a, $b) = (self.0, o.0);
                Self($product)
            }
        }

        impl Div for $t {
            type Output = Self;
            /// A quotient by zero is zero, the usual guard.
            #[inline]
            #[allow(clippy::suspicious_arithmetic_impl, reason = "the binary point")]
            fn div(self, o: Self) -> Self {
                let ($n, $d) = (self.0, o.0);
                Self(if $d == 0 { 0 } else { $quotient })
            }
        }

        impl Scalar for $t {
            const ZERO: Self = Self(0);
            const ONE: Self = Self(1 << 16);
            const NEVER: Self = Self(<$word>::MAX);

            #[inline]
            fn of_raw(raw: i32) -> Self {
                Self(raw.into())
            }

            #[inline]
            fn px(self) -> f64 {
                self.0 as f64 / 65536.0
            }

            #[inline]
            fn root(self) -> Self {
                let $v = if self.0 < 0 { 0 } else { self.0 as u64 };
                Self($root as $word)
            }

            #[inline]
            fn floor(self) -> i32 {
                (self.0 >> 16) as i32
            }

            #[inline]
            fn of_int(n: i32) -> Self {
                Self(<$word>::from(n) << 16)
            }
        }
    };
}

fixed!(
    Q16,
    i32,
    |a, b| ((i64::from(a) * i64::from(b)) >> 16) as i32,
    |n, d| (i64::from(n) * 65536 / i64::from(d)) as i32,
    |v| (v << 16).isqrt()
);
fixed!(Wide, i64, |a, b| a.wrapping_mul(b) >> 16, |n, d| n.wrapping_mul(65536).wrapping_div(d), |v| (v << 16).isqrt());
