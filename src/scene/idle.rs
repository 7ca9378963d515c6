//! Bodies of a scene that remembers, and repeat their last step.
//!
//! If a step changes neither a body nor any body that it touches, the next step changes nothing
//! either: it starts from the same state. So these bodies are not moved. Their events are those of
//! the last step.
//!
//! This holds as long as no other body comes near. A body that is not idle moves no farther in a
//! step than [`stop_idling_in_reach`](Scene::stop_idling_in_reach) assumes. All bodies within that
//! distance make their steps in full.

use super::body::{Mode, Slot};
use super::body_path::{Pace, size};
use super::kernel::BodyShape;
use super::meeting_time::{around, reach};
use super::memory::{Idle, Remembered, Rest, rest, rest_mut};
use super::pairs::root;
use super::{Scene, SceneEvent, Stepped};
use crate::broad::{BroadPhase, Handle, Keyed, Pair};
use crate::filter::Filter;
use crate::num::{Raw, Vec2};
use crate::query::Touches;
use crate::shape::Aabb;

impl Rest {
    /// Whether the step left a body as it was.
    fn repeats<S: BodyShape>(&self, slot: &Slot<S>, gravity: Vec2) -> Idle {
        let causes = &self.made.causes;
        let before = causes.velocity - slot.body.weight(gravity) - slot.tally.kick;
        let as_it_was = slot.mode == Mode::Awake
            && slot.path.rate == Vec2::ZERO
            && slot.body.velocity == before
            && causes.gravity == gravity
            && (slot.support, slot.ground, slot.blocked, slot.tally.drift)
                == (self.start.support, self.start.ground, self.start.blocked, self.start.drift);
        match (as_it_was, self.start.quiet.saturating_add(1) == slot.quiet, self.start.quiet == slot.quiet) {
            (true, true, _) => Idle::Counts,
            (true, false, true) => Idle::Never,
            _ => Idle::No,
        }
    }
}

/// Whether the body in a slot makes no step.
pub(super) fn is_idle(memory: &[Remembered], at: usize) -> bool {
    idle(memory, at).is_some()
}

/// Makes the body in a slot move in full in the next step. Returns whether it was idle.
pub(super) fn stop_idling(memory: &mut [Remembered], at: usize) -> bool {
    let Some(rest) = rest_mut(memory, at) else { return false };
    core::mem::replace(&mut rest.idle, Idle::No) != Idle::No
}

pub(super) fn idle(memory: &[Remembered], at: usize) -> Option<&Rest> {
    rest(memory, at).filter(|rest| rest.idle != Idle::No)
}

/// Whether nothing changes between two bodies.
pub(super) fn are_idle<S>(memory: &[Remembered], slots: &[Slot<S>], pair: Pair) -> bool {
    let fixed = |at: Handle| slots.get(at.slot()).is_some_and(|slot| slot.mode == Mode::Fixed);
    let [a, b] = [pair.a, pair.b].map(|at| is_idle(memory, at.slot()));
    (a && (b || fixed(pair.b))) || (b && fixed(pair.a))
}

