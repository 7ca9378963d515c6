//! The walk of a ray over the open cells of a map: which grid line it crosses next, exactly and without division.

use super::walk::Beyond;
use crate::num::umul;
use crate::world::grid::{Grid, Span};
use crate::world::{Outside, Set, Store, TileMap, TileShape};

/// One axis of a ray on its way.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Side {
    /// The index of the cell: the one just ahead, where the ray is on a line. -1 and the count stand for the bands beyond the map.
    pub(in crate::world) cell: i32,
    /// 1 or -1; -1 where there is no motion.
    pub(in crate::world) step: i32,
    /// Distance from the start to the next line, where there is one: below 2^31.
    pub(in crate::world) near: u32,
    /// At least the number of lines ahead, up to the end, that have a cell of the map behind them.
    pub(in crate::world) lines: i32,
    /// The size of the motion, below 2^30.
    pub(in crate::world) size: u32,
}

impl Side {
    /// A coordinate moved along the ray.
    #[inline]
    pub(in crate::world) fn ahead(&self, v: i32, by: u32) -> i32 {
        v.wrapping_add(self.step.wrapping_mul(by as i32))
    }

    /// After `n` more lines.
    #[inline]
    pub(in crate::world) fn crossed(self, n: u32, cell: u32) -> Self {
        let near = self.near.wrapping_add(n.wrapping_mul(cell));
        Self { cell: self.ahead(self.cell, n), near, lines: self.lines.wrapping_sub(n as i32), ..self }
    }

    /// At the start, and always where there is no motion: whether that is on a line, so that it touches the cell before the first one too.
    /// True for some starts in a band as well, where both cells are beyond the map.
    #[inline]
    pub(in crate::world) fn on_line(&self, cell: u32) -> bool {
        self.near == cell
    }
}

/// A set of axes: 1 for the lines between columns, 2 for those between rows.
pub(in crate::world) type Axes = u32;

pub(in crate::world) const X: Axes = 1;
pub(in crate::world) const Y: Axes = 2;

/// Where a walk ended: the axis of the line whose face was met, or one of the constants of this type, or both; 0 where it goes on.
pub(in crate::world) type Met = u32;

/// The motion ends without a face.
pub(in crate::world) const END: Met = 16;

/// The difference of the times of the next two crossings times both sizes: below 2^61.
#[inline]
pub(in crate::world) fn lead(x: &Side, y: &Side) -> i64 {
    umul(x.near, y.size).wrapping_sub(umul(y.near, x.size)) as i64
}

/// Axes on whose lines the ray runs, so that it is in two cells at any time.
#[inline]
pub(in crate::world) fn along(x: &Side, y: &Side, cell: u32) -> Axes {
    let columns = if x.size == 0 && x.on_line(cell) { X } else { 0 };
    columns | if y.size == 0 && y.on_line(cell) { Y } else { 0 }
}

/// The result of [`TileMap::run`].
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Run {
    pub(in crate::world) met: Met,
    /// The tile that was met.
    pub(in crate::world) id: u8,
    /// Lines crossed between columns and between rows.
    pub(in crate::world) kx: u32,
    pub(in crate::world) ky: u32,
}

