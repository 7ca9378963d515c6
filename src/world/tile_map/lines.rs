//! Finds the first side of a cell that a moving box meets among blocks, line by line.
//!
//! A box enters a full cell only where its front reaches a line of the grid. At that moment the
//! cells behind the line that the box spans decide. Lines come in the order of time, so the first
//! one with a hit ends the search.

use super::{Outside, ShapeSet, Store, TileMap, merged};
use crate::num::Raw;
use crate::shape::Aabb;
use crate::world::cell::Range;
use crate::world::grid::GridAxis;
use crate::world::lines::{BlockHit, Lines, Sides};
use crate::world::tile_map::kind::TileKind;

/// One surface of sides in a line: the first of its cells, and the flags of all.
#[derive(Clone, Copy)]
struct LineSurface {
    /// The index of the cell along the line, or [`NOWHERE`].
    index: i32,
    flags: u8,
    one_way: bool,
    at_end: bool,
}

/// The index of no cell.
const NOWHERE: i32 = i32::MIN;

impl LineSurface {
    const NONE: Self = Self { index: NOWHERE, flags: 0, one_way: true, at_end: false };

    /// Solid wins over one-way, and then the smaller index. Cells come by their index.
    #[inline]
    const fn join(&mut self, index: i32, kind: TileKind) {
        self.flags |= kind.flags;
        if self.index == NOWHERE || (self.one_way && kind.is_full()) {
            (self.index, self.one_way) = (index, !kind.is_full());
        }
    }

    const fn is_none(self) -> bool {
        self.index == NOWHERE
    }
}

/// The parameters of the search for a side besides the geometry.
#[derive(Clone, Copy)]
#[expect(clippy::struct_excessive_bools, reason = "facts that are independent of each other")]
struct Asked {
    /// Whether the line is across x.
    is_x: bool,
    /// Whether the box reaches a line of the other axis at the same moment.
    tie: bool,
    in_map: bool,
    pass_one_way: bool,
}

