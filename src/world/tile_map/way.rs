//! The cells that a body passes on a long straight way, each once, in strips: column after column,
//! or row after row, whichever the way crosses more of.

use super::{Set, Store, TileMap};
use crate::num::{Raw, mul_div, umul};
use crate::shape::Aabb;
use crate::world::cell::{Block, Cells, Range};

/// The cells to visit: those of a range, or those of a way.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Walk {
    Cells(Cells),
    Way(Way),
}

/// A walk over the strips of a way.
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
    cells: Cells,
    /// Whether the strips are rows.
    rows: bool,
    /// Whether all strips are in the map.
    in_map: bool,
    /// Whether there is another strip.
    goes_on: bool,
    /// Whether the current strip is the first one, and whether that holds something.
    is_first: bool,
    starts_beside: bool,
    /// The current strip, the step to the next one, and the last that there is.
    strip: Edge,
    /// How far the front goes until it comes into the next strip. Of the first strip not the gap
    /// before it: a strip beyond the map is wider than a cell, and the body may be in it already.
    from: i32,
    /// The length of the motion along, and how much of it goes aside, in parts of 2^30.
    length: i32,
    slope: u32,
    /// How much later than the front the body's sides come into a strip, and leave it.
    lag: i32,
    rear: i32,
    /// The cells aside at both ends of the body.
    trail: Edge,
    lead: Edge,
    /// The tiles of the current strip that are left: the place of the next one, how many in its
    /// row, the last column, the row, the last row.
    tile: u32,
    count: i32,
    last_x: i32,
    y: i32,
    last_y: i32,
    width: i32,
}

/// The cell of one end of a body, along one axis.
#[derive(Clone, Copy, Debug)]
struct Edge {
    index: i32,
    step: i32,
    /// The last index that there is.
    last: i32,
    /// How far the body goes until this end is in the next cell.
    gap: i32,
}

impl Edge {
    const NONE: Self = Self { index: 0, step: 0, last: 0, gap: 0 };

    #[inline]
    const fn after(&self, far: i32, cell: i32) -> (i32, i32) {
        let (mut index, mut gap) = (self.index, self.gap);
        while gap <= far && index != self.last {
            (index, gap) = (index.wrapping_add(self.step), gap.wrapping_add(cell));
        }
        (index, gap)
    }
}

impl Way {
    /// Cells that are nearer than this to the way count as passed. It makes up for two roundings
    /// down, and for a displacement that is rounded aside.
    const MARGIN: i32 = 6;

    /// A way that is over.
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

    /// The part of the motion after which the body comes to the next strip, as a numerator and a
    /// denominator; `None` where the way ends.
    #[inline]
    pub(crate) const fn next_part(&self) -> Option<(u32, u32)> {
        if !self.goes_on {
            return None;
        }
        Some((if self.from < 0 { 0 } else { self.from as u32 }, self.length as u32))
    }

    /// How far aside the body is after a distance along, rounded down.
    #[inline]
    const fn aside(&self, along: i32) -> i32 {
        let along = if along < self.length { along } else { self.length };
        if along <= 0 { 0 } else { (umul(along as u32, self.slope) >> 30) as i32 }
    }
}

