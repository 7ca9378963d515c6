//! What a motion ran into.

use crate::error::Truncated;
use crate::num::{Axis, Toi};
use crate::world::{Cell, Feature};
use core::iter::{Chain, Flatten};
use core::slice::Iter;

/// One thing that a moving body ran into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hit {
    /// The part of the motion that was used up when it was hit. Exact floor for the first hit on a face along x or y, and for a
    /// box on the slope of a tile; early by less than a raw unit of way elsewhere; later hits of one call add the roundings of the earlier ones.
    pub toi: Toi,
    /// The exact normal of what was hit: out of the solid, toward the body.
    pub axis: Axis,
    /// The cell of the level.
    pub cell: Cell,
    /// Which feature of the cell, as [`Feature::index`](crate::world::Feature::index).
    pub index: u16,
    /// The user flags of the tile or segment.
    pub flags: u8,
    /// Whether it is a one-way face.
    pub one_way: bool,
    /// Which level, as [`Feature::source`](crate::world::Feature::source).
    pub source: u8,
}

impl Hit {
    pub(super) const fn of(axis: Axis, feature: &Feature, toi: Toi) -> Self {
        let Feature { cell, index, flags, one_way, source, .. } = *feature;
        Self { toi, axis, cell, index, flags, one_way, source }
    }
}

/// The hits of one motion in the order in which they happened, at most [`Hits::CAPACITY`].
///
/// Plain data: a copy is a snapshot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hits {
    /// In halves: 48 bytes are made and copied in line, 96 by a library's routine for memory of any size.
    early: [Option<Hit>; 2],
    late: [Option<Hit>; 2],
    seen: u8,
}

impl Hits {
    /// How many hits are kept: one for each iteration.
    pub const CAPACITY: usize = 4;

    #[inline]
    pub(super) const fn none() -> Self {
        Self { early: [None; 2], late: [None; 2], seen: 0 }
    }

    #[inline]
    pub(super) const fn one(hit: Hit) -> Self {
        Self { early: [Some(hit), None], late: [None; 2], seen: 1 }
    }

    pub(super) fn push(&mut self, hit: Hit) {
        let half = if self.seen < 2 { &mut self.early } else { &mut self.late };
        if let Some(slot) = half.get_mut(usize::from(self.seen & 1)).filter(|_| self.seen < Self::CAPACITY as u8) {
            *slot = Some(hit);
        }
        self.seen = self.seen.saturating_add(1);
    }

    /// The hits, first to last.
    pub fn iter(&self) -> impl Iterator<Item = &Hit> {
        self.into_iter()
    }

    /// How many are kept.
    #[must_use]
    pub fn len(&self) -> usize {
        (self.seen as usize).min(Self::CAPACITY)
    }

    /// Whether the motion was free.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.seen == 0
    }

    /// The first hit.
    #[must_use]
    pub const fn first(&self) -> Option<Hit> {
        self.early[0]
    }

    /// Copies the hits into a vector of any capacity, first to last.
    ///
    /// # Errors
    /// [`Truncated`] where they do not fit: `out` then holds the earliest.
    pub fn copy_to(&self, out: &mut heapless::VecView<Hit>) -> Result<(), Truncated> {
        for (kept, hit) in self.iter().enumerate() {
            if out.push(*hit).is_err() {
                return Err(Truncated { seen: self.seen.into(), kept: kept as u32 });
            }
        }
        Ok(())
    }
}

impl<'a> IntoIterator for &'a Hits {
    type Item = &'a Hit;
    type IntoIter = Flatten<Chain<Iter<'a, Option<Hit>>, Iter<'a, Option<Hit>>>>;
    fn into_iter(self) -> Self::IntoIter {
        self.early.iter().chain(&self.late).flatten()
    }
}
