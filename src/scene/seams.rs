//! Further looks at the pairs of a step, for round bodies on [flush boxes](super::flush_boxes).
//!
//! A first look cannot tell whether a corner counts: the sides of the other boxes may come later.

use super::at_boxes::AtBoxes;
use super::body::Slot;
use super::farthest_pushes::FarthestPushes;
use super::flush_boxes::{clears, is_slanted};
use super::idle::is_idle;
use super::kernel::BodyShape;
use super::meeting_time::senses;
use super::memory::Remembered;
use super::pairs::{both, collect_effects, collect_kicks, is_carried_in, round_at_box};
use super::reply::Replies;
use crate::broad::{Handle, Pair};
use crate::motion::Masses;
use crate::motion::response::separate;
use crate::num::Vec2;

/// What a further look at a pair is for, in this order.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum SeamLook {
    /// The way straight out of boxes, as the push of each round body.
    Sides,
    /// The corners that it does not lead out of.
    Corners,
    /// The effects of all contacts that count.
    Effects,
    /// The changes of velocities.
    Kicks,
}

impl SeamLook {
    pub(super) const ALL: [Self; 4] = [Self::Sides, Self::Corners, Self::Effects, Self::Kicks];
}

/// Prepares a look. Returns whether there is one: no round body meets both sides and corners of
/// boxes in most steps, and the effects that were collected stay.
#[inline(never)]
pub(super) fn clear_before<S>(
    look: SeamLook,
    slots: &mut [Slot<S>],
    memory: &[Remembered],
    (movers, woken): (&[Handle], &[Handle]),
) -> bool {
    let both = AtBoxes(AtBoxes::SIDE | AtBoxes::CORNER);
    let awake = || movers.iter().chain(woken).filter(|handle| !is_idle(memory, handle.slot()));
    let any = || awake().any(|at| slots.get(at.slot()).is_some_and(|slot| slot.tally.at_boxes == both));
    match look {
        SeamLook::Sides if !any() => return false,
        SeamLook::Corners | SeamLook::Kicks => return true,
        SeamLook::Sides | SeamLook::Effects => {}
    }
    for handle in awake() {
        let Some(Slot { tally, .. }) = slots.get_mut(handle.slot()) else { continue };
        (tally.pushes, tally.hits, tally.straight) = (FarthestPushes::NONE, 0, (0, 0));
        if look == SeamLook::Sides {
            tally.at_boxes = if tally.at_boxes == both { AtBoxes(AtBoxes::FLUSH) } else { AtBoxes::NONE };
        }
    }
    true
}

/// Looks at a pair again.
pub(super) fn look_again<S: BodyShape>(
    look: SeamLook,
    slots: &mut [Slot<S>],
    pair: Pair,
    gravity: Vec2,
    replies: &mut impl Replies,
) {
    if look == SeamLook::Kicks {
        return collect_kicks(slots, pair, gravity, replies);
    }
    let flush = |at: Handle| slots.get(at.slot()).is_some_and(|slot| slot.tally.at_boxes.0 == AtBoxes::FLUSH);
    let round = round_at_box(slots, pair).filter(|&at| flush(at));
    if look != SeamLook::Effects && round.is_none() {
        return;
    }
    let Some((a, b)) = both(slots, pair).filter(|(a, b)| !senses(a, b)) else { return };
    let Some(contact) = a.body.shape.contact(&b.body.shape) else { return };
    let reply = replies.to(pair);
    if !reply.acts() {
        return;
    }
    if look == SeamLook::Effects {
        let carried = is_carried_in(a, b, &contact, gravity);
        collect_effects(slots, pair, &contact, gravity, (carried, reply));
        return;
    }
    let corner = is_slanted(contact.axis());
    let Some(at) = round.filter(|_| corner == (look == SeamLook::Corners)) else { return };
    let is_a = at == pair.a;
    let (round, other) = if is_a { (a, b) } else { (b, a) };
    let sticks_out = corner && !clears(round.tally.pushes, &round.body.shape, &other.body.shape);
    // The other one gets none of the push.
    let (by_a, by_b) = separate(&contact, if is_a { Masses::B_FIXED } else { Masses::A_FIXED }.share_of_a());
    let Some(Slot { tally, .. }) = slots.get_mut(at.slot()) else { return };
    if sticks_out {
        tally.at_boxes = AtBoxes::NONE;
    } else if !corner {
        tally.pushes.add(by_a + by_b);
    }
}
