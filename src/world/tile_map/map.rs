//! A level of tiles: borrowed bytes, a grid, a table of kinds, and what lies outside.

use super::outline::beyond;
use crate::num::{Fx, Raw, Vec2};
use crate::world::{Bits, Blocks, Bytes, Cell, Grid, Set, Store, TileKind, TileKinds, TileMapError};
use core::marker::PhantomData;

/// What lies beyond the cells of a [`TileMap`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outside {
    /// Nothing: bodies leave the map and fall for ever.
    #[default]
    Empty,
    /// Solid: the map is a closed room.
    Solid,
    /// The border, continued to the end of the domain: what is solid on the map's outer edge is solid beyond it, so half an edge gives half a
    /// band. A one-way edge goes on along its own line only: one that blocks from above is not repeated above and below the map.
    Edge,
}

/// A level of square tiles, read from where it lies: it owns nothing and needs no memory but itself (60 bytes on a 32-bit core).
///
/// The solid is the union of its tiles' shapes, borders included, and of what is [`Outside`]. Its surface is derived from the tiles when
/// asked: interior faces do not exist, so nothing can snag on a seam, and a door is one byte written (in memory; then make the map, a
/// view, anew).
///
/// `S` says which shapes it can hold ([`Blocks`]), `T` how ids are stored: [`Bytes`] or [`Bits`]. Cells are squares of 16 units from the
/// origin, rows are consecutive and outside is empty, unless said otherwise:
///
/// ```
/// use tilesat::{Cell, Fx, Outside, TileKind, TileKinds, TileMap, TileMapError, Vec2};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'$', TileKind::EMPTY.with_flags(1));
/// static MAP: TileMap = match TileMap::from_ascii("\
/// ....$...
/// ..####..
/// ........", &KINDS) {
///     Ok(map) => map,
///     Err(_) => panic!("bad level"),
/// };
/// assert_eq!((MAP.width(), MAP.height()), (8, 3));
/// assert_eq!(MAP.kind(Cell::new(2, 1)), TileKind::FULL);
///
/// // Cells of 8 units around the origin, in a closed room: constant as well.
/// const ROOM: Result<TileMap, TileMapError> = match MAP_DATA {
///     Ok(map) => map.with_outside(Outside::Solid).with_cell(Fx::lit("8")),
///     Err(e) => Err(e),
/// };
/// const MAP_DATA: Result<TileMap, TileMapError> = TileMap::new(&[0; 12], 4, 3, &KINDS);
/// let room = ROOM?.with_origin(Vec2::from_ints(-16, -12))?;
/// assert_eq!(room.cell_at(Vec2::ZERO), Cell::new(2, 1));
/// # Ok::<(), TileMapError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct TileMap<'a, S: Set = Blocks, T: Store = Bytes> {
    pub(in crate::world) data: &'a [u8],
    pub(in crate::world) kinds: &'a TileKinds,
    pub(in crate::world) grid: Grid,
    pub(in crate::world) stride: u16,
    pub(in crate::world) outside: Outside,
    /// Bits of the tiles that are not empty, or none.
    pub(in crate::world) occupied: &'a [u32],
    pub(in crate::world) marker: PhantomData<(S, T)>,
}

/// The side of a cell where nothing else is said: 16 units.
const CELL: Fx = Fx::from_bits(16 << 16);

impl<'a> TileMap<'a, Blocks, Bytes> {
    /// A map of one byte a tile, row after row.
    ///
    /// The data may be longer than the map, for [`with_stride`](Self::with_stride). Maps of more than 511 cells a side do not fit the domain with
    /// cells of 16 units: [`on_grid`](Self::on_grid) takes the cell at once.
    ///
    /// # Errors
    /// [`TileMapError`]: no cells, too many, not enough data, or a shape that is not in the set.
    pub const fn new(tiles: &'a [u8], width: u16, height: u16, kinds: &'a TileKinds) -> Result<Self, TileMapError> {
        match Grid::new(width, height, CELL, Vec2::ZERO) {
            Ok(grid) => Self::build(tiles, grid, width, kinds),
            Err(e) => Err(e),
        }
    }

    /// A map of one byte a tile, row after row, on a grid.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub const fn on_grid(tiles: &'a [u8], grid: Grid, kinds: &'a TileKinds) -> Result<Self, TileMapError> {
        Self::build(tiles, grid, grid.x.count, kinds)
    }
}

impl<'a> TileMap<'a, Blocks, Bits> {
    /// A map of one bit a tile, row after row without gaps, the least significant bit of each byte first: a clear bit is id 0, a set one
    /// id 1.
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
        match Grid::new(width, height, CELL, Vec2::ZERO) {
            Ok(grid) => Self::build(bits, grid, width, kinds),
            Err(e) => Err(e),
        }
    }
}

