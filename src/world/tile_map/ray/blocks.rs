//! A ray among full cells: a fast run over the open ones, and the rare steps that test four cells
//! at once.

use crate::num::{LONG, umul};
use crate::world::grid::GridAxis;
use crate::world::ray::walk::{Axes, Beyond, Lane, X, Y, along, lead};
use crate::world::tile_map::kind::{TileKind, TileShape};
use crate::world::tile_map::occupancy::AREA;
use crate::world::tile_map::{Outside, ShapeSet, Store, TileMap};

/// The end of a walk: the axis of the line whose face was met, or one of the constants of this
/// type, or both. 0 while it continues.
pub(in crate::world) type RayStop = u32;

/// The motion ends without a face.
pub(in crate::world) const END: RayStop = 16;

/// The start is inside: no face was met.
pub(super) const INSIDE: RayStop = 8;

/// The cell of the face is not the current one, but the one before it on the other axis.
const BESIDE: RayStop = 4;

/// The result of [`TileMap::run`].
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct BlockRun {
    pub(in crate::world) met: RayStop,
    /// The tile that was met.
    pub(in crate::world) id: u8,
    /// Lines crossed between columns and between rows.
    pub(in crate::world) kx: u32,
    pub(in crate::world) ky: u32,
    /// The lead, divided by the cell, where it ended without a face and was to be kept.
    pub(super) lead: i32,
}

