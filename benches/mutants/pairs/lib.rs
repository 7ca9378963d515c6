//! The crate without levels, bodies and motion: what the queries of pairs need.

#![no_std]
// What the rest of the crate uses is idle here.
#![allow(dead_code, unused_imports)]

pub use fixed;

pub mod error;
pub mod num;
pub mod query;
pub mod shape;

pub use error::{Quantity, RangeError, Truncated};
pub use num::{Axis, Fx, Ratio, Toi, UnitVec2, Vec2};
pub use query::{CastHit, Contact, Inside, MovingHit};
pub use shape::{Aabb, Circle, Segment};

pub mod prelude {
    pub use crate::query::{CastShape, ClosestPoint, Contacts, Contains, Distance, Overlaps, Touches};
}