impl<'a, S: Set> TileMap<'a, S, Bytes> {
    /// A map of one byte a tile, row after row, on a grid, that can hold the shapes of any [`Set`].
    ///
    /// ```
    /// use tilesat::{AllShapes, Circle, Fx, Grid, Slopes, TileKind, TileKinds, TileMap, TileMapError, TileShape, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY
    ///     .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    ///     .with(b'(', TileKind::of(TileShape::ConcaveBottomLeft));
    /// let grid = Grid::new(2, 1, Fx::from_num(16), Vec2::ZERO)?;
    /// let map = TileMap::<AllShapes>::of(b"/(", grid, &KINDS)?;
    /// // 45 degrees: five units in front of the slope's middle a ball of 7 reaches it.
    /// let ball = Circle::new(Vec2::from_ints(3, 3), Fx::from_num(7)).unwrap();
    /// assert!(!map.overlaps(&ball) && !map.touches(&ball));
    /// // A set that does not have the shape refuses it.
    /// assert_eq!(TileMap::<Slopes>::of(b"/(", grid, &KINDS).unwrap_err(), TileMapError::ShapeNotInSet { id: b'(' });
    /// # Ok::<(), TileMapError>(())
    /// ```
    ///
    /// # Errors
    /// As [`new`](TileMap::new).
    pub const fn of(tiles: &'a [u8], grid: Grid, kinds: &'a TileKinds) -> Result<Self, TileMapError> {
        Self::build(tiles, grid, grid.x.count, kinds)
    }
}

