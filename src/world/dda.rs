//! The walk of a ray over the cells: which grid line it crosses next, exactly and without division, until it enters the solid.

use super::{Outside, Set, Store, TileMap};
use crate::num::umul;

/// One axis of a ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    /// The index of the first cell: the one just ahead, where the start is on a line.
    start: i32,
    /// 1 or -1; -1 where there is no motion.
    step: i32,
    /// Distance from the start to the first line after it, where there is one: below 2^30 + 2^24.
    near: u32,
    /// At least the number of lines ahead, up to the end, as far as the map and the bands around it have lines.
    lines: u32,
    /// The size of the motion, below 2^30.
    pub(super) size: u32,
    /// Lines crossed.
    pub(super) crossed: u32,
    /// Whether the start is on a line, so that it touches the cell before the first one too.
    pub(super) on_line: bool,
}

impl Side {
    /// A coordinate moved along the ray.
    #[inline]
    pub(super) fn ahead(&self, v: i32, by: u32) -> i32 {
        v.wrapping_add(self.step.wrapping_mul(by as i32))
    }

    /// The index of the current cell.
    #[inline]
    pub(super) fn cell(&self) -> i32 {
        self.ahead(self.start, self.crossed)
    }

    /// The index of the cell before, as seen from the current one.
    #[inline]
    pub(super) fn before(&self) -> i32 {
        self.cell().wrapping_sub(self.step)
    }

    /// The sign of a normal that opposes the ray.
    #[inline]
    pub(super) fn opposed(&self) -> i32 {
        self.step.wrapping_neg()
    }

    /// Distance from the start to the line crossed last; a start on a line has crossed that.
    #[inline]
    pub(super) fn distance(&self, cell: u32) -> u32 {
        self.near.wrapping_sub(cell).wrapping_add(self.crossed.wrapping_mul(cell))
    }

    /// At least the number of lines still ahead.
    #[inline]
    fn left(&self) -> u32 {
        self.lines.wrapping_sub(self.crossed)
    }
}

/// Columns, then rows.
pub(super) type Sides = [Side; 2];

/// A set of axes: 1 for columns, 2 for rows.
pub(super) type Axes = u32;

pub(super) const X: Axes = 1;
pub(super) const Y: Axes = 2;

/// The four cells at a line or corner, as seen by a ray: the one it is in, those across one line, and the one across both. A bit is set where
/// the cell is full. Across a single line, they are two cells twice.
pub(super) type Around = u32;

pub(super) const HERE: Around = 1;
pub(super) const OVER_X: Around = 2;
pub(super) const OVER_Y: Around = 4;
pub(super) const AHEAD: Around = 8;
pub(super) const ALL: Around = 15;

/// What [`TileMap::turn`] adds to [`Around`]: above this, the axis of a face that opposes the ray, as [`Axes`].
pub(super) const FACE: u32 = 4;
/// The end of the motion.
pub(super) const END: u32 = 1 << 8;

/// For each [`Around`], whether a face between columns is met (then one between rows): a full cell behind one that is not.
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

/// The cells, and above them the face that is met across one of these axes, x first.
#[inline]
pub(super) const fn met(around: Around, over: Axes) -> u32 {
    let x = FACES[0] >> around & over & X;
    let y = (FACES[1] >> around << 1) & over & Y;
    around | (if x != 0 { x } else { y }) << FACE
}

