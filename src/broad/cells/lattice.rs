//! Square cells: the one to which a box belongs, those that can concern a region, and those around
//! a cell or along a motion.

use crate::broad::BroadError;
use crate::num::{DOMAIN, Raw, Toi, Vec2, leading_zeros32};
use crate::shape::Aabb;

/// A lattice of cells. A box belongs to the cell of its centre, and no side of it is longer than a
/// cell.
///
/// So two boxes that touch belong to the same cell or to neighbours. A cell has its lower lines and
/// not its upper ones. If a whole cell is between two cells, centres in them are therefore more
/// than a side of a cell apart. Half widths add up to at most that side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lattice {
    /// The first corner of cell (0, 0).
    pub(in crate::broad) origin: Raw,
    /// The side is 2^log raw, 1 to 28.
    log: u8,
}

/// The coordinates of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct At {
    pub(in crate::broad) x: i32,
    pub(in crate::broad) y: i32,
}

/// Consecutive cells of a row or of a column, both ends included; none if the ends are in the wrong
/// order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct CellRange {
    pub(in crate::broad) lo: i32,
    pub(in crate::broad) hi: i32,
}

/// Cells in a rectangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    pub(in crate::broad) x: CellRange,
    pub(in crate::broad) y: CellRange,
}

/// Whether a slot of the table has no body: then its box ends before it begins.
#[inline]
pub(in crate::broad) fn is_free(bounds: &Aabb) -> bool {
    bounds.hi().x < bounds.lo().x
}

impl CellRange {
    /// The part in common.
    pub(in crate::broad) fn and(self, other: Self) -> Self {
        Self { lo: self.lo.max(other.lo), hi: self.hi.min(other.hi) }
    }

    /// This run with both ends clamped to 0..=`last`. Runs keep their order, and the part that they
    /// had in that range.
    pub(in crate::broad) fn clamped(self, last: i32) -> Self {
        Self { lo: self.lo.max(0).min(last), hi: self.hi.max(0).min(last) }
    }

    pub(in crate::broad) fn is_empty(self) -> bool {
        self.lo > self.hi
    }

    /// The number of cells of a run that is not empty.
    pub(in crate::broad) fn len(self) -> u32 {
        self.hi.wrapping_sub(self.lo).wrapping_add(1) as u32
    }
}

impl Window {
    /// The window of one cell.
    pub(in crate::broad) fn of(at: At) -> Self {
        let one = |v| CellRange { lo: v, hi: v };
        Self { x: one(at.x), y: one(at.y) }
    }

    /// Its first cell.
    pub(in crate::broad) fn first(&self) -> At {
        At { x: self.x.lo, y: self.y.lo }
    }

    /// How many of `all` cells, less than 2^16, are left without those of this window; `None` if it
    /// has more.
    pub(in crate::broad) fn cells_of(&self, all: usize) -> Option<u32> {
        let (all, w, h) = (all as u32, self.x.len(), self.y.len());
        if w > all || h > all { None } else { all.checked_sub(w.wrapping_mul(h)) }
    }
}

impl At {
    /// Whether another cell is at most `cells` away along either axis.
    pub(in crate::broad) fn is_within(self, cells: i32, other: Self) -> bool {
        self.x.abs_diff(other.x).max(self.y.abs_diff(other.y)) as i32 <= cells
    }
}

impl Lattice {
    /// `None` if the side is not a power of two from 2 to 2^28.
    pub(in crate::broad) const fn new(origin: Vec2, side: i32) -> Option<Self> {
        if side < 2 || side > DOMAIN / 2 || side & (side - 1) != 0 {
            return None;
        }
        Some(Self { origin: Raw::of(origin), log: side.trailing_zeros() as u8 })
    }

    pub(in crate::broad) const fn side(&self) -> i32 {
        1 << self.log()
    }

    pub(in crate::broad) const fn log(&self) -> u32 {
        (self.log & 31) as u32
    }

    /// The cell of a box. Sums and twice the origin are below 2^30 in size, so the difference is
    /// below 2^31; half units count.
    #[inline]
    pub(in crate::broad) fn at(&self, bounds: &Aabb) -> At {
        let (lo, hi, by) = (bounds.lo(), bounds.hi(), (self.log() + 1) & 31);
        At {
            x: lo.x.wrapping_add(hi.x).wrapping_sub(self.origin.x << 1) >> by,
            y: lo.y.wrapping_add(hi.y).wrapping_sub(self.origin.y << 1) >> by,
        }
    }

