//! What a moving body knows of the level around it, so that it asks nothing twice.

use crate::num::Raw;
use crate::shape::Aabb;
use crate::world::World;

/// A region that was looked at, and a box in it outside of which nothing of the level is.
///
/// A body whose inside stays in the region and out of the box meets nothing and overlaps nothing: most starts, ends and slides need no
/// more than these comparisons. Bodies without area have no inside: theirs are [grown](hull) by a raw unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Around {
    seen: Aabb,
    held: Option<Aabb>,
}

impl Around {
    /// Nothing is known: no box is inside of this one.
    pub(super) const NOTHING: Self =
        Self { seen: Aabb::from_raw_unchecked(Raw { x: 1, y: 1 }, Raw { x: 0, y: 0 }), held: None };

    /// Looks at a region, unless it is known already.
    pub(super) fn look<W: World>(&mut self, world: &W, region: &Aabb) {
        if !self.has_seen(region) {
            *self = Self { seen: *region, held: world.occupied(region) };
        }
    }

    /// The part of a known region that may hold something.
    pub(super) fn held_in(&self, region: &Aabb) -> Option<Aabb> {
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
        self.has_seen(region) && self.held_in(region).is_none()
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
