//! The response toolkit: what becomes of a velocity, a pair or a string of points at a contact.
//!
//! Small functions and plain values over the public types, for movers and for games that resolve contacts by themselves: project out, split the velocity
//! at the surface, scale both parts, and only where it moves in; share a push by the masses. Lengths are units, velocities units a frame, accelerations
//! units a frame and frame. Rounding never gains speed, never leads into a surface and is the same for both signs.
//!
//! | question | answer |
//! |---|---|
//! | which part of this velocity is into the surface? | [`split`] |
//! | what is the velocity after the contact? | [`slide`], [`bounce`], [`respond`]; a [`Surface`] in a mover |
//! | how does a ball bounce for ever? | a [`Speed`] beside its velocity; its [`Energy`] where there is gravity |
//! | what if gravity is less than a raw unit a frame? | an [`Acceleration`] with a [`Carry`] |
//! | how do two bodies get out of each other? | [`separate`], by their [`Masses`] |
//! | and their velocities? | [`exchange`] |
//! | ropes, chains, ragdolls? | [`Particle`]s joined by [`Stick`]s, brought to their lengths by [`relax`], asleep when [`Quiet`] |
//!
//! The ideas are those of the tutorials and the talk on N by Metanet Software (projection, split velocities, Verlet points); friction is
//! Coulomb's, and the points are those of Jakobsen's *Advanced Character Physics* (2001).

mod acceleration;
mod impact;
mod reply;
mod surface;
mod verlet;

pub use acceleration::{Acceleration, Carry};
pub use impact::{Masses, Split, bounce, exchange, respond, separate, slide, split};
pub(in crate::motion) use reply::{Bounce, Reply};
pub(in crate::motion) use surface::law::Law;
pub use surface::{Energy, Smooth, Speed, Surface};
pub use verlet::{Link, Particle, Quiet, RelaxError, Stick, relax};
