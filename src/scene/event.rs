//! What a step of a scene reports: its events, and the work that it took.

use super::SceneFault;
use crate::broad::{Handle, Pair};
use crate::motion::Hits;
use crate::num::{Axis, Fx, Toi, Vec2};
use crate::query::Contact;

/// An event of a step, reported as it happens, in no particular order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SceneEvent<'a> {
    /// Two bodies, at most one of them a sensor, touched at the step's start. Reported in every
    /// step in which they touch and one of them is awake. For begin and end, pass the pairs of
    /// `Touch` and of [`Meet`](Self::Meet), which reports fast bodies, to
    /// [`PairEvents`](crate::broad::PairEvents).
    Touch {
        /// The two bodies; `a` has the smaller key.
        pair: Pair,
        /// How they overlap, from `a` to `b`; `None` if they only touch.
        contact: Option<&'a Contact>,
    },
    /// Two bodies, at most one of them a sensor, ran into each other on their paths. One is
    /// [fast](super#fast-bodies).
    Meet {
        /// The two bodies; `a` has the smaller key.
        pair: Pair,
        /// The time, as a part of the step.
        toi: Toi,
        /// The normal, from `a` to `b`.
        axis: Axis,
        /// How fast they approached along the normal, in units per step, rounded to nearest.
        speed: Fx,
    },
    /// A body ran into the level.
    Level {
        /// The body.
        body: Handle,
        /// Its hits.
        hits: &'a Hits,
        /// The flags of all hits, or-ed.
        flags: u8,
        /// The velocity that it hit with. [`Hit::approach`](crate::motion::Hit::approach) says from
        /// it how hard each hit was.
        velocity: Vec2,
    },
    /// A body could not be moved: it overlaps the level, its motion is too long, or it would leave
    /// the domain or the broad phase. It stays where it was, and its velocity is now zero.
    Held {
        /// The body.
        body: Handle,
        /// Why it could not be moved.
        fault: SceneFault,
    },
}

/// The work of a step, for budgets and tests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stepped {
    /// Bodies that were moved through the level: those awake by then. Zero if all sleep.
    pub moved: u16,
    /// Bodies of those that were [held](SceneEvent::Held).
    pub held: u16,
    /// Sleeping bodies that were touched.
    pub woken: u16,
    /// Bodies that fell asleep.
    pub slept: u16,
    /// Pairs of boxes tested, twice if bodies ran into each other. Round bodies at seams of flush
    /// boxes cost three more tests. Zero if all sleep. Memory saves some of it.
    pub pairs: u32,
    /// Pairs of bodies that touched at the step's start.
    pub touching: u32,
    /// Pairs of bodies that overlapped at the step's start, without sensors. A remaining overlap
    /// counts in the next step.
    pub overlapping: u32,
}
