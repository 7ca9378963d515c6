//! A level of tiles: borrowed bytes, a grid, a table of kinds, and its outside. Type parameters
//! give the set of shapes that it can hold, and how ids are stored.

mod behind;
mod build;
mod clear;
mod convex;
pub(in crate::world) mod features;
mod full;
pub(in crate::world) mod kind;
pub(in crate::world) mod level;
mod lines;
mod look;
mod occupancy;
pub(in crate::world) mod outline;
pub(in crate::world) mod overlap;
pub(in crate::world) mod ray;
pub(in crate::world) mod region;
pub(in crate::world) mod shape_surface;
pub(in crate::world) mod surface;
#[cfg(test)]
mod tests;
mod way;

use super::cell::Cell;
use super::grid::Grid;
use super::sealed::Sealed;
use super::tile_map::kind::TileShape;
use crate::num::{Fx, Raw, Vec2};
use crate::shape::Aabb;
use core::fmt::Debug;
use core::marker::PhantomData;
use kind::{TileKind, TileKinds};
use outline::beyond;
use shape_surface::ShapeSurface;
use surface::{BlockSurface, CellSurface};

/// The solid beyond the cells of a [`TileMap`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outside {
    /// Nothing: bodies leave the map and fall without end.
    #[default]
    Empty,
    /// Solid: the map is a closed room.
    Solid,
    /// The border tiles repeat to the end of the domain. If the map's outer edge is solid, so is
    /// everything beyond it; half an edge gives half a band. A one-way edge continues only along
    /// its own line: one that blocks from above is not repeated above and below the map.
    Edge,
}

/// A level of square tiles: a view that owns nothing, and takes 60 bytes on a 32-bit core.
///
/// The solid is the union of its tiles' shapes, borders included, and of [`Outside`]. Its surface
/// is derived from the tiles when you ask. Interior faces do not exist, so nothing can snag on a
/// seam. To open a door, write one byte (in memory) and make the map again. Because it is a view,
/// [`of`](Self::of) with a constant grid costs only a few comparisons.
///
/// `S` is the set of shapes that it can hold, such as [`Blocks`]. `T` is the storage of ids:
/// [`Bytes`] or [`Bits`]. By default cells are squares of 16 units from the origin, rows are
/// consecutive, and the outside is empty.
///
/// | you have | blocks and one-way tiles only | any set, as `TileMap::<Slopes>::of` | cells |
/// |---|---|---|---|
/// | bytes | [`new`](Self::new) | [`of_bytes`](Self::of_bytes) | 16 units, from the origin |
/// | bytes and a [`Grid`] | [`on_grid`](Self::on_grid) | [`of`](Self::of) | the grid's |
/// | text | [`from_ascii`](Self::from_ascii) | [`of_ascii`](Self::of_ascii) | 16 units, from the origin |
/// | bits | [`from_bits`](Self::from_bits) | | 16 units, from the origin |
///
/// You can change each setting:
///
/// ```
/// use tilesat::{Cell, Outside, TileKind, TileKinds, TileMap, TileMapError, Vec2, fx};
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
/// // Cells of 8 units around the origin, in a closed room. This map is a constant, too.
/// const ROOM: Result<TileMap, TileMapError> = match MAP_DATA {
///     Ok(map) => map.with_outside(Outside::Solid).with_cell(fx!(8)),
///     Err(e) => Err(e),
/// };
/// const MAP_DATA: Result<TileMap, TileMapError> = TileMap::new(&[0; 12], 4, 3, &KINDS);
/// let room = ROOM?.with_origin(Vec2::from_ints(-16, -12))?;
/// assert_eq!(room.cell_at(Vec2::ZERO), Cell::new(2, 1));
/// # Ok::<(), TileMapError>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[doc(alias("TileMapLayer", "grid collision"))]
pub struct TileMap<'a, S: ShapeSet = Blocks, T: Store = Bytes> {
    pub(in crate::world) data: &'a [u8],
    pub(in crate::world) kinds: &'a TileKinds,
    pub(in crate::world) grid: Grid,
    pub(in crate::world) stride: u16,
    pub(in crate::world) outside: Outside,
    /// For an [`Occupied`] map, bits of the tiles that are not empty, and of areas with such a
    /// tile. Otherwise empty.
    pub(in crate::world) occupied: &'a [u32],
    pub(in crate::world) marker: PhantomData<(S, T)>,
}

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// Columns.
    #[must_use]
    pub const fn width(&self) -> u16 {
        self.grid.width()
    }

    /// Rows.
    #[must_use]
    pub const fn height(&self) -> u16 {
        self.grid.height()
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

    /// The box of all its cells: the limits of a [`Character`](crate::Character).
    #[must_use]
    pub const fn bounds(&self) -> Aabb {
        Aabb::from_raw_unchecked(Raw::of(self.grid.origin()), Raw::of(self.grid.end()))
    }

    /// The grid of the cells.
    #[must_use]
    pub const fn grid(&self) -> Grid {
        self.grid
    }

    /// The outside of the map.
    #[must_use]
    pub const fn outside(&self) -> Outside {
        self.outside
    }

    /// The cell that holds a point; see [`Grid::cell_at`].
    #[must_use]
    pub const fn cell_at(&self, p: Vec2) -> Cell {
        self.grid.cell_at(p)
    }

    /// The id of a tile; `None` outside the map.
    ///
    /// ```
    /// use tilesat::{Cell, TileKind, TileKinds, TileMap};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii(".#\n##\n", &KINDS)?;
    /// assert_eq!(level.tile(Cell::new(1, 0)), Some(b'#'));
    /// assert_eq!(level.tile(Cell::new(2, 0)), None);
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    #[must_use]
    #[doc(alias("get_tile", "mget"))]
    pub const fn tile(&self, cell: Cell) -> Option<u8> {
        if self.holds(cell.x as i32, cell.y as i32) { Some(self.id(cell.x as i32, cell.y as i32)) } else { None }
    }

    /// The kind of a cell, also outside the map, as [`Outside`] defines.
    #[must_use]
    pub const fn kind(&self, cell: Cell) -> TileKind {
        self.kind_at(cell.x as i32, cell.y as i32)
    }

    #[inline]
    pub(in crate::world) const fn holds(&self, x: i32, y: i32) -> bool {
        (x as u32) < self.grid.x.count && (y as u32) < self.grid.y.count
    }

    /// The id of a tile of the map.
    #[inline]
    pub(in crate::world) const fn id(&self, x: i32, y: i32) -> u8 {
        self.id_at(self.place(x, y))
    }

    /// The index of a tile of the map in the data.
    #[inline]
    pub(in crate::world) const fn place(&self, x: i32, y: i32) -> u32 {
        (y as u32).wrapping_mul(self.stride as u32).wrapping_add(x as u32)
    }

    /// The id of a tile by its index in the data.
    #[inline]
    #[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
    pub(in crate::world) const fn id_at(&self, tile: u32) -> u8 {
        let byte = if T::BITS == 8 { tile } else { tile >> 3 } as usize;
        // The constructors have checked the length: the program never takes the other branch.
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
            // Blocks continue unchanged, a one-way edge only along its line.
            return match kind.one_way_side() {
                Some(side) if (if side & 1 == 0 { in_y != y } else { in_x != x }) => {
                    TileKind::EMPTY.with_flags(kind.flags)
                }
                _ => kind,
            };
        }
        self.kind_unless_edge(x, y)
    }

    /// The kind of any cell of the map, or beyond it if the border is not repeated.
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

    /// The corners of a cell. If the border of a map of blocks is repeated, border cells reach to
    /// the end of the domain.
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

