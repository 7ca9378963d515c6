//! Fast bodies meet others and the level on their whole path, in the order of the times.
//!
//! Each has a straight path for the rest of the step, and knows its first end: the level, another
//! body, or the step. The earliest end is handled, and the bodies that it changed look again.
//!
//! A slow body has already moved, and replies as on the straight path from its start. A hit changes
//! its velocity, but it keeps that path, and the body that hit it avoids the path. Two that meet
//! again in the step move along each other, and their velocities meet in the next one.

use super::blocked_sides::blocked_sides;
use super::body::{ALOFT, NOBODY, Slot};
use super::body_path::{BodyPath, Heading, Pace, PathEnd, TURNS, later, rate_of, size};
use super::change::add_to_awake;
use super::idle::stop_idling;
use super::kernel::BodyShape;
use super::level_of_body::View;
use super::meeting_time::{Encounter, FirstEnd, each_near, may_meet, senses, stops};
use super::memory::Remembered;
use super::pressed::kept_pressed;
use super::reply::{Replies, Reply};
use super::through_level::{Touched, Trip, hold_in_place};
use super::two_paths::{TwoPaths, pushed};
use super::{Scene, SceneEvent, SceneFault, Stepped};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;
use crate::motion::{Hit, Hits, Surface};
use crate::num::{Toi, Vec2};
use crate::query::Touches;

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, const M: usize, S: BodyShape> Scene<B, N, M, S> {
    /// Moves the fast bodies. Returns whether one has been quiet for long enough. A separate
    /// function: most steps need neither its registers nor its stack.
    #[inline(never)]
    pub(super) fn sweep<V: View<S>>(
        &mut self,
        trip: &Trip<'_, V>,
        stepped: &mut Stepped,
        replies: &mut impl Replies,
        each: &mut dyn FnMut(SceneEvent<'_>),
    ) -> bool {
        let from = self.count;
        let Some((movers, room)) = self.awake.split_at_mut_checked(from) else { return false };
        let (near, slots, memory) = (&mut self.near, self.slots.as_mut_slice(), self.memory.as_mut_slice());
        let mut sweep = Sweep { near, slots, memory, movers, room, woken: 0, trip, margin: 0, stepped, replies, each };
        sweep.run();
        let woken = sweep.woken;
        stepped.woken += woken as u16;
        self.count += woken;
        self.mark_woken(from);
        let quiet =
            |handle: &Handle| self.slots.get(handle.slot()).is_some_and(|slot| slot.quiet >= self.sleep().steps);
        self.awake().iter().any(quiet)
    }
}

/// No chord is taken for less than this, in raw units. Its velocity is that of the part of the path
/// that is left, whose roundings are less than 1 in 2000 of it. Of 11 raw units they took a tenth.
const SHORTEST_CHORD: u32 = 1 << 12;

struct Sweep<'a, B, V, S, R> {
    near: &'a mut B,
    slots: &'a mut [Slot<S>],
    memory: &'a mut [Remembered],
    /// The bodies that were awake before.
    movers: &'a [Handle],
    room: &'a mut [Handle],
    woken: usize,
    trip: &'a Trip<'a, V>,
    /// No slow body is farther than this from its position in the broad phase.
    margin: u32,
    stepped: &'a mut Stepped,
    replies: &'a mut R,
    each: &'a mut dyn FnMut(SceneEvent<'_>),
}

