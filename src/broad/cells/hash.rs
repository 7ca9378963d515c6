//! Bodies in cells of an unbounded world.

use super::factor::factor;
use super::lists::{Links, Lists};
use super::near::{last_ring, ring};
use super::pairs::{Near, pairs};
use super::path::{along, is_short};
use super::{At, Lattice, Window, is_free};
use crate::broad::cursor::Meter;
use crate::broad::spatial::{Spatial, square};
use crate::broad::table::{Bodies, NIL, Slots, Table, touch};
use crate::broad::{BroadError, BroadPhase, GridError, Handle, Pair, PairCursor, PairsError, Tag};
use crate::num::{Fx, Raw, Toi, Vec2};
use crate::shape::Aabb;

/// Up to N bodies in square cells of which there is no end, each in the cell of its centre; cells share BUCKETS lists.
///
/// For worlds that are much wider than what is in them. Cell (x, y) has list `x + K y`, of BUCKETS as the last bits say, a power of two from 64 to 32768, with a factor K for each such
/// that no two cells of a window of w x h cells share a list where `(w - 1) (h - 1)` is at most a quarter of the buckets, and w and h at most all of
/// them: in what a screen shows nothing collides, and never do a cell and its neighbours. What shares a list costs tests of boxes, and answers stay the same.
///
/// Bodies with longer sides than a cell are refused as [`TooLarge`](BroadError::TooLarge), or with `LARGE` kept in a list of their own, as by a [`LooseGrid`](crate::broad::LooseGrid), which also
/// says the costs. Queries of regions look at each cell or at each body, whichever are fewer. RAM: 6 bytes a body and 2 a bucket,
/// beside box, tag and the generation's 2 bytes.
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
#[derive(Clone, Copy, Debug)]
pub struct SpatialHash<const BUCKETS: usize, const N: usize, T = (), const LARGE: bool = false> {
    table: Table<T, N>,
    lattice: Lattice,
    heads: [u16; BUCKETS],
    links: Links<N>,
}

impl<const BUCKETS: usize, const N: usize, T: Tag, const LARGE: bool> SpatialHash<BUCKETS, N, T, LARGE> {
    const FACTOR: u16 = factor(BUCKETS);

    /// An empty one, which may be a `static`, with the side of its cells: a power of two of raw units (so of units as well), from 2 raw to 4096 units.
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

    #[inline]
    fn lists(&self) -> Lists<'_> {
        self.links.lists(&[], &self.heads)
    }

    /// The bodies of one cell: others in its list are of other cells.
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

    /// The bodies of a window of cells.
    fn bodies_in(&self, window: &Window, mut each: impl FnMut(usize, &Aabb)) {
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

impl<const BUCKETS: usize, const N: usize, T: Tag, const LARGE: bool> Spatial for SpatialHash<BUCKETS, N, T, LARGE> {
    type Tag = T;
    /// A list; NIL is that of large bodies.
    type Place = u16;

    fn table(&self) -> Bodies<'_, T> {
        self.table.bodies()
    }

    fn slots(&mut self) -> Slots<'_, T> {
        self.table.slots()
    }

    #[inline]
    fn admit(&self, bounds: &Aabb) -> Result<u16, BroadError> {
        if self.lattice.holds(bounds) {
            Ok(Self::bucket(self.lattice.at(bounds)))
        } else if LARGE {
            Ok(NIL)
        } else {
            Err(self.lattice.too_large(bounds))
        }
    }

    fn link(&mut self, slot: usize, place: u16) {
        self.links.lists_mut(&mut [], &mut self.heads).link(slot, place);
    }

    #[inline]
    fn relink(&mut self, slot: usize, place: u16) {
        if self.links.cell(slot) != place {
            self.unlink(slot);
            self.link(slot, place);
        }
    }

    #[inline]
    fn move_all(&mut self, mut to: impl FnMut(Handle, &Aabb) -> Aabb) -> Result<(), (Handle, BroadError)> {
        let (mut first, mut slot) = (Ok(()), 0);
        let lattice = self.lattice;
        loop {
            let cells = self.links.cells();
            let stays = |slot: usize, bounds: &Aabb| {
                cells.get(slot) == Some(&Self::bucket(lattice.at(bounds))) && lattice.holds(bounds)
            };
            let Some((moved, bounds)) = self.table.slots().set_while(slot, &mut to, stays) else { return first };
            let handle = self.table.bodies().handle(moved);
            if let Err(error) = self.move_to(handle, &bounds) {
                first = first.and(Err((handle, error)));
            }
            slot = moved + 1;
        }
    }

    fn unlink(&mut self, slot: usize) {
        self.links.lists_mut(&mut [], &mut self.heads).unlink(slot);
    }

    #[inline]
    fn walk<M: Meter>(
        &mut self,
        cursor: &mut PairCursor,
        meter: &mut M,
        each: impl FnMut(Pair) -> bool,
    ) -> Result<(), PairsError> {
        // Lists of a cell and its eight neighbours are nine different ones, so a neighbour is met in one list only.
        let near = Near { stride: usize::from(Self::FACTOR), mask: BUCKETS - 1 };
        pairs::<T, M, LARGE>(self.table.bodies(), self.lists(), near, cursor, meter, each)
    }

    #[inline]
    fn visit(&self, region: &Aabb, mut each: impl FnMut(usize)) {
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
        self.bodies_in(&window, found);
    }

    #[inline]
    fn visit_path(&self, start: &Aabb, motion: Raw, mut each: impl FnMut(usize) -> Toi) {
        if !is_short(&self.lattice, start, motion, self.table.bodies().bounds.len()) {
            let end = Aabb::from_raw_unchecked(start.lo().add(motion), start.hi().add(motion));
            return self.visit(&start.union(&end), |slot| {
                each(slot);
            });
        }
        let (lists, mut until) = (self.lists(), Toi::ONE);
        lists.from(lists.large).for_each(|slot| until = each(slot));
        along(
            &self.lattice,
            start,
            motion,
            |w| w,
            |window| {
                self.bodies_in(window, |slot, _| until = each(slot));
                until
            },
        );
    }

    #[inline]
    fn visit_near(&self, point: Raw, mut reach: i32, mut each: impl FnMut(usize) -> i32) {
        let (lists, mut left) = (self.lists(), self.table.bodies().bounds.len() as i32);
        lists.from(lists.large).for_each(|slot| reach = each(slot));
        let centre = self.lattice.at(&Aabb::from_raw_unchecked(point, point));
        for r in 0.. {
            let around = square(point, reach);
            let window = self.lattice.window(around.lo(), around.hi());
            if r > last_ring(centre, &window) {
                return;
            }
            left -= 8 * r + 1;
            if left < 0 {
                // More cells than bodies: those that are not in a ring before.
                return self.all().for_each(|(slot, bounds)| {
                    if self.links.cell(slot) != NIL && !self.lattice.at(bounds).is_within(r - 1, centre) {
                        each(slot);
                    }
                });
            }
            for part in ring(centre, r) {
                let part = Window { x: part.x.and(window.x), y: part.y.and(window.y) };
                self.bodies_in(&part, |slot, _| reach = each(slot));
            }
        }
    }
}