/// The difference of the times of the next two crossings times both sizes: below 2^61.
#[inline(never)]
fn lead([x, y]: &Sides, cell: u32) -> i64 {
    let next = |side: &Side| side.distance(cell).wrapping_add(cell);
    umul(next(x), y.size).wrapping_sub(umul(next(y), x.size)) as i64
}

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// Measures one axis of a ray from `u`, a distance from the map's origin.
    #[inline(never)]
    pub(super) fn side(&self, u: i32, d: i32, extent: i32, count: u16) -> Side {
        // The bands around the map count as cells; where the border is repeated, they are part of its cells.
        let edge = matches!(self.outside, Outside::Edge) as i32;
        let (first, last) = (edge.wrapping_sub(1), (count as i32).wrapping_sub(edge));
        // Toward smaller coordinates (no motion is counted so), a point on a line belongs to the cell before.
        let v = if d <= 0 { u.wrapping_sub(1) } else { u };
        let start = if v < 0 {
            first
        } else if v >= extent {
            last
        } else {
            self.grid.quotient(v as u32) as i32
        };
        let into = v.wrapping_sub(self.grid.line(start));
        let (step, near, room, behind) = if d <= 0 {
            (-1, into.wrapping_add(1), start.wrapping_sub(first), last.wrapping_sub(start))
        } else {
            (1, self.grid.cell.wrapping_sub(into), last.wrapping_sub(start), start.wrapping_sub(first))
        };
        let (near, size) = (near as u32, d.unsigned_abs());
        let mut lines = 0;
        // By a power of two that the cell is not below: never too few. Without room ahead `near` is of no line, and 0 is right too.
        if size >= near {
            lines = (size >> (self.grid.log & 31)).wrapping_add(1);
            lines = if lines < room as u32 { lines } else { room as u32 };
        }
        let on_line = near == self.grid.cell as u32 && behind != 0;
        Side { start, step, near, lines, size, crossed: 0, on_line }
    }

    /// The cells at the lines last crossed on these axes.
    #[inline(never)]
    pub(super) fn around(&self, [x, y]: &Sides, wide: Axes) -> Around {
        let columns = [if wide & X == 0 { x.cell() } else { x.before() }, x.cell()];
        let rows = [if wide & Y == 0 { y.cell() } else { y.before() }, y.cell()];
        let (mut around, mut i) = (0, 4usize);
        while i != 0 {
            i -= 1;
            around = around << 1 | self.solid(columns[i & 1], rows[i >> 1 & 1]) as u32;
        }
        around
    }

    /// One step of any kind: over a line, over both at once, across the map's border or beyond it. `along`: axes on whose lines the ray runs,
    /// so that it is in two cells at any time.
    #[inline(never)]
    pub(super) fn turn(&self, sides: &mut Sides, along: Axes) -> u32 {
        let e = lead(sides, self.grid.cell as u32);
        let [x, y] = sides;
        let mut lines = 0;
        if x.lines != x.crossed {
            lines |= X;
        }
        if y.lines != y.crossed {
            lines |= Y;
        }
        let next = if e < 0 {
            X
        } else if e == 0 {
            X | Y
        } else {
            Y
        };
        let mut over = lines & next;
        if over == 0 {
            // The motion ends before the next line; or the map's last column reaches to the end of the domain, so that only rows change
            // from here (or the other way round).
            if !matches!(self.outside, Outside::Edge) || lines == 0 {
                return END;
            }
            over = lines;
        }
        x.crossed = x.crossed.wrapping_add(over & X);
        y.crossed = y.crossed.wrapping_add(over >> 1);
        met(self.around(sides, over | along), over)
    }

    /// The steps inside the map and in the open: one look-up a cell, up to the border, the end, a corner or a full cell. Then:
    /// the axis of the line that was crossed, else 0.
    ///
    /// The [lead] is divided by the cell, so that a crossing moves it by the other size. That loses the tie alone, and what a floor
    /// of 0 does not decide is left to [`turn`](Self::turn).
    #[inline(never)]
    pub(super) fn run(&self, sides: &mut Sides) -> u32 {
        let cell = self.grid.cell as u32;
        let Some(mut e) = self.divided(lead(sides, cell)) else { return 0 };
        let [x, y] = sides;
        let (cx, cy) = (x.cell() as u32, y.cell() as u32);
        let (width, height) = (self.grid.width as u32, self.grid.height as u32);
        if cx >= width || cy >= height {
            return 0;
        }
        let room_x = if x.step < 0 { cx } else { width.wrapping_sub(1).wrapping_sub(cx) };
        let room_y = if y.step < 0 { cy } else { height.wrapping_sub(1).wrapping_sub(cy) };
        let (room_x, room_y) = (room_x.min(x.left()), room_y.min(y.left()));
        let (mut nx, mut ny) = (room_x, room_y);
        let (ex, ey) = (y.size as i32, x.size as i32);
        let stride = self.stride as u32;
        let (px, py) = (x.step as u32, if y.step < 0 { stride.wrapping_neg() } else { stride });
        let mut tile = cy.wrapping_mul(stride).wrapping_add(cx);
        let hit = loop {
            if e < 0 {
                if nx == 0 {
                    break 0;
                }
                nx = nx.wrapping_sub(1);
                e = e.wrapping_add(ex);
                tile = tile.wrapping_add(px);
                match self.full_at(tile) {
                    Some(false) => {}
                    _ => break X,
                }
            } else {
                if e == 0 || ny == 0 {
                    break 0;
                }
                ny = ny.wrapping_sub(1);
                e = e.wrapping_sub(ey);
                tile = tile.wrapping_add(py);
                match self.full_at(tile) {
                    Some(false) => {}
                    _ => break Y,
                }
            }
        };
        x.crossed = x.crossed.wrapping_add(room_x).wrapping_sub(nx);
        y.crossed = y.crossed.wrapping_add(room_y).wrapping_sub(ny);
        hit
    }

    /// Whether the tile at a place in the data is full; `None` does not happen.
    #[inline]
    fn full_at(&self, tile: u32) -> Option<bool> {
        let byte = if T::BITS == 8 { tile } else { tile >> 3 } as usize;
        let id = *self.data.get(byte)?;
        Some(self.kinds.get(if T::BITS == 8 { id } else { id >> (tile & 7) & 1 }).is_full())
    }

    /// The floor of `e / cell`, where it is at least -2^30 and below 2^31; that is so for the lead in a cell of the map, except in a
    /// border cell that stands for a band.
    #[inline]
    fn divided(&self, e: i64) -> Option<i32> {
        let (cell, log) = (self.grid.cell as u32, (self.grid.log & 31) as u32);
        // Made positive by 2^30 cells.
        let e = e.wrapping_add((cell as i64) << 30);
        let wide = e >> log;
        let mut q = wide as u32;
        if q as i64 != wide {
            return None;
        }
        if self.grid.magic != 0 {
            // The multiplier is 2^(31 + log) / cell or less than one above: the candidate is less than 2 off, dropped bits included.
            q = ((umul(q, self.grid.magic) >> 31) as u32).wrapping_sub(2);
            let mut rest = (e as u32).wrapping_sub(q.wrapping_mul(cell));
            while rest >= cell {
                rest = rest.wrapping_sub(cell);
                q = q.wrapping_add(1);
            }
        }
        if q < 3 << 30 { Some(q.wrapping_sub(1 << 30) as i32) } else { None }
    }
}
