//! Square cells: which one a box belongs to, and which ones a region can have to do with.

use crate::broad::BroadError;
use crate::num::{DOMAIN, Raw, Vec2};
use crate::shape::Aabb;

/// A lattice of cells. A box belongs to the cell of its centre, and no side of it is longer than a cell.
///
/// So two boxes that touch belong to the same cell or to neighbours: where a whole cell is between two cells, centres in them are
/// more than a side of a cell apart (a cell has its lower lines and not its upper ones), and half widths add up to at most that.
#[derive(Clone, Copy, Debug)]
pub(in crate::broad) struct Lattice {
    /// Where cell (0, 0) begins.
    origin: Raw,
    /// The side is 2^log raw, 1 to 28.
    log: u8,
}

/// The coordinates of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::broad) struct At {
    pub(in crate::broad) x: i32,
    pub(in crate::broad) y: i32,
}

/// Some cells of a row or of a column: from one to another, both included; none where they are in the wrong order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::broad) struct Run {
    pub(in crate::broad) lo: i32,
    pub(in crate::broad) hi: i32,
}

/// Cells in a rectangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::broad) struct Window {
    pub(in crate::broad) x: Run,
    pub(in crate::broad) y: Run,
}

/// Whether a slot of the table has no body: then its box ends before it begins.
#[inline]
pub(in crate::broad) fn is_free(bounds: &Aabb) -> bool {
    bounds.hi().x < bounds.lo().x
}

impl Run {
    /// The part in common.
    pub(in crate::broad) fn and(self, other: Self) -> Self {
        Self { lo: self.lo.max(other.lo), hi: self.hi.min(other.hi) }
    }

    /// Both ends moved to the nearest of 0 to `last`. Runs keep their order; those that had something of it in them keep that.
    pub(in crate::broad) fn clamped(self, last: i32) -> Self {
        Self { lo: self.lo.max(0).min(last), hi: self.hi.max(0).min(last) }
    }

    pub(in crate::broad) fn is_empty(self) -> bool {
        self.lo > self.hi
    }

    /// How many there are, in one that is not empty.
    pub(in crate::broad) fn len(self) -> u32 {
        self.hi.wrapping_sub(self.lo).wrapping_add(1) as u32
    }
}

impl Window {
    /// How many are left of so many cells, less than 2^16, without those of a window; `None` where it has more.
    pub(in crate::broad) fn cells_of(&self, all: usize) -> Option<u32> {
        let (all, w, h) = (all as u32, self.x.len(), self.y.len());
        if w > all || h > all { None } else { all.checked_sub(w.wrapping_mul(h)) }
    }
}

impl At {
    /// Whether another cell is at most so many away, along either axis.
    pub(in crate::broad) fn is_within(self, cells: i32, other: Self) -> bool {
        self.x.abs_diff(other.x).max(self.y.abs_diff(other.y)) as i32 <= cells
    }
}

impl Lattice {
    /// `None` where the side is not a power of two from 2 to 2^28.
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

    /// The cell of a box. Sums and twice the origin are below 2^30 in size, so the difference is below 2^31; half units count.
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

    /// What a box is refused with that is not.
    #[cold]
    pub(in crate::broad) fn too_large(&self, bounds: &Aabb) -> BroadError {
        let size = bounds.hi().sub(bounds.lo());
        BroadError::TooLarge { size: size.x.max(size.y), limit: self.side() }
    }

    /// The cells of all boxes that touch a region: their centres are at most half a cell away from it. Boxes are in the domain, so
    /// what a region has beyond it does not count.
    pub(in crate::broad) fn window(&self, lo: Raw, hi: Raw) -> Window {
        let inside = |v: Raw| Raw { x: v.x.clamp(-DOMAIN, DOMAIN), y: v.y.clamp(-DOMAIN, DOMAIN) };
        let (lo, hi) = (self.before(inside(lo)), self.behind(inside(hi)));
        let run = |lo, hi| Run { lo: lo >> self.log(), hi: hi >> self.log() };
        Window { x: run(lo.x, hi.x), y: run(lo.y, hi.y) }
    }

    /// Half a cell before a corner in the domain, as seen from the origin: below 2^30 + 2^28.
    pub(in crate::broad) fn before(&self, corner: Raw) -> Raw {
        let half = self.side() >> 1;
        corner.sub(self.origin).sub(Raw { x: half, y: half })
    }

    /// Half a cell behind a corner in the domain, as seen from the origin.
    pub(in crate::broad) fn behind(&self, corner: Raw) -> Raw {
        let half = self.side() >> 1;
        corner.sub(self.origin).add(Raw { x: half, y: half })
    }
}

#[cfg(test)]
mod tests {
    use super::{Run, Window};

    /// More cells than a word can count are more than there are bodies.
    #[test]
    fn windows_are_counted_beyond_a_word() {
        let run = |cells: i32| Run { lo: -3, hi: cells - 4 };
        let left = |w: i32, h: i32| Window { x: run(w), y: run(h) }.cells_of(8);
        assert_eq!((left(1 << 29, 8), left(8, 1 << 29), left(9, 1)), (None, None, None));
        assert_eq!((left(2, 3), left(8, 1), left(1, 8)), (Some(2), Some(0), Some(0)));
    }
}
