//! Bodies of a scene that remembers, and repeat their last step.
//!
//! If a step leaves a body as it found it, and all bodies that it touches too, then the next step
//! does the same: it starts from the same state. So these bodies make no step. Their events are
//! those of the last one.
//!
//! This holds as long as nobody else comes near. A body that is not idle goes no farther in a step
//! than [`disturb`](Scene::disturb) allows for. All within that make their steps in full.

use super::body::{Mode, Slot};
use super::kernel::BodyShape;
use super::met::{around, reach};
use super::pairs::root;
use super::rest::{Idle, Rest};
use super::way::size;
use super::{Scene, SceneEvent, Stepped};
use crate::broad::{BroadPhase, Handle, Keyed, Pair};
use crate::filter::Filter;
use crate::num::{Raw, Vec2};
use crate::shape::Aabb;

impl Rest {
    /// Whether the step left a body as it was.
    fn repeats<S: BodyShape>(&self, slot: &Slot<S>, gravity: Vec2) -> Idle {
        let before = self.causes.velocity - self.causes.weight - slot.tally.kick;
        let as_it_was = slot.mode == Mode::Awake
            && slot.way.rate == Vec2::ZERO
            && slot.body.velocity == before
            // Its weight says under which gravity.
            && !slot.body.floats
            && self.causes.weight == gravity
            && (slot.support, slot.ground, slot.tally.drift) == (self.start.support, self.start.ground, self.start.drift);
        match (as_it_was, self.start.quiet.saturating_add(1) == slot.quiet, self.start.quiet == slot.quiet) {
            (true, true, _) => Idle::Counts,
            (true, false, true) => Idle::Never,
            _ => Idle::No,
        }
    }
}

/// Whether the body in a slot makes no step.
pub(super) fn is_idle(rests: &[Option<Rest>], at: usize) -> bool {
    idle(rests, at).is_some()
}

/// Has the body in a slot make its next step in full. Returns whether it was idle.
pub(super) fn stir(rests: &mut [Option<Rest>], at: usize) -> bool {
    let Some(Some(rest)) = rests.get_mut(at) else { return false };
    core::mem::replace(&mut rest.idle, Idle::No) != Idle::No
}

pub(super) fn idle(rests: &[Option<Rest>], at: usize) -> Option<&Rest> {
    rests.get(at)?.as_ref().filter(|rest| rest.idle != Idle::No)
}

/// Whether nothing changes between two bodies.
pub(super) fn are_idle<S>(rests: &[Option<Rest>], slots: &[Slot<S>], pair: Pair) -> bool {
    let fixed = |at: Handle| slots.get(at.slot()).is_some_and(|slot| slot.mode == Mode::Fixed);
    let [a, b] = [pair.a, pair.b].map(|at| is_idle(rests, at.slot()));
    (a && (b || fixed(pair.b))) || (b && fixed(pair.a))
}

