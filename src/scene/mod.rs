//! A scene: a level, a broad phase and bodies in one call per frame.
//!
//! [`Scene`] consists of public parts, and you can use each without it. A
//! [`BroadPhase`](crate::broad::BroadPhase) finds the bodies that are near each other.
//! [`contact`](crate::query::Contacts) finds how two bodies overlap.
//! [`separate`](crate::motion::response::separate) and
//! [`exchange`](crate::motion::response::exchange) part them and change their velocities. A
//! [`Mover`](crate::Mover) moves each through the level. A scene is plain data.
//!
//! ```
//! use tilesat::scene::{SceneBody, SceneEvent, SortSweepScene};
//! use tilesat::{Aabb, Circle, Fx, TileKind, TileKinds, TileMap, Vec2};
//!
//! static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
//! let level = TileMap::from_ascii("#......#\n#......#\n########\n", &KINDS)?; // the floor is at y = 32
//! let mut scene = SortSweepScene::<64>::empty();
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
//! 2. Every touching pair that the game [accepts](Scene::step_with) is reported; sensors do no more
//!    than that. If two overlap, each gets its share of the
//!    [push](crate::motion::response::separate) that parts them. If they approach, each gets its
//!    share of the [change of velocity](crate::motion::response::exchange). Of all pushes on a body
//!    the farthest to each side count, so two floors push no higher than one. Of its n changes,
//!    each counts for 1/n.
//! 3. Each body is [moved](crate::Mover::move_and_slide) by its push and then by its velocity. It
//!    bounces off the level as its surface says. A body that meets the level at no more than the
//!    gravity of two steps does not bounce: it would jitter there. Every new position passes the
//!    level's exact overlap test.
//! 4. Bodies that lie on others are moved after them, from the lowest up. In the same step they
//!    come out of bodies that are carried themselves.
//! 5. Fast bodies are moved last, from one hit to the next.
//! 6. Bodies that have hardly moved for some steps fall asleep, together with all that they touch.
//!
//! # What holds
//!
//! - **No body enters the solid.** A body that is in it already, or cannot be moved for another
//!   reason, is [held](SceneEvent::Held): it stays and has no velocity.
//! - **Bodies may overlap** after a step, if the level leaves no room or many push. The next step
//!   finds how deep, and pushes again. Of a body that was pushed in vain, others then come out the
//!   whole way. A heavy body comes into a light one at a wall by two of its steps, and by what
//!   gravity adds in three.
//! - **Nothing fast passes anything**: see [below](self#fast-bodies).
//! - **Order does not matter**, neither that of insertion nor that of the broad phase, nor the
//!   choice of broad phase. For this, keys must be unique (otherwise slots decide). Only events
//!   come in no particular order.
//! - **Images**: mirrored scenes give mirrored bits and moved scenes the same bits, as far as the
//!   [mover](crate::Mover::move_and_slide) and [degenerate](crate::query::Contact::is_degenerate)
//!   contacts (two coincident centres) do.
//! - **Momentum** is kept exactly, and **energy** (mass times speed squared) never grows, exactly,
//!   if two free bodies meet and no third. In a crowd each meeting may change both by less than a
//!   raw unit of velocity. Energy gained from gravity and from pushes is not counted.
//! - **Piles stand**: a body that lies on the level, or on bodies that do, is not pushed down by
//!   those on top of it; there momentum goes into the ground. Support reaches a whole pile within a
//!   step. Velocities count relative to the carrier: a pile on a lift that moves evenly is the pile
//!   at rest, bit for bit. Boxes of a column keep their order and do not sink into each other.
//!   Balls that lie askew overlap by a raw unit.
//! - **Sleep costs nothing**: a step with all bodies asleep reads a counter. A body wakes if a body
//!   that is awake touches it, or if you push, [place](Scene::place) or [wake](Scene::wake) it. It
//!   also wakes if you name a region that [changed](Scene::wake_region), and if a solid that
//!   [moves](Scene::ride) comes near it. A tile or a solid that you take away wakes nobody: name its
//!   region. Sensors wake nobody. A woken body wakes the bodies that it touches in the next step,
//!   with the whole pile of those that touch each other.
//!
//! # Fast bodies
//!
//! A body is fast if it moves by more than half of its smaller side in a step, by its velocity and
//! by pushes, or if it is [flagged](SceneBody::fast). A test of its start alone would miss the
//! bodies on its way. A fast body makes its step from event to event. It goes up to its first hit,
//! the level or a body, found by the exact cast of two that [both
//! move](crate::query::CastShape::cast_moving). There it bounces or slides, and continues for the
//! rest of the step. All such events of a scene come in the order of their times. At one time the
//! level comes first, then the pair with the smaller keys.
//!
//! ```text
//!   t = 0        0.4          0.7           |#
//!     o-----------o            o <----------|#   1  ball meets crate       (Meet)
//!               +--+                        |#   2  it meets the wall      (Level)
//!               |  |  slow bodies keep      |#   3  and so on
//!               +--+  their way this step  |#
//! ```
//!
//! - Two bodies exchange velocities at most once per step. The event reports them once, with the
//!   time and the speed ([`SceneEvent::Meet`]). If they hit each other again, the one that nothing
//!   has stopped yields: a body slides along the wall that another one presses it against.
//! - A slow or sleeping body that is hit uses its new velocity from the next step on.
//! - Sensors on the way are reported too, each time that a body enters one.
//! - After three bodies or eight events in a step, a body waits for the next step where it is. No
//!   body passes it.
//! - Two bodies that are *not* fast may still pass each other if they clip each other or are
//!   squeezed. Flag large, slow bodies among small ones.
//! - The game moves a fixed body between steps, so it is never on a way: it does not meet the
//!   bodies that it jumps over.
//!
//! A fast body with nobody in reach is moved like all others; that costs one region query.
//! Otherwise each event takes a few casts through the level and region queries, and tests the boxes
//! of all fast bodies. In a crowd that presses itself, this grows faster than the square of the
//! number: flag bullets, crushers and the hero, not a crowd.
//!
//! ```
//! use tilesat::scene::{SceneBody, SceneEvent, SortSweepScene};
//! use tilesat::{Aabb, Circle, Fx, TileKinds, TileMap, Toi, Vec2};
//! let level = TileMap::from_ascii("....\n....\n", &TileKinds::EMPTY)?;
//! let mut scene = SortSweepScene::<8>::empty();
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
//! [`SortSweep`](crate::broad::SortSweep): 221 000 instructions per step while they fly and land,
//! at most 430 000, most of them the mover's. 804 000 if all lie in nooks of slopes and none may
//! sleep; 57 if all sleep. A scene that [remembers](Scene::remembering) makes such steps for a
//! fifteenth of that: 53 000. Stack: 3.9 KB for such a step. [`Scene`] has other kinds of scenes.
//!
//! # Games in a scene
//!
//! **Capsules** are bodies of a `Scene<B, 64, 0, WithCapsules>`: see [`WithCapsules`]. Others link
//! none of their code. **Turned boxes, polygons, slanted capsules** need
//! [`AnyShape`](crate::shape::AnyShape) there.
//!
//! **Moving platforms** are [`Solid`](crate::Solid)s or
//! [`ConvexSolid`](crate::world::ConvexSolid)s: [`ride`](crate::Scene::ride) moves them, with what
//! they carry and push, and each step sees them in a [`Joined`](crate::Joined) level. Without `ride`
//! a solid only blocks, and a body that it enters is [held](SceneEvent::Held).
//!
//! They can also be `fixed` bodies that the game [places](crate::Scene::place). Those push by their
//! velocity, and carry by friction. Set the platform's velocity, and place it *after* the step, in
//! which the bodies on it move with it. That is all for up and down. Sideways *both* need friction:
//! if two bodies meet, the surface that bounces more counts, or else the one with less friction. A
//! conveyor is such a body that stays where it is.
//!
//! If you place a platform without setting its velocity, it pushes as it rises, and slides away
//! below its load as it goes sideways or down. A body that it crushes against the level overlaps
//! it, and is reported.
//!
//! ```
//! use tilesat::scene::{SceneBody, SortSweepScene};
//! use tilesat::{Aabb, Fx, Ratio, Surface, TileKinds, TileMap, Vec2};
//! let level = TileMap::from_ascii("........\n........\n", &TileKinds::EMPTY)?;
//! let at = |x, y, w, h| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h));
//! let mut scene = SortSweepScene::<8>::empty();
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
//! [floats](SceneBody::floats), with a mass and no velocity. In each frame, walk it through the
//! level, `place` it, `step`, and continue from where the scene pushed it, which the level allows.
//! It meets triggers, and pushes crates that it walks into. A hit changes its velocity in the
//! scene: add that to the walker's or not, and set it to zero. A `fixed` body would not do: nobody
//! pushes it, and it does not meet other fixed bodies. The walker does not know that it stands on a
//! crate, but [`is_supported`](crate::Scene::is_supported) does.
//!
//! ```
//! use tilesat::scene::{SceneBody, SceneEvent, Shape, SortSweepScene};
//! use tilesat::{Aabb, Axis, Filter, Mover, TileKind, TileKinds, TileMap, Vec2, Walker};
//! static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
//! let level = TileMap::from_ascii("........\n........\n########", &KINDS)?; // the floor is at y = 32
//! let at = |x, y, w, h| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h));
//! let mut scene = SortSweepScene::<8>::empty();
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
//! **Ghosts, bullets, pick-ups**: what happens where two bodies meet is a [`Reply`], which
//! [`step_with`](Scene::step_with) asks for: they ignore or cross each other, slide, touch or
//! bounce. A [`Filter`](crate::Filter) does the same for whole groups, and costs less. What the level
//! is to a body is the other half: [`SceneBody::responses`] for what stops it, and
//! [`step_in`](Scene::step_in) for the tiles that it passes.
//! [`step_along`](Scene::step_along) reports them.
//!
//! **Tiles that only some bodies meet**: give the tiles flags, and write one table of the flags
//! that each kind of body passes. It makes a table of tiles for each kind of body
//! ([`TileKinds::passing`](crate::TileKinds::passing)), and these make a level for each. The levels
//! share their tiles: a door that opens does so for all. The table of flags works alike for levels
//! of every [set](crate::world::Set) of shapes.
//!
//! ```
//! use tilesat::scene::{SceneBody, SortSweepScene};
//! use tilesat::world::Set;
//! use tilesat::{AllShapes, Blocks, Circle, Slopes, TileKind, TileKinds, TileMap, TileShape, Vec2, fx};
//! const CURTAIN: u8 = 1;
//! const FENCE: u8 = 2;
//! // Knights, ghosts, arrows: the flags that each passes.
//! const PASSED: [u8; 3] = [0, CURTAIN | FENCE, FENCE];
//! const fn of_bodies(kinds: &TileKinds) -> [TileKinds; 3] {
//!     [kinds.passing(PASSED[0]), kinds.passing(PASSED[1]), kinds.passing(PASSED[2])]
//! }
//!
//! const BLOCKS: TileKinds = TileKinds::EMPTY
//!     .with(b'#', TileKind::FULL)
//!     .with(b'c', TileKind::FULL.with_flags(CURTAIN))
//!     .with(b'f', TileKind::FULL.with_flags(FENCE));
//! const SLOPES: TileKinds = BLOCKS.with(b'/', TileKind::of(TileShape::SlopeBottomRight));
//! const ROUND: TileKinds = SLOPES.with(b'o', TileKind::of(TileShape::ConvexBottomRight));
//! static BLOCKS_OF: [TileKinds; 3] = of_bodies(&BLOCKS);
//! static SLOPES_OF: [TileKinds; 3] = of_bodies(&SLOPES);
//! static ROUND_OF: [TileKinds; 3] = of_bodies(&ROUND);
//!
//! /// Where a knight, a ghost and an arrow end that start at x = 8.
//! fn ends<S: Set>(rows: &str, kinds: &'static [TileKinds; 3]) -> Result<[i32; 3], Box<dyn std::error::Error>> {
//!     let tiles = TileMap::from_ascii(rows, &TileKinds::EMPTY)?;
//!     let level = |kind: usize| tiles.with_kinds::<S>(&kinds[kind]);
//!     let levels = [level(0)?, level(1)?, level(2)?];
//!     let mut scene = SortSweepScene::<8>::empty();
//!     for key in 0..3 {
//!         let ball = Circle::new(Vec2::from_ints(8, 8), fx!(4))?;
//!         scene.insert(&SceneBody { velocity: Vec2::from_ints(100, 0), ..SceneBody::new(ball, key) })?;
//!     }
//!     // The key says of which kind a body is. These meet only the level.
//!     scene.step_in(|body| &levels[body.key as usize], Vec2::ZERO, |_| false, |_| ())?;
//!     let mut ends = [0; 3];
//!     for (_, body) in scene.bodies() {
//!         ends[body.key as usize] = body.shape.position().x.to_num();
//!     }
//!     Ok(ends)
//! }
//! let ends_of_all = [28, 76, 44]; // before the fence, the wall and the curtain
//! assert_eq!(ends::<Blocks>("..fc.#.\n.......", &BLOCKS_OF)?, ends_of_all);
//! assert_eq!(ends::<Slopes>("..fc.#.\n../../.", &SLOPES_OF)?, ends_of_all);
//! assert_eq!(ends::<AllShapes>("..fc.#.\n..o../.", &ROUND_OF)?, ends_of_all);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Landings**: a body at rest hits the floor in every step. To hear a landing once, feed what the
//! body hits to a list of [events](crate::broad::PairEvents); the key is any pair that you choose.
//! [`Hit::approach`](crate::motion::Hit::approach) says how hard a hit was.
//!
//! ```
//! use tilesat::broad::{Handle, PairEvent, PairEvents};
//! use tilesat::scene::{SceneBody, SceneEvent, SortSweepScene};
//! use tilesat::{Aabb, Cell, Fx, TileKind, TileKinds, TileMap, Vec2};
//! static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
//! let level = TileMap::from_ascii("...\n...\n...\n###", &KINDS)?; // the floor is at y = 48
//! let mut scene = SortSweepScene::<8>::empty();
//! let crate_ = scene.insert(&SceneBody::new(Aabb::new(Vec2::from_ints(4, 4), Vec2::from_ints(12, 12))?, 1))?;
//! let mut contacts = PairEvents::<16, (Handle, Cell)>::new();
//! let (mut landings, mut hardest) = (0, Fx::ZERO);
//! for _ in 0..600 {
//!     scene.step(&level, Vec2::from_raw(0, 1 << 14), |event| {
//!         if let SceneEvent::Level { body, hits, velocity, .. } = event {
//!             for hit in hits {
//!                 contacts.feed((body, hit.cell));
//!                 hardest = hardest.max(hit.approach(velocity));
//!             }
//!         }
//!     })?;
//!     // A body that sleeps reports nothing, and has left nothing.
//!     contacts.finish(|(body, _)| scene.is_awake(*body).is_ok_and(|awake| !awake))?;
//!     landings += contacts.iter().filter(|event| matches!(event, PairEvent::Begin(_))).count();
//! }
//! assert_eq!((landings, hardest), (1, Fx::from_num(4.25)));
//! assert!(!scene.is_awake(crate_)? && contacts.iter().count() == 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Sensors** wake nobody, whatever you do with them. A sensor with a mass meets sleeping bodies
//! once you have placed it; give it `floats`. A fixed sensor and a sleeping body both rest. If you
//! put the sensor on such a body, nothing is reported until the body wakes. Call
//! [`wake`](crate::Scene::wake) for the bodies that [`near`](crate::Scene::near) finds there.
//!
//! **Keys** must be unique for results that do not depend on the order of insertion. If two are
//! equal, nothing fails: the one in the smaller slot is `a`, and slots depend on that order.
//!
//! **Grids with [`Border::Refuse`](crate::broad::Border::Refuse)** hold a body that would leave at
//! its last position in every step, without a velocity, until it falls asleep there. Remove it when
//! the event reports it, or use a border that accepts all.
//!
//! **Rollback** takes a [`Snapshot`], or copies the scene. It also needs everything that the game's
//! own rules read: [`PairEvents`](crate::broad::PairEvents),
//! [`Exceptions`](crate::broad::Exceptions), the bytes of tiles that change, solids.