impl BlockRun {
    /// Nowhere.
    pub(super) const NONE: Self = Self { met: 0, id: 0, kx: 0, ky: 0, lead: 0 };
}

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// Measures one axis of a ray.
    #[inline]
    pub(in crate::world) fn lane(&self, span: &GridAxis, o: i32, d: i32) -> Lane {
        self.grid.lane_with(span, o, d, |before, last| self.beyond(before, last))
    }

    /// The bands around the map count as cells; where the border of blocks is repeated, they are
    /// part of its cells.
    #[cold]
    #[inline(never)]
    fn beyond(&self, before: bool, last: i32) -> i32 {
        let band = !matches!(self.outer(), Beyond::Merged) as i32;
        if before { band.wrapping_neg() } else { last.wrapping_add(band) }
    }

    /// The tiles that a walk finds beyond the map.
    #[inline]
    pub(in crate::world) fn outer(&self) -> Beyond {
        match self.outside {
            Outside::Empty => Beyond::Nothing,
            Outside::Edge if !S::SHAPED => Beyond::Merged,
            _ => Beyond::Bands,
        }
    }

    /// Whether a ray starts inside the map, in the open, and not along a line: then
    /// [`run`](Self::run) can go ahead.
    #[inline]
    pub(in crate::world) fn runs(&self, x: &Lane, y: &Lane) -> bool {
        along(x, y, self.grid.cell as u32) == 0
            && self.holds(x.cell, y.cell)
            && !self.kinds.get(self.id(x.cell, y.cell)).is_full()
    }

    /// Walks to the next full cell, or, if `ANY`, to the next that is not empty, with one look-up
    /// per cell. It stops if the next line leads out of the map, or the motion ends, except with a
    /// corner ahead. `met` is then 0, and also if the next cell is unknown.
    ///
    /// The [lead] is divided by the cell: a crossing moves it by the other size. Divided evenly, 0
    /// is both lines at once: then the cells beside the corner come first, x before y. Else a floor
    /// of 0 is more than 0.
    #[inline(always)]
    pub(in crate::world) fn run<const ANY: bool>(&self, x: &Lane, y: &Lane) -> BlockRun {
        let Some((e, even)) = self.divided(lead(x, y)) else { return BlockRun::NONE };
        // What ends after some cells has no empty area to pass.
        if T::OCCUPIED && x.lines.wrapping_add(y.lines) > 2 * AREA {
            self.run_open::<ANY>(x, y, e, even)
        } else {
            self.run_from::<ANY, false>(x, y, e, even)
        }
    }

    /// [`run`](Self::run) with a lead that has been divided, and is kept if `KEEP`.
    #[inline(always)]
    pub(super) fn run_from<const ANY: bool, const KEEP: bool>(
        &self,
        x: &Lane,
        y: &Lane,
        mut e: i32,
        even: bool,
    ) -> BlockRun {
        if LONG && !even {
            return self.run_packed::<ANY, KEEP>(x, y, e);
        }
        let stride = self.stride as i32;
        let (px, py) = (x.step, y.step.wrapping_mul(stride));
        let mut tile = y.cell.wrapping_mul(stride).wrapping_add(x.cell);
        let (mut nx, mut ny) = (x.lines, y.lines);
        let mut id = 0;
        let met = loop {
            let before = e;
            if e < 0 {
                nx = nx.wrapping_sub(1);
                if nx < 0 {
                    nx = 0;
                    break END;
                }
                e = e.wrapping_add(y.size as i32);
                tile = tile.wrapping_add(px);
            } else {
                if e == 0 && even {
                    if nx == 0 || ny == 0 {
                        break 0;
                    }
                    let (Some((id_x, full_x)), Some((id_y, full_y))) = (
                        self.stop_at::<ANY>(tile.wrapping_add(px) as u32),
                        self.stop_at::<ANY>(tile.wrapping_add(py) as u32),
                    ) else {
                        break 0;
                    };
                    if full_x || !full_y {
                        nx = nx.wrapping_sub(1);
                    }
                    if full_x {
                        id = id_x;
                        break X;
                    }
                    ny = ny.wrapping_sub(1);
                    if full_y {
                        id = id_y;
                        break Y;
                    }
                    e = y.size.wrapping_sub(x.size) as i32;
                    tile = tile.wrapping_add(px).wrapping_add(py);
                    let Some((id_both, full)) = self.stop_at::<ANY>(tile as u32) else { break 0 };
                    if full {
                        id = id_both;
                        break X;
                    }
                    continue;
                }
                ny = ny.wrapping_sub(1);
                if ny < 0 {
                    ny = 0;
                    break END;
                }
                e = e.wrapping_sub(x.size as i32);
                tile = tile.wrapping_add(py);
            }
            let Some((found, full)) = self.stop_at::<ANY>(tile as u32) else { break 0 };
            if full {
                id = found;
                break if before < 0 { X } else { Y };
            }
        };
        BlockRun {
            met,
            id,
            kx: x.lines.wrapping_sub(nx) as u32,
            ky: y.lines.wrapping_sub(ny) as u32,
            lead: if KEEP { e } else { 0 },
        }
    }

    /// The id of the tile at a place in the data, and whether a run ends there; `None` does not
    /// happen.
    #[inline]
    pub(in crate::world) fn stop_at<const ANY: bool>(&self, tile: u32) -> Option<(u8, bool)> {
        let byte = *self.data.get(if T::BITS == 8 { tile } else { tile >> 3 } as usize)?;
        let id = if T::BITS == 8 { byte } else { byte >> (tile & 7) & 1 };
        let kind = self.kinds.get(id);
        Some((id, if ANY { !matches!(kind.shape, TileShape::Empty) } else { kind.is_full() }))
    }

    /// The floor of `e / cell`, and whether nothing was left over; `None` if it is not at least
    /// -2^30 and below 2^31. It is for the lead in a cell of the map, except in a border cell that
    /// stands for a band.
    #[inline]
    fn divided(&self, e: i64) -> Option<(i32, bool)> {
        let (cell, log) = (self.grid.cell as u32, self.grid.log & 31);
        if self.grid.magic == 0 {
            let q = e >> log;
            let even = e as u32 & cell.wrapping_sub(1) == 0;
            return if q as i32 as i64 == q { Some((q as i32, even)) } else { None };
        }
        // Made positive by 2^30 cells, it is below 2^31 cells and 2^(32 + log).
        let e = e.wrapping_add((cell as i64) << 30);
        let wide = e >> log;
        if wide as u32 as i64 != wide {
            return None;
        }
        // The multiplier is 2^(31 + log) / cell or less than one above: the candidate is less than
        // 2 off, dropped bits included.
        let mut q = ((umul(wide as u32, self.grid.magic) >> 31) as u32).wrapping_sub(2);
        let mut rest = (e as u32).wrapping_sub(q.wrapping_mul(cell));
        while rest >= cell {
            rest = rest.wrapping_sub(cell);
            q = q.wrapping_add(1);
        }
        if q < 3 << 30 { Some((q.wrapping_sub(1 << 30) as i32, rest == 0)) } else { None }
    }

    /// [`run`](Self::run) along a line that has cells of the map on both sides; two look-ups per
    /// step. `None` for other rays and, unless `ANY`, if the cell at the start is full.
    ///
    /// A face is met where a full cell follows one that is not, on the same side of the line. So a
    /// wall that the ray slides along has none.
    #[inline(never)]
    pub(in crate::world) fn run_along<const ANY: bool>(&self, x: &Lane, y: &Lane) -> Option<BlockRun> {
        let (stride, lines) = (self.stride as i32, along(x, y, self.grid.cell as u32));
        // The axis of the motion, the steps between tiles along it and to the other side, and the
        // first tile there.
        let (way, axis, step, across, other) = match lines {
            X => (y, Y, y.step.wrapping_mul(stride), x.step.wrapping_neg(), (x.cell.wrapping_sub(x.step), y.cell)),
            Y => (x, X, x.step, y.step.wrapping_mul(stride).wrapping_neg(), (x.cell, y.cell.wrapping_sub(y.step))),
            _ => return None,
        };
        if !self.holds(x.cell, y.cell) || !self.holds(other.0, other.1) {
            return None;
        }
        // A face cannot be in the cells at the start yet. So cells that may be solid are not read.
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
        Some(BlockRun { met, id: 0, kx, ky, lead: 0 })
    }
}

