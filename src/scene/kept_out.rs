//! Fixed bodies keep out those that are not fast.
//!
//! A slow body is tested where it starts. In one step it can enter a fixed body by half of its own
//! size. In a gap between two of them, the pushes to both sides then cancel each other, and it
//! passes. So a motion that ends deep in a fixed body is cut where the two meet, and the body's
//! velocity is answered there. Without a bounce it goes on along the surface. The next step finds
//! an overlap that tells the direction of the surface, and reports the touch.

use super::SceneBody;
use super::blocked_sides::blocked_sides;
use super::body::{Mode, Slot};
use super::body_path::size;
use super::kernel::BodyShape;
use super::level_of_body::View;
use super::meeting_time::{around, may_meet, pair, senses};
use super::memory::{Remembered, Start, keep};
use super::reply::{Replies, Reply};
use super::through_level::Trip;
use super::velocities::{Meeting, part, toward};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;
use crate::motion::Surface;
use crate::num::{Axis, Fx, Raw, Vec2};

/// The state of a body before its motion in a step.
#[derive(Clone, Copy)]
pub(super) struct Before<S> {
    shape: S,
    start: Start,
    under: u16,
}

/// The first fixed body that a motion leads into.
#[derive(Clone, Copy)]
struct FirstFixed {
    /// How far the body moves up to it, relative to it; `None` if it overlaps it already.
    until: Option<Vec2>,
    /// How far the game moves it after the step.
    lift: Vec2,
    /// The normal of its surface.
    axis: Axis,
    velocity: Vec2,
    /// How it changes the velocity of the body.
    kick: Vec2,
    /// The order in which they are met: the time, the depth at the end, the key and the slot.
    rank: (u32, i32, u32, usize),
}

/// How far fixed bodies move by the end of a step at most; `None` if there are none.
pub(super) fn fixed_margin<S: BodyShape>(slots: &[Slot<S>], gravity: Vec2) -> Option<u32> {
    let fixed = slots.iter().filter(|slot| slot.mode == Mode::Fixed);
    fixed.map(|slot| size(slot.lift(gravity))).max()
}

impl<S: BodyShape> Before<S> {
    pub(super) fn of(slot: &Slot<S>) -> Self {
        Self { shape: slot.body.shape, start: Start::of(slot), under: slot.tally.under }
    }
}

impl<V> Trip<'_, V> {
    /// Cuts the motion that a body has made, if it ends deep in a fixed body.
    #[inline(never)]
    pub(super) fn keep_out<S: BodyShape, B: BroadPhase<Tag = Keyed<Filter>>>(
        &self,
        (slots, near, memory): (&mut [Slot<S>], &mut B, &mut [Remembered]),
        handle: Handle,
        before: &Before<S>,
        replies: &mut impl Replies,
    ) where
        V: View<S>,
    {
        let Some(slot) = slots.get(handle.slot()) else { return };
        let from = &before.shape;
        let by = slot.body.shape.position() - from.position();
        let Some((by, velocity)) = self.cut(slots, near, (handle, slot), (from, by), replies) else { return };
        let body = SceneBody { shape: *from, ..slot.body };
        let to = self.touch(&body, by).map_or(*from, |touched| touched.shape);
        if !slot.path.lies() && near.move_to(handle, &to.aabb()).is_err() {
            return;
        }
        self.report_path(handle, &slot.body.shape, &to);
        keep(memory, handle.slot(), None);
        let by = to.position() - from.position();
        let Some(slot) = slots.get_mut(handle.slot()) else { return };
        let Start { quiet, blocked, drift, .. } = before.start;
        (slot.body.shape, slot.body.velocity, slot.path.rate) = (to, velocity, by);
        (slot.quiet, slot.blocked, slot.tally.drift, slot.tally.under) = (quiet, blocked, drift, before.under);
        slot.block(blocked_sides(slot.tally.push(), by), by);
        self.arrive(slot, by, slot.support, false);
    }

    /// The part of a motion from a place that fixed bodies leave, and the body's velocity then.
    /// `None` if they leave all of it.
    #[inline(never)]
    pub(super) fn cut<S: BodyShape>(
        &self,
        slots: &[Slot<S>],
        near: &impl BroadPhase<Tag = Keyed<Filter>>,
        (handle, slot): (Handle, &Slot<S>),
        (from, by): (&S, Vec2),
        replies: &mut impl Replies,
    ) -> Option<(Vec2, Vec2)> {
        let (velocity, margin) = (slot.body.velocity, self.fixed?);
        let mut first = |by: Vec2, passed: u32| {
            first_fixed(slots, near, (handle, slot), (from, by), (margin, passed), (self.gravity, &mut *replies))
        };
        first(by, 0)?;
        let met = first(by, size(by))?;
        let along = |v: Vec2| Surface::SLICK.respond(v, met.axis).unwrap_or(Vec2::ZERO);
        let Some(until) = met.until else {
            // It was answered at the start of the step, and still leads into it: others push, or
            // another fixed body holds it.
            let by = met.lift + along(by - met.lift);
            let held = first(by, 0).is_some();
            return Some(if held {
                (met.lift, met.velocity)
            } else {
                (by, met.velocity + along(velocity - met.velocity))
            });
        };
        // Answered at once: if the game places the other elsewhere, the next step may not find it.
        let up_to = met.lift + until + shortened(by - met.lift, depth(from));
        let left = velocity + met.kick;
        // Along a surface that it does not bounce off, it makes the rest.
        let rest = up_to + along(by - up_to);
        let goes = along(left - met.velocity) == left - met.velocity && first(rest, 0).is_none();
        Some((if goes { rest } else { up_to }, left))
    }
}

