//! A scene: a level, a broad phase and bodies, tied together for those who want one call a frame.
//!
//! [`Scene`] is made of public parts alone, and each of them can be used without it: a [`BroadPhase`](crate::broad::BroadPhase) says who is near whom,
//! [`contact`](crate::query::Contacts) how two bodies overlap, [`separate`](crate::motion::response::separate) and
//! [`exchange`](crate::motion::response::exchange) what that does to them, and a [`Mover`](crate::Mover) takes each through the level. It is plain data.
//!
//! ```
//! use tilesat::broad::SortSweep;
//! use tilesat::scene::{SceneBody, SceneEvent, SceneTag};
//! use tilesat::{Aabb, Circle, Fx, Scene, TileKind, TileKinds, TileMap, Vec2};
//!
//! static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
//! let level = TileMap::from_ascii("#......#\n#......#\n########\n", &KINDS)?; // the floor is at y = 32
//! let mut scene = Scene::<SortSweep<64, SceneTag>, 64>::new(SortSweep::new());
//! let crate_ = scene.insert(&SceneBody::new(Aabb::new(Vec2::from_ints(40, 22), Vec2::from_ints(50, 32))?, 1))?;
//! let ball = scene.insert(&SceneBody::new(Circle::new(Vec2::from_ints(45, 10), Fx::from_num(4))?, 2))?;
//!
//! let gravity = Vec2::from_raw(0, 6_554);
//! let mut met = 0;
//! for _ in 0..90 {
//!     scene.step(&level, gravity, |event| met += u32::from(matches!(event, SceneEvent::Touch { .. })))?;
//! }
//! assert!(met > 0 && scene.awake().is_empty()); // the ball lies on the crate, and both sleep
//! assert!(scene.is_supported(ball)?);
//!
//! let snapshot = scene;
//! scene.push(crate_, Vec2::from_ints(0, -2))?; // a kick from below
//! assert_eq!(scene.step(&level, gravity, |_| {})?.moved, 2); // it woke the crate, the crate the ball
//! scene = snapshot; // and never happened
//! assert!(scene.awake().is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A step
//!
//! ```text
//!   1 gravity      2 body against body, from where       3 each body against the level:
//!                    all are at the step's start           its push, then its velocity
//!      o               o--+   pushes: the farthest           o.
//!      |  v += g       | o|-->  to each side                   `.   never into the solid
//!      v               +--+   velocities: a mean           ______`o___
//! ```
//!
//! 1. Gravity is added to the velocities of all bodies awake, but of those that [float](SceneBody::floats).
//! 2. Every pair that touches, and that the game [lets count](Scene::step_with), is told; sensors do no more than that. Where two overlap, each gets its share of the [push](crate::motion::response::separate) that parts them, and of the
//!    [change of velocity](crate::motion::response::exchange) where they approach. Of all pushes on a body the farthest to each side count, so two floors push no higher than one;
//!    of its n changes, each counts for 1/n.
//! 3. Each body is [moved](crate::Mover::move_and_slide) by its push and then by its velocity, and bounces off the level as its surface says, but not where it
//!    meets it at no more than what gravity gives in two steps: what lies there would hum above it. It is not stored anywhere that the
//!    level's exact overlap test rejects.
//! 4. What has hardly moved for some steps, and all that it touches with it, falls asleep.
//!
//! # What holds
//!
//! - **No body enters the solid.** One that is in it already, or could not be moved for another reason, is [held](SceneEvent::Held): it stays and has no velocity.
//! - **Bodies may overlap** after a step, where the level leaves no room, where many push, where something is fast: two that pass through each other within a step do not meet (how fast is too fast: below). The next
//!   step tells how deep, and pushes again.
//! - **Order does not matter**: neither that of insertion nor that of the broad phase, nor which one it is, where keys are unique (or else slots decide). Only events come in no particular order.
//! - **Images**: mirrored scenes give mirrored bits and moved scenes the same, as far as the [mover](crate::Mover::move_and_slide) and
//!   [degenerate](crate::query::Contact::is_degenerate) contacts (two coincident centres) do.
//! - **Momentum** is kept exactly, and **energy** (mass times speed squared) does not grow, exactly, where two free bodies meet and no third; in a crowd both are up to less
//!   than a raw unit of velocity for each meeting. Energy gained by gravity and by pushes apart is not counted.
//! - **Piles stand**: what lies on the level, or on bodies that do, is not pushed down by what is on top of it; there momentum goes into the ground. A body k bodies up sinks by k times
//!   what falls in one step. It takes a step a body until those on top know that the ground is gone.
//! - **Asleep costs nothing**: a step with all asleep is a look at a counter. A body wakes where one that is awake touches it, where it is pushed, [placed](Scene::place) or
//!   [woken](Scene::wake), and where the scene is told of a region that [changed](Scene::wake_region): a tile that is gone, a [`Solid`](crate::Solid) that
//!   moves, which stops bodies but does not push or carry them (a fixed body does). Sensors wake nobody. It wakes what it touches in
//!   the step after, with all that had fallen asleep with it one step a body.
//!
//! # Cost
//!
//! On a Cortex-M0, 64 bodies, boxes and circles, among tiles of all shapes, with a [`SortSweep`](crate::broad::SortSweep): 184 000 instructions a step while they fly and land, at most 298 000,
//! most of them the mover's; 553 000 where all lie in nooks of slopes and none may sleep; 41 where all do. Stack: 2580 bytes.
//!
#![doc = include_str!("guide.md")]

