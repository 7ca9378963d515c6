//! Every body against every other one.

use super::cursor::{Meter, Step};
use super::spatial::Spatial;
use super::table::{Bodies, Slots, Table};
use super::{BroadError, Handle, Pair, PairCursor, PairsError, Tag};
use crate::shape::Aabb;
use core::slice::Iter;

/// Up to N bodies, each tested against each: the fastest for a dozen, and the definition of what the others must find.
///
/// Cost: N (N - 1) / 2 tests of boxes, most of them two comparisons; an insertion or a move is a store. RAM: box, tag and the generation's 2 bytes.
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
#[derive(Clone, Copy, Debug)]
pub struct BruteForce<const N: usize, T = ()> {
    table: Table<T, N>,
}

impl<const N: usize, T: Tag> BruteForce<N, T> {
    /// An empty one; may be a `static`.
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

impl<const N: usize, T: Tag> Spatial for BruteForce<N, T> {
    type Tag = T;
    type Place = ();

    fn table(&self) -> Bodies<'_, T> {
        self.table.bodies()
    }

    fn slots(&mut self) -> Slots<'_, T> {
        self.table.slots()
    }

    fn admit(&self, _: &Aabb) -> Result<(), BroadError> {
        Ok(())
    }

    fn link(&mut self, _: usize, (): ()) {}

    fn relink(&mut self, _: usize, (): ()) {}

    fn unlink(&mut self, _: usize) {}

    fn walk<M: Meter>(
        &mut self,
        cursor: &mut PairCursor,
        meter: &mut M,
        each: impl FnMut(Pair) -> bool,
    ) -> Result<(), PairsError> {
        all_pairs(self.table.bodies(), cursor, meter, each)
    }

    fn visit(&self, region: &Aabb, each: impl FnMut(usize)) {
        self.table.bodies().touching(region, each);
    }

    fn move_all(&mut self, to: impl FnMut(Handle, &Aabb) -> Aabb) -> Result<(), (Handle, BroadError)> {
        self.table.slots().set_each(to);
        Ok(())
    }
}

/// The cursor: `a` is the row, `b` how many bodies after it are done.
fn all_pairs<T: Tag, M: Meter>(
    bodies: Bodies<'_, T>,
    cursor: &mut PairCursor,
    meter: &mut M,
    mut each: impl FnMut(Pair) -> bool,
) -> Result<(), PairsError> {
    let n = bodies.bounds.len();
    if let Some(mut scan) = Scan::new(bodies.bounds, cursor) {
        loop {
            let step = scan.next(meter);
            let (row, later) = (n - scan.rows.len() - 1, n - scan.later.len());
            let (stopped, next) = match step {
                Step::Pair if bodies.pair(row, later - 1).is_none_or(&mut each) => continue,
                Step::Pair => (PairsError::Full, later - 1),
                Step::Spent => (PairsError::BudgetExceeded, later),
                Step::End => break,
            };
            (cursor.a, cursor.b) = (row as u16, (next - row - 1) as u16);
            return Err(stopped);
        }
    }
    *cursor = PairCursor::new();
    Ok(())
}

struct Scan<'a> {
    row: &'a Aabb,
    /// The bodies after the row's.
    rows: Iter<'a, Aabb>,
    /// Those that it has still to be tested against.
    later: Iter<'a, Aabb>,
}

impl<'a> Scan<'a> {
    fn new(bounds: &'a [Aabb], cursor: &PairCursor) -> Option<Self> {
        let (row, rest) = bounds.get(usize::from(cursor.a)..)?.split_first()?;
        Some(Self { row, rows: rest.iter(), later: rest.get(usize::from(cursor.b)..)?.iter() })
    }

    /// Goes on to two boxes that touch. Apart from what is done with them, so that the box of the row stays in registers.
    #[inline(never)]
    fn next<M: Meter>(&mut self, meter: &mut M) -> Step {
        // Written back only where it ends, so that they are in registers until then.
        let Self { mut row, ref rows, ref later } = *self;
        let (mut rows, mut later) = (rows.clone(), later.clone());
        let step = 'found: loop {
            let (low, high) = (row.lo(), row.hi());
            while !later.as_slice().is_empty() {
                if !meter.spend() {
                    break 'found Step::Spent;
                }
                let Some(b) = later.next() else { break };
                if b.lo().x > high.x || b.hi().x < low.x {
                    continue;
                }
                if b.lo().y <= high.y && b.hi().y >= low.y {
                    break 'found Step::Pair;
                }
            }
            let Some(next) = rows.next() else { return Step::End };
            row = next;
            later = rows.clone();
        };
        *self = Self { row, rows, later };
        step
    }
}