impl<B, V, S, R> Sweep<'_, B, V, S, R>
where
    B: BroadPhase<Tag = Keyed<Filter>>,
    V: View<S>,
    S: BodyShape,
    R: Replies,
{
    // Separate calls: the mover goes about 2 KB deeper from here, and the stack of a call is free
    // again when it returns.
    fn run(&mut self) {
        self.launch();
        while let Some(handle) = self.earliest() {
            match self.slots.get(handle.slot()).map_or(PathEnd::Step, |slot| slot.path.end.1) {
                PathEnd::Step => break,
                PathEnd::Level => self.hit_level(handle),
                PathEnd::Body(with) => self.meet_body(handle, with),
            }
        }
        for handle in self.movers {
            self.finish(*handle);
        }
        self.slots.iter_mut().for_each(|slot| slot.path = BodyPath::made(slot.path.rate));
    }

    /// A push is a part of the body's path: another body may be on it.
    #[inline(never)]
    fn launch(&mut self) {
        for handle in self.movers {
            let Some(slot) = self.slots.get_mut(handle.slot()) else { continue };
            if slot.path.is_swept() {
                slot.body.velocity += slot.tally.kick;
                let (pace, rate) = (slot.path.pace, slot.body.velocity + slot.tally.push());
                slot.path = BodyPath { pace, since: Toi::ZERO, aloft: true, ..BodyPath::made(rate) };
                self.stepped.moved += 1;
            } else {
                self.margin = self.margin.max(size(slot.path.rate));
            }
        }
        self.look_again(None);
    }

    /// The body with the earliest end. At one time the level's end is first, then the pair with the
    /// smaller keys, then slots.
    fn earliest(&self) -> Option<Handle> {
        let swept = |handle: &&Handle| self.slots.get(handle.slot()).is_some_and(|slot| slot.path.is_swept());
        self.movers.iter().filter(swept).copied().min_by_key(|handle| {
            let rank = |at: usize| (self.slots.get(at).map_or(0, |slot| slot.body.key), at);
            let mine = rank(handle.slot());
            let (time, end) = self.slots.get(handle.slot()).map_or((Toi::ONE, PathEnd::Step), |slot| slot.path.end);
            let (kind, other) = match end {
                PathEnd::Level => (0, mine),
                PathEnd::Body(with) => (1, rank(with.into())),
                PathEnd::Step => (2, mine),
            };
            (kind == 2, time, kind, mine.min(other), mine.max(other))
        })
    }

    /// Finds the ends of the paths of the bodies in the slots `turned`, and of those that depend on
    /// them. With `None`, at the start of the step, it finds all ends. All look again if one is
    /// held, because some may have seen it move.
    #[inline(never)]
    fn look_again(&mut self, mut turned: Option<[u16; 2]>) {
        loop {
            let held = self.stepped.held;
            self.find_ends(turned.take());
            if self.stepped.held == held {
                break;
            }
        }
    }

    fn find_ends(&mut self, turned: Option<[u16; 2]>) {
        for &handle in self.movers {
            let Some(slot) = self.slots.get(handle.slot()) else { continue };
            if !slot.path.is_swept() || slot.path.is_held() {
                continue;
            }
            let known = turned.filter(|turned| !turned.iter().any(|&at| slot.path.depends_on(handle, at)));
            if known.is_some() && !slot.path.waits() {
                continue;
            }
            let slot = *slot;
            let end = match known {
                Some(turned) => Ok(self.compare_turned(handle, &slot, turned)),
                None => self.find_end(handle, &slot),
            };
            let Some(slot) = self.slots.get_mut(handle.slot()) else { continue };
            match end {
                Ok(end) => slot.path.end = end,
                Err(fault) => {
                    (slot.body.velocity, slot.path.rate) = (Vec2::ZERO, Vec2::ZERO);
                    (slot.path.turns, slot.path.end) = (BodyPath::HELD, (Toi::ONE, PathEnd::Step));
                    self.stepped.held += 1;
                    (self.each)(SceneEvent::Held { body: handle, fault });
                }
            }
        }
    }

    /// The first end of a body's path.
    #[inline(never)]
    fn find_end(&mut self, handle: Handle, slot: &Slot<S>) -> Result<(Toi, PathEnd), SceneFault> {
        let since = slot.path.since;
        let touched = self.trip.touch(&slot.body, slot.path.left(since))?;
        let mut first = FirstEnd::of_level(touched.hit.map(|hit| later(since, hit.toi)));
        let replies = &mut *self.replies;
        each_near(self.near, self.slots, (self.movers, self.margin), handle, stops, |other, at| {
            first.meet((handle, slot), (other, at), replies);
        });
        Ok(first.end)
    }

    /// The first end of the path of a body that waits, if others have turned on which it did not
    /// depend. It may have ignored them before, and they may ignore it if they wait as well.
    fn compare_turned(&mut self, handle: Handle, slot: &Slot<S>, turned: [u16; 2]) -> (Toi, PathEnd) {
        let (mut first, passed) = (FirstEnd::known(self.slots, slot.path.end), slot.passed());
        for other in turned {
            let other = usize::from(other);
            let near = |at: &&Slot<S>| at.path.is_swept() && stops(slot, at) && at.passed().touches(&passed);
            if let Some(at) = self.slots.get(other).filter(near) {
                first.meet((handle, slot), (Handle::new(other, at.generation), at), self.replies);
            }
        }
        first.end
    }

    /// Handles a hit of the level.
    #[inline(never)]
    fn hit_level(&mut self, handle: Handle) {
        let Some(slot) = self.slots.get(handle.slot()).copied() else { return };
        let (time, _) = slot.path.end;
        self.report_sensors(handle, &slot, time);
        let touched = self.trip.touch(&slot.body, slot.path.left(slot.path.since));
        let Some(slot) = self.slots.get_mut(handle.slot()) else { return };
        slot.path.turns += u8::from(slot.path.turns < TURNS);
        let (mut push, mut chord) = (pushed(slot), None);
        // Others may lead it faster than it moves by itself.
        let leads_itself = slot.path.rate == slot.body.velocity;
        if let Ok(Touched { shape, hit: Some(hit), floor, flags }) = touched {
            let velocity = slot.body.velocity;
            let stays = shape.position() == slot.body.shape.position();
            self.trip.report_path(handle, &slot.body.shape, &shape);
            slot.body.shape = shape;
            if stays && slot.path.stop == Heading::of(hit.axis) {
                // Between two surfaces that face each other, bounces would take no time.
                slot.body.velocity = Surface::SLICK.respond(velocity, hit.axis).unwrap_or(Vec2::ZERO);
            } else {
                let (after, slides) = self.trip.after(&slot.body, &hit);
                // A curve has the next hit at once, again and again. The mover knows the chord, and
                // others can meet the body on that.
                let left = slot.path.left(time);
                let bends = slides && slot.path.turns > 1 && !slot.path.waits() && size(left) >= SHORTEST_CHORD;
                if bends && push == Vec2::ZERO {
                    let bent = self.trip.bend(&slot.body, left);
                    chord = bent.ok().filter(|(by, _)| *by != Vec2::ZERO);
                }
                slot.body.velocity = after;
            }
            // It is pushed along the surface.
            push = Surface::SLICK.respond(push, hit.axis).unwrap_or(Vec2::ZERO);
            slot.path.stop = Heading::of(hit.axis.reversed());
            if floor {
                (slot.support, slot.ground, slot.path.aloft) = (0, NOBODY, false);
            }
            let hits = Hits::one(Hit { toi: time, ..hit });
            (self.each)(SceneEvent::Level { body: handle, hits: &hits, flags, velocity });
        }
        if let Some((by, velocity)) = chord {
            if leads_itself {
                slot.body.velocity = rate_of(velocity, time);
            }
            slot.path.go_on(time, rate_of(by, time), !leads_itself);
        } else {
            let waits = slot.path.waits();
            slot.path.go_on(time, if waits { Vec2::ZERO } else { slot.body.velocity + push }, waits);
        }
        let at = handle.slot() as u16;
        self.look_again(Some([at, at]));
    }

    /// Handles a meeting of two bodies.
    #[inline(never)]
    fn meet_body(&mut self, handle: Handle, with: u16) {
        let slots = &*self.slots;
        let (Some(slot), Some(other)) = (slots.get(handle.slot()), slots.get(usize::from(with))) else { return };
        let (one, two) = ((handle, *slot), (Handle::new(with.into(), other.generation), *other));
        if let Some(met) = Encounter::of((one.0, &one.1), (two.0, &two.1)) {
            for (at, slot) in [&one, &two] {
                if slot.path.is_swept() {
                    self.report_sensors(*at, slot, met.time);
                }
            }
            self.meet(&met);
        } else if let Some(slot) = self.slots.get_mut(handle.slot()) {
            // This cannot happen: the body that found it has looked at the same two.
            slot.path.turns = TURNS;
        }
        let at = handle.slot() as u16;
        self.look_again(Some([at, with]));
    }

    #[inline(never)]
    fn meet(&mut self, met: &Encounter) {
        self.place_at_meeting(met);
        let Some(mut paths) = TwoPaths::of(self.slots, met) else { return };
        if !paths.again {
            self.report(met, &paths);
            let reply = self.replies.to(met.pair);
            paths.exchange_velocities(self.slots, reply, self.trip.gravity);
        }
        paths.settle(self.slots, self.trip.gravity);
        paths.go_on();
        paths.part();
        paths.count_turns();
        for (at, from) in [(met.pair.a, paths.one), (met.pair.b, paths.other)] {
            self.commit(at, &from);
        }
    }

    /// Moves the swept ones of two bodies to where they meet. Tested against the level, because the
    /// position is rounded: a body on a floor might lead into it.
    fn place_at_meeting(&mut self, met: &Encounter) {
        for (at, place) in [(met.pair.a, met.place_a), (met.pair.b, met.place_b)] {
            let Some(slot) = self.slots.get_mut(at.slot()).filter(|slot| slot.path.is_swept()) else {
                continue;
            };
            if let Ok(shape) = self.trip.slide(at, &slot.body, place - slot.body.shape.position()) {
                slot.body.shape = shape;
            }
            slot.path.since = met.time;
        }
    }

    /// Reports that two bodies meet for the first time, and wakes them.
    fn report(&mut self, met: &Encounter, paths: &TwoPaths<'_, S>) {
        (self.each)(met.event(&paths.one, &paths.other));
        add_to_awake(self.slots, self.room, &mut self.woken, met.pair.a);
        add_to_awake(self.slots, self.room, &mut self.woken, met.pair.b);
    }

    /// Stores the velocity, the path and the support of a body after a meeting.
    fn commit(&mut self, at: Handle, from: &Slot<S>) {
        let Some(slot) = self.slots.get_mut(at.slot()) else { return };
        // A body that has already moved in this step does not fall asleep at its end.
        if slot.path.pace == Pace::Slow && slot.body.velocity != from.body.velocity {
            slot.quiet = 0;
            stop_idling(self.memory, at.slot());
        }
        (slot.body.velocity, slot.path) = (from.body.velocity, from.path);
        (slot.support, slot.ground) = (from.support, from.ground);
        // The hit has made it fast: now it meets slow bodies and sensors on its path, too.
        if slot.path.pace == Pace::Cut && slot.leads_fast() {
            slot.path.pace = Pace::Swept;
        }
    }

    /// Reports the sensors on a path that ends at a time.
    #[inline(never)]
    fn report_sensors(&mut self, handle: Handle, slot: &Slot<S>, until: Toi) {
        let (each, replies) = (&mut *self.each, &mut *self.replies);
        // The next step reports two slow bodies that touch.
        let fast = |slot: &Slot<S>| slot.path.pace == Pace::Swept;
        let counts = |one: &Slot<S>, other: &Slot<S>| {
            (fast(one) || fast(other)) && may_meet(one, other) && (R::CROSSES || senses(one, other))
        };
        each_near(self.near, self.slots, (self.movers, self.margin), handle, counts, |other, at| {
            let sensor = senses(slot, at);
            let met = Encounter::of((handle, slot), (other, at)).filter(|met| met.begins && met.time < until);
            let reports = |reply: Reply| reply == Reply::Cross || (sensor && reply.acts());
            if let Some(met) = met.filter(|met| reports(replies.to(met.pair))) {
                let (a, b) = if met.pair.a == handle { (slot, at) } else { (at, slot) };
                each(met.event(a, b));
            }
        });
    }

    /// Only the step ends its path.
    #[inline(never)]
    fn finish(&mut self, handle: Handle) {
        let swept = |slot: &&Slot<S>| slot.path.is_swept();
        let Some(slot) = self.slots.get(handle.slot()).filter(swept).copied() else { return };
        self.report_sensors(handle, &slot, Toi::ONE);
        let Some(slot) = self.slots.get_mut(handle.slot()) else { return };
        if let Ok(touched) = self.trip.touch(&slot.body, slot.path.left(slot.path.since)) {
            self.trip.report_path(handle, &slot.body.shape, &touched.shape);
            slot.body.shape = touched.shape;
        }
        slot.path.since = Toi::ONE;
        if slot.path.aloft {
            (slot.support, slot.ground) = (ALOFT, NOBODY);
        }
        let (bounds, free) = (slot.body.shape.aabb(), slot.path.turns == 0);
        let by = self.near.bounds(handle).map_or(Vec2::ZERO, |from| bounds.min() - from.min());
        slot.block(blocked_sides(slot.tally.push(), by), by);
        slot.path.rate = by;
        if slot.path.led || slot.path.waits() {
            slot.body.velocity = kept_pressed(slot.body.velocity, by, slot.body.weight(self.trip.gravity));
        }
        match self.near.move_to(handle, &bounds) {
            Ok(()) => self.trip.arrive(slot, by, slot.support, free),
            Err(fault) => {
                slot.body.shape = slot.body.shape.shifted(Vec2::ZERO - by);
                hold_in_place(slot, handle, fault.into(), self.stepped, self.each);
            }
        }
    }
}
