//! Rows of cells, of which most are empty: words that tell which are not.

use super::{At, Run, Window};

/// How cells are numbered: row by row, with a power of two of columns.
#[derive(Clone, Copy, Debug)]
pub(in crate::broad) struct Rows {
    pub(in crate::broad) count: u16,
    pub(in crate::broad) log_columns: u8,
}

impl Rows {
    pub(in crate::broad) const fn log_columns(self) -> u32 {
        (self.log_columns & 15) as u32
    }

    pub(in crate::broad) const fn last(self) -> At {
        At { x: (1 << self.log_columns()) - 1, y: self.count as i32 - 1 }
    }

    /// The number of a cell of the grid.
    #[inline]
    pub(in crate::broad) fn number(self, at: At) -> usize {
        (at.y as usize) << self.log_columns() | at.x as usize
    }

    /// The cell of a number.
    #[inline]
    pub(in crate::broad) fn place(self, number: u16) -> At {
        At { x: i32::from(number) & self.last().x, y: i32::from(number) >> self.log_columns() }
    }

    /// Windows of cells beyond the grid become ones of its border, where the bodies beyond it are.
    pub(in crate::broad) fn clip(self, window: Window) -> Window {
        let last = self.last();
        Window { x: window.x.clamped(last.x), y: window.y.clamped(last.y) }
    }

    /// The cells of a window of the grid that are not empty: one look at 32 of them.
    #[inline]
    pub(in crate::broad) fn occupied(self, words: &[u32], window: &Window, mut each: impl FnMut(usize)) {
        let Window { x: Run { lo, hi }, y } = *window;
        if lo > hi {
            return;
        }
        for row in y.lo..=y.hi {
            let (first, last) = (self.number(At { x: lo, y: row }), self.number(At { x: hi, y: row }));
            let (mut number, end) = (first & !31, last >> 5);
            let mut before = u32::MAX << (first & 31);
            for (i, word) in words.iter().enumerate().take(end + 1).skip(first >> 5) {
                let after = if i == end { u32::MAX >> (31 - (last & 31)) } else { u32::MAX };
                let mut bits = word & before & after;
                while bits != 0 {
                    each(number + bits.trailing_zeros() as usize);
                    bits &= bits - 1;
                }
                (before, number) = (u32::MAX, number + 32);
            }
        }
    }
}
