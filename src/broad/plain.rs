//! Bodies without cells, tested each against every other one, or in the order of their left sides.

use super::order::{compact, sort};
use super::table::{Bodies, HasTable, Slots, Table};
use super::table::{Meter, Spatial, Stop};
use super::{BroadError, Handle, Pair, PairCursor, PairsError, Tag};
use crate::num::LONG;
use crate::shape::Aabb;
use core::slice::Iter;

/// The common part of both: they accept any box, and a query tests each.
macro_rules! any_box {
    ($place:ty) => {
        type Place = $place;

        fn relink(&mut self, _: usize, _: $place) {}

        fn move_all(&mut self, to: impl FnMut(Handle, &Aabb) -> Aabb) -> Result<(), (Handle, BroadError)> {
            self.table.slots().set_each(to);
            Ok(())
        }
    };
}

/// A search for boxes that touch: the body of a row against those that come after it, row by row.
trait PairScan {
    fn next<M: Meter>(&mut self, meter: &mut M) -> Stop;

    /// How many rows are left after this one, and against how many bodies it has still to be
    /// tested.
    fn left(&self) -> (usize, usize);

    /// The slots of the two boxes that it found last, of `n` places.
    fn found(&self, n: usize) -> (usize, usize);
}

/// Finds all pairs of `n` places. In the cursor, `a` is the row, and `b` the number of places after
/// it that are done.
fn pairs<T: Tag, M: Meter>(
    bodies: Bodies<'_, T>,
    n: usize,
    scan: Option<impl PairScan>,
    cursor: &mut PairCursor,
    meter: &mut M,
    mut each: impl FnMut(Pair) -> bool,
) -> Result<(), PairsError> {
    if let Some(mut scan) = scan {
        loop {
            let (stopped, again) = match scan.next(meter) {
                Stop::Pair => {
                    let (i, j) = scan.found(n);
                    if bodies.pair(i, j).is_none_or(&mut each) {
                        continue;
                    }
                    (PairsError::Full, 1)
                }
                Stop::Spent => (PairsError::BudgetExceeded, 0),
                Stop::End => break,
            };
            let (rows, later) = scan.left();
            (cursor.a, cursor.b) = ((n - rows - 1) as u16, (rows - later - again) as u16);
            return Err(stopped);
        }
    }
    *cursor = PairCursor::new();
    Ok(())
}

/// Up to N bodies, each tested against each.
///
/// It is the fastest for a dozen bodies, and defines the answers of the others.
///
/// Cost: N (N - 1) / 2 tests of boxes, most of them two comparisons; an insertion or a move is a
/// store. RAM: box, tag and 2 bytes for the generation.
///
/// ```
/// use tilesat::broad::{BroadPhase, BruteForce};
/// use tilesat::{Aabb, Vec2};
///
/// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
/// let mut near = BruteForce::<16>::new();
/// let (a, b, c) = (near.insert(&at(0)?, ())?, near.insert(&at(8)?, ())?, near.insert(&at(20)?, ())?);
///
/// let mut pairs = Vec::new();
/// near.pairs(|pair| pairs.push((pair.a, pair.b)));
/// assert_eq!(pairs, [(a, b)]); // their boxes touch
///
/// near.move_to(c, &at(15)?)?;
/// assert!(near.remove(a).is_ok() && near.remove(a).is_err()); // it is gone
/// near.pairs(|pair| assert_eq!((pair.a, pair.b), (b, c)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BruteForce<const N: usize, T = ()> {
    pub(super) table: Table<T, N>,
}

impl<const N: usize, T: Tag> BruteForce<N, T> {
    /// An empty broad phase.
    ///
    /// It may be a `static`, which takes no flash: all its bits are zero.
    #[must_use]
    pub const fn new() -> Self {
        Self { table: Table::new() }
    }
}

impl<const N: usize, T: Tag> Default for BruteForce<N, T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize, T: Tag> HasTable for BruteForce<N, T> {
    type Tag = T;