/// The four cells at a line or corner. For a ray they are the one it is in, those across one line,
/// and the one across both. A bit is set where the cell is full. Across a single line, they are two
/// cells twice.
type FourCells = u32;

const HERE: FourCells = 1;
const OVER_X: FourCells = 2;
const OVER_Y: FourCells = 4;
const AHEAD: FourCells = 8;
const ALL: FourCells = 15;

/// For each [`FourCells`], whether a face between columns is met (then one between rows): a full
/// cell behind one that is not.
const FACES: [u32; 2] = {
    let (mut faces, mut around) = ([0, 0], 0);
    while around < 16 {
        let (here, x, y, ahead) = (around & HERE != 0, around & OVER_X != 0, around & OVER_Y != 0, around & AHEAD != 0);
        faces[0] |= (((x && !here) || (ahead && !y)) as u32) << around;
        faces[1] |= (((y && !here) || (ahead && !x)) as u32) << around;
        around += 1;
    }
    faces
};

/// The face that is met across one of these axes, x first.
#[inline]
const fn met(around: FourCells, over: Axes) -> RayStop {
    let (axis, beside) = if FACES[0] >> around & over & X != 0 {
        (X, OVER_Y)
    } else if FACES[1] >> around & over >> 1 != 0 {
        (Y, OVER_X)
    } else {
        return 0;
    };
    // The face is before the cell ahead, unless that is not full or has a full one before it.
    if around & (AHEAD | beside) == AHEAD { axis } else { axis | BESIDE }
}

