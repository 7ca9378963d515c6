//! The constructors of maps from bytes, bits or text. Each checks its input.

use super::{Bits, Blocks, Bytes, Outside, ShapeSet, Store, TileMap};
use crate::num::{Fx, Vec2};
use crate::world::error::TileMapError;
use crate::world::grid::Grid;
use crate::world::tile_map::kind::TileKinds;
use core::marker::PhantomData;

/// The default side of a cell: 16 units.
const CELL: Fx = Fx::from_bits(16 << 16);

impl<'a> TileMap<'a, Blocks, Bytes> {
    /// A map of blocks from bytes, row after row, in cells of 16 units.
    ///
    /// Each byte is the id of a tile. The data may be longer than the map, for
    /// [`with_stride`](Self::with_stride). Maps of more than 511 cells per side do not fit the
    /// domain with cells of 16 units. For these, use [`on_grid`](Self::on_grid). For slopes and
    /// arcs, use [`of_bytes`](Self::of_bytes).
    ///
    /// # Errors
    /// [`TileMapError`] if there are no cells, too many, or not enough data, or if a shape is not
    /// in the set.
    ///
    /// ```
    /// use tilesat::{TileKind, TileKinds, TileMap, TileMapError};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);
    /// let level = TileMap::new(&[0, 0, 1, 1], 2, 2, &KINDS)?;
    /// assert_eq!(level.bounds().max(), tilesat::Vec2::from_ints(32, 32));
    /// let short = TileMap::new(&[0, 0, 1], 2, 2, &KINDS);
    /// assert_eq!(short.unwrap_err(), TileMapError::TooShort { needed: 4, found: 3 });
    /// # Ok::<(), TileMapError>(())
    /// ```
    pub const fn new(tiles: &'a [u8], width: u16, height: u16, kinds: &'a TileKinds) -> Result<Self, TileMapError> {
        Self::at_origin(tiles, width, height, kinds)
    }

    /// A map of blocks from bytes, row after row, on a grid.
    ///
    /// Each byte is the id of a tile. For slopes and arcs, use [`of`](TileMap::of).
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub const fn on_grid(tiles: &'a [u8], grid: Grid, kinds: &'a TileKinds) -> Result<Self, TileMapError> {
        Self::build(tiles, grid, grid.width(), kinds)
    }
}

impl<'a> TileMap<'a, Blocks, Bits> {
    /// A map of two kinds of blocks from bits, in cells of 16 units.
    ///
    /// One bit per tile, row after row without gaps, the least significant bit of each byte first.
    /// A clear bit is id 0, a set one id 1.
    ///
    /// ```
    /// use tilesat::{Cell, TileKind, TileKinds, TileMap};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);
    /// let map = TileMap::from_bits(&[0b0110_0001, 0b1], 3, 3, &KINDS)?;
    /// assert_eq!(map.tile(Cell::new(0, 0)), Some(1)); // #..
    /// assert_eq!(map.tile(Cell::new(2, 1)), Some(1)); // ..#
    /// assert_eq!(map.tile(Cell::new(2, 2)), Some(1)); // #.#
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    ///
    /// # Errors
    /// As [`new`](TileMap::new).
    pub const fn from_bits(
        bits: &'a [u8],
        width: u16,
        height: u16,
        kinds: &'a TileKinds,
    ) -> Result<Self, TileMapError> {
        Self::at_origin(bits, width, height, kinds)
    }
}

impl<'a, S: ShapeSet> TileMap<'a, S, Bytes> {
    /// A map of any [`ShapeSet`] of shapes from bytes, row after row, on a grid.
    ///
    /// Each byte is the id of a tile.
    ///
    /// ```
    /// use tilesat::{AllShapes, Circle, Fx, Grid, Slopes, TileKind, TileKinds, TileMap, TileMapError, TileShape, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY
    ///     .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    ///     .with(b'(', TileKind::of(TileShape::ConcaveBottomLeft));
    /// let grid = Grid::new(2, 1, Fx::from_num(16), Vec2::ZERO)?;
    /// let map = TileMap::<AllShapes>::of(b"/(", grid, &KINDS)?;
    /// // The slope is 45 degrees, some 7.07 units from (3, 3): a ball of radius 7 does not reach it.
    /// let ball = Circle::new(Vec2::from_ints(3, 3), Fx::from_num(7)).unwrap();
    /// assert!(!map.overlaps(&ball) && !map.touches(&ball));
    /// // A set without the shape refuses it.
    /// assert_eq!(TileMap::<Slopes>::of(b"/(", grid, &KINDS).unwrap_err(), TileMapError::ShapeNotInSet { id: b'(' });
    /// # Ok::<(), TileMapError>(())
    /// ```
    ///
    /// # Errors
    /// As [`new`](TileMap::new).
    pub const fn of(tiles: &'a [u8], grid: Grid, kinds: &'a TileKinds) -> Result<Self, TileMapError> {
        Self::build(tiles, grid, grid.width(), kinds)
    }

