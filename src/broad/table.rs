//! The bodies of a broad phase by slot: boxes, tags and generations; and the operations that each
//! broad phase implements.
//!
//! Also the state of an enumeration of pairs, and its budget.

use super::{BroadError, Handle, Pair, PairsError, Tag};
use crate::num::{DOMAIN, Raw, Toi};
use crate::shape::Aabb;

/// N slots; plain data: a copy is a snapshot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Table<T, const N: usize> {
    pub(super) bounds: [Aabb; N],
    pub(super) tags: [T; N],
    /// Odd if the slot is taken.
    pub(super) generations: [u16; N],
    pub(super) state: State,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct State {
    /// One more than the slot freed last, or 0. An empty table is all zeros, so a static one takes
    /// no flash.
    pub(super) free: u16,
    /// Slots from here on were never taken.
    pub(super) top: u16,
    pub(super) len: u16,
    /// A body came or moved in this epoch.
    pub(super) moved: bool,
    /// Counts changes that disturb an enumeration. It steps at most once per enumeration, so it
    /// does not wrap while one is running.
    pub(super) epoch: u32,
}

impl State {
    /// The slot of the body that is inserted next; one that does not exist if there is no room.
    #[inline]
    pub(crate) fn next_slot(self) -> usize {
        self.free.checked_sub(1).unwrap_or(self.top).into()
    }
}

/// No slot.
pub(super) const NIL: u16 = u16::MAX;

/// A slot without a body: no box touches it. It keeps the left side, so an order by left sides
/// stays as it is. The last word is one more than the next free slot, or 0.
pub(super) const fn dead(left: i32, next: u16) -> Aabb {
    Aabb::from_raw_unchecked(Raw { x: left, y: i32::MAX }, Raw { x: i32::MIN, y: next as i32 })
}

/// Whether two boxes have a point in common. False if one is of a free slot.
#[inline]
pub(super) fn touch(a: &Aabb, b: &Aabb) -> bool {
    let (alo, ahi, blo, bhi) = (a.lo(), a.hi(), b.lo(), b.hi());
    alo.x <= bhi.x && blo.x <= ahi.x && alo.y <= bhi.y && blo.y <= ahi.y
}

/// The slots in use, for reading.
#[derive(Clone, Copy, Debug)]
pub struct Bodies<'a, T> {
    pub(super) bounds: &'a [Aabb],
    pub(super) tags: &'a [T],
    pub(super) generations: &'a [u16],
    pub(crate) state: State,
}

/// All slots, for writing.
#[derive(Debug)]
pub struct Slots<'a, T> {
    pub(super) bounds: &'a mut [Aabb],
    tags: &'a mut [T],
    generations: &'a mut [u16],
    state: &'a mut State,
}

/// The compiler refuses more bodies than a list can link.
pub(super) const fn check_bodies(n: usize) {
    assert!(n < NIL as usize, "the parameter N, the most bodies, must be at most 65534");
}

impl<T: Tag, const N: usize> Table<T, N> {
    pub(super) const fn new() -> Self {
        const { check_bodies(N) };
        Self {
            bounds: [Aabb::from_raw_unchecked(Raw::ZERO, Raw::ZERO); N],
            tags: [T::BLANK; N],
            generations: [0; N],
            state: State { free: 0, top: 0, len: 0, moved: false, epoch: 0 },
        }
    }

    /// The slots that were ever taken: all bodies are among them.
    #[inline]
    pub(super) fn bodies(&self) -> Bodies<'_, T> {
        let top = usize::from(self.state.top);
        Bodies {
            bounds: self.bounds.get(..top).unwrap_or_default(),
            tags: self.tags.get(..top).unwrap_or_default(),
            generations: self.generations.get(..top).unwrap_or_default(),
            state: self.state,
        }
    }

    #[inline]
    pub(super) fn slots(&mut self) -> Slots<'_, T> {
        Slots {
            bounds: &mut self.bounds,
            tags: &mut self.tags,
            generations: &mut self.generations,
            state: &mut self.state,
        }
    }
}

impl<'a, T: Tag> Bodies<'a, T> {
    /// The bodies that are here, by slot.
    pub(super) fn iter(self) -> impl Iterator<Item = (Handle, Aabb, T)> + use<'a, T> {
        let slots = self.generations.iter().zip(self.bounds).zip(self.tags).enumerate();
        slots
            .map(|(slot, ((generation, bounds), tag))| (Handle::new(slot, *generation), *bounds, *tag))
            .filter(|(handle, ..)| handle.is_taken())
    }
}

