//! Pair queries: one trait per verb, one implementation per pair. A game links only the pairs that
//! it uses.
//!
//! | verb | asks | answer | rounding |
//! |---|---|---|---|
//! | [`Overlaps`] | do the interiors meet? | `bool` | exact, strict |
//! | [`OverlapsFrom`] | do the interiors meet? Faster, with a hint from the last frame | `bool` | exact, strict |
//! | [`Touches`] | do they share a point? | `bool` | exact, closed |
//! | [`BoxColumns`] | which of many boxes does a box overlap or touch? | `[bool; N]` | exact |
//! | [`Contacts`] | how deep, in which direction is the way out, where? | `Option<`[`Contact`]`>` | axis exact, depth up, push-out away |
//! | [`Manifolds`] | at which one or two points do they rest? | `Option<`[`Manifold`]`>` | as a contact |
//! | [`Contains`] | is all of B in A? | `bool` | exact, closed |
//! | [`Distance`] | how far apart are they? | [`Fx`](crate::Fx) | down, 0 if they touch |
//! | [`ClosestPoint`] | which points are nearest? | `Option<(Vec2, Vec2)>` | nearest, `None` if they touch |
//! | [`CastShape`] | when does this motion first hit? | `Option<`[`CastHit`]`>` | yes or no exact, time down |
//!
//! All but `OverlapsFrom` exist for every ordered pair of [`Aabb`](crate::Aabb),
//! [`Circle`](crate::Circle), [`Segment`](crate::Segment), [`Capsule`](crate::Capsule),
//! [`OrientedBox`](crate::OrientedBox) and [`ConvexPolygon`](crate::ConvexPolygon). `OverlapsFrom`
//! needs at least one of the last three. [`AnyShape`](crate::shape::AnyShape) has all verbs, and a
//! [`Compound`](crate::shape::Compound) has those of its parts. In `Contains` and `Distance`, B may
//! also be a point ([`Vec2`](crate::Vec2)). In `CastShape`, A may be a point against boxes and
//! circles. Each shape has the methods `closest_point` and `cast_ray`. A compound has `cast_ray`,
//! unless its parts are segments, and no `closest_point`.
//!
//! Every loop has a bound, and there is no division instruction. Only casts can fail: they refuse
//! numbers that are out of range. A translated scene gives the same bits, and a mirrored one gives
//! mirrored bits.
//!
//! Mirrored scenes may give other bits in these cases:
//!
//! - Degenerate contacts: their axis follows the conventions below, and their points depend on it.
//! - Points in the middle of facing sides, of a contact or of nearest points. The middle is rounded
//!   down, so it may be a raw unit off. For slanted sides it is at most two off.
//! - Nearest points of slanted parallel sides. They are at the lexicographically first end of the
//!   facing parts. So in a mirrored scene they may be at the other end.
//! - The axis of a cast by a motion along x or y. It may meet two sides or corners at the same
//!   moment, whose axes mirror each other at the motion. It then takes the one to its left (y up).
//! - Equally deep points of a manifold: the order of the two.
//!
//! Exchanging x and y also changes the choices that prefer x.
//!
//! # The contact of each shape
//!
//! A is the orange shape, and B is the box. The points of the manifold on B and the normals from
//! the points on A are red. A after its push-out is faint.
//!
//! <!-- contacts:begin -->
//! <p>
//! <svg width="552" height="264" viewBox="0 0 276 132"
//! font-size="7" stroke-linejoin="round" stroke-linecap="round">
//! <g transform="translate(0,0)">
//! <text x="3" y="9" fill="currentColor">Aabb</text>
//! <g fill="#888" stroke="#888" opacity="0.5">
//! <path d="M40,32 84,32 84,62 40,62Z" stroke-width="1"/></g>
//! <g fill="#d80" stroke="#d80" opacity="0.6">
//! <path d="M20,18 48,18 48,38 20,38Z" stroke-width="1"/></g>
//! <g fill="#d80" stroke="#d80" opacity="0.2">
//! <path d="M20,12 48,12 48,32 20,32Z" stroke-width="1"/></g>
//! <g fill="none" stroke="#d22">
//! <path d="M40,32L40,32" stroke-width="3"/>
//! <path d="M40,38L40,48"/>
//! <path d="M48,32L48,32" stroke-width="3"/>
//! <path d="M48,38L48,48"/>
//! </g>
//! </g>
//! <g transform="translate(92,0)">
//! <text x="3" y="9" fill="currentColor">Circle</text>
//! <g fill="#888" stroke="#888" opacity="0.5">
//! <path d="M40,32 84,32 84,62 40,62Z" stroke-width="1"/></g>
//! <g fill="#d80" stroke="#d80" opacity="0.6">
//! <path d="M32,30Z" stroke-width="33"/></g>
//! <g fill="#d80" stroke="#d80" opacity="0.2">
//! <path d="M24.5,28.1Z" stroke-width="33"/></g>
//! <g fill="none" stroke="#d22">
//! <path d="M40,32L40,32" stroke-width="3"/>
//! <path d="M47.5,33.9L57.2,36.3"/>
//! </g>
//! </g>
//! <g transform="translate(184,0)">
//! <text x="3" y="9" fill="currentColor">Segment</text>
//! <g fill="#888" stroke="#888" opacity="0.5">
//! <path d="M40,32 84,32 84,62 40,62Z" stroke-width="1"/></g>
//! <g fill="#d80" stroke="#d80" opacity="0.6">
//! <path d="M22,46 58,24Z" stroke-width="1"/></g>
//! <g fill="#d80" stroke="#d80" opacity="0.2">
//! <path d="M20.7,43.8 56.7,21.8Z" stroke-width="1"/></g>
//! <g fill="none" stroke="#d22">
//! <path d="M40,32L40,32" stroke-width="3"/>
//! <path d="M41.3,34.2L46.5,42.7"/>
//! </g>
//! </g>
//! <g transform="translate(0,66)">
//! <text x="3" y="9" fill="currentColor">Capsule</text>
//! <g fill="#888" stroke="#888" opacity="0.5">
//! <path d="M40,32 84,32 84,62 40,62Z" stroke-width="1"/></g>
//! <g fill="#d80" stroke="#d80" opacity="0.6">
//! <path d="M18,36 44,25Z" stroke-width="19"/></g>
//! <g fill="#d80" stroke="#d80" opacity="0.2">
//! <path d="M16.4,32.2 42.4,21.2Z" stroke-width="19"/></g>
//! <g fill="none" stroke="#d22">
//! <path d="M40,32L40,32" stroke-width="3"/>
//! <path d="M41.6,35.8L45.5,45"/>
//! <path d="M47,32L47,32" stroke-width="3"/>
//! <path d="M47.5,33.3L51.4,42.5"/>
//! </g>
//! </g>
//! <g transform="translate(92,66)">
//! <text x="3" y="9" fill="currentColor">OrientedBox</text>
//! <g fill="#888" stroke="#888" opacity="0.5">
//! <path d="M40,32 84,32 84,62 40,62Z" stroke-width="1"/></g>
//! <g fill="#d80" stroke="#d80" opacity="0.6">
//! <path d="M19.8,13.8 53.9,25.2 48.2,42.2 14.1,30.8Z" stroke-width="1"/></g>
//! <g fill="#d80" stroke="#d80" opacity="0.2">
//! <path d="M19.8,3.5 53.9,14.9 48.2,32 14.1,20.6Z" stroke-width="1"/></g>
//! <g fill="none" stroke="#d22">
//! <path d="M48.2,32L48.2,32" stroke-width="3"/>
//! <path d="M48.2,42.2L48.2,52.2"/>
//! <path d="M40,32L40,32" stroke-width="3"/>
//! <path d="M40,39.5L40,49.5"/>
//! </g>
//! </g>
//! <g transform="translate(184,66)">
//! <text x="3" y="9" fill="currentColor">ConvexPolygon</text>
//! <g fill="#888" stroke="#888" opacity="0.5">
//! <path d="M40,32 84,32 84,62 40,62Z" stroke-width="1"/></g>
//! <g fill="#d80" stroke="#d80" opacity="0.6">
//! <path d="M34,16 50,30 40,42 20,40 14,26Z" stroke-width="7"/></g>
//! <g fill="#d80" stroke="#d80" opacity="0.2">
//! <path d="M26.8,10 42.8,24 32.8,36 12.8,34 6.8,20Z" stroke-width="7"/></g>
//! <g fill="none" stroke="#d22">
//! <path d="M40,32L40,32" stroke-width="3"/>
//! <path d="M47.2,38L54.9,44.4"/>
//! <path d="M40,42L40,42" stroke-width="3"/>
//! <path d="M42.3,43.9L50,50.3"/>
//! </g>
//! </g>
//! </svg>
//! </p>
//! <!-- contacts:end -->
//!
//! # Capsules, oriented boxes and polygons
//!
//! All pairs with one of these shapes share one algorithm. It merges the sides of A and -B by
//! direction: these are the sides of the sum A + (-B). Each verb then asks about the origin and
//! that polygon. For shapes of n and m corners it visits at most n + m sides. `overlaps` stops at
//! the first side that separates the shapes. Boxes, capsules, and polygons of few sides have
//! shorter tests, which give the same answers or fall back to this algorithm. A game of boxes,
//! circles and segments links none of this code.
//!
//! Contacts follow the table below. If several exits are equally short, an axis along x wins, then
//! one along y, then another. If two are opposite, the positive one wins (if slanted, the one with
//! positive y), then the first counter-clockwise from +x. Closest points on round sides are within
//! a raw unit per component.
//!
//! # Degenerate cases
//!
//! These cases follow a convention, or are easily guessed wrong. "Point" means a shape without
//! size.
//!
//! | case | `overlaps` | `touches` | `contact` |
//! |---|---|---|---|
//! | shapes that share border points only | no | yes | none |
//! | point or segment reaching inside a box that has area | yes | yes | least exit |
//! | point or segment within a side or corner of a box | no | yes | none |
//! | two boxes of which one or both have no area | as segments or points | yes if they meet | as segments |
//! | flat boxes that cross (one wide, one high) | yes | yes | least exit |
//! | two points, or a point on a segment | no | yes, if equal | none |
//! | segments: proper crossing | yes | yes | least exit over both lines |
//! | segments: T, common end, collinear | no | yes | none |
//! | circle of radius 0 against a circle or box with area | yes inside | yes | radial, or least exit |
//! | circle of radius 0 against a segment or point | no | yes, if on it | none |
//! | equal centres of circles | yes, if a radius is not 0 | yes | +x, degenerate |
//! | circle with its centre on a side of a box | yes | yes | normal of the side |
//! | circle with its centre on a corner of a box | yes | yes | x axis, outward, degenerate |
//! | circle with its centre on a segment, ends included | yes | yes | `(-e.y, e.x)`, degenerate |
//! | circle with its centre on a point | yes | yes | +x, degenerate |
//! | box: left and right exit equally deep, and least | yes | yes | +x (top and bottom: +y), degenerate |
//! | box: x and y exit equally deep, and least | yes | yes | x axis, its own sign, degenerate |
//! | box and sloped segment: axis and normal exit equal | yes | yes | the axis, degenerate |
//! | box and sloped segment: both sides equal | yes | yes | `(-e.y, e.x)`, degenerate |
//! | crossing segments: both halves equal | yes | yes | `(-e.y, e.x)`, degenerate |
//! | crossing segments: exits over both lines equal | yes | yes | x before y before the smaller normal, degenerate |
//!
//! `e` is the edge of the segment from its lexicographically smaller end (smaller x, then smaller
//! y) to the other. Segments parallel to x or y have axes of length one. Moving A against the axis
//! of a degenerate contact ends the overlap as any other does. In the order (B, A) that axis is the
//! same if its sign is a convention. It is reversed if only the choice between two axes is a
//! convention. The distance of shapes that are less than one raw unit apart is 0, while `touches`
//! is false.

