//! The errors that several modules share: small values that say what and where.
//!
//! An error that wraps another one prints it as a part of its own message, because a chip logs one
//! line. So [`source`](core::error::Error::source) is `None` everywhere, and a report that prints
//! the chain of causes repeats nothing. Match the variant to get the inner error.
//!
//! Enums of errors and of a scene's events are `non_exhaustive`: a later version may refuse more,
//! or report more. Enums that a game acts on are complete: [`Outcome`](crate::Outcome),
//! [`Ride`](crate::motion::Ride), [`PairEvent`](crate::broad::PairEvent),
//! [`PairsError`](crate::broad::PairsError). If one of them grows, the compiler shows you each
//! place that must handle the new case.

use crate::num::Fx;
use core::fmt;

/// The input that a [`RangeError`] names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
// A word, because in a `Result` an error shares the memory of the answer. A byte in it would split
// the copies of the answer at an odd address. A Cortex-M0 then copies byte by byte, which takes 17
// % of a hero's frame.
#[repr(u32)]
pub enum Quantity {
    /// A horizontal coordinate.
    X,
    /// A vertical coordinate.
    Y,
    /// A radius: negative or too large.
    Radius,
    /// A half extent: negative or too large.
    HalfExtent,
    /// The width of a box: its minimum is right of its maximum, or a solid has none.
    Width,
    /// The height of a box: its minimum is beyond its maximum, or a solid has none.
    Height,
    /// The horizontal component of a motion.
    MotionX,
    /// The vertical component of a motion.
    MotionY,
    /// The width, height or radius of a body that is to be moved.
    BodySize,
    /// How far a walker keeps to the ground.
    Snap,
    /// How far a body moves down with a floor that sinks.
    Follow,
    /// The length of a stick or a rope.
    Length,
    /// How high a walker steps.
    StepHeight,
    /// How far a mover may move a body aside: [`Mover::assist`](crate::Mover::assist).
    Assist,
    /// The number of cells of a level that a motion would visit, not a length.
    Cells,
    /// The direction of a box: both components are zero, or one is `i32::MIN`, which has no
    /// opposite.
    Direction,
    /// The slant of a moving capsule. It must be upright or level. Zero means that it has no
    /// radius.
    Capsule,
    /// The shape of a moving body, or of a solid, has no area. The value is the smaller side of its
    /// bounding box.
    Area,
    /// The radius of a solid that must be sharp: [`ConvexSolid`](crate::world::ConvexSolid).
    Rounding,
    /// The number of corners that a solid has, and keeps when it turns.
    Corners,
    /// The horizontal coordinate at which a motion or a ray would end.
    EndX,
    /// The vertical coordinate at which a motion or a ray would end.
    EndY,
    /// [`Feel::fall`](crate::Feel::fall), which must not be negative; so for the six that follow.
    Fall,
    /// [`Feel::jump`](crate::Feel::jump).
    Jump,
    /// [`Feel::jump_cut`](crate::Feel::jump_cut).
    JumpCut,
    /// [`Feel::acceleration`](crate::Feel::acceleration).
    Acceleration,
    /// [`Feel::air_acceleration`](crate::Feel::air_acceleration).
    AirAcceleration,
    /// [`Feel::wall_jump`](crate::Feel::wall_jump).
    WallJump,
    /// [`Feel::wall_slide`](crate::Feel::wall_slide).
    WallSlide,
}

/// An input outside the range that keeps arithmetic exact; nothing was changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RangeError {
    /// The input that is out of range.
    pub what: Quantity,
    /// The raw value that is out of range. For a circle, the coordinate that it would reach.
    pub value: i32,
}

