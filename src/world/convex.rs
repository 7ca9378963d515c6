//! A convex shape as a level meets it.
//!
//! A level tests its pieces one by one: boxes, polygons and quarters of discs, or segments and one
//! winding number. Only a program with queries for one of these shapes links any of it.

use crate::num::Raw;
use crate::query::{Core, meets};
use crate::shape::{Aabb, Convex};

/// A convex shape before a level that is shifted by an offset.
#[derive(Clone, Copy, Debug)]
pub struct ConvexBody<'a> {
    pub(crate) core: Core<'a>,
    /// Its bounding box, relative to the level.
    pub(crate) bounds: Aabb,
    pub(crate) offset: Raw,
}

impl ConvexBody<'_> {
    /// The same body relative to a level that is shifted by a further offset.
    pub(in crate::world) fn seen_from(&self, offset: Raw) -> Self {
        Self { bounds: self.bounds.shifted(offset.reversed()), offset: self.offset.add(offset), ..*self }
    }

    /// Whether it meets the hull of some points of the level.
    pub(in crate::world) fn meets<const CLOSED: bool, const N: usize>(&self, points: [Raw; N]) -> bool {
        let corners = points.map(|p| p.add(self.offset).vec2());
        meets::<CLOSED>(self.core, Core { corners: &corners, radius: 0 })
    }

    /// Whether it meets a box.
    pub(in crate::world) fn meets_box<const CLOSED: bool>(&self, lo: Raw, hi: Raw) -> bool {
        let corners = Aabb::from_raw_unchecked(lo.add(self.offset), hi.add(self.offset)).outline();
        meets::<CLOSED>(self.core, Core { corners: &corners, radius: 0 })
    }

    /// A body without width or height, which levels know as a box.
    pub(in crate::world) fn as_box(&self) -> Option<&Aabb> {
        let (lo, hi) = (self.bounds.lo(), self.bounds.hi());
        (lo.x == hi.x || lo.y == hi.y).then_some(&self.bounds)
    }
}