/// A pair of different shapes, in both orders, by the macro of one ordered pair. Its kernels take
/// the shapes in either order.
macro_rules! both_orders {
    ($one:ident: [$($n:tt)*] $a:ty, $b:ty) => {
        $one!([$($n)*] $a, $b);
        $one!([$($n)*] $b, $a);
    };
    ($one:ident: $a:ty, $b:ty, |$x:ident, $y:ident $(, $more:ident)?| $($kernel:expr),+) => {
        $one!($a, $b, |$x, $y $(, $more)?| $($kernel),+);
        $one!($b, $a, |$y, $x $(, $more)?| $($kernel),+);
    };
}

pub(crate) mod cast;
pub(crate) mod closest;
mod compound;
mod contact;
mod convex;
pub(crate) mod meet;
mod overlap;
#[cfg(test)]
mod tests;

pub(crate) use cast::kernel::{Course, Enter, InDomain, Moment, RayTarget};
pub use cast::{CastHit, CastShape, Inside, MovingHit};
pub use closest::{ClosestPoint, Distance};
pub use contact::{Contact, Contacts};
pub(crate) use convex::{ArcCell, Core, between, meets};
pub use convex::{Manifold, ManifoldPoint, Manifolds, OverlapsFrom, Part, Separation};
pub use overlap::{BoxColumns, Contains, Overlaps, Touches};
