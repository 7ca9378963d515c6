//! What a query that fills a buffer refuses.

use crate::error::{RangeError, Truncated};
use core::fmt;

/// Why a query has no answer, or not the whole one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum QueryError {
    /// It was not asked: an argument is out of range. The buffer is empty.
    Range(RangeError),
    /// The buffer is full of what comes first; the rest did not fit.
    Truncated(Truncated),
}

impl From<RangeError> for QueryError {
    fn from(error: RangeError) -> Self {
        Self::Range(error)
    }
}

impl From<Truncated> for QueryError {
    fn from(error: Truncated) -> Self {
        Self::Truncated(error)
    }
}

impl fmt::Display for QueryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range(error) => error.fmt(f),
            Self::Truncated(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for QueryError {}
