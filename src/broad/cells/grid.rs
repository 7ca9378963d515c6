//! Bodies in cells of a bounded world.

use super::lattice::{At, CellRows, Lattice, Window};
use super::lists::{Links, Lists, ListsMut, Neighbours};
use super::{InCells, Moving};
use crate::broad::table::{Bodies, HasTable, NIL, Slots, Table, touch};
use crate::broad::{BroadError, GridError, Tag};
use crate::num::{Fx, Vec2, check_coordinate};
use crate::shape::Aabb;

/// How a [`LooseGrid`] treats a body whose centre is outside its cells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Border {
    /// The body belongs to the nearest cell of the border. All answers stay the same, but many
    /// bodies outside cost as much as many in one cell.
    #[default]
    Clamp,
    /// The body is refused: [`OutOfWorld`](BroadError::OutOfWorld).
    Refuse,
}

/// Up to N bodies in a grid of square cells, each in the cell of its centre.
///
/// It suits hundreds of bodies in a world of known size.
///
/// ```text
///        columns (a power of two)
///      +----+----+----+----+--
///      |    | o  |    |    |        a body is in one list, wherever it reaches;
///      +----+----+----+----+--      no side of it is longer than a cell, so what it touches
///      |    |    | oo | o  |        is in one of nine cells
/// rows +----+----+----+----+--
/// ```
///
/// The grid has `BLOCKS` blocks of 32 cells each. A world of 2048 x 1024 units in cells of 32 has
/// 64 columns and 32 rows: 2048 cells, 64 blocks, as [`blocks_for`](LooseGrid::blocks_for)
/// computes. With `LARGE`, bodies with longer sides than a cell go into a separate list, and each
/// of them is tested against all bodies. Without it, they are refused as
/// [`TooLarge`](BroadError::TooLarge).
///
/// Cost: an insertion, a removal and a move are O(1); a move within a cell costs little more than
/// the store of the box. For pairs, a body is tested against five lists: the rest of its own cell's
/// list, and those of half of the neighbours. The worst case has all bodies in one cell: N (N - 1)
/// / 2 tests, as with [`BruteForce`](crate::broad::BruteForce); `pairs_from` has a budget for that.
/// Queries look at 32 empty cells at once; rays and casts visit only the cells along their path.
/// RAM: 6 bytes per body and 2.125 per cell (68 per block), beside box, tag and 2 bytes for the
/// generation.
///
/// ```
/// use tilesat::broad::{BroadError, BroadPhase, LooseGrid};
/// use tilesat::{Aabb, Fx, Vec2};
///
/// // 16 x 8 cells of 32 units.
/// let mut near = LooseGrid::<4, 64>::new(Vec2::ZERO, Fx::from_num(32), 16)?;
/// let at = |x, y| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + 10, y + 10));
/// let (a, b) = (near.insert(&at(25, 60)?, ())?, near.insert(&at(35, 70)?, ())?);
/// near.insert(&at(-400, 70)?, ())?; // outside: in a cell of the border
///
/// let mut pairs = Vec::new();
/// near.pairs(|pair| pairs.push((pair.a, pair.b)));
/// assert_eq!(pairs, [(a, b)]); // neighbours in different cells
///
/// let wall = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(500, 10))?;
/// assert!(matches!(near.insert(&wall, ()), Err(BroadError::TooLarge { .. })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(alias("uniform grid", "spatial partition"))]
pub struct LooseGrid<const BLOCKS: usize, const N: usize, T = (), const LARGE: bool = false> {
    pub(in crate::broad) table: Table<T, N>,
    pub(in crate::broad) lattice: Lattice,
    pub(in crate::broad) rows: CellRows,
    pub(in crate::broad) border: Border,
    occupied: [u32; BLOCKS],
    heads: [[u16; 32]; BLOCKS],
    links: Links<N>,
}

