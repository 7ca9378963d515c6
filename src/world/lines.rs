//! The lines of a grid that a moving box reaches, and what it meets at one.

use crate::num::umul;
use core::cmp::Ordering;

/// The lines along both axes that the front of a box reaches. A line at the very end of its motion
/// does not count, because the box enters nothing there.
///
/// Public in a private module, because a sealed trait's methods name it.
#[derive(Clone, Copy, Debug)]
pub struct Lines {
    pub(in crate::world) x: Sides,
    pub(in crate::world) y: Sides,
    /// Whether the box has an area, and its whole motion is in the map.
    pub(in crate::world) in_map: bool,
}

/// The two sides of a box across an axis, and the cells along that axis. Distances are in the
/// direction of the motion, from where the box starts.
///
/// ```text
///     way ----------->
///     |   |   +-------|---+   |       lead: the cell behind the front
///     |   |   | box   |   |   |       rear: the cell before the rear
///     |   |   +-------|---+   |
///          rear        lead gap
/// ```
///
/// A box without an extent on a line has its front at the end of one cell. Its rear is at the start
/// of the next, so `rear` is a step beyond `lead`.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Sides {
    /// The length of the motion.
    pub(in crate::world) way: i32,
    /// To the next cell, 1 or -1.
    pub(in crate::world) step: i32,
    /// The cell behind the front, and how far the front is from its end.
    pub(in crate::world) lead: i32,
    pub(in crate::world) gap: i32,
    /// The cell before the rear, and how far the rear is from its end.
    pub(in crate::world) rear: i32,
    pub(in crate::world) far: i32,
    /// The last cell: it has no end.
    pub(in crate::world) last: i32,
    /// From a tile to the next one along this axis, in the map's data.
    pub(in crate::world) stride: i32,
}

/// A hit of the side of a full or one-way cell.
///
/// Public in a private module, because a sealed trait's methods name it.
#[derive(Clone, Copy, Debug)]
pub struct BlockHit {
    /// The cell, and the flags of all cells whose sides are one surface with its side.
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) flags: u8,
    pub(crate) one_way: bool,
    /// Whether the side is across x, and the step of the motion over it.
    pub(crate) is_x: bool,
    pub(crate) step: i32,
    /// Whether the box meets only the end of the side, corner to corner.
    pub(crate) at_end: bool,
    /// The moment as a part of the motion: a numerator and a denominator.
    pub(crate) num: i32,
    pub(crate) den: i32,
}

impl Lines {
    pub(crate) const NONE: Self = {
        let none = Sides { way: 0, step: 1, lead: 0, gap: 0, rear: 0, far: 0, last: 0, stride: 0 };
        Self { x: none, y: none, in_map: false }
    };

    /// Whether all of the way is in the map, and so in the domain.
    #[inline]
    pub(crate) const fn are_in_map(&self) -> bool {
        self.in_map
    }

    /// Which axis has the next line, or both at once. `None` after the last one.
    #[inline]
    pub(in crate::world) fn next(&self) -> Option<Ordering> {
        match (self.x.gap < self.x.way, self.y.gap < self.y.way) {
            (true, true) => Some(self.x.compare(self.x.gap, &self.y, self.y.gap)),
            (true, false) => Some(Ordering::Less),
            (false, true) => Some(Ordering::Greater),
            (false, false) => None,
        }
    }
}

impl Sides {
    /// Compares the moment at which these sides have moved by `far` with that at which others have
    /// moved by `gap`. A motion that has not begun is at no line before the others.
    #[inline]
    pub(in crate::world) fn compare(&self, far: i32, other: &Self, gap: i32) -> Ordering {
        if gap == 0 {
            return far.cmp(&0);
        }
        umul(far as u32, other.way as u32).cmp(&umul(gap as u32, self.way as u32))
    }

    /// The last cell has no end.
    pub(in crate::world) const fn end_at_last(&mut self) {
        if self.lead == self.last {
            self.gap = i32::MAX;
        }
        if self.rear == self.last {
            self.far = i32::MAX;
        }
    }

    /// The cell after one, and how far its end is.
    #[inline]
    pub(in crate::world) const fn after(&self, index: i32, gap: i32, cell: i32) -> (i32, i32) {
        let next = index.wrapping_add(self.step);
        (next, if next == self.last { i32::MAX } else { gap.wrapping_add(cell) })
    }
}