    fn table(&self) -> Bodies<'_, T> {
        self.table.bodies()
    }

    fn slots(&mut self) -> Slots<'_, T> {
        self.table.slots()
    }
}

impl<const N: usize, T: Tag> Spatial for BruteForce<N, T> {
    any_box!(());

    fn admit(&self, _: &Aabb) -> Result<(), BroadError> {
        Ok(())
    }

    fn visit(&self, region: &Aabb, each: impl FnMut(usize)) {
        self.table.bodies().touching(region, each);
    }

    fn link(&mut self, _: usize, (): ()) {}

    fn unlink(&mut self, _: usize) {}

    fn walk<M: Meter>(
        &mut self,
        cursor: &mut PairCursor,
        meter: &mut M,
        each: impl FnMut(Pair) -> bool,
    ) -> Result<(), PairsError> {
        let bodies = self.table.bodies();
        pairs(bodies, bodies.bounds.len(), EachScan::new(bodies.bounds, cursor), cursor, meter, each)
    }
}

struct EachScan<'a> {
    row: &'a Aabb,
    /// The bodies after the row's.
    rows: Iter<'a, Aabb>,
    /// The bodies against which the row has still to be tested.
    later: Iter<'a, Aabb>,
}

impl<'a> EachScan<'a> {
    fn new(bounds: &'a [Aabb], cursor: &PairCursor) -> Option<Self> {
        let (row, rest) = bounds.get(usize::from(cursor.a)..)?.split_first()?;
        Some(Self { row, rows: rest.iter(), later: rest.get(usize::from(cursor.b)..)?.iter() })
    }
}

impl PairScan for EachScan<'_> {
    /// Continues to two boxes that touch. Separate from the use of the pair: the box of the row
    /// stays in registers.
    #[inline(never)]
    fn next<M: Meter>(&mut self, meter: &mut M) -> Stop {
        // Written back only at the end, so they stay in registers until then.
        let Self { mut row, ref rows, ref later } = *self;
        let (mut rows, mut later) = (rows.clone(), later.clone());
        let step = 'found: loop {
            let (low, high) = (row.lo(), row.hi());
            while !later.as_slice().is_empty() {
                if !meter.spend() {
                    break 'found Stop::Spent;
                }
                let Some(b) = later.next() else { break };
                if b.lo().x > high.x || b.hi().x < low.x {
                    continue;
                }
                if b.lo().y <= high.y && b.hi().y >= low.y {
                    break 'found Stop::Pair;
                }
            }
            let Some(next) = rows.next() else { return Stop::End };
            row = next;
            later = rows.clone();
        };
        *self = Self { row, rows, later };
        step
    }

    fn left(&self) -> (usize, usize) {
        (self.rows.len(), self.later.len())
    }

    fn found(&self, n: usize) -> (usize, usize) {
        (n - self.rows.len() - 1, n - self.later.len() - 1)
    }
}