/// How far from its box a body may move in this step: [`reach`], with the state in which an idle
/// body made its last step.
pub(super) fn reach_of<S: BodyShape>(memory: &[Remembered], slot: &Slot<S>, at: usize) -> u32 {
    idle(memory, at).map_or_else(
        || reach(slot),
        |rest| size(rest.made.causes.velocity).saturating_add(size(rest.made.causes.pressed.push())),
    )
}

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, const M: usize, S: BodyShape> Scene<B, N, M, S> {
    /// Before a step: ends the idleness of bodies that another one may reach.
    ///
    /// A hit changes a velocity by at most twice the difference of the two, and a push is at most
    /// an overlap. In a pile one body may push the next. Take the sum of four times the velocity
    /// and of the overlap, over all bodies that a body may meet, directly or not. It moves no
    /// farther in a step. These bodies are a company: two join if they are no farther apart than
    /// both may move.
    #[inline(never)]
    pub(super) fn stop_idling_in_reach(&mut self, gravity: Vec2) {
        let Self { near, slots, awake, count, memory, .. } = self;
        let awake = awake.get(..*count).unwrap_or_default();
        // A body that sleeps may wake in this step, and move.
        let all = slots.iter().any(|slot| slot.mode == Mode::Asleep);
        let fixed = slots.iter().filter(|slot| slot.mode == Mode::Fixed);
        let fixed = fixed.map(|slot| size(slot.body.velocity)).max().unwrap_or(0);
        // The velocity that a step adds.
        let more = size(gravity).saturating_add(fixed);
        let (mut idle, mut most) = (0_usize, 0);
        for handle in awake {
            let rest = rest_mut(memory, handle.slot());
            if let Some(rest) = rest.filter(|rest| rest.idle != Idle::No) {
                if !all && rest.made.causes.gravity == gravity {
                    idle += 1;
                    continue;
                }
                rest.idle = Idle::No;
            }
            if let Some(slot) = slots.get_mut(handle.slot()) {
                most = most.max(slot.goes_alone(*handle, more));
            }
        }
        // Each round disturbs one more body, or joins two companies, or is the last.
        let mut ends = idle == 0 || idle == awake.len();
        while !ends {
            ends = true;
            for &handle in awake {
                if is_idle(memory, handle.slot()) {
                    continue;
                }
                let company = usize::from(root(slots, handle.slot() as u16));
                let Some(far) = slots.get(company).map(|slot| slot.tally.hits) else { continue };
                let Some(slot) = slots.get_mut(handle.slot()).filter(|slot| slot.tally.under != far) else { continue };
                let (bounds, first) = (slot.body.shape.aabb(), slot.tally.under == 0);
                (slot.tally.under, ends) = (far, false);
                let (within, mut deep) = (around(&bounds, raw(far)), QUARTER);
                near.in_region(&around(&bounds, raw(far.saturating_add(most))), |other| {
                    let Some(it) = slots.get_mut(other.slot()).filter(|_| other != handle) else { return };
                    let box_ = it.body.shape.aabb();
                    deep = deep.max(overlap(&bounds, &box_));
                    if !it.is_awake() {
                        return;
                    }
                    if is_idle(memory, other.slot()) {
                        if !within.touches(&box_) {
                            return;
                        }
                        stop_idling(memory, other.slot());
                        it.goes_alone(other, more);
                    } else {
                        let theirs = usize::from(root(slots, other.slot() as u16));
                        let far_both = slots.get(theirs).map_or(0, |slot| slot.tally.hits).saturating_add(far);
                        if theirs == company || !around(&bounds, raw(far_both)).touches(&box_) {
                            return;
                        }
                    }
                    most = most.max(together(slots, handle, other));
                });
                if first && deep > QUARTER {
                    let company = root(slots, handle.slot() as u16);
                    if let Some(slot) = slots.get_mut(usize::from(company)) {
                        slot.tally.hits = slot.tally.hits.saturating_add(sixteenths(deep));
                        most = most.max(slot.tally.hits);
                    }
                }
            }
        }
    }

    /// A body without a mass appears: ends the idleness of the bodies that have it in their reach.
    /// Fast ones make another step then, even if it touches none of them.
    #[inline(never)]
    pub(super) fn stop_idling_around(&mut self, bounds: &Aabb) {
        let Self { slots, awake, count, memory, .. } = self;
        for handle in awake.get(..*count).unwrap_or_default() {
            let Some(slot) = slots.get(handle.slot()) else { continue };
            let far = reach_of(memory, slot, handle.slot());
            if around(&slot.body.shape.aabb(), far).touches(bounds) {
                stop_idling(memory, handle.slot());
            }
        }
    }

    /// After a step: bodies that it did not change, with all that they touch, become idle.
    #[inline(never)]
    pub(super) fn find_idle(&mut self, gravity: Vec2) {
        let Self { slots, awake, count, memory, .. } = self;
        let awake = awake.get(..*count).unwrap_or_default();
        let busy = |memory: &[Remembered; M], at: usize| !is_idle(memory, at);
        for handle in awake.iter().filter(|handle| busy(memory, handle.slot())) {
            if let Some(slot) = slots.get_mut(handle.slot()) {
                slot.tally.hits = 0;
            }
        }
        let repeats = |slots: &[Slot<S>], memory: &[Remembered; M], at: usize| {
            slots.get(at).zip(rest(memory, at)).map(|(slot, rest)| rest.repeats(slot, gravity))
        };
        for handle in awake.iter().filter(|handle| busy(memory, handle.slot())) {
            if repeats(slots, memory, handle.slot()).is_none_or(|idle| idle == Idle::No) {
                let root = root(slots, handle.slot() as u16);
                if let Some(slot) = slots.get_mut(usize::from(root)) {
                    slot.tally.hits = 1;
                }
            }
        }
        for handle in awake {
            if is_idle(memory, handle.slot()) {
                continue;
            }
            let root = root(slots, handle.slot() as u16);
            let together = slots.get(usize::from(root)).is_some_and(|slot| slot.tally.hits == 0);
            let found = repeats(slots, memory, handle.slot()).filter(|_| together);
            if let Some((rest, idle)) = rest_mut(memory, handle.slot()).zip(found) {
                rest.idle = idle;
            }
        }
    }
}