/// The fixed body that a motion leads into first, of those in which it ends deep and deeper than it
/// starts. If it may have `passed` others by some distance, also of those that it meets on its way.
///
/// Where a ball runs over the seam of two boxes, it may end deep only in the second one. It meets
/// the first one before, and so never the corner behind the seam.
fn first_fixed<S: BodyShape>(
    slots: &[Slot<S>],
    near: &impl BroadPhase<Tag = Keyed<Filter>>,
    (handle, slot): (Handle, &Slot<S>),
    (from, by): (&S, Vec2),
    (margin, passed): (u32, u32),
    (gravity, replies): (Vec2, &mut impl Replies),
) -> Option<FirstFixed> {
    let (end, least) = (from.translated(by).ok()?, depth(from));
    let mut first: Option<FirstFixed> = None;
    // Each is a motion: no sum wraps.
    near.in_region(&around(&end.aabb(), margin.wrapping_add(passed)), |other| {
        let fixed = slots.get(other.slot()).filter(|at| at.mode == Mode::Fixed && may_meet(slot, at));
        let Some(fixed) = fixed.filter(|at| !senses(slot, at)) else { return };
        let it = &fixed.body;
        let deep = fixed.comes_to(gravity).contact(&end).map_or(Fx::ZERO, |contact| contact.depth());
        if deep <= least && passed == 0 {
            return;
        }
        let (start, lift) = (it.shape.contact(from), fixed.lift(gravity));
        if start.is_some_and(|start| start.depth().max(least) >= deep) {
            return;
        }
        let Some(hit) = from.run_into(by - lift, &it.shape, Vec2::ZERO) else { return };
        let mut until = (!hit.inside).then_some(hit.displacement);
        let mut axis = start.map_or(hit.axis, |start| start.axis());
        if slot.path.lies() {
            // It is brought out of those below it once they have moved, if it is not too deep. What
            // is below does not stop it across gravity: not the next stone of a floor, either.
            let up = toward(gravity).reversed();
            let across = Surface::SLICK.respond(by - lift, up).unwrap_or(Vec2::ZERO);
            if from.run_into(across, &it.shape, Vec2::ZERO).is_none() {
                if deep <= least * 32 {
                    return;
                }
                (until, axis) = (None, up);
            }
        }
        let reply = replies.to(pair((handle, slot), (other, fixed)));
        if !matches!(reply, Reply::Ignore | Reply::Cross) {
            let rank = (hit.toi.raw(), -deep.to_bits(), it.key, other.slot());
            if first.is_none_or(|first| rank < first.rank) {
                let kick = Meeting::of(fixed, slot, (axis, reply), gravity).filter(Meeting::is_hit);
                let kick = kick.map_or(Vec2::ZERO, |meeting| meeting.kicks(1).1);
                first = Some(FirstFixed { until, axis, lift, velocity: it.velocity, kick, rank });
            }
        }
    });
    first
}

/// How deep a slow body may end in a fixed one: 1/256 of its smaller side. It then still overlaps
/// it at the side from which it came.
fn depth<S: BodyShape>(shape: &S) -> Fx {
    let bounds = shape.aabb();
    let Raw { x, y } = bounds.hi().sub(bounds.lo());
    Fx::from_bits((x.min(y) >> 8).max(1))
}

/// The part of a motion that is at most this long.
fn shortened(by: Vec2, length: Fx) -> Vec2 {
    part(by, length.to_bits().unsigned_abs(), size(by))
}
