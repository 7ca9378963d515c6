//! Finds which of many bodies are near each other, in fixed memory.
//!
//! A broad phase keeps a box for each body and finds those whose boxes touch. You then run the
//! exact queries on few pairs. It also finds the bodies near a point, in a region, on a ray or in
//! front of a moving box. [`BroadPhase`] is the interface. Beside its box, each body has a [`Tag`].
//!
//! ```
//! use tilesat::broad::SortSweep;
//! use tilesat::prelude::*;
//! use tilesat::{Circle, Filter, Fx, LayerMask, Vec2};
//! const SHIP: LayerMask = LayerMask::layer(0);
//! const SHOT: LayerMask = LayerMask::layer(1);
//!
//! let mut near = SortSweep::<64, Filter>::new();
//! let mut balls = [Circle::new(Vec2::ZERO, Fx::ZERO)?; 64]; // the data of the game, by slot
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
//! This program shows queries at a point, in a region and near a point, and all pairs in parts.
//! Calls with a list write their results in canonical order.
//!
//! ```
//! use heapless::Vec;
//! use tilesat::broad::{BroadPhase, Handle, Nearest, PairCursor, SortSweep};
//! use tilesat::{Aabb, Vec2, fx};
//! let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
//! let mut near = SortSweep::<8>::new();
//! let [a, b] = [near.insert(&at(0)?, ())?, near.insert(&at(8)?, ())?];
//!
//! let mut clicked = None;
//! near.at_point(Vec2::from_ints(3, 3), |body| clicked = Some(body));
//! assert_eq!(clicked, Some(a));
//!
//! let mut found = Vec::<Handle, 8>::new();
//! near.collect_region(&at(4)?, &mut found)?;
//! assert_eq!(found, [a, b]);
//!
//! let mut close = Vec::<Nearest, 8>::new();
//! near.neighbours(Vec2::from_ints(20, 4), fx!(10), |_, _| true, &mut close)?;
//! assert_eq!((close.len(), close[0].handle), (1, b));
//!
//! // At most 100 tests of two boxes per call. Call again with the same cursor until it is `Ok`.
//! let (mut cursor, mut pairs) = (PairCursor::new(), Vec::<_, 8>::new());
//! near.pairs_from(&mut cursor, 100, &mut pairs)?;
//! assert_eq!((near.len(), pairs.len()), (2, 1));
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
mod stored {
    //! Slots, free slots and orders that have to agree.

    mod cells;
    mod lists;
    mod plain;
    mod slots;
}
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
