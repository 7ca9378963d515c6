//! The errors that several modules share: small values that say what and where.

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
        let (what, value) = (self.what, self.value);
        let settle = match what {
            Quantity::X | Quantity::Y => "positions stay below 8192 units on each side of the origin",
            Quantity::Radius | Quantity::HalfExtent | Quantity::Length => "it must be from 0 to below 8192 units",
            Quantity::Width | Quantity::Height => "the second corner must be beyond the first",
            Quantity::MotionX | Quantity::MotionY => "shorten the motion, or begin it nearer to the origin",
            Quantity::BodySize => "a body that moves is below 8192 units wide and high",
            Quantity::Cells => {
                return write!(
                    f,
                    "the motion visits too many cells, {value} or more: shorten it, or enlarge the cells"
                );
            }
            // The settings of walkers and riders.
            _ => "it must be from 0 to below 4096 units",
        };
        write!(f, "{what:?} is out of range: {} ({value} raw); {settle}", Fx::from_bits(value))
    }
}

impl core::error::Error for RangeError {}

/// A result was cut off because the list was full. The kept results come first in the documented
/// order.
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
        write!(f, "only {} of {} results fit into the list: enlarge it", self.kept, self.seen)
    }
}

impl core::error::Error for Truncated {}
