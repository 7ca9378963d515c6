//! The motion of one body through the level.

use super::blocked_sides::blocked_sides;
use super::body::{ALOFT, Mode, NOBODY, Slot, Tally, UNSETTLED};
use super::body_path::{BodyPath, Drift, Pace, size};
use super::farthest_pushes::FarthestPushes;
use super::flush_boxes::is_slanted;
use super::kernel::{BodyShape, Visit};
use super::level_of_body::{Sliding, View, sliding};
use super::meeting_time::{may_meet, senses};
use super::memory::{Causes, Made, Remembered, Rest, Start, keep, known, note, rest_mut};
use super::pressed::Pressed;
use super::resting::{down, holds_up};
use super::velocities::toward;
use super::{SceneBody, SceneEvent, SceneFault, Sleep, Stepped};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;
use crate::motion::{Body, Hit, Moved, Mover, Response, Surface};
use crate::num::{Ratio, Raw, Vec2};
use crate::world::World;

/// The data that all motions through the level share.
pub(super) struct Trip<'a, V> {
    view: &'a V,
    mover: Sliding,
    pub(super) gravity: Vec2,
    /// How far a fixed body may be from its position in the broad phase, if there are any.
    pub(super) fixed: Option<u32>,
    sleep: Sleep,
    /// The first place in the memory for short motions.
    paths: usize,
}

impl<'a, V> Trip<'a, V> {
    pub(super) fn new(view: &'a V, gravity: Vec2, fixed: Option<u32>, sleep: Sleep, paths: usize) -> Self {
        let mover = sliding(Mover::platformer(toward(gravity).reversed()));
        Self { view, mover, gravity, fixed, sleep, paths }
    }
}

/// The part of a trip that depends on the type of the shape.
struct Travel<'t, 'a, V, S, N> {
    trip: &'t Trip<'a, V>,
    slot: &'t mut Slot<S>,
    at: (Handle, Causes),
    memory: &'t mut [Remembered],
    near: &'t mut N,
    each: &'t mut dyn FnMut(SceneEvent<'_>),
}

impl<V, S, N> Visit<S> for Travel<'_, '_, V, S, N>
where
    V: View<S>,
    S: BodyShape,
    N: BroadPhase,
{
    type Out = Result<(), SceneFault>;
    #[inline]
    fn of<B: Body + Into<S>>(self, body: &B) -> Self::Out {
        self.trip.travel(self.slot, self.at, body, self.memory, self.near, self.each)
    }
}

/// A motion, and its first hit.
struct ToFirstHit<'t, W>(&'t Sliding, &'t W, Vec2);

impl<S, W: World> Visit<S> for ToFirstHit<'_, W> {
    type Out = Result<Touched<S>, SceneFault>;
    #[inline]
    fn of<B: Body + Into<S>>(self, body: &B) -> Self::Out {
        let Self(mover, level, by) = self;
        Ok(Touched::of(&mover.move_and_slide(level, body, by)?))
    }
}

