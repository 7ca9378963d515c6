//! Pair queries: one trait per verb, one implementation per pair. A game links only the pairs that
//! it uses.
//!
//! | verb | asks | answer | rounding |
//! |---|---|---|---|
//! | [`Overlaps`] | do the interiors meet? | `bool` | exact, strict |
//! | [`OverlapsFrom`] | do they, with what separated them last as a hint? | `bool` | the same |
//! | [`Touches`] | have they a point in common? | `bool` | exact, closed |
//! | [`Contacts`] | how deep, which way out, where? | `Option<`[`Contact`]`>` | axis exact, depth up, push-out away |
//! | [`Manifolds`] | at which one or two points do they rest? | `Option<`[`Manifold`]`>` | as a contact |
//! | [`Contains`] | is all of B in A? | `bool` | exact, closed |
//! | [`Distance`] | how far apart? | [`Fx`](crate::Fx) | down, 0 where they touch |
//! | [`ClosestPoint`] | which points are nearest? | `Option<(Vec2, Vec2)>` | nearest, `None` where they touch |
//! | [`CastShape`] | when does this motion first hit? | `Option<`[`CastHit`]`>` | yes or no exact, time down |
//!
//! All but `OverlapsFrom` are implemented for every ordered pair of [`Aabb`](crate::Aabb),
//! [`Circle`](crate::Circle), [`Segment`](crate::Segment), [`Capsule`](crate::Capsule),
//! [`OrientedBox`](crate::OrientedBox) and [`ConvexPolygon`](crate::ConvexPolygon); `OverlapsFrom`
//! for those with one of the last three. [`AnyShape`](crate::shape::AnyShape) has all of them, too,
//! and a [`Compound`](crate::shape::Compound) those that its parts answer. `Contains` and `Distance` take a point
//! ([`Vec2`](crate::Vec2)) as B, too, `CastShape` a point as A against boxes and circles.
//! `closest_point` is a method of each shape, `cast_ray` of the first three. None of them can loop
//! without a bound or divide, and none can fail but casts, which refuse what is out of range.
//! Results depend on differences only: a translated scene gives the same bits, a mirrored one
//! mirrored bits.
//!
//! # Capsules, oriented boxes and polygons
//!
//! One mechanism serves all pairs with one of these: the sides of A and of B, merged by direction,
//! are those of the sum A + (-B), and each question is about the origin and that polygon. For
//! shapes of n and m corners each verb walks n + m sides at most, parallel ones together;
//! `overlaps` stops at the first one that separates. A scene of boxes, circles and segments links
//! none of it.
//!
//! Contacts follow the table below. Of equally short exits the axis is one along x, then along y,
//! then another; of these the positive one (of others: with positive y), then the first
//! counter-clockwise from +x. Closest points of rounded sides, and of `closest_point`, are within a
//! raw unit per component: the point of the core and the radius are rounded each to nearest.
//!
//! # Degenerate cases
//!
//! Cases that are decided by convention, or are easily guessed wrong; "point" means a shape of no
//! size.
//!
//! | case | `overlaps` | `touches` | `contact` |
//! |---|---|---|---|
//! | shapes that share border points only | no | yes | none |
//! | point or segment reaching inside a box that has area | yes | yes | least exit |
//! | point or segment within a side or corner of a box | no | yes | none |
//! | two boxes of which one or both have no area | as segments or points | yes where they meet | as segments |
//! | flat boxes that cross (one wide, one high) | yes | yes | least exit |
//! | two points, or a point on a segment | no | yes, where equal | none |
//! | segments: proper crossing | yes | yes | least exit over both lines |
//! | segments: T, common end, collinear | no | yes | none |
//! | circle of radius 0 against a circle or box with area | yes inside | yes | radial, or least exit |
//! | circle of radius 0 against a segment or point | no | yes, where on it | none |
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
//! y) to the other; parallels to x and y have axes of length one. Moving A against the axis of a
//! degenerate contact ends the overlap as any other does. In the order (B, A) that axis is the same
//! where its sign is a convention, and reversed where only the choice between two axes is one.
//! Distances of shapes less than one raw unit apart are 0, and `touches` is then false.

pub(crate) mod cast;
pub(crate) mod closest;
mod compound;
mod contact;
mod convex;
pub(crate) mod meet;
mod overlap;
#[cfg(test)]
mod tests;

// Motion uses `scaled` and `toward` through this path.
pub(crate) use crate::num as round;

pub use cast::{CastHit, CastShape, Inside, MovingHit};
pub use closest::{ClosestPoint, Distance};
pub use contact::{Contact, Contacts};
pub(crate) use convex::{ArcCell, Core, meets};
pub use convex::{Manifold, ManifoldPoint, Manifolds, OverlapsFrom, Part, Separation};
pub use overlap::{Contains, Overlaps, Touches};