/// One axis of a body and its motion.
struct Side {
    lo: i32,
    hi: i32,
    d: i32,
}

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// The way of a body whose core is rounded by `r`, before its first strip.
    ///
    /// At a slope s of at most 1, a disc reaches `r sqrt(1 + s^2) < r (1 + 7 s / 16)` aside of its
    /// centre's line, and its bounds `r (1 + s)`. So it is where bounds would be that start to
    /// reach aside 9/16 of the radius behind the front, and end so much earlier.
    #[inline(never)]
    pub(in crate::world) const fn way(&self, bounds: &Aabb, r: i32, d: Raw) -> Way {
        let (m, lo, hi) = (Way::MARGIN, bounds.lo(), bounds.hi());
        let x = Side { lo: lo.x.wrapping_sub(m), hi: hi.x.wrapping_add(m), d: d.x };
        let y = Side { lo: lo.y.wrapping_sub(m), hi: hi.y.wrapping_add(m), d: d.y };
        let in_map = self.holds_way(&x, &y);
        let rows = d.y.unsigned_abs() > d.x.unsigned_abs();
        let (along, aside) = if rows { (y, x) } else { (x, y) };
        let (length, lag) = (along.d.unsigned_abs(), (r >> 1).wrapping_add(r >> 4));
        let (strip, trail) = (self.edge(&along, rows), self.edge(&aside, !rows));
        let width = along.hi.wrapping_sub(along.lo);
        Way {
            rows,
            in_map,
            goes_on: true,
            // Before its first strip, and as the front sees it.
            strip: Edge {
                index: strip.index.wrapping_sub(strip.step),
                gap: strip.gap.wrapping_sub(self.grid.cell).wrapping_sub(width),
                ..strip
            },
            from: width.wrapping_neg(),
            length: length as i32,
            slope: mul_div(aside.d.unsigned_abs(), 1 << 30, length),
            lag,
            rear: width.wrapping_sub(lag),
            lead: Edge { gap: trail.gap.wrapping_sub(aside.hi.wrapping_sub(aside.lo)), ..trail },
            trail,
            ..Way::NONE
        }
    }

    const fn holds_way(&self, x: &Side, y: &Side) -> bool {
        let (x_axis, y_axis) = (&self.grid.x, &self.grid.y);
        let (x0, x1) = if x.d < 0 { (x.lo.wrapping_add(x.d), x.hi) } else { (x.lo, x.hi.wrapping_add(x.d)) };
        let (y0, y1) = if y.d < 0 { (y.lo.wrapping_add(y.d), y.hi) } else { (y.lo, y.hi.wrapping_add(y.d)) };
        x0 >= x_axis.origin
            && y0 >= y_axis.origin
            && x1.wrapping_sub(x_axis.origin) < x_axis.size
            && y1.wrapping_sub(y_axis.origin) < y_axis.size
    }

    /// The cell of the trailing end.
    #[inline(never)]
    const fn edge(&self, side: &Side, rows: bool) -> Edge {
        let axis = if rows { &self.grid.y } else { &self.grid.x };
        let forth = side.d >= 0;
        let at = if forth { side.lo } else { side.hi };
        let index = self.grid.index(at, axis);
        let border = axis.origin.wrapping_add(self.grid.line(index));
        if forth {
            let gap = border.wrapping_add(self.grid.cell).wrapping_sub(at);
            Edge { index, step: 1, last: axis.count as i32, gap }
        } else {
            Edge { index, step: -1, last: -1, gap: at.wrapping_sub(border) }
        }
    }

    /// Goes to the next strip of a way that has one.
    ///
    /// While the body is in the strip, its trailing end goes from where it is when the front comes
    /// in, and its leading end to where it is when the rear leaves.
    #[inline(never)]
    pub(in crate::world) const fn next_strip(&self, way: &mut Way) {
        let cell = self.grid.cell;
        way.is_first = way.from < 0;
        let before = way.aside(way.from.wrapping_add(way.lag));
        let Edge { mut index, step, last, mut gap } = way.strip;
        let from = index.wrapping_add(step);
        loop {
            (index, gap) = (index.wrapping_add(step), gap.wrapping_add(cell));
            way.goes_on = gap < way.length && index != last;
            // The first strip is all that the body is in at the start.
            if gap >= 0 || !way.goes_on {
                break;
            }
        }
        (way.strip.index, way.strip.gap, way.from) = (index, gap, gap);
        // Where the grid ends, the last strip has no far border.
        let after = if way.goes_on { gap.wrapping_add(way.rear) } else { way.length };
        let after = way.aside(after);
        let ((a, a_gap), (b, b_gap)) = (way.trail.after(before, cell), way.lead.after(after, cell));
        (way.trail.index, way.trail.gap, way.lead.index, way.lead.gap) = (a, a_gap, b, b_gap);
        let (a, b) = if a < b { (a, b) } else { (b, a) };
        let (p, q) = (from, index);
        let (p, q) = if p < q { (p, q) } else { (q, p) };
        let (x0, x1, y0, y1) = if way.rows { (a, b, p, q) } else { (p, q, a, b) };
        if way.in_map {
            way.width = x1.wrapping_sub(x0).wrapping_add(1);
            (way.tile, way.count) = (self.place(x0, y0), way.width);
            (way.last_x, way.y, way.last_y) = (x1, y0, y1);
        } else {
            way.cells = Cells::of(self.solid_range(Range { x0, y0, x1, y1 }));
        }
    }

    /// The next cell that holds something, before the next strip.
    #[inline]
    pub(in crate::world) const fn next_on_way(&self, way: &mut Way) -> Option<Block> {
        if !way.in_map {
            let block = self.next_cell(&mut way.cells);
            way.starts_beside |= way.is_first && block.is_some();
            return block;
        }
        let (mut tile, mut count) = (way.tile, way.count);
        loop {
            while count > 0 {
                let id = self.id_at(tile);
                (tile, count) = (tile.wrapping_add(1), count.wrapping_sub(1));
                if !self.kinds.is_empty(id) {
                    (way.tile, way.count) = (tile, count);
                    way.starts_beside |= way.is_first;
                    let x = way.last_x.wrapping_sub(count);
                    return Some(Block { x, y: way.y, kind: self.kinds.get(id) });
                }
            }
            if way.y >= way.last_y {
                way.count = 0;
                return None;
            }
            way.y = way.y.wrapping_add(1);
            count = way.width;
            tile = tile.wrapping_sub(count as u32).wrapping_add(self.stride as u32);
        }
    }
}
