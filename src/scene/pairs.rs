//! How the contacts at the start of a step affect two bodies: which pushes the other, which lies on
//! the other, and which rest together.

use super::at_boxes::AtBoxes;
use super::blocked_sides::leads_to_blocked;
use super::body::{ALOFT, Mode, NOBODY, SEVERAL, Slot};
use super::body_path::Pace;
use super::flush_boxes::{is_flush, is_slanted, rolls_on};
use super::kernel::BodyShape;
use super::meeting_time::senses;
use super::reply::{Replies, Reply};
use super::velocities::{Meeting, Top, toward};
use crate::broad::{BroadPhase, Handle, Pair};
use crate::motion::Masses;
use crate::motion::response::separate;
use crate::num::{Axis, Vec2};
use crate::query::Contact;

/// All pairs with at least one awake body: selected by the tags of the others, or one by one if the
/// awake bodies are few.
pub(super) fn each_pair<B: BroadPhase>(near: &mut B, movers: &[Handle], each: impl FnMut(Pair)) {
    if movers.len() > near.len() >> 1 {
        near.pairs(each);
    } else {
        let known = near.pairs_of(movers, each);
        debug_assert!(known.is_ok(), "a body of the scene is in its broad phase");
    }
}

/// The bodies of a pair, if both are in the scene.
pub(super) fn both<S>(slots: &[Slot<S>], pair: Pair) -> Option<(&Slot<S>, &Slot<S>)> {
    let (a, b) = (slots.get(pair.a.slot())?, slots.get(pair.b.slot())?);
    (a.mode != Mode::Free && b.mode != Mode::Free).then_some((a, b))
}

/// The body of a pair that rolls, if the other one is a box.
pub(super) fn round_at_box<S: BodyShape>(slots: &[Slot<S>], pair: Pair) -> Option<Handle> {
    let (a, b) = both(slots, pair)?;
    if rolls_on(a, b) { Some(pair.a) } else { rolls_on(b, a).then_some(pair.b) }
}

/// Notes how a round body meets a box, until it is known whether the boxes are flush. A corner
/// without an effect is not noted.
fn note_box<S: BodyShape>(slots: &mut [Slot<S>], pair: Pair, axis: Axis, acts: bool) {
    let round = round_at_box(slots, pair).and_then(|at| slots.get_mut(at.slot()));
    if let Some(Slot { tally, .. }) = round.filter(|slot| slot.tally.at_boxes.0 != AtBoxes::FLUSH) {
        tally.at_boxes.0 |= match (is_slanted(axis), acts) {
            (true, true) => AtBoxes::CORNER,
            (true, false) => 0,
            (false, _) => AtBoxes::SIDE,
        };
    }
}

/// Collects the effects of a contact on two bodies. Returns whether they approach.
pub(super) fn collect_effects<S: BodyShape>(
    slots: &mut [Slot<S>],
    pair: Pair,
    contact: &Contact,
    gravity: Vec2,
    (carried, reply): (bool, Reply),
) -> bool {
    let Some((a, b)) = both(slots, pair).filter(|(a, b)| !is_flush(a, b, contact.axis())) else { return false };
    let Some(meeting) = Meeting::of_pile(slots, a, b, (contact.axis(), reply), gravity) else { return false };
    let (by_a, by_b) = parted(contact, &meeting, (a.blocked, b.blocked), || tried_part(a, b, gravity));
    let is_hit = if carried { meeting.lands(gravity) } else { meeting.is_hit() };
    note_box(slots, pair, contact.axis(), is_hit || !carried);
    for (at, by, moves) in [(pair.a, by_a, meeting.moves_a), (pair.b, by_b, meeting.moves_b)] {
        let Some(slot) = slots.get_mut(at.slot()) else { continue };
        if !carried {
            slot.tally.pushes.add(by);
        }
        if is_hit && moves {
            slot.tally.hit(meeting.is_straight());
        }
    }
    is_hit
}

/// A crate at a blocked side tries one part in so many of its share.
///
/// If it tried all of it, it would come into the next one of a row that a hero presses against a
/// wall. Such overlaps add up along the row: with 16-unit crates, 2 units per step and five crates,
/// to 9 units in place of 2. But it must try more than a free neighbour pushes it back. With one in
/// 64, five crates with friction stand before a door that opens.
const CRATES_TRY: u32 = 4;

/// Which part of its share a body of a pair tries at a blocked side, as one in so many.
///
/// Heaps of balls come to rest only if they try all of it. Boxes seen from above would get stuck in
/// doors. Fast bodies do not come into each other.
fn tried_part<S: BodyShape>(a: &Slot<S>, b: &Slot<S>, gravity: Vec2) -> u32 {
    let whole = |slot: &Slot<S>| slot.body.fast || slot.body.shape.is_round();
    if gravity == Vec2::ZERO || whole(a) || whole(b) { 1 } else { CRATES_TRY }
}

/// The pushes that part two bodies. One that is blocked tries a part of its share again, and the
/// other makes the whole correction. If two crates are blocked, each makes half. By its share, a
/// heavy one between two light ones would come into the one at the wall in each step.
fn parted(contact: &Contact, meeting: &Meeting, (a, b): (u8, u8), part: impl Fn() -> u32) -> (Vec2, Vec2) {
    let of = |masses: Masses| separate(contact, masses.share_of_a());
    let tried = |push: Vec2| {
        let (x, y) = push.raw();
        // At least a raw unit, or the body would never find that the side is free.
        let one = |c: i32| c.signum().wrapping_mul(c.unsigned_abs().div_ceil(part()) as i32);
        Vec2::from_raw(one(x), one(y))
    };
    let (by_a, by_b) = of(meeting.masses);
    match (leads_to_blocked(a, by_a), leads_to_blocked(b, by_b)) {
        (true, false) if meeting.moves_b => (tried(by_a), of(Masses::A_FIXED).1),
        (false, true) if meeting.moves_a => (of(Masses::B_FIXED).0, tried(by_b)),
        (true, true) if part() > 1 && meeting.moves_a && meeting.moves_b => of(Masses::EQUAL),
        _ => (by_a, by_b),
    }
}

