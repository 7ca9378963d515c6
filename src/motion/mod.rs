//! Motion: where a body ends up when it moves through a level.
//!
//! [`Mover::move_and_slide`] sweeps a box or a circle against the level's [features](crate::world::Feature), stops it exactly where
//! it first touches, lets the [`Response`] decide what becomes of its velocity, and goes on with what is left of the motion, at most
//! [`Mover::ITERATIONS`] times. Nothing is stored that the level's exact overlap test rejects (*verify, then commit*), so a body that
//! starts outside of the solid ends outside of it, whatever the speed.
//!
//! | question | answer |
//! |---|---|
//! | does a seam between tiles stop or lift a body? | no: interior faces and flat joints have no features |
//! | touching and sliding along, or moving away? | not a hit |
//! | a corner that is hit by a box on both sides at once? | the side that opposes the motion more, the vertical one on a tie |
//! | a circle at a corner? | rounded: the exact disc, no square corners |
//! | from slope to slope, from a floor into a quarter pipe? | no joint is felt; the part of the velocity along the surface is kept |
//! | a wedge that is too narrow? | it stops where it touches both sides, and rests there |
//! | one-way faces? | block what is entirely in front when the motion starts, and moves in; nothing else |
//! | the body starts inside the solid? | [`Stuck`]: nothing moves |

mod body;
mod hits;
mod moment;
mod moved;
mod mover;
mod pipe;
mod plane;
mod run;
mod sweep_arc;
mod sweep_box;
mod sweep_circle;
mod sweep_corner;
mod sweep_slope;
mod sweep_vertex;
#[cfg(all(test, not(target_os = "none")))]
mod tests;

pub use body::Body;
pub use hits::{Hit, Hits};
pub use moved::{MoveError, Moved, Placed, Stuck, Work};
pub use mover::{Mover, Response};