    /// Whether a box is small enough for a cell.
    #[inline]
    pub(in crate::broad) fn holds(&self, bounds: &Aabb) -> bool {
        let (size, side) = (bounds.hi().sub(bounds.lo()), self.side());
        size.x <= side && size.y <= side
    }

    /// The error for a box that is too large.
    #[cold]
    pub(in crate::broad) fn too_large(&self, bounds: &Aabb) -> BroadError {
        let size = bounds.hi().sub(bounds.lo());
        BroadError::TooLarge { size: size.x.max(size.y), limit: self.side() }
    }

    /// The cells of all boxes that touch a region: their centres are at most half a cell away from
    /// it. Boxes are in the domain, so the part of a region beyond it does not count.
    pub(in crate::broad) fn window(&self, lo: Raw, hi: Raw) -> Window {
        let inside = |v: Raw| Raw { x: v.x.clamp(-DOMAIN, DOMAIN), y: v.y.clamp(-DOMAIN, DOMAIN) };
        let (lo, hi) = (self.before(inside(lo)), self.behind(inside(hi)));
        let run = |lo, hi| CellRange { lo: lo >> self.log(), hi: hi >> self.log() };
        Window { x: run(lo.x, hi.x), y: run(lo.y, hi.y) }
    }

    /// Half a cell before a corner in the domain, relative to the origin: below 2^30 + 2^28.
    pub(in crate::broad) fn before(&self, corner: Raw) -> Raw {
        let half = self.side() >> 1;
        corner.sub(self.origin).sub(Raw { x: half, y: half })
    }

    /// Half a cell behind a corner in the domain, relative to the origin.
    pub(in crate::broad) fn behind(&self, corner: Raw) -> Raw {
        let half = self.side() >> 1;
        corner.sub(self.origin).add(Raw { x: half, y: half })
    }
}

/// How cells are numbered: row by row, with a power of two of columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::broad) struct CellRows {
    pub(in crate::broad) count: u16,
    pub(in crate::broad) log_columns: u8,
}

impl CellRows {
    pub(in crate::broad) const fn log_columns(self) -> u32 {
        (self.log_columns & 15) as u32
    }

    pub(in crate::broad) const fn last(self) -> At {
        At { x: (1 << self.log_columns()) - 1, y: self.count as i32 - 1 }
    }

    /// The number of a cell of the grid.
    #[inline]
    pub(in crate::broad) fn number(self, at: At) -> usize {
        (at.y as usize) << self.log_columns() | at.x as usize
    }

    /// The cell of a number.
    #[inline]
    pub(in crate::broad) fn place(self, number: u16) -> At {
        At { x: i32::from(number) & self.last().x, y: i32::from(number) >> self.log_columns() }
    }

    /// Clamps a window to the grid, because bodies beyond the grid are in the cells of its border.
    pub(in crate::broad) fn clip(self, window: Window) -> Window {
        let last = self.last();
        Window { x: window.x.clamped(last.x), y: window.y.clamped(last.y) }
    }

    /// The cells of a window of the grid that are not empty: one look at 32 of them.
    #[inline]
    pub(in crate::broad) fn occupied(self, words: &[u32], window: &Window, mut each: impl FnMut(usize)) {
        let Window { x: CellRange { lo, hi }, y } = *window;
        if lo > hi {
            return;
        }
        for row in y.lo..=y.hi {
            let (first, last) = (self.number(At { x: lo, y: row }), self.number(At { x: hi, y: row }));
            let (mut number, end) = (first & !31, last >> 5);
            let mut before = u32::MAX << (first & 31);
            for (i, word) in words.iter().enumerate().take(end + 1).skip(first >> 5) {
                let after = if i == end { u32::MAX >> (31 - (last & 31)) } else { u32::MAX };
                let mut bits = word & before & after;
                while bits != 0 {
                    each(number + bits.trailing_zeros() as usize);
                    bits &= bits - 1;
                }
                (before, number) = (u32::MAX, number + 32);
            }
        }
    }
}

/// The cells at distance `r` from a cell: the rows above and below, and the columns at the sides
/// between them.
///
/// The distance is the longer of those along the axes. Each cell is in one window. With `r` = 0
/// only the first window has a cell.
///
/// ```text
///  1 1 1
///  3 . 4
///  2 2 2
/// ```
pub(in crate::broad) fn ring(centre: At, r: i32) -> [Window; 4] {
    let (x, y) = (CellRange { lo: centre.x - r, hi: centre.x + r }, CellRange { lo: centre.y - r, hi: centre.y + r });
    let one = |v| CellRange { lo: v, hi: v };
    let between = CellRange { lo: y.lo + 1, hi: y.hi - 1 };
    let below = if r == 0 { between } else { one(y.hi) };
    [
        Window { x, y: one(y.lo) },
        Window { x, y: below },
        Window { x: one(x.lo), y: between },
        Window { x: one(x.hi), y: between },
    ]
}

