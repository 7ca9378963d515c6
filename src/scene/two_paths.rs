//! Two bodies that meet on their paths: their velocities, who lies on whom, and who yields.

use super::body::{ALOFT, NOBODY, Slot};
use super::body_path::{Heading, TURNS};
use super::kernel::BodyShape;
use super::meeting_time::Encounter;
use super::pairs::both;
use super::reply::Reply;
use super::velocities::{Meeting, Top, toward};
use crate::broad::Handle;
use crate::motion::response::exchange;
use crate::motion::{Masses, Surface};
use crate::num::Vec2;

/// What moves a body beside its velocity: its push, until it meets another body or another one
/// leads it.
pub(super) fn pushed<S>(slot: &Slot<S>) -> Vec2 {
    if slot.path.led || slot.path.has_met_any() { Vec2::ZERO } else { slot.path.rate - slot.body.velocity }
}

/// A body comes to lie on one that something carries in this step.
fn settle_on<S: BodyShape>(slots: &[Slot<S>], upper: &mut Slot<S>, lower: &Slot<S>, at: Handle) {
    if lower.path.aloft || lower.support == ALOFT {
        return;
    }
    if upper.path.aloft {
        (upper.support, upper.ground, upper.path.aloft) = (ALOFT, NOBODY, false);
    }
    upper.lie_on(slots, lower, at);
}

/// Two bodies that meet, and how each continues. The methods change both.
pub(super) struct TwoPaths<'m, S> {
    met: &'m Encounter,
    pub(super) one: Slot<S>,
    pub(super) other: Slot<S>,
    /// They have met in this step before.
    pub(super) again: bool,
    top: Top,
    /// What they had in common before.
    together: Vec2,
    pushes: (Vec2, Vec2),
}

impl<'m, S: BodyShape> TwoPaths<'m, S> {
    #[inline]
    pub(super) fn of(slots: &[Slot<S>], met: &'m Encounter) -> Option<Self> {
        let (one, other) = both(slots, met.pair)?;
        Some(Self {
            met,
            one: *one,
            other: *other,
            again: one.path.has_met(met.pair.b) || other.path.has_met(met.pair.a),
            top: Top::Neither,
            together: one.path.rate.common(other.path.rate),
            pushes: (pushed(one), pushed(other)),
        })
    }

    /// The hit changes both velocities.
    #[inline]
    pub(super) fn exchange_velocities(&mut self, slots: &[Slot<S>], reply: Reply, gravity: Vec2) {
        let hit = (self.met.axis, reply);
        if let Some(meeting) = Meeting::of_pile(slots, &self.one, &self.other, hit, gravity) {
            let (by_a, by_b) = meeting.kicks(1);
            for (slot, by) in [(&mut self.one, by_a), (&mut self.other, by_b)] {
                if !slot.path.is_held() {
                    slot.body.velocity += by;
                }
            }
        }
    }

    /// The upper one comes to lie on the lower one.
    #[inline]
    pub(super) fn settle(&mut self, slots: &[Slot<S>], gravity: Vec2) {
        self.top = Top::of(self.met.axis, toward(gravity));
        let (a, b) = (self.met.pair.a, self.met.pair.b);
        match self.top {
            Top::A if self.one.path.is_swept() => settle_on(slots, &mut self.one, &self.other, b),
            Top::B if self.other.path.is_swept() => settle_on(slots, &mut self.other, &self.one, a),
            _ => {}
        }
    }

    /// Both continue with their velocities and pushes.
    #[inline]
    pub(super) fn go_on(&mut self) {
        let (a, b) = (self.met.pair.a, self.met.pair.b);
        for (slot, with, push) in [(&mut self.one, b, self.pushes.0), (&mut self.other, a, self.pushes.1)] {
            if slot.path.is_swept() {
                if !self.again {
                    slot.path.note(with);
                }
                // A body that it has already met leads it, with its own velocity.
                let led = self.again || slot.path.waits();
                let rate = if led { slot.path.rate } else { slot.body.velocity + push };
                slot.path.go_on(self.met.time, rate, led);
            }
        }
    }

    /// The rest of the two paths must not lead into each other, whatever the velocities are. A
    /// speed below the sum of the masses, in raw units, may be too low to be shared by them. Then
    /// one yields, as when they meet again.
    #[inline]
    pub(super) fn part(&mut self) {
        let axis = self.met.axis;
        let shared = match self.goes() {
            (true, true) if !self.again => {
                self.one.body.mass.zip(self.other.body.mass).and_then(|(m, n)| Masses::new(m.get(), n.get()))
            }
            _ => None,
        };
        let yields = self.choose_yielder();
        for masses in [shared, yields].into_iter().flatten() {
            if let Ok(rates) = exchange(self.one.path.rate, self.other.path.rate, axis, masses, &Surface::SLICK) {
                (self.one.path.rate, self.other.path.rate) = rates;
            }
        }
        if self.again && axis.x != 0 && axis.y != 0 {
            // Their paths are rounded: along a slanted side they would approach by a raw unit, meet
            // at once, and wait.
            let apart = Vec2::from_raw(2 * axis.x.signum(), 2 * axis.y.signum());
            match yields {
                Some(Masses::B_FIXED) => self.one.path.rate -= apart,
                Some(_) => self.other.path.rate += apart,
                None => {}
            }
        }
    }

    /// The masses by which one of them takes the whole turn.
    #[inline]
    fn choose_yielder(&mut self) -> Option<Masses> {
        let (axis, goes) = (self.met.axis, self.goes());
        // One that was stopped on its path cannot yield: it would meet what stopped it, and
        // the other again, until both wait.
        let stopped = (self.one.path.stop.bars(axis.reversed()), self.other.path.stop.bars(axis));
        let first_yields = if stopped.0 == stopped.1 { self.top == Top::A } else { stopped.1 };
        let yields = match goes {
            (true, other_goes) if first_yields || !other_goes => Some(Masses::B_FIXED),
            (_, true) => Some(Masses::A_FIXED),
            _ => None,
        };
        match yields {
            Some(Masses::B_FIXED) if stopped.1 || !goes.1 => self.one.path.stop = Heading::of(axis),
            Some(Masses::A_FIXED) if stopped.0 || !goes.0 => self.other.path.stop = Heading::of(axis.reversed()),
            _ => {}
        }
        yields
    }

    /// A body that was turned often enough waits, and keeps what both had in common.
    #[inline]
    pub(super) fn count_turns(&mut self) {
        let goes = self.goes();
        for (slot, goes_on) in [(&mut self.one, goes.1), (&mut self.other, goes.0)] {
            if slot.path.is_swept() && !(slot.path.waits() && goes_on) {
                slot.path.turns += u8::from(slot.path.turns < TURNS);
                if slot.path.waits() {
                    slot.path.rate = self.together;
                }
            }
        }
    }

    /// Whether each of them may be led elsewhere.
    fn goes(&self) -> (bool, bool) {
        (self.one.path.goes(), self.other.path.goes())
    }
}
