//! Which bodies rest on each other without touching.
//!
//! A fast body stops where it meets another one, rounded back by less than a raw unit. There it
//! rests. A body that moves after those below it, on a slanted or round one, rests likewise.

use super::body::{Slot, UNSETTLED};
use super::kernel::BodyShape;
use super::meeting_time::{around, may_meet, pair, senses};
use super::pairs::join;
use super::reply::{Replies, Reply};
use super::velocities::toward;
use crate::broad::{BroadPhase, Handle};
use crate::num::{Fx, Toi, Vec2};

/// The most that the support of a sleeping body is below it, as in
/// [`Mover::supported`](crate::Mover::supported).
pub(super) const NEAR: Fx = Fx::from_bits(8);

/// The displacement down, along a weight that is not zero, to the body or level that holds a body.
pub(super) fn down(weight: Vec2) -> Vec2 {
    toward(weight).unit().scaled(NEAR)
}

/// Whether one of two bodies rests on the other one. They sleep and wake together even if they do
/// not touch.
#[inline(never)]
pub(super) fn leans<S: BodyShape>(a: &Slot<S>, b: &Slot<S>, gravity: Vec2) -> bool {
    rests(a, b, gravity) || rests(b, a, gravity)
}

#[inline(never)]
fn rests<S: BodyShape>(upper: &Slot<S>, lower: &Slot<S>, gravity: Vec2) -> bool {
    let weight = upper.body.weight(gravity);
    weight != Vec2::ZERO && holds_up(&lower.body.shape, &upper.body.shape.shifted(down(weight)), weight)
}

/// Whether a shape holds one that was moved into it along its weight. A shape that overlaps it only
/// from the side does not: two such would hold each other in the air.
pub(super) fn holds_up<S: BodyShape>(lower: &S, upper: &S, weight: Vec2) -> bool {
    upper.contact(lower).is_some_and(|contact| contact.axis().dot_vec(weight) > 0)
}

/// Steps of rest beyond the last in which a body that comes to touch another stays awake. In a heap
/// bodies may move to and fro for ever, and touch again in each step.
const AWAITED: u8 = 8;

impl<S: BodyShape> Slot<S> {
    /// Whether a body that has moved touches another, and did not when the step began. The next
    /// step reports that.
    fn begins_to_touch(&self, other: &Self) -> bool {
        self.path.rate != Vec2::ZERO
            && self.body.shape.touches(&other.body.shape)
            && !self.at(Toi::ZERO).touches(&other.at(Toi::ZERO))
    }
}

/// Joins a body that may fall asleep to the awake ones that hold it. It may have met them only at
/// the end of its motion, or rest above them without touching them. Those that it only begins to
/// touch keep it awake.
pub(super) fn join_leaning<S: BodyShape>(
    slots: &mut [Slot<S>],
    near: &impl BroadPhase,
    handle: Handle,
    (gravity, steps): (Vec2, u8),
    replies: &mut impl Replies,
) {
    let Some(slot) = slots.get(handle.slot()).filter(|slot| slot.quiet >= steps) else { return };
    let new = slot.quiet - steps < AWAITED;
    near.in_region(&around(&slot.body.shape.aabb(), NEAR.to_bits() as u32), |other| {
        let (Some(one), Some(two)) = (slots.get(handle.slot()), slots.get(other.slot())) else { return };
        if other == handle || !may_meet(one, two) {
            return;
        }
        let begins = new && one.begins_to_touch(two);
        if !begins && (!two.is_awake() || senses(one, two) || !leans(one, two, gravity)) {
            return;
        }
        let pair = pair((handle, one), (other, two));
        let reply = replies.to(pair);
        if !begins {
            if reply.acts() {
                join(slots, pair);
            }
        } else if let Some(slot) = slots.get_mut(handle.slot()).filter(|_| reply != Reply::Ignore) {
            slot.tally.under = UNSETTLED;
        }
    });
}