impl<'a, S: Set, T: Store> TileMap<'a, S, T> {
    /// Every constructor ends here, whatever the set and the store.
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
        let mut id = 0u8;
        loop {
            if S::SHAPES >> kinds.get(id).shape as u64 & 1 == 0 {
                return Err(TileMapError::ShapeNotInSet { id });
            }
            if id == u8::MAX {
                return Ok(map);
            }
            id = id.wrapping_add(1);
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

    /// The same tiles, each row `stride` tiles after the one before: a window into a wider level, or rows with padding; without
    /// [occupancy](Self::with_occupancy).
    ///
    /// # Errors
    /// [`TileMapError::Stride`] below the width, [`TileMapError::TooShort`] where the data ends before the last tile.
    pub const fn with_stride(mut self, stride: u16) -> Result<Self, TileMapError> {
        if stride < self.grid.x.count {
            return Err(TileMapError::Stride(stride));
        }
        self.stride = stride;
        // Other tiles than the bits were made of.
        self.occupied = &[];
        match self.check_length() {
            Ok(()) => Ok(self),
            Err(e) => Err(e),
        }
    }

    /// The same map with its first corner elsewhere.
    ///
    /// # Errors
    /// [`TileMapError::OutOfDomain`].
    pub const fn with_origin(self, origin: Vec2) -> Result<Self, TileMapError> {
        self.with_grid(Grid::new(self.grid.x.count, self.grid.y.count, self.grid.cell(), origin))
    }

    /// The same map with cells of another size.
    ///
    /// # Errors
    /// [`TileMapError::Cell`] where it is odd or not in 2^8..=2^24 raw, [`TileMapError::OutOfDomain`].
    pub const fn with_cell(self, cell: Fx) -> Result<Self, TileMapError> {
        self.with_grid(Grid::new(self.grid.x.count, self.grid.y.count, cell, self.grid.origin()))
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

    /// The same tiles with another table, which may hold the shapes of another [`Set`].
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
    pub const fn with_kinds<N: Set>(self, kinds: &'a TileKinds) -> Result<TileMap<'a, N, T>, TileMapError> {
        match TileMap::<N, T>::build(self.data, self.grid, self.stride, kinds) {
            Ok(map) => Ok(map.with_outside(self.outside)),
            Err(e) => Err(e),
        }
    }

    /// The same map with something else outside.
    #[must_use]
    pub const fn with_outside(mut self, outside: Outside) -> Self {
        self.outside = outside;
        self
    }

    /// Columns.
    #[must_use]
    pub const fn width(&self) -> u16 {
        self.grid.x.count
    }

    /// Rows.
    #[must_use]
    pub const fn height(&self) -> u16 {
        self.grid.y.count
    }

    /// The side of a cell.
    #[must_use]
    pub const fn cell(&self) -> Fx {
        self.grid.cell()
    }

    /// The corner of the first cell with the smallest coordinates.
    #[must_use]
    pub const fn origin(&self) -> Vec2 {
        self.grid.origin()
    }

    /// Where the cells are.
    #[must_use]
    pub const fn grid(&self) -> Grid {
        self.grid
    }

    /// What lies outside.
    #[must_use]
    pub const fn outside(&self) -> Outside {
        self.outside
    }

    /// The cell that holds a point; see [`Grid::cell_at`].
    #[must_use]
    pub const fn cell_at(&self, p: Vec2) -> Cell {
        self.grid.cell_at(p)
    }

    /// The id of a tile; `None` outside of the map.
    #[must_use]
    pub const fn tile(&self, cell: Cell) -> Option<u8> {
        if self.holds(cell.x as i32, cell.y as i32) { Some(self.id(cell.x as i32, cell.y as i32)) } else { None }
    }

    /// The kind of a cell, outside of the map too, as [`Outside`] has it.
    #[must_use]
    pub const fn kind(&self, cell: Cell) -> TileKind {
        self.kind_at(cell.x as i32, cell.y as i32)
    }

    #[inline]
    pub(in crate::world) const fn holds(&self, x: i32, y: i32) -> bool {
        (x as u32) < self.grid.x.count as u32 && (y as u32) < self.grid.y.count as u32
    }

    /// The id of a tile of the map.
    #[inline]
    pub(in crate::world) const fn id(&self, x: i32, y: i32) -> u8 {
        self.id_at(self.place(x, y))
    }

    /// The place of a tile of the map in the data.
    #[inline]
    pub(in crate::world) const fn place(&self, x: i32, y: i32) -> u32 {
        (y as u32).wrapping_mul(self.stride as u32).wrapping_add(x as u32)
    }

    /// The id of a tile by its place in the data.
    #[inline]
    #[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
    pub(in crate::world) const fn id_at(&self, tile: u32) -> u8 {
        let byte = if T::BITS == 8 { tile } else { tile >> 3 } as usize;
        // The constructors have checked the length: the other branch is never taken.
        let byte = if byte < self.data.len() { self.data[byte] } else { 0 };
        if T::BITS == 8 { byte } else { byte >> (tile & 7) & 1 }
    }

    /// The kind of any cell.
    pub(in crate::world) const fn kind_at(&self, x: i32, y: i32) -> TileKind {
        if let Outside::Edge = self.outside {
            let (in_x, in_y) = (merged(x, self.grid.x.count), merged(y, self.grid.y.count));
            let kind = self.kind_unless_edge(in_x, in_y);
            if S::SHAPED {
                return if in_x == x && in_y == y { kind } else { continued(kind, x, y, in_x, in_y) };
            }
            // Blocks are continued as they are, a one-way edge along its line alone.
            return match kind.one_way_side() {
                Some(side) if (if side & 1 == 0 { in_y != y } else { in_x != x }) => {
                    TileKind::EMPTY.with_flags(kind.flags)
                }
                _ => kind,
            };
        }
        self.kind_unless_edge(x, y)
    }

    /// The kind of any cell of the map, or beyond it where the border is not repeated.
    #[inline(never)]
    pub(in crate::world) const fn kind_unless_edge(&self, x: i32, y: i32) -> TileKind {
        if self.holds(x, y) {
            self.kinds.get(self.id(x, y))
        } else if let Outside::Solid = self.outside {
            TileKind::FULL
        } else {
            TileKind::EMPTY
        }
    }

    #[inline]
    pub(in crate::world) const fn full(&self, x: i32, y: i32) -> bool {
        self.kind_at(x, y).is_full()
    }

    /// The corners of a cell: where the border is repeated and only blocks are, border cells reach to the end of the domain.
    #[inline]
    pub(in crate::world) const fn extent(&self, x: i32, y: i32) -> (Raw, Raw) {
        self.extent_between((x, y), (x, y))
    }

    /// The first corner of one cell and the last one of another.
    pub(in crate::world) const fn extent_between(&self, first: (i32, i32), last: (i32, i32)) -> (Raw, Raw) {
        if !S::SHAPED && matches!(self.outside, Outside::Edge) {
            // A border cell as a part of the band beyond it: each side by its own index.
            let (width, height) = (self.grid.x.count as i32 - 1, self.grid.y.count as i32 - 1);
            let (x0, y0) = (if first.0 == 0 { -1 } else { first.0 }, if first.1 == 0 { -1 } else { first.1 });
            let (x1, y1) =
                (if last.0 == width { last.0 + 1 } else { last.0 }, if last.1 == height { last.1 + 1 } else { last.1 });
            self.grid.bounds((x0, y0), (x1, y1))
        } else {
            self.grid.bounds(first, last)
        }
    }
}

/// What a border tile, at `in_x` and `in_y`, is beyond the map at `x` and `y`.
#[inline(never)]
const fn continued(kind: TileKind, x: i32, y: i32, in_x: i32, in_y: i32) -> TileKind {
    if in_y == y {
        return beyond(kind, if x < in_x { 3 } else { 1 }, false);
    }
    if in_x == x {
        return beyond(kind, if y < in_y { 0 } else { 2 }, false);
    }
    // The side that begins at the corner.
    let k = match (x < in_x, y < in_y) {
        (true, true) => 0,
        (false, true) => 1,
        (false, false) => 2,
        (true, false) => 3,
    };
    beyond(kind, k, true)
}

/// The nearest index of the map.
pub(in crate::world) const fn merged(index: i32, count: u16) -> i32 {
    if index < 0 {
        0
    } else if index >= count as i32 {
        count as i32 - 1
    } else {
        index
    }
}
