//! A way through the level, and what is remembered of a body that makes it.

use super::body::Slot;
use super::way::Drift;
use crate::motion::{Hit, Hits, Moved};
use crate::num::Vec2;

/// The last way of a body through the level.
///
/// If it led nowhere, then its next way with the same causes is the same, as long as neither the
/// body nor the level changes. A change of the body by a step goes through
/// [`Trip::make`](super::trip::Trip), one by the game through [`Scene::alter`](super::Scene::alter),
/// and one of the level through [`Scene::wake_region`](super::Scene::wake_region); each clears this.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rest {
    pub(super) made: Made,
    pub(super) start: Start,
    pub(super) idle: Idle,
    /// It led nowhere, and nothing has moved the body since.
    pub(super) stays: bool,
}

/// The causes of a way through the level, and its end, apart from how far it led.
#[derive(Clone, Copy, Debug)]
pub(super) struct Made {
    pub(super) causes: Causes,
    /// What is left of the velocity.
    pub(super) velocity: Vec2,
    /// A body at rest touches one surface, or two that it is wedged between. Two hits are half of
    /// all that a way may have.
    hits: [Option<Hit>; 2],
    pub(super) floor: bool,
}

/// The state that a body has before its way, apart from its shape and velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Start {
    pub(super) support: u8,
    pub(super) ground: u16,
    pub(super) quiet: u8,
    pub(super) drift: Drift,
}

impl Start {
    pub(super) fn of<S>(slot: &Slot<S>) -> Self {
        Self { support: slot.support, ground: slot.ground, quiet: slot.quiet, drift: slot.tally.drift }
    }
}

/// Whether a body repeats its last step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Idle {
    No,
    /// It counts its quiet steps.
    Counts,
    /// It is never quiet.
    Never,
}

/// What moves a body in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Causes {
    pub(super) push: Vec2,
    pub(super) velocity: Vec2,
    /// It says at which speeds the body does not bounce, and which surfaces are floors.
    pub(super) gravity: Vec2,
}

impl Rest {
    pub(super) fn of(made: &Made, start: Start, by: Vec2) -> Self {
        Self { made: *made, start, idle: Idle::No, stays: by == Vec2::ZERO && made.hits[0].is_some() }
    }
}

impl Made {
    /// `None` if the way led to more hits than are kept.
    pub(super) fn of<B>(causes: Causes, moved: &Moved<B>) -> Option<Self> {
        Some(Self { causes, velocity: moved.velocity, hits: moved.hits.few()?, floor: moved.floor })
    }

    pub(super) fn hits(&self) -> Hits {
        Hits::of_few(self.hits)
    }

    pub(super) fn flags(&self) -> u8 {
        self.hits.iter().flatten().fold(0, |flags, hit| flags | hit.flags)
    }
}
