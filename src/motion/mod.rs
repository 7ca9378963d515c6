//! Motion: where a body ends up when it moves through a level.
//!
//! [`Mover::move_and_slide`] sweeps a box or a circle against the level's
//! [features](crate::world::Feature), stops it exactly where it first touches, lets the
//! [`Response`] decide what becomes of its velocity, and goes on with what is left of the motion,
//! at most [`Mover::ITERATIONS`] times. Nothing is stored that the level's exact overlap test
//! rejects (*verify, then commit*), so a body that starts outside of the solid ends outside of it,
//! whatever the speed.
//!
//! | question | answer |
//! |---|---|
//! | does a seam between tiles stop or lift a body? | no: interior faces and flat joints have no features |
//! | touching and sliding along, or moving away? | not a hit |
//! | a corner that is hit by a box on both sides at once? | the side that opposes the motion more, the vertical one on a tie |
//! | a circle at a corner? | rounded: the exact disc, no square corners |
//! | from slope to slope, from a floor into a quarter pipe? | no joint is felt; the part of the velocity along the surface is kept |
//! | a wedge that is too narrow? | it stops where it touches both sides, and rests there |
//! | gravity in a V, a bowl, between domes? | it comes to rest and stays: the same place and velocity for ever |
//! | one-way faces? | block what is entirely in front when the motion starts, and moves in; nothing else |
//! | a platform moves under the body, a door against it? | [`Mover::ride`] carries it, pushes it, or says that it is [squashed](Ride::Squashed) |
//! | the body starts inside the solid? | [`Stuck`]: nothing moves; or as [`StartInside`] says (then **no gravity while it is inside**, or it falls through the floor below a closed door); [`escape`] pushes out what reaches the surface. Better: never [close a door](#doors) on it |
//!
//! # Doors
//!
//! A door is closed by changing tiles, which moves no body, or by moving a [`Solid`](crate::Solid),
//! which does. Any of these keeps bodies out of it:
//!
//! - **Ask first.** While `door.overlaps(&body)` is true for any body, the door stays open.
//! - **Let it come.** A door that is a moving [`Solid`](crate::Solid) pushes what is in its way, by
//!   [`Mover::ride`], or says that it is [squashed](Ride::Squashed): then stop the door, or the
//!   body is lost. Once it is closed its tiles may take over.
//! - **Remember.** Keep the last place where the level did not overlap the body, and put the body
//!   back there.
//!
//! ```
//! use tilesat::prelude::*;
//! use tilesat::{Aabb, Axis, Fx, Mover, Solid, TileKind, TileKinds, TileMap, Vec2, motion::Ride};
//! static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
//! let level = TileMap::from_ascii("###\n   \n###", &KINDS)?; // a corridor, from y = 16 to 32
//! let boxed = |x, y, w, h| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h));
//! let (door, player) = (boxed(16, 16, 16, 16)?, boxed(20, 22, 10, 10)?);
//! assert!(door.overlaps(&player)); // so the tile stays open; or
//!
//! let mover = Mover::platformer(Axis::NEG_Y);
//! let sliding = [Solid::new(boxed(4, 16, 16, 16)?, 1)?.with_motion(Vec2::from_ints(12, 0))?]; // from the left
//! let ridden = mover.ride(&level, &sliding, &player, Fx::ONE)?;
//! assert!(matches!(ridden.ride, Ride::Pushed { .. }) && ridden.motion == Vec2::from_ints(12, 0));
//! let falling = [Solid::new(boxed(16, 6, 16, 16)?, 1)?.with_motion(Vec2::from_ints(0, 10))?]; // from above
//! assert!(matches!(mover.ride(&level, &falling, &player, Fx::ONE)?.ride, Ride::Squashed { .. })); // so it stops
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Time: fixed steps and slow motion
//!
//! There is no time step: a velocity is the motion of one call. Call at a fixed rate, and collect
//! the time between two pictures until it makes a step; then a run depends on nothing but its
//! input, and a replay is the list of keys.
//!
//! Slow motion is *fewer steps*, not smaller velocities: half a velocity is rounded anew, gravity
//! would have to shrink with the square, and the run would be another one. Between two steps draw a
//! point between two places, with [`Toi::of`](crate::Toi::of), and never move a body there.
//!
//! ```
//! use tilesat::{Aabb, Axis, Mover, TileKind, TileKinds, TileMap, Toi, Vec2};
//!
//! static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
//! let level = TileMap::from_ascii("      \n      \n######\n", &KINDS)?;
//! let mover = Mover::platformer(Axis::NEG_Y);
//! let step = |(body, v): (Aabb, Vec2)| {
//!     let moved = mover.move_and_slide(&level, &body, v + Vec2::from_raw(0, 9_000)).unwrap();
//!     (moved.body, moved.velocity)
//! };
//! let start = (Aabb::new(Vec2::from_ints(4, 2), Vec2::from_ints(12, 14))?, Vec2::from_ints(1, 0));
//!
//! // `speed` parts of a step for each of so many pictures; what is drawn, and the last step's state.
//! let play = |speed: u32, pictures: u32| {
//!     let (mut time, mut before, mut now) = (0, start, start);
//!     let mut drawn = start.0.min();
//!     for _ in 0..pictures {
//!         time += speed;
//!         while time >= 60 {
//!             time -= 60;
//!             (before, now) = (now, step(now));
//!         }
//!         let part = Toi::from_raw(Toi::ONE.raw() / 60 * time).unwrap();
//!         drawn = before.0.min() + part.of(now.0.min() - before.0.min()); // up to a step late, and smooth
//!     }
//!     (now, drawn)
//! };
//! let (normal, slow) = (play(60, 40), play(20, 120)); // a third of the speed, three times as many pictures
//! assert_eq!(normal, slow); // the same run, bit for bit
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod blocks;
mod body;
mod cast;
mod character;
mod contact;
mod feel;
mod inside;
mod memo;
mod moved;
mod mover;
mod order;
mod plane;
pub mod response {
    //! The response toolkit: what becomes of a velocity, a pair or a string of points at a contact.
    //!
    //! Small functions and plain values over the public types, for movers and for games that
    //! resolve contacts by themselves: project out, split the velocity at the surface, scale both
    //! parts, and only where it moves in; share a push by the masses. Lengths are units, velocities
    //! units a frame, accelerations units a frame and frame. Rounding never gains speed, never
    //! leads into a surface and is the same for both signs.
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
    //! The ideas are those of the tutorials and the talk on N by Metanet Software (projection,
    //! split velocities, Verlet points); friction is Coulomb's, and the points are those of
    //! Jakobsen's *Advanced Character Physics* (2001).