impl Asked {
    /// Whether a cell stops the motion over a line, if nothing covers its side.
    #[inline(never)]
    const fn is_stopped(self, kind: TileKind, step: i32) -> bool {
        match kind.one_way_side() {
            Some(side) => !self.pass_one_way && (side & 1 == 1) == self.is_x && (side == 0 || side == 3) == (step > 0),
            None => kind.is_full(),
        }
    }
}

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// The lines that a moving box reaches.
    pub(in crate::world) const fn lines(&self, bounds: &Aabb, d: Raw) -> Lines {
        let (lo, hi) = (bounds.lo(), bounds.hi());
        let inside = if lo.x < hi.x && lo.y < hi.y { self.range_inside(lo, hi) } else { None };
        let range = match inside {
            Some(range) => range,
            None => self.open_range(lo, hi),
        };
        let mut lines = Lines {
            x: self.sides((lo.x, hi.x), d.x, (range.x0, range.x1), &self.grid.x, 1),
            y: self.sides((lo.y, hi.y), d.y, (range.y0, range.y1), &self.grid.y, self.stride as i32),
            in_map: inside.is_some(),
        };
        let (to_x, to_y) = (d.x.wrapping_sub(self.grid.x.origin), d.y.wrapping_sub(self.grid.y.origin));
        let (x0, y0) = (lo.x.wrapping_add(to_x), lo.y.wrapping_add(to_y));
        let (x1, y1) = (hi.x.wrapping_add(to_x), hi.y.wrapping_add(to_y));
        if !lines.in_map || (x0 | y0 | self.grid.x.size.wrapping_sub(x1) | self.grid.y.size.wrapping_sub(y1)) < 0 {
            lines.in_map = false;
            lines.x.end_at_last();
            lines.y.end_at_last();
        }
        lines
    }

    #[inline(always)]
    const fn sides(
        &self,
        (lo, hi): (i32, i32),
        d: i32,
        (first, last): (i32, i32),
        axis: &GridAxis,
        stride: i32,
    ) -> Sides {
        let (start, end) = (lo.wrapping_sub(axis.origin), hi.wrapping_sub(axis.origin));
        let from = start.wrapping_sub(self.grid.line(first));
        let to = self.grid.line(last.wrapping_add(1)).wrapping_sub(end);
        // The cells are as long as what is before the box, the box, and what is after it.
        let all = self.grid.line(last.wrapping_sub(first)).wrapping_sub(end.wrapping_sub(start));
        if d < 0 {
            let far = from.wrapping_sub(all);
            Sides { way: d.wrapping_neg(), step: -1, lead: first, gap: from, rear: last, far, last: -1, stride }
        } else {
            let far = to.wrapping_sub(all);
            Sides { way: d, step: 1, lead: last, gap: to, rear: first, far, last: axis.count as i32, stride }
        }
    }

    /// Whether a box overlaps a full cell at the start of its motion.
    pub(in crate::world) fn starts_inside(&self, lines: &Lines, bounds: &Aabb) -> bool {
        if !lines.in_map {
            return self.overlaps(bounds);
        }
        let (x, y) = (&lines.x, &lines.y);
        let (x0, x1) = if x.step < 0 { (x.lead, x.rear) } else { (x.rear, x.lead) };
        let (y0, y1) = if y.step < 0 { (y.lead, y.rear) } else { (y.rear, y.lead) };
        self.any_full_in_map(Range { x0, y0, x1, y1 }, |_, _| true)
    }

    /// The hit at the next line that has one. Counts the lines.
    pub(in crate::world) fn next_block(
        &self,
        lines: &mut Lines,
        pass_one_way: bool,
        seen: &mut u32,
    ) -> Option<BlockHit> {
        loop {
            let next = lines.next()?;
            let Lines { x, y, in_map } = lines;
            let asked = Asked { is_x: true, tie: next.is_eq(), in_map: *in_map, pass_one_way };
            let (mut found, mut is_x) = (LineSurface::NONE, true);
            if next.is_le() {
                *seen = seen.wrapping_add(1);
                found = self.behind(x, y, asked);
            }
            if next.is_ge() {
                *seen = seen.wrapping_add(1);
                let other = self.behind(y, x, Asked { is_x: false, ..asked });
                // At the same moment, a side that is not hit at its end wins, then the side that
                // opposes the motion more, then the one across x.
                let goes_first = found.is_none()
                    || (!other.is_none() && if found.at_end == other.at_end { y.way > x.way } else { found.at_end });
                if goes_first {
                    (found, is_x) = (other, false);
                }
            }
            if !found.is_none() {
                return Some(self.block_hit(if is_x { x } else { y }, is_x, found));
            }
            let cell = self.grid.cell;
            if next.is_le() {
                (x.lead, x.gap) = x.after(x.lead, x.gap, cell);
            }
            if next.is_ge() {
                (y.lead, y.gap) = y.after(y.lead, y.gap, cell);
            }
        }
    }

    fn block_hit(&self, across: &Sides, is_x: bool, found: LineSurface) -> BlockHit {
        let LineSurface { index, flags, one_way, at_end } = found;
        let at = across.lead.wrapping_add(across.step);
        let (mut x, mut y) = if is_x { (at, index) } else { (index, at) };
        if let Outside::Edge = self.outside {
            // A border cell stands for all cells beyond it.
            (x, y) = (merged(x, self.grid.x.count), merged(y, self.grid.y.count));
        }
        BlockHit { x, y, flags, one_way, is_x, step: across.step, at_end, num: across.gap, den: across.way }
    }

    /// The side of the cells behind a line that the front reaches.
    #[inline(never)]
    fn behind(&self, across: &Sides, aside: &mut Sides, asked: Asked) -> LineSurface {
        // The rear, at the moment at which the front is at the line.
        while aside.far < aside.way && aside.compare(aside.far, across, across.gap).is_le() {
            (aside.rear, aside.far) = aside.after(aside.rear, aside.far, self.grid.cell);
        }
        if asked.tie || !asked.in_map {
            return self.behind_at_corner(across, aside, asked);
        }
        let (mut index, last) = if aside.step < 0 { (aside.lead, aside.rear) } else { (aside.rear, aside.lead) };
        let over = across.step.wrapping_mul(across.stride);
        let before = across.lead.wrapping_mul(across.stride).wrapping_add(index.wrapping_mul(aside.stride));
        let mut tile = before.wrapping_add(over) as u32;
        let mut found = LineSurface::NONE;
        while index <= last {
            let id = self.id_at(tile);
            if !self.kinds.is_empty(id) {
                let kind = self.kinds.get(id);
                let stops = kind.is_full() || asked.is_stopped(kind, across.step);
                if stops && !self.kinds.get(self.id_at(tile.wrapping_sub(over as u32))).is_full() {
                    found.join(index, kind);
                }
            }
            (index, tile) = (index.wrapping_add(1), tile.wrapping_add(aside.stride as u32));
        }
        found
    }

    /// [`behind`](Self::behind) for a box at a corner of cells, or for cells beyond the map.
    ///
    /// ```text
    ///            | B |       A: the last cell that the box spans. With a tie, its corner
    ///        +---+---+       is at the start of B. It enters B through the end of its side,
    ///        |   | A |       or, if that goes on along A, through the middle of a side.
    ///        |box|   |
    /// ```
    ///
    /// A box without an extent along the line, and on a line across, spans no cell. It is stopped
    /// where A's side continues along B, or at the end of B's side if it moves in that direction.
    #[inline(never)]
    fn behind_at_corner(&self, across: &Sides, aside: &Sides, asked: Asked) -> LineSurface {
        let beyond = aside.lead.wrapping_add(aside.step);
        let thin = aside.rear == beyond;
        let from = if thin { aside.lead } else { aside.rear };
        let to = if thin || asked.tie { beyond } else { aside.lead };
        let (mut index, last) = if aside.step < 0 { (to, from) } else { (from, to) };
        let at = across.lead.wrapping_add(across.step);
        let kind_of = |across: i32, aside: i32| {
            if asked.is_x { self.kind_at(across, aside) } else { self.kind_at(aside, across) }
        };
        let covered = |index: i32| kind_of(across.lead, index).is_full();
        // Whether the side of a cell goes on along another: solid along solid, and a one-way one
        // along all that blocks the same way.
        let goes_on = |one_way: bool, along: i32| {
            let kind = kind_of(at, along);
            kind.is_full() || (one_way && asked.is_stopped(kind, across.step) && !covered(along))
        };
        let (mut whole, mut end) = (LineSurface::NONE, LineSurface { at_end: true, ..LineSurface::NONE });
        while index <= last {
            let kind = kind_of(at, index);
            if asked.is_stopped(kind, across.step) && !covered(index) {
                let one_way = !kind.is_full();
                if index == beyond && !goes_on(one_way, aside.lead) {
                    if asked.tie {
                        end.join(index, kind);
                    }
                } else if index == beyond || !thin || goes_on(one_way, beyond) {
                    whole.join(index, kind);
                }
            }
            index = index.wrapping_add(1);
        }
        if whole.is_none() { end } else { whole }
    }
}
