//! An exact judge of shape pairs, written from the definitions and sharing no code with the library.
//!
//! Two convex shapes overlap where the origin is interior to the Minkowski sum `A + (-B)`. The judge builds that sum: the hull of all
//! differences of vertices, grown by the sum of the radii. Every question is then one about the origin and one polygon, answered
//! with 256-bit integers.

#![allow(dead_code, reason = "each test file uses its own part of the judge")]

pub(crate) mod closest;
pub(crate) mod exit;
pub(crate) mod figure;
pub(crate) mod generate;
pub(crate) mod int256;
pub(crate) mod kernel;
pub(crate) mod measure;
pub(crate) mod nearest;
pub(crate) mod random;
pub(crate) mod sum;
pub(crate) mod touch;
pub(crate) mod verify;
