//! Numbers: the public scalar and vectors, and the wide integer arithmetic that every query is built from.
//!
//! | | what | exact? |
//! |---|---|---|
//! | [`Fx`], [`Vec2`] | lengths and positions, 16.16 | the user's numbers |
//! | [`Axis`] | a direction as two integers, of any length | always exact |
//! | [`UnitVec2`] | a direction of length one, 2.30 | within 1.5 raw |
//! | [`Toi`] | a fraction of a motion, 2^30 = the whole | rounded down |
//! | [`Ratio`] | friction, restitution, shares, 2^30 = one | nearest |
//! | [`umul`] [`usqr`] [`imul`] [`mul64`] [`sqr64`] | wide products | exact |
//! | [`isqrt64`] [`mul_div`] [`div_sqrt`] | roots and quotients without division | exact floor |
//!
//! "raw" is one unit of the integer lattice: the bits of an `Fx`, 1/65536 of a unit. Kernels see raw integers only and never the
//! binary point, so other formats may be fed by their bits ([`Vec2::from_raw`]).

mod direction;
mod part;
mod quotient;
#[cfg(test)]
mod tests;
mod vec2;
mod wide;

pub use direction::{Axis, UnitVec2};
pub(crate) use direction::{on_circle, scaled, toward, unit_ceil};
pub(crate) use part::fraction;
pub use part::{Ratio, Toi};
pub use quotient::{div_sqrt, isqrt64, isqrt64_ceil, mul_div, mul_div_wide, recip, rsqrt};
pub(crate) use quotient::{leading_zeros32, leading_zeros64, root128_down, root128_up};
pub use vec2::{DOMAIN, MOTION, Vec2};
pub(crate) use vec2::{Raw, check_coordinate, check_length, check_motion, check_radius};
pub(crate) use wide::{LONG, add128, cmp_squares, dot, mul128, norm, square_times, sub128};
pub use wide::{SPLIT, imul, imul_split, less128, mul64, sqr64, umul, umul_split, usqr, usqr_split};

/// The world's scalar: signed 16.16 fixed point. A unit is whatever the game says it is, usually a pixel.
pub type Fx = fixed::types::I16F16;
