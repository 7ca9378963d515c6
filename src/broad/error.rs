//! What a broad phase refuses.

use super::Handle;
use crate::num::Fx;
use core::fmt;

/// Why a body was not taken, moved or found; the broad phase is as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum BroadError {
    /// All slots are taken.
    Full {
        /// How many there are.
        capacity: u16,
    },
    /// The handle's body was removed.
    ///
    /// Of another broad phase a handle is told only where its slot has no body here, or one of another generation: there may be a body of the
    /// same name, and which of the two is meant cannot be told.
    Stale(Handle),
    /// The box is wider or higher than a cell of the grid, in raw units.
    TooLarge {
        /// The longer side.
        size: i32,
        /// The longest that fits.
        limit: i32,
    },
    /// The box's centre is outside of the grid, which refuses such bodies; in raw units.
    OutOfWorld {
        /// The centre.
        x: i32,
        /// The centre.
        y: i32,
    },
}

impl fmt::Display for BroadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Full { capacity } => write!(f, "all {capacity} slots are taken"),
            Self::Stale(handle) => {
                write!(f, "no body with slot {} and generation {}", handle.slot(), handle.generation())
            }
            Self::TooLarge { size, limit } => {
                write!(f, "a side of {} is longer than {}", Fx::from_bits(size), Fx::from_bits(limit))
            }
            Self::OutOfWorld { x, y } => {
                write!(f, "a centre at ({}, {}) is outside of the grid", Fx::from_bits(x), Fx::from_bits(y))
            }
        }
    }
}

impl core::error::Error for BroadError {}

/// Why an enumeration of pairs stopped before its end; nothing is lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PairsError {
    /// The budget of tests is spent: the next call goes on from here.
    BudgetExceeded,
    /// There is no more room for pairs: take them out, and the next call goes on from here.
    Full,
    /// A body was inserted or moved since the enumeration began: the cursor is at the start again.
    Changed,
}

impl fmt::Display for PairsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::BudgetExceeded => "the budget of tests is spent before all pairs were found",
            Self::Full => "there is no more room for pairs",
            Self::Changed => "bodies were inserted or moved during the enumeration",
        })
    }
}

impl core::error::Error for PairsError {}
