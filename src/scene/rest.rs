//! What a scene remembers of bodies at rest, so that they need no look at the level.

use super::body::Slot;
use super::drift::Drift;
use crate::motion::{Hit, Hits, Moved};
use crate::num::Vec2;

/// The last way of a body through the level.
///
/// If it led nowhere, then its next way with the same causes is the same, as long as neither the
/// body nor the level changes. A change of the body by a step goes through
/// [`Trip::make`](super::trip::Trip), one by the game through [`Scene::alter`](super::Scene::alter),
/// and one of the level through [`Scene::wake_region`](super::Scene::wake_region); each clears this.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Rest {
    pub(super) causes: Causes,
    pub(super) start: Start,
    pub(super) idle: Idle,
    /// It led nowhere, and nothing has moved the body since.
    pub(super) stays: bool,
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
    /// It says at which speeds the body does not bounce.
    pub(super) weight: Vec2,
}

impl Rest {
    /// `None` if the way led to more hits than are kept.
    pub(super) fn of<B>(causes: Causes, start: Start, by: Vec2, moved: &Moved<B>) -> Option<Self> {
        let hits = moved.hits.few()?;
        let stays = by == Vec2::ZERO && !moved.hits.is_empty();
        Some(Self { causes, start, idle: Idle::No, stays, velocity: moved.velocity, hits, floor: moved.floor })
    }

    pub(super) fn hits(&self) -> Hits {
        Hits::of_few(self.hits)
    }

    pub(super) fn flags(&self) -> u8 {
        self.hits.iter().flatten().fold(0, |flags, hit| flags | hit.flags)
    }
}
