//! Where an enumeration of pairs stands, and what it may still spend.

use super::PairsError;

/// Where an enumeration of pairs stands between two calls; plain data, at the start by default.
///
/// It belongs to one broad phase, and to its snapshots only with a copy of the cursor made at the same time: where a snapshot is put back without that,
/// begin with a new one, or pairs may be missed. Bodies may be removed in between; where one is inserted or moved the next call says
/// [`Changed`](PairsError::Changed), once, and the call after that begins anew.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PairCursor {
    pub(super) epoch: u32,
    pub(super) under_way: bool,
    /// What is left to do of the present row or cell, as each broad phase sees it.
    pub(super) row: u16,
    pub(super) a: u16,
    pub(super) b: u16,
    pub(super) lane: u8,
}

impl PairCursor {
    /// At the start.
    #[must_use]
    pub const fn new() -> Self {
        Self { epoch: 0, under_way: false, row: 0, a: 0, b: 0, lane: 0 }
    }

    /// Begins or goes on.
    pub(super) fn resume(&mut self, epoch: u32) -> Result<(), PairsError> {
        if !self.under_way {
            *self = Self { epoch, under_way: true, ..Self::new() };
        } else if self.epoch != epoch {
            *self = Self::new();
            return Err(PairsError::Changed);
        }
        Ok(())
    }
}

/// Why a search for the next pair ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// Two boxes touch.
    Pair,
    /// The budget is spent.
    Spent,
    /// There are no more.
    End,
}

/// Counts the tests of an enumeration, or does not.
pub trait Meter {
    /// Takes one test from the budget; false where there is none left.
    fn spend(&mut self) -> bool;
}

/// No budget: costs nothing.
#[derive(Debug)]
pub(super) struct Unlimited;

impl Meter for Unlimited {
    #[inline]
    fn spend(&mut self) -> bool {
        true
    }
}

/// So many tests.
#[derive(Debug)]
pub(super) struct Budget(pub(super) u32);

impl Meter for Budget {
    #[inline]
    fn spend(&mut self) -> bool {
        match self.0.checked_sub(1) {
            Some(rest) => {
                self.0 = rest;
                true
            }
            None => false,
        }
    }
}
