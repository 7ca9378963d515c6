//! Bodies in cells of an unbounded world.

use super::lattice::{At, Lattice, Window, is_free};
use super::lists::{Links, Lists, ListsMut, Neighbours};
use super::{InCells, Moving};
use crate::broad::table::{Bodies, HasTable, NIL, Slots, Table, touch};
use crate::broad::{BroadError, GridError, Tag};
use crate::num::{Fx, Vec2};
use crate::shape::Aabb;

/// Up to N bodies in an endless grid of square cells, each in the cell of its centre.
///
/// The cells share BUCKETS lists. It suits worlds that are much larger than the bodies in them.
/// Cell (x, y) has list `x + K y`, modulo BUCKETS, a power of two from 64 to 32 768. The factor K
/// spreads near cells. In a window of w x h cells, no two share a list if `(w - 1) (h - 1)` is at
/// most a quarter of BUCKETS. Both w and h must be at most BUCKETS. Within a screen nothing
/// collides, and a cell never collides with its neighbours. Cells that share a list cost tests of
/// boxes; answers stay the same.
///
/// Bodies with longer sides than a cell are refused as [`TooLarge`](BroadError::TooLarge). With
/// `LARGE` they go into a separate list, as in a [`LooseGrid`](crate::broad::LooseGrid), which also
/// documents the costs. Queries of regions look at each cell or at each body, whichever are fewer.
/// RAM: 6 bytes per body and 2 per bucket, beside box, tag and 2 bytes for the generation.
///
/// ```
/// use tilesat::broad::{BroadPhase, SpatialHash};
/// use tilesat::{Aabb, Fx, Vec2};
///
/// let mut near = SpatialHash::<64, 32>::new(Fx::from_num(32))?;
/// let at = |x, y| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + 10, y + 10));
/// let (a, b) = (near.insert(&at(-6005, 60)?, ())?, near.insert(&at(-6010, 70)?, ())?);
/// near.insert(&at(7000, -7000)?, ())?;
///
/// let mut pairs = Vec::new();
/// near.pairs(|pair| pairs.push((pair.a, pair.b)));
/// assert_eq!(pairs, [(a, b)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(alias("hash grid", "spatial hashing"))]
pub struct SpatialHash<const BUCKETS: usize, const N: usize, T = (), const LARGE: bool = false> {
    pub(in crate::broad) table: Table<T, N>,
    pub(in crate::broad) lattice: Lattice,
    heads: [u16; BUCKETS],
    links: Links<N>,
}

impl<const BUCKETS: usize, const N: usize, T: Tag, const LARGE: bool> SpatialHash<BUCKETS, N, T, LARGE> {
    const FACTOR: u16 = factor(BUCKETS);

    /// An empty broad phase with the given side of its cells.
    ///
    /// The side is a power of two of raw units (so of units as well), from 2 raw to 4096 units. It
    /// may be a `static`, which takes as much flash as RAM, like a
    /// [`LooseGrid`](crate::broad::LooseGrid::new).
    ///
    /// # Errors
    /// [`GridError::Cell`].
    pub const fn new(cell: Fx) -> Result<Self, GridError> {
        let Some(lattice) = Lattice::new(Vec2::ZERO, cell.to_bits()) else {
            return Err(GridError::Cell { side: cell.to_bits() });
        };
        Ok(Self { table: Table::new(), lattice, heads: [NIL; BUCKETS], links: Links::new() })
    }

    /// The list of a cell.
    #[inline]
    fn bucket(at: At) -> u16 {
        (at.x.wrapping_add(at.y.wrapping_mul(i32::from(Self::FACTOR))) as usize & (BUCKETS - 1)) as u16
    }

    /// The bodies of one cell, without those of other cells in its list.
    #[inline]
    fn bodies_at(&self, at: At, mut each: impl FnMut(usize, &Aabb)) {
        let (bodies, lists) = (self.table.bodies(), self.lists());
        for slot in lists.from(lists.head(usize::from(Self::bucket(at)))) {
            match bodies.bounds.get(slot) {
                Some(bounds) if self.lattice.at(bounds) == at => each(slot, bounds),
                _ => {}
            }
        }
    }

    /// The bodies of a window, with their boxes of cells.
    fn boxes_in(&self, window: &Window, mut each: impl FnMut(usize, &Aabb)) {
        for y in window.y.lo..=window.y.hi {
            for x in window.x.lo..=window.x.hi {
                self.bodies_at(At { x, y }, &mut each);
            }
        }
    }