/// No two bodies at rest overlap by that much: a first guess.
const QUARTER: u32 = 1 << 14;

/// Raw units as 1/16 of a unit, rounded up. Saturates far beyond the domain.
fn sixteenths(raw: u32) -> u16 {
    u16::try_from((raw >> 12) + 1).unwrap_or(u16::MAX)
}

fn raw(sixteenths: u16) -> u32 {
    if sixteenths == u16::MAX { u32::MAX } else { u32::from(sixteenths) << 12 }
}

impl<S: BodyShape> Slot<S> {
    /// Begins a company of one. Returns how far it may move. Until the step begins, `hits` of the
    /// representative has that distance, and `under` of each how far a look has reached.
    fn goes_alone(&mut self, handle: Handle, more: u32) -> u16 {
        let far = size(self.body.velocity).saturating_add(more).saturating_mul(4).saturating_add(QUARTER);
        (self.tally.link, self.tally.hits, self.tally.under) = (handle.slot() as u16, sixteenths(far), 0);
        self.tally.hits
    }
}

/// Joins the companies of two bodies. Returns how far they may move.
fn together<S>(slots: &mut [Slot<S>], one: Handle, other: Handle) -> u16 {
    let (a, b) = (root(slots, one.slot() as u16), root(slots, other.slot() as u16));
    let far = |slots: &[Slot<S>], at: u16| slots.get(usize::from(at)).map_or(0, |slot| slot.tally.hits);
    let sum = if a == b { far(slots, a) } else { far(slots, a).saturating_add(far(slots, b)) };
    if let Some(slot) = slots.get_mut(usize::from(b)) {
        slot.tally.link = a;
    }
    if let Some(slot) = slots.get_mut(usize::from(a)) {
        slot.tally.hits = sum;
    }
    sum
}

/// The most that two boxes overlap, and so the shapes in them.
fn overlap(a: &Aabb, b: &Aabb) -> u32 {
    let Raw { x, y } = Raw::of(a.max().min(b.max())).sub(Raw::of(a.min().max(b.min())));
    x.min(y).max(0).unsigned_abs()
}

/// Makes the step of a body, if it is idle: its events. Returns whether it is.
pub(super) fn repeats<S>(
    slots: &mut [Slot<S>],
    memory: &[Remembered],
    handle: Handle,
    stepped: &mut Stepped,
    each: &mut dyn FnMut(SceneEvent<'_>),
) -> bool {
    let Some(rest) = idle(memory, handle.slot()) else { return false };
    let Some(slot) = slots.get_mut(handle.slot()) else { return true };
    stepped.moved += 1;
    slot.path.pace = Pace::Slow;
    slot.quiet = slot.quiet.saturating_add(u8::from(rest.idle == Idle::Counts));
    let (hits, flags) = (rest.made.hits(), rest.made.flags());
    if !hits.is_empty() {
        each(SceneEvent::Level { body: handle, hits: &hits, flags, velocity: rest.made.causes.velocity });
    }
    true
}