impl Grid {
    /// Measures one axis of a ray, with what a cell beyond the grid (before it?, last cell) is called.
    #[inline]
    pub(in crate::world) fn side_with(
        &self,
        span: &Span,
        o: i32,
        d: i32,
        beyond: impl FnOnce(bool, i32) -> i32,
    ) -> Side {
        // A motion toward smaller coordinates (or none) is one toward larger ones in the mirror: a point on a line belongs to the cell ahead.
        let u = o.wrapping_sub(span.origin);
        let v = if d > 0 { u } else { span.size.wrapping_sub(u) };
        let last = (span.count as i32).wrapping_sub(1);
        let mut cell = self.quotient(v as u32) as i32;
        if v as u32 >= span.size as u32 {
            cell = beyond(v < 0, last);
        }
        let size = d.unsigned_abs();
        // By a power of two that the cell is not below, and rounded up: never too few.
        let some = (size >> (self.log & 31)).wrapping_add(1) as i32;
        let room = last.wrapping_sub(cell);
        Side {
            cell: if d > 0 { cell } else { room },
            step: if d > 0 { 1 } else { -1 },
            near: self.line(cell.wrapping_add(1)).wrapping_sub(v) as u32,
            lines: if some < room { some } else { room },
            size,
        }
    }
}

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// Measures one axis of a ray.
    #[inline]
    pub(in crate::world) fn side(&self, span: &Span, o: i32, d: i32) -> Side {
        self.grid.side_with(span, o, d, |before, last| self.beyond(before, last))
    }

    /// The bands around the map count as cells; where the border of blocks is repeated, they are part of its cells.
    #[cold]
    #[inline(never)]
    fn beyond(&self, before: bool, last: i32) -> i32 {
        let band = !matches!(self.outer(), Beyond::Merged) as i32;
        if before { band.wrapping_neg() } else { last.wrapping_add(band) }
    }

    /// What a walk finds beyond the map.
    #[inline]
    pub(in crate::world) fn outer(&self) -> Beyond {
        match self.outside {
            Outside::Empty => Beyond::Nothing,
            Outside::Edge if !S::SHAPED => Beyond::Merged,
            _ => Beyond::Bands,
        }
    }

    /// Whether a ray starts inside the map, in the open, and not along a line: then [`run`](Self::run) can go ahead.
    #[inline]
    pub(in crate::world) fn runs(&self, x: &Side, y: &Side) -> bool {
        along(x, y, self.grid.cell as u32) == 0
            && self.holds(x.cell, y.cell)
            && !self.kinds.get(self.id(x.cell, y.cell)).is_full()
    }

    /// Walks to the next full cell, or where `ANY` to the next that is not empty; one look-up a cell. Where the next line leads out of the map, or the motion is over, it ends, save with a
    /// corner ahead: `met` is 0 then, and so it is where it cannot tell what is next.
    ///
    /// The [lead] is divided by the cell, so that a crossing moves it by the other size. Divided evenly, 0 is both lines at once: then the
    /// cells beside the corner come first, x before y. Else a floor of 0 is more than 0.
    #[inline(always)]
    pub(in crate::world) fn run<const ANY: bool>(&self, x: &Side, y: &Side) -> Run {
        let Some((mut e, even)) = self.divided(lead(x, y)) else { return Run { met: 0, id: 0, kx: 0, ky: 0 } };
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
        Run { met, id, kx: x.lines.wrapping_sub(nx) as u32, ky: y.lines.wrapping_sub(ny) as u32 }
    }

    /// The id of the tile at a place in the data, and whether a run ends there; `None` does not happen.
    #[inline]
    pub(in crate::world) fn stop_at<const ANY: bool>(&self, tile: u32) -> Option<(u8, bool)> {
        let byte = *self.data.get(if T::BITS == 8 { tile } else { tile >> 3 } as usize)?;
        let id = if T::BITS == 8 { byte } else { byte >> (tile & 7) & 1 };
        let kind = self.kinds.get(id);
        Some((id, if ANY { !matches!(kind.shape, TileShape::Empty) } else { kind.is_full() }))
    }

    /// The floor of `e / cell`, and whether nothing was left over; `None` where it is not at least -2^30 and below 2^31. It is for the lead in a
    /// cell of the map, except in a border cell that stands for a band.
    #[inline]
    fn divided(&self, e: i64) -> Option<(i32, bool)> {
        let (cell, log) = (self.grid.cell as u32, (self.grid.log & 31) as u32);
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
        // The multiplier is 2^(31 + log) / cell or less than one above: the candidate is less than 2 off, dropped bits included.
        let mut q = ((umul(wide as u32, self.grid.magic) >> 31) as u32).wrapping_sub(2);
        let mut rest = (e as u32).wrapping_sub(q.wrapping_mul(cell));
        while rest >= cell {
            rest = rest.wrapping_sub(cell);
            q = q.wrapping_add(1);
        }
        if q < 3 << 30 { Some((q.wrapping_sub(1 << 30) as i32, rest == 0)) } else { None }
    }
}
