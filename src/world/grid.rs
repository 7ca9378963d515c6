//! The grid of a map: origin, cell size, and the cell of a coordinate without division.

use super::cell::Cell;
use super::error::TileMapError;
use crate::error::Quantity;
use crate::num::{DOMAIN, Fx, Raw, SPLIT, Vec2, leading_zeros32, umul};
use crate::shape::Aabb;

/// The cells of a map: how many, how large, and where.
///
/// ```text
///  origin +---+---+---+
///         |0,0|1,0|2,0|     cell: the side of a square
///         +---+---+---+
///         |0,1|1,1|2,1|     y may grow down (as here) or up
///         +---+---+---+ end
/// ```
///
/// ```
/// use tilesat::{Cell, Fx, Grid, Vec2};
/// let grid = Grid::new(30, 20, Fx::from_num(8), Vec2::from_ints(-120, 0))?;
/// assert_eq!(grid.cell_at(Vec2::from_ints(-1, 8)), Cell::new(14, 1));
/// assert_eq!(grid.cell_at(Vec2::from_ints(-121, 1000)), Cell::new(-1, 20)); // beyond the map
/// # Ok::<(), tilesat::TileMapError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Grid {
    pub(super) x: GridAxis,
    pub(super) y: GridAxis,
    pub(super) cell: i32,
    /// 0 if the cell is a power of two, else `ceil(2^(31 + log) / cell)`.
    pub(super) magic: u32,
    /// `floor(log2 cell)`, 8 to 24. A whole word, as in [`GridAxis::count`].
    pub(super) log: u32,
}

/// One axis of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct GridAxis {
    /// The first corner of the first cell.
    pub(super) origin: i32,
    /// The length of all cells, below 2^30.
    pub(super) size: i32,
    /// The number of cells, 1 to 32 767. It is a whole word. With bytes between the fields of a
    /// constant grid, a map made from it would take a call of the compiler's copy routine.
    pub(super) count: u32,
}

impl Grid {
    /// A grid of `width` x `height` cells of side `cell`, the first corner of the first cell at
    /// `origin`.
    ///
    /// # Errors
    /// [`TileMapError`] if a count is 0 or above 32 767, or the cell is odd or not in 2^8..=2^24
    /// raw (1/256 to 256 units). Also if an end of the grid is outside the
    /// [domain](crate::num::DOMAIN).
    pub const fn new(width: u16, height: u16, cell: Fx, origin: Vec2) -> Result<Self, TileMapError> {
        if width == 0 || height == 0 {
            return Err(TileMapError::EmptyMap);
        }
        if width > i16::MAX as u16 || height > i16::MAX as u16 {
            return Err(TileMapError::TooManyCells(if width > height { width } else { height }));
        }
        let (cell, origin) = (cell.to_bits(), Raw::of(origin));
        if cell < 1 << 8 || cell > 1 << 24 || cell & 1 != 0 {
            return Err(TileMapError::Cell(cell));
        }
        match (span(origin.x, width, cell, Quantity::X), span(origin.y, height, cell, Quantity::Y)) {
            (Ok(x), Ok(y)) => {
                let (magic, log) = magic(cell as u32);
                Ok(Self { x, y, cell, magic, log })
            }
            (Err(e), _) | (_, Err(e)) => Err(e),
        }
    }

    /// Columns.
    #[must_use]
    pub const fn width(&self) -> u16 {
        self.x.count as u16
    }

    /// Rows.
    #[must_use]
    pub const fn height(&self) -> u16 {
        self.y.count as u16
    }

    /// The side of a cell.
    #[must_use]
    pub const fn cell(&self) -> Fx {
        Fx::from_bits(self.cell)
    }

    /// The corner of the first cell with the smallest coordinates.
    #[must_use]
    pub const fn origin(&self) -> Vec2 {
        Vec2::from_raw(self.x.origin, self.y.origin)
    }

    /// The corner of the last cell with the largest coordinates.
    #[must_use]
    pub const fn end(&self) -> Vec2 {
        Vec2::from_raw(self.x.origin.wrapping_add(self.x.size), self.y.origin.wrapping_add(self.y.size))
    }

