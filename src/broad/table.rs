//! The bodies of a broad phase: boxes, tags and generations, by slot.

use super::{BroadError, Handle, Pair, Tag};
use crate::num::Raw;
use crate::shape::Aabb;

/// N slots; plain data: a copy is a snapshot.
#[derive(Clone, Copy, Debug)]
pub(super) struct Table<T, const N: usize> {
    bounds: [Aabb; N],
    tags: [T; N],
    /// Odd where the slot is taken.
    generations: [u16; N],
    state: State,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    /// The slot freed last, or NIL.
    free: u16,
    /// Slots from here on were never taken.
    top: u16,
    pub(super) len: u16,
    /// A body came or moved in this epoch.
    moved: bool,
    /// Counts what disturbs an enumeration. It steps at most once an enumeration, so it does not come round while one is under way.
    epoch: u32,
}

/// No slot.
pub(super) const NIL: u16 = u16::MAX;

/// A slot that nobody has: no box touches it. The left side is kept, which leaves an order by it as it is; the last word is the next free slot.
const fn dead(left: i32, next: u16) -> Aabb {
    Aabb::from_raw_unchecked(Raw { x: left, y: i32::MAX }, Raw { x: i32::MIN, y: next as i32 })
}

/// Whether two boxes have a point in common. False where one is of a free slot.
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
    pub(super) state: State,
}

/// All slots, for writing.
#[derive(Debug)]
pub struct Slots<'a, T> {
    pub(super) bounds: &'a mut [Aabb],
    tags: &'a mut [T],
    generations: &'a mut [u16],
    state: &'a mut State,
}

impl<T: Tag, const N: usize> Table<T, N> {
    pub(super) const fn new() -> Self {
        const { assert!(N < NIL as usize, "a broad phase holds at most 65534 bodies") };
        Self {
            bounds: [dead(i32::MAX, NIL); N],
            tags: [T::BLANK; N],
            generations: [0; N],
            state: State { free: NIL, top: 0, len: 0, moved: false, epoch: 0 },
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
    /// The name of the body of a slot.
    #[inline]
    pub(super) fn handle(&self, slot: usize) -> Handle {
        Handle::new(slot, self.generations.get(slot).copied().unwrap_or(0))
    }

    /// The slot of a body that is here.
    #[inline]
    pub(super) fn slot(&self, handle: Handle) -> Result<usize, BroadError> {
        let slot = handle.slot();
        // An even generation is no handle's.
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

    /// The bodies of two slots as a pair, if they may be one: the smaller key first, then the smaller slot.
    ///
    /// To be asked after the boxes. A frame of 64 bodies, each against each, takes a Cortex-M0 31 600 instructions that way round, whatever the masks are; with
    /// masks before boxes it is 69 300 where all may pair and 45 100 where none may, since a test of boxes mostly ends at its first comparison.
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
        let reused = self.state.free != NIL;
        let slot = usize::from(if reused { self.state.free } else { self.state.top });
        let places = (self.bounds.get_mut(slot), self.tags.get_mut(slot), self.generations.get_mut(slot));
        let (Some(place), Some(own), Some(generation)) = places else {
            return Err(BroadError::Full { capacity: self.bounds.len() as u16 });
        };
        if reused {
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

    /// Frees the slot of a body, and gives back what it carried.
    pub(super) fn remove(&mut self, slot: usize) -> T {
        let places = (self.bounds.get_mut(slot), self.tags.get(slot), self.generations.get_mut(slot));
        let (Some(place), Some(&tag), Some(generation)) = places else { return T::BLANK };
        *place = dead(place.lo().x, self.state.free);
        *generation = generation.wrapping_add(1);
        self.state.free = slot as u16;
        self.state.len -= 1;
        tag
    }

    #[inline]
    pub(super) fn set_bounds(&mut self, slot: usize, bounds: &Aabb) {
        if let Some(place) = self.bounds.get_mut(slot) {
            *place = *bounds;
        }
        self.state.moved = true;
    }

    /// Gives every body another box. For where any box is taken.
    #[inline]
    pub(super) fn set_each(&mut self, to: impl FnMut(Handle, &Aabb) -> Aabb) {
        self.set_while(0, to, |_, _| true);
    }

    /// Gives bodies other boxes, from a slot on and as long as `keep` takes them: the first that it does not take is left to the caller.
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

    /// The present epoch: a new one where bodies came or moved.
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
