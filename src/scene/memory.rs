//! What a scene remembers, so that bodies need no look at the level.
//!
//! The first N places are for the N slots: how the body there lies. The places beyond are for short
//! ways of any body. A body that others push to and fro on one spot makes the same few ways again
//! and again, often for ever: a ball on a slope leans on a box, which pushes it away, so that it
//! rolls back. A way is the same if the body is, with its position, and what moves it.

use super::rest::{Causes, Made, Rest};
use super::way::size;
use crate::num::Vec2;

/// A place of the memory.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    Empty,
    Rest(Rest),
    Way(Way),
}

/// A short way through the level.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    made: Made,
    slot: u16,
    from: Vec2,
    by: Vec2,
    /// It was made or repeated since all places were in use.
    used: bool,
}

pub(super) fn rest(places: &[Place], at: usize) -> Option<&Rest> {
    if let Place::Rest(rest) = places.get(at)? { Some(rest) } else { None }
}

pub(super) fn rest_mut(places: &mut [Place], at: usize) -> Option<&mut Rest> {
    if let Place::Rest(rest) = places.get_mut(at)? { Some(rest) } else { None }
}

/// Keeps how the body in a slot lies, if there is a place for it.
pub(super) fn keep(places: &mut [Place], at: usize, rest: Option<Rest>) {
    if let Some(place) = places.get_mut(at) {
        *place = rest.map_or(Place::Empty, Place::Rest);
    }
}

/// How far a way led that was made before, and its end.
pub(super) fn known(ways: &mut [Place], at: usize, from: Vec2, causes: &Causes) -> Option<(Vec2, Made)> {
    ways.iter_mut().find_map(|place| {
        let Place::Way(way) = place else { return None };
        let same = usize::from(way.slot) == at && way.from == from && way.made.causes == *causes;
        same.then(|| {
            way.used = true;
            (way.by, way.made)
        })
    })
}

/// Keeps a way that was made, if it is as short as those of bodies that hardly move. Long ways are
/// seldom repeated.
pub(super) fn note(ways: &mut [Place], at: usize, from: Vec2, by: Vec2, made: &Made) {
    if ways.is_empty() || size(by) > size(made.causes.gravity).saturating_mul(2) {
        return;
    }
    let free = |place: &Place| !matches!(place, Place::Way(way) if way.used);
    // In the place of one that was not repeated lately.
    if !ways.iter().any(free) {
        for place in &mut *ways {
            if let Place::Way(way) = place {
                way.used = false;
            }
        }
    }
    if let Some(place) = ways.iter_mut().find(|place| free(place)) {
        *place = Place::Way(Way { made: *made, slot: at as u16, from, by, used: true });
    }
}

/// A body has changed: forgets its ways.
pub(super) fn forget(ways: &mut [Place], at: usize) {
    for place in ways {
        if matches!(place, Place::Way(way) if usize::from(way.slot) == at) {
            *place = Place::Empty;
        }
    }
}