    /// A map of any [`ShapeSet`] of shapes from bytes, row after row, in cells of 16 units.
    ///
    /// The short form of [`of`](Self::of), as [`new`](TileMap::new) is that of
    /// [`on_grid`](TileMap::on_grid).
    ///
    /// ```
    /// use tilesat::{Slopes, TileKind, TileKinds, TileMap, TileMapError, TileShape, Vec2};
    /// static KINDS: TileKinds =
    ///     TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'/', TileKind::of(TileShape::SlopeBottomRight));
    /// let tiles = [*b"../", *b"###"];
    /// let level = TileMap::<Slopes>::of_bytes(tiles.as_flattened(), 3, 2, &KINDS)?;
    /// assert_eq!(level.bounds().max(), Vec2::from_ints(48, 32));
    /// # Ok::<(), TileMapError>(())
    /// ```
    ///
    /// # Errors
    /// As [`new`](TileMap::new).
    pub const fn of_bytes(
        tiles: &'a [u8],
        width: u16,
        height: u16,
        kinds: &'a TileKinds,
    ) -> Result<Self, TileMapError> {
        Self::at_origin(tiles, width, height, kinds)
    }
}

impl<'a, S: ShapeSet, T: Store> TileMap<'a, S, T> {
    /// A map of cells of 16 x 16 units from the origin.
    const fn at_origin(data: &'a [u8], width: u16, height: u16, kinds: &'a TileKinds) -> Result<Self, TileMapError> {
        match Grid::new(width, height, CELL, Vec2::ZERO) {
            Ok(grid) => Self::build(data, grid, width, kinds),
            Err(e) => Err(e),
        }
    }

    /// The common end of all constructors, for any set and store.
    pub(in crate::world) const fn build(
        data: &'a [u8],
        grid: Grid,
        stride: u16,
        kinds: &'a TileKinds,
    ) -> Result<Self, TileMapError> {
        let map = Self { data, kinds, grid, stride, outside: Outside::Empty, occupied: &[], marker: PhantomData };
        if let Err(e) = map.check_length() {
            return Err(e);
        }
        match kinds.beyond(S::SHAPES) {
            Some(id) => Err(TileMapError::ShapeNotInSet { id }),
            None => Ok(map),
        }
    }

    /// Below 2^31 tiles: both factors are below 2^15 and 2^16.
    const fn check_length(&self) -> Result<(), TileMapError> {
        let rows_before = self.grid.y.count.wrapping_sub(1) as u64;
        let tiles = rows_before * self.stride as u64 + self.grid.x.count as u64;
        let needed = (tiles * T::BITS as u64).div_ceil(8);
        let found = self.data.len() as u64;
        if found < needed {
            return Err(TileMapError::TooShort { needed: needed as u32, found: found as u32 });
        }
        Ok(())
    }

    /// Sets the stride: each row begins `stride` tiles after the one before. The map is then a
    /// window into a wider level, or has padded rows. It loses its
    /// [occupancy](Self::with_occupancy).
    ///
    /// ```
    /// use tilesat::{Cell, TileKind, TileKinds, TileMap};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// // The right half of rows of four tiles.
    /// let window = TileMap::new(&b"...#..##"[2..], 2, 2, &KINDS)?.with_stride(4)?;
    /// assert_eq!(window.kind(Cell::new(0, 1)), TileKind::FULL);
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    ///
    /// # Errors
    /// [`TileMapError::Stride`] if the stride is below the width, [`TileMapError::TooShort`] if the
    /// data ends before the last tile.
    pub const fn with_stride(mut self, stride: u16) -> Result<Self, TileMapError> {
        if stride < self.grid.width() {
            return Err(TileMapError::Stride(stride));
        }
        self.stride = stride;
        // The bits belong to other tiles.
        self.occupied = &[];
        match self.check_length() {
            Ok(()) => Ok(self),
            Err(e) => Err(e),
        }
    }