/// The number of the last ring that has a cell of a window; the centre is in it.
pub(in crate::broad) fn last_ring(centre: At, window: &Window) -> i32 {
    let far = |run: CellRange, at: i32| (at - run.lo).max(run.hi - at);
    far(window.x, centre.x).max(far(window.y, centre.y))
}

/// At most 2^15 parts: products of two such numbers fit a word.
const MOST_PARTS: u32 = 15;

/// Passes windows of cells to `each`. Together they hold the cells of all boxes that a moving box
/// touches, every cell once.
///
/// The motion is cut into 2^k parts, each shorter than a cell if at most 2^15 parts suffice. Both
/// its ends are in the domain. The cells near a part form a window. All four sides of the windows
/// only move in the direction of the motion. A cell in two windows is therefore in all windows
/// between them. So a cell of a window was visited before exactly if it is in the previous window.
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
/// `clip` clamps sides of windows to a grid, and must keep their order. `each` returns which part
/// of the motion still matters. Bodies that are touched only later are left out.
#[inline]
pub(in crate::broad) fn along(
    lattice: &Lattice,
    start: &Aabb,
    motion: Raw,
    clip: impl Fn(Window) -> Window,
    mut each: impl FnMut(&Window) -> Toi,
) {
    let (lo, hi, log) = (lattice.before(start.lo()), lattice.behind(start.hi()), log_parts(lattice, motion));
    let (mut x, mut y) = (Edges::new(lo.x, hi.x, motion.x), Edges::new(lo.y, hi.y, motion.y));
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

/// One axis of a motion: where the nearest cells begin and end at its start, how long it is, and
/// how far it has come.
struct Edges {
    lo: i32,
    hi: i32,
    motion: i32,
    at: i32,
}

impl Edges {
    fn new(lo: i32, hi: i32, motion: i32) -> Self {
        // Ends of parts are rounded down: the motion itself is less than a unit beyond.
        Self { lo, hi: hi.wrapping_add(1), motion, at: 0 }
    }

    /// The cells near a part of the motion: from `i` to `i + 1`, of 2^log.
    fn part(&mut self, i: u32, log: u32, log_cell: u32) -> CellRange {
        // Rounded down, and all of it in the end. The rest is below 2^log.
        let (i, rest) = (i + 1, self.motion as u32 & ((1 << log) - 1));
        let end = (self.motion >> log).wrapping_mul(i as i32).wrapping_add(((rest * i) >> log) as i32);
        let (from, to) = if end < self.at { (end, self.at) } else { (self.at, end) };
        self.at = end;
        CellRange { lo: self.lo.wrapping_add(from) >> log_cell, hi: self.hi.wrapping_add(to) >> log_cell }
    }
}

/// Whether a motion passes fewer cells than there are bodies. Otherwise it is better to look at all
/// of them. A part moves the sides by about a cell.
pub(in crate::broad) fn is_short(lattice: &Lattice, start: &Aabb, motion: Raw, bodies: usize) -> bool {
    let first = lattice.window(start.lo(), start.hi());
    let part = first.x.len().saturating_add(first.y.len());
    first.cells_of(bodies).is_some_and(|left| part <= left >> log_parts(lattice, motion))
}

/// How many times the motion is halved.
fn log_parts(lattice: &Lattice, motion: Raw) -> u32 {
    let most = motion.x.unsigned_abs() | motion.y.unsigned_abs();
    (32 - leading_zeros32(most)).saturating_sub(lattice.log()).min(MOST_PARTS)
}

/// The cells of a window that are not in the one before: whole rows, and the rest of the other
/// rows.
fn fresh(now: Window, before: Option<Window>) -> [Window; 2] {
    const NONE: CellRange = CellRange { lo: 0, hi: -1 };
    let Some(before) = before else { return [now, Window { x: NONE, y: NONE }] };
    [Window { x: now.x, y: beyond(now.y, before.y) }, Window { x: beyond(now.x, before.x), y: now.y.and(before.y) }]
}

/// The part of a run that another one does not have, which is at one of its sides.
fn beyond(now: CellRange, before: CellRange) -> CellRange {
    if now.hi > before.hi {
        CellRange { lo: now.lo.max(before.hi + 1), hi: now.hi }
    } else {
        CellRange { lo: now.lo, hi: now.hi.min(before.lo - 1) }
    }
}