impl LooseGrid<1, 1> {
    /// How many blocks the cells of a world take.
    ///
    /// All three lengths are in the same unit. The columns are `width / cell` rounded up to a power
    /// of two of at least 4. The rows are `height / cell` rounded up, and a block has 32 cells. If
    /// that is 0, as with a `cell` of 0, or more than 2047, the compiler refuses such a grid.
    ///
    /// ```
    /// use tilesat::broad::LooseGrid;
    /// use tilesat::{Fx, Vec2};
    /// const BLOCKS: usize = LooseGrid::blocks_for(2048, 1024, 32);
    /// assert_eq!(BLOCKS, 64); // 64 columns, 32 rows
    /// assert!(LooseGrid::<BLOCKS, 200>::new(Vec2::ZERO, Fx::from_num(32), 64).is_ok());
    /// assert_eq!(LooseGrid::blocks_for(1000, 768, 32), 24); // 32 columns, 24 rows
    /// ```
    #[must_use]
    pub const fn blocks_for(width: u32, height: u32, cell: u32) -> usize {
        if cell == 0 {
            return 0;
        }
        let across = width.div_ceil(cell);
        // No world can have more columns than this, nor more cells.
        let columns = if across > 1 << 16 { 1 << 16 } else { across.next_power_of_two() };
        let cells = if columns < 4 { 4 } else { columns }.saturating_mul(height.div_ceil(cell));
        cells.div_ceil(32) as usize
    }
}

impl<const BLOCKS: usize, const N: usize, T: Tag, const LARGE: bool> LooseGrid<BLOCKS, N, T, LARGE> {
    /// An empty grid, which may be a `static`.
    ///
    /// Pass the corner with the smallest coordinates, the side of a cell, and the number of
    /// columns. A `static` grid takes as much flash as RAM, because its initial value is not all
    /// zeros. On a chip, build it when the program starts.
    ///
    /// The side is a power of two of raw units (so of units as well), and the columns are a power
    /// of two. So no index needs a division. The blocks give the number of rows. Bodies outside are
    /// [clamped](Border::Clamp).
    ///
    /// # Errors
    /// [`GridError`].
    ///
    /// ```
    /// use tilesat::broad::{BroadPhase, LooseGrid};
    /// use tilesat::{Fx, Vec2};
    /// static EMPTY: LooseGrid<24, 200> = match LooseGrid::new(Vec2::ZERO, Fx::const_from_int(32), 32) {
    ///     Ok(grid) => grid, // 32 x 24 cells
    ///     Err(_) => panic!(),
    /// };
    /// let level = EMPTY; // a copy is a snapshot
    /// assert!(level.is_empty());
    /// assert!(LooseGrid::<24, 200>::new(Vec2::ZERO, Fx::from_num(24), 32).is_err()); // not a power of two
    /// ```
    pub const fn new(origin: Vec2, cell: Fx, columns: u16) -> Result<Self, GridError> {
        const { check_blocks(BLOCKS) };
        if let Err(error) = check_coordinate(origin) {
            return Err(GridError::Origin(error));
        }
        let Some(lattice) = Lattice::new(origin, cell.to_bits()) else {
            return Err(GridError::Cell { side: cell.to_bits() });
        };
        let (cells, log) = (BLOCKS << 5, columns.trailing_zeros());
        if columns < 4 || !columns.is_power_of_two() || cells >> log << log != cells {
            return Err(GridError::Columns { columns, cells: cells as u16 });
        }
        Ok(Self {
            table: Table::new(),
            lattice,
            rows: CellRows { count: (cells >> log) as u16, log_columns: log as u8 },
            border: Border::Clamp,
            occupied: [0; BLOCKS],
            heads: [[NIL; 32]; BLOCKS],
            links: Links::new(),
        })
    }

    /// Sets the treatment of bodies outside, from the next insertion or move on.
    ///
    /// ```
    /// use tilesat::broad::{Border, BroadError, BroadPhase, LooseGrid};
    /// use tilesat::{Aabb, Vec2, fx};
    /// let mut near = LooseGrid::<4, 64>::new(Vec2::ZERO, fx!(32), 16)?.with_border(Border::Refuse);
    /// let outside = Aabb::new(Vec2::from_ints(-40, 0), Vec2::from_ints(-30, 8))?;
    /// assert!(matches!(near.insert(&outside, ()), Err(BroadError::OutOfWorld { .. })));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub const fn with_border(self, border: Border) -> Self {
        Self { border, ..self }
    }

    /// A cell beyond the grid: the one of the border that stands for it.
    #[cold]
    fn beyond(&self, at: At, bounds: &Aabb) -> Result<At, BroadError> {
        if self.border == Border::Refuse {
            let (x, y) = bounds.centre().raw();
            return Err(BroadError::OutOfWorld { x, y });
        }
        // Clamping coordinates to the grid keeps their order and increases no difference. So
        // neighbours stay neighbours.
        let last = self.rows.last();
        Ok(At { x: at.x.max(0).min(last.x), y: at.y.max(0).min(last.y) })
    }
}