/// Up to N bodies, sorted by their left sides.
///
/// It is the fastest from a dozen to some hundreds of bodies of any size. A body is tested against
/// those whose left sides are within its extent in x. The order is kept from one enumeration to the
/// next, and bodies that move a little change it a little. If a world is higher than wide, or its
/// bodies fall in columns, exchange x and y.
///
/// ```text
///  a +-----+          order of left sides: a b c d
///    |   +-|--+ b     a is tested against b and c, which begin before its right side,
///    +---|-+  |       and no further: d begins beyond it, and so does all after d
///        +----+  +--+ d
///       c +---+  +--+
///         +---+
/// ```
///
/// Cost of an enumeration: first the shifts that restore the order, one for each two bodies that
/// changed places. After 8 N shifts, for example if all bodies were placed elsewhere, it runs a
/// heap sort of N log N steps. A frame of 256 bodies takes a Cortex-M0 some 40 000 instructions, or
/// 190 000 if all were placed elsewhere. Then comes a test of boxes for every two that touch in x,
/// and one more per body. If all touch in x, there are N (N - 1) / 2. Nothing is sorted if nothing
/// moved, or if an enumeration [continues](crate::broad::BroadPhase::pairs_from).
///
/// An insertion or a move is a store. A query of a region or a point tests the box of every body.
/// After an enumeration, as long as nothing moves, it tests only those that begin before the
/// region's right side. RAM: 2 bytes per body, beside box, tag and 2 bytes for the generation.
///
/// ```
/// use tilesat::broad::{BroadPhase, SortSweep};
/// use tilesat::{Aabb, Vec2};
///
/// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
/// let mut near = SortSweep::<64>::new();
/// let (a, b, c) = (near.insert(&at(20)?, ())?, near.insert(&at(8)?, ())?, near.insert(&at(0)?, ())?);
///
/// let mut pairs = Vec::new();
/// near.pairs(|pair| pairs.push((pair.a, pair.b)));
/// assert_eq!(pairs, [(b, c)]); // their boxes touch
///
/// near.move_each(|body, bounds| if body == a { at(15).unwrap_or(*bounds) } else { *bounds })
///     .map_err(|(_, error)| error)?;
/// near.remove(c)?;
/// near.pairs(|pair| assert_eq!((pair.a, pair.b), (a, b)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(alias("sweep and prune", "SAP"))]
pub struct SortSweep<const N: usize, T = ()> {
    pub(super) table: Table<T, N>,
    /// Every slot that was ever taken, once. Those that were in use at the last sort come first.
    pub(super) order: [u16; N],
    /// The number of sorted slots.
    pub(super) sorted: u16,
    /// A body was inserted or removed.
    pub(super) stale: bool,
    /// The epoch of the last sort.
    pub(super) epoch: u32,
}

impl<const N: usize, T: Tag> SortSweep<N, T> {
    /// An empty broad phase.
    ///
    /// It may be a `static`, which takes no flash: all its bits are zero.
    #[must_use]
    pub const fn new() -> Self {
        Self { table: Table::new(), order: [0; N], sorted: 0, stale: false, epoch: 0 }
    }
}

/// Whether the next body receives a slot that was never taken, which comes last in the order.
#[derive(Clone, Copy, Debug)]
pub struct NewSlot(bool);

impl<const N: usize, T: Tag> Default for SortSweep<N, T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize, T: Tag> HasTable for SortSweep<N, T> {
    type Tag = T;

    fn table(&self) -> Bodies<'_, T> {
        self.table.bodies()
    }

    fn slots(&mut self) -> Slots<'_, T> {
        self.table.slots()
    }
}

impl<const N: usize, T: Tag> Spatial for SortSweep<N, T> {
    any_box!(NewSlot);

    fn admit(&self, _: &Aabb) -> Result<NewSlot, BroadError> {
        Ok(NewSlot(self.table.state.free == 0))
    }

    /// Stops at the first body that begins beyond the region, if nothing came or moved since the
    /// last sort.
    fn visit(&self, region: &Aabb, mut each: impl FnMut(usize)) {
        let bodies = self.table.bodies();
        if bodies.state.moved || bodies.state.epoch != self.epoch {
            return bodies.touching(region, each);
        }
        let (low, high) = (region.lo(), region.hi());
        for &slot in self.order.get(..usize::from(self.sorted)).unwrap_or_default() {
            let Some(b) = bodies.bounds.get(usize::from(slot)) else { break };
            if b.lo().x > high.x {
                break;
            }
            // The right side of a free slot is before everything.
            if b.hi().x >= low.x && b.lo().y <= high.y && b.hi().y >= low.y {
                each(usize::from(slot));
            }
        }
    }

    fn link(&mut self, slot: usize, NewSlot(is_new): NewSlot) {
        self.stale = true;
        if let Some(last) = self.order.get_mut(slot).filter(|_| is_new) {
            *last = slot as u16;
        }
    }

    /// A free slot keeps its position in the order, and its left side: a running enumeration finds
    /// the others where they were.
    fn unlink(&mut self, _: usize) {
        self.stale = true;
    }