mod body;
mod set;
mod step;

pub use body::{SceneBody, Shape};
pub use set::{Scene, Sleep};

use crate::broad::{BroadError, Handle, Pair};
use crate::error::RangeError;
use crate::motion::{Hits, MoveError};
use crate::query::Contact;
use core::fmt;

/// What a scene's bodies carry in its broad phase.
pub type SceneTag = crate::broad::Keyed<crate::Filter>;

/// What happened in a step, as it happens; in no particular order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SceneEvent<'a> {
    /// Two bodies, sensors too, touched at the step's start. In every step in which they do and one of them is awake: for begin and end feed `pair` to
    /// [`PairEvents`](crate::broad::PairEvents).
    Touch {
        /// Who; `a` has the smaller key.
        pair: Pair,
        /// How they overlap, from `a` to `b`; none where they only touch.
        contact: Option<&'a Contact>,
    },
    /// A body ran into the level.
    Level {
        /// Who.
        body: Handle,
        /// Into what.
        hits: &'a Hits,
        /// The flags of all that, or-ed.
        flags: u8,
    },
    /// A body could not be moved: it stays where it was, and has no velocity any more.
    Held(SceneError),
}

/// What a step did: for budgets and tests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stepped {
    /// Bodies that the level was asked about: those awake. Zero where all sleep.
    pub moved: u16,
    /// Bodies of those that were [held](SceneEvent::Held).
    pub held: u16,
    /// Bodies that something touched while they slept.
    pub woken: u16,
    /// Bodies that fell asleep.
    pub slept: u16,
    /// Pairs of boxes looked into, twice where bodies ran into each other. Zero where all sleep.
    pub pairs: u32,
    /// Pairs of bodies that touched at the step's start.
    pub touching: u32,
    /// Pairs of bodies that overlapped then and are no sensors; what is left of that shows in the next step.
    pub overlapping: u32,
}

/// What was refused, and of which body; that body, or the scene, is as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SceneError {
    /// The body; none where it is about the call: a body that is not in yet, a gravity.
    pub body: Option<Handle>,
    /// What is wrong.
    pub fault: SceneFault,
}

/// Why.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SceneFault {
    /// The broad phase does not know it, or has no room or place for it.
    Broad(BroadError),
    /// It overlaps the level, or would leave the domain, or is too fast or too large.
    Move(MoveError),
}

impl SceneError {
    pub(super) fn of(body: Handle, fault: impl Into<SceneFault>) -> Self {
        Self { body: Some(body), fault: fault.into() }
    }

    pub(super) fn call(fault: impl Into<SceneFault>) -> Self {
        Self { body: None, fault: fault.into() }
    }
}

impl From<BroadError> for SceneFault {
    fn from(e: BroadError) -> Self {
        Self::Broad(e)
    }
}

impl From<MoveError> for SceneFault {
    fn from(e: MoveError) -> Self {
        Self::Move(e)
    }
}

impl From<RangeError> for SceneFault {
    fn from(e: RangeError) -> Self {
        Self::Move(e.into())
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(body) = self.body {
            write!(f, "body {} (generation {}): ", body.slot(), body.generation())?;
        }
        match self.fault {
            SceneFault::Broad(e) => e.fmt(f),
            SceneFault::Move(e) => e.fmt(f),
        }
    }
}

impl core::error::Error for SceneError {}