/// How far from its box a body may come in this step: [`reach`], as it was when an idle body made
/// its last step.
pub(super) fn reach_of<S: BodyShape>(rests: &[Option<Rest>], slot: &Slot<S>, at: usize) -> u32 {
    idle(rests, at)
        .map_or_else(|| reach(slot), |rest| size(rest.causes.velocity).saturating_add(size(rest.causes.push)))
}

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, const M: usize, S: BodyShape> Scene<B, N, M, S> {
    /// Before a step: bodies that another one may reach are not idle.
    ///
    /// A hit changes a velocity by at most twice the difference of the two, and a push is at most
    /// an overlap. In a pile one body may push the next. So in a step none goes farther than the
    /// sum, over all that make one, of four times the velocity and of the overlap.
    #[inline(never)]
    pub(super) fn disturb(&mut self, gravity: Vec2) {
        let Self { near, slots, awake, count, rests, .. } = self;
        let awake = awake.get(..*count).unwrap_or_default();
        // A body that sleeps may wake in this step, and move.
        let all = slots.iter().any(|slot| slot.mode == Mode::Asleep);
        let mut idle = 0_usize;
        for handle in awake {
            let Some(Some(rest)) = rests.get_mut(handle.slot()) else { continue };
            if all || rest.causes.weight != gravity {
                rest.idle = Idle::No;
            }
            idle += usize::from(rest.idle != Idle::No);
        }
        let fixed = slots.iter().filter(|slot| slot.mode == Mode::Fixed);
        let fixed = fixed.map(|slot| size(slot.body.velocity)).max().unwrap_or(0);
        // What a step adds to a velocity, and the largest overlap known so far.
        let (more, mut deep) = (size(gravity).saturating_add(fixed), QUARTER);
        // Each round disturbs one more, or finds a larger overlap, or is the last.
        while 0 < idle && idle < awake.len() {
            let moving = awake.iter().filter(|handle| !is_idle(rests, handle.slot()));
            let moving = moving.filter_map(|handle| slots.get(handle.slot()));
            let way = |slot: &Slot<S>| size(slot.body.velocity).saturating_add(more).saturating_mul(4);
            let far = moving.fold(0, |far: u32, slot| far.saturating_add(way(slot)).saturating_add(deep));
            let known = (idle, deep);
            for &handle in awake {
                let Some(slot) = slots.get(handle.slot()).filter(|_| !is_idle(rests, handle.slot())) else { continue };
                let bounds = slot.body.shape.aabb();
                near.in_region(&around(&bounds, far), |other| {
                    idle -= usize::from(stir(rests, other.slot()));
                    let other = slots.get(other.slot()).filter(|_| other != handle);
                    deep = deep.max(other.map_or(0, |other| overlap(&bounds, &other.body.shape.aabb())));
                });
            }
            if known == (idle, deep) {
                break;
            }
        }
    }

    /// After a step: bodies that it left as they were, with all that they touch, are idle.
    #[inline(never)]
    pub(super) fn find_idle(&mut self, gravity: Vec2) {
        let Self { slots, awake, count, rests, .. } = self;
        let awake = awake.get(..*count).unwrap_or_default();
        let busy = |rests: &[Option<Rest>; M], at: usize| !is_idle(rests, at);
        for handle in awake.iter().filter(|handle| busy(rests, handle.slot())) {
            if let Some(slot) = slots.get_mut(handle.slot()) {
                slot.tally.hits = 0;
            }
        }
        let repeats = |slots: &[Slot<S>], rests: &[Option<Rest>; M], at: usize| {
            slots.get(at).zip(rests.get(at)?.as_ref()).map(|(slot, rest)| rest.repeats(slot, gravity))
        };
        for handle in awake.iter().filter(|handle| busy(rests, handle.slot())) {
            if repeats(slots, rests, handle.slot()).is_none_or(|idle| idle == Idle::No) {
                let root = root(slots, handle.slot() as u16);
                if let Some(slot) = slots.get_mut(usize::from(root)) {
                    slot.tally.hits = 1;
                }
            }
        }
        for handle in awake {
            if is_idle(rests, handle.slot()) {
                continue;
            }
            let root = root(slots, handle.slot() as u16);
            let together = slots.get(usize::from(root)).is_some_and(|slot| slot.tally.hits == 0);
            let found = repeats(slots, rests, handle.slot()).filter(|_| together);
            if let Some((Some(rest), idle)) = rests.get_mut(handle.slot()).map(Option::as_mut).zip(found) {
                rest.idle = idle;
            }
        }
    }
}

/// No two bodies at rest overlap by that much: a first guess.
const QUARTER: u32 = 1 << 14;

/// How deep two boxes overlap at most, and with them the shapes in them.
fn overlap(a: &Aabb, b: &Aabb) -> u32 {
    let Raw { x, y } = Raw::of(a.max().min(b.max())).sub(Raw::of(a.min().max(b.min())));
    x.min(y).max(0).unsigned_abs()
}

/// The step of an idle body: its events.
pub(super) fn repeat<S>(
    slot: &mut Slot<S>,
    handle: Handle,
    rest: &Rest,
    stepped: &mut Stepped,
    each: &mut impl FnMut(SceneEvent<'_>),
) {
    stepped.moved += 1;
    slot.quiet = slot.quiet.saturating_add(u8::from(rest.idle == Idle::Counts));
    let (hits, flags) = (rest.hits(), rest.flags());
    if !hits.is_empty() {
        each(SceneEvent::Level { body: handle, hits: &hits, flags, velocity: rest.causes.velocity });
    }
}
