//! Levels as text in the program: the characters are the tile ids.

use crate::num::{Fx, Vec2};
use crate::world::{Blocks, Bytes, Grid, Set, TileKinds, TileMap, TileMapError};

impl<'a> TileMap<'a, Blocks, Bytes> {
    /// A map from lines of text of one length, one character a tile; the characters are the ids. A line feed may end the last row too.
    ///
    /// Nothing is copied: the map reads the text, stepping over the line feeds. Usable in constants, so that a mistake in a level is a
    /// compile error; the compiler does some 10 steps a character, and up to about 100 000 characters stay within its limit on
    /// constant evaluation.
    ///
    /// ```
    /// use tilesat::{Cell, TileKind, TileKinds, TileMap, TileMapError};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let map = TileMap::from_ascii("#..\n###\n", &KINDS)?;
    /// assert_eq!((map.width(), map.height(), map.tile(Cell::new(0, 1))), (3, 2, Some(b'#')));
    ///
    /// let ragged = TileMap::from_ascii("#..\n####", &KINDS);
    /// assert_eq!(ragged.unwrap_err(), TileMapError::RowLength { row: 1, expected: 3, found: 4 });
    /// # Ok::<(), TileMapError>(())
    /// ```
    ///
    /// # Errors
    /// [`TileMapError`]: no cells, too many, rows of different lengths, a character that is not ASCII, or a carriage return (as an editor or a
    /// checkout on Windows may add).
    pub const fn from_ascii(text: &'a str, kinds: &'a TileKinds) -> Result<Self, TileMapError> {
        Self::of_ascii(text, kinds)
    }
}

impl<'a, S: Set> TileMap<'a, S, Bytes> {
    /// The same for the shapes of any [`Set`].
    ///
    /// ```
    /// use tilesat::{Slopes, TileKind, TileKinds, TileMap, TileMapError, TileShape};
    /// static KINDS: TileKinds =
    ///     TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'/', TileKind::of(TileShape::SlopeBottomRight));
    /// let hill = TileMap::<Slopes>::of_ascii("../.\n./##", &KINDS)?;
    /// assert_eq!((hill.width(), hill.height()), (4, 2));
    /// # Ok::<(), TileMapError>(())
    /// ```
    ///
    /// # Errors
    /// As [`from_ascii`](TileMap::from_ascii), and [`TileMapError::ShapeNotInSet`].
    pub const fn of_ascii(text: &'a str, kinds: &'a TileKinds) -> Result<Self, TileMapError> {
        let text = text.as_bytes();
        let (width, height) = match measure(text) {
            Ok(size) => size,
            Err(e) => return Err(e),
        };
        if width > i16::MAX as u32 || height > i16::MAX as u32 {
            let n = if width > height { width } else { height };
            return Err(TileMapError::TooManyCells(if n > u16::MAX as u32 { u16::MAX } else { n as u16 }));
        }
        match Grid::new(width as u16, height as u16, Fx::from_bits(16 << 16), Vec2::ZERO) {
            Ok(grid) => Self::build(text, grid, width as u16 + 1, kinds),
            Err(e) => Err(e),
        }
    }
}

/// Width and height of a text whose rows have one length.
#[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
const fn measure(text: &[u8]) -> Result<(u32, u32), TileMapError> {
    let (mut width, mut row, mut column) = (0, 0, 0);
    let mut i = 0;
    while i < text.len() {
        let character = text[i];
        i += 1;
        if character >= 0x80 {
            return Err(TileMapError::NotAscii { row, column });
        }
        if character == b'\r' {
            return Err(TileMapError::CarriageReturn { row });
        }
        if character != b'\n' {
            column += 1;
        }
        if character == b'\n' || i == text.len() {
            if row == 0 {
                width = column;
            } else if column != width {
                return Err(TileMapError::RowLength { row, expected: width, found: column });
            }
            row += 1;
            column = 0;
        }
    }
    Ok((width, row))
}