mod blocked;
mod body;
mod change;
mod error;
mod idle;
mod kernel;
mod lean;
mod meeting;
mod memory;
mod met;
mod pairs;
mod piles;
mod reply;
mod ride;
mod set;
mod shape;
mod snapshot;
mod step;
#[cfg(feature = "serde")]
mod stored;
mod swept;
mod trip;
mod view;
mod way;

pub use body::SceneBody;
pub use error::{SceneError, SceneFault};
pub use kernel::BodyShape;
pub use reply::{Answer, Reply};
pub use set::{Scene, Sleep, SortSweepScene};
pub use shape::{Shape, WithCapsules};
pub use snapshot::Snapshot;

use crate::broad::{Handle, Pair};
use crate::motion::Hits;
use crate::num::{Axis, Fx, Toi, Vec2};
use crate::query::Contact;

/// The tag of each body in the broad phase.
pub type SceneTag = crate::broad::Keyed<crate::Filter>;

/// An event of a step, reported as it happens, in no particular order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SceneEvent<'a> {
    /// Two bodies, at most one of them a sensor, touched at the step's start. Reported in every
    /// step in which they touch and one of them is awake. For begin and end, pass `pair` to
    /// [`PairEvents`](crate::broad::PairEvents).
    Touch {
        /// The two bodies; `a` has the smaller key.
        pair: Pair,
        /// How they overlap, from `a` to `b`; `None` if they only touch.
        contact: Option<&'a Contact>,
    },
    /// Two bodies, at most one of them a sensor, ran into each other on their way. One of them is
    /// [fast](self#fast-bodies).
    Meet {
        /// The two bodies; `a` has the smaller key.
        pair: Pair,
        /// The time, as a part of the step.
        toi: Toi,
        /// The normal, from `a` to `b`.
        axis: Axis,
        /// How fast they approached along the normal, in units per step, rounded to nearest.
        speed: Fx,
    },
    /// A body ran into the level.
    Level {
        /// The body.
        body: Handle,
        /// Its hits.
        hits: &'a Hits,
        /// The flags of all hits, or-ed.
        flags: u8,
        /// The velocity that it hit with. [`Hit::approach`](crate::motion::Hit::approach) says from
        /// it how hard each hit was.
        velocity: Vec2,
    },
    /// A body could not be moved. It stays where it was, and has no velocity any more.
    Held(SceneError),
}

/// The work of a step, for budgets and tests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stepped {
    /// Bodies that were moved through the level: those awake by then. Zero if all sleep.
    pub moved: u16,
    /// Bodies of those that were [held](SceneEvent::Held).
    pub held: u16,
    /// Sleeping bodies that were touched.
    pub woken: u16,
    /// Bodies that fell asleep.
    pub slept: u16,
    /// Pairs of boxes tested, twice if bodies ran into each other. Zero if all sleep. Memory saves
    /// some of it.
    pub pairs: u32,
    /// Pairs of bodies that touched at the step's start.
    pub touching: u32,
    /// Pairs of bodies that overlapped at the step's start, without sensors. A remaining overlap
    /// counts in the next step.
    pub overlapping: u32,
}
