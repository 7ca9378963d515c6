//! An exact judge of casts, written from the definition, and the checks of one case.
//!
//! A overlaps B if the origin is in the open set K = interior of B + (-A), the hull of all
//! differences of vertices grown by the radii. A motion d of A is the path of the origin to d. So
//! everything is one question: does the path up to a fraction of the motion meet K? A least
//! distance of two convex sets answers it. Nothing solves for a time, and nothing shares code with
//! the library.

pub mod ask;
pub mod judge;
pub mod motions;
pub mod number;
