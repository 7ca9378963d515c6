//! Where and when the paths of two bodies meet, and which bodies can be on a path.

use super::SceneEvent;
use super::body::{Mode, Slot};
use super::body_path::{Pace, PathEnd, later, size};
use super::kernel::BodyShape;
use super::reply::Replies;
use crate::broad::{BroadPhase, Handle, Pair};
use crate::num::{Axis, DOMAIN, Raw, Toi, Vec2};
use crate::query::Touches;
use crate::shape::Aabb;

/// Where and when two bodies run into each other.
pub(super) struct Encounter {
    pub(super) pair: Pair,
    pub(super) time: Toi,
    /// From `a` to `b`.
    pub(super) axis: Axis,
    pub(super) place_a: Vec2,
    pub(super) place_b: Vec2,
    /// They did not overlap before.
    pub(super) begins: bool,
}

impl Encounter {
    /// In the order of the pair, so the result is the same for both bodies. The paths start at the
    /// time from which both bodies are on them.
    #[inline(never)]
    pub(super) fn of<S: BodyShape>(one: (Handle, &Slot<S>), other: (Handle, &Slot<S>)) -> Option<Self> {
        let pair = pair(one, other);
        let (a, b) = if pair.a == one.0 { (one.1, other.1) } else { (other.1, one.1) };
        let swept = |slot: &Slot<S>| slot.path.is_swept();
        let from = match (swept(a), swept(b)) {
            (true, true) => a.path.since.max(b.path.since),
            (true, false) => a.path.since,
            (false, true) => b.path.since,
            (false, false) => return None,
        };
        let (p, q) = (a.at(from), b.at(from));
        let (left_a, left_b) = (a.path.left(from), b.path.left(from));
        let hit = p.run_into(left_a, &q, left_b)?;
        if !hit.inside {
            // The cast's own displacements are shares of how far they approach, which may be zero.
            // So one body is placed by the time, and the other at the distance from the cast.
            let nearer = hit.displacement - hit.displacement_b;
            let (by_a, by_b) = if swept(a) {
                (hit.toi.of(left_b) + nearer, hit.toi.of(left_b))
            } else {
                (hit.toi.of(left_a), hit.toi.of(left_a) - nearer)
            };
            let (place_a, place_b) = (p.position() + by_a, q.position() + by_b);
            return Some(Self {
                pair,
                time: later(from, hit.toi),
                axis: hit.axis.reversed(),
                place_a,
                place_b,
                begins: true,
            });
        }
        let axis = p.contact(&q)?.axis();
        let nearing = axis.dot_vec(a.path.rate - b.path.rate) > 0;
        nearing.then_some(Self { pair, time: from, axis, place_a: p.position(), place_b: q.position(), begins: false })
    }

    /// The event of a meeting of its bodies, `a` and `b`.
    pub(super) fn event<S>(&self, a: &Slot<S>, b: &Slot<S>) -> SceneEvent<'static> {
        let speed = self.axis.approach(b.body.velocity - a.body.velocity);
        SceneEvent::Meet { pair: self.pair, toi: self.time, axis: self.axis, speed }
    }
}

/// The first end of a path among those that were compared. At the same time, the level goes before
/// bodies, then the body with the smaller key, then the one in the smaller slot.
pub(super) struct FirstEnd {
    pub(super) end: (Toi, PathEnd),
    /// The key and the slot of the body, if one ends it.
    rank: (u32, usize),
}

impl FirstEnd {
    /// The end at the level, if there is one.
    pub(super) fn of_level(hit: Option<Toi>) -> Self {
        Self { end: hit.map_or((Toi::ONE, PathEnd::Step), |time| (time, PathEnd::Level)), rank: (0, 0) }
    }

    /// An end that was found before.
    pub(super) fn known<S>(slots: &[Slot<S>], end: (Toi, PathEnd)) -> Self {
        let rank = match end.1 {
            PathEnd::Body(at) => (slots.get(usize::from(at)).map_or(0, |slot| slot.body.key), at.into()),
            PathEnd::Level | PathEnd::Step => (0, 0),
        };
        Self { end, rank }
    }