impl<T: Tag> Bodies<'_, T> {
    /// The handle of the body of a slot.
    #[inline]
    pub(crate) fn handle(&self, slot: usize) -> Handle {
        Handle::new(slot, self.generations.get(slot).copied().unwrap_or(0))
    }

    /// The slot of a body that is here.
    #[inline]
    pub(super) fn slot(&self, handle: Handle) -> Result<usize, BroadError> {
        let slot = handle.slot();
        // No handle has an even generation.
        if self.generations.get(slot) == Some(&handle.generation()) { Ok(slot) } else { Err(BroadError::Stale(handle)) }
    }

    /// The slots of all bodies whose boxes touch a region, one after the other.
    #[inline]
    pub(super) fn touching(&self, region: &Aabb, mut each: impl FnMut(usize)) {
        for (slot, bounds) in self.bounds.iter().enumerate() {
            if touch(bounds, region) {
                each(slot);
            }
        }
    }

    /// The bodies of two slots as a pair, if they may pair: the smaller key first, then the smaller
    /// slot.
    ///
    /// Test the boxes first. A frame of 64 bodies, each against each, then takes a Cortex-M0 31 600
    /// instructions, whatever the masks are. With masks before boxes it takes 69 300 if all may
    /// pair, and 45 100 if none may. The reason is that a test of boxes mostly ends at its first
    /// comparison.
    #[inline]
    pub(super) fn pair(&self, i: usize, j: usize) -> Option<Pair> {
        let (Some(a), Some(b)) = (self.tags.get(i), self.tags.get(j)) else { return None };
        if !a.pairs_with(b) {
            return None;
        }
        let (i, j) = if (a.key(), i) <= (b.key(), j) { (i, j) } else { (j, i) };
        Some(Pair { a: self.handle(i), b: self.handle(j) })
    }
}

impl<T: Tag> Slots<'_, T> {
    pub(super) fn insert(&mut self, bounds: &Aabb, tag: T) -> Result<Handle, BroadError> {
        let slot = self.state.next_slot();
        let places = (self.bounds.get_mut(slot), self.tags.get_mut(slot), self.generations.get_mut(slot));
        let (Some(place), Some(own), Some(generation)) = places else {
            return Err(BroadError::Full { capacity: self.bounds.len() as u16 });
        };
        if self.state.free != 0 {
            self.state.free = place.hi().y as u16;
        } else {
            self.state.top += 1;
        }
        (*place, *own) = (*bounds, tag);
        *generation = generation.wrapping_add(1);
        self.state.len += 1;
        self.state.moved = true;
        Ok(Handle::new(slot, *generation))
    }

    /// Frees the slot of a body, and returns its tag. The slot keeps only the left side of its box.
    /// So two broad phases are equal whatever was removed, also after a round trip through serde.
    pub(super) fn remove(&mut self, slot: usize) -> T {
        let places = (self.bounds.get_mut(slot), self.tags.get_mut(slot), self.generations.get_mut(slot));
        let (Some(place), Some(own), Some(generation)) = places else { return T::BLANK };
        *place = dead(place.lo().x, self.state.free);
        *generation = generation.wrapping_add(1);
        self.state.free = (slot as u16).wrapping_add(1);
        self.state.len -= 1;
        core::mem::replace(own, T::BLANK)
    }

    #[inline]
    pub(super) fn set_bounds(&mut self, slot: usize, bounds: &Aabb) {
        if let Some(place) = self.bounds.get_mut(slot) {
            *place = *bounds;
        }
        self.state.moved = true;
    }

    /// Sets the box of every body, for broad phases that accept any box.
    #[inline]
    pub(super) fn set_each(&mut self, to: impl FnMut(Handle, &Aabb) -> Aabb) {
        self.set_while(0, to, |_, _| true);
    }

    /// Sets the boxes of bodies from a slot on, as long as `keep` accepts them. The first that it
    /// refuses is left to the caller.
    #[inline]
    pub(super) fn set_while(
        &mut self,
        from: usize,
        mut to: impl FnMut(Handle, &Aabb) -> Aabb,
        mut keep: impl FnMut(usize, &Aabb) -> bool,
    ) -> Option<(usize, Aabb)> {
        self.state.moved = true;
        let top = usize::from(self.state.top);
        let (bounds, generations) = (self.bounds.get_mut(from..top)?, self.generations.get(from..top)?);
        for (slot, (place, generation)) in (from..).zip(bounds.iter_mut().zip(generations)) {
            let handle = Handle::new(slot, *generation);
            if handle.is_taken() {
                let new = to(handle, place);
                if !keep(slot, &new) {
                    return Some((slot, new));
                }
                *place = new;
            }
        }
        None
    }

    /// The current epoch: a new one if bodies came or moved.
    #[inline]
    pub(super) fn epoch(&mut self) -> u32 {
        if self.state.moved {
            self.state.moved = false;
            self.state.epoch = self.state.epoch.wrapping_add(1);
        }
        self.state.epoch
    }

    pub(super) fn set_tag(&mut self, slot: usize, tag: T) {
        if let Some(own) = self.tags.get_mut(slot) {
            *own = tag;
        }
    }
}

/// The bodies of a broad phase, in their slots.
pub trait HasTable: Sized {
    /// The tag that bodies carry.
    type Tag: Tag;

    /// The slots that were ever taken, for reading.
    fn table(&self) -> Bodies<'_, Self::Tag>;

