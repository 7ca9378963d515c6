//! Lists of the bodies of each cell, in arrays: 6 bytes a body, 2 a cell, and a bit a cell that tells whether it has bodies.

use crate::broad::table::NIL;

/// Links of N bodies.
#[derive(Clone, Copy, Debug)]
pub(in crate::broad) struct Links<const N: usize> {
    next: [u16; N],
    prev: [u16; N],
    cell: [u16; N],
    /// The first of the bodies that are too large for a cell; their cell is NIL.
    large: u16,
}

/// Lists, for reading.
#[derive(Clone, Copy, Debug)]
pub(in crate::broad) struct Lists<'a> {
    /// Nothing where cells are not marked.
    pub(in crate::broad) occupied: &'a [u32],
    pub(in crate::broad) heads: &'a [u16],
    pub(in crate::broad) next: &'a [u16],
    pub(in crate::broad) cell: &'a [u16],
    pub(in crate::broad) large: u16,
}

/// Lists, for writing.
#[derive(Debug)]
pub(in crate::broad) struct ListsMut<'a> {
    occupied: &'a mut [u32],
    heads: &'a mut [u16],
    next: &'a mut [u16],
    prev: &'a mut [u16],
    cell: &'a mut [u16],
    large: &'a mut u16,
}

impl<const N: usize> Links<N> {
    pub(in crate::broad) const fn new() -> Self {
        Self { next: [NIL; N], prev: [NIL; N], cell: [NIL; N], large: NIL }
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

    /// The cell of a body; what a removed one had, until its slot is taken again.
    #[inline]
    pub(in crate::broad) fn cell(&self, slot: usize) -> u16 {
        self.cell.get(slot).copied().unwrap_or(NIL)
    }
}

impl<'a> Lists<'a> {
    /// The first body of a cell, or NIL.
    #[inline]
    pub(in crate::broad) fn head(&self, cell: usize) -> u16 {
        self.heads.get(cell).copied().unwrap_or(NIL)
    }

    /// A list from its first body on: that one, and the next.
    #[inline]
    pub(in crate::broad) fn begin(&self, first: u16) -> (usize, usize, usize) {
        let first = usize::from(first);
        (first, 0, usize::from(self.next.get(first).copied().unwrap_or(NIL)))
    }

    /// The bodies of a list, from its first on. Lists have no circles: the next of a body in the lists is in them, and a removed
    /// one keeps the next that it had, which was removed later if at all.
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

    /// Says whether a cell has bodies; nothing for NIL, which is beyond all.
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

    /// Takes a body out of its list. Its own links stay: an enumeration may stand there.
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
}

/// NIL is no place.
fn set(links: &mut [u16], slot: usize, to: u16) {
    if let Some(link) = links.get_mut(slot) {
        *link = to;
    }
}
