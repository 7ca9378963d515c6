//! A scene: a level, a broad phase and bodies in one call per frame.
//!
//! [`Scene`] is made of public parts alone, and each of them can be used without it: a
//! [`BroadPhase`](crate::broad::BroadPhase) finds the bodies that are near each other,
//! [`contact`](crate::query::Contacts) how two bodies overlap,
//! [`separate`](crate::motion::response::separate) and
//! [`exchange`](crate::motion::response::exchange) what that does to them, and a
//! [`Mover`](crate::Mover) takes each through the level. It is plain data.
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
//! 1. Gravity is added to the velocities of all bodies that are awake and do not
//!    [float](SceneBody::floats).
//! 2. Every pair that touches, and that the game [lets count](Scene::step_with), is reported;
//!    sensors do no more than that. Where two overlap, each gets its share of the
//!    [push](crate::motion::response::separate) that parts them, and of the
//!    [change of velocity](crate::motion::response::exchange) where they approach. Of all pushes on
//!    a body the farthest to each side count, so two floors push no higher than one; of its n
//!    changes, each counts for 1/n.
//! 3. Each body is [moved](crate::Mover::move_and_slide) by its push and then by its velocity, and
//!    bounces off the level as its surface says, but not where it meets it at no more than what
//!    gravity gives in two steps: what lies there would hum above it. It is not stored anywhere
//!    that the level's exact overlap test rejects.
//! 4. What lies on others is moved after them, from the lowest up, and comes out of those that are
//!    carried themselves, in the same step.
//! 5. What is fast is moved last, from one thing that it meets to the next.
//! 6. What has hardly moved for some steps, and all that it touches with it, falls asleep.
//!
//! # What holds
//!
//! - **No body enters the solid.** One that is in it already, or could not be moved for another
//!   reason, is [held](SceneEvent::Held): it stays and has no velocity.
//! - **Bodies may overlap** after a step, where the level leaves no room, where many push. The next
//!   step tells how deep, and pushes again.
//! - **Nothing fast passes anything**: see [below](self#fast-bodies).
//! - **Order does not matter**: neither that of insertion nor that of the broad phase, nor which
//!   one it is, where keys are unique (or else slots decide). Only events come in no particular
//!   order.
//! - **Images**: mirrored scenes give mirrored bits and moved scenes the same, as far as the
//!   [mover](crate::Mover::move_and_slide) and [degenerate](crate::query::Contact::is_degenerate)
//!   contacts (two coincident centres) do.
//! - **Momentum** is kept exactly, and **energy** (mass times speed squared) does not grow,
//!   exactly, where two free bodies meet and no third; in a crowd both are up to less than a raw
//!   unit of velocity for each meeting. Energy gained by gravity and by pushes apart is not
//!   counted.
//! - **Piles stand**: what lies on the level, or on bodies that do, is not pushed down by what is
//!   on top of it; there momentum goes into the ground. Support reaches a whole pile within a step,
//!   and velocities count relative to what carries it: a pile on a lift that moves evenly is the
//!   pile at rest, bit for bit. Boxes of a column keep their order and do not sink into each other.
//!   Balls that lie askew overlap by a raw unit.
//! - **Asleep costs nothing**: a step with all asleep is a look at a counter. A body wakes where
//!   one that is awake touches it, where it is pushed, [placed](Scene::place) or
//!   [woken](Scene::wake), and where you name a region that [changed](Scene::wake_region): a tile
//!   that is gone, a [`Solid`](crate::Solid) that moves, which stops bodies but does not push or
//!   carry them (a fixed body does). Sensors wake nobody. It wakes what it touches in the step
//!   after, with the whole pile of those that touch each other.
//!
//! # Fast bodies
//!
//! A body is fast where it moves by more than half of its smaller side in a step, by its velocity
//! and by what pushes it, or where it is [flagged](SceneBody::fast): a look at where it starts
//! would miss whom it meets on its way. It makes its step from event to event: up to the first
//! thing that it runs into, the level or a body, by the exact cast of two that
//! [both move](crate::query::CastShape::cast_moving); there it bounces or slides, and goes on for
//! the rest of the step. All such events of a scene come in the order of their times. At one time
//! the level comes first, then the pair with the smaller keys.
//!
//! ```text
//!   t = 0        0.4          0.7           |#
//!     o-----------o            o <----------|#   1  ball meets crate       (Meet)
//!               +--+                        |#   2  it meets the wall      (Level)
//!               |  |  what is slow keeps    |#   3  and what it meets next
//!               +--+  its way in this step  |#
//! ```
//!
//! - Two exchange velocities at most once a step, and are reported once, with the time and with how
//!   hard ([`SceneEvent::Meet`]). Where they run into each other again they are led along each
//!   other until the step ends.
//! - What is slow, or sleeps, and is hit has its new velocity from the next step on.
//! - Sensors on the way are reported, too, each time that a body enters one.
//! - After three bodies or eight events of a step a body waits for the next step where it is; none
//!   passes it.
//! - Two that are *not* fast may still pass each other where they clip each other or are squeezed:
//!   large and slow among small things wants the flag.
//! - A fixed body is moved by the game between steps, so it is never on a way: what it jumps over
//!   it does not meet.
//!
//! A fast body with nobody in reach is moved as all others are, so that costs a region query. Else
//! each event takes two casts through the level and a region query, and a test of each other fast
//! body.
//!
//! ```
//! use tilesat::broad::SortSweep;
//! use tilesat::scene::{SceneBody, SceneEvent, SceneTag};
//! use tilesat::{Aabb, Circle, Fx, Scene, TileKinds, TileMap, Toi, Vec2};
//! let level = TileMap::from_ascii("....\n....\n", &TileKinds::EMPTY)?;
//! let mut scene = Scene::<SortSweep<8, SceneTag>, 8>::new(SortSweep::new());
//! let wall = Aabb::new(Vec2::from_ints(50, -40), Vec2::from_ints(51, 40))?;
//! let wall = scene.insert(&SceneBody::fixed(wall, 1))?;
//! let bullet = SceneBody::new(Circle::new(Vec2::ZERO, Fx::from_num(2))?, 2);
//! let bullet = scene.insert(&SceneBody { velocity: Vec2::from_ints(192, 0), floats: true, ..bullet })?;
//! let mut met = None;
//! scene.step(&level, Vec2::ZERO, |event| {
//!     if let SceneEvent::Meet { pair, toi, speed, .. } = event {
//!         met = Some((pair.a, toi, speed));
//!     }
//! })?;
//! assert_eq!(met, Some((wall, Toi::from_raw(1 << 28).unwrap(), Fx::from_num(192)))); // 48 of 192 units
//! assert_eq!(scene.body(bullet)?.shape.position(), Vec2::from_ints(48, 0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Cost
//!
//! On a Cortex-M0, 64 bodies, boxes and circles, among tiles of all shapes, with a
//! [`SortSweep`](crate::broad::SortSweep): 247 000 instructions per step while they fly and land,
//! at most 504 000, most of them the mover's; 995 000 where all lie in nooks of slopes and none may
//! sleep; 32 where all do. Stack: 3072 bytes.
//!
//! # Games in a scene
//!
//! **Moving platforms** are `fixed` bodies that the game [places](crate::Scene::place), not
//! [`Solid`](crate::Solid)s: those are level for a step, stop what runs into them, and neither push
//! nor carry; a body that one moves into is [held](SceneEvent::Held). Give the platform the
//! velocity that it has, and place it *after* the step, in which those on it move with it. Up and
//! down that is all; sideways it carries by friction, as a conveyor does, which is such a body that
//! stays where it is. Where two meet, the surface of the one that bounces more counts, else that
//! with less friction: so *both* need friction. If you place it without its velocity, a platform
//! that rises pushes, and one that goes sideways or down leaves from under what stands on it. What
//! it crushes against the level overlaps it, and is reported.
//!
//! ```
//! use tilesat::broad::SortSweep;
//! use tilesat::scene::{SceneBody, SceneTag};
//! use tilesat::{Aabb, Fx, Ratio, Scene, Surface, TileKinds, TileMap, Vec2};
//! let level = TileMap::from_ascii("........\n........\n", &TileKinds::EMPTY)?;
//! let at = |x, y, w, h| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h));
//! let mut scene = Scene::<SortSweep<8, SceneTag>, 8>::new(SortSweep::new());
//! let surface = Surface::new(Ratio::ZERO, Ratio::ONE); // friction, for both
//! let velocity = Vec2::from_ints(1, -1);
//! let mut way = at(10, 100, 24, 4)?;
//! let lift = scene.insert(&SceneBody { velocity, surface, ..SceneBody::fixed(way, 1) })?;
//! let load = scene.insert(&SceneBody { velocity, surface, ..SceneBody::new(at(18, 92, 8, 8)?, 2) })?;
//! for _ in 0..40 {
//!     scene.step(&level, Vec2::from_raw(0, 6_554), |_| {})?;
//!     way = Aabb::new(way.min() + velocity, way.max() + velocity)?;
//!     scene.place(lift, way)?;
//! }
//! let load = scene.body(load)?.shape.aabb();
//! assert!((load.min().x - way.min().x - Fx::from_num(8)).abs() < 1); // where it stood
//! assert_eq!(load.max().y, way.min().y); // and on it
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **A hero** that a [`Walker`](crate::Walker) moves is in the scene as a body that
//! [floats](SceneBody::floats), with a mass and no velocity. Each frame: walk it through the level,
//! `place` it, `step`, and go on from where the scene has pushed it, which the level allows. It
//! meets triggers, and pushes crates by being in their way; what hits it changes its velocity in
//! the scene: add that to the walker's or not, and set it to zero. As a `fixed` body it would be
//! pushed by nobody, and would meet nothing that is fixed itself. The walker does not know that it
//! stands on a crate: [`is_supported`](crate::Scene::is_supported) does.
//!
//! ```
//! use tilesat::broad::SortSweep;
//! use tilesat::scene::{SceneBody, SceneEvent, SceneTag, Shape};
//! use tilesat::{Aabb, Axis, Filter, Mover, Scene, TileKind, TileKinds, TileMap, Vec2, Walker};
//! static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
//! let level = TileMap::from_ascii("........\n........\n########", &KINDS)?; // the floor is at y = 32
//! let at = |x, y, w, h| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h));
//! let mut scene = Scene::<SortSweep<8, SceneTag>, 8>::new(SortSweep::new());
//! let mut hero = at(4, 20, 8, 12)?;
//! let body = scene.insert(&SceneBody { floats: true, ..SceneBody::new(hero, 1) })?;
//! let box_ = scene.insert(&SceneBody::new(at(40, 22, 10, 10)?, 2))?;
//! let door = SceneBody { filter: Filter::default().with_sensor(true), ..SceneBody::fixed(at(24, 0, 4, 32)?, 3) };
//! let door = scene.insert(&door)?;
//! let (walker, mut floor, mut passed) = (Walker::new(Mover::platformer(Axis::NEG_Y)), None, false);
//! for _ in 0..40 {
//!     let walked = walker.walk(&level, &hero, Vec2::from_ints(1, 1), floor)?;
//!     floor = walked.floor;
//!     scene.place(body, walked.moved.body)?;
//!     scene.step(&level, Vec2::from_raw(0, 6_554), |event| {
//!         passed |= matches!(event, SceneEvent::Touch { pair, .. } if (pair.a, pair.b) == (body, door));
//!     })?;
//!     scene.set_velocity(body, Vec2::ZERO)?;
//!     if let Shape::Aabb(pushed) = scene.body(body)?.shape {
//!         hero = pushed;
//!     }
//! }
//! assert!(passed && scene.body(box_)?.shape.position().x > 41); // it pushes the box before it
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Sensors** wake nobody, whatever is done with them. One with a mass meets sleepers when you
//! have placed it; give it `floats`. A fixed one and a body that sleeps both rest: where it is put
//! on one, nothing is reported until that one wakes; call [`wake`](crate::Scene::wake) for what
//! [`near`](crate::Scene::near) finds there.
//!
//! **Keys** must be unique for results that do not depend on the order of insertion. Where two are
//! equal nothing fails: the one in the smaller slot is `a`, and slots depend on that order.
//!
//! **Grids with [`Border::Refuse`](crate::broad::Border::Refuse)**: a body that would leave is held
//! at its last place in every step, without a velocity, until it falls asleep there. It is the
//! game's to remove it when it is told, or to have a border that takes all.
//!
//! **Rollback** takes a [`Snapshot`], or copies the scene, and with it all that the game's own rules read:
//! [`PairEvents`](crate::broad::PairEvents), [`Exceptions`](crate::broad::Exceptions), the bytes of
//! tiles that change, solids.

