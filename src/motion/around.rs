//! What a moving body knows of the level around it, so that it asks nothing twice.

use crate::num::Raw;
use crate::shape::Aabb;
use crate::world::{Cells, World};

/// A region that was looked at, and a box in it outside of which nothing of the level is.
///
/// A body whose inside stays in the region and out of the box meets nothing and overlaps nothing: most starts, ends and slides need no
/// more than these comparisons. Bodies without area have no inside: theirs are [grown](hull) by a raw unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Around {
    seen: Aabb,
    held: Option<Aabb>,
    /// The cells in that box, if the level tells.
    cells: Option<Cells>,
}

/// What a region may hold.
pub(super) struct Held {
    pub(super) bounds: Aabb,
    /// The cells that the inside of the bounds meets, where they are known.
    pub(super) cells: Option<Cells>,
}

impl Around {
    /// Nothing is known: no box is inside of this one.
    pub(super) const NOTHING: Self =
        Self { seen: Aabb::from_raw_unchecked(Raw { x: 1, y: 1 }, Raw { x: 0, y: 0 }), held: None, cells: None };

    /// Looks at a region, unless it is known already.
    pub(super) fn look<W: World>(&mut self, world: &W, region: &Aabb) {
        if !self.has_seen(region) {
            (self.held, self.cells) = world.occupied_cells(region);
            self.seen = *region;
        }
    }

    /// What a known region may hold.
    pub(super) fn held_of(&self, region: &Aabb) -> Option<Held> {
        if *region == self.seen {
            self.held_of_all()
        } else {
            Some(Held { bounds: self.held_in(region)?, cells: None })
        }
    }

    /// What all of the known region may hold. Where its cells are known, they alone count.
    pub(super) fn held_of_all(&self) -> Option<Held> {
        let bounds = if self.cells.is_some() { self.held? } else { self.held_in(&self.seen)? };
        Some(Held { bounds, cells: self.cells })
    }

    /// The cells in all of the known region, where they are known and there are any.
    pub(super) fn known_cells(&self) -> Option<Cells> {
        if self.held.is_some() { self.cells } else { None }
    }

    /// The part of a known region that may hold something.
    fn held_in(&self, region: &Aabb) -> Option<Aabb> {
        let (held, a, b) = (self.held?, region.lo(), region.hi());
        let lo = Raw { x: a.x.max(held.lo().x), y: a.y.max(held.lo().y) };
        let hi = Raw { x: b.x.min(held.hi().x), y: b.y.min(held.hi().y) };
        (lo.x < hi.x && lo.y < hi.y).then_some(Aabb::from_raw_unchecked(lo, hi))
    }

    /// Whether all of the region that was looked at holds nothing.
    pub(super) fn is_empty(&self) -> bool {
        self.held.is_none()
    }

    /// Whether a region is known to hold nothing.
    pub(super) fn is_free(&self, region: &Aabb) -> bool {
        self.has_seen(region) && self.is_free_in_sight(region)
    }

    /// The same of a region that is known.
    pub(super) fn is_free_in_sight(&self, region: &Aabb) -> bool {
        self.held.is_none_or(|held| {
            let ((a, b), (lo, hi)) = ((region.lo(), region.hi()), (held.lo(), held.hi()));
            b.x <= lo.x || a.x >= hi.x || b.y <= lo.y || a.y >= hi.y
        })
    }

    fn has_seen(&self, region: &Aabb) -> bool {
        let ((a, b), (lo, hi)) = ((region.lo(), region.hi()), (self.seen.lo(), self.seen.hi()));
        a.x >= lo.x && b.x <= hi.x && a.y >= lo.y && b.y <= hi.y
    }
}

/// What the inside of the bounds covers between two displacements, `margin` raw units larger on every side.
pub(super) fn hull(bounds: &Aabb, from: Raw, to: Raw, margin: i32) -> Aabb {
    let (a, b) = (bounds.lo(), bounds.hi());
    let lo = Raw { x: a.x + from.x.min(to.x) - margin, y: a.y + from.y.min(to.y) - margin };
    let hi = Raw { x: b.x + from.x.max(to.x) + margin, y: b.y + from.y.max(to.y) + margin };
    Aabb::from_raw_unchecked(lo, hi)
}
