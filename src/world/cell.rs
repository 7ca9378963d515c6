//! Cells of a grid, and walks over ranges of them or along a motion.

use super::tile_map::kind::TileKind;
use crate::num::umul;

/// A cell of a [`TileMap`](super::TileMap): column and row, counted from the map's origin.
///
/// ```text
///            x = 0   1   2        columns and rows -1, width and height
///  row -1  .   .   .   .   .      stand for everything beyond the map
///  row  0  . +---+---+---+ .
///  row  1  . |   | * |   | .      * is Cell { x: 1, y: 1 }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cell {
    /// Column. -1 and the map's width stand for everything left and right of the map. For a
    /// [solid](super::Solids) it holds the key: see [`Solids::key_of`](super::Solids::key_of).
    pub x: i16,
    /// Row; -1 and the map's height stand for everything beyond the first and the last row.
    pub y: i16,
}

impl Cell {
    /// A cell from its column and row.
    #[must_use]
    pub const fn new(x: i16, y: i16) -> Self {
        Self { x, y }
    }

    /// The cell that stands for a solid: its key in a row that no grid has, as theirs begin at -1.
    pub(crate) const fn of_solid(key: u16) -> Self {
        Self::new(key as i16, Self::SOLIDS)
    }

    /// The key of a solid.
    pub(crate) const fn solid(self) -> Option<u16> {
        if self.y == Self::SOLIDS { Some(self.x as u16) } else { None }
    }

    const SOLIDS: i16 = i16::MIN;

    /// For indices clamped to -1..=32767.
    pub(crate) const fn of(x: i32, y: i32) -> Self {
        Self { x: x as i16, y: y as i16 }
    }
}

/// Columns `x0..=x1` of rows `y0..=y1`; empty if a first index is above its last.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Range {
    pub(in crate::world) x0: i32,
    pub(in crate::world) y0: i32,
    pub(in crate::world) x1: i32,
    pub(in crate::world) y1: i32,
}

impl Range {
    pub(in crate::world) const NONE: Self = Self { x0: 0, y0: 0, x1: -1, y1: -1 };

    /// A range without a cell, to be [widened](Self::with).
    pub(in crate::world) const NOWHERE: Self = Self { x0: i32::MAX, y0: i32::MAX, x1: i32::MIN, y1: i32::MIN };

    /// This range, widened to a cell.
    #[inline]
    pub(in crate::world) const fn with(self, x: i32, y: i32) -> Self {
        Self {
            x0: if x < self.x0 { x } else { self.x0 },
            y0: if y < self.y0 { y } else { self.y0 },
            x1: if x > self.x1 { x } else { self.x1 },
            y1: if y > self.y1 { y } else { self.y1 },
        }
    }

    /// How many cells it has: at least one, and fewer than 2^32 in a map.
    #[inline]
    pub(in crate::world) const fn cells(&self) -> u32 {
        let (width, height) = (self.x1.wrapping_sub(self.x0), self.y1.wrapping_sub(self.y0));
        (width as u32).wrapping_add(1).wrapping_mul((height as u32).wrapping_add(1))
    }

    #[inline]
    pub(in crate::world) const fn holds(&self, x: i32, y: i32) -> bool {
        self.x0 <= x && x <= self.x1 && self.y0 <= y && y <= self.y1
    }
}

/// A cell that holds something.
///
/// Public in a private module, because a sealed trait's methods name it.
#[derive(Clone, Copy, Debug)]
pub struct Block {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) kind: TileKind,
}

/// The next cell of a walk over such cells.
#[derive(Clone, Copy, Debug)]
pub struct Cells {
    pub(in crate::world) range: Range,
    pub(in crate::world) x: i32,
    pub(in crate::world) y: i32,
}

impl Cells {
    /// A walk without a cell.
    pub(crate) const NONE: Self = Self::of(Range::NONE);

    /// How many columns it is over, before or after that, if it is over one row.
    pub(crate) const fn row_width(&self) -> Option<u32> {
        let Range { x0, y0, x1, y1 } = self.range;
        if y0 == y1 { Some((x1.wrapping_sub(x0) as u32).wrapping_add(1)) } else { None }
    }

    pub(in crate::world) const fn of(range: Range) -> Self {
        Self { x: range.x0, y: range.y0, range }
    }
}

