//! The interface that every kind of level has for capsules, oriented boxes and convex polygons.

use super::convex::ConvexBody;
use super::joined::Joined;
use super::level::World;
use super::placed::Placed;
use super::segment_map::SegmentMap;
use super::solids::Solids;
use super::solids::convex::{ConvexSolids, SolidShape};
use super::tile_map::{Set, Store, TileMap};
use crate::num::Raw;
use crate::query::{Core, Overlaps, Touches};
use crate::shape::{Aabb, AnyShape, Capsule, Compound, Convex, ConvexPolygon, OrientedBox, Single};

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
            convex_meets! { [$($parameters)*] $level, [const N: usize] AnyShape<N> }

            impl<$($parameters)* P: Single, const M: usize> Overlaps<Compound<P, M>> for $level
            where
                Self: Overlaps<P>,
            {
                fn overlaps(&self, b: &Compound<P, M>) -> bool {
                    World::overlaps_aabb(self, &b.aabb()) && b.parts().iter().any(|part| Overlaps::overlaps(self, part))
                }
            }

            impl<$($parameters)* P: Single, const M: usize> Touches<Compound<P, M>> for $level
            where
                Self: Touches<P>,
            {
                fn touches(&self, b: &Compound<P, M>) -> bool {
                    World::touches_aabb(self, &b.aabb()) && b.parts().iter().any(|part| Touches::touches(self, part))
                }
            }
        )*
    };
}

all_convex! {
    [S: Set, T: Store,] TileMap<'_, S, T>;
    [] SegmentMap<'_>;
    [] Solids<'_>;
    [C: SolidShape,] ConvexSolids<'_, C>;
    [A: World, B: World,] Joined<'_, A, B>;
    [W: World,] Placed<'_, W>;
}
