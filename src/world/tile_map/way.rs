//! The cells that a body passes on a long straight motion, each once. They come in strips: column
//! after column, or row after row, whichever the motion crosses more of.

use super::{ShapeSet, Store, TileMap};
use crate::num::{Raw, mul_div};
use crate::shape::Aabb;
use crate::world::cell::{Block, Cells, Edge, Range, Way};

/// One axis of a body and its motion.
struct AxisMotion {
    lo: i32,
    hi: i32,
    d: i32,
}

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// The walk of a body whose core is rounded by `r`, before its first strip.
    ///
    /// At a slope s of at most 1, a disc reaches `r sqrt(1 + s^2) < r (1 + 7 s / 16)` aside of its
    /// centre's line, and its bounds `r (1 + s)`. So it is where bounds would be that start to
    /// reach aside 9/16 of the radius behind the front, and end so much earlier.
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    #[cfg_attr(not(target_pointer_width = "64"), inline(never))]
    pub(in crate::world) const fn way(&self, bounds: &Aabb, r: i32, d: Raw) -> Way {
        let (m, lo, hi) = (Way::MARGIN, bounds.lo(), bounds.hi());
        let x = AxisMotion { lo: lo.x.wrapping_sub(m), hi: hi.x.wrapping_add(m), d: d.x };
        let y = AxisMotion { lo: lo.y.wrapping_sub(m), hi: hi.y.wrapping_add(m), d: d.y };
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

    const fn holds_way(&self, x: &AxisMotion, y: &AxisMotion) -> bool {
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
    const fn edge(&self, side: &AxisMotion, rows: bool) -> Edge {
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

    /// Moves on to the next strip of a walk that has one.
    ///
    /// The cells of a strip reach from the trailing end of the body, when its front enters, to the
    /// leading end, when its rear leaves.
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    #[cfg_attr(not(target_pointer_width = "64"), inline(never))]
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
