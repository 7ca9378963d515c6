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

mod axis;
mod domain;
mod fraction;
mod q30;
mod ratio;
mod root;
mod toi;
mod unit;
mod vec2;
mod wide;

pub use axis::Axis;
pub use domain::{DOMAIN, MOTION};
pub(crate) use domain::{check_coordinate, check_length, check_motion, check_radius};
pub(crate) use fraction::fraction;
pub use q30::Ratio;
pub use ratio::{div_sqrt, mul_div, mul_div_wide, recip};
pub use root::{isqrt64, isqrt64_ceil, rsqrt};
pub(crate) use root::{leading_zeros32, leading_zeros64, root128_down, root128_up};
pub use toi::Toi;
pub use unit::UnitVec2;
pub(crate) use unit::unit_ceil;
pub(crate) use vec2::Raw;
pub use vec2::Vec2;
pub(crate) use wide::{LONG, add128, cmp_squares, dot, mul128, norm, square_times, sub128};
pub use wide::{SPLIT, imul, imul_split, less128, mul64, sqr64, umul, umul_split, usqr, usqr_split};

/// The world's scalar: signed 16.16 fixed point. A unit is whatever the game says it is, usually a pixel.
pub type Fx = fixed::types::I16F16;

#[cfg(test)]
mod tests {
    use super::{cmp_squares, square_times};

    /// Numbers that differ in one of the three words of a product only, or in none.
    #[test]
    fn squares_are_compared_in_all_words() {
        let numbers = [0, 1, 2, 3, 1 << 32, (1 << 32) + 1, (1 << 60) - 1, 1 << 60, (1 << 60) + 1];
        for (a, p) in numbers.into_iter().flat_map(|a| numbers.map(|p| (a, p))) {
            for (b, q) in numbers.into_iter().flat_map(|b| numbers.map(|q| (b, q))) {
                let expected = square_times(a, p).cmp(&square_times(b, q));
                assert_eq!(cmp_squares((a, p), (b, q)), expected, "{a} {p} {b} {q}");
            }
        }
    }
}
