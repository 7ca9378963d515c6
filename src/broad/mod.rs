//! Many bodies: which of them are near each other, in fixed memory.
//!
//! A broad phase keeps a box for each body and finds those whose boxes touch. You then run the
//! exact queries on few pairs. It also finds the bodies near a point, in a region, on a ray or in
//! the way of a box. [`BroadPhase`] is the interface; beside its box, each body carries a [`Tag`].
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
mod cells;
mod events;
mod handle;
mod order;
mod phase;
mod plain;
#[cfg(feature = "serde")]
mod stored;
mod table;
#[cfg(test)]
mod tests;

pub use ask::{BroadHit, Nearest};
pub use cells::{Border, LooseGrid, SpatialHash};
pub use events::{Exceptions, Ignore, PairEvent, PairEvents};
pub use handle::{BroadError, GridError, PairsError, QueryError};
pub use handle::{Handle, Keyed, Pair, Tag};
pub use phase::BroadPhase;
pub use plain::{BruteForce, SortSweep};
pub use table::PairCursor;
