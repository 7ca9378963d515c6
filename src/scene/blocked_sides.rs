//! The blocked sides of a body: those to which it was last pushed without effect, against the level
//! or against others.
//!
//! Two bodies that overlap part by their masses. If something holds one of them, its share is lost.
//! A heavy body would sink into a light one at a wall, and pass through it. So a body remembers the
//! sides to which it is blocked. At a blocked side the other body makes the whole correction.

use crate::num::Vec2;

const LEFT: u8 = 1;
const RIGHT: u8 = 2;
const UP: u8 = 4;
const DOWN: u8 = 8;

/// All sides.
#[cfg(feature = "serde")]
pub(super) const ALL: u8 = LEFT | RIGHT | UP | DOWN;

fn sides(v: Vec2) -> u8 {
    let (x, y) = v.raw();
    let of = |c: i32, low: u8, high: u8| match c {
        ..0 => low,
        0 => 0,
        1.. => high,
    };
    of(x, LEFT, RIGHT) | of(y, UP, DOWN)
}

/// The sides to which less than half of a push was made. Along a slope, a body makes most of it.
pub(super) fn blocked_sides(push: Vec2, made: Vec2) -> u8 {
    sides(push) & !sides(made + made - push + sign(push))
}

/// A raw unit to each side of a push, so exactly half of it is enough.
fn sign(push: Vec2) -> Vec2 {
    let (x, y) = push.raw();
    Vec2::from_raw(x.signum(), y.signum())
}

/// The sides that stay blocked: those to which a body was not pushed, and did not move. Otherwise
/// it would be free in every other step, and bodies on it would jitter.
pub(super) fn still_blocked(blocked: u8, push: Vec2, made: Vec2) -> u8 {
    blocked & !sides(push) & !sides(made)
}

/// Whether a push leads to a blocked side.
pub(super) fn leads_to_blocked(blocked: u8, push: Vec2) -> bool {
    sides(push) & blocked != 0
}