    /// Moves the map's first corner to `origin`.
    ///
    /// # Errors
    /// [`TileMapError::OutOfDomain`].
    pub const fn with_origin(self, origin: Vec2) -> Result<Self, TileMapError> {
        self.with_grid(Grid::new(self.grid.width(), self.grid.height(), self.grid.cell(), origin))
    }

    /// Sets the side of the cells.
    ///
    /// # Errors
    /// [`TileMapError::Cell`] if it is odd or not in 2^8..=2^24 raw, [`TileMapError::OutOfDomain`].
    pub const fn with_cell(self, cell: Fx) -> Result<Self, TileMapError> {
        self.with_grid(Grid::new(self.grid.width(), self.grid.height(), cell, self.grid.origin()))
    }

    const fn with_grid(mut self, grid: Result<Grid, TileMapError>) -> Result<Self, TileMapError> {
        match grid {
            Ok(grid) => {
                self.grid = grid;
                Ok(self)
            }
            Err(e) => Err(e),
        }
    }

    /// Replaces the table of kinds by one that may have the shapes of another [`ShapeSet`].
    ///
    /// ```
    /// use tilesat::{Slopes, TileKind, TileKinds, TileMap, TileShape};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'/', TileKind::of(TileShape::SlopeBottomRight));
    /// let map = TileMap::from_ascii("./\n/.", &TileKinds::EMPTY)?.with_kinds::<Slopes>(&KINDS)?;
    /// assert_eq!(map.kind(map.cell_at(map.origin())).shape, TileShape::Empty);
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    ///
    /// # Errors
    /// [`TileMapError::ShapeNotInSet`].
    pub const fn with_kinds<N: ShapeSet>(self, kinds: &'a TileKinds) -> Result<TileMap<'a, N, T>, TileMapError> {
        match TileMap::<N, T>::build(self.data, self.grid, self.stride, kinds) {
            Ok(map) => Ok(map.with_outside(self.outside)),
            Err(e) => Err(e),
        }
    }

    /// Sets the outside of the map.
    ///
    /// ```
    /// use tilesat::{Outside, TileKinds, TileMap, Vec2, prelude::*};
    /// let open = TileMap::new(&[0; 4], 2, 2, &TileKinds::EMPTY)?;
    /// let beyond = tilesat::Aabb::new(Vec2::from_ints(-9, 0), Vec2::from_ints(-1, 8))?;
    /// assert!(!open.overlaps(&beyond) && open.with_outside(Outside::Solid).overlaps(&beyond));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[must_use]
    pub const fn with_outside(mut self, outside: Outside) -> Self {
        self.outside = outside;
        self
    }
}

impl<'a> TileMap<'a, Blocks, Bytes> {
    /// A map of blocks from lines of text of one length, in cells of 16 units.
    ///
    /// For slopes and arcs, use [`of_ascii`](TileMap::of_ascii). One character per tile; the
    /// characters are the ids. A line feed may end the last row too. One at the start would be an
    /// empty row: open a literal that begins on the next line with `"\`.
    ///
    /// Nothing is copied: the map reads the text, and skips the line feeds. In a constant, a
    /// mistake in a level is a compile error. The compiler does some 10 steps per character. Up to
    /// about 100 000 characters stay within its limit on constant evaluation.
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
    /// [`TileMapError`] if there are no cells or too many, if rows have different lengths, or if a
    /// character is not ASCII. Also if there is a carriage return, which an editor or a checkout on
    /// Windows may add.
    pub const fn from_ascii(text: &'a str, kinds: &'a TileKinds) -> Result<Self, TileMapError> {
        Self::of_ascii(text, kinds)
    }
}

impl<'a, S: ShapeSet> TileMap<'a, S, Bytes> {
    /// A map of any [`ShapeSet`] of shapes from lines of text, in cells of 16 units.
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
        match Grid::new(width as u16, height as u16, CELL, Vec2::ZERO) {
            Ok(grid) => Self::build(text, grid, width as u16 + 1, kinds),
            Err(e) => Err(e),
        }
    }
}

/// Width and height of a text whose rows have equal length.
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
