//! The rare steps of a ray, each looking at all four cells around a crossing: at the start, in the solid, along a line, beyond the map.

use super::dda::{Axes, END, Met, Side, X, Y, along};
use super::line::BESIDE;
use crate::world::{Outside, Set, Store, TileKind, TileMap};

/// The start is inside: no face was met.
pub(in crate::world) const INSIDE: Met = 8;
/// The four cells at a line or corner, as seen by a ray: the one it is in, those across one line, and the one across both. A bit is set where
/// the cell is full. Across a single line, they are two cells twice.
type Around = u32;

const HERE: Around = 1;
const OVER_X: Around = 2;
const OVER_Y: Around = 4;
const AHEAD: Around = 8;
const ALL: Around = 15;

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

/// The face that is met across one of these axes, x first.
#[inline]
const fn met(around: Around, over: Axes) -> Met {
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

/// A ray on its way.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Detour {
    pub(in crate::world) x: Side,
    pub(in crate::world) y: Side,
    /// Cells entered.
    pub(in crate::world) cells: u32,
    /// The kind of the cell at the end.
    pub(in crate::world) kind: TileKind,
}

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// Goes on to the end, step by step, from the start or any later cell that is not full. Then the cell is the one that the face belongs to.
    #[cold]
    #[inline(never)]
    pub(in crate::world) fn detour(&self, w: &mut Detour, hits_inside: bool) -> Met {
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

    /// What is met at the start, where the cell ahead is full.
    #[inline]
    fn depart(&self, w: &mut Detour, hits_inside: bool) -> Met {
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
            // The line met last is one cell before the next: no distance.
            w.x.near = cell;
            w.y.near = cell;
            return INSIDE | if w.y.size > w.x.size { Y } else { X };
        }
        // Met is what the ray goes into, along a line into both cells; else it slides along the border.
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
    fn turn(&self, w: &mut Detour) -> Met {
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
    fn around(&self, w: &Detour, wide: Axes) -> Around {
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
    fn known(&self, index: i32, border: i32, count: u16) -> i32 {
        if matches!(self.outside, Outside::Edge) && index as u32 >= count as u32 { border } else { index }
    }
}
