//! What a scene remembers, so that bodies need no look at the level.
//!
//! The first N places are for the N slots: how the body there lies. The further places are for
//! short motions of any body. A body that others push to and fro on one spot repeats the same few
//! motions, often for ever. A ball on a slope leans on a box, which pushes it away, and it rolls
//! back. Two motions are equal if the body, its position and the causes are equal.

use super::body::Slot;
use super::body_path::{Drift, Pace, size};
use super::pressed::Pressed;
use crate::motion::{Hit, Hits, Moved};
use crate::num::Vec2;

/// A place of the memory.
#[derive(Clone, Copy, Debug)]
pub(super) enum Remembered {
    Empty,
    Rest(Rest),
    Path(RememberedPath),
}

/// A short motion through the level.
#[derive(Clone, Copy, Debug)]
pub(super) struct RememberedPath {
    made: Made,
    slot: u16,
    from: Vec2,
    by: Vec2,
    /// It was made or repeated since all places were in use.
    used: bool,
}

/// The last motion of a body through the level.
///
/// If it led nowhere, its next motion with the same causes does the same, as long as neither the
/// body nor the level changes. Each change clears this: a step changes a body in
/// [`Trip::make`](super::through_level::Trip), and the game in
/// [`Scene::alter`](super::Scene::alter). The game announces a change of the level by
/// [`Scene::wake_region`](super::Scene::wake_region).
#[derive(Clone, Copy, Debug)]
pub(super) struct Rest {
    pub(super) made: Made,
    pub(super) start: Start,
    pub(super) idle: Idle,
    /// It led nowhere, and nothing has moved the body since.
    pub(super) stays: bool,
}

/// The causes of a motion through the level, and its end, without its displacement.
#[derive(Clone, Copy, Debug)]
pub(super) struct Made {
    pub(super) causes: Causes,
    /// The velocity that is left.
    pub(super) velocity: Vec2,
    /// A body at rest touches one surface, or two that it is wedged between. Two hits are half of
    /// those that a motion may have.
    hits: [Option<Hit>; 2],
    pub(super) floor: bool,
    /// The [sides](super::blocked_sides) to which less than half of the push was made.
    pub(super) blocked: u8,
}

/// The state of a body before its motion, without its shape and velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Start {
    pub(super) support: u8,
    pub(super) ground: u16,
    pub(super) quiet: u8,
    pub(super) blocked: u8,
    pub(super) drift: Drift,
    /// Whether it moved after all bodies below it.
    pub(super) lies: bool,
}

impl Start {
    pub(super) fn of<S>(slot: &Slot<S>) -> Self {
        Self {
            support: slot.support,
            ground: slot.ground,
            quiet: slot.quiet,
            blocked: slot.blocked,
            drift: slot.tally.drift,
            lies: slot.path.pace == Pace::Lies,
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

/// The causes of a body's motion in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Causes {
    pub(super) pressed: Pressed,
    pub(super) velocity: Vec2,
    /// Gravity, which decides at which speeds the body does not bounce, and which surfaces are
    /// floors.
    pub(super) gravity: Vec2,
}

impl Rest {
    pub(super) fn of(made: &Made, start: Start, by: Vec2) -> Self {
        Self { made: *made, start, idle: Idle::No, stays: by == Vec2::ZERO && made.hits[0].is_some() }
    }
}

impl Made {
    /// `None` if the motion had more hits than are kept.
    pub(super) fn of<B>(causes: Causes, moved: &Moved<B>, (velocity, blocked): (Vec2, u8)) -> Option<Self> {
        Some(Self { causes, velocity, hits: moved.hits.few()?, floor: moved.floor, blocked })
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

/// The displacement and the end of a motion that was made before.
pub(super) fn known(paths: &mut [Remembered], at: usize, from: Vec2, causes: &Causes) -> Option<(Vec2, Made)> {
    paths.iter_mut().find_map(|place| {
        let Remembered::Path(path) = place else { return None };
        let same = usize::from(path.slot) == at && path.from == from && path.made.causes == *causes;
        same.then(|| {
            path.used = true;
            (path.by, path.made)
        })
    })
}

/// Keeps a motion, if it is as short as those of bodies that hardly move. Long motions are seldom
/// repeated.
pub(super) fn note(paths: &mut [Remembered], at: usize, from: Vec2, by: Vec2, made: &Made) {
    if paths.is_empty() || size(by) > size(made.causes.gravity).saturating_mul(2) {
        return;
    }
    let free = |place: &Remembered| !matches!(place, Remembered::Path(path) if path.used);
    // Replaces one that was not repeated lately.
    if !paths.iter().any(free) {
        for place in &mut *paths {
            if let Remembered::Path(path) = place {
                path.used = false;
            }
        }
    }
    if let Some(place) = paths.iter_mut().find(|place| free(place)) {
        *place = Remembered::Path(RememberedPath { made: *made, slot: at as u16, from, by, used: true });
    }
}

/// Forgets the motions of a body that has changed.
pub(super) fn forget(paths: &mut [Remembered], at: usize) {
    for place in paths {
        if matches!(place, Remembered::Path(path) if usize::from(path.slot) == at) {
            *place = Remembered::Empty;
        }
    }
}
