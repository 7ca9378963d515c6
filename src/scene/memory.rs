//! What a scene remembers, so that bodies need no look at the level.
//!
//! The first N places are for the N slots: how the body there lies. The places beyond are for short
//! ways of any body. A body that others push to and fro on one spot makes the same few ways again
//! and again, often for ever: a ball on a slope leans on a box, which pushes it away, so that it
//! rolls back. A way is the same if the body is, with its position, and what moves it.

use super::body::Slot;
use super::body_way::{Drift, size};
use crate::motion::{Hit, Hits, Moved};
use crate::num::Vec2;

/// A place of the memory.
#[derive(Clone, Copy, Debug)]
pub(super) enum Remembered {
    Empty,
    Rest(Rest),
    Way(RememberedWay),
}

/// A short way through the level.
#[derive(Clone, Copy, Debug)]
pub(super) struct RememberedWay {
    made: Made,
    slot: u16,
    from: Vec2,
    by: Vec2,
    /// It was made or repeated since all places were in use.
    used: bool,
}

/// The last way of a body through the level.
///
/// If it led nowhere, then its next way with the same causes is the same, as long as neither the
/// body nor the level changes. A change of the body by a step goes through
/// [`Trip::make`](super::through_level::Trip), one by the game through [`Scene::alter`](super::Scene::alter),
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
    /// The [sides](super::blocked_sides) to which the push led less than half its way.
    pub(super) blocked: u8,
}

/// The state that a body has before its way, apart from its shape and velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Start {
    pub(super) support: u8,
    pub(super) ground: u16,
    pub(super) quiet: u8,
    pub(super) blocked: u8,
    pub(super) drift: Drift,
}

impl Start {
    pub(super) fn of<S>(slot: &Slot<S>) -> Self {
        Self {
            support: slot.support,
            ground: slot.ground,
            quiet: slot.quiet,
            blocked: slot.blocked,
            drift: slot.tally.drift,
        }
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
    pub(super) fn of<B>(causes: Causes, moved: &Moved<B>, blocked: u8) -> Option<Self> {
        Some(Self { causes, velocity: moved.velocity, hits: moved.hits.few()?, floor: moved.floor, blocked })
    }

    pub(super) fn hits(&self) -> Hits {
        Hits::of_few(self.hits)
    }

    pub(super) fn flags(&self) -> u8 {
        self.hits.iter().flatten().fold(0, |flags, hit| flags | hit.flags)
    }
}

pub(super) fn rest(places: &[Remembered], at: usize) -> Option<&Rest> {
    if let Remembered::Rest(rest) = places.get(at)? { Some(rest) } else { None }
}

pub(super) fn rest_mut(places: &mut [Remembered], at: usize) -> Option<&mut Rest> {
    if let Remembered::Rest(rest) = places.get_mut(at)? { Some(rest) } else { None }
}

/// Keeps how the body in a slot lies, if there is a place for it.
pub(super) fn keep(places: &mut [Remembered], at: usize, rest: Option<Rest>) {
    if let Some(place) = places.get_mut(at) {
        *place = rest.map_or(Remembered::Empty, Remembered::Rest);
    }
}

/// How far a way led that was made before, and its end.
pub(super) fn known(ways: &mut [Remembered], at: usize, from: Vec2, causes: &Causes) -> Option<(Vec2, Made)> {
    ways.iter_mut().find_map(|place| {
        let Remembered::Way(way) = place else { return None };
        let same = usize::from(way.slot) == at && way.from == from && way.made.causes == *causes;
        same.then(|| {
            way.used = true;
            (way.by, way.made)
        })
    })
}

/// Keeps a way that was made, if it is as short as those of bodies that hardly move. Long ways are
/// seldom repeated.
pub(super) fn note(ways: &mut [Remembered], at: usize, from: Vec2, by: Vec2, made: &Made) {
    if ways.is_empty() || size(by) > size(made.causes.gravity).saturating_mul(2) {
        return;
    }
    let free = |place: &Remembered| !matches!(place, Remembered::Way(way) if way.used);
    // In the place of one that was not repeated lately.
    if !ways.iter().any(free) {
        for place in &mut *ways {
            if let Remembered::Way(way) = place {
                way.used = false;
            }
        }
    }
    if let Some(place) = ways.iter_mut().find(|place| free(place)) {
        *place = Remembered::Way(RememberedWay { made: *made, slot: at as u16, from, by, used: true });
    }
}

/// A body has changed: forgets its ways.
pub(super) fn forget(ways: &mut [Remembered], at: usize) {
    for place in ways {
        if matches!(place, Remembered::Way(way) if usize::from(way.slot) == at) {
            *place = Remembered::Empty;
        }
    }
}
