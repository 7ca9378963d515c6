//! The velocity that a body loses as others push it back.
//!
//! Gravity adds velocity in each step, and a push takes back the displacement. If a push left the
//! velocity as it is, a body among others would become faster with every step. A heap of balls
//! would never rest. So a body that cannot yield loses velocity, too: as much as the push leads
//! against it. No component grows by that or changes its sign, so neither does the energy grow.
//!
//! A body that yields keeps its velocity. So two that meet keep their momentum, on a floor and in
//! the wind, too. So does a row on a floor: it is as free across gravity as one body. If such rows
//! lost velocity, nothing could push a heap aside.
//!
//! On a slope, gravity also adds velocity across itself. So there a push takes back both
//! components. Otherwise three boxes in a V of slopes would shake for ever.

use super::body::{ALOFT, NOBODY, Slot};
use super::farthest_pushes::FarthestPushes;
use crate::num::{Raw, Vec2};

/// The pushes on a body, and what holds it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pressed {
    /// The farthest push to each side.
    low: Vec2,
    high: Vec2,
    /// Something carries it, so it does not yield along gravity.
    lies: bool,
    /// The level or a fixed body carries it, so it is free across gravity.
    stands: bool,
    /// The velocity of what carries all below it.
    ground: Vec2,
}

impl Pressed {
    pub(super) fn of<S>(slot: &Slot<S>, ground: Vec2) -> Self {
        let stands = slot.support == 0 || (slot.support == 1 && slot.ground != NOBODY);
        let FarthestPushes { low, high } = slot.tally.pushes;
        Self { low, high, lies: slot.support != ALOFT, stands, ground }
    }

    pub(super) fn push(&self) -> Vec2 {
        self.low + self.high
    }

    /// The velocity that is left after the body's motion, relative to what carries it. On a slanted
    /// surface gravity acts on both components.
    pub(super) fn left(&self, velocity: Vec2, gravity: Vec2, slanted: bool) -> Vec2 {
        if gravity == Vec2::ZERO {
            return velocity;
        }
        let (low, high, g) = (Raw::of(self.low), Raw::of(self.high), Raw::of(gravity));
        let ground = Raw::of(self.ground);
        let v = Raw::of(velocity).sub(ground);
        let main = g.x.unsigned_abs().max(g.y.unsigned_abs());
        let one = |v: i32, low: i32, high: i32, g: i32| {
            let lies = self.lies && (slanted || g.unsigned_abs() == main);
            // In the wind, a row at a wall cannot yield either.
            let wedged = low != 0 && high != 0 && (g != 0 || !self.stands);
            // Across gravity the sum of both pushes counts: a row takes its bodies along.
            let push = low.wrapping_add(high);
            match (lies, wedged) {
                (true, _) => held(v, low, high),
                (false, true) => held(v, push.min(0), push.max(0)),
                (false, false) => v,
            }
        };
        Raw { x: one(v.x, low.x, high.x, g.x), y: one(v.y, low.y, high.y, g.y) }.add(ground).vec2()
    }
}

/// A component of a velocity, less the push against it, but not reversed.
fn held(v: i32, low: i32, high: i32) -> i32 {
    if v < 0 { v.wrapping_add(high).min(0) } else { v.wrapping_add(low).max(0) }
}

/// The velocity of a body that others lead, or that waits, after a step in which it `made` a
/// displacement.
///
/// If that is less than what gravity adds in two steps, the velocity along gravity falls to the
/// displacement. It falls by no more than gravity adds in two steps.
///
/// What it lies on, and what presses it there, have stopped it, and each changes its velocity only
/// once per step. If it kept what gravity adds, a wedged body would store speed in every step, and
/// fly off when it comes free. In a group that falls together, bodies lead each other, too, but
/// move.
pub(super) fn kept_pressed(velocity: Vec2, made: Vec2, weight: Vec2) -> Vec2 {
    let ((x, y), (made_x, made_y), (g_x, g_y)) = (velocity.raw(), made.raw(), weight.raw());
    let one = |v: i32, made: i32, g: i32| {
        // Along gravity. Each is a motion: no product wraps.
        let (along, moved, most) =
            (v.wrapping_mul(g.signum()), made.wrapping_mul(g.signum()), g.wrapping_abs().wrapping_mul(2));
        if moved >= most {
            return v;
        }
        let lost = along.wrapping_sub(moved.max(0)).min(most).max(0);
        v.wrapping_sub(lost.wrapping_mul(g.signum()))
    };
    Vec2::from_raw(one(x, made_x, g_x), one(y, made_y, g_y))
}
