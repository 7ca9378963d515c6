//! Which cells a query looks at.

use super::SegmentMap;
use crate::num::Raw;
use crate::world::grid::Span;
use crate::world::tile_map::range::Range;

impl SegmentMap<'_> {
    /// The cells that hold the points of a closed box, each point in one: where [`Grid::cell_at`](crate::Grid::cell_at) has it, and in the last
    /// cells what is on the far borders of the grid.
    ///
    /// That is enough to find what meets the box: a segment is referred to by every cell whose closed square it meets.
    pub(super) const fn cells(&self, lo: Raw, hi: Raw) -> Range {
        let (x0, x1) = along(&self.grid.x, lo.x, self.grid.column(lo.x), self.grid.column(hi.x));
        let (y0, y1) = along(&self.grid.y, lo.y, self.grid.row(lo.y), self.grid.row(hi.y));
        Range { x0, y0, x1, y1 }
    }

    /// [`cells`](Self::cells) of a box without its borders, for a box with area.
    pub(super) const fn open_cells(&self, lo: Raw, hi: Raw) -> Range {
        self.cells(lo, Raw { x: hi.x.wrapping_sub(1), y: hi.y.wrapping_sub(1) })
    }
}

/// The first and the last cell of the grid from `first` to `last`; none where the box begins beyond the end.
const fn along(span: &Span, lo: i32, first: i32, last: i32) -> (i32, i32) {
    let count = span.count as i32;
    if first == count && lo.wrapping_sub(span.origin) > span.size {
        return (0, -1);
    }
    let end = count.wrapping_sub(1);
    let first = if first < end { first } else { end };
    (if first < 0 { 0 } else { first }, if last < end { last } else { end })
}