    /// The slots, for writing.
    fn slots(&mut self) -> Slots<'_, Self::Tag>;
}

/// How a broad phase finds bodies.
///
/// Sealed: nothing outside the crate implements it or needs to name it. The public face is
/// [`BroadPhase`](super::BroadPhase), which has its [`Tag`](HasTable::Tag).
pub trait Spatial: HasTable {
    /// The position of a box in the structure.
    type Place: Copy;

    /// The position of a box in the structure, if it is allowed.
    ///
    /// # Errors
    /// `TooLarge` and `OutOfWorld`.
    fn admit(&self, bounds: &Aabb) -> Result<Self::Place, BroadError>;

    /// Inserts a new body of the table.
    fn link(&mut self, slot: usize, place: Self::Place);

    /// Updates a body whose box in the table has changed.
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

    /// Removes a body that is about to leave the table.
    fn unlink(&mut self, slot: usize);

    /// Clears what a free slot keeps of its last body for enumerations. Call it only if no
    /// enumeration is running, as in a scene.
    fn forget(&mut self, _slot: usize) {}

    /// All pairs from the cursor on, each once. If `each` has no room, the pair comes again.
    ///
    /// # Errors
    /// `BudgetExceeded` and `Full`, with the cursor at the position to continue; at the end it is
    /// at the start.
    fn walk<M: Meter>(
        &mut self,
        cursor: &mut PairCursor,
        meter: &mut M,
        each: impl FnMut(Pair) -> bool,
    ) -> Result<(), PairsError>;

    /// The slots of all bodies whose boxes touch a region, each once, in any order.
    ///
    /// Boxes in the table may lie outside the domain for a while
    /// ([`pairs_of`](super::BroadPhase::pairs_of)): they touch no region.
    fn visit(&self, region: &Aabb, each: impl FnMut(usize));

    /// The slots of all bodies whose boxes a moving box touches, borders and both ends included,
    /// each once, in any order. Other bodies may be included. The box may be a point. Both ends of
    /// the motion are in the domain.
    ///
    /// `each` returns which part of the motion still matters. A body that is touched later than the
    /// last answer, in whole parts of 2^30, may be skipped.
    fn visit_path(&self, start: &Aabb, motion: Raw, mut each: impl FnMut(usize) -> Toi) {
        let end = Aabb::from_raw_unchecked(start.lo().add(motion), start.hi().add(motion));
        self.visit(&start.union(&end), |slot| {
            each(slot);
        });
    }

    /// The slots of all bodies whose boxes touch the square around a point with half side `reach`,
    /// each once, in any order. Other bodies may be included. The point is in the domain and
    /// `reach` is not negative.
    ///
    /// `each` returns the half side of the square that still matters. Bodies that touch only the
    /// rest may be skipped.
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

/// The state of an enumeration of pairs between two calls.
///
/// It is plain data, and its default is the start. It belongs to one broad phase. If you restore a
/// snapshot of the broad phase, also restore the cursor of that time, or begin with a new one.
/// Otherwise pairs may be missed. You may remove bodies between two calls. If one is inserted or
/// moved, the next call returns [`Changed`](PairsError::Changed) once, and the call after that
/// begins again.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PairCursor {
    pub(super) epoch: u32,
    pub(super) under_way: bool,
    /// The rest of the current row or cell, as each broad phase defines it.
    pub(super) row: u16,
    pub(super) a: u16,
    pub(super) b: u16,
    pub(super) lane: u8,
}

impl PairCursor {
    /// A cursor at the start.
    #[must_use]
    pub const fn new() -> Self {
        Self { epoch: 0, under_way: false, row: 0, a: 0, b: 0, lane: 0 }
    }

    /// Begins or continues.
    pub(super) fn resume(&mut self, epoch: u32) -> Result<(), PairsError> {
        if !self.under_way {
            *self = Self { epoch, under_way: true, ..Self::new() };
        } else if self.epoch != epoch {
            *self = Self::new();
            return Err(PairsError::Changed);
        }
        Ok(())
    }
}

/// Why a search for the next pair ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    /// Two boxes touch.
    Pair,
    /// The budget is spent.
    Spent,
    /// There are no more pairs.
    End,
}

/// Counts the tests of an enumeration, if it has a budget.
pub trait Meter {
    /// Takes one test from the budget. False if none is left.
    fn spend(&mut self) -> bool;
}

/// No budget, which costs nothing.
#[derive(Debug)]
pub(super) struct Unlimited;

impl Meter for Unlimited {
    #[inline]
    fn spend(&mut self) -> bool {
        true
    }
}

/// A budget of this many tests.
#[derive(Debug)]
pub(super) struct Budget(pub(super) u32);

impl Meter for Budget {
    #[inline]
    fn spend(&mut self) -> bool {
        match self.0.checked_sub(1) {
            Some(rest) => {
                self.0 = rest;
                true
            }
            None => false,
        }
    }
}