    /// The cell that holds a point.
    ///
    /// Left and upper borders belong to the cell, right and lower ones to the next. Exact for every
    /// `p`; beyond the map, -1 or the width (the height). Cost: about 40 instructions on a
    /// Cortex-M0, twice that if the cell is not a power of two; no division.
    ///
    /// ```
    /// use tilesat::{Cell, Grid, Vec2, fx};
    /// let grid = Grid::new(20, 15, fx!(16), Vec2::ZERO)?;
    /// assert_eq!(grid.cell_at(Vec2::from_ints(31, 32)), Cell::new(1, 2));
    /// assert_eq!(grid.cell_at(Vec2::from_ints(-5, 0)), Cell::new(-1, 0)); // left of the grid
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    #[must_use]
    pub const fn cell_at(&self, p: Vec2) -> Cell {
        let p = Raw::of(p);
        Cell::of(self.column(p.x), self.row(p.y))
    }

    /// The index of a cell in bytes that are row after row, as for
    /// [`TileMap::of`](crate::TileMap::of); `None` beyond the map.
    ///
    /// ```
    /// use tilesat::{Cell, Grid, Vec2, fx};
    /// const GRID: Grid = match Grid::new(4, 2, fx!(16), Vec2::ZERO) {
    ///     Ok(grid) => grid,
    ///     Err(_) => panic!("the grid is wrong"),
    /// };
    /// let mut tiles = *b"..o.####";
    /// if let Some(tile) = GRID.index_of(Cell::new(2, 0)).and_then(|index| tiles.get_mut(index)) {
    ///     *tile = b'.'; // the coin is taken
    /// }
    /// assert_eq!(&tiles, b"....####");
    /// assert_eq!(GRID.index_of(Cell::new(4, 0)), None);
    /// ```
    #[must_use]
    pub const fn index_of(&self, cell: Cell) -> Option<usize> {
        let (x, y) = (cell.x as i32, cell.y as i32);
        if x < 0 || y < 0 || x >= self.x.count as i32 || y >= self.y.count as i32 {
            return None;
        }
        // Below 2^30: both counts are below 2^15.
        Some(y as usize * self.x.count as usize + x as usize)
    }

    /// The box of a cell, to draw a tile or to put a door into it; `None` beyond the map.
    ///
    /// Exact; neighbouring boxes share a side. Cost: three products.
    ///
    /// ```
    /// use tilesat::{Aabb, Cell, Grid, Vec2, fx};
    /// let grid = Grid::new(20, 15, fx!(16), Vec2::from_ints(-100, 0))?;
    /// let spawn = grid.bounds_of(Cell::new(2, 1)).unwrap();
    /// assert_eq!((spawn.min(), spawn.max()), (Vec2::from_ints(-68, 16), Vec2::from_ints(-52, 32)));
    /// assert_eq!(grid.bounds_of(Cell::new(20, 0)), None);
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    #[must_use]
    #[doc(alias("map_to_local", "tile_rect", "cell rectangle"))]
    pub const fn bounds_of(&self, cell: Cell) -> Option<Aabb> {
        if self.index_of(cell).is_none() {
            return None;
        }
        let (lo, hi) = self.square(cell.x as i32, cell.y as i32);
        Some(Aabb::from_raw_unchecked(lo, hi))
    }

    /// The column that holds `x` as [`cell_at`](Self::cell_at) has it; of `x - 1`, the column that
    /// `x` is entered from on the right.
    pub(super) const fn column(&self, x: i32) -> i32 {
        self.index(x, &self.x)
    }

    pub(super) const fn row(&self, y: i32) -> i32 {
        self.index(y, &self.y)
    }

    /// The columns of two coordinates, `hi` not less than `lo - 1`, which are usually near each
    /// other.
    #[inline]
    pub(super) const fn columns(&self, lo: i32, hi: i32) -> (i32, i32) {
        self.indices(lo, hi, &self.x)
    }

    #[inline]
    pub(super) const fn rows(&self, lo: i32, hi: i32) -> (i32, i32) {
        self.indices(lo, hi, &self.y)
    }