    mod acceleration;
    mod impact;
    mod reply;
    #[cfg(feature = "serde")]
    mod stored;
    mod surface;
    mod verlet;

    pub use acceleration::{Acceleration, Carry};
    pub use impact::{Masses, Split, bounce, exchange, respond, separate, slide, split};
    pub(in crate::motion) use reply::{Bounce, Reply};
    pub(in crate::motion) use surface::law::Law;
    pub use surface::{Energy, Smooth, Speed, Surface};
    pub use verlet::{Link, Particle, Quiet, RelaxError, Stick, relax};
}
mod run;
mod search;
mod slide;
mod solids;
#[cfg(feature = "serde")]
mod stored;
mod sweep_body;
mod sweep_face;
mod sweep_round;
#[cfg(all(test, not(target_os = "none")))]
mod tests;
mod walk {
    //! Walking: what a character needs beyond
    //! [`Mover::move_and_slide`](super::Mover::move_and_slide), for the games that have one.
    //!
    //! On the ground a [`Walker`] goes by *legs* along the floor: a sweep along it, which the
    //! floor's bends upward, steps and walls end, and a look down from its end, which finds where
    //! the floor bends downward. In the air it moves as its mover does, up to the first floor.

    mod assist;
    mod ground;
    mod stride;
    mod walker;

    pub(super) use ground::CONTACT;
    pub use ground::Support;
    pub use walker::{SlopeSpeed, Walked, Walker};
}
mod ways;

pub use body::Body;
pub use cast::BodyHit;
pub use character::{Character, Outcome, Step};

pub use feel::{Feel, Input};
pub use inside::{StartInside, escape};
pub use memo::Memo;
pub use moved::{Hit, Hits, MoveError, Moved, Stuck, Work};
pub use mover::{Mover, Response};
pub use response::{Acceleration, Carry, Energy, Masses, Smooth, Speed, Surface};
pub use solids::{Ridden, Ride};
pub use walk::{SlopeSpeed, Support, Walked, Walker};
