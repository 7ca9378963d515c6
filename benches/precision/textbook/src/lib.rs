//! Collision code that ignores rounding: the formulas of the textbooks, written once over a number
//! format.
//!
//! They decide whether a pair overlaps, and compute depth and normal. The number formats are
//! floating point, Q16.16 as in hobby code, and Q16.16 in wider registers. [`exact`] answers the
//! same questions in integers that cannot be wrong, without a filter. All of it runs without a
//! standard library, so that a microcontroller counts the same code.

#![no_std]

pub mod broad;
pub mod capsule;
pub mod cast;
pub mod cells;
pub mod checksum;
pub mod dda;
pub mod exact;
pub mod pair;
pub mod polygon;
mod scalar;
pub mod shape;
pub mod tile;
pub mod tile_set;
pub mod turned;
pub mod walk;

pub use scalar::{Q16, Scalar, Wide};