/// A walk over the strips that a motion crosses.
///
/// `along` is the axis across the strips, `aside` the other one. Distances count from the start of
/// the motion and in its direction.
///
/// ```text
///     +---+---+---+---+          strips are columns here; in each, the cells
///     | o . # | # | # |  lead    from `trail` to `lead`
///     +---+ . +---+---+
///     | # | # | # . o |  trail
///     +---+---+---+---+
/// ```
///
/// Public in a private module, because a sealed trait's methods name it.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "facts that are independent of each other")]
pub struct Way {
    /// The cells to visit before the next strip, if they are not in `tile` and `count`.
    pub(in crate::world) cells: Cells,
    /// Whether the strips are rows.
    pub(in crate::world) rows: bool,
    /// Whether all strips are in the map.
    pub(in crate::world) in_map: bool,
    /// Whether there is another strip.
    pub(in crate::world) goes_on: bool,
    /// Whether the current strip is the first one, and whether that holds something.
    pub(in crate::world) is_first: bool,
    pub(in crate::world) starts_beside: bool,
    /// The current strip, the step to the next one, and the last that there is.
    pub(in crate::world) strip: Edge,
    /// How far the front moves until it enters the next strip. For the first strip it leaves out
    /// the gap before it. The reason is that a strip beyond the map is wider than a cell, and the
    /// body may be in it already.
    pub(in crate::world) from: i32,
    /// The length of the motion along, and the part of it that is aside, in parts of 2^30.
    pub(in crate::world) length: i32,
    pub(in crate::world) slope: u32,
    /// How much later than the front the body's sides enter a strip, and leave it.
    pub(in crate::world) lag: i32,
    pub(in crate::world) rear: i32,
    /// The cells aside at both ends of the body.
    pub(in crate::world) trail: Edge,
    pub(in crate::world) lead: Edge,
    /// The tiles that are left of the current strip. In order: the place of the next one, the
    /// number in its row, the last column, the row, and the last row.
    pub(in crate::world) tile: u32,
    pub(in crate::world) count: i32,
    pub(in crate::world) last_x: i32,
    pub(in crate::world) y: i32,
    pub(in crate::world) last_y: i32,
    pub(in crate::world) width: i32,
}

/// The cell of one end of a body, along one axis.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Edge {
    pub(in crate::world) index: i32,
    pub(in crate::world) step: i32,
    /// The last index that there is.
    pub(in crate::world) last: i32,
    /// How far the body moves until this end is in the next cell.
    pub(in crate::world) gap: i32,
}

impl Edge {
    pub(in crate::world) const NONE: Self = Self { index: 0, step: 0, last: 0, gap: 0 };

    #[inline]
    pub(in crate::world) const fn after(&self, far: i32, cell: i32) -> (i32, i32) {
        let (mut index, mut gap) = (self.index, self.gap);
        while gap <= far && index != self.last {
            (index, gap) = (index.wrapping_add(self.step), gap.wrapping_add(cell));
        }
        (index, gap)
    }
}

impl Way {
    /// Cells that are nearer than this to the path count as passed. It covers two roundings down,
    /// and a displacement that is rounded aside.
    pub(in crate::world) const MARGIN: i32 = 6;

    /// A walk that has ended.
    pub(in crate::world) const NONE: Self = {
        Self {
            cells: Cells::NONE,
            rows: false,
            in_map: false,
            goes_on: false,
            is_first: false,
            starts_beside: false,
            strip: Edge::NONE,
            from: 0,
            length: 0,
            slope: 0,
            lag: 0,
            rear: 0,
            trail: Edge::NONE,
            lead: Edge::NONE,
            tile: 0,
            count: 0,
            last_x: 0,
            y: 0,
            last_y: 0,
            width: 0,
        }
    };

    /// Whether the first strip, in which the body starts, holds something.
    pub(crate) const fn starts_beside(&self) -> bool {
        self.starts_beside
    }

    /// The part of the motion after which the body enters the next strip, as a numerator and a
    /// denominator; `None` if the walk ends.
    #[inline]
    pub(crate) const fn next_part(&self) -> Option<(u32, u32)> {
        if !self.goes_on {
            return None;
        }
        Some((if self.from < 0 { 0 } else { self.from as u32 }, self.length as u32))
    }

    /// How far aside the body is after a distance along, rounded down.
    #[inline]
    pub(in crate::world) const fn aside(&self, along: i32) -> i32 {
        let along = if along < self.length { along } else { self.length };
        if along <= 0 { 0 } else { (umul(along as u32, self.slope) >> 30) as i32 }
    }
}
