//! How many solids contain the reference point of a cell.

use super::{Kind, SegmentMap};
use crate::num::Raw;

impl SegmentMap<'_> {
    /// The winding number of a cell's reference point, from that of the cell before it in the row (0 for the first one).
    ///
    /// ```text
    ///       ^ e          ^ e: +1 further left    The reference point R of a cell is its corner, moved right by an infinitesimal and
    ///   R---|---R   and  |       -1 right of e   up by a much smaller one. On the way from R to R there is what crosses the line
    ///                  solid left, y up          between the corners, the right one included and the left one not.
    /// ```
    ///
    /// All that crosses the line before a corner meets the closed square of the cell before it.
    pub(super) const fn next_winding(&self, x: i32, y: i32, before: i32) -> i32 {
        let left = Raw { x: self.grid.x.origin.wrapping_add(self.grid.line(x)), y: self.grid.line_y(y) };
        if x == 0 {
            return self.passed(0, y, left);
        }
        let cell = x.wrapping_sub(1);
        let start = Raw { x: left.x.wrapping_sub(self.grid.cell), ..left };
        before.wrapping_add(self.passed(cell, y, left)).wrapping_sub(self.passed(cell, y, start))
    }

    /// What the winding number changes by at segments of a cell that cross the height of `r` at `r` or before it, from left to right.
    ///
    /// Just above `r`, segments that end at its height from below are gone, and those that start there upward have begun. The
    /// slope of a segment moves its crossing by a part of the smaller infinitesimal only, so that one exactly at `r` has been passed.
    const fn passed(&self, x: i32, y: i32, r: Raw) -> i32 {
        let mut sum = 0i32;
        let mut refs = self.refs(x, y);
        while let Some(index) = refs.advance() {
            let seg = self.segment(index);
            let (before, after) = (seg.a.y <= r.y, seg.b().y <= r.y);
            if before == after || !matches!(seg.kind, Kind::Solid) {
                continue;
            }
            // Positive where r is on the left of the segment. Upward, that is not passed; downward it is.
            let side = Raw { x: seg.dir.x, y: seg.dir.y }.cross(r.sub(seg.a));
            if before && side <= 0 {
                sum = sum.wrapping_sub(1);
            } else if after && side >= 0 {
                sum = sum.wrapping_add(1);
            }
        }
        sum
    }
}
