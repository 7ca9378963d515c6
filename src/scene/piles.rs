//! Bodies that lie on others are carried from the ground up.
//!
//! Each such body is moved after all bodies below it. It is pushed out of bodies that are carried,
//! at their new positions. Its velocity meets that of the carrier of all. So support reaches the
//! whole pile within a step, and a pile on a moving carrier behaves as at rest.

use super::body::{ALOFT, Mode, Slot, UNSETTLED};
use super::body_path::{Drift, Pace, size};
use super::farthest_pushes::FarthestPushes;
use super::flush_boxes::{clears, is_slanted, rolls_on};
use super::idle::{is_idle, repeats};
use super::kept_out::Before;
use super::kernel::BodyShape;
use super::level_of_body::View;
use super::meeting_time::{around, may_meet, pair, senses};
use super::memory::{Remembered, keep, rest_mut};
use super::pressed::Pressed;
use super::reply::{Replies, Reply};
use super::through_level::{Trip, hold_in_place};
use super::velocities::{Meeting, Top, carried, part, toward};
use super::{Scene, SceneEvent, SceneFault, Stepped};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;
use crate::motion::Masses;
use crate::motion::response::separate;
use crate::num::{Axis, Raw, Vec2};
use crate::query::Contact;

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, const M: usize, S: BodyShape> Scene<B, N, M, S> {
    /// Moves the bodies that lie on others. Returns whether one has been quiet for long enough. A
    /// separate function: a scene without piles needs neither its registers nor its stack.
    #[inline(never)]
    pub(super) fn settle<V: View<S>>(
        &mut self,
        trip: &Trip<'_, V>,
        stepped: &mut Stepped,
        replies: &mut impl Replies,
        each: &mut dyn FnMut(SceneEvent<'_>),
    ) -> bool {
        let Self { near, slots, awake, count, memory, sleep } = self;
        let movers = awake.get_mut(..*count).unwrap_or_default();
        let mut lying = from_the_lowest(movers, 0, (slots, memory), trip.gravity);
        let mut pile = Pile { near, slots, memory, trip, stepped };
        let mut calm = false;
        let mut at = 0;
        while at < lying {
            let Some(&handle) = movers.get(at) else { break };
            at += 1;
            let repeats = repeats(pile.slots, pile.memory, handle, pile.stepped, each);
            if !repeats && pile.carry(handle, replies, each) {
                lying = from_the_lowest(movers, at, (pile.slots, pile.memory), trip.gravity);
            }
            calm |= pile.slots.get(handle.slot()).is_some_and(|slot| slot.quiet >= sleep.sleep().steps);
        }
        calm
    }
}

/// Moves the lying bodies to the front, starting at `from`: the lowest first, then by keys, then by
/// slots. Returns where they end.
///
/// Bodies that repeat their last step still have the order that this step gave them.
fn from_the_lowest<S: BodyShape, const M: usize>(
    movers: &mut [Handle],
    from: usize,
    (slots, memory): (&[Slot<S>], &[Remembered; M]),
    gravity: Vec2,
) -> usize {
    let slot = |handle: Option<&Handle>| handle.and_then(|handle| slots.get(handle.slot()));
    let rank = |handle: Option<&Handle>| {
        let found = slot(handle).zip(handle);
        found.map(|(slot, handle)| (slot.height(gravity), slot.body.key, handle.slot()))
    };
    let rests = |handle: Option<&Handle>| handle.is_some_and(|handle| is_idle(memory, handle.slot()));
    let mut lying = from;
    for at in from..movers.len() {
        if slot(movers.get(at)).is_none_or(|slot| !slot.path.lies()) {
            continue;
        }
        swap(movers, lying, at);
        // Almost no body changes its position in the list from step to step.
        let mut to = lying;
        while to > from {
            let (one, before) = (movers.get(to), movers.get(to - 1));
            if (rests(one) && rests(before)) || rank(one) >= rank(before) {
                break;
            }
            swap(movers, to - 1, to);
            to -= 1;
        }
        lying += 1;
    }
    lying
}

/// Exchanges two entries of a list, without a branch that could panic.
fn swap(movers: &mut [Handle], a: usize, b: usize) {
    if let Ok([a, b]) = movers.get_disjoint_mut([a, b]) {
        core::mem::swap(a, b);
    }
}

/// The carriers that a body overlaps.
struct MetCarriers {
    /// How many of them it runs into, one of these, and how both change their velocities.
    hits: u16,
    last: Option<(Handle, (Vec2, Vec2))>,
    /// The sum of the changes of its velocity, if each hit is one on the ground.
    kick: Vec2,
    /// Whether it meets a corner, and the way out of the sides that it meets.
    corner: bool,
    out: FarthestPushes,
}

struct Pile<'a, B, V, S, const M: usize> {
    near: &'a mut B,
    slots: &'a mut [Slot<S>],
    memory: &'a mut [Remembered; M],
    trip: &'a Trip<'a, V>,
    stepped: &'a mut Stepped,
}

