//! What each broad phase does in its own way; the rest is the same for all.

use super::cursor::Meter;
use super::table::{Bodies, Slots};
use super::{BroadError, Handle, Pair, PairCursor, PairsError, Tag};
use crate::num::{DOMAIN, Raw, Toi};
use crate::shape::Aabb;

/// How bodies are found, each broad phase in its own way.
///
/// Sealed: nothing outside of the crate implements it or needs to name it. The public face is [`BroadPhase`](super::BroadPhase), which has its
/// [`Tag`](Self::Tag).
pub trait Spatial: Sized {
    /// What bodies carry.
    type Tag: Tag;
    /// Where a box belongs.
    type Place: Copy;

    /// The slots that were ever taken, for reading.
    fn table(&self) -> Bodies<'_, Self::Tag>;

    /// The slots, for writing.
    fn slots(&mut self) -> Slots<'_, Self::Tag>;

    /// Where a box would belong, if it can be taken at all.
    ///
    /// # Errors
    /// `TooLarge` and `OutOfWorld`.
    fn admit(&self, bounds: &Aabb) -> Result<Self::Place, BroadError>;

    /// Takes a new body of the table in.
    fn link(&mut self, slot: usize, place: Self::Place);

    /// The body has another box now; in the table too.
    fn relink(&mut self, slot: usize, place: Self::Place);

    /// Moves every body.
    ///
    /// # Errors
    /// The first refusal, with the body.
    #[inline]
    fn move_all(&mut self, mut to: impl FnMut(Handle, &Aabb) -> Aabb) -> Result<(), (Handle, BroadError)> {
        let mut first = Ok(());
        for slot in 0..self.table().bounds.len() {
            let bodies = self.table();
            let handle = bodies.handle(slot);
            let Some(bounds) = bodies.bounds.get(slot).filter(|_| handle.is_taken()) else { continue };
            let bounds = to(handle, bounds);
            match self.admit(&bounds) {
                Ok(place) => {
                    self.slots().set_bounds(slot, &bounds);
                    self.relink(slot, place);
                }
                Err(error) => first = first.and(Err((handle, error))),
            }
        }
        first
    }

    /// The body is about to leave the table.
    fn unlink(&mut self, slot: usize);

    /// All pairs from the cursor on, each once. Where `each` has no room the pair comes again.
    ///
    /// # Errors
    /// `BudgetExceeded` and `Full`, with the cursor where it has to go on; at the end it is at the start.
    fn walk<M: Meter>(
        &mut self,
        cursor: &mut PairCursor,
        meter: &mut M,
        each: impl FnMut(Pair) -> bool,
    ) -> Result<(), PairsError>;

    /// The slots of all bodies whose boxes touch a region, each once, in any order.
    ///
    /// Boxes in the table may lie outside of the domain for a while ([`pairs_of`](super::BroadPhase::pairs_of)): they touch no region.
    fn visit(&self, region: &Aabb, each: impl FnMut(usize));

    /// The slots of all bodies whose boxes a box touches on its way, borders and both ends included, each once, in any order; other bodies may
    /// come, too. The box may be a point. Both ends of the way are in the domain.
    ///
    /// `each` answers which part of the way still matters: a body that is touched later than the last answer, in whole parts of 2^30, need not come.
    fn visit_path(&self, start: &Aabb, motion: Raw, mut each: impl FnMut(usize) -> Toi) {
        let end = Aabb::from_raw_unchecked(start.lo().add(motion), start.hi().add(motion));
        self.visit(&start.union(&end), |slot| {
            each(slot);
        });
    }

    /// The slots of all bodies whose boxes touch the square around a point that reaches so far to each side, each once, in any order; other
    /// bodies may come, too. The point is in the domain and `reach` is not negative.
    ///
    /// `each` answers how far the square that still matters reaches: what touches only the rest need not come.
    fn visit_near(&self, point: Raw, reach: i32, mut each: impl FnMut(usize) -> i32) {
        self.visit(&square(point, reach), |slot| {
            each(slot);
        });
    }
}

/// The part of a square that is in the domain, where all boxes are.
pub(super) fn square(centre: Raw, reach: i32) -> Aabb {
    let low = |v: i32| v.saturating_sub(reach).max(1 - DOMAIN);
    let high = |v: i32| v.saturating_add(reach).min(DOMAIN - 1);
    Aabb::from_raw_unchecked(Raw { x: low(centre.x), y: low(centre.y) }, Raw { x: high(centre.x), y: high(centre.y) })
}