    /// All bodies, large ones too.
    fn all(&self) -> impl Iterator<Item = (usize, &Aabb)> {
        self.table.bodies().bounds.iter().enumerate().filter(|(_, bounds)| !is_free(bounds))
    }
}

impl<const BUCKETS: usize, const N: usize, T: Tag, const LARGE: bool> HasTable for SpatialHash<BUCKETS, N, T, LARGE> {
    type Tag = T;

    fn table(&self) -> Bodies<'_, T> {
        self.table.bodies()
    }

    fn slots(&mut self) -> Slots<'_, T> {
        self.table.slots()
    }
}

impl<const BUCKETS: usize, const N: usize, T: Tag, const LARGE: bool> InCells for SpatialHash<BUCKETS, N, T, LARGE> {
    const LARGE: bool = LARGE;
    const ENDLESS: bool = true;

    #[inline]
    fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    #[inline]
    fn lists(&self) -> Lists<'_> {
        self.links.lists(&[], &self.heads)
    }

    #[inline]
    fn lists_mut(&mut self) -> ListsMut<'_> {
        self.links.lists_mut(&mut [], &mut self.heads)
    }

    #[inline]
    fn number(&self, bounds: &Aabb) -> Result<u16, BroadError> {
        Ok(Self::bucket(self.lattice.at(bounds)))
    }

    #[inline]
    fn moving(&mut self) -> Moving<'_, T, impl Fn(u16, &Aabb) -> bool> {
        let lattice = self.lattice;
        let stays = move |cell, bounds: &Aabb| cell == Self::bucket(lattice.at(bounds)) && lattice.holds(bounds);
        Moving { slots: self.table.slots(), numbers: self.links.cells(), stays }
    }

    #[inline]
    fn neighbours(&self) -> Neighbours {
        // A cell and its eight neighbours have nine different lists. So each neighbour is in only
        // one of them.
        Neighbours { stride: usize::from(Self::FACTOR), mask: BUCKETS - 1 }
    }

    #[inline]
    fn clip(&self, window: Window) -> Window {
        window
    }

    #[inline]
    fn bodies_in(&self, window: &Window, mut each: impl FnMut(usize)) {
        self.boxes_in(window, |slot, _| each(slot));
    }

    #[inline]
    fn touching(&self, region: &Aabb, mut each: impl FnMut(usize)) {
        let mut found = |slot, bounds: &Aabb| {
            if touch(bounds, region) {
                each(slot);
            }
        };
        let window = self.lattice.window(region.lo(), region.hi());
        if window.cells_of(self.table.bodies().bounds.len()).is_none() {
            return self.all().for_each(|(slot, bounds)| found(slot, bounds));
        }
        let (bodies, lists) = (self.table.bodies(), self.lists());
        for slot in lists.from(lists.large) {
            if let Some(bounds) = bodies.bounds.get(slot) {
                found(slot, bounds);
            }
        }
        self.boxes_in(&window, found);
    }

    #[inline]
    fn rest(&self, r: i32, centre: At, mut each: impl FnMut(usize)) {
        let lists = self.lists();
        self.all().for_each(|(slot, bounds)| {
            if lists.cell_of(slot) != NIL && !self.lattice.at(bounds).is_within(r - 1, centre) {
                each(slot);
            }
        });
    }
}

/// Factors for 2^6 to 2^15 buckets.
///
/// Two cells share a list if `x + K y` of their distance (x, y) is a multiple of the number of
/// buckets B. Such distances form a lattice. Each factor is odd, so no two cells of a column of B
/// cells share a list. Of all factors, each has the largest least `|x y|` among the distances with
/// neither 0: at least B / 4. The factor nearest to B times the golden ratio would suit only some
/// B.
const FACTORS: [u16; 10] = [19, 47, 75, 149, 275, 791, 1557, 2431, 6229, 12031];

/// The factor for a number of buckets. The compiler refuses numbers without one.
pub(in crate::broad) const fn factor(buckets: usize) -> u16 {
    assert!(
        buckets.is_power_of_two() && buckets >= 64 && buckets <= 32_768,
        "the first parameter, BUCKETS, must be a power of two from 64 to 32768: SpatialHash<BUCKETS, N, T>"
    );
    let (mut rest, mut log) = (FACTORS.as_slice(), buckets.trailing_zeros() - 6);
    loop {
        match rest {
            [first, ..] if log == 0 => return *first,
            [_, tail @ ..] => (rest, log) = (tail, log - 1),
            [] => return 1,
        }
    }
}
