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
mod pair;
mod reply;
mod surface;
mod verlet;

pub use acceleration::{Acceleration, Carry};
pub use pair::{Masses, exchange, separate};
pub(in crate::motion) use reply::{Bounce, Reply};
pub(in crate::motion) use surface::law::Law;
pub use surface::{Energy, Smooth, Speed, Surface};
pub use verlet::{Link, Particle, Quiet, RelaxError, Stick, relax};

use crate::error::RangeError;
use crate::num::{Axis, DOMAIN, Ratio, Raw, Vec2, check_motion};
use crate::query::round::scaled;

/// A vector as the sum of a part along a normal and a part along the surface; the sum is exact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Split {
    /// Along the normal, or against it.
    pub normal: Vec2,
    /// Along the surface.
    pub tangent: Vec2,
}

/// Splits a velocity at a normal of any length.
///
/// The normal part is rounded to nearest (halves toward zero), the tangent is the rest, so both are within half a raw unit of the exact parts and their sum
/// is `v`. Exact at normals along x and y. A zero normal gives all to the tangent. How hard something was hit is the
/// [`length`](Vec2::length) of the normal part. Mirrored input gives mirrored bits. Cost: two long divisions, some 1730 instructions on a Cortex-M0.
///
/// ```
/// use tilesat::{Axis, Vec2, motion::response::split};
/// let parts = split(Vec2::from_ints(7, 1), Axis::new(3, -4))?;
/// assert_eq!(parts.normal, Vec2::from_raw(133_693, -178_258)); // 17/25 of (3, -4)
/// assert_eq!(parts.normal + parts.tangent, Vec2::from_ints(7, 1));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] where a component of `v` is outside of the [domain](crate::num::DOMAIN).
pub fn split(v: Vec2, normal: Axis) -> Result<Split, RangeError> {
    check_motion(v, DOMAIN)?;
    let along = if normal.x == 0 {
        Vec2::from_raw(0, if normal.y == 0 { 0 } else { v.y.to_bits() })
    } else if normal.y == 0 {
        Vec2::from_raw(v.x.to_bits(), 0)
    } else {
        let (s, nn) = (normal.dot_vec(v), normal.length_squared());
        Raw { x: scaled(normal.x, s, nn), y: scaled(normal.y, s, nn) }.vec2()
    };
    Ok(Split { normal: along, tangent: v - along })
}

/// A velocity without its part into a surface: [`Surface::respond`] of [`Surface::SLICK`].
///
/// # Errors
/// [`RangeError`] where a component of `v` is outside of the [domain](crate::num::DOMAIN).
pub fn slide(v: Vec2, normal: Axis) -> Result<Vec2, RangeError> {
    Surface::SLICK.respond(v, normal)
}

/// A velocity whose part into a surface is turned round, times `restitution`: [`Surface::respond`] without friction.
///
/// # Errors
/// [`RangeError`] where a component of `v` is outside of the [domain](crate::num::DOMAIN).
pub fn bounce(v: Vec2, normal: Axis, restitution: Ratio) -> Result<Vec2, RangeError> {
    Surface::new(restitution, Ratio::ZERO).respond(v, normal)
}

/// A velocity after a contact with restitution and friction: [`Surface::respond`].
///
/// # Errors
/// [`RangeError`] where a component of `v` is outside of the [domain](crate::num::DOMAIN).
pub fn respond(v: Vec2, normal: Axis, restitution: Ratio, friction: Ratio) -> Result<Vec2, RangeError> {
    Surface::new(restitution, friction).respond(v, normal)
}
