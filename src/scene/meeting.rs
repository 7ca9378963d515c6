//! What becomes of two bodies that run into each other.

use super::body::{ALOFT, Slot};
use crate::motion::response::exchange;
use crate::motion::{Masses, Surface};
use crate::num::{Axis, Ratio, Vec2, mul_div};

/// How two overlapping bodies act on each other.
#[derive(Clone, Copy)]
pub(super) struct Meeting {
    axis: Axis,
    pub(super) masses: Masses,
    surface: Surface,
    /// The velocities that meet.
    a: Vec2,
    b: Vec2,
    pub(super) moves_a: bool,
    pub(super) moves_b: bool,
}

/// Which of two bodies is on top of the other, as gravity sees it.
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
    /// `None` where neither can be moved.
    ///
    /// What is below, and fixed or [carried](carries), counts as falling for one step: then what lies on it falls by as much as it is pushed up in each step, and
    /// rests. That body has no more energy afterwards. Seen from the one below, whose velocity is g, it has not; its change is `j n + f t` with `|f| <= j`, for no
    /// friction is above 1, and n is nearer to -g than to its perpendicular: so the change is against g, and adding g back gains nothing.
    /// For one that floats it stands still, and nothing is added.
    pub(super) fn of(a: &Slot, b: &Slot, axis: Axis, gravity: Vec2) -> Option<Self> {
        let (one, other) = (&a.body, &b.body);
        let masses = match (one.mass, other.mass) {
            (None, None) => return None,
            (None, Some(_)) => Masses::A_FIXED,
            (Some(_), None) => Masses::B_FIXED,
            (Some(m), Some(n)) => Masses::new(m.get(), n.get()).unwrap_or(Masses::EQUAL),
        };
        let surface = acting(&one.surface, &other.surface);
        let (moves_a, moves_b) = (one.mass.is_some(), other.mass.is_some());
        let (v, w) = (one.velocity, other.velocity);
        let own = Self { axis, masses, surface, a: v, b: w, moves_a, moves_b };
        let slick = surface.friction() == Ratio::ZERO;
        Some(match Top::of(axis, toward(gravity)) {
            Top::A if !moves_b => Self { b: w + one.weight(gravity), ..own },
            Top::B if !moves_a => Self { a: v + other.weight(gravity), ..own },
            Top::A if moves_a && carries(b, a, gravity, slick) => {
                Self { masses: Masses::B_FIXED, b: one.weight(gravity), moves_b: false, ..own }
            }
            Top::B if moves_b && carries(a, b, gravity, slick) => {
                Self { masses: Masses::A_FIXED, a: other.weight(gravity), moves_a: false, ..own }
            }
            _ => own,
        })
    }

    /// Whether they approach.
    pub(super) fn is_hit(&self) -> bool {
        self.axis.dot_vec(self.a - self.b) > 0
    }

    /// By what the velocities change, where the body with more hits has so many.
    ///
    /// Of each change only that part counts, so of the changes of one body no more than one whole one does; what it ends with is then a mean of what it had and
    /// of what its hits give it, and no mean of velocities has more energy than the mean of their energies.
    pub(super) fn kicks(&self, hits: u16) -> (Vec2, Vec2) {
        let Ok((a, b)) = exchange(self.a, self.b, self.axis, self.masses, &self.surface) else {
            return (Vec2::ZERO, Vec2::ZERO);
        };
        (part(a - self.a, hits), part(b - self.b, hits))
    }
}

/// Whether a body does not give way to one on top of it: it lies on the level, or on bodies that do, and the push that it gets goes into the ground. If it gave
/// way, a pile would sink into itself.
///
/// Not where it rises; nor, where there is friction, where it goes sideways by more than gravity gives in a step: then it takes the one on top along.
fn carries(lower: &Slot, upper: &Slot, gravity: Vec2, slick: bool) -> bool {
    let v = lower.body.velocity;
    lower.support < upper.support
        && gravity.dot(v) >= 0
        && (slick || gravity.perp_dot(v).unsigned_abs() <= gravity.length_squared())
}

/// How many are between a body on top and what carries all, if the one below it has so many.
pub(super) fn carried(below: u8) -> u8 {
    if below == ALOFT { ALOFT } else { below + 1 }
}

/// Which of two surfaces counts: not a matter of which is A.
fn acting(a: &Surface, b: &Surface) -> Surface {
    let rank = |s: &Surface| (s.restitution().raw(), !s.friction().raw());
    if rank(a) < rank(b) { *b } else { *a }
}

/// The direction of a vector.
pub(super) fn toward(v: Vec2) -> Axis {
    let (x, y) = v.raw();
    Axis::new(x, y)
}

/// `v / n`, toward zero.
fn part(v: Vec2, n: u16) -> Vec2 {
    if n <= 1 {
        return v;
    }
    let of = |c: i32| {
        let size = mul_div(c.unsigned_abs(), 1, n.into()) as i32;
        if c < 0 { size.wrapping_neg() } else { size }
    };
    let (x, y) = v.raw();
    Vec2::from_raw(of(x), of(y))
}
