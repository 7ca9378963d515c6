//! Which bodies of a step are swept: the fast ones, and slow ones that run into them.

use super::Scene;
use super::body::{Mode, Slot};
use super::body_path::Pace;
use super::idle::reach_of;
use super::kernel::BodyShape;
use super::level_of_body::View;
use super::meeting_time::{around, may_meet, pair, reach, senses};
use super::memory::keep;
use super::reply::{Replies, Reply};
use super::through_level::Trip;
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;
use crate::num::Vec2;
use crate::query::Touches;

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, const M: usize, S: BodyShape> Scene<B, N, M, S> {
    /// Releases bodies without others in reach, to which only the level matters. Also those that
    /// the level holds, if no other is in reach before a third body turns it: others meet them at
    /// their positions.
    #[inline(never)]
    pub(super) fn release_unreachable<V: View<S>>(&mut self, trip: &Trip<'_, V>, replies: &mut impl Replies) {
        let Self { near, slots, memory, .. } = self;
        let movers = self.awake.get(..self.count).unwrap_or_default();
        let widest = movers
            .iter()
            .filter_map(|handle| Some(reach_of(memory, slots.get(handle.slot())?, handle.slot())))
            .max()
            .unwrap_or(0);
        for &handle in movers {
            let Some(slot) = slots.get(handle.slot()).filter(|slot| slot.path.pace == Pace::Swept) else { continue };
            let (mut alone, mut apart) = (true, true);
            let (bounds, far) = (slot.body.shape.aabb(), reach(slot));
            near.in_region(&around(&bounds, far.saturating_add(widest)), |other| {
                let found = slots.get(other.slot()).filter(|at| apart && other != handle && may_meet(slot, at));
                let acts = |at: &&Slot<S>| replies.to(pair((handle, slot), (other, at))) != Reply::Ignore;
                if let Some(at) = found.filter(acts) {
                    let both = far.saturating_add(reach_of(memory, at, other.slot()));
                    (alone, apart) = (false, !around(&bounds, both).touches(&at.body.shape.aabb()));
                }
            });
            let stays = alone || (apart && trip.stays(slot));
            if let Some(slot) = slots.get_mut(handle.slot()).filter(|_| stays) {
                slot.path.pace = Pace::Slow;
            }
        }
    }

    /// Sweeps slow bodies that run into a fast one, too, so their masses decide. If they moved
    /// first, as all slow bodies do, the fast body would make way. A walker of mass 1 would carry a
    /// hero of mass 255 along. Not for bodies that are fast only as others push them: in a pressed
    /// row, they are between slow ones.
    #[inline(never)]
    pub(super) fn cut_paths(&mut self, replies: &mut impl Replies) {
        let Self { near, slots, memory, .. } = self;
        let movers = self.awake.get(..self.count).unwrap_or_default();
        // A body that lies on a fixed one moves as on a floor of the level. Not on a lift, and not
        // if others push it: there it would sink in, unless it moves as a pile does.
        let may_cut = |slots: &[Slot<S>], slot: &Slot<S>| {
            let still = |ground: &Slot<S>| ground.mode == Mode::Fixed && ground.body.velocity == Vec2::ZERO;
            let on_floor = || slots.get(usize::from(slot.ground)).is_some_and(still);
            slot.is_awake()
                && match slot.path.pace {
                    Pace::Slow => true,
                    Pace::Lies => slot.support == 1 && slot.tally.push() == Vec2::ZERO && on_floor(),
                    _ => false,
                }
        };
        let slow = |handle: &Handle| slots.get(handle.slot()).filter(|slot| may_cut(slots, slot));
        let Some(widest) = movers.iter().filter_map(slow).map(reach).max() else { return };
        for &handle in movers {
            let fast = |slot: &Slot<S>| slot.path.pace == Pace::Swept && slot.leads_fast();
            let Some(one) = slots.get(handle.slot()).copied().filter(fast) else { continue };
            near.in_region(&around(&one.body.shape.aabb(), reach(&one).saturating_add(widest)), |other| {
                let Some(two) = slots.get(other.slot()).filter(|at| may_cut(slots, at)) else { return };
                let meet = may_meet(&one, two) && !senses(&one, two) && runs_into(two, &one);
                if meet && replies.to(pair((handle, &one), (other, two))).acts() {
                    if let Some(slot) = slots.get_mut(other.slot()) {
                        slot.path.pace = Pace::Cut;
                        keep(memory, other.slot(), None);
                    }
                }
            });
        }
    }
}

/// The displacement that a body begins the step with.
fn motion<S>(slot: &Slot<S>) -> Vec2 {
    slot.body.velocity + slot.tally.kick + slot.tally.push()
}

/// Whether a slow body moves into a fast one on the straight paths of both, or into one that a wall
/// stops at once.
fn runs_into<S: BodyShape>(slow: &Slot<S>, fast: &Slot<S>) -> bool {
    let (p, q, by) = (&slow.body.shape, &fast.body.shape, motion(slow));
    [motion(fast), Vec2::ZERO].into_iter().any(|way| {
        let Some(hit) = p.run_into(by, q, way) else { return false };
        let inward = if hit.inside { p.contact(q).map(|contact| contact.axis()) } else { Some(hit.axis.reversed()) };
        inward.is_some_and(|axis| axis.dot_vec(by) > 0)
    })
}
