//! All pairs of bodies in lists of cells.
//!
//! The bodies of a cell are tested against five lists: what follows them in their own, and the whole lists of half of the eight neighbours. Of two
//! neighbours one has the other in its half, so every pair is met once.
//!
//! ```text
//!  .  .  .       0: its own, from the body on
//!  .  0  1       numbers of cells grow to the right and down
//!  2  3  4
//! ```

use super::lists::Lists;
use crate::broad::cursor::Meter;
use crate::broad::table::{Bodies, NIL, touch};
use crate::broad::{Pair, PairCursor, PairsError, Tag};

/// How neighbours of a cell are named.
#[derive(Clone, Copy, Debug)]
pub(in crate::broad) struct Near {
    /// From a cell to the one in the next row.
    pub(in crate::broad) stride: usize,
    /// Bits of a name that count.
    pub(in crate::broad) mask: usize,
}

/// In `row` of a cursor: the cells are done, the large bodies are next.
const CELLS_DONE: u16 = NIL;

/// First the pairs of bodies in cells, then where there can be `LARGE` ones theirs.
#[inline]
pub(in crate::broad) fn pairs<T: Tag, M: Meter, const LARGE: bool>(
    bodies: Bodies<'_, T>,
    lists: Lists<'_>,
    near: Near,
    cursor: &mut PairCursor,
    meter: &mut M,
    each: impl FnMut(Pair) -> bool,
) -> Result<(), PairsError> {
    let mut walk = Walk { bodies, lists, meter, each };
    if !LARGE || cursor.row != CELLS_DONE {
        walk.in_cells(near, cursor)?;
    }
    if LARGE {
        if cursor.row != CELLS_DONE {
            (cursor.row, cursor.a, cursor.b) = (CELLS_DONE, 0, 0);
        }
        walk.large_ones(cursor)?;
    }
    *cursor = PairCursor::new();
    Ok(())
}

/// Bodies while pairs are looked for.
struct Walk<'a, T, M, F> {
    bodies: Bodies<'a, T>,
    lists: Lists<'a>,
    meter: &'a mut M,
    each: F,
}

impl<T: Tag, M: Meter, F: FnMut(Pair) -> bool> Walk<'_, T, M, F> {
    /// The cursor: `row` is the cell; `a` the body, `lane` one more than the list it is tested against, and `b` the next body there; with `lane` 0 the cell was not begun.
    ///
    /// A body that was removed touches nothing, wherever the cursor stands, and what followed it in its list is still reached from it.
    #[inline(always)]
    fn in_cells(&mut self, near: Near, cursor: &mut PairCursor) -> Result<(), PairsError> {
        let first = usize::from(cursor.row);
        if cursor.lane != 0 {
            let resumed = (usize::from(cursor.a), usize::from(cursor.lane - 1), usize::from(cursor.b));
            self.cell(near, first, resumed).map_err(|stop| stop.keep(first, cursor))?;
        }
        // A cell that was begun is done.
        let first = first + usize::from(cursor.lane != 0);
        if self.lists.occupied.is_empty() {
            for (cell, &head) in self.lists.heads.iter().enumerate().skip(first).filter(|&(_, &head)| head != NIL) {
                self.cell(near, cell, self.lists.begin(head)).map_err(|stop| stop.keep(cell, cursor))?;
            }
            return Ok(());
        }
        let mut before = u32::MAX << (first & 31);
        for (block, word) in self.lists.occupied.iter().enumerate().skip(first >> 5) {
            let mut bits = word & before;
            before = u32::MAX;
            while bits != 0 {
                let cell = block << 5 | bits.trailing_zeros() as usize;
                bits &= bits - 1;
                let head = self.lists.head(cell);
                self.cell(near, cell, self.lists.begin(head)).map_err(|stop| stop.keep(cell, cursor))?;
            }
        }
        Ok(())
    }

    /// The bodies of a cell against their lists: from a body, a list and a body there on.
    #[inline(always)]
    fn cell(
        &mut self,
        near: Near,
        cell: usize,
        (mut i, mut lane, mut from): (usize, usize, usize),
    ) -> Result<(), Stop> {
        let bounds = self.bodies.bounds;
        // As long as the boxes, so that one comparison is enough for both.
        let Some(next) = self.lists.next.get(..bounds.len()) else { return Ok(()) };
        let head = |step| self.lists.head((cell + step) & near.mask);
        // The three of the next row are beside each other, but for a few cells at the end.
        let below = (cell + near.stride - 1) & near.mask;
        let [left, middle, right] = match self.lists.heads.get(below..).and_then(<[u16]>::first_chunk) {
            Some(&three) => three,
            None => [head(near.stride - 1), head(near.stride), head(near.stride + 1)],
        };
        let neighbours = [NIL, head(1), left, middle, right];
        // NIL, the end of a list, is the slot of none.
        while let (Some(a), Some(&after)) = (bounds.get(i), next.get(i)) {
            loop {
                while let (Some(b), Some(&then)) = (bounds.get(from), next.get(from)) {
                    if !self.meter.spend() {
                        return Err(Stop { i, lane, from, why: PairsError::BudgetExceeded });
                    }
                    // Of two cells above each other most boxes fail here.
                    if b.lo().y <= a.hi().y && touch(a, b) && !self.meet(i, from) {
                        return Err(Stop { i, lane, from, why: PairsError::Full });
                    }
                    from = usize::from(then);
                }
                lane += 1;
                let Some(&first) = neighbours.get(lane) else { break };
                from = usize::from(first);
            }
            i = usize::from(after);
            (lane, from) = (0, usize::from(next.get(i).copied().unwrap_or(NIL)));
        }
        Ok(())
    }

    /// Two bodies that touch: whether there was room for them, if they are a pair.
    #[inline(never)]
    fn meet(&mut self, i: usize, j: usize) -> bool {
        self.bodies.pair(i, j).is_none_or(&mut self.each)
    }

    /// Each body that is too large for a cell against all others, two of a kind once. The cursor: `a` is the body, `b` how many are done.
    fn large_ones(&mut self, cursor: &mut PairCursor) -> Result<(), PairsError> {
        let mut done = usize::from(cursor.b);
        let all = self.bodies.bounds.iter().zip(self.lists.cell).enumerate();
        for (i, (a, _)) in all.clone().skip(usize::from(cursor.a)).filter(|&(_, (_, &cell))| cell == NIL) {
            for (j, (b, _)) in all.clone().skip(done).filter(|&(j, (_, &cell))| cell != NIL || j > i) {
                let why = if !self.meter.spend() {
                    PairsError::BudgetExceeded
                } else if !touch(a, b) || self.meet(i, j) {
                    continue;
                } else {
                    PairsError::Full
                };
                (cursor.a, cursor.b) = (i as u16, j as u16);
                return Err(why);
            }
            done = 0;
        }
        Ok(())
    }
}

/// Where and why a walk stops.
struct Stop {
    i: usize,
    lane: usize,
    from: usize,
    why: PairsError,
}

impl Stop {
    #[cold]
    fn keep(self, cell: usize, cursor: &mut PairCursor) -> PairsError {
        (cursor.row, cursor.a, cursor.lane, cursor.b) =
            (cell as u16, self.i as u16, self.lane as u8 + 1, self.from as u16);
        self.why
    }
}
