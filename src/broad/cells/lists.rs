//! Lists of the bodies of each cell, in arrays, and all pairs of bodies in them. 6 bytes per body,
//! 2 per cell, and one bit per cell: whether it has bodies.
//!
//! The bodies of a cell are tested against five lists. They are the rest of their own list, and the
//! whole lists of half of the eight neighbours. One of two neighbours has the other in its half, so
//! every pair is met once.
//!
//! ```text
//!  .  .  .       0: its own, from the body on
//!  .  0  1       numbers of cells grow to the right and down
//!  2  3  4
//! ```

use crate::broad::table::Meter;
use crate::broad::table::{Bodies, NIL, touch};
use crate::broad::{Pair, PairCursor, PairsError, Tag};

/// Links of N bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::broad) struct Links<const N: usize> {
    next: [u16; N],
    prev: [u16; N],
    cell: [u16; N],
    /// The first of the bodies that are too large for a cell; their cell is NIL.
    large: u16,
}

/// Lists, for reading.
#[derive(Clone, Copy, Debug)]
pub struct Lists<'a> {
    /// Empty if cells are not marked.
    pub(in crate::broad) occupied: &'a [u32],
    pub(in crate::broad) heads: &'a [u16],
    pub(in crate::broad) next: &'a [u16],
    pub(in crate::broad) cell: &'a [u16],
    pub(in crate::broad) large: u16,
}

/// Lists, for writing.
#[derive(Debug)]
pub struct ListsMut<'a> {
    occupied: &'a mut [u32],
    heads: &'a mut [u16],
    next: &'a mut [u16],
    prev: &'a mut [u16],
    cell: &'a mut [u16],
    large: &'a mut u16,
}

impl<const N: usize> Links<N> {
    /// A free slot must not have the cell NIL, or it would be tested as a large body.
    pub(in crate::broad) const fn new() -> Self {
        Self { next: [NIL; N], prev: [NIL; N], cell: [0; N], large: NIL }
    }

    #[inline]
    pub(in crate::broad) fn lists<'a>(&'a self, occupied: &'a [u32], heads: &'a [u16]) -> Lists<'a> {
        Lists { occupied, heads, next: &self.next, cell: &self.cell, large: self.large }
    }

    #[inline]
    pub(in crate::broad) fn lists_mut<'a>(&'a mut self, occupied: &'a mut [u32], heads: &'a mut [u16]) -> ListsMut<'a> {
        ListsMut {
            occupied,
            heads,
            next: &mut self.next,
            prev: &mut self.prev,
            cell: &mut self.cell,
            large: &mut self.large,
        }
    }

    /// The cells of all bodies.
    #[inline]
    pub(in crate::broad) fn cells(&self) -> &[u16] {
        &self.cell
    }
}

impl<'a> Lists<'a> {
    /// The cell of a body. A removed body keeps it until its slot is forgotten or taken again.
    #[inline]
    pub(in crate::broad) fn cell_of(&self, slot: usize) -> u16 {
        self.cell.get(slot).copied().unwrap_or(NIL)
    }

    /// Whether a removed body left links here, which an enumeration may still follow.
    #[cfg(feature = "serde")]
    pub(in crate::broad) fn has_links(&self, slot: usize) -> bool {
        self.cell_of(slot) != 0 || self.next.get(slot) != Some(&NIL)
    }

    /// The first body of a cell, or NIL.
    #[inline]
    pub(in crate::broad) fn head(&self, cell: usize) -> u16 {
        self.heads.get(cell).copied().unwrap_or(NIL)
    }

    /// A list from a first body on: that body, and those after it.
    #[inline]
    pub(in crate::broad) fn begin(&self, first: u16) -> (usize, usize, usize) {
        let first = usize::from(first);
        (first, 0, usize::from(self.next.get(first).copied().unwrap_or(NIL)))
    }

    /// The bodies of a list, from its first on.
    ///
    /// Lists have no cycles. The next body of a body in a list is in that list. A removed body
    /// keeps its next one; if that one was removed too, it was removed later.
    #[inline]
    pub(in crate::broad) fn from(&self, first: u16) -> impl Iterator<Item = usize> + use<'a> {
        let (next, mut body) = (self.next, first);
        core::iter::from_fn(move || {
            let slot = usize::from(body);
            body = *next.get(slot)?;
            Some(slot)
        })
    }
}

impl ListsMut<'_> {
    fn head_mut(&mut self, cell: u16) -> Option<&mut u16> {
        if cell == NIL { Some(self.large) } else { self.heads.get_mut(usize::from(cell)) }
    }

    /// Marks whether a cell has bodies. Does nothing for NIL, which is beyond all cells.
    fn mark(&mut self, cell: u16, occupied: bool) {
        if let Some(word) = self.occupied.get_mut(usize::from(cell >> 5)) {
            let bit = 1 << (cell & 31);
            *word = if occupied { *word | bit } else { *word & !bit };
        }
    }

    /// Puts a body into the list of a cell, or of large ones for NIL.
    pub(in crate::broad) fn link(&mut self, slot: usize, cell: u16) {
        let Some(head) = self.head_mut(cell) else { return };
        let first = core::mem::replace(head, slot as u16);
        set(self.prev, usize::from(first), slot as u16);
        set(self.next, slot, first);
        set(self.prev, slot, NIL);
        set(self.cell, slot, cell);
        self.mark(cell, true);
    }

    /// Takes a body out of its list. Its own links stay, because an enumeration may be there.
    pub(in crate::broad) fn unlink(&mut self, slot: usize) {
        let of = |links: &[u16]| links.get(slot).copied().unwrap_or(NIL);
        let (next, prev, cell) = (of(self.next), of(self.prev), of(self.cell));
        if prev != NIL {
            set(self.next, usize::from(prev), next);
        } else if let Some(head) = self.head_mut(cell) {
            *head = next;
            self.mark(cell, next != NIL);
        }
        set(self.prev, usize::from(next), prev);
    }

    /// Clears the links of a free slot, which is then like one that was never taken.
    pub(in crate::broad) fn forget(&mut self, slot: usize) {
        set(self.next, slot, NIL);
        set(self.prev, slot, NIL);
        set(self.cell, slot, 0);
    }
}

