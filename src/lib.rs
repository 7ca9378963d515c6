//! Exact, heap-free, fixed-point 2D collision for tile levels on microcontrollers and handheld consoles.
//!
//! A level is bytes in flash, one byte (or bit) a tile. Bodies are boxes and circles. The crate answers: do they overlap, how deep and
//! which way out, what does this ray see, and where does this body end up when it slides along the level. Every yes/no is exact,
//! every rounding has a declared direction, every loop has a bound, and nothing panics. It needs no FPU, no heap, no 64-bit multiply.
//!
//! Tiles can be blocks, halves, slopes and quarter arcs ([`TileShape`]); polygons, walls and one-way chains that no grid holds are a [`SegmentMap`]
//! (built by the compiler with [`segment_map!`]), and [`Joined`] makes one level of two. Platforms, doors and crushers are [`Solids`].
//!
//! Which of many bodies meet is a [`BroadPhase`](broad::BroadPhase)'s to say, and [`Scene`] ties all of it together.
//!
//! It is not a physics engine: there are no joints, rotating bodies or forces.
//!
//! ```
//! use tilesat::prelude::*;
//! use tilesat::{Aabb, Axis, Circle, Fx, Inside, Mover, TileKind, TileKinds, TileMap, Vec2};
//!
//! // The characters of the text are the tile ids; the table says what they are.
//! static KINDS: TileKinds = TileKinds::EMPTY
//!     .with(b'#', TileKind::FULL)
//!     .with(b'=', TileKind::ONE_WAY_UP)
//!     .with(b'o', TileKind::EMPTY.with_flags(1));
//! let rows = "..o.....\n...===..\n........\n########\n"; // cells of 16 x 16 units, rows downward
//! let level = TileMap::from_ascii(rows, &KINDS)?;
//!
//! let player = Aabb::new(Vec2::from_ints(20, 20), Vec2::from_ints(30, 34))?;
//! let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&level, &player, Vec2::from_ints(2, 30))?;
//! assert!(moved.floor); // landed on row 3, whose top is at y = 48
//! assert_eq!(moved.body.max().y, 48);
//!
//! let ray = level.cast_ray(Vec2::from_ints(4, 4), Vec2::from_ints(0, 90), Inside::Hit)?;
//! assert_eq!(ray.map(|hit| hit.point), Some(Vec2::from_ints(4, 48)));
//!
//! let ball = Circle::new(Vec2::from_ints(30, 40), Fx::from_num(8))?;
//! assert!(ball.touches(&moved.body) && level.flags_touched(&ball) == 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Conventions
//!
//! - **Numbers**: lengths are [`Fx`], 16.16; *raw* is one unit of its last place. Coordinates stay below 8192 units
//!   ([`num::DOMAIN`]); constructors refuse the rest, so kernels cannot wrap.
//! - **Touching is not overlapping.** `overlaps` is strict, `touches` is closed, both exact ([`query`]).
//! - **Normals** of contacts point from A to B, those of casts and rays out of what was hit; they are exact integers ([`Axis`]); the unit vector is computed when asked for.
//! - **Rounding** is safe: depths up, push-outs away, distances and times of impact down; what is moved never ends inside.
//! - **Directions**: y grows as the caller likes. Rows of a [`TileMap`] follow y, and "up" in a tile's name is toward row 0.
//! - **Units are per frame**: a velocity is the motion of one call.
//!
//! # Map
//!
//! | module | what |
//! |---|---|
//! | [`num`] | scalars, vectors, wide products, roots |
//! | [`shape`] | [`Aabb`], [`Circle`], [`Segment`] |
//! | [`query`] | one trait a verb, for each pair of shapes: overlaps, contacts, distances, casts |
//! | [`world`] | [`TileMap`], [`SegmentMap`], [`Solids`], [`Joined`], [`Rooms`]: surfaces, overlaps, contacts, rays |
//! | [`broad`] | [`BroadPhase`](broad::BroadPhase): which of many bodies are near each other; events of pairs |
//! | [`scene`] | [`Scene`]: level, broad phase and bodies by one call a frame |
//! | [`motion`] | [`Mover::move_and_slide`], [`Walker`], [`Mover::ride`] on moving [`Solid`]s, responses, casts through levels |
//! | [`error`] | what can be refused |
//! | [`boards`] | notes for real boards: targets, manifests, frame budgets |
//!
//! # Features
//!
//! None is on by default and none changes a result. `defmt` adds a compact `Format` to every public type. `libm` takes the
//! processor's square root on x86-64: a circle's cast costs a quarter less.

#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
// What could panic, or would be floating point, is refused in the library; tests and examples are free.
#![warn(
    clippy::expect_used,
    clippy::float_arithmetic,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::std_instead_of_core
)]
#![warn(clippy::unreachable, clippy::unwrap_used)]

pub use {fixed, heapless};

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
pub mod world;

pub use error::{Quantity, RangeError, Truncated};
pub use filter::{Filter, LayerMask};
pub use motion::{
    Acceleration, Body, BodyHit, Carry, Character, Energy, Feel, Hit, Hits, Input, Masses, MoveError, Moved, Mover,
    Outcome, Response, Ridden, Ride, SlopeSpeed, Smooth, Speed, StartInside, Step, Stuck, Support, Surface, Walked,
    Walker, Work,
};
pub use num::{Axis, Fx, Ratio, Toi, UnitVec2, Vec2};
pub use query::{CastHit, Contact, Inside, MovingHit};
pub use scene::{Scene, SceneBody, SceneError};
pub use shape::{Aabb, Circle, Segment};
/// The verbs: `use tilesat::prelude::*;` brings the traits of the pair queries into scope. Types come from the crate's root.
pub mod prelude {
    pub use crate::broad::BroadPhase;
    pub use crate::query::{CastShape, ClosestPoint, Contacts, Contains, Distance, Overlaps, Touches};
}
pub use world::{
    AllShapes, Bits, Blocks, Bytes, Cell, Feature, Features, Geometry, Grid, Joined, JoinedFeatures, JoinedRayHits,
    Near, OneWay, Outside, Path, PathKind, Placed, PlacedFeatures, PlacedRayHits, RayHit, RayHits, RayRules, Room,
    Rooms, SegmentFault, SegmentFeatures, SegmentMap, SegmentMapError, SegmentRayHits, Side, Size, Slopes, Solid,
    SolidFeatures, SolidRayHits, Solids, TileAt, TileKind, TileKinds, TileMap, TileMapError, TileShape, Tiles, World,
    WorldContact,
};

/// The README's example is a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
