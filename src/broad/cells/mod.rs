//! Bodies in square cells: the common part of a bounded grid and an unbounded world.

mod grid;
mod hash;
mod lattice;
pub(in crate::broad) mod lists;
#[cfg(test)]
mod tests;

pub use grid::{Border, LooseGrid};
pub use hash::SpatialHash;

use super::phase::BroadPhase;
use super::table::{HasTable, NIL, Slots};
use super::table::{Meter, PairCursor, Spatial, square};
use super::{BroadError, Handle, Pair, PairsError};
use crate::num::{Raw, Toi};
use crate::shape::Aabb;
use lattice::{At, Lattice, Window, along, is_short, last_ring, ring};
use lists::{CELLS_DONE, Lists, ListsMut, Neighbours, PairWalk};

/// Lists of bodies by the cells of their centres, and one of those that are too large for a cell.
pub trait InCells: HasTable {
    /// Whether bodies that are too large for a cell are accepted.
    const LARGE: bool;

    /// Whether rings of cells have no end, so there may be more cells than bodies.
    const ENDLESS: bool;

    fn lattice(&self) -> &Lattice;

    fn lists(&self) -> Lists<'_>;

    fn lists_mut(&mut self) -> ListsMut<'_>;

    /// The number of the list of a box's cell, whether or not the box is too large for it.
    ///
    /// # Errors
    /// `OutOfWorld`.
    fn number(&self, bounds: &Aabb) -> Result<u16, BroadError>;

    /// The data that a move of all bodies touches.
    fn moving(&mut self) -> Moving<'_, Self::Tag, impl Fn(u16, &Aabb) -> bool>;

    /// How the lists of neighbours are numbered.
    fn neighbours(&self) -> Neighbours;

    /// A window of cells, clamped to the cells that stand for those beyond.
    fn clip(&self, window: Window) -> Window;

    /// The bodies of a window of cells.
    fn bodies_in(&self, window: &Window, each: impl FnMut(usize));

    /// See [`Spatial::visit`].
    fn touching(&self, region: &Aabb, each: impl FnMut(usize));

    /// All bodies of cells that are in no ring before ring `r` around a cell; called only if rings
    /// have no end.
    fn rest(&self, r: i32, centre: At, each: impl FnMut(usize));
}

/// The bodies, the numbers of their lists, and whether a body with another box stays in a list.
#[derive(Debug)]
pub struct Moving<'a, T, F> {
    slots: Slots<'a, T>,
    numbers: &'a [u16],
    stays: F,
}

impl<C: InCells> Spatial for C {
    /// The number of a list; NIL is that of large bodies.
    type Place = u16;

    #[inline]
    fn admit(&self, bounds: &Aabb) -> Result<u16, BroadError> {
        let number = self.number(bounds)?;
        if self.lattice().holds(bounds) {
            Ok(number)
        } else if C::LARGE {
            Ok(NIL)
        } else {
            Err(self.lattice().too_large(bounds))
        }
    }

    fn link(&mut self, slot: usize, place: u16) {
        self.lists_mut().link(slot, place);
    }

    #[inline]
    fn relink(&mut self, slot: usize, place: u16) {
        if self.lists().cell_of(slot) != place {
            self.unlink(slot);
            self.link(slot, place);
        }
    }

    #[inline]
    fn move_all(&mut self, mut to: impl FnMut(Handle, &Aabb) -> Aabb) -> Result<(), (Handle, BroadError)> {
        let (mut first, mut slot) = (Ok(()), 0);
        loop {
            let left = {
                let Moving { mut slots, numbers, stays } = self.moving();
                let keep = |slot: usize, bounds: &Aabb| numbers.get(slot).is_some_and(|&number| stays(number, bounds));
                slots.set_while(slot, &mut to, keep)
            };
            let Some((moved, bounds)) = left else { return first };
            let handle = self.table().handle(moved);
            if let Err(error) = self.move_to(handle, &bounds) {
                first = first.and(Err((handle, error)));
            }
            slot = moved + 1;
        }
    }

    fn unlink(&mut self, slot: usize) {
        self.lists_mut().unlink(slot);
    }

    fn forget(&mut self, slot: usize) {
        self.lists_mut().forget(slot);
    }

    #[inline]
    fn walk<M: Meter>(
        &mut self,
        cursor: &mut PairCursor,
        meter: &mut M,
        each: impl FnMut(Pair) -> bool,
    ) -> Result<(), PairsError> {
        let mut walk = PairWalk { bodies: self.table(), lists: self.lists(), meter, each };
        // First the pairs of bodies in cells. Then those of large bodies, if there can be any.
        if !C::LARGE || cursor.row != CELLS_DONE {
            walk.in_cells(self.neighbours(), cursor)?;
        }
        if C::LARGE {
            if cursor.row != CELLS_DONE {
                (cursor.row, cursor.a, cursor.b) = (CELLS_DONE, 0, 0);
            }
            walk.large_ones(cursor)?;
        }
        *cursor = PairCursor::new();
        Ok(())
    }

    #[inline]
    fn visit(&self, region: &Aabb, each: impl FnMut(usize)) {
        self.touching(region, each);
    }

    #[inline]
    fn visit_path(&self, start: &Aabb, motion: Raw, mut each: impl FnMut(usize) -> Toi) {
        if !is_short(self.lattice(), start, motion, self.table().bounds.len()) {
            let end = Aabb::from_raw_unchecked(start.lo().add(motion), start.hi().add(motion));
            return self.touching(&start.union(&end), |slot| {
                each(slot);
            });
        }
        let (lists, mut until) = (self.lists(), Toi::ONE);
        lists.from(lists.large).for_each(|slot| until = each(slot));
        along(
            self.lattice(),
            start,
            motion,
            |window| self.clip(window),
            |window| {
                self.bodies_in(window, |slot| until = each(slot));
                until
            },
        );
    }

    #[inline]
    fn visit_near(&self, point: Raw, mut reach: i32, mut each: impl FnMut(usize) -> i32) {
        let (lists, mut left) = (self.lists(), self.table().bounds.len() as i32);
        lists.from(lists.large).for_each(|slot| reach = each(slot));
        let centre = self.clip(Window::of(self.lattice().at(&Aabb::from_raw_unchecked(point, point)))).first();
        for r in 0.. {
            let around = square(point, reach);
            let window = self.clip(self.lattice().window(around.lo(), around.hi()));
            if r > last_ring(centre, &window) {
                return;
            }
            left -= 8 * r + 1;
            if C::ENDLESS && left < 0 {
                return self.rest(r, centre, |slot| {
                    each(slot);
                });
            }
            for part in ring(centre, r) {
                let part = Window { x: part.x.and(window.x), y: part.y.and(window.y) };
                self.bodies_in(&part, |slot| reach = each(slot));
            }
        }
    }
}
