//! Capsules, oriented boxes and convex polygons against levels.
//!
//! A level asks about its pieces one by one: boxes, polygons and quarters of discs, or segments and one winding number. Only a program that
//! asks about one of these shapes links any of it.

use super::joined::Joined;
use super::level::World;
use super::placed::Placed;
use super::segment_map::SegmentMap;
use super::solids::Solids;
use super::tile_map::{Set, Store, TileMap};
use crate::num::Raw;
use crate::query::{Core, Overlaps, Touches, meets};
use crate::shape::{Aabb, Capsule, Convex, ConvexPolygon, OrientedBox};

/// A convex shape before a level that is shifted by an offset.
#[derive(Clone, Copy, Debug)]
pub struct ConvexBody<'a> {
    pub(crate) core: Core<'a>,
    /// Its bounding box, as the level sees it.
    pub(crate) bounds: Aabb,
    pub(crate) offset: Raw,
}

impl ConvexBody<'_> {
    /// The same seen from a level that is shifted by as much again.
    pub(in crate::world) const fn seen_from(&self, offset: Raw) -> Self {
        let bounds = Aabb::from_raw_unchecked(self.bounds.lo().sub(offset), self.bounds.hi().sub(offset));
        Self { bounds, offset: self.offset.add(offset), ..*self }
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

/// Asks a level about a shape.
fn ask<W: World, B: Convex>(world: &W, shape: &B, bounds: Aabb, closed: bool) -> bool {
    let corners = shape.outline();
    let core = Core { corners: &corners, radius: shape.rounding() };
    world.meets_convex(&ConvexBody { core, bounds, offset: Raw::ZERO }, closed)
}

macro_rules! convex_meets {
    ([$($parameters:tt)*] $level:ty, [$($n:tt)*] $body:ty) => {
        impl<$($parameters)* $($n)*> Overlaps<$body> for $level {
            fn overlaps(&self, b: &$body) -> bool {
                ask(self, b, b.aabb(), false)
            }
        }

        impl<$($parameters)* $($n)*> Touches<$body> for $level {
            fn touches(&self, b: &$body) -> bool {
                ask(self, b, b.aabb(), true)
            }
        }
    };
}

macro_rules! all_convex {
    ($([$($parameters:tt)*] $level:ty;)*) => {
        $(
            convex_meets! { [$($parameters)*] $level, [] Capsule }
            convex_meets! { [$($parameters)*] $level, [] OrientedBox }
            convex_meets! { [$($parameters)*] $level, [const N: usize] ConvexPolygon<N> }
        )*
    };
}

all_convex! {
    [S: Set, T: Store,] TileMap<'_, S, T>;
    [] SegmentMap<'_>;
    [] Solids<'_>;
    [A: World, B: World,] Joined<'_, A, B>;
    [W: World,] Placed<'_, W>;
}