mod body;
mod error;
mod meeting;
mod met;
mod pairs;
mod piles;
mod set;
mod shape;
mod snapshot;
mod step;
#[cfg(feature = "serde")]
mod stored;
mod swept;
mod way;

pub use body::SceneBody;
pub use error::{SceneError, SceneFault};
pub use set::{Scene, Sleep};
pub use shape::Shape;
pub use snapshot::Snapshot;

use crate::broad::{Handle, Pair};
use crate::motion::Hits;
use crate::num::{Axis, Fx, Toi};
use crate::query::Contact;

/// What a scene's bodies carry in its broad phase.
pub type SceneTag = crate::broad::Keyed<crate::Filter>;

/// What happened in a step, as it happens; in no particular order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SceneEvent<'a> {
    /// Two bodies, sensors too, touched at the step's start. In every step in which they do and one
    /// of them is awake: for begin and end feed `pair` to [`PairEvents`](crate::broad::PairEvents).
    Touch {
        /// Who; `a` has the smaller key.
        pair: Pair,
        /// How they overlap, from `a` to `b`; none where they only touch.
        contact: Option<&'a Contact>,
    },
    /// Two bodies of which one is [fast](self#fast-bodies) ran into each other on their way,
    /// sensors too.
    Meet {
        /// Who; `a` has the smaller key.
        pair: Pair,
        /// When, as a part of the step.
        toi: Toi,
        /// The normal, from `a` to `b`.
        axis: Axis,
        /// How fast they came nearer along the normal, in units per step, to nearest.
        speed: Fx,
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
    /// Bodies that were moved through the level: those awake. Zero where all sleep.
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
    /// Pairs of bodies that overlapped then and are no sensors; what is left of that shows in the
    /// next step.
    pub overlapping: u32,
}