    /// Compares the end at a body that [counts](stops), if the two meet.
    pub(super) fn meet<S: BodyShape>(
        &mut self,
        one: (Handle, &Slot<S>),
        other: (Handle, &Slot<S>),
        replies: &mut impl Replies,
    ) {
        let Some(met) = Encounter::of(one, other) else { return };
        let (time, end) = self.end;
        let rank = (other.1.body.key, other.0.slot());
        let before = match end {
            PathEnd::Step => met.time <= time,
            PathEnd::Level => met.time < time,
            PathEnd::Body(_) => (met.time, rank) < (time, self.rank),
        };
        if before && replies.to(met.pair).acts() {
            (self.end, self.rank) = ((met.time, PathEnd::Body(other.0.slot() as u16)), rank);
        }
    }
}

impl<S: BodyShape> Slot<S> {
    /// Its shape at a time, on its path.
    pub(super) fn at(&self, time: Toi) -> S {
        self.body.shape.shifted(self.path.left(self.path.since) - self.path.left(time))
    }

    /// The box around the rest of its path. It is tested before a cast, which costs ten times as
    /// much: in a crowd it touches the boxes of only a few others.
    pub(super) fn passed(&self) -> Aabb {
        let start = self.body.shape.aabb();
        start.union(&self.body.shape.shifted(self.path.left(self.path.since)).aabb())
    }
}

/// The other bodies that may be on a body's path: slow ones at their positions in the broad phase,
/// and those that are swept.
pub(super) fn each_near<B: BroadPhase, S: BodyShape>(
    near: &B,
    slots: &[Slot<S>],
    (movers, margin): (&[Handle], u32),
    handle: Handle,
    counts: impl Fn(&Slot<S>, &Slot<S>) -> bool,
    mut each: impl FnMut(Handle, &Slot<S>),
) {
    let Some(slot) = slots.get(handle.slot()) else { return };
    let may = |other: Handle, swept: bool| {
        let found = slots.get(other.slot()).filter(|at| at.path.is_swept() == swept);
        found.filter(|at| other != handle && counts(slot, at))
    };
    let passed = slot.passed();
    near.in_region(&around(&passed, margin), |other| {
        if let Some(at) = may(other, false) {
            each(other, at);
        }
    });
    for &other in movers {
        if let Some(at) = may(other, true).filter(|at| at.passed().touches(&passed)) {
            each(other, at);
        }
    }
}

pub(super) fn may_meet<S>(one: &Slot<S>, other: &Slot<S>) -> bool {
    other.mode != Mode::Free && one.body.filter.with_still(false).lets_pair(other.body.filter.with_still(false))
}

/// Whether one of two is reported to the other, and neither pushes.
pub(super) const fn senses<S>(one: &Slot<S>, other: &Slot<S>) -> bool {
    one.body.filter.sensor() || other.body.filter.sensor()
}

/// Whether another body may end the path of one.
pub(super) fn stops<S>(one: &Slot<S>, other: &Slot<S>) -> bool {
    let counts = |slot: &Slot<S>| slot.path.pace == Pace::Swept || slot.mode == Mode::Fixed;
    (counts(one) || counts(other)) && may_meet(one, other) && !one.path.ignores(&other.path) && !senses(one, other)
}

/// Two bodies in canonical order.
pub(super) fn pair<S>(one: (Handle, &Slot<S>), other: (Handle, &Slot<S>)) -> Pair {
    let rank = |(handle, slot): (Handle, &Slot<S>)| (slot.body.key, handle.slot());
    let (a, b) = if rank(one) < rank(other) { (one.0, other.0) } else { (other.0, one.0) };
    Pair { a, b }
}

/// How far from its box a body may move in this step: no bounce makes it faster. The velocity of a
/// body without a mass only acts on others, and a sleeping body keeps what its last step collected.
pub(super) fn reach<S: BodyShape>(slot: &Slot<S>) -> u32 {
    if !slot.is_awake() {
        return 0;
    }
    size(slot.body.velocity + slot.tally.kick).saturating_add(size(slot.tally.push()))
}

/// A box grown on all sides, within the domain.
pub(super) fn around(bounds: &Aabb, by: u32) -> Aabb {
    let by = by.min(DOMAIN as u32) as i32;
    let (lo, hi) = (bounds.lo(), bounds.hi());
    let least = |c: i32| c.saturating_sub(by).max(1 - DOMAIN);
    let most = |c: i32| c.saturating_add(by).min(DOMAIN - 1);
    Aabb::from_raw_unchecked(Raw { x: least(lo.x), y: least(lo.y) }, Raw { x: most(hi.x), y: most(hi.y) })
}