/// The state of a ray.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Detour {
    pub(in crate::world) x: Lane,
    pub(in crate::world) y: Lane,
    /// Cells entered.
    pub(in crate::world) cells: u32,
    /// The kind of the cell at the end.
    pub(in crate::world) kind: TileKind,
}

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// Walks to the end, step by step, from the start or any later cell that is not full. The cell
    /// is then the one to which the face belongs.
    #[cold]
    #[inline(never)]
    pub(in crate::world) fn detour(&self, w: &mut Detour, hits_inside: bool) -> RayStop {
        let mut met = 0;
        if let Some(run) = self.run_along::<false>(&w.x, &w.y) {
            let cell = self.grid.cell as u32;
            (w.x, w.y) = (w.x.crossed(run.kx, cell), w.y.crossed(run.ky, cell));
            w.cells = w.cells.wrapping_add(run.kx).wrapping_add(run.ky);
            met = run.met & !END;
        } else if self.kind_unless_edge(w.x.cell, w.y.cell).is_full() {
            met = self.depart(w, hits_inside);
        }
        while met == 0 {
            met = self.turn(w);
        }
        if met & BESIDE != 0 {
            let side = if met & X != 0 { &mut w.y } else { &mut w.x };
            side.cell = side.cell.wrapping_sub(side.step);
        }
        w.kind = self.kind_unless_edge(w.x.cell, w.y.cell);
        met
    }

    /// The hit at the start, where the cell ahead is full.
    #[inline]
    fn depart(&self, w: &mut Detour, hits_inside: bool) -> RayStop {
        let cell = self.grid.cell as u32;
        let (mut lines, mut motion) = (0, 0);
        if w.x.on_line(cell) {
            lines |= X;
        }
        if w.y.on_line(cell) {
            lines |= Y;
        }
        let mut around = self.around(w, lines);
        if around == ALL {
            if !hits_inside {
                return 0;
            }
            // The last line met is one cell before the next: no distance.
            w.x.near = cell;
            w.y.near = cell;
            return INSIDE | if w.y.size > w.x.size { Y } else { X };
        }
        // Stop is a cell that the ray goes into. Along a line it must go into both cells; otherwise
        // it slides along the border.
        let mut into = around;
        if w.x.size != 0 {
            motion |= X;
        } else {
            into &= around << 1;
        }
        if w.y.size != 0 {
            motion |= Y;
        } else {
            into &= around << 2;
        }
        if into & AHEAD == 0 {
            around = 0;
        }
        self::met(around, motion)
    }

    /// One step of any kind: over a line, over both at once, across the map's border or beyond it.
    #[inline]
    fn turn(&self, w: &mut Detour) -> RayStop {
        let over = self.grid.next_lines(&w.x, &w.y, self.outer());
        if over == 0 {
            return END;
        }
        let cell = self.grid.cell as u32;
        let wide = over | along(&w.x, &w.y, cell);
        w.x = w.x.crossed(over & X, cell);
        w.y = w.y.crossed(over >> 1, cell);
        w.cells = w.cells.wrapping_add(over & X).wrapping_add(over >> 1);
        met(self.around(w, wide), over)
    }

    /// The cells at the lines last crossed on these axes.
    #[inline(never)]
    #[expect(clippy::indexing_slicing, reason = "masked to the tables' lengths")]
    fn around(&self, w: &Detour, wide: Axes) -> FourCells {
        let mut columns = [w.x.cell; 2];
        if wide & X != 0 {
            columns[0] = self.known(w.x.cell.wrapping_sub(w.x.step), w.x.cell, self.grid.x.count);
        }
        let mut rows = [w.y.cell; 2];
        if wide & Y != 0 {
            rows[0] = self.known(w.y.cell.wrapping_sub(w.y.step), w.y.cell, self.grid.y.count);
        }
        let (mut around, mut i) = (0, 4usize);
        while i != 0 {
            i = i.wrapping_sub(1);
            around = around << 1 | self.kind_unless_edge(columns[i & 1], rows[i >> 1 & 1]).is_full() as u32;
        }
        around
    }

    /// The index of a cell, or that of the border cell beside it that stands for a band.
    #[inline]
    fn known(&self, index: i32, border: i32, count: u32) -> i32 {
        if matches!(self.outside, Outside::Edge) && index as u32 >= count { border } else { index }
    }
}
