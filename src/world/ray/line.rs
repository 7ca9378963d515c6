//! Rays that run along a line of the grid, so that they are in two cells at any time.

use super::dda::{END, Met, Run, Side, X, Y, along};
use crate::world::{Set, Store, TileMap};

/// The cell of the face is not the current one, but the one before it on the other axis.
pub(in crate::world) const BESIDE: Met = 4;

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// [`run`](Self::run) along a line that has cells of the map on both sides; two look-ups a step. `None` for other rays and, unless `ANY`, where the
    /// cell at the start is full.
    ///
    /// A face is met where a full cell follows one that is not, on the same side of the line: a wall that the ray slides along has none.
    #[inline(never)]
    pub(in crate::world) fn run_along<const ANY: bool>(&self, x: &Side, y: &Side) -> Option<Run> {
        let (stride, lines) = (self.stride as i32, along(x, y, self.grid.cell as u32));
        // The axis of the motion, the steps between tiles along it and to the other side, and the first tile there.
        let (way, axis, step, across, other) = match lines {
            X => (y, Y, y.step.wrapping_mul(stride), x.step.wrapping_neg(), (x.cell.wrapping_sub(x.step), y.cell)),
            Y => (x, X, x.step, y.step.wrapping_mul(stride).wrapping_neg(), (x.cell, y.cell.wrapping_sub(y.step))),
            _ => return None,
        };
        if !self.holds(x.cell, y.cell) || !self.holds(other.0, other.1) {
            return None;
        }
        // The cells at the start are where a face cannot be yet; of those that may hold anything nothing is asked.
        let (mut left, mut tile) = (way.lines, y.cell.wrapping_mul(stride).wrapping_add(x.cell));
        if !ANY {
            (left, tile) = (left.wrapping_add(1), tile.wrapping_sub(step));
        }
        let (mut full_here, mut full_beside) = (!ANY, !ANY);
        let met = loop {
            if left <= 0 {
                break END;
            }
            left = left.wrapping_sub(1);
            tile = tile.wrapping_add(step);
            if self.stop_at::<ANY>(tile as u32)?.1 {
                if full_here {
                    return None;
                }
                break axis;
            }
            let next_beside = self.stop_at::<ANY>(tile.wrapping_add(across) as u32)?.1;
            if next_beside && !full_beside {
                break axis | BESIDE;
            }
            (full_here, full_beside) = (false, next_beside);
        };
        let crossed = way.lines.wrapping_sub(left) as u32;
        let (kx, ky) = if axis == X { (crossed, 0) } else { (0, crossed) };
        Some(Run { met, id: 0, kx, ky })
    }
}
