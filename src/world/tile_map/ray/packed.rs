//! A run over open cells on 64-bit processors.

use super::blocks::{BlockRun, END};
use crate::world::ray::walk::{Lane, X, Y};
use crate::world::tile_map::{ShapeSet, Store, TileMap};

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// A [run](Self::run) where no corner can be met, with the lead and the tile in one register.
    /// The lead is above, so its sign is that of both. No tile of the map is before the first
    /// one, so the lower half never borrows from the lead.
    #[inline(always)]
    pub(super) fn run_packed<const ANY: bool, const KEEP: bool>(&self, x: &Lane, y: &Lane, e: i32) -> BlockRun {
        let stride = self.stride as i32;
        let packed = |lead: i64, tile: i32| (lead << 32).wrapping_add(tile as i64);
        let over_x = packed(y.size as i64, x.step);
        let over_y = packed(-(x.size as i64), y.step.wrapping_mul(stride));
        let mut state = packed(e as i64, y.cell.wrapping_mul(stride).wrapping_add(x.cell));
        let (mut nx, mut ny, mut id) = (x.lines, y.lines, 0);
        let met = loop {
            let axis = if state < 0 {
                nx = nx.wrapping_sub(1);
                if nx < 0 {
                    nx = 0;
                    break END;
                }
                state = state.wrapping_add(over_x);
                X
            } else {
                ny = ny.wrapping_sub(1);
                if ny < 0 {
                    ny = 0;
                    break END;
                }
                state = state.wrapping_add(over_y);
                Y
            };
            let Some((found, full)) = self.stop_at::<ANY>(state as u32) else { break 0 };
            if full {
                id = found;
                break axis;
            }
        };
        let (kx, ky) = (x.lines.wrapping_sub(nx) as u32, y.lines.wrapping_sub(ny) as u32);
        BlockRun { met, id, kx, ky, lead: if KEEP { (state >> 32) as i32 } else { 0 } }
    }
}
