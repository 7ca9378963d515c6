//! Numbers: the public scalar and vectors, and the wide integer arithmetic that every query is
//! built from.
//!
//! | | what | exact? |
//! |---|---|---|
//! | [`Fx`], [`Vec2`] | lengths and positions, 16.16 | as given |
//! | [`Axis`] | a direction as two integers, of any length | always exact |
//! | [`UnitVec2`] | a direction of length one, 2.30 | within 1.5 raw |
//! | [`Toi`] | a fraction of a motion, 2^30 = the whole | rounded down |
//! | [`Ratio`] | friction, restitution, shares, 2^30 = one | nearest |
//! | [`umul`] [`usqr`] [`imul`] [`mul64`] [`sqr64`] | wide products | exact |
//! | [`isqrt64`] [`mul_div`] [`div_sqrt`] | roots and quotients without division | exact floor |
//!
//! A constructor that can fail in only one way returns an `Option`, which a constant unwraps at
//! compile time: [`Ratio::new`], [`Toi::from_raw`], [`Vec2::from_f32`],
//! [`Masses::new`](crate::motion::Masses::new). Constructors of values with several fields, and of
//! every shape and level, return an error that names the field.
//!
//! "raw" is one unit of the integer lattice: the last bit of an `Fx`, 1/65536 of a unit. The crate
//! computes with raw integers and never looks at the binary point. So you can pass numbers of
//! another fixed-point format by their bits: [`Vec2::from_raw`].

mod by_length;
mod direction;
mod domain;
mod geometry;
mod inverse_root;
mod part;
mod quotient;
mod raw;
#[cfg(feature = "serde")]
mod stored;
#[cfg(test)]
mod tests;
mod turns;
mod vec2;
mod wide;

pub(crate) use by_length::{div_length, unit_by};
pub use direction::{Axis, UnitVec2};
pub(crate) use direction::{on_circle, scaled, toward, unit_ceil};
pub use domain::{DOMAIN, MOTION};
pub(crate) use domain::{check_coordinate, check_length, check_motion, check_radius};
pub(crate) use inverse_root::InverseRoot;
pub use inverse_root::div_sqrt;
pub(crate) use part::fraction;
pub use part::{Ratio, Toi};
pub use quotient::{isqrt64, isqrt64_ceil, mul_div, mul_div_wide, recip, rsqrt};
pub(crate) use quotient::{leading_zeros32, leading_zeros64, root128_down, root128_up};
pub(crate) use raw::Raw;
pub use vec2::Vec2;
pub(crate) use wide::{LONG, add128, cmp_squares, dot, mul128, norm, sqr_signed, square_times, sub128};
pub use wide::{SPLIT, imul, imul_split, less128, mul64, sqr64, umul, umul_split, usqr, usqr_split};

/// The scalar type of positions and lengths: signed 16.16 fixed point.
///
/// You choose what a unit is; most games use one pixel. The type is [`FixedI32`](fixed::FixedI32)
/// of the crate [`fixed`]. One raw unit is 1/65536; the largest value is just below 32768. Write
/// constants with [`fx!`](crate::fx): `fx!(0.25)` is computed by the compiler. `Fx::lit("0.25")`
/// outside a `const` is parsed when the program runs (874 instructions on a Cortex-M0, and 3.9 KB
/// of flash).
///
/// # Overflow
///
/// Nothing in this crate overflows or panics, but the operators of `Fx` belong to `fixed`. They
/// panic in debug builds and **wrap in release builds**:
///
/// | you write | where it fails | instead |
/// |---|---|---|
/// | `a + b`, `a - b`, `-a` | beyond ±32 768 | `a.saturating_add(b)`, `a.checked_add(b)`, ... |
/// | `a * b` | beyond ±32 768, such as 182 * 182 | `a.saturating_mul(b)`, `a.checked_mul(b)` |
/// | `a / b` | beyond ±32 768; `b == 0` panics in every build | `a.checked_div(b)` |
/// | `Fx::from_num(n)` | `n` beyond ±32 768 | `Fx::checked_from_num(n)`, `Fx::saturating_from_num(n)`; `Fx::from(i16)` cannot fail |
///
/// Operators of [`Vec2`] saturate. If you compute only with vectors, none of these occurs.
#[doc(alias("fixed point", "Q16.16", "Fixed"))]
pub type Fx = fixed::types::I16F16;

/// An [`Fx`](crate::Fx) from a literal, always computed by the compiler.
///
/// The value is rounded to the nearest raw unit (1/65536), ties to even. It may be negative. You
/// can use it wherever an expression is allowed, also in your own macros. Anything that is not a
/// number within 16.16 does not compile.
///
/// ```
/// use tilesat::{Fx, fx};
/// const GRAVITY: Fx = fx!(0.25);
/// assert_eq!(GRAVITY.to_bits(), 1 << 14);
/// assert_eq!(fx!(-1.5) + fx!(2), fx!(0.5));
/// ```
///
/// ```compile_fail
/// let too_large = tilesat::fx!(40000); // 16.16 ends below 32768
/// ```
///
/// ```compile_fail
/// let two_signs = tilesat::fx!(--5);
/// ```
///
/// ```compile_fail
/// let text = tilesat::fx!("0.25");
/// ```
///
/// ```compile_fail
/// let n = 3;
/// let not_a_literal = tilesat::fx!(n); // for a variable: Fx::from(n), Fx::checked_from_num(n)
/// ```
#[macro_export]
macro_rules! fx {
    ($value:literal) => {
        const { $crate::num::literal(::core::stringify!($value)) }
    };
    (- $size:literal) => {
        const { $crate::num::literal(::core::concat!("- ", ::core::stringify!($size))) }
    };
    ($($other:tt)*) => {
        ::core::compile_error!(
            "fx! takes one literal, as in fx!(0.25); for a variable, use Fx::from (an i16) or Fx::checked_from_num"
        )
    };
}

/// The value of a literal, for [`fx!`](crate::fx).
///
/// In the body of a macro, `stringify!` puts a space after a minus, and [`Fx::lit`] does not accept
/// it.
#[doc(hidden)]
#[must_use]
pub const fn literal(text: &str) -> Fx {
    let (negative, size) = match text.as_bytes() {
        [b'-', b' ', size @ ..] => (true, size),
        size => (false, size),
    };
    let value = match core::str::from_utf8(size) {
        // Wider than an `Fx`, so that the message below gives the range.
        Ok(size) => fixed::types::I48F16::lit(size).to_bits(),
        Err(_) => i64::MAX,
    };
    // The compiler evaluates it: no program holds these panics.
    assert!(!negative || value >= 0, "fx! takes one sign");
    let value = if negative { value.wrapping_neg() } else { value };
    assert!(value == value as i32 as i64, "fx! takes a number from -32768 to below 32768");
    Fx::from_bits(value as i32)
}
