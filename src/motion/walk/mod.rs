//! Walking: what a character needs beyond [`Mover::move_and_slide`](super::Mover::move_and_slide), for the games that have one.
//!
//! On the ground a [`Walker`] goes by *legs* along the floor: a sweep along it, which the floor's bends upward, steps and walls end, and a look down
//! from its end, which finds where the floor bends downward. In the air it moves as its mover does, up to the first floor.

mod ground;
mod stride;
mod walker;

pub(super) use ground::CONTACT;
pub use ground::Support;
pub use walker::{SlopeSpeed, Walked, Walker};
