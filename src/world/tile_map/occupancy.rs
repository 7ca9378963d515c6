//! One bit a tile in the caller's storage, so that queries pass over empty rows of cells with one test.

use crate::world::{Set, Store, TileMap, TileMapError, TileShape};

impl<'a, S: Set, T: Store> TileMap<'a, S, T> {
    /// The words that [`fill_occupancy`](Self::fill_occupancy) needs: one for each 32 columns begun, for every row.
    #[must_use]
    pub const fn occupancy_words(&self) -> usize {
        self.words_a_row() as usize * self.grid.y.count as usize
    }

    pub(in crate::world) const fn words_a_row(&self) -> u32 {
        (self.grid.x.count as u32).div_ceil(32)
    }

    /// Writes one bit a tile, set where its shape is not empty: bit `x % 32` of word `x / 32` of each row. Words beyond are left alone.
    ///
    /// # Errors
    /// [`TileMapError::Occupancy`] where the words are too few; nothing is written then.
    pub const fn fill_occupancy(&self, words: &mut [u32]) -> Result<(), TileMapError> {
        if words.len() < self.occupancy_words() {
            return Err(self.too_few(words.len()));
        }
        let (mut y, mut rest) = (0, words);
        while y < self.grid.y.count as i32 {
            let mut x = 0;
            while x < self.grid.x.count as i32 {
                // There are as many as steps.
                let Some((word, after)) = rest.split_first_mut() else { return Ok(()) };
                *word = self.word(x, y);
                rest = after;
                x = x.wrapping_add(32);
            }
            y = y.wrapping_add(1);
        }
        Ok(())
    }

    /// The same map with the bits of [`fill_occupancy`](Self::fill_occupancy) at hand: the same answers, faster where rows of cells are empty.
    ///
    /// The bits are compared with the tiles, so that a map cannot lie: a look-up a tile, in the compiler for a `const` map. After a tile is written, fill
    /// them again.
    ///
    /// ```
    /// use tilesat::{Cell, TileKind, TileKinds, TileMap, TileMapError};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// const BARE: TileMap = match TileMap::from_ascii("....\n....\n####", &KINDS) {
    ///     Ok(map) => map,
    ///     Err(_) => panic!("bad level"),
    /// };
    /// // 4 bytes of flash for each 32 tiles.
    /// static WORDS: [u32; BARE.occupancy_words()] = {
    ///     let mut words = [0; BARE.occupancy_words()];
    ///     assert!(BARE.fill_occupancy(&mut words).is_ok());
    ///     words
    /// };
    /// assert_eq!(WORDS, [0, 0, 0b1111]);
    /// let map = BARE.with_occupancy(&WORDS)?;
    /// assert_eq!(map.tile(Cell::new(1, 2)), Some(b'#'));
    /// assert_eq!(BARE.with_occupancy(&[0, 1, 0]).unwrap_err(), TileMapError::Occupancy { row: 1 });
    /// # Ok::<(), TileMapError>(())
    /// ```
    ///
    /// # Errors
    /// [`TileMapError::Occupancy`]: the first row that is missing or wrong.
    pub const fn with_occupancy(mut self, words: &'a [u32]) -> Result<Self, TileMapError> {
        if words.len() < self.occupancy_words() {
            return Err(self.too_few(words.len()));
        }
        let (mut y, mut rest) = (0, words);
        while y < self.grid.y.count as i32 {
            let mut x = 0;
            while x < self.grid.x.count as i32 {
                match rest.split_first() {
                    Some((word, after)) if *word == self.word(x, y) => rest = after,
                    _ => return Err(TileMapError::Occupancy { row: y as u16 }),
                }
                x = x.wrapping_add(32);
            }
            y = y.wrapping_add(1);
        }
        self.occupied = words;
        Ok(self)
    }

    /// The row of the first word that is missing. A row has at least one word, so the division is by no zero.
    const fn too_few(&self, found: usize) -> TileMapError {
        let row = match (found as u32).checked_div(self.words_a_row()) {
            Some(row) => row as u16,
            None => 0,
        };
        TileMapError::Occupancy { row }
    }

    /// The bits of up to 32 tiles from column `x` on.
    const fn word(&self, x: i32, y: i32) -> u32 {
        let (mut word, mut bit) = (0, 0);
        while bit < 32 && x.wrapping_add(bit) < self.grid.x.count as i32 {
            let shape = self.kinds.get(self.id(x.wrapping_add(bit), y)).shape;
            word |= (!matches!(shape, TileShape::Empty) as u32) << bit;
            bit += 1;
        }
        word
    }

    /// The first column of `x..=last` in a row whose cell has a shape; beyond `last` where none has. Columns and rows may be beyond the map.
    #[inline]
    pub(in crate::world) const fn next_shape(&self, mut x: i32, last: i32, y: i32) -> i32 {
        if x > last {
        } else if self.holds(x, y) && self.holds(last, y) {
            if self.known_empty(x, last, y) {
                return last.wrapping_add(1);
            }
            let mut tile = self.place(x, y);
            while x <= last && self.kinds.get(self.id_at(tile)).is_empty() {
                (x, tile) = (x.wrapping_add(1), tile.wrapping_add(1));
            }
        } else {
            while x <= last && self.kind_at(x, y).is_empty() {
                x = x.wrapping_add(1);
            }
        }
        x
    }

    /// Whether all tiles of a row of the map from column `x0` to `x1` are known to be empty.
    #[inline]
    pub(in crate::world) const fn known_empty(&self, x0: i32, x1: i32, y: i32) -> bool {
        !self.occupied.is_empty() && self.row_is_empty(x0, x1, y)
    }

    #[inline(never)]
    #[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
    pub(in crate::world) const fn row_is_empty(&self, x0: i32, x1: i32, y: i32) -> bool {
        let row = self.words_a_row().wrapping_mul(y as u32);
        let (mut word, last) = (row.wrapping_add(x0 as u32 >> 5), row.wrapping_add(x1 as u32 >> 5));
        let mut mask = u32::MAX << (x0 & 31);
        while word <= last && (word as usize) < self.occupied.len() {
            if word == last {
                mask &= u32::MAX >> (31 - (x1 & 31));
            }
            if self.occupied[word as usize] & mask != 0 {
                return false;
            }
            mask = u32::MAX;
            word = word.wrapping_add(1);
        }
        true
    }
}