    #[inline(never)]
    const fn indices(&self, lo: i32, hi: i32, span: &GridAxis) -> (i32, i32) {
        let first = self.index(lo, span);
        let mut last = first;
        // A few steps cost less than a quotient.
        let (mut steps, mut next) = (4, span.origin.wrapping_add(self.line(first.wrapping_add(1))));
        while hi >= next && last < span.count as i32 {
            if steps == 0 {
                return (first, self.index(hi, span));
            }
            (last, next, steps) = (last.wrapping_add(1), next.wrapping_add(self.cell), steps - 1);
        }
        if hi < lo { (first, self.index(hi, span)) } else { (first, last) }
    }

    /// Any `v`: the difference of two words, the first not less, fits an unsigned word.
    #[inline(never)]
    pub(super) const fn index(&self, v: i32, span: &GridAxis) -> i32 {
        if v < span.origin {
            return -1;
        }
        let d = v.wrapping_sub(span.origin) as u32;
        if d >= span.size as u32 { span.count as i32 } else { self.quotient(d) as i32 }
    }

    /// The last cell that begins before a distance from the origin, not less than the `first`;
    /// found by steps, because it is usually near.
    #[inline]
    pub(super) const fn last_before(&self, distance: i32, first: i32) -> i32 {
        let (mut index, mut end) = (first, self.line(first.wrapping_add(1)));
        if end >= distance {
            return index;
        }
        // One step or none is frequent.
        (index, end) = (index.wrapping_add(1), end.wrapping_add(self.cell));
        if end >= distance {
            return index;
        }
        // A quotient costs as much as two more steps, where a long product is one instruction.
        if !SPLIT {
            return self.quotient(distance.wrapping_sub(1) as u32) as i32;
        }
        self.last_from(distance, index, end)
    }

    /// More than two steps. A separate function: inlined and unrolled, it costs motions that step
    /// less 6 of 340 instructions on a Cortex-M0.
    #[inline(never)]
    const fn last_from(&self, distance: i32, mut index: i32, mut end: i32) -> i32 {
        while end < distance {
            (index, end) = (index.wrapping_add(1), end.wrapping_add(self.cell));
        }
        index
    }

    /// `d / cell` for `d < 2^30`.
    ///
    /// Granlund and Montgomery: let `l = log + 1` and `2^(30 + l) <= m cell < 2^(30 + l) + cell`.
    /// Then `m d / 2^(30 + l)` exceeds `d / cell` by less than `d / 2^(30 + l) <= 1 / cell`, which
    /// cannot reach the next multiple. `m <= 2^31`, as `cell > 2^(l - 1)`.
    #[inline]
    pub(super) const fn quotient(&self, d: u32) -> u32 {
        // The high word of the product makes 32 of the shift by 31 + log.
        if self.magic == 0 {
            d >> (self.log & 31)
        } else if SPLIT {
            self.quotient_by_words(d)
        } else {
            (umul(d, self.magic) >> 32) as u32 >> (self.log.wrapping_sub(1) & 31)
        }
    }

    /// [`quotient`](Self::quotient) for results below 2^15, without a long product.
    ///
    /// d / 2^(log - 1) is below 2^17, and the magic's upper half at most 2^15: the product is below
    /// 2^32. The first quotient loses less than 1 of it, which is half a cell, and the second less
    /// than 2^17 / 2^16 cells. So three steps are enough; a loop would be unrolled, and cost more.
    pub(super) const fn quotient_by_words(&self, d: u32) -> u32 {
        let index = (d >> (self.log.wrapping_sub(1) & 31)).wrapping_mul(self.magic >> 16) >> 16;
        let (rest, cell) = (d.wrapping_sub(index.wrapping_mul(self.cell as u32)), self.cell as u32);
        let steps = if rest < cell {
            0
        } else if rest < cell << 1 {
            1
        } else {
            2 + (rest >= (cell << 1).wrapping_add(cell)) as u32
        };
        index.wrapping_add(steps)
    }

    /// How many cells a box may meet with its inside, those beyond the map included: less than
    /// 2^31.
    pub(super) const fn most_cells(&self, width: u32, height: u32) -> u32 {
        self.most_along(width, &self.x).wrapping_mul(self.most_along(height, &self.y))
    }