/// Sets a link. NIL is not a slot, and is ignored.
fn set(links: &mut [u16], slot: usize, to: u16) {
    if let Some(link) = links.get_mut(slot) {
        *link = to;
    }
}

/// How neighbours of a cell are numbered.
#[derive(Clone, Copy, Debug)]
pub struct Neighbours {
    /// From a cell to the one in the next row.
    pub(in crate::broad) stride: usize,
    /// The bits of a number that count.
    pub(in crate::broad) mask: usize,
}

/// In `row` of a cursor: the cells are done, the large bodies are next.
pub(in crate::broad) const CELLS_DONE: u16 = NIL;

/// Bodies while pairs are looked for.
pub(in crate::broad) struct PairWalk<'a, T, M, F> {
    pub(in crate::broad) bodies: Bodies<'a, T>,
    pub(in crate::broad) lists: Lists<'a>,
    pub(in crate::broad) meter: &'a mut M,
    pub(in crate::broad) each: F,
}

impl<T: Tag, M: Meter, F: FnMut(Pair) -> bool> PairWalk<'_, T, M, F> {
    /// Finds the pairs of bodies in cells.
    ///
    /// In the cursor, `row` is the cell, `a` the body, and `b` the next body of the list that it is
    /// tested against. `lane` is one more than the number of that list, or 0 if the cell was not
    /// begun.
    ///
    /// A removed body touches nothing, wherever the cursor is. The bodies after it in its list are
    /// still reached from it.
    #[inline(always)]
    pub(in crate::broad) fn in_cells(&mut self, near: Neighbours, cursor: &mut PairCursor) -> Result<(), PairsError> {
        let first = usize::from(cursor.row);
        if cursor.lane != 0 {
            let resumed = (usize::from(cursor.a), usize::from(cursor.lane - 1), usize::from(cursor.b));
            self.cell(near, first, resumed).map_err(|stop| stop.keep(first, cursor))?;
        }
        // A started cell is finished.
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

    /// Tests the bodies of a cell against their lists, from a body, a list and a body in that list
    /// on.
    #[inline(always)]
    fn cell(
        &mut self,
        near: Neighbours,
        cell: usize,
        (mut i, mut lane, mut from): (usize, usize, usize),
    ) -> Result<(), LaneStop> {
        let bounds = self.bodies.bounds;
        // As long as the boxes, so one comparison is enough for both.
        let Some(next) = self.lists.next.get(..bounds.len()) else { return Ok(()) };
        let head = |step| self.lists.head((cell + step) & near.mask);
        // The three cells of the next row are adjacent in memory, except for a few at the end.
        let below = (cell + near.stride - 1) & near.mask;
        let [left, middle, right] = match self.lists.heads.get(below..).and_then(<[u16]>::first_chunk) {
            Some(&three) => three,
            None => [head(near.stride - 1), head(near.stride), head(near.stride + 1)],
        };
        let neighbours = [NIL, head(1), left, middle, right];
        // NIL, the end of a list, is no slot.
        while let (Some(a), Some(&after)) = (bounds.get(i), next.get(i)) {
            loop {
                while let (Some(b), Some(&then)) = (bounds.get(from), next.get(from)) {
                    if !self.meter.spend() {
                        return Err(LaneStop { i, lane, from, why: PairsError::BudgetExceeded });
                    }
                    // For two cells above each other, most boxes fail here.
                    if b.lo().y <= a.hi().y && touch(a, b) && !self.meet(i, from) {
                        return Err(LaneStop { i, lane, from, why: PairsError::Full });
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

    /// Passes on two bodies that touch, if they are a pair. Returns whether there was room for
    /// them.
    #[inline(never)]
    fn meet(&mut self, i: usize, j: usize) -> bool {
        self.bodies.pair(i, j).is_none_or(&mut self.each)
    }

    /// Tests each body that is too large for a cell against all others, and two large bodies once.
    /// In the cursor, `a` is the body, and `b` the number of bodies that are done.
    pub(in crate::broad) fn large_ones(&mut self, cursor: &mut PairCursor) -> Result<(), PairsError> {
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
struct LaneStop {
    i: usize,
    lane: usize,
    from: usize,
    why: PairsError,
}

impl LaneStop {
    #[cold]
    fn keep(self, cell: usize, cursor: &mut PairCursor) -> PairsError {
        (cursor.row, cursor.a, cursor.lane, cursor.b) =
            (cell as u16, self.i as u16, self.lane as u8 + 1, self.from as u16);
        self.why
    }
}
