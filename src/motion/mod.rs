//! Motion: where a body ends up when it moves through a level.
//!
//! [`Mover::move_and_slide`] sweeps a [`Body`] against the level's
//! [features](crate::world::Feature) and stops it exactly where it first touches. A body is a box,
//! a circle, a capsule, an oriented box, a polygon, or a compound of these. The [`Response`] then
//! decides the new velocity for the rest of the motion, at most [`Mover::ITERATIONS`] times.
//! Every new position passes the level's exact overlap test before it is kept (*verify, then
//! commit*). A body that starts outside of the solid therefore ends outside of it, at any speed.
//!
//! | question | answer |
//! |---|---|
//! | Does a seam between tiles stop or lift a body? | No: interior faces and flat joints have no features. |
//! | Is a surface a hit if the body touches it, but does not move into it? | No. Add gravity in every frame, on the ground too, or `floor` stays false. |
//! | On which side does a box hit a corner that it meets exactly? | On the side that opposes the motion more; on a tie, on the vertical one. |
//! | How does a circle pass a corner? | It moves around it as an exact disc, not as a square. |
//! | How does a capsule pass a corner? | Its ends move around it as discs, its sides slide straight. |
//! | Does a joint between two slopes, or of a floor and a quarter pipe, stop a body? | No. The body keeps the part of its velocity along the surface. |
//! | What happens in a wedge that is too narrow? | The body stops where it touches both sides, and rests there. |
//! | Does a body under gravity rest in a V, in a bowl, between domes? | Yes. It keeps the same position and velocity for ever. |
//! | What do one-way faces block? | Only a body that is entirely in front of them when the motion starts, and that moves in. |
//! | What if a platform moves under the body, or a door against it? | [`Mover::ride`] carries it, pushes it, or reports that it is [squashed](Ride::Squashed). |
//! | What if the platform is a slope or a ball, or turns? | Use [`Mover::ride_convex`] instead. |
//! | What if the body starts inside the solid? | The call returns [`Stuck`], and nothing moves. [`StartInside::Ignore`] lets the body leave, but then use **no gravity while it is inside**, or it falls through the floor below a closed door. [`escape`] pushes out a body that reaches the surface. It is better never to [close a door](#doors) on a body. |
//!
//! # Doors
//!
//! You close a door by changing tiles, which moves no body, or by moving a [`Solid`](crate::Solid),
//! which does. Each of these keeps bodies out of it:
//!
//! - **Test first.** Keep the door open while `door.overlaps(&body)` is true for any body.
//! - **Push.** A door that is a moving [`Solid`](crate::Solid) pushes bodies aside with
//!   [`Mover::ride`], or reports that one is [squashed](Ride::Squashed). Then stop the door, or
//!   remove the body. [`Scene::ride`](crate::Scene::ride) has already moved the door then: look
//!   before you move it. Once the door is closed, tiles can replace it.
//! - **Put back.** Keep the last position at which the level did not overlap the body, and put the
//!   body back there.
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
//! the time between two pictures until it fills a step. A run then depends only on its input, and a
//! replay is the list of keys.
//!
//! For slow motion, take *fewer steps*, not smaller velocities. Half a velocity is rounded again,
//! gravity would have to shrink with the square, and the run would differ. Between two steps, draw
//! a point between two positions with [`Vec2::lerp`](crate::Vec2::lerp). Never move a body there.
//!
//! ```
//! use tilesat::{Aabb, Axis, Mover, Ratio, TileKind, TileKinds, TileMap, Vec2, fx};
//!
//! static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
//! let level = TileMap::from_ascii("      \n      \n######\n", &KINDS)?;
//! let mover = Mover::platformer(Axis::NEG_Y);
//! let step = |(body, v): (Aabb, Vec2)| {
//!     let moved = mover.move_and_slide(&level, &body, v + Vec2::new(fx!(0), fx!(0.15))).unwrap();
//!     (moved.body, moved.velocity)
//! };
//! let start = (Aabb::new(Vec2::from_ints(4, 2), Vec2::from_ints(12, 14))?, Vec2::from_ints(1, 0));
//!
//! // Plays `pictures` pictures of `speed / 60` steps each. Returns the last state, and what is drawn.
//! let play = |speed: u32, pictures: u32| {
//!     let (mut time, mut before, mut now) = (0, start, start);
//!     let mut drawn = start.0.min();
//!     for _ in 0..pictures {
//!         time += speed;
//!         while time >= 60 {
//!             time -= 60;
//!             (before, now) = (now, step(now));
//!         }
//!         drawn = before.0.min().lerp(now.0.min(), Ratio::new(time, 60).unwrap()); // up to a step late, and smooth
//!     }
//!     (now, drawn)
//! };
//! let (normal, slow) = (play(60, 40), play(20, 120)); // a third of the speed, three times as many pictures
//! assert_eq!(normal, slow); // the same run, bit for bit
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod along;
mod block_entry;
mod block_lines;
mod blocks;
mod body;
mod cast;
mod character;
mod character_step;
mod contact;
mod feel;
mod first_leg;
mod free_way;
mod inside;
mod look_ahead;
mod lying;
mod memo;
mod moved;
mod mover;
mod only_hit;
mod order;
mod plan;
mod plane;
pub mod response {
    //! The response toolkit: how a contact changes a velocity, a pair of bodies or a string of
    //! points.
    //!
    //! Small functions and plain values over the public types, for movers and for games that
    //! resolve contacts themselves. They push a body out, split its velocity at the surface, and
    //! scale both parts, but only if the body moves in. Two bodies share a push by their masses.
    //! Lengths are in units, velocities in units per frame, accelerations in units per frame
    //! squared. Rounding never gains speed, never leads into a surface, and is the same for both
    //! signs.
    //!
    //! | question | answer |
    //! |---|---|
    //! | Which part of this velocity goes into the surface? | [`split`] |
    //! | What is the velocity after the contact? | [`slide`], [`bounce`], [`respond`]; a [`Surface`] in a mover |
    //! | How does a ball bounce for ever? | Keep a [`Speed`] beside its velocity, or its [`Energy`] if there is gravity. |
    //! | What if gravity is less than a raw unit per frame? | Use an [`Acceleration`] with a [`Carry`]. |
    //! | How are two bodies separated? | [`separate`], by their [`Masses`] |
    //! | How do their velocities change? | [`exchange`] |
    //! | How do I make ropes, chains and ragdolls? | Join [`Particle`]s with [`Stick`]s. [`relax`] restores their lengths; let them sleep when [`Quiet`]. |
    //!
    //! The ideas come from the tutorials and the talk on N by Metanet Software (projection, split
    //! velocities, Verlet points). Friction is Coulomb's. The points are those of Jakobsen's
    //! *Advanced Character Physics* (2001).

