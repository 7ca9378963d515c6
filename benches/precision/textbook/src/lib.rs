//! What collision code looks like where nobody thinks about rounding: the formulas of the
//! textbooks, written once over a number format.
//!
//! They decide whether a pair overlaps, and tell depth and normal. Floating point, Q16.16 as hobby
//! code has it, and Q16.16 in wider registers are instances; [`exact`] has the same questions in
//! integers that cannot be wrong, and no filter in front. All of it runs without a standard
//! library, so that the same code is counted on a microcontroller.

#![no_std]

pub mod broad;
pub mod cast;
pub mod cells;
pub mod checksum;
pub mod dda;
pub mod exact;
pub mod pair;
mod scalar;
pub mod shape;
pub mod tile;
pub mod tile_set;
pub mod walk;

pub use scalar::{Q16, Scalar, Wide};