impl fmt::Display for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (what, value) = (self.what, self.value);
        let settle = match what {
            Quantity::X | Quantity::Y => "keep positions less than 8192 units from the origin on each axis",
            Quantity::Radius | Quantity::HalfExtent | Quantity::Length => "it must be from 0 to below 8192 units",
            Quantity::Width | Quantity::Height if value == 0 => "that of a solid must be above 0",
            Quantity::Width | Quantity::Height => "the maximum of a box must not be less than its minimum",
            Quantity::MotionX | Quantity::MotionY => "a motion must be less than 4096 units on each axis",
            Quantity::EndX | Quantity::EndY => {
                "motions and rays must end less than 8192 units from the origin on each axis"
            }
            Quantity::BodySize => "a moving body must be less than 8192 units wide and high",
            Quantity::Cells => {
                return write!(
                    f,
                    "the motion visits too many cells, {value} or more: shorten it, or enlarge the cells"
                );
            }
            Quantity::Direction if value == i32::MIN => {
                return write!(f, "a direction needs an opposite: its components must be above i32::MIN");
            }
            Quantity::Direction => {
                return write!(f, "a direction is needed: one of its two components must not be zero");
            }
            Quantity::Area => {
                return write!(
                    f,
                    "the shape has no area: a solid needs one, and so does an oriented box, polygon or `AnyShape` that moves"
                );
            }
            Quantity::Rounding => {
                return write!(
                    f,
                    "a solid that turns or has slanted sides cannot have a radius of {} ({value} raw): make it a sharp polygon; a round box that is level can be an `AnyShape`",
                    Fx::from_bits(value)
                );
            }
            Quantity::Corners => {
                return write!(f, "a solid keeps its number of corners when it turns: the new shape must have {value}");
            }
            Quantity::Capsule if value == 0 => {
                return write!(f, "the capsule has no radius: a moving capsule needs one");
            }
            Quantity::Capsule => {
                return write!(
                    f,
                    "the capsule is slanted by {} ({value} raw): make it upright or level, or move it as an `AnyShape`",
                    Fx::from_bits(value)
                );
            }
            Quantity::Fall
            | Quantity::Jump
            | Quantity::JumpCut
            | Quantity::Acceleration
            | Quantity::AirAcceleration
            | Quantity::WallJump
            | Quantity::WallSlide => "only the gravity of a `Feel` may be negative: \"up\" follows from that",
            // The settings of walkers and riders.
            _ => "it must be from 0 to below 4096 units",
        };
        if matches!(what, Quantity::X | Quantity::Y) && matches!(value, i32::MIN | i32::MAX) {
            // Whole units that do not fit, or the end at which operators of vectors stop.
            return write!(f, "{what:?} does not fit: numbers go from -32768 to below 32768; {settle}");
        }
        write!(f, "{what:?} is out of range: {} ({value} raw); {settle}", Fx::from_bits(value))
    }
}

impl core::error::Error for RangeError {}

/// A result was cut off because the list was full.
///
/// The kept results come first in the documented order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Truncated {
    /// The number of results.
    pub seen: u32,
    /// The number of results that were kept.
    pub kept: u32,
}

impl fmt::Display for Truncated {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the list has room for {} of {} results: enlarge it", self.kept, self.seen)
    }
}

impl core::error::Error for Truncated {}

/// Points that are not the corners of a convex polygon, or have none; nothing was changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum PolygonError {
    /// There are fewer than three corners. For a hull: all points are on one line.
    TooFew {
        /// How many there are.
        count: usize,
    },
    /// There are more corners than the polygon can hold.
    TooMany {
        /// The number of corners that the polygon can hold.
        capacity: usize,
    },
    /// A point is outside the domain.
    Range {
        /// Which one, counted from zero.
        at: usize,
        /// The fault of the corner.
        error: RangeError,
    },
    /// A corner is at the position of the one before it.
    Repeated {
        /// Which one, counted from zero.
        at: usize,
    },
    /// A corner is on one line with its neighbours. Leave it out.
    Collinear {
        /// Which one, counted from zero.
        at: usize,
    },
    /// A corner turns in the other direction than those before it. Use the hull, or cut the polygon
    /// into convex parts.
    Reflex {
        /// Which one, counted from zero.
        at: usize,
    },
    /// The path of the corners winds around more than once.
    Winds {
        /// How often it winds around.
        times: usize,
    },
}

impl fmt::Display for PolygonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew { count } => {
                write!(f, "the polygon has {count} corners, but needs three that are not on one line")
            }
            Self::TooMany { capacity } => {
                write!(f, "the polygon has more than {capacity} corners: raise the capacity, or leave corners out")
            }
            Self::Range { at, error } => write!(f, "corner {at}: {error}"),
            Self::Repeated { at } => write!(f, "corner {at} equals the corner before it: leave it out"),
            Self::Collinear { at } => write!(f, "corner {at} is on one line with its neighbours: leave it out"),
            Self::Reflex { at } => write!(f, "corner {at} turns the other way: take the hull, or convex parts"),
            Self::Winds { times } => write!(f, "the corners go round {times} times: list them once around the polygon"),
        }
    }
}

impl core::error::Error for PolygonError {}