/// How two bodies that run into each other change their velocities.
pub(super) fn collect_kicks<S: BodyShape, R: Replies>(
    slots: &mut [Slot<S>],
    pair: Pair,
    gravity: Vec2,
    replies: &mut R,
) {
    let Some((a, b)) = both(slots, pair) else { return };
    if senses(a, b) {
        return;
    }
    let Some(contact) = a.body.shape.contact(&b.body.shape) else { return };
    if is_flush(a, b, contact.axis()) {
        return;
    }
    let carried = is_carried_in(a, b, &contact, gravity);
    let hit = |meeting: &Meeting| if carried { meeting.lands(gravity) } else { meeting.is_hit() };
    let met = |reply| Meeting::of_pile(slots, a, b, (contact.axis(), reply), gravity).filter(hit);
    // Most pairs that touch do not approach, whatever the reply is, so this is tested first.
    // Friction decides whether one counts as the ground of the other: `Bounce` has none, `Touch`
    // has full friction.
    let by_surfaces = met(Reply::Meet);
    let others = || R::ASKS && (met(Reply::Bounce).is_some() || met(Reply::Touch).is_some());
    if by_surfaces.is_none() && !others() {
        return;
    }
    let reply = replies.to(pair);
    let Some(meeting) = (if reply == Reply::Meet { by_surfaces } else { met(reply).filter(|_| reply.acts()) }) else {
        return;
    };
    let hits = |slot: &Slot<S>, moves: bool| if moves { slot.tally.sharers(meeting.is_straight()) } else { 0 };
    let (by_a, by_b) = meeting.kicks(hits(a, meeting.moves_a).max(hits(b, meeting.moves_b)));
    for (at, by) in [(pair.a, by_a), (pair.b, by_b)] {
        if let Some(slot) = slots.get_mut(at.slot()) {
            slot.tally.kick += by;
        }
    }
}

/// Handles two touching bodies, one of which may lie on the other. Returns whether the pair is left
/// until those below have made their steps.
pub(super) fn note_who_lies<S: BodyShape>(
    slots: &mut [Slot<S>],
    pair: Pair,
    contact: Option<&Contact>,
    gravity: Vec2,
) -> bool {
    let Some((a, b)) = both(slots, pair) else { return false };
    let Some(top) = upper(a, b, contact, gravity) else { return false };
    let carried = contact.is_some() && is_carried(a, b, top);
    let (at, lower) = if top == Top::A { (pair.a, pair.b) } else { (pair.b, pair.a) };
    if let Some(slot) = slots.get_mut(at.slot()) {
        let under = &mut slot.tally.under;
        *under = if *under == NOBODY { lower.slot() as u16 } else { SEVERAL };
        slot.path.pace = Pace::Lies;
    }
    carried
}

/// Which of two touching bodies may lie on the other.
fn upper<S: BodyShape>(a: &Slot<S>, b: &Slot<S>, contact: Option<&Contact>, gravity: Vec2) -> Option<Top> {
    if gravity == Vec2::ZERO {
        return None;
    }
    let top = contact.map(|contact| Top::of(contact.axis(), toward(gravity)));
    if top.is_none_or(|top| top == Top::A) && a.lies_on(b, gravity) {
        Some(Top::A)
    } else if top.is_none_or(|top| top == Top::B) && b.lies_on(a, gravity) {
        Some(Top::B)
    } else {
        None
    }
}

/// Whether the pair is left until those below have made their steps. A fast body is moved last, and
/// along its whole path: what it overlaps pushes it like the others, or nothing would.
fn is_carried<S: BodyShape>(a: &Slot<S>, b: &Slot<S>, top: Top) -> bool {
    let (upper, lower) = if top == Top::A { (a, b) } else { (b, a) };
    lower.support != ALOFT && !upper.leads_fast()
}

/// Whether two overlapping bodies are left until those below have made their steps.
pub(super) fn is_carried_in<S: BodyShape>(a: &Slot<S>, b: &Slot<S>, contact: &Contact, gravity: Vec2) -> bool {
    upper(a, b, Some(contact), gravity).is_some_and(|top| is_carried(a, b, top))
}

/// Two bodies that touch rest together. A fixed one joins no body.
pub(super) fn join<S>(slots: &mut [Slot<S>], pair: Pair) {
    let fixed = |slot: &Slot<S>| slot.mode == Mode::Fixed;
    if both(slots, pair).is_none_or(|(a, b)| fixed(a) || fixed(b)) {
        return;
    }
    let (a, b) = (root(slots, pair.a.slot() as u16), root(slots, pair.b.slot() as u16));
    if let Some(slot) = slots.get_mut(usize::from(a.max(b))) {
        slot.tally.link = a.min(b);
    }
}

/// The representative of a body and all that it touches. The path to it is halved.
pub(super) fn root<S>(slots: &mut [Slot<S>], mut at: u16) -> u16 {
    let link = |slots: &[Slot<S>], at: u16| slots.get(usize::from(at)).map_or(at, |slot| slot.tally.link);
    for _ in 0..slots.len() {
        let next = link(slots, at);
        if next == at {
            break;
        }
        let after = link(slots, next);
        if let Some(slot) = slots.get_mut(usize::from(at)) {
            slot.tally.link = after;
        }
        at = after;
    }
    at
}
