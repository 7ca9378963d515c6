//! How two bodies act on each other's velocities, and which of them carries the other.

use super::body::{ALOFT, Slot};
use super::body_path::size;
use super::kernel::BodyShape;
use super::reply::Reply;
use crate::motion::response::exchange;
use crate::motion::{Masses, Surface};
use crate::num::{Axis, Ratio, Vec2, mul_div};
use core::num::NonZeroU8;

/// How two overlapping bodies act on each other.
#[derive(Clone, Copy)]
pub(super) struct Meeting {
    axis: Axis,
    pub(super) masses: Masses,
    surface: Surface,
    /// They continue as one.
    sticks: bool,
    /// The velocities that meet.
    a: Vec2,
    b: Vec2,
    pub(super) moves_a: bool,
    pub(super) moves_b: bool,
}

/// Which of two bodies is on top of the other, along gravity.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Top {
    A,
    B,
    Neither,
}

impl Top {
    /// The contact's axis, from A to B, must be nearer to gravity than to its perpendicular.
    pub(super) fn of(axis: Axis, gravity: Axis) -> Self {
        let along = axis.dot(gravity);
        if along.unsigned_abs() <= axis.perp_dot(gravity).unsigned_abs() {
            Self::Neither
        } else if along > 0 {
            Self::A
        } else {
            Self::B
        }
    }
}

impl Meeting {
    /// `None` if neither can be moved. A contact too slow to rise by more than gravity takes in two
    /// steps does not bounce.
    pub(super) fn of<S>(a: &Slot<S>, b: &Slot<S>, (axis, reply): (Axis, Reply), gravity: Vec2) -> Option<Self> {
        let (one, other) = (&a.body, &b.body);
        let masses = match (one.mass, other.mass) {
            (None, None) => return None,
            (None, Some(_)) => Masses::A_FIXED,
            (Some(_), None) => Masses::B_FIXED,
            (Some(m), Some(n)) => Masses::new(m.get(), n.get()).unwrap_or(Masses::EQUAL),
        };
        let surface = acting(&one.surface, &other.surface, reply).resting_under(gravity);
        let sticks = reply == Reply::Touch;
        let (moves_a, moves_b) = (one.mass.is_some(), other.mass.is_some());
        Some(Self { axis, masses, surface, sticks, a: one.velocity, b: other.velocity, moves_a, moves_b })
    }

    /// A is below B and carried, so a hit on it is a hit on the ground. Relative to the ground, B
    /// has no more energy afterwards.
    pub(super) fn onto<S: BodyShape>(
        slots: &[Slot<S>],
        a: &Slot<S>,
        b: &Slot<S>,
        (axis, reply): (Axis, Reply),
        gravity: Vec2,
    ) -> Self {
        Self {
            axis,
            masses: Masses::A_FIXED,
            surface: acting(&a.body.surface, &b.body.surface, reply).resting_under(gravity),
            sticks: reply == Reply::Touch,
            a: a.ground_velocity(slots),
            b: b.body.velocity,
            moves_a: false,
            moves_b: true,
        }
    }

    /// Two bodies of which one may [carry](carries) the other.
    pub(super) fn of_pile<S: BodyShape>(
        slots: &[Slot<S>],
        a: &Slot<S>,
        b: &Slot<S>,
        (axis, reply): (Axis, Reply),
        gravity: Vec2,
    ) -> Option<Self> {
        let own = Self::of(a, b, (axis, reply), gravity)?;
        let slick = own.surface.friction() == Ratio::ZERO && !own.sticks;
        let swept = a.path.is_swept() || b.path.is_swept();
        let passes = slick && (!swept || axis.perp_dot(toward(gravity)) == 0);
        Some(match Top::of(axis, toward(gravity)) {
            Top::A if own.moves_a && carries(slots, (b, a), gravity, passes) => {
                Self::onto(slots, b, a, (axis.reversed(), reply), gravity).swapped()
            }
            Top::B if own.moves_b && carries(slots, (a, b), gravity, passes) => {
                Self::onto(slots, a, b, (axis, reply), gravity)
            }
            _ => own,
        })
    }

    fn swapped(self) -> Self {
        Self {
            axis: self.axis.reversed(),
            masses: self.masses.swapped(),
            surface: self.surface,
            sticks: self.sticks,
            a: self.b,
            b: self.a,
            moves_a: self.moves_b,
            moves_b: self.moves_a,
        }
    }