    mod acceleration;
    mod bounce;
    mod impact;
    mod law;
    mod reply;
    #[cfg(feature = "serde")]
    mod stored;
    mod surface;
    mod table;
    mod verlet;

    pub use acceleration::{Acceleration, Carry};
    pub(in crate::motion) use bounce::{Bounce, ReplyFn};
    pub use impact::{Masses, Split, bounce, exchange, respond, separate, slide, split};
    pub use law::{ByFlags, ByHit, Smooth};
    pub(in crate::motion) use law::{Law, Plain};
    pub use surface::{Energy, Speed, Surface};
    pub use table::{Response, Responses};
    pub use verlet::{Link, Particle, Quiet, RelaxError, Stick, relax};
}
mod rider;
mod run;
mod search;
mod slide;
mod slope_limit;
mod solids;
mod stance;
#[cfg(feature = "serde")]
mod stored;
mod sweep_body;
mod sweep_capsule;
mod sweep_convex;
mod sweep_face;
mod sweep_round;
#[cfg(all(test, not(target_os = "none")))]
mod tests;
mod touch_convex;
mod touched_plane;
mod walk {
    //! Walking: a [`Walker`] follows floors, which
    //! [`Mover::move_and_slide`](super::Mover::move_and_slide) does not.
    //!
    //! On the ground a [`Walker`] moves by *legs*. Each leg is a sweep along the floor, which ends
    //! at an upward bend, a step or a wall. A look down from its end finds where the floor bends
    //! downward. In the air it moves as its mover does, up to the first floor.

    mod assist;
    mod frame;
    mod ground;
    mod step;
    mod stride;
    mod walker;

    pub use frame::Walked;
    pub(super) use ground::CONTACT;
    pub use ground::Support;
    pub(super) use stride::Footing;
    pub(super) use walker::checked;
    pub use walker::{SlopeSpeed, Walker};
}
mod ways;

pub use body::Body;
pub use cast::BodyHit;
pub(crate) use cast::cast_in;
pub use character::Character;
pub use feel::{Feel, Input, OnLeave, Outcome, Step};
pub use inside::{StartInside, escape, turn};
pub use memo::Memo;
pub use moved::{Hit, Hits, MoveError, Moved, Stuck, Work};
pub use mover::Mover;
pub use response::{Acceleration, ByFlags, ByHit, Carry, Energy, Masses, Response, Responses, Smooth, Speed, Surface};
pub use rider::MovingSolid;
pub(crate) use run::first_place;
pub use solids::{Ridden, Ride};
pub use walk::{SlopeSpeed, Support, Walked, Walker};
