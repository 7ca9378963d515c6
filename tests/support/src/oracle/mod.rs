//! An exact judge of shape pairs, written from the definitions and sharing no code with the
//! library.
//!
//! Two convex shapes overlap if the origin is interior to the Minkowski sum `A + (-B)`. The judge
//! builds that sum: the hull of all differences of vertices, grown by the sum of the radii. Every
//! question is then one about the origin and one polygon, in 256-bit integers.

pub mod closest;
pub mod exit;
pub mod figure;
mod fraction;
pub mod generate;
pub mod int256;
pub mod kernel;
pub mod measure;
pub mod nearest;
pub mod rational;
pub mod sum;
pub mod touch;
pub mod verify;
