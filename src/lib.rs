//! Exact, heap-free, fixed-point 2D collision for tile levels on microcontrollers and handheld
//! consoles.
//!
//! A level is bytes in flash, one byte (or bit) per tile. Bodies are boxes, circles, capsules,
//! oriented boxes and convex polygons. The crate answers these questions. Do two shapes overlap,
//! how deep, and which push parts them? What does this ray hit? Where is this body after it slides
//! along the level? Every yes/no answer is exact, every rounding has a documented direction, every
//! loop has a bound, and nothing panics in release builds. The crate needs no FPU, no heap and no
//! 64-bit multiply. On 64-bit hosts, some tests of pairs first compute with `f64`. Integers decide
//! whatever the error of a float could change, so the bits are the same everywhere.
//!
//! It is not a physics engine: it has no joints and no forces, and bodies rotate only when your
//! game rotates them.
//!
//! The hero of a platformer is one type, [`Character`], with one call per frame:
//!
//! ```
//! use tilesat::{Aabb, Character, Feel, Input, Outcome, TileKind, TileKinds, TileMap, Vec2, fx};
//!
//! // The characters of the text are the tile ids; the table defines them.
//! static KINDS: TileKinds = TileKinds::EMPTY
//!     .with(b'#', TileKind::FULL)
//!     .with(b'=', TileKind::ONE_WAY_UP)
//!     .with(b'o', TileKind::EMPTY.with_flags(1));
//! let rows = "........\n...==...\n.....o..\n########\n"; // cells of 16 x 16 units, rows downward
//! let level = TileMap::from_ascii(rows, &KINDS)?;
//!
//! let body = Aabb::new(Vec2::from_ints(4, 20), Vec2::from_ints(14, 34))?;
//! let mut hero = Character::new(body, level.bounds(), Feel::DEFAULT);
//! let mut flags = 0;
//! while hero.body().max().x < 100 {
//!     let step = hero.step(&level, Input::running(fx!(1.5)))?;
//!     assert_eq!(step.outcome, Outcome::Moved);
//!     flags |= level.flags_touched(hero.body());
//! }
//! assert_eq!(flags, 1); // it fell, ran, and took the coin
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which type do I need?
//!
//! | you want | type |
//! |---|---|
//! | the hero of a platformer | [`Character`] |
//! | a character with your own rules | [`Walker`], [`Mover::ride`] |
//! | anything that moves and hits | [`Mover::move_and_slide`] |
//! | lifts, doors, crushers | [`Solid`], [`Solids`] |
//! | sloped lifts, bumpers, platforms that turn | [`ConvexSolid`](world::ConvexSolid), [`Character::step_on`], [`Mover::ride_convex`] |
//! | a level of tiles: blocks, halves, slopes, quarter arcs | [`TileMap`], [`TileKinds`], [`TileShape`] |
//! | a level of polygons, walls, one-way chains | [`SegmentMap`], built by the compiler with [`segment_map!`] |
//! | two levels as one | [`Joined`] |
//! | which of many bodies are close to each other | a [`BroadPhase`](broad::BroadPhase) |
//! | level, broad phase and bodies in one call per frame; it takes the most [flash](Scene) | [`Scene`] |
//! | overlaps, contacts, casts and rays of shapes | [`prelude`], [`query`] |
//!
//! # Conventions
//!
//! - **Numbers**: lengths are [`Fx`], 16.16, and literals are [`fx!`]; *raw* is one unit of the
//!   last place. Coordinates stay below 8192 units ([`num::DOMAIN`]); constructors refuse the rest,
//!   so kernels cannot wrap.
//! - **Touching is not overlapping.** `overlaps` is strict, `touches` is closed, both exact
//!   ([`query`]).
//! - **Normals** of contacts point from A to B. Those of casts and rays point out of the shape that
//!   was hit. They are exact integers ([`Axis`]), and you can compute the unit vector from them.
//! - **Rounding** is safe: depths are rounded up, push-outs away, distances and times of impact
//!   down. A body that you move by a result never ends inside.
//! - **The y axis**: row 0 of a [`TileMap`] has the smallest y, and "up" in a tile's name is toward
//!   row 0. On a screen (y down) "up" is [`Axis::NEG_Y`]. With y up, pass [`Axis::Y`] and store the
//!   rows bottom first.
//! - **Units are per frame**: a velocity is the motion of one call.
//! - **Overflow**: nothing in this crate overflows, and [`Vec2`] saturates. Your own arithmetic on
//!   single [`Fx`] values can: see [`Fx`](Fx#overflow).
//!
//! # Map
//!
//! | module | contents |
//! |---|---|
//! | [`num`] | scalars, vectors, wide products, roots |
//! | [`shape`] | [`Aabb`], [`Circle`], [`Segment`]; [`Capsule`], [`OrientedBox`], [`ConvexPolygon`]; [`AnyShape`](shape::AnyShape), [`Compound`](shape::Compound), [`ConvexParts`](shape::ConvexParts) |
//! | [`query`] | one trait per verb, for each pair of shapes: overlaps, contacts, distances, casts |
//! | [`world`] | [`TileMap`], [`SegmentMap`], [`Solids`], [`Joined`], [`Rooms`]: surfaces, overlaps, contacts, rays |
//! | [`broad`] | [`BroadPhase`](broad::BroadPhase): which of many bodies are near each other; events of pairs |
//! | [`scene`] | [`Scene`]: level, broad phase and bodies by one call per frame |
//! | [`motion`] | [`Character`], [`Mover::move_and_slide`], [`Walker`], [`Mover::ride`] on moving [`Solid`]s, responses, casts through levels |
//! | [`error`] | errors that several modules share |
//! | [`boards`] | costs; notes for real boards: targets, manifests, frame budgets |
//!
//! # Features
//!
//! None is on by default and none changes a result. `defmt` adds a compact `Format` to every public
//! type. `serde` writes and reads every plain state that a game keeps, without a heap: numbers,
//! shapes, heroes, movers, solids, particles, broad phases, pairs and scenes. States that depend on
//! the internals of this crate carry a format version. Reading applies the same checks as the
//! constructors. Swapped corners, coordinates outside the domain, unknown versions and inconsistent
//! lists are errors that say what is wrong and where. A [`Memo`](motion::Memo) is not saved: it
//! reads back empty, because its answer cannot be checked without the level. `libm` uses the
//! processor's square root on x86-64, which saves 7 % of the instructions of a circle cast.