impl<const BLOCKS: usize, const N: usize, T: Tag, const LARGE: bool> HasTable for LooseGrid<BLOCKS, N, T, LARGE> {
    type Tag = T;

    fn table(&self) -> Bodies<'_, T> {
        self.table.bodies()
    }

    fn slots(&mut self) -> Slots<'_, T> {
        self.table.slots()
    }
}

impl<const BLOCKS: usize, const N: usize, T: Tag, const LARGE: bool> InCells for LooseGrid<BLOCKS, N, T, LARGE> {
    const LARGE: bool = LARGE;
    const ENDLESS: bool = false;

    #[inline]
    fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    #[inline]
    fn lists(&self) -> Lists<'_> {
        self.links.lists(&self.occupied, self.heads.as_flattened())
    }

    #[inline]
    fn lists_mut(&mut self) -> ListsMut<'_> {
        self.links.lists_mut(&mut self.occupied, self.heads.as_flattened_mut())
    }

    #[inline]
    fn number(&self, bounds: &Aabb) -> Result<u16, BroadError> {
        let (mut at, last) = (self.lattice.at(bounds), self.rows.last());
        // One comparison per axis: negative numbers become large ones.
        if at.x as u32 > last.x as u32 || at.y as u32 > last.y as u32 {
            at = self.beyond(at, bounds)?;
        }
        Ok(self.rows.number(at) as u16)
    }

    #[inline]
    fn moving(&mut self) -> Moving<'_, T, impl Fn(u16, &Aabb) -> bool> {
        let (lattice, rows) = (self.lattice, self.rows);
        let stays = move |cell: u16, bounds: &Aabb| {
            // The number of no cell is one beyond the grid.
            lattice.at(bounds) == rows.place(cell) && lattice.holds(bounds) && !(LARGE && cell == NIL)
        };
        Moving { slots: self.table.slots(), numbers: self.links.cells(), stays }
    }

    #[inline]
    fn neighbours(&self) -> Neighbours {
        // The last cell of a row and the first of the next have adjacent numbers, but are not
        // neighbours. That only costs tests of boxes that do not touch: there are at least two
        // cells between them.
        Neighbours { stride: 1 << self.rows.log_columns(), mask: usize::MAX }
    }

    #[inline]
    fn clip(&self, window: Window) -> Window {
        self.rows.clip(window)
    }

    #[inline]
    fn bodies_in(&self, window: &Window, mut each: impl FnMut(usize)) {
        let lists = self.lists();
        self.rows.occupied(&self.occupied, window, |cell| lists.from(lists.head(cell)).for_each(&mut each));
    }

    #[inline]
    fn touching(&self, region: &Aabb, mut each: impl FnMut(usize)) {
        let (bodies, lists) = (self.table.bodies(), self.lists());
        let mut found = |slot| {
            if bodies.bounds.get(slot).is_some_and(|bounds| touch(bounds, region)) {
                each(slot);
            }
        };
        lists.from(lists.large).for_each(&mut found);
        self.bodies_in(&self.clip(self.lattice.window(region.lo(), region.hi())), found);
    }

    #[inline]
    fn rest(&self, _: i32, _: At, _: impl FnMut(usize)) {}
}

/// The compiler refuses other numbers of blocks.
pub(in crate::broad) const fn check_blocks(blocks: usize) {
    assert!(
        blocks > 0 && blocks < 2048,
        "the first parameter, BLOCKS, must be from 1 to 2047: LooseGrid<BLOCKS, N, T>"
    );
}
