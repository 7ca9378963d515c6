//! Many bodies: which of them are near each other, in fixed memory.
//!
//! A broad phase keeps a box for each body and finds those whose boxes touch, so that the exact queries are asked about few pairs. It says who is near a point, in a region, on a
//! ray or in the way of a box, too. [`BroadPhase`] is the interface; what a body carries beside its box is its [`Tag`].
//!
//! ```
//! use tilesat::broad::SortSweep;
//! use tilesat::prelude::*;
//! use tilesat::{Circle, Filter, Fx, LayerMask, Vec2};
//! const SHIP: LayerMask = LayerMask::layer(0);
//! const SHOT: LayerMask = LayerMask::layer(1);
//!
//! let mut near = SortSweep::<64, Filter>::new();
//! let mut balls = [Circle::new(Vec2::ZERO, Fx::ZERO)?; 64]; // the game's own, by slot
//! for (x, layer, meets) in [(0, SHIP, SHOT), (6, SHOT, SHIP), (13, SHOT, SHIP)] {
//!     let ball = Circle::new(Vec2::from_ints(x, 0), Fx::from_num(4))?;
//!     let handle = near.insert(&ball.aabb(), Filter::new(layer, meets))?;
//!     balls[handle.slot()] = ball;
//! }
//! let mut hits = 0;
//! near.pairs(|pair| hits += u32::from(balls[pair.a.slot()].overlaps(&balls[pair.b.slot()])));
//! assert_eq!(hits, 1); // the ship and the nearer shot; shots do not meet
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
#![doc = include_str!("guide.md")]

mod ask;
mod brute;
mod cells;
mod cursor;
mod error;
mod events;
mod handle;
mod phase;
mod spatial;
mod sweep;
mod table;
mod tag;

pub use ask::{BroadHit, Nearest, QueryError};
pub use brute::BruteForce;
pub use cells::{Border, GridError, LooseGrid, SpatialHash};
pub use cursor::PairCursor;
pub use error::{BroadError, PairsError};
pub use events::{Exceptions, Ignore, PairEvent, PairEvents};
pub use handle::{Handle, Pair};
pub use phase::BroadPhase;
pub use sweep::SortSweep;
pub use tag::{Keyed, Tag};