#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
// Lints refuse panics and floating point in the library. Tests and examples may use them.
#![warn(
    clippy::expect_used,
    clippy::float_arithmetic,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::std_instead_of_core
)]
#![warn(clippy::unreachable, clippy::unwrap_used)]

/// The crate of the scalar: [`Fx`] is [`fixed::types::I16F16`]. A new major version of it is one of
/// this crate.
pub use fixed;
/// The crate of lists of results: [`heapless::Vec`]. A new major version of it is one of this
/// crate.
pub use heapless;

#[allow(clippy::doc_markdown, reason = "names of boards")]
#[doc = include_str!("boards.md")]
pub mod boards {}
pub mod broad;
pub mod error;
mod filter;
#[cfg(feature = "defmt")]
mod format;
pub mod motion;
pub mod num;
pub mod query;
pub mod scene;
pub mod shape;
#[cfg(feature = "serde")]
mod stored;
pub mod world;

pub use error::{Quantity, RangeError};
pub use filter::{Filter, LayerMask};
pub use motion::{
    Body, Character, Feel, Hit, Input, MoveError, Moved, Mover, Outcome, Response, SlopeSpeed, Step, Support, Surface,
    Walked, Walker,
};
pub use num::{Axis, Fx, Ratio, Toi, UnitVec2, Vec2};
pub use query::{CastHit, Contact, Inside};
pub use scene::{Scene, SceneBody};
pub use shape::{Aabb, Capsule, Circle, ConvexPolygon, OrientedBox, Segment};
/// The traits of the pair queries and of the broad phases: `use tilesat::prelude::*;`.
///
/// Import types from the crate root, and iterators and parts of results from their modules.
pub mod prelude {
    pub use crate::broad::BroadPhase;
    pub use crate::query::{
        CastShape, ClosestPoint, Contacts, Contains, Distance, Manifolds, Overlaps, OverlapsFrom, Touches,
    };
}
pub use world::{
    AllShapes, Blocks, Cell, Grid, Joined, Outside, Path, PathKind, RayHit, Room, Rooms, SegmentMap, SegmentMapError,
    Side, Slopes, Solid, Solids, TileKind, TileKinds, TileMap, TileMapError, TileShape, World,
};

/// The README's example is a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
