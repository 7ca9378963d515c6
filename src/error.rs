//! What can be wrong with an input: small values that say what and where.

use crate::num::Fx;
use core::fmt;

/// The input that a [`RangeError`] names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Quantity {
    /// A horizontal coordinate.
    X,
    /// A vertical coordinate.
    Y,
    /// A radius: negative or too large.
    Radius,
    /// A half extent: negative or too large.
    HalfExtent,
    /// The width of a box: its minimum is right of its maximum.
    Width,
    /// The height of a box: its minimum is beyond its maximum.
    Height,
    /// The horizontal component of a motion.
    MotionX,
    /// The vertical component of a motion.
    MotionY,
    /// The width, height or radius of a body that is to be moved.
    BodySize,
    /// How far a walker keeps to the ground.
    Snap,
    /// How far a body goes down with a floor that sinks.
    Follow,
    /// The length of a stick or a rope.
    Length,
    /// How high a walker steps.
    StepHeight,
    /// How far a body may be put aside: [`Mover::assist`](crate::Mover::assist).
    Assist,
    /// The cells of a level that a motion comes to: their number, not a length.
    Cells,
}

/// An input outside of the range that keeps arithmetic exact; nothing was changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RangeError {
    /// Which input.
    pub what: Quantity,
    /// The raw value that is out of range: of a circle or a motion, where it would reach.
    pub value: i32,
}

impl fmt::Display for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.what {
            Quantity::Cells => write!(f, "a motion comes to too many cells: {} or more", self.value),
            what => write!(f, "{what:?} is out of range: {} ({} raw)", Fx::from_bits(self.value), self.value),
        }
    }
}

impl core::error::Error for RangeError {}

/// A result was cut off because the room for it was full; what is kept comes first in the documented order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Truncated {
    /// How many results there were.
    pub seen: u32,
    /// How many of them were kept.
    pub kept: u32,
}

impl fmt::Display for Truncated {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "only {} of {} results fit", self.kept, self.seen)
    }
}

impl core::error::Error for Truncated {}
