//! Scenes: bodies that move through a level and meet each other, in one call per frame.
//!
//! [`Scene`] consists of public parts, and you can use each part alone. A
//! [`BroadPhase`](crate::broad::BroadPhase) finds the bodies that are near each other.
//! [`contact`](crate::query::Contacts) finds how two bodies overlap.
//! [`separate`](crate::motion::response::separate) and
//! [`exchange`](crate::motion::response::exchange) part them and change their velocities. A
//! [`Mover`](crate::Mover) moves each body through the level. A scene is plain data, so a copy is a
//! snapshot.
//!
//! ```
//! use tilesat::scene::{SceneBody, SceneEvent, SortSweepScene};
//! use tilesat::{Aabb, Circle, TileKind, TileKinds, TileMap, Vec2, fx};
//!
//! static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
//! let level = TileMap::from_ascii("#......#\n#......#\n########\n", &KINDS)?; // the floor is at y = 32
//! let mut scene = SortSweepScene::<64>::empty();
//! let crate_ = scene.insert(&SceneBody::new(Aabb::new(Vec2::from_ints(40, 22), Vec2::from_ints(50, 32))?, 1))?;
//! let ball = scene.insert(&SceneBody::new(Circle::new(Vec2::from_ints(45, 10), fx!(4))?, 2))?;
//!
//! let gravity = Vec2::new(fx!(0), fx!(0.1));
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
//! 2. Every touching pair that the game [accepts](Scene::step_with) is reported. A sensor does no
//!    more than that. If two bodies overlap, each receives its share of the
//!    [push](crate::motion::response::separate) that parts them. If they approach, each receives
//!    its share of the [change of velocity](crate::motion::response::exchange). Of all pushes to
//!    one side only the longest counts, so two floors push a body no higher than one. Of n changes
//!    of velocity each counts for 1/n. In a corner of walls along x and y without friction, the
//!    change of each wall counts whole. Where boxes are flush, the push straight out of one
//!    leads a round body out of its neighbour, too. It does not feel the corner of that.
//! 3. Each body is [moved](crate::Mover::move_and_slide) by its push, and then by its velocity. Its
//!    surface decides how it bounces off the level. It does not bounce if it meets the level at no
//!    more than the gravity of two steps, because it would jitter there. If a push lifts a body
//!    that lies on something, the body also loses as much of its downward velocity. So does a body
//!    that others wedge, but not along a floor on which it stands. On a slope, any push against its
//!    velocity counts. A fixed body in the way ends the motion. Every new position passes the
//!    level's exact overlap test.
//! 4. Bodies that lie on others are moved after them, from the lowest up. If they overlap a body
//!    that is carried, they are pushed out of it in the same step.
//! 5. Fast bodies are moved last, from one hit to the next.
//! 6. Bodies that have hardly moved for some steps fall asleep, together with all bodies that they
//!    touch. A body that moved onto another one in this step stays awake, and the next step reports
//!    the pair. In a heap that has hardly moved, bodies may also lose touch and find it again. Such
//!    a pair is known already.
//!
//! # Guarantees
//!
//! - **No body enters the solid.** A body that is in it already, or cannot be moved for another
//!   reason, is [held](SceneEvent::Held): it stays and has no velocity.
//! - **Bodies may overlap** after a step, if the level leaves no room or if many bodies push. The
//!   next step finds how deep they are, and pushes again. If a push could not move a body, the
//!   other body makes the whole correction in the next step. A heavy body that presses a light one
//!   against a wall can sink into it by two of its steps, plus the gravity of three.
//! - **Fixed bodies keep out all others.** A slow body stops or slides where it would enter a fixed
//!   one by more than 1/256 of its own smaller side. A body that lies on a fixed one may be in it
//!   by an eighth of that side. So nothing passes a gap that is too narrow.
//! - **Nothing fast passes anything**: see [below](self#fast-bodies).
//! - **Order does not matter**: the order of insertion, the order in which the broad phase finds
//!   bodies, and the choice of broad phase change nothing. This needs unique keys; if two are
//!   equal, slots decide. Events are reported in no particular order.
//! - **Images**: a mirrored scene gives the mirrored bits, and a moved scene the same bits. The
//!   limits are those of the [mover](crate::Mover::move_and_slide) and of
//!   [degenerate](crate::query::Contact::is_degenerate) contacts, whose centres coincide.
//! - **Momentum and energy**: if two free bodies meet and touch no third, their momentum is kept
//!   exactly. Their energy (mass times speed squared) never grows. In a crowd each meeting may
//!   change both by less than a raw unit of velocity. A slow body that runs into several at once
//!   takes a mean, and loses energy. Three elastic balls that meet keep less than half of it. Flag
//!   bouncing balls as `fast`. Energy that gravity and pushes add is not counted.
//! - **Piles stand**: a body that lies on the level, or on bodies that do, is not pushed down by
//!   those on top of it. The momentum goes into the ground. Support reaches a whole pile within a
//!   step. Velocities are relative to the carrier: a pile on a lift that moves evenly behaves as at
//!   rest, bit for bit. Boxes of a column keep their order and do not sink into each other. Round
//!   bodies do: see the [limits](self#limits).
//! - **Sleep costs nothing**: a step with all bodies asleep reads a counter. A body wakes if a body
//!   that is awake touches it, or if you push, [place](Scene::place) or [wake](Scene::wake) it. It
//!   also wakes if a [moving solid](Scene::ride) comes near it, or if you name a region that
//!   [changed](Scene::wake_region). A tile or a solid that you remove wakes no body, so name its
//!   region. Sensors wake no body. In the next step, a woken body wakes the whole pile of bodies
//!   that touch it or each other.
//!
//! # Fast bodies
//!
//! A body is fast if its velocity and its pushes move it by more than half of its smaller side in a
//! step. A [flagged](SceneBody::fast) body is always fast. A slow body is tested only where its
//! step starts. That test would miss bodies on the path of a fast one.
//!
//! A fast body moves up to its first hit, the level or a body. An exact cast of [two moving
//! shapes](crate::query::CastShape::cast_moving) finds it. There the body bounces or slides, and
//! continues for the rest of the step. All hits in a scene are handled in the order of their times.
//! At equal times the level comes first, then the pair with the smaller keys.
//!
//! ```text
//!   t = 0        0.4          0.7           |#
//!     o-----------o            o <----------|#   1  ball meets crate       (Meet)
//!               +--+                        |#   2  it meets the wall      (Level)
//!               |  |  slow bodies keep      |#   3  and so on
//!               +--+  their way this step  |#
//! ```
//!
//! - Two bodies exchange velocities at most once per step. One [`SceneEvent::Meet`] reports them,
//!   with the time and the speed. If they hit each other again, one of them yields: the one that
//!   nothing else has stopped. A body slides along the wall against which another one presses it.
//! - A slow or sleeping body that is hit uses its new velocity from the next step on. But a slow
//!   body that runs into one that is fast by itself is moved with it in that step, so their masses
//!   decide. It meets the other slow bodies on its path only if the hit makes it fast. This is not
//!   so for bodies that lie on others.
//! - A body that others hold where it is loses what gravity adds. So a wedged body stores no speed.
//! - Sensors on the path are reported, too, each time that a body enters one.
//! - After meeting three bodies, or after eight events, a body waits for the next step. No body
//!   passes it.
//! - Two bodies that are *not* fast may still pass each other if they clip each other or are
//!   squeezed. Flag the one that moves against the other.
//! - The game moves a fixed body between steps. The body does not meet those that it jumps over.
//!
//! A fast body with no body in reach is moved like all others, and costs one more region query.
//! Otherwise each event costs a few casts through the level, a few region queries, and a test of
//! the boxes of all fast bodies. In a crowd that presses together, the cost grows faster than the
//! square of the number of fast bodies. So flag bullets, crushers and the hero, not a crowd. Slow
//! bodies that run into a fast one cost more in that step, too. If sixty press a hero, the step
//! takes two to six times as long.
//!
//! ```
//! use tilesat::scene::{SceneBody, SceneEvent, SortSweepScene};
//! use tilesat::{Aabb, Circle, TileKinds, TileMap, Toi, Vec2, fx};
//! let level = TileMap::from_ascii("....\n....\n", &TileKinds::EMPTY)?;
//! let mut scene = SortSweepScene::<8>::empty();
//! let wall = Aabb::new(Vec2::from_ints(50, -40), Vec2::from_ints(51, 40))?;
//! let wall = scene.insert(&SceneBody::fixed(wall, 1))?;
//! let bullet = SceneBody::new(Circle::new(Vec2::ZERO, fx!(2))?, 2);
//! let bullet = scene.insert(&SceneBody { velocity: Vec2::from_ints(192, 0), floats: true, ..bullet })?;
//! let mut met = None;
//! scene.step(&level, Vec2::ZERO, |event| {
//!     if let SceneEvent::Meet { pair, toi, speed, .. } = event {
//!         met = Some((pair.a, toi, speed));
//!     }
//! })?;
//! assert_eq!(met, Some((wall, Toi::from_raw(1 << 28).unwrap(), fx!(192)))); // 48 of 192 units
//! assert_eq!(scene.body(bullet)?.shape.position(), Vec2::from_ints(48, 0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Limits
//!
//! - **Bodies sink into others that can move.** A ball that rests between two others overlaps them.
//!   At a gravity of 0.25, one of radius 8 on two that touch is 0.07 units deep. In a heap of 60
//!   some overlap by 2 to 5 units, and a ball may pass another one in a narrow bin. One that lies
//!   on others may be pressed into a fast hero for a step, by up to half of its size.
//! - **A heavy slow body sinks through a light one that the level holds**, such as a ball in a
//!   gap. With 50 times its mass it always does, with ten in some places. While it sinks it stores
//!   speed, and a surface that bounces throws it out. Flag the heavy one as `fast`.
//! - **Slow boxes without friction in a V of slopes may move for ever**, by a third of gravity per
//!   step or more. Of two boxes, 9 scenes in 100 do not come to rest, and of eight, 31. With a
//!   friction of 20 percent, all do.
//! - **A row that a hero presses against a wall yields.** Boxes under gravity overlap by little
//!   more than one step of the hero. On impact they overlap by three steps, and in a row of eight
//!   by six. In 32 of 1500 random rows, one body passed another. Other shapes, and bodies seen from
//!   above, stay in each other by up to four steps, and pass far more often. Flag all of them as
//!   `fast`: in a row, none is then more than 1/50 of a unit in another.
//! - **A group of fast bodies that keeps pressing together sinks in slowly**, such as enemies that
//!   chase a hero. In ten seconds, eleven boxes come into each other by less than 1/20 of a unit,
//!   and balls by less than 1/10. After minutes in a corner, balls may be deeper. A crowd of fast
//!   bodies costs far more, and gets stuck in a narrow door. Slow bodies sink in half as deep if
//!   each frame is two steps, with half of the velocities.
//! - **Friction slows a row down.** A hero that pushes five crates with a friction of 20 percent
//!   moves at two thirds of its speed, though it is far heavier.
//! - **Large heaps may keep moving**: of balls without friction, 2 of 180 heaps of 8 to 24, and
//!   an eighth of those of 60. Balls among boxes swing longer.
//! - **A fast body that lies on slow ones may keep them awake**, though nothing moves: it hits them
//!   in each step. With one fast body of eight that is so in 8 bins of 100, of four in 2, without
//!   friction in 8 and 3. If all are fast, or none is, nearly all sleep.
//! - **A fast body that two surfaces touch from both sides** keeps only its velocity along them, if
//!   they face each other to two degrees. In a wider wedge it bounces out.
//! - **A fast body on a fixed one** that the game [places](Scene::place) may lag by one step's
//!   gravity.
//! - **A body bounces for ever** if its restitution is above one half and its
//!   [`resting_below`](crate::Surface::resting_below) is less than gravity / (1 - restitution).
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
//! They can also be `fixed` bodies that the game [places](crate::Scene::place). Such a platform
//! pushes by its velocity, and carries by friction. Set its velocity, step the scene, and then
//! place the platform. The bodies on it move in the step, and it follows them. That is enough for
//! up and down. Sideways, the platform and its load *both* need friction. When two bodies meet, the
//! surface that bounces more decides, or else the one with less friction. A conveyor is a `fixed`
//! body with a velocity that stays where it is. Let that lead along its surface. A body that meets
//! it head-on is hit as a ball by a bat, and gains speed.
//!
//! If you place a platform without setting its velocity, it pushes its load only as it rises. As it
//! moves sideways or down, it slides away below its load. A body that it crushes against the level
//! overlaps it, and is reported.
//!
//! ```
//! use tilesat::scene::{SceneBody, SortSweepScene};
//! use tilesat::{Aabb, Ratio, Surface, TileKinds, TileMap, Vec2, fx};
//! let level = TileMap::from_ascii("........\n........\n", &TileKinds::EMPTY)?;
//! let at = |x, y, w, h| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h));
//! let mut scene = SortSweepScene::<8>::empty();
//! let surface = Surface::new(Ratio::ZERO, Ratio::ONE); // friction, for both
//! let velocity = Vec2::from_ints(1, -1);
//! let mut way = at(10, 100, 24, 4)?;
//! let lift = scene.insert(&SceneBody { velocity, surface, ..SceneBody::fixed(way, 1) })?;
//! let load = scene.insert(&SceneBody { velocity, surface, ..SceneBody::new(at(18, 92, 8, 8)?, 2) })?;
//! for _ in 0..40 {
//!     scene.step(&level, Vec2::new(fx!(0), fx!(0.1)), |_| {})?;
//!     way = Aabb::new(way.min() + velocity, way.max() + velocity)?;
//!     scene.place(lift, way)?;
//! }
//! let load = scene.body(load)?.shape.aabb();
//! assert!((load.min().x - way.min().x - fx!(8)).abs() < 1); // the same position on the lift
//! assert_eq!(load.max().y, way.min().y); // exactly on top of it
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **A hero**, or an enemy that walks, is a [`SceneCharacter`]. It stands on the bodies of the
//! scene, pushes them, and goes along with the one below it. If you move a hero by a
//! [`Walker`](crate::Walker) of your own, give it a [`led`](SceneBody::led) body. In each frame,
//! walk through the level, [`place`](Scene::place) the body, and call `step`. Then continue from
//! the position to which the scene pushed the body, and set its velocity to zero. The body never
//! overlaps the level there. Do not use a `fixed` body: nothing pushes it, and it does not meet
//! other fixed bodies. The walker does not know that it stands on a crate, but
//! [`is_supported`](crate::Scene::is_supported) does.
//!
//! **Hitscan, dashes, explosions, cursors**: [`cast_ray_in`](Scene::cast_ray_in) and
//! [`cast_shape_in`](Scene::cast_shape_in) find what is first on a line: the level or a body.
//! [`cast_ray`](Scene::cast_ray) and [`cast_shape`](Scene::cast_shape) look only at bodies.
//! [`overlapping`](Scene::overlapping), [`touching`](Scene::touching) and
//! [`at_point`](Scene::at_point) list the bodies at a position.
//!
//! **Ghosts, bullets, pick-ups**: your closure in [`step_with`](Scene::step_with) returns a
//! [`Reply`] for each pair: ignore, cross, slide, touch or bounce. A [`Filter`](crate::Filter)
//! costs less if whole groups ignore each other. By default a body slides along a wall, and may
//! meet others behind it in the same step. Set [`SceneBody::responses`] for surfaces that stop the
//! body, or [`Responses::otherwise`](crate::motion::Responses::otherwise) for a bullet that stops
//! at all of them. Use [`step_in`](Scene::step_in) for tiles that a body passes.
//! [`step_along`](Scene::step_along) reports these tiles.
//!
//! **Tiles that only some bodies meet**: give the tiles flags, and list the flags that each kind of
//! body passes. [`TileKinds::passing`](crate::TileKinds::passing) makes a table of tiles for each
//! kind of body, and each table makes a level. The levels share their tiles, so a door opens for
//! all of them. This works for every [set](crate::world::ShapeSet) of shapes.
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
//! use tilesat::{Aabb, Cell, Fx, TileKind, TileKinds, TileMap, Vec2, fx};
//! static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
//! let level = TileMap::from_ascii("...\n...\n...\n###", &KINDS)?; // the floor is at y = 48
//! let mut scene = SortSweepScene::<8>::empty();
//! let crate_ = scene.insert(&SceneBody::new(Aabb::new(Vec2::from_ints(4, 4), Vec2::from_ints(12, 12))?, 1))?;
//! let mut contacts = PairEvents::<16, (Handle, Cell)>::new();
//! let (mut landings, mut hardest) = (0, Fx::ZERO);
//! for _ in 0..600 {
//!     scene.step(&level, Vec2::new(fx!(0), fx!(0.25)), |event| {
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
//! assert_eq!((landings, hardest), (1, fx!(4.25)));
//! assert!(!scene.is_awake(crate_)? && contacts.iter().count() == 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Sensors** never wake a body. A sensor with a mass reports sleeping bodies when it moves, or
//! once you have placed it. Give it `floats`, so that it does not fall. A fixed sensor and a
//! sleeping body both rest, so nothing is reported until the body wakes. To learn about such bodies
//! at once, call [`wake`](crate::Scene::wake) for those that [`near`](crate::Scene::near) finds
//! there.
//!
//! **Keys** must be unique for results that do not depend on the order of insertion. If two are
//! equal, nothing fails: the one in the smaller slot is `a`, and slots depend on that order.
//!
//! **Grids with [`Border::Refuse`](crate::broad::Border::Refuse)** let no body leave. A body at the
//! border stays at its last position without a velocity, and each step reports it as
//! [held](SceneEvent::Held), until it falls asleep. Remove it then, or use a border that accepts
//! all.
//!
//! **Rollback** takes a [`Snapshot`], or copies the scene. Copy all data of your rules as well:
//! [`PairEvents`](crate::broad::PairEvents), [`Exceptions`](crate::broad::Exceptions), solids, and
//! the bytes of tiles that change.

mod at_boxes;
mod blocked_sides;
mod body;
mod body_path;
mod change;
mod character_looks;
mod error;
mod event;
mod farthest_pushes;
mod fast_bodies;
mod flush_boxes;
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
mod reached;
mod reply;
mod resting;
mod ride;
mod scene_character;
mod seams;
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
pub use scene_character::SceneCharacter;
pub use set::{Scene, Sleep, SortSweepScene};
pub use shape::{Shape, WithCapsules};
pub use snapshot::Snapshot;
pub use through_both::{FirstHit, SceneCast};

/// The tag of each body in the broad phase.
pub type SceneTag = crate::broad::Keyed<crate::Filter>;