/// A motion as far as the level allows.
struct Slide<'t, 'a, V, S>(&'t Trip<'a, V>, (Handle, &'t SceneBody<S>), Vec2);

impl<S, V: View<S>> Visit<S> for Slide<'_, '_, V, S> {
    type Out = Result<S, SceneFault>;
    #[inline]
    fn of<B: Body + Into<S>>(self, from: &B) -> Self::Out {
        let Self(trip, body, by) = self;
        Ok(trip.view.go(&trip.mover, body, from, by)?.body.into())
    }
}

/// The displacement of a body's own motion, and its velocity then. The body does not make that
/// motion.
struct OwnMotion<'t, 'a, V, S>(&'t Trip<'a, V>, &'t SceneBody<S>, Vec2);

impl<S: BodyShape, V: View<S>> Visit<S> for OwnMotion<'_, '_, V, S> {
    type Out = Result<(Vec2, Vec2), SceneFault>;
    #[inline]
    fn of<B: Body + Into<S>>(self, from: &B) -> Self::Out {
        let Self(trip, body, by) = self;
        let moved = trip.bouncing(body).move_and_slide(trip.view.level(body), from, by)?;
        Ok((moved.position() - from.position(), moved.velocity))
    }
}

impl<V> Trip<'_, V> {
    /// The mover of a body's own motion.
    fn bouncing<S: BodyShape>(&self, body: &SceneBody<S>) -> Sliding {
        let mover = self.mover.with_response(Response::Bounce).only_with(self.surface(body));
        mover.with_responses(body.responses)
    }

    /// One body's whole step, on ground of this velocity.
    pub(super) fn make<S: BodyShape>(
        &self,
        slot: &mut Slot<S>,
        (handle, ground): (Handle, Vec2),
        memory: &mut [Remembered],
        near: &mut impl BroadPhase,
        stepped: &mut Stepped,
        each: &mut dyn FnMut(SceneEvent<'_>),
    ) where
        V: View<S>,
    {
        stepped.moved += 1;
        let (shape, at, causes) = (slot.body.shape, handle.slot(), self.causes(slot, ground));
        let made = if memory.is_empty() {
            None
        } else if let Some(rest) = rest_mut(memory, at).filter(|rest| rest.stays && rest.made.causes == causes) {
            rest.start = Start::of(slot);
            Some((Vec2::ZERO, rest.made))
        } else {
            let paths = memory.get_mut(self.paths..).unwrap_or_default();
            let found = known(paths, at, shape.position(), &causes);
            if let Some((by, made)) = &found {
                keep(memory, at, Some(Rest::of(made, Start::of(slot), *by)));
            }
            found
        };
        let done = match made {
            Some((by, made)) => self.repeat(slot, handle, (by, &made), near, each),
            None => shape.visit(Travel { trip: self, slot, at: (handle, causes), memory, near, each }),
        };
        if let Err(fault) = done {
            keep(memory, at, None);
            hold_in_place(slot, handle, fault, stepped, each);
        }
    }

    /// The causes of a body's motion in this step.
    fn causes<S: BodyShape>(&self, slot: &Slot<S>, ground: Vec2) -> Causes {
        let velocity = slot.body.velocity + slot.tally.kick;
        Causes { pressed: Pressed::of(slot, ground), velocity, gravity: self.gravity }
    }

    /// The remembered motion that [`travel`](Self::travel) would make.
    #[inline(never)]
    fn repeat<S: BodyShape>(
        &self,
        slot: &mut Slot<S>,
        handle: Handle,
        (by, made): (Vec2, &Made),
        near: &mut impl BroadPhase,
        each: &mut dyn FnMut(SceneEvent<'_>),
    ) -> Result<(), SceneFault> {
        go(slot, handle, by, near)?;
        slot.body.velocity = made.velocity;
        slot.block(made.blocked, by);
        let (hits, flags) = (made.hits(), made.flags());
        self.arrive(slot, by, if made.floor { 0 } else { ALOFT }, hits.is_empty());
        if !hits.is_empty() {
            each(SceneEvent::Level { body: handle, hits: &hits, flags, velocity: made.causes.velocity });
        }
        Ok(())
    }

    /// Whether the level holds a slow body at its position.
    #[inline(never)]
    pub(super) fn stays<S: BodyShape>(&self, slot: &Slot<S>) -> bool
    where
        V: View<S>,
    {
        let (shape, Causes { pressed, velocity, .. }) = (&slot.body.shape, self.causes(slot, Vec2::ZERO));
        // The look costs as much as the step. So only a body that nothing pushes, and that is no
        // faster than two steps of gravity, is looked at.
        if pressed.push() != Vec2::ZERO || size(velocity) > size(self.gravity).saturating_mul(2) {
            return false;
        }
        let (mover, level) = (self.bouncing(&slot.body), self.view.level(&slot.body));
        let made = shape.visit(ToFirstHit(&mover, level, velocity));
        made.is_ok_and(|made: Touched<S>| made.shape.position() == shape.position())
    }

    /// First moves by the push, along the level, then by the velocity.
    fn travel<S: BodyShape, B: Body + Into<S>>(
        &self,
        slot: &mut Slot<S>,
        (handle, causes): (Handle, Causes),
        body: &B,
        memory: &mut [Remembered],
        near: &mut impl BroadPhase,
        each: &mut dyn FnMut(SceneEvent<'_>),
    ) -> Result<(), SceneFault>
    where
        V: View<S>,
    {
        let (mut start, mut blocked, start_of) = (*body, 0, Start::of(slot));
        let Causes { pressed, velocity, .. } = causes;
        let push = pressed.push();
        if push != Vec2::ZERO {
            start = self.view.go(&self.mover, (handle, &slot.body), body, push)?.body;
            blocked = blocked_sides(push, start.position() - body.position());
        }
        let result = self.view.go(&self.bouncing(&slot.body), (handle, &slot.body), &start, velocity);
        // Matched by reference: it is long.
        let moved = match &result {
            Ok(moved) => moved,
            Err(error) => return Err((*error).into()),
        };
        let by = moved.position() - body.position();
        go(slot, handle, by, near)?;
        slot.block(blocked, by);
        let slanted = moved.hits.first().is_some_and(|hit| is_slanted(hit.axis));
        let left = pressed.left(moved.velocity, self.gravity, slanted);
        if !memory.is_empty() {
            let (at, made) = (handle.slot(), Made::of(causes, moved, (left, blocked)));
            keep(memory, at, made.as_ref().map(|made| Rest::of(made, start_of, by)));
            if let Some((paths, made)) = memory.get_mut(self.paths..).zip(made.as_ref()) {
                note(paths, at, body.position(), by, made);
            }
        }
        slot.body.velocity = left;
        self.arrive(slot, by, if moved.floor { 0 } else { ALOFT }, moved.hits.is_empty());
        if !moved.hits.is_empty() {
            each(SceneEvent::Level { body: handle, hits: &moved.hits, flags: moved.flags, velocity });
        }
        Ok(())
    }

    /// Moves up to the first hit.
    pub(super) fn touch<S: BodyShape>(&self, body: &SceneBody<S>, by: Vec2) -> Result<Touched<S>, SceneFault>
    where
        V: View<S>,
    {
        let (mover, level) = (self.mover.with_response(Response::Touch), self.view.level(body));
        body.shape.visit(ToFirstHit(&mover, level, by))
    }

    /// The displacement that the body's own motion would make, and its velocity then.
    pub(super) fn bend<S: BodyShape>(&self, body: &SceneBody<S>, by: Vec2) -> Result<(Vec2, Vec2), SceneFault>
    where
        V: View<S>,
    {
        body.shape.visit(OwnMotion(self, body, by))
    }

    /// Moves as far as the level allows.
    pub(super) fn slide<S: BodyShape>(&self, handle: Handle, body: &SceneBody<S>, by: Vec2) -> Result<S, SceneFault>
    where
        V: View<S>,
    {
        body.shape.visit(Slide(self, (handle, body), by))
    }

    /// Whether a body that gravity moves would run into the level or another body at once.
    #[inline(never)]
    pub(super) fn is_held_up<S: BodyShape>(
        &self,
        slots: &[Slot<S>],
        near: &impl BroadPhase<Tag = Keyed<Filter>>,
        handle: Handle,
    ) -> bool
    where
        V: View<S>,
    {
        let Some(slot) = slots.get(handle.slot()) else { return true };
        let weight = slot.body.weight(self.gravity);
        if weight == Vec2::ZERO || slot.path.is_held() {
            return true;
        }
        let down = down(weight);
        // A body in the solid is held, too.
        if self.touch(&slot.body, down).map_or(true, |touched| touched.hit.is_some()) {
            return true;
        }
        let (lower, mut held) = (slot.body.shape.shifted(down), false);
        near.in_region(&lower.aabb(), |other| {
            let Some(it) = slots.get(other.slot()).filter(|_| other != handle) else { return };
            held |= !senses(slot, it) && may_meet(slot, it) && holds_up(&it.body.shape, &lower, weight);
        });
        held
    }

    /// A body has made a straight path.
    pub(super) fn report_path<S: BodyShape>(&self, handle: Handle, from: &S, to: &S)
    where
        V: View<S>,
    {
        self.view.report_path(handle, from, to.position() - from.position());
    }

    /// The surface that the level has for a body.
    fn surface<S: BodyShape>(&self, body: &SceneBody<S>) -> Surface {
        body.surface.resting_under(body.weight(self.gravity))
    }

    /// The velocity of a body after a hit of the level, and whether that is a slide.
    pub(super) fn after<S: BodyShape>(&self, body: &SceneBody<S>, hit: &Hit) -> (Vec2, bool) {
        let mut surface = self.surface(body);
        match body.responses.response_to(hit.flags) {
            Some(Response::Touch) => return (Vec2::ZERO, false),
            Some(Response::Slide) => surface = Surface::new(Ratio::ZERO, surface.friction()),
            _ => {}
        }
        let slides = surface.stops(Raw::of(body.velocity), hit.axis);
        (surface.respond(body.velocity, hit.axis).unwrap_or(Vec2::ZERO), slides)
    }

    /// Updates a body that has come this far.
    pub(super) fn arrive<S: BodyShape>(&self, slot: &mut Slot<S>, by: Vec2, support: u8, free: bool) {
        // In a heap, weight makes bodies push each other in every step. Without weight, a push
        // ends, or there is no room and nothing moves.
        let weight = slot.body.weight(self.gravity);
        let moves = (by, slot.body.velocity) != (Vec2::ZERO, Vec2::ZERO);
        let pressed = moves && weight == Vec2::ZERO && size(slot.tally.push()) > self.still();
        let is_still = self.is_still(slot, by) && !pressed;
        // A slow body that nothing holds is at the start or the top of a flight. If it fell asleep
        // there, it would stay in the air, where nothing wakes it. In a heap it also hops now and
        // then for a step. Such a step is not one of rest, but does not end a rest. A bounce does.
        let Tally { pushes, under, .. } = slot.tally;
        // Gravity comes before a body wakes, so one that has not moved since runs into nothing.
        let lies_on = slot.mode == Mode::Woken && by == Vec2::ZERO && slot.support != ALOFT;
        let support = if lies_on { slot.support } else { support };
        let held = !free || lies_on || pushes != FarthestPushes::NONE || !matches!(under, NOBODY | UNSETTLED);
        let flies = weight != Vec2::ZERO && !held;
        if matches!(under, NOBODY | UNSETTLED) {
            slot.tally.under = if flies { UNSETTLED } else { NOBODY };
        }
        // A ball that two others hold rises at one by less than gravity, falls back to the other,
        // and so on for ever.
        let rises = self.gravity.dot(slot.body.velocity) < 0 && size(slot.body.velocity) > size(self.gravity);
        if !is_still || (rises && !slot.body.floats) {
            (slot.quiet, slot.tally.drift) = (0, Drift::NONE);
        } else if !flies {
            slot.quiet = slot.quiet.saturating_add(1);
        }
        slot.support = support;
        if support == 0 || support == ALOFT {
            slot.ground = NOBODY;
        }
    }

    /// Raw units per step below which a body has hardly moved.
    fn still(&self) -> u32 {
        self.sleep.still.to_bits().max(0).unsigned_abs()
    }

    /// Whether it has hardly moved: in this step, or on the whole since it has been quiet. In a
    /// heap, bodies that push each other to and fro would otherwise do so for ever. A body that is
    /// slow enough to fall asleep may move as far in all its steps of rest.
    fn is_still<S>(&self, slot: &mut Slot<S>, by: Vec2) -> bool {
        let (x, y) = by.raw();
        let (still, Sleep { steps, .. }) = (self.still(), self.sleep);
        let far = still.saturating_mul(steps.into()).max(size(self.gravity).saturating_mul(2));
        slot.tally.drift = slot.tally.drift.plus(by);
        // Between two walls a fast body may end each step where it began.
        let flies = size(slot.body.velocity) > far;
        !flies && (x.unsigned_abs().max(y.unsigned_abs()) < still || (still > 0 && slot.tally.drift.is_within(far)))
    }
}

/// Moves a body along its path, as far as the level allows.
fn go<S: BodyShape>(
    slot: &mut Slot<S>,
    handle: Handle,
    by: Vec2,
    near: &mut impl BroadPhase,
) -> Result<(), SceneFault> {
    if by != Vec2::ZERO {
        let shape = slot.body.shape.shifted(by);
        if slot.path.pace != Pace::Lies {
            near.move_to(handle, &shape.aabb())?;
        }
        slot.body.shape = shape;
    }
    slot.path.rate = by;
    Ok(())
}

/// A body at the end of a motion, or at the level.
pub(super) struct Touched<S> {
    pub(super) shape: S,
    pub(super) hit: Option<Hit>,
    pub(super) floor: bool,
    pub(super) flags: u8,
}

impl<S> Touched<S> {
    fn of<B: Body + Into<S>>(moved: &Moved<B>) -> Self {
        Self { shape: moved.body.into(), hit: moved.hits.first(), floor: moved.floor, flags: moved.flags }
    }
}

/// A body that cannot be moved stays.
pub(super) fn hold_in_place<S>(
    slot: &mut Slot<S>,
    handle: Handle,
    fault: SceneFault,
    stepped: &mut Stepped,
    each: &mut dyn FnMut(SceneEvent<'_>),
) {
    slot.body.velocity = Vec2::ZERO;
    (slot.support, slot.quiet) = (ALOFT, slot.quiet.saturating_add(1));
    slot.path = BodyPath { turns: BodyPath::HELD, ..BodyPath::REST };
    stepped.held += 1;
    each(SceneEvent::Held { body: handle, fault });
}
