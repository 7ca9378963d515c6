//! The verbs for capsules, oriented boxes and convex polygons: with each other and with boxes, circles and segments.
//!
//! One mechanism for all pairs. A shape is a few corners with a radius around them, and a pair is the sum A + (-B), whose
//! sides [`walk::Walk`] merges from theirs. Questions are about the origin and that polygon.
//! Only pairs with one of these shapes come here: a game of boxes and circles links none of it.

mod exit;
mod face;
mod near;
mod place;
mod walk;
mod within;

use super::closest::{ClosestPoint, Distance};
use super::contact::{Contact, Contacts};
use super::overlap::{Contains, Overlaps, Touches};
use crate::num::{Fx, Vec2};
use crate::shape::{Aabb, Capsule, Circle, Convex, ConvexPolygon, OrientedBox, Segment};
use place::{Place, meets};
use walk::Core;

/// Runs `$body` with the cores of two shapes.
macro_rules! with_cores {
    ($x:expr, $y:expr, |$a:ident, $b:ident| $body:expr) => {{
        let (p, q) = ($x.outline(), $y.outline());
        let $a = Core { corners: &p, radius: $x.rounding() };
        let $b = Core { corners: &q, radius: $y.rounding() };
        $body
    }};
}

/// All verbs of one ordered pair.
macro_rules! pair {
    ([$($n:tt)*] $a:ty, $b:ty) => {
        impl<$($n)*> Overlaps<$b> for $a {
            #[inline]
            fn overlaps(&self, b: &$b) -> bool {
                with_cores!(self, b, |a, b| meets::<false>(a, b))
            }
        }

        impl<$($n)*> Touches<$b> for $a {
            #[inline]
            fn touches(&self, b: &$b) -> bool {
                with_cores!(self, b, |a, b| meets::<true>(a, b))
            }
        }

        impl<$($n)*> Contacts<$b> for $a {
            #[inline]
            fn contact(&self, b: &$b) -> Option<Contact> {
                with_cores!(self, b, |a, b| exit::contact(a, b))
            }
        }

        impl<$($n)*> Contains<$b> for $a {
            #[inline]
            fn contains(&self, b: &$b) -> bool {
                with_cores!(self, b, |a, b| within::contains(a, b))
            }
        }

        impl<$($n)*> ClosestPoint<$b> for $a {
            #[inline]
            fn closest_points(&self, b: &$b) -> Option<(Vec2, Vec2)> {
                with_cores!(self, b, |a, b| near::closest_points(a, b)).map(|(p, q)| (p.vec2(), q.vec2()))
            }
        }

        impl<$($n)*> Distance<$b> for $a {
            #[inline]
            fn distance(&self, b: &$b) -> Fx {
                with_cores!(self, b, |a, b| {
                    // Rounding down commutes with whole numbers: floor(x - r) = floor(x) - r.
                    let radii = a.radius.wrapping_add(b.radius) as u32;
                    Fx::from_bits(Place::of(a, b).distance().saturating_sub(radii) as i32)
                })
            }
        }
    };
}

/// A pair of different shapes, in both orders.
macro_rules! pair_both {
    ([$($n:tt)*] $a:ty, $b:ty) => {
        pair!([$($n)*] $a, $b);
        pair!([$($n)*] $b, $a);
    };
}

pair!([] Capsule, Capsule);
pair_both!([] Capsule, Aabb);
pair_both!([] Capsule, Circle);
pair_both!([] Capsule, Segment);
pair!([] OrientedBox, OrientedBox);
pair_both!([] OrientedBox, Aabb);
pair_both!([] OrientedBox, Circle);
pair_both!([] OrientedBox, Segment);
pair_both!([] OrientedBox, Capsule);
pair!([const N: usize, const M: usize] ConvexPolygon<N>, ConvexPolygon<M>);
pair_both!([const N: usize] ConvexPolygon<N>, Aabb);
pair_both!([const N: usize] ConvexPolygon<N>, Circle);
pair_both!([const N: usize] ConvexPolygon<N>, Segment);
pair_both!([const N: usize] ConvexPolygon<N>, Capsule);
pair_both!([const N: usize] ConvexPolygon<N>, OrientedBox);