/// The continuation of a border tile, at `in_x` and `in_y`, beyond the map at `x` and `y`.
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
pub(in crate::world) const fn merged(index: i32, count: u32) -> i32 {
    if index < 0 {
        0
    } else if index >= count as i32 {
        count as i32 - 1
    } else {
        index
    }
}

/// Which shapes a [`TileMap`](crate::world::TileMap) can hold. A level of blocks links no code for
/// other shapes.
///
/// Sealed; the markers are types such as [`Blocks`]. Constructors refuse a table with a shape
/// that is not in the set.
pub trait ShapeSet: Sealed + Copy + Debug + Eq + 'static {
    /// One bit for each discriminant of [`TileShape`] that is allowed.
    const SHAPES: u64;

    /// Whether there are shapes besides blocks and one-way tiles.
    #[doc(hidden)]
    const SHAPED: bool = Self::SHAPES & bits(TileShape::HalfTop, TileShape::SteepHighBottomLeft) != 0;

    /// Whether there are arcs.
    #[doc(hidden)]
    const ARCS: bool = Self::SHAPES & bits(TileShape::ConvexTopLeft, TileShape::ConcaveBottomLeft) != 0;

    /// How a map's surface is derived from such tiles.
    #[doc(hidden)]
    type CellSurface: CellSurface;
}

/// The bits of the shapes `from..=to`.
pub(super) const fn bits(from: TileShape, to: TileShape) -> u64 {
    (2 << to as u64) - (1 << from as u64)
}

/// Empty, full and one-way tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Blocks;

impl Sealed for Blocks {}
impl ShapeSet for Blocks {
    const SHAPES: u64 = bits(TileShape::Empty, TileShape::Full) | bits(TileShape::OneWayUp, TileShape::OneWayLeft);
    type CellSurface = BlockSurface;
}

/// [`Blocks`], half tiles and straight slopes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Slopes;

impl Sealed for Slopes {}
impl ShapeSet for Slopes {
    const SHAPES: u64 = AllShapes::SHAPES & !bits(TileShape::ConvexTopLeft, TileShape::ConcaveBottomLeft);
    type CellSurface = ShapeSurface<false>;
}

/// Every [`TileShape`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AllShapes;

impl Sealed for AllShapes {}
impl ShapeSet for AllShapes {
    const SHAPES: u64 = bits(TileShape::Empty, TileShape::OneWayLeft);
    type CellSurface = ShapeSurface<true>;
}

/// How a [`TileMap`](crate::world::TileMap) stores its tile ids.
///
/// Sealed; the markers are [`Bytes`], [`Bits`], and [`Occupied`] with either.
pub trait Store: Sealed + Copy + Debug + Eq + 'static {
    /// Bits of one tile: 8 or 1.
    const BITS: u32;

    /// Whether there may be bits of the tiles that are not empty.
    #[doc(hidden)]
    const OCCUPIED: bool = false;
}

/// One byte per tile: 256 ids.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bytes;

impl Sealed for Bytes {}
impl Store for Bytes {
    const BITS: u32 = 8;
}

/// One bit per tile, the least significant bit of a byte first: ids 0 and 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bits;

impl Sealed for Bits {}
impl Store for Bits {
    const BITS: u32 = 1;
}

/// Tile ids stored as in `T`, with [occupancy](crate::world::TileMap::with_occupancy) beside them.
///
/// A separate type: a map without occupancy links none of its code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Occupied<T: Store = Bytes>(PhantomData<T>);

impl<T: Store> Default for Occupied<T> {
    fn default() -> Self {
        Self(PhantomData)
    }
}

impl<T: Store> Sealed for Occupied<T> {}
impl<T: Store> Store for Occupied<T> {
    const BITS: u32 = T::BITS;
    const OCCUPIED: bool = true;
}
