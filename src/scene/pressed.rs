//! The velocity that a body loses as others push it back.
//!
//! Gravity adds velocity in each step, and a push takes back the displacement. If a push left the
//! velocity as it is, a body among others would become faster with every step. A heap of balls
//! would never rest. So a body that cannot yield loses velocity, too: as much as the push leads
//! against it. No component grows by that or changes its sign, so neither does the energy grow.
//!
//! A body that yields keeps its velocity. So two that meet keep their momentum.

use super::body::{ALOFT, Slot};
use crate::num::{Raw, Vec2};

/// The pushes on a body, and what holds it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pressed {
    /// The farthest push to each side.
    low: Vec2,
    high: Vec2,
    /// Something carries it, so it does not yield along gravity.
    lies: bool,
    /// The velocity of what carries all below it.
    ground: Vec2,
}

impl Pressed {
    pub(super) fn of<S>(slot: &Slot<S>, ground: Vec2) -> Self {
        Self { low: slot.tally.low, high: slot.tally.high, lies: slot.support != ALOFT, ground }
    }

    pub(super) fn push(&self) -> Vec2 {
        self.low + self.high
    }

    /// Whether others push from opposite sides, or the level has not let it make all of its push.
    fn is_wedged(&self, made: Vec2) -> bool {
        let (low, high) = (Raw::of(self.low), Raw::of(self.high));
        (low.x != 0 && high.x != 0) || (low.y != 0 && high.y != 0) || made != self.push()
    }

    /// The velocity that is left after the body has made a part of its push, relative to what
    /// carries it.
    pub(super) fn left(&self, velocity: Vec2, made: Vec2, gravity: Vec2) -> Vec2 {
        let wedged = self.is_wedged(made);
        if gravity == Vec2::ZERO || !(wedged || self.lies) {
            return velocity;
        }
        let (low, high, g) = (Raw::of(self.low), Raw::of(self.high), Raw::of(gravity));
        let ground = Raw::of(self.ground);
        let v = Raw::of(velocity).sub(ground);
        let x = if wedged || g.x != 0 { held(v.x, low.x, high.x) } else { v.x };
        let y = if wedged || g.y != 0 { held(v.y, low.y, high.y) } else { v.y };
        Raw { x, y }.add(ground).vec2()
    }
}

/// A component of a velocity, less the push against it, but not reversed.
fn held(v: i32, low: i32, high: i32) -> i32 {
    if v < 0 { v.wrapping_add(high).min(0) } else { v.wrapping_add(low).max(0) }
}
