//! Scenes: bodies that move through a level and meet each other, in one call per frame.
//!
//! [`Scene`] consists of public parts, and you can use each part alone. A
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
//! assert_eq!(scene.step(&level, gravity, |_| {})?.moved, 2); // the kick woke the crate, and the crate woke the ball
//! scene = snapshot; // undone
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
//! 2. Every touching pair that the game [accepts](Scene::step_with) is reported; for sensors, that
//!    is all. If two overlap, each receives its share of the
//!    [push](crate::motion::response::separate) that parts them. If they approach, each receives
//!    its share of the [change of velocity](crate::motion::response::exchange). Only the farthest
//!    push to each side counts, so two floors push no higher than one. If a body has n changes,
//!    each counts for 1/n. In a corner of slick walls along x and y, each wall counts whole.
//! 3. Each body is [moved](crate::Mover::move_and_slide) by its push and then by its velocity. Its
//!    surface decides how it bounces off the level. A body that meets the level at no more than the
//!    gravity of two steps does not bounce: it would jitter there. A body that lies on something
//!    loses velocity along gravity, too, as far as the push leads against it. So does one that
//!    others wedge, but not along a floor on which it stands. A fixed body ends the motion. Every
//!    new position passes the level's exact overlap test.
//! 4. Bodies that lie on others are moved after them, from the lowest up. In the same step they are
//!    pushed out of bodies that are carried.
//! 5. Fast bodies are moved last, from one hit to the next.
//! 6. Bodies that have hardly moved for some steps fall asleep, together with all bodies that they
//!    touch. One that comes to touch another in this step stays awake, so the next step reports it.
//!
//! # Guarantees
//!
//! - **No body enters the solid.** A body that is in it already, or cannot be moved for another
//!   reason, is [held](SceneEvent::Held): it stays and has no velocity.
//! - **Bodies may overlap** after a step, if the level leaves no room or many push. The next step
//!   finds how deep, and pushes again. If a push could not move a body, the other body then makes
//!   the whole correction. A heavy body can sink into a light one at a wall by two of its steps,
//!   plus what gravity adds in three.
//! - **Fixed bodies keep out all others.** The motion of a slow body ends where it would enter one
//!   by more than 1/256 of its smaller side, or goes on along it. A body that lies on one may be in
//!   it by an eighth of that side. So nothing passes a gap that is too narrow.
//! - **Nothing fast passes anything**: see [below](self#fast-bodies).
//! - **Order does not matter**, neither of insertion nor of the broad phase, nor the choice of
//!   broad phase. For this, keys must be unique (otherwise slots decide). Events come in no
//!   particular order.
//! - **Images**: mirrored scenes give mirrored bits and moved scenes the same bits, as far as the
//!   [mover](crate::Mover::move_and_slide) and [degenerate](crate::query::Contact::is_degenerate)
//!   contacts (two coincident centres) do.
//! - **Momentum** is kept exactly, and **energy** (mass times speed squared) never grows, exactly,
//!   if two free bodies meet and no third. In a crowd each meeting may change both by less than a
//!   raw unit of velocity. Energy gained from gravity and from pushes is not counted.
//! - **Piles stand**: a body that lies on the level, or on bodies that do, is not pushed down by
//!   those on top of it. The momentum goes into the ground. Support reaches a whole pile within a
//!   step. Velocities are relative to the carrier: a pile on a lift that moves evenly behaves as at
//!   rest, bit for bit. Boxes of a column keep their order and do not sink into each other. Round
//!   bodies do: see the [limits](self#limits).
//! - **Sleep costs nothing**: a step with all bodies asleep reads a counter. A body wakes if a body
//!   that is awake touches it, or if you push, [place](Scene::place) or [wake](Scene::wake) it. It
//!   also wakes if you name a region that [changed](Scene::wake_region), and if a solid that
//!   [moves](Scene::ride) comes near it. A tile or a solid that you remove wakes no body, so name
//!   its region. Sensors wake no body. A woken body wakes the bodies that it touches in the next
//!   step, with the whole pile of those that touch each other.
//!
//! # Fast bodies
//!
//! A body is fast if its velocity and its pushes move it by more than half of its smaller side in a
//! step. A [flagged](SceneBody::fast) body is always fast. A test of only its start would miss the
//! bodies on its path. A fast body moves from event to event. It moves up to its first hit, the
//! level or a body, found by the exact cast of two that [both
//! move](crate::query::CastShape::cast_moving). There it bounces or slides, and continues for the
//! rest of the step. All such events of a scene are handled in the order of their times. At the
//! same time the level comes first, then the pair with the smaller keys.
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
//!   has stopped yields: a body slides along the wall against which another one presses it.
//! - A slow or sleeping body that is hit uses its new velocity from the next step on.
//! - Sensors on the path are reported, too, each time that a body enters one.
//! - After three bodies or eight events in a step, a body waits for the next step, and no body
//!   passes it.
//! - Two bodies that are *not* fast may still pass each other if they clip each other or are
//!   squeezed. Flag the one that moves against the other.
//! - The game moves a fixed body between steps, so it does not meet bodies that it jumps over.
//!
//! A fast body with no body in reach is moved like all others; that costs one region query.
//! Otherwise each event takes a few casts through the level and region queries, and tests the boxes
//! of all fast bodies. In a crowd that presses together, the cost grows faster than the square of
//! the number of fast bodies. So flag bullets, crushers and the hero, not a crowd.
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
//! # Limits
//!
//! - **Bodies sink into others that can move.** A ball that rests between two others overlaps them.
//!   At a gravity of 0.25, one of radius 8 on two that touch is 0.07 units deep. In a heap of 60
//!   some overlap by 2 to 5 units, and a ball may pass another one in a narrow bin.
//! - **A row that a hero presses against a wall yields.** Boxes under gravity come into each other
//!   by little more than one of its steps. When it hits them, it is three, or six in a row of
//!   eight. Of 1500 random rows, one passes another in 32. Other shapes, and bodies seen from
//!   above, stay in each other by up to four steps, and pass far more often. Flag all of them as
//!   `fast`: none is then more than 1/50 of a unit in another. A crowd of fast bodies costs far
//!   more, and gets stuck in a narrow door.
//! - **Friction slows a row down.** A hero that pushes five crates with a friction of 20 percent
//!   moves at two thirds of its speed, though it is far heavier.
//! - **Large heaps may keep moving**: of balls without friction, 2 of 180 heaps of 8 to 24, and
//!   an eighth of those of 60. Balls among boxes swing longer.
//! - **A fast body on a fixed one** that the game [places](Scene::place) may be behind by what
//!   gravity adds in a step.
//! - **A body bounces for ever** if its restitution is above one half and its
//!   [`Surface::resting_below`](crate::Surface::resting_below) is too low. It is if it is less than
//!   the gravity, divided by one minus the restitution.
//!
//! # Cost
//!
//! The mover takes most of a step. [`Scene`] lists instructions, flash and stack, and shows what a
//! scene that [remembers](Scene::remembering) saves.
//!
//! # Games in a scene
//!
//! **Capsules** are bodies of a `Scene<B, 64, 0, WithCapsules>`: see [`WithCapsules`]. Other scenes
//! link none of their code. **Oriented boxes, polygons and slanted capsules** need
//! [`AnyShape`](crate::shape::AnyShape) there.
//!
//! **Moving platforms** are [`Solid`](crate::Solid)s or
//! [`ConvexSolid`](crate::world::ConvexSolid)s. [`ride`](crate::Scene::ride) moves them, with the
//! bodies that they carry and push. Each step takes them in a [`Joined`](crate::Joined) level.
//! Without `ride` a solid only blocks, and a body that it enters is [held](SceneEvent::Held).
//!
//! They can also be `fixed` bodies that the game [places](crate::Scene::place). Those push by their
//! velocity, and carry by friction. Set the platform's velocity, and place it *after* the step in
//! which the bodies on it move with it. That is enough for up and down. Sideways, *both* need
//! friction: if two bodies meet, the surface that bounces more is used, or else the one with less
//! friction. A conveyor is such a body that you do not move.
//!
//! If you place a platform without setting its velocity, it pushes as it rises. As it moves
//! sideways or down, it slides away below its load. A body that it crushes against the level
//! overlaps it, and is reported.
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
//! assert!((load.min().x - way.min().x - Fx::from_num(8)).abs() < 1); // the same position on the lift
//! assert_eq!(load.max().y, way.min().y); // exactly on top of it
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **A hero**: to put a hero that a [`Walker`](crate::Walker) moves into a scene, insert a body
//! that [floats](SceneBody::floats), with a mass and zero velocity. In each frame, walk the hero
//! through the level, `place` its body, call `step`, and continue from the position to which the
//! scene pushed it. The body never overlaps the level there. The body meets triggers, and pushes
//! crates into which it walks. A hit changes its velocity in the scene: add that to the walker's or
//! not, and set it to zero. Do not use a `fixed` body: nothing pushes it, and it does not meet
//! other fixed bodies. The walker does not know that it stands on a crate, but
//! [`is_supported`](crate::Scene::is_supported) does.
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
//! assert!(passed && scene.body(box_)?.shape.position().x > 41); // it pushes the box
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Hitscan, dashes, explosions, cursors**: [`cast_ray_in`](Scene::cast_ray_in) and
//! [`cast_shape_in`](Scene::cast_shape_in) find what is first on a line: the level or a body.
//! [`cast_ray`](Scene::cast_ray) and [`cast_shape`](Scene::cast_shape) look only at bodies.
//! [`overlapping`](Scene::overlapping), [`touching`](Scene::touching) and
//! [`at_point`](Scene::at_point) list the bodies at a position.
//!
//! **Ghosts, bullets, pick-ups**: your closure in [`step_with`](Scene::step_with) returns a
//! [`Reply`] for each pair: ignore, cross, slide, touch or bounce. A [`Filter`](crate::Filter)
//! costs less if whole groups ignore each other. For the level, use [`SceneBody::responses`] for
//! surfaces that stop the body, or [`Responses::otherwise`](crate::motion::Responses::otherwise)
//! for a bullet that stops at all of them. By default a body slides along a wall, and may meet
//! others behind it in the same step. Use [`step_in`](Scene::step_in) for tiles that it passes.
//! [`step_along`](Scene::step_along) reports those.
//!
//! **Tiles that only some bodies meet**: give the tiles flags, and list the flags that each kind of
//! body passes. [`TileKinds::passing`](crate::TileKinds::passing) makes a table of tiles for each
//! kind of body, and each table makes a level. The levels share their tiles: a door that opens does
//! so for all. This works for every [set](crate::world::ShapeSet) of shapes.
//!
//! ```
//! use tilesat::scene::{SceneBody, SortSweepScene};
//! use tilesat::world::ShapeSet;
//! use tilesat::{AllShapes, Blocks, Circle, Slopes, TileKind, TileKinds, TileMap, TileShape, Vec2, fx};
//! const CURTAIN: u8 = 1;
//! const FENCE: u8 = 2;
//! // The flags that knights, ghosts and arrows pass.
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
//! /// The final positions of a knight, a ghost and an arrow that start at x = 8.
//! fn ends<S: ShapeSet>(rows: &str, kinds: &'static [TileKinds; 3]) -> Result<[i32; 3], Box<dyn std::error::Error>> {
//!     let tiles = TileMap::from_ascii(rows, &TileKinds::EMPTY)?;
//!     let level = |kind: usize| tiles.with_kinds::<S>(&kinds[kind]);
//!     let levels = [level(0)?, level(1)?, level(2)?];
//!     let mut scene = SortSweepScene::<8>::empty();
//!     for key in 0..3 {
//!         let ball = Circle::new(Vec2::from_ints(8, 8), fx!(4))?;
//!         scene.insert(&SceneBody { velocity: Vec2::from_ints(100, 0), ..SceneBody::new(ball, key) })?;
//!     }
//!     // The key is the kind of the body. These bodies meet only the level.
//!     scene.step_in(|body| &levels[body.key as usize], Vec2::ZERO, |_| false, |_| ())?;
//!     let mut ends = [0; 3];
//!     for (_, body) in scene.bodies() {
//!         ends[body.key as usize] = body.shape.position().x.to_num();
//!     }
//!     Ok(ends)
//! }
//! let ends_of_all = [28, 76, 44]; // in front of the fence, the wall and the curtain
//! assert_eq!(ends::<Blocks>("..fc.#.\n.......", &BLOCKS_OF)?, ends_of_all);
//! assert_eq!(ends::<Slopes>("..fc.#.\n../../.", &SLOPES_OF)?, ends_of_all);
//! assert_eq!(ends::<AllShapes>("..fc.#.\n..o../.", &ROUND_OF)?, ends_of_all);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Landings**: a body at rest hits the floor in every step. To report a landing once, feed the
//! hits of the body to a list of [events](crate::broad::PairEvents); the key is any pair that you
//! choose. [`Hit::approach`](crate::motion::Hit::approach) says how hard a hit was.
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
//!     // A sleeping body reports nothing, and still touches its floor.
//!     contacts.finish(|(body, _)| scene.is_awake(*body).is_ok_and(|awake| !awake))?;
//!     landings += contacts.iter().filter(|event| matches!(event, PairEvent::Begin(_))).count();
//! }
//! assert_eq!((landings, hardest), (1, Fx::from_num(4.25)));
//! assert!(!scene.is_awake(crate_)? && contacts.iter().count() == 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Sensors** never wake a body. A sensor with a mass meets sleeping bodies when it moves or once
//! you have placed it; give it `floats`. A fixed sensor and a sleeping body both rest. If you put
//! the sensor on such a body, nothing is reported until the body wakes. Call
//! [`wake`](crate::Scene::wake) for the bodies that [`near`](crate::Scene::near) finds there.
//!
//! **Keys** must be unique for results that do not depend on the order of insertion. If two are
//! equal, nothing fails: the one in the smaller slot is `a`, and slots depend on that order.
//!
//! **Grids with [`Border::Refuse`](crate::broad::Border::Refuse)** hold a body that would leave at
//! its last position in every step, without a velocity, until it falls asleep there. Remove it when
//! the event reports it, or use a border that accepts all.
//!
//! **Rollback** takes a [`Snapshot`], or copies the scene. It also needs all data of your rules:
//! [`PairEvents`](crate::broad::PairEvents), [`Exceptions`](crate::broad::Exceptions), the bytes of
//! tiles that change, solids.

mod blocked_sides;
mod body;
mod body_path;
mod change;
mod error;
mod event;
mod fast_bodies;
mod idle;
mod kept_out;
mod kernel;
mod level_of_body;
mod meeting_time;
mod memory;
mod pairs;
mod piles;
mod pressed;
mod query;
mod reply;
mod resting;
mod ride;
mod set;
mod shape;
mod snapshot;
mod step;
#[cfg(feature = "serde")]
mod stored;
mod swept_bodies;
mod through_both;
mod through_level;
mod two_paths;
mod velocities;
mod verbs;

pub use body::SceneBody;
pub use error::{SceneError, SceneFault};
pub use event::{SceneEvent, Stepped};
pub use kernel::BodyShape;
pub use query::SceneHit;
pub use reply::{Answer, Reply};
pub use set::{Scene, Sleep, SortSweepScene};
pub use shape::{Shape, WithCapsules};
pub use snapshot::Snapshot;
pub use through_both::{FirstHit, SceneCast};

/// The tag of each body in the broad phase.
pub type SceneTag = crate::broad::Keyed<crate::Filter>;
