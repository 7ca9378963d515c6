//! What a step tells.

use super::SceneError;
use crate::broad::{Handle, Pair};
use crate::motion::Hits;
use crate::query::Contact;

/// What happened in a step, as it happens; in no particular order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SceneEvent<'a> {
    /// Two bodies, sensors too, touched at the step's start. In every step in which they do and one of them is awake: for begin and end feed `pair` to
    /// [`PairEvents`](crate::broad::PairEvents).
    Touch {
        /// Who; `a` has the smaller key.
        pair: Pair,
        /// How they overlap, from `a` to `b`; none where they only touch.
        contact: Option<&'a Contact>,
    },
    /// A body ran into the level.
    Level {
        /// Who.
        body: Handle,
        /// Into what.
        hits: &'a Hits,
        /// The flags of all that, or-ed.
        flags: u8,
    },
    /// A body could not be moved: it stays where it was, and has no velocity any more.
    Held(SceneError),
}

/// What a step did: for budgets and tests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stepped {
    /// Bodies that the level was asked about: those awake. Zero where all sleep.
    pub moved: u16,
    /// Bodies of those that were [held](SceneEvent::Held).
    pub held: u16,
    /// Bodies that something touched while they slept.
    pub woken: u16,
    /// Bodies that fell asleep.
    pub slept: u16,
    /// Pairs of boxes looked into, twice where bodies ran into each other. Zero where all sleep.
    pub pairs: u32,
    /// Pairs of bodies that touched at the step's start.
    pub touching: u32,
    /// Pairs of bodies that overlapped then and are no sensors; what is left of that shows in the next step.
    pub overlapping: u32,
}
