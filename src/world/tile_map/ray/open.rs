//! A ray through open areas: if a map knows which areas are empty, one step passes each of them.

use super::blocks::{BlockRun, END};
use crate::world::ray::walk::{Beyond, Lane, X, Y};
use crate::world::tile_map::occupancy::{AREA, AREA_LOG};
use crate::world::tile_map::{ShapeSet, Store, TileMap};

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// [`run_from`](Self::run_from) that passes empty areas: pieces of it, each as far as into the
    /// next area.
    #[inline(never)]
    pub(super) fn run_open<const ANY: bool>(&self, x: &Lane, y: &Lane, mut e: i32, even: bool) -> BlockRun {
        let (mut u, mut v, cell) = (*x, *y, self.grid.cell as u32);
        // Most rays end near their start, so a ray that begins among tiles first walks a whole
        // area: a piece costs as much as some cells.
        let mut ahead = AREA;
        loop {
            let before = (u.lines, v.lines);
            let (lead, is_over) = self.pass(&mut u, &mut v, e, even);
            if (u.lines, v.lines) != before {
                ahead = 0;
            }
            if is_over && !ANY && matches!(self.outer(), Beyond::Nothing) {
                return BlockRun { met: END, ..BlockRun::NONE };
            }
            e = lead;
            let run = self.run_from::<ANY, true>(&beyond_border(&u, ahead), &beyond_border(&v, ahead), e, even);
            ahead = 0;
            (u, v, e) = (u.crossed(run.kx, cell), v.crossed(run.ky, cell), run.lead);
            // If a piece could not go on, its end is the end of the whole.
            if run.met & (X | Y) != 0 || (u.lines, v.lines) == before {
                let (kx, ky) = (x.lines.wrapping_sub(u.lines) as u32, y.lines.wrapping_sub(v.lines) as u32);
                return BlockRun { kx, ky, ..run };
            }
        }
    }

    /// Walks through empty areas, to where the next line leads out of the last of them. The new
    /// lead is returned, and whether the motion ends, or leaves the map, in one.
    ///
    /// ```text
    ///   +-------+-------+-------+     Each step is over a border of an area, which is a line of cells too: the lead of the next two
    ///   |  o_   |       |       |     borders says which comes first. The last step is taken back: of the other axis, only the lines
    ///   |    `-_|       |#      |     that come before it are crossed (`x`).
    ///   +-------+`-_----+-------+
    ///   |       |   `-x_|  #    |
    /// ```
    ///
    /// A corner of areas is left to be looked at. Bits: a lead divided by a cell is below 2^31, and
    /// sizes times the side of an area below 2^35.
    #[inline]
    fn pass(&self, x: &mut Lane, y: &mut Lane, e: i32, even: bool) -> (i32, bool) {
        let (areas, stride) = self.areas();
        let (mut column, mut row) = (x.cell >> AREA_LOG, stride.wrapping_mul(y.cell >> AREA_LOG));
        let is_empty = |column: i32, row: i32| {
            let word = areas.get(row.wrapping_add(column >> 5) as usize);
            word.is_some_and(|word| word >> (column & 31) & 1 == 0)
        };
        if !is_empty(column, row) {
            return (e, false);
        }
        let (sx, sy) = (x.size as i64, y.size as i64);
        let (first_x, first_y) = (to_border(x), to_border(y));
        let mut lead = (e as i64).wrapping_add((first_x as i64 - 1) * sy).wrapping_sub((first_y as i64 - 1) * sx);
        // How many borders are in the motion and in the map.
        let (most_x, most_y) = (borders(x, first_x), borders(y, first_y));
        let (mut left_x, mut left_y) = (most_x, most_y);
        let (step_x, step_y) = (x.step, y.step.wrapping_mul(stride));
        let (far_x, far_y) = (sy << AREA_LOG, sx << AREA_LOG);
        let corner = if even { 0 } else { i64::MIN };
        let (mut last_is_x, mut is_over) = (None, false);
        loop {
            let is_x = lead < 0;
            if is_x {
                if left_x == 0 {
                    is_over = true;
                    break;
                }
                left_x = left_x.wrapping_sub(1);
                column = column.wrapping_add(step_x);
                lead = lead.wrapping_add(far_x);
            } else {
                if left_y == 0 || lead == corner {
                    is_over = lead != corner;
                    break;
                }
                left_y = left_y.wrapping_sub(1);
                row = row.wrapping_add(step_y);
                lead = lead.wrapping_sub(far_y);
            }
            last_is_x = Some(is_x);
            if !is_empty(column, row) {
                break;
            }
        }
        let Some(is_x) = last_is_x else { return (e, is_over) };
        let mut kx = (most_x.wrapping_sub(left_x) << AREA_LOG).wrapping_add(first_x).wrapping_sub(1);
        let mut ky = (most_y.wrapping_sub(left_y) << AREA_LOG).wrapping_add(first_y).wrapping_sub(1);
        if is_x {
            (kx, lead) = (kx.wrapping_sub(AREA), lead.wrapping_sub(far_x));
            while ky > 0 && (lead.wrapping_add(sx) < 0 || (lead.wrapping_add(sx) == 0 && even)) {
                (ky, lead) = (ky.wrapping_sub(1), lead.wrapping_add(sx));
            }
        } else {
            (ky, lead) = (ky.wrapping_sub(AREA), lead.wrapping_add(far_y));
            while kx > 0 && lead >= sy {
                (kx, lead) = (kx.wrapping_sub(1), lead.wrapping_sub(sy));
            }
        }
        // Beyond the end of the motion, or of the map, there is nothing to pass.
        if kx > x.lines || ky > y.lines {
            return (e, is_over);
        }
        let cell = self.grid.cell as u32;
        (*x, *y) = (x.crossed(kx as u32, cell), y.crossed(ky as u32, cell));
        (lead as i32, is_over)
    }
}

/// How many lines lead to another area, the last of them included.
#[inline]
fn to_border(lane: &Lane) -> i32 {
    let place = lane.cell & (AREA - 1);
    if lane.step > 0 { AREA.wrapping_sub(place) } else { place.wrapping_add(1) }
}

/// How many of the lines ahead are borders of areas, of which the first is known.
#[inline]
fn borders(lane: &Lane, first: i32) -> i32 {
    let beyond = lane.lines.wrapping_sub(first);
    if beyond < 0 { 0 } else { (beyond >> AREA_LOG).wrapping_add(1) }
}

/// With no more lines than to the next area, and some more.
#[inline]
fn beyond_border(lane: &Lane, by: i32) -> Lane {
    Lane { lines: lane.lines.min(to_border(lane).wrapping_add(by)), ..*lane }
}