    #[inline(never)]
    const fn most_along(&self, length: u32, span: &GridAxis) -> u32 {
        let (most, all) = (self.quotient(length).wrapping_add(2), span.count + 2);
        if most < all { most } else { all }
    }

    /// The smaller coordinate of a column's side, as a distance from the origin. For columns
    /// 0..=width.
    #[inline]
    pub(super) const fn line(&self, index: i32) -> i32 {
        index.wrapping_mul(self.cell)
    }

    /// The side of a row toward row 0. For rows of the map.
    #[inline]
    pub(super) const fn line_y(&self, row: i32) -> i32 {
        self.y.origin.wrapping_add(self.line(row))
    }

    /// The corners of a cell of the map.
    #[inline]
    pub(super) const fn square(&self, x: i32, y: i32) -> (Raw, Raw) {
        let lo = Raw { x: self.x.origin.wrapping_add(self.line(x)), y: self.line_y(y) };
        (lo, Raw { x: lo.x.wrapping_add(self.cell), y: lo.y.wrapping_add(self.cell) })
    }

    /// The corners of a cell; a cell at -1 or width (height) reaches to the end of the domain.
    #[inline]
    pub(super) const fn corners(&self, x: i32, y: i32) -> (Raw, Raw) {
        self.bounds((x, y), (x, y))
    }

    /// The first corner of one cell of the map and the last one of another.
    #[inline]
    pub(super) const fn area(&self, first: (i32, i32), last: (i32, i32)) -> (Raw, Raw) {
        let origin = Raw { x: self.x.origin, y: self.y.origin };
        let lo = Raw { x: self.line(first.0), y: self.line(first.1) };
        let hi = Raw { x: self.line(last.0.wrapping_add(1)), y: self.line(last.1.wrapping_add(1)) };
        (origin.add(lo), origin.add(hi))
    }

    /// The first corner of one cell and the last one of another.
    #[inline(never)]
    pub(super) const fn bounds(&self, first: (i32, i32), last: (i32, i32)) -> (Raw, Raw) {
        let lo = Raw { x: self.start(first.0, &self.x), y: self.start(first.1, &self.y) };
        let hi = Raw { x: self.end_of(last.0, &self.x), y: self.end_of(last.1, &self.y) };
        (lo, hi)
    }

    const fn start(&self, index: i32, span: &GridAxis) -> i32 {
        if index < 0 { 1 - DOMAIN } else { span.origin.wrapping_add(self.line(index)) }
    }

    const fn end_of(&self, index: i32, span: &GridAxis) -> i32 {
        if index >= span.count as i32 { DOMAIN - 1 } else { span.origin.wrapping_add(self.line(index.wrapping_add(1))) }
    }
}

/// One axis, if both ends are inside the domain: the product is below 2^39.
const fn span(origin: i32, count: u16, cell: i32, what: Quantity) -> Result<GridAxis, TileMapError> {
    let size = count as i64 * cell as i64;
    let end = origin as i64 + size;
    if origin <= -DOMAIN || origin >= DOMAIN {
        Err(TileMapError::OutOfDomain { what, value: origin })
    } else if end >= DOMAIN as i64 {
        let value = if end > i32::MAX as i64 { i32::MAX } else { end as i32 };
        Err(TileMapError::OutOfDomain { what, value })
    } else {
        Ok(GridAxis { origin, size: size as i32, count: count as u32 })
    }
}

/// The multiplier of [`Grid::quotient`] and the log2, for `2^8 <= cell <= 2^24`. Runs once per map;
/// mostly in the compiler.
const fn magic(cell: u32) -> (u32, u32) {
    let log = 31 - leading_zeros32(cell);
    if cell.is_power_of_two() {
        return (0, log);
    }
    // The floor of 2^(31 + log) / cell, one bit per step, without a 64-bit division: the remainder
    // stays below the cell.
    let (mut floor, mut rem, mut step) = (0u32, 1 << log, 0);
    while step < 31 {
        rem <<= 1;
        floor <<= 1;
        if rem >= cell {
            rem = rem.wrapping_sub(cell);
            floor |= 1;
        }
        step += 1;
    }
    // No power of two divides evenly: the ceiling is one more than the floor.
    (floor.wrapping_add(1), log)
}
