//! Round bodies on flush boxes.
//!
//! Gravity sinks a ball into the box below it and, near a seam, into the corner of the next box.
//! That contact is slanted: if it counted, each seam would slow the ball down. But the push straight
//! out of the box below leads out of the next one, too. So its corner does not count. A corner that
//! sticks out, or that has no box beside it, still overlaps the ball after that push.

use super::body::Slot;
use super::idle::is_idle;
use super::kernel::BodyShape;
use super::meeting_time::senses;
use super::memory::Remembered;
use super::pairs::{both, collect_effects, collect_kicks, is_carried_in};
use super::reply::Replies;
use crate::broad::{Handle, Pair};
use crate::motion::Masses;
use crate::motion::response::separate;
use crate::num::{Axis, Vec2};

/// How a round body meets boxes at the start of a step: bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct AtBoxes(u8);

impl AtBoxes {
    pub(super) const NONE: Self = Self(0);
    const SIDE: u8 = 1;
    const CORNER: u8 = 2;
    /// The way straight out leads out of all corners, too: they do not count.
    const FLUSH: u8 = 4;
}

/// The longest pushes straight out of boxes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct WayOut {
    low: Vec2,
    high: Vec2,
}

impl WayOut {
    pub(super) const NONE: Self = Self { low: Vec2::ZERO, high: Vec2::ZERO };

    pub(super) fn add(&mut self, push: Vec2) {
        (self.low, self.high) = (self.low.min(push), self.high.max(push));
    }

    /// Whether it leads a round shape out of a box. Exact: flush boxes need no tolerance.
    pub(super) fn clears<S: BodyShape>(&self, round: &S, other: &S) -> bool {
        let by = self.low + self.high;
        by != Vec2::ZERO && round.translated(by).is_ok_and(|moved| moved.contact(other).is_none())
    }
}

/// Whether one body rolls, and the other is a box.
pub(super) fn rolls_on<S: BodyShape>(one: &Slot<S>, other: &Slot<S>) -> bool {
    one.body.mass.is_some() && one.body.shape.is_round() && !other.body.shape.is_round()
}

/// Whether a round body with this contact meets a corner of a box.
pub(super) fn is_corner(axis: Axis) -> bool {
    axis.x != 0 && axis.y != 0
}

/// Whether a contact does not count, because it is at a corner of flush boxes.
pub(super) fn is_flush<S: BodyShape>(a: &Slot<S>, b: &Slot<S>, axis: Axis) -> bool {
    let flush = |one: &Slot<S>, other: &Slot<S>| one.tally.at_boxes.0 == AtBoxes::FLUSH && rolls_on(one, other);
    is_corner(axis) && (flush(a, b) || flush(b, a))
}

/// The body of a pair that rolls, if the other one is a box.
fn round_at_box<S: BodyShape>(slots: &[Slot<S>], pair: Pair) -> Option<Handle> {
    let (a, b) = both(slots, pair)?;
    if rolls_on(a, b) { Some(pair.a) } else { rolls_on(b, a).then_some(pair.b) }
}

/// Notes how a round body meets a box, until it is known whether the boxes are flush. A corner
/// without an effect is not noted.
pub(super) fn note_box<S: BodyShape>(slots: &mut [Slot<S>], pair: Pair, axis: Axis, acts: bool) {
    let round = round_at_box(slots, pair).and_then(|at| slots.get_mut(at.slot()));
    if let Some(Slot { tally, .. }) = round.filter(|slot| slot.tally.at_boxes.0 != AtBoxes::FLUSH) {
        tally.at_boxes.0 |= match (is_corner(axis), acts) {
            (true, true) => AtBoxes::CORNER,
            (true, false) => 0,
            (false, _) => AtBoxes::SIDE,
        };
    }
}

/// What a further look at a pair is for, in this order.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Look {
    /// The way straight out of boxes, as the push of each round body.
    Sides,
    /// The corners that it does not lead out of.
    Corners,
    /// The effects of all contacts that count.
    Effects,
    /// The changes of velocities.
    Kicks,
}

impl Look {
    pub(super) const ALL: [Self; 4] = [Self::Sides, Self::Corners, Self::Effects, Self::Kicks];
}

/// Prepares a look. Returns whether there is one: no round body meets both sides and corners of
/// boxes in most steps, and the effects that were collected stay.
#[inline(never)]
pub(super) fn clear_before<S>(
    look: Look,
    slots: &mut [Slot<S>],
    memory: &[Remembered],
    (movers, woken): (&[Handle], &[Handle]),
) -> bool {
    let both = AtBoxes(AtBoxes::SIDE | AtBoxes::CORNER);
    let awake = || movers.iter().chain(woken).filter(|handle| !is_idle(memory, handle.slot()));
    let any = || awake().any(|at| slots.get(at.slot()).is_some_and(|slot| slot.tally.at_boxes == both));
    match look {
        Look::Sides if !any() => return false,
        Look::Corners | Look::Kicks => return true,
        Look::Sides | Look::Effects => {}
    }
    for handle in awake() {
        let Some(Slot { tally, .. }) = slots.get_mut(handle.slot()) else { continue };
        (tally.low, tally.high, tally.hits, tally.straight) = (Vec2::ZERO, Vec2::ZERO, 0, (0, 0));
        if look == Look::Sides {
            tally.at_boxes = if tally.at_boxes == both { AtBoxes(AtBoxes::FLUSH) } else { AtBoxes::NONE };
        }
    }
    true
}

/// Looks at a pair again.
pub(super) fn look_again<S: BodyShape>(
    look: Look,
    slots: &mut [Slot<S>],
    pair: Pair,
    gravity: Vec2,
    replies: &mut impl Replies,
) {
    if look == Look::Kicks {
        return collect_kicks(slots, pair, gravity, replies);
    }
    let flush = |at: Handle| slots.get(at.slot()).is_some_and(|slot| slot.tally.at_boxes.0 == AtBoxes::FLUSH);
    let round = round_at_box(slots, pair).filter(|&at| flush(at));
    if look != Look::Effects && round.is_none() {
        return;
    }
    let Some((a, b)) = both(slots, pair).filter(|(a, b)| !senses(a, b)) else { return };
    let Some(contact) = a.body.shape.contact(&b.body.shape) else { return };
    let reply = replies.to(pair);
    if !reply.acts() {
        return;
    }
    if look == Look::Effects {
        let carried = is_carried_in(a, b, &contact, gravity);
        collect_effects(slots, pair, &contact, gravity, (carried, reply));
        return;
    }
    let corner = is_corner(contact.axis());
    let Some(at) = round.filter(|_| corner == (look == Look::Corners)) else { return };
    let is_a = at == pair.a;
    let (round, other) = if is_a { (a, b) } else { (b, a) };
    let out = WayOut { low: round.tally.low, high: round.tally.high };
    let sticks_out = corner && !out.clears(&round.body.shape, &other.body.shape);
    // The other one gets none of the push.
    let (by_a, by_b) = separate(&contact, if is_a { Masses::B_FIXED } else { Masses::A_FIXED }.share_of_a());
    let Some(Slot { tally, .. }) = slots.get_mut(at.slot()) else { return };
    if sticks_out {
        tally.at_boxes = AtBoxes::NONE;
    } else if !corner {
        tally.pushed(by_a + by_b);
    }
}