impl<B: BroadPhase<Tag = Keyed<Filter>>, V: View<S>, S: BodyShape, const M: usize> Pile<'_, B, V, S, M> {
    /// One body's whole step. Returns whether others must be brought out of it, too.
    fn carry(&mut self, handle: Handle, replies: &mut impl Replies, each: &mut dyn FnMut(SceneEvent<'_>)) -> bool {
        let ground = ground_under(self.slots, handle);
        let Some(slot) = self.slots.get_mut(handle.slot()) else { return false };
        let known = slot.body.shape;
        let moved = slot.path.pace == Pace::Moved;
        let by = if moved { slot.path.rate } else { Vec2::ZERO };
        let (start, quiet) =
            (known.position() - by, if moved { slot.quiet_before(by) } else { slot.quiet_and_drift() });
        if !moved {
            let before = self.trip.fixed.map(|_| Before::of(slot));
            self.trip.make(slot, (handle, ground), self.memory, self.near, self.stepped, each);
            if let Some(before) = before {
                self.trip.keep_out((self.slots, self.near, self.memory), handle, &before, replies);
            }
            let Some(slot) = self.slots.get_mut(handle.slot()) else { return false };
            if slot.path.pace != Pace::Lies {
                return false;
            }
        }
        self.come_out(handle, known, (start, quiet), replies, each)
    }

    /// The part after its motion through the level, on a separate stack frame.
    #[inline(never)]
    fn come_out(
        &mut self,
        handle: Handle,
        known: S,
        before: (Vec2, (u8, Drift)),
        replies: &mut impl Replies,
        each: &mut dyn FnMut(SceneEvent<'_>),
    ) -> bool {
        let Some(slot) = self.slots.get(handle.slot()) else { return false };
        let mut slot = *slot;
        slot.tally.pushes = FarthestPushes::NONE;
        if let Err(fault) = self.leave_carriers(handle, &mut slot, before, replies) {
            slot.body.shape = known;
            keep(self.memory, handle.slot(), None);
            hold_in_place(&mut slot, handle, fault, self.stepped, each);
        }
        (slot.path.pace, slot.path.turns) = (Pace::Slow, 1);
        if let Some(place) = self.slots.get_mut(handle.slot()) {
            *place = slot;
        }
        size(slot.tally.push()) > size(self.trip.gravity).saturating_mul(2)
            && self.mark_pushed_on_top(handle, &slot, replies)
    }

    /// Finds the bodies on top that have made their steps and lay on nobody, if a body was pushed
    /// into them. Returns whether there are any.
    fn mark_pushed_on_top(&mut self, handle: Handle, lower: &Slot<S>, replies: &mut impl Replies) -> bool {
        let Self { near, slots, trip, .. } = self;
        let mut any = false;
        near.in_region(&lower.body.shape.aabb(), |other| {
            let Some(slot) = slots.get_mut(other.slot()).filter(|slot| slot.path.turns == 0) else { return };
            let slow = slot.is_awake() && slot.path.pace == Pace::Slow;
            let on_top = slow && slot.lies_on(lower, trip.gravity) && may_meet(slot, lower);
            if on_top && !senses(slot, lower) && replies.to(pair((handle, lower), (other, slot))).acts() {
                (slot.path.pace, any) = (Pace::Moved, true);
            }
        });
        any
    }

    /// Pushes a body out of its carriers after its motion.
    #[inline(never)]
    fn leave_carriers(
        &mut self,
        handle: Handle,
        slot: &mut Slot<S>,
        before: (Vec2, (u8, Drift)),
        replies: &mut impl Replies,
    ) -> Result<(), SceneFault> {
        let gravity = self.trip.gravity;
        let it = *slot;
        let mut met = self.meet_carriers((handle, &it), slot, FarthestPushes::NONE, replies);
        if met.corner && met.out != FarthestPushes::NONE {
            slot.tally.pushes = FarthestPushes::NONE;
            met = self.meet_carriers((handle, &it), slot, met.out, replies);
        }
        let MetCarriers { hits, last, kick, .. } = met;
        let lies = slot.support != ALOFT;
        let mut by = part(kick, 1, hits.into());
        if let (1, Some((other, kicks))) = (hits, last) {
            by = kicks.1;
            if let Some(lower) = self.slots.get_mut(other.slot()) {
                lower.body.velocity += kicks.0;
            }
        }
        slot.body.velocity += by;
        let mut push = slot.tally.push();
        if push != Vec2::ZERO {
            if let Some(rest) = rest_mut(self.memory, handle.slot()) {
                rest.stays = false;
            }
            if let Some(cut) = self.trip.cut(self.slots, self.near, (handle, slot), (&slot.body.shape, push), replies) {
                (push, slot.body.velocity) = cut;
            }
            slot.body.shape = self.trip.slide(handle, &slot.body, push)?;
            let pressed = Pressed::of(slot, slot.ground_velocity(self.slots));
            slot.body.velocity = pressed.left(slot.body.velocity, gravity, false);
        }
        let bounds = slot.body.shape.aabb();
        if self.near.bounds(handle).is_ok_and(|known| known != bounds) {
            self.near.move_to(handle, &bounds)?;
        }
        let (start, quiet) = before;
        slot.path.rate = slot.body.shape.position() - start;
        if lies {
            (slot.quiet, slot.tally.drift) = quiet;
            self.trip.arrive(slot, slot.path.rate, slot.support, false);
        }
        Ok(())
    }

    /// Pushes a body out of its carriers, and finds how those that it runs into change velocities.
    /// Corners that `out` [leads out of](clears) do not count.
    #[inline(never)]
    fn meet_carriers(
        &self,
        (handle, it): (Handle, &Slot<S>),
        slot: &mut Slot<S>,
        out: FarthestPushes,
        replies: &mut impl Replies,
    ) -> MetCarriers {
        let gravity = self.trip.gravity;
        let mut met = MetCarriers { hits: 0, last: None, kick: Vec2::ZERO, corner: false, out: FarthestPushes::NONE };
        self.below((handle, it), out, replies, |other, lower, (contact, reply)| {
            let (_, by) = separate(contact, Masses::A_FIXED.share_of_a());
            if rolls_on(it, lower) {
                if is_slanted(contact.axis()) {
                    met.corner = true;
                } else {
                    met.out.add(by);
                }
            }
            slot.tally.pushes.add(still_touching(by, contact.axis()));
            slot.lie_on(self.slots, lower, other);
            let of = (contact.axis(), reply);
            let meeting = Meeting::of_pile(self.slots, lower, it, of, gravity).filter(Meeting::is_hit);
            if let Some(meeting) = meeting {
                let kicks = meeting.kicks(1);
                (met.hits, met.last) = (met.hits + 1, Some((other, kicks)));
                let onto = || Meeting::onto(self.slots, lower, it, of, gravity).kicks(1).1;
                met.kick += if meeting.moves_a { onto() } else { kicks.1 };
            }
        });
        met
    }

    /// The carriers of a body that it overlaps at their new positions, without the corners that
    /// `out` leads out of.
    fn below(
        &self,
        upper: (Handle, &Slot<S>),
        out: FarthestPushes,
        replies: &mut impl Replies,
        mut each: impl FnMut(Handle, &Slot<S>, (&Contact, Reply)),
    ) {
        let (handle, slot) = upper;
        let gravity = self.trip.gravity;
        let mut ask = |other: Handle, lower: &Slot<S>| {
            let carries = other != handle && !lower.path.lies() && lower.support != ALOFT && may_meet(slot, lower);
            if !carries || senses(slot, lower) {
                return;
            }
            let shape = lower.comes_to(gravity);
            let Some(contact) = shape.contact(&slot.body.shape) else { return };
            if rolls_on(slot, lower) && is_slanted(contact.axis()) && clears(out, &slot.body.shape, &shape) {
                return;
            }
            if Top::of(contact.axis(), toward(gravity)) == Top::B {
                let reply = replies.to(pair(upper, (other, lower)));
                if reply.acts() {
                    each(other, lower, (&contact, reply));
                }
            }
        };
        // The step finds other bodies there when they are touched. Otherwise a ball that rolls
        // between the two would never rest.
        let rolls = slot.body.shape.is_round() || slot.path.pace == Pace::Moved;
        let only = self.slots.get(usize::from(slot.tally.under)).filter(|_| !rolls);
        if let Some(lower) = only {
            return ask(Handle::new(slot.tally.under.into(), lower.generation), lower);
        }
        self.near.in_region(&around(&slot.body.shape.aabb(), self.trip.fixed.unwrap_or(0)), |other| {
            if let Some(lower) = self.slots.get(other.slot()) {
                ask(other, lower);
            }
        });
    }
}

impl<S: BodyShape> Slot<S> {
    /// For how many steps it has been quiet, and how far it has moved since.
    const fn quiet_and_drift(&self) -> (u8, Drift) {
        (self.quiet, self.tally.drift)
    }

    /// The values of [`quiet_and_drift`](Self::quiet_and_drift) before its motion in this step. Its
    /// rest ended if it has none now.
    fn quiet_before(&self, by: Vec2) -> (u8, Drift) {
        let counted = u8::from(self.tally.under != UNSETTLED);
        if self.quiet == 0 { (0, Drift::NONE) } else { (self.quiet - counted, self.tally.drift.minus(by)) }
    }

    /// In any unit: twice the middle of its box, against gravity.
    pub(super) fn height(&self, gravity: Vec2) -> i64 {
        let bounds = self.body.shape.aabb();
        bounds.lo().add(bounds.hi()).dot(Raw::of(gravity)).wrapping_neg()
    }

    /// How the game moves a fixed body along gravity after the step. Across gravity it may be a
    /// conveyor.
    pub(super) fn lift(&self, gravity: Vec2) -> Vec2 {
        let ((x, y), v) = (gravity.raw(), self.body.velocity);
        match (self.mode == Mode::Fixed, x == 0, y == 0) {
            (true, true, false) => Vec2::from_raw(0, v.raw().1),
            (true, false, true) => Vec2::from_raw(v.raw().0, 0),
            _ => Vec2::ZERO,
        }
    }

    /// Its shape at the step's end.
    pub(super) fn comes_to(&self, gravity: Vec2) -> S {
        let (shape, by) = (self.body.shape, self.lift(gravity));
        shape.translated(by).unwrap_or(shape)
    }

    /// Another body carries it, and so does that body's carrier. If there are several, it takes the
    /// one with the fewest between, then the one on the ground with the smallest key.
    pub(super) fn lie_on(&mut self, slots: &[Self], lower: &Self, at: Handle) {
        let key = |ground: u16| slots.get(usize::from(ground)).map_or(0, |slot| slot.body.key);
        let ground = if lower.mode == Mode::Fixed { at.slot() as u16 } else { lower.ground };
        let support = carried(lower.support);
        if (support, key(ground)) < (self.support, key(self.ground)) {
            (self.support, self.ground) = (support, ground);
        }
    }

    /// Whether it settles on another body, or moves with it. Otherwise it yields to bodies that it
    /// overlaps, like those that the level carries.
    pub(super) fn lies_on(&self, lower: &Self, gravity: Vec2) -> bool {
        self.body.mass.is_some() && self.support != 0 && self.height(gravity) > lower.height(gravity)
    }

    /// The velocity of the body that carries all below it.
    pub(super) fn ground_velocity(&self, slots: &[Self]) -> Vec2 {
        if self.mode == Mode::Fixed {
            return self.body.velocity;
        }
        let ground = slots.get(usize::from(self.ground)).filter(|slot| slot.mode == Mode::Fixed);
        ground.map_or(Vec2::ZERO, |slot| slot.body.velocity)
    }
}

/// The velocity of the body that carries one and all below it.
#[inline]
pub(super) fn ground_under<S: BodyShape>(slots: &[Slot<S>], handle: Handle) -> Vec2 {
    slots.get(handle.slot()).map_or(Vec2::ZERO, |slot| slot.ground_velocity(slots))
}

/// A push that leaves oblique bodies overlapping by at most a raw unit. A push rounded outward
/// would part bodies that stay in contact.
fn still_touching(push: Vec2, axis: Axis) -> Vec2 {
    if axis.x == 0 || axis.y == 0 {
        return push;
    }
    let (x, y) = push.raw();
    Vec2::from_raw(x - x.signum(), y - y.signum())
}
