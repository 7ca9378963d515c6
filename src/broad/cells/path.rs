//! The cells that a box passes on its way.

use super::{Lattice, Run, Window};
use crate::num::{Raw, Toi, leading_zeros32};
use crate::shape::Aabb;

/// At most 2^15 parts: products of two such numbers fit a word.
const MOST_PARTS: u32 = 15;

/// Gives windows of cells to `each` which together hold the cells of all boxes that a box touches on its way, every cell once.
///
/// The way is cut into 2^k parts, none as long as a cell if that takes no more than 2^15 parts; both its ends are in the domain. What is near a part is a window, of
/// which all four sides only ever move in the direction of the motion. So a cell that is in two windows is in all between them, and
/// what a window has in common with the one before is what was in any of those before.
///
/// ```text
///  +-----+--+
///  |  1  | 2+--+     1: the first window; 2: what is new in the second; 3: in the third
///  +--+--+--+ 3|
///     | 2   |  |
///     +--+--+--+
///        | 3   |
///        +-----+
/// ```
///
/// `clip` moves sides of windows into a grid, and must keep their order. `each` answers which part of the way still matters: what is touched only
/// later does not come any more.
#[inline]
pub(in crate::broad) fn along(
    lattice: &Lattice,
    start: &Aabb,
    motion: Raw,
    clip: impl Fn(Window) -> Window,
    mut each: impl FnMut(&Window) -> Toi,
) {
    let (lo, hi, log) = (lattice.before(start.lo()), lattice.behind(start.hi()), log_parts(lattice, motion));
    let (mut x, mut y) = (Side::new(lo.x, hi.x, motion.x), Side::new(lo.y, hi.y, motion.y));
    let (mut before, mut until) = (None, Toi::ONE);
    for i in 0..1u32 << log {
        if i << (30 - log) > until.raw() {
            return;
        }
        let now = clip(Window { x: x.part(i, log, lattice.log()), y: y.part(i, log, lattice.log()) });
        if before == Some(now) {
            continue;
        }
        for window in fresh(now, before).iter().filter(|w| !w.x.is_empty() && !w.y.is_empty()) {
            until = each(window);
        }
        before = Some(now);
    }
}

/// One axis of a way: where the nearest cells begin and end at its start, and how far it is there and now.
struct Side {
    lo: i32,
    hi: i32,
    motion: i32,
    at: i32,
}

impl Side {
    fn new(lo: i32, hi: i32, motion: i32) -> Self {
        // Ends of parts are rounded down: the way itself is less than a unit beyond.
        Self { lo, hi: hi.wrapping_add(1), motion, at: 0 }
    }

    /// The cells near a part of the way: from `i` to `i + 1`, of 2^log.
    fn part(&mut self, i: u32, log: u32, log_cell: u32) -> Run {
        // Rounded down, and all of it in the end. The rest is below 2^log.
        let (i, rest) = (i + 1, self.motion as u32 & ((1 << log) - 1));
        let end = (self.motion >> log).wrapping_mul(i as i32).wrapping_add(((rest * i) >> log) as i32);
        let (from, to) = if end < self.at { (end, self.at) } else { (self.at, end) };
        self.at = end;
        Run { lo: self.lo.wrapping_add(from) >> log_cell, hi: self.hi.wrapping_add(to) >> log_cell }
    }
}

/// Whether a way passes fewer cells than there are bodies; else it is better to look at all of them. A part moves the sides by about a cell.
pub(in crate::broad) fn is_short(lattice: &Lattice, start: &Aabb, motion: Raw, bodies: usize) -> bool {
    let first = lattice.window(start.lo(), start.hi());
    let part = first.x.len().saturating_add(first.y.len());
    first.cells_of(bodies).is_some_and(|left| part <= left >> log_parts(lattice, motion))
}

/// How many times the way is halved.
fn log_parts(lattice: &Lattice, motion: Raw) -> u32 {
    let most = motion.x.unsigned_abs() | motion.y.unsigned_abs();
    (32 - leading_zeros32(most)).saturating_sub(lattice.log()).min(MOST_PARTS)
}

/// What a window has that the one before did not have: whole rows, and the rest of the other rows.
fn fresh(now: Window, before: Option<Window>) -> [Window; 2] {
    const NONE: Run = Run { lo: 0, hi: -1 };
    let Some(before) = before else { return [now, Window { x: NONE, y: NONE }] };
    [Window { x: now.x, y: beyond(now.y, before.y) }, Window { x: beyond(now.x, before.x), y: now.y.and(before.y) }]
}

/// What a run has that another has not, which is at one of its sides.
fn beyond(now: Run, before: Run) -> Run {
    if now.hi > before.hi {
        Run { lo: now.lo.max(before.hi + 1), hi: now.hi }
    } else {
        Run { lo: now.lo, hi: now.hi.min(before.lo - 1) }
    }
}