    /// Whether it changes only velocities along x, or along y.
    pub(super) fn is_straight(&self) -> (bool, bool) {
        let slick = self.surface.friction() == Ratio::ZERO && !self.sticks;
        (slick && self.axis.y == 0, slick && self.axis.x == 0)
    }

    /// Whether they approach.
    pub(super) fn is_hit(&self) -> bool {
        self.axis.dot_vec(self.a - self.b) > 0
    }

    /// Whether they run into each other faster than the gravity of two steps. Bodies at rest do
    /// not.
    pub(super) fn lands(&self, gravity: Vec2) -> bool {
        self.is_hit() && size(self.a - self.b) > size(gravity).saturating_mul(2)
    }

    /// The changes of both velocities, if the body with more hits has this many.
    ///
    /// Only 1/hits of each change counts, so all changes of one body add up to at most one whole
    /// change. Its final velocity is then a mean of its old one and of those from its hits. No mean
    /// of velocities has more energy than the mean of their energies.
    pub(super) fn kicks(&self, hits: u16) -> (Vec2, Vec2) {
        // Along the whole relative velocity, all of it is lost.
        let axis = if self.sticks { toward(self.a - self.b) } else { self.axis };
        let Ok((a, b)) = exchange(self.a, self.b, axis, self.masses, &self.surface) else {
            return (Vec2::ZERO, Vec2::ZERO);
        };
        let one = |change: Vec2| part(change, 1, hits.into());
        (one(a - self.a), one(b - self.b))
    }
}

/// Whether a body does not yield to one on top of it. It lies on the level, or on bodies that do,
/// and the push goes into the ground. If it yielded, a pile would sink into itself.
///
/// False if the momentum of the two rises from the ground. A light body that bounces under a heavy
/// one does not: if it yielded each time, the two would never rest.
///
/// Unless it `passes` below the other one, also false if it moves sideways on the carrier by more
/// than gravity adds in a step. With friction, it drags the one on top along. Where a swept body
/// runs under a slanted side, it pushes the other one up. Slow bodies that overlap there part by
/// their pushes: if they lost velocity as well, nothing could push a heap aside.
fn carries<S: BodyShape>(slots: &[Slot<S>], (lower, upper): (&Slot<S>, &Slot<S>), gravity: Vec2, passes: bool) -> bool {
    if lower.support == ALOFT {
        return false;
    }
    let ground = lower.ground_velocity(slots);
    let v = lower.body.velocity - ground;
    // 2^58 at most, which times a mass is too much.
    let momentum =
        |v: Vec2, slot: &Slot<S>| (gravity.dot(v) >> 5) * i64::from(slot.body.mass.map_or(0, NonZeroU8::get));
    let sinks = momentum(v, lower) + momentum(upper.body.velocity - ground, upper) >= 0;
    sinks && (passes || gravity.perp_dot(v).unsigned_abs() <= gravity.length_squared())
}

/// How many bodies are between a body on top and the carrier of all, if the one below it has
/// `below`.
pub(super) fn carried(below: u8) -> u8 {
    if below == ALOFT { ALOFT } else { below + 1 }
}

/// The surface that is used for two bodies, in either order.
fn acting(a: &Surface, b: &Surface, reply: Reply) -> Surface {
    let rank = |s: &Surface| (s.restitution().raw(), !s.friction().raw());
    let own = if rank(a) < rank(b) { *b } else { *a };
    match reply {
        Reply::Slide => Surface::new(Ratio::ZERO, own.friction()),
        Reply::Touch => Surface::SLICK,
        Reply::Bounce => Surface::ELASTIC,
        Reply::Meet | Reply::Cross | Reply::Ignore => own,
    }
}

/// The direction of a vector.
pub(super) fn toward(v: Vec2) -> Axis {
    let (x, y) = v.raw();
    Axis::new(x, y)
}

/// `v * n / of`, toward zero, and at most `v`.
pub(super) fn part(v: Vec2, n: u32, of: u32) -> Vec2 {
    if n >= of {
        return v;
    }
    let share = |c: i32| {
        let size = mul_div(c.unsigned_abs(), n, of) as i32;
        if c < 0 { size.wrapping_neg() } else { size }
    };
    let (x, y) = v.raw();
    Vec2::from_raw(share(x), share(y))
}