    fn walk<M: Meter>(
        &mut self,
        cursor: &mut PairCursor,
        meter: &mut M,
        each: impl FnMut(Pair) -> bool,
    ) -> Result<(), PairsError> {
        if (cursor.a, cursor.b) == (0, 0) {
            self.sort_if_changed();
        }
        let order = self.order.get(..usize::from(self.sorted)).unwrap_or_default();
        let bodies = self.table.bodies();
        pairs(bodies, order.len(), OrderedScan::new(order, bodies.bounds, cursor), cursor, meter, each)
    }
}

impl<const N: usize, T: Tag> SortSweep<N, T> {
    /// Sorts, unless nothing came or moved since. In that case an enumeration may be running, and
    /// the order must not change.
    #[inline]
    fn sort_if_changed(&mut self) {
        let epoch = self.table.slots().epoch();
        if self.epoch == epoch {
            return;
        }
        let bodies = self.table.bodies();
        if self.stale {
            let used = self.order.get_mut(..bodies.bounds.len()).unwrap_or_default();
            self.sorted = compact(used, bodies.generations);
            self.stale = false;
        }
        sort(self.order.get_mut(..usize::from(self.sorted)).unwrap_or_default(), bodies.bounds);
        self.epoch = epoch;
    }
}

struct OrderedScan<'a> {
    order: &'a [u16],
    bounds: &'a [Aabb],
    /// The slot whose pairs are looked for.
    row: u16,
    /// The slot that touches it. On narrow cores there are too few registers to keep it in one.
    other: u16,
    /// The slots after it.
    rows: Iter<'a, u16>,
    /// The slots against which the row has still to be tested.
    later: Iter<'a, u16>,
}

impl<'a> OrderedScan<'a> {
    fn new(order: &'a [u16], bounds: &'a [Aabb], cursor: &PairCursor) -> Option<Self> {
        let (&row, rest) = order.get(usize::from(cursor.a)..)?.split_first()?;
        Some(Self {
            order,
            bounds,
            row,
            other: row,
            rows: rest.iter(),
            later: rest.get(usize::from(cursor.b)..)?.iter(),
        })
    }
}

impl PairScan for OrderedScan<'_> {
    /// Continues to two boxes that touch. Separate from the use of the pair: the box of the row
    /// stays in registers.
    ///
    /// The next boxes begin at or beyond the row's left side. Each touches the row in x if it
    /// begins before the row's right side. The right side of a free slot is before everything, and
    /// as a later one a free slot fails in y.
    #[cfg_attr(not(target_pointer_width = "64"), inline(never))]
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    fn next<M: Meter>(&mut self, meter: &mut M) -> Stop {
        // Written back only at the end, so they stay in registers until then.
        let Self { order, bounds, mut row, ref rows, ref later, .. } = *self;
        let (mut rows, mut later) = (rows.clone(), later.clone());
        let (step, other) = 'found: loop {
            let Some(a) = bounds.get(usize::from(row)) else { return Stop::End };
            let (low, high) = (a.lo().y, a.hi());
            while !later.as_slice().is_empty() {
                if !meter.spend() {
                    break 'found (Stop::Spent, row);
                }
                let Some(&slot) = later.next() else { break };
                let Some(b) = bounds.get(usize::from(slot)) else { break };
                if b.lo().x > high.x {
                    break;
                }
                if b.lo().y <= high.y && b.hi().y >= low {
                    break 'found (Stop::Pair, if LONG { slot } else { row });
                }
            }
            let Some(&next) = rows.next() else { return Stop::End };
            row = next;
            later = rows.clone();
        };
        *self = Self { order, bounds, row, other, rows, later };
        step
    }

    fn left(&self) -> (usize, usize) {
        (self.rows.len(), self.later.len())
    }

    fn found(&self, n: usize) -> (usize, usize) {
        let last = || self.order.get(n - self.later.len() - 1).copied().unwrap_or(self.row);
        (usize::from(self.row), usize::from(if LONG { self.other } else { last() }))
    }
}
