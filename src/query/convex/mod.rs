//! The verbs for capsules, oriented boxes and convex polygons: with each other and with boxes,
//! circles and segments.
//!
//! There is one mechanism for all pairs. A shape is a few corners with a radius around them, and a
//! pair is the sum A + (-B), whose sides [`walk::SideWalk`] merges from theirs. Questions are about
//! the origin and that polygon. Frequent pairs have shorter tests with the same answers, such as
//! [`short`] and [`each_side`]. Only pairs with a capsule, an oriented box or a polygon use this
//! code: a game of boxes and circles links none of it.

mod across;
mod apart;
mod box_contact;
mod box_pair;
mod box_point;
mod boxes;
mod capsules;
mod cast;
mod each_side;
mod exit;
mod face;
mod float_margins;
mod float_quads;
mod gaps;
mod hint;
mod manifold;
mod margins;
mod meets;
mod near;
mod nearness;
mod place;
mod point;
mod ray;
mod round;
mod short;
mod short_boxes;
mod short_place;
mod short_sides;
#[cfg(test)]
mod tests;
mod two_floats;
mod two_segments;
mod walk;

use super::cast::CastShape;
use super::cast::kernel::{CastHit, Course, Enter, InDomain, Inside, RayTarget};
use super::closest::{ClosestPoint, Distance, from_border};
use super::contact::{Contact, Contacts};
use super::meet::aabb_aabb;
use super::overlap::{Contains, Overlaps, Touches};
use crate::error::RangeError;
use crate::num::{Fx, LONG, Raw, Toi, Vec2};
use crate::shape::{Aabb, AnyShape, Capsule, Circle, Convex, ConvexPolygon, OrientedBox, Segment};
use apart::Quads;
use box_pair::BoxPair;
use box_point::BoxPoint;
use capsules::Capsules;
use exit::Exit;
use meets::{capsules_meet, meets_by};
use short::Short;
use short_place::place_of;

pub(crate) use meets::meets;
pub(crate) use near::between;
pub(crate) use round::ArcCell;
pub(crate) use walk::Core;

pub use hint::{OverlapsFrom, Separation};
pub use manifold::{Manifold, ManifoldPoint, Part};

/// How two shapes rest on each other: one or two points.
///
/// `Some` exactly if [`overlaps`](Overlaps::overlaps) is true. `manifold(a, b)` and `manifold(b,
/// a)` mirror each other as [`contact`](Contacts::contact) does. It exists for all pairs of shapes.
/// Cost: a contact and some hundred instructions.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Axis, OrientedBox, Vec2, fx, query::Part};
/// let floor = Aabb::new(Vec2::from_ints(-50, 0), Vec2::from_ints(50, 20))?; // y down
/// let crate_ = OrientedBox::new(Vec2::from_ints(0, -7), Vec2::from_ints(12, 8), Axis::X)?;
/// let resting = crate_.manifold(&floor).unwrap();
/// assert_eq!(resting.axis(), Axis::Y);
/// let feet: Vec<_> = resting.points().map(|p| (p.contact.point_on_a(), p.part_a)).collect();
/// assert_eq!(feet[0], (Vec2::from_ints(-12, 1), Part::Corner(3)));
/// assert_eq!(feet[1], (Vec2::from_ints(12, 1), Part::Corner(2)));
/// assert!(resting.points().all(|p| p.contact.depth() == 1));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
pub trait Manifolds<B: ?Sized> {
    /// The points at which this shape (A) and `b` (B) overlap; `None` if they do not.
    #[must_use]
    fn manifold(&self, b: &B) -> Option<Manifold>;
}

/// Runs `$body` with the cores of two shapes.
macro_rules! with_cores {
    ($x:expr, $y:expr, |$a:ident, $b:ident| $body:expr) => {{
        let (p, q) = ($x.outline(), $y.outline());
        let $a = Core { corners: &p, radius: $x.rounding() };
        let $b = Core { corners: &q, radius: $y.rounding() };
        $body
    }};
}

macro_rules! manifolds {
    ([$($n:tt)*] $a:ty, $b:ty) => {
        impl<$($n)*> Manifolds<$b> for $a {
            #[inline]
            fn manifold(&self, b: &$b) -> Option<Manifold> {
                with_cores!(self, b, |a, b| manifold::manifold(a, b))
            }
        }
    };
}

/// Whether the bounding boxes of two shapes overlap or touch. This decides most pairs that are
/// apart.
#[inline]
fn boxes_meet<const CLOSED: bool>((a, b): &(Aabb, Aabb)) -> bool {
    aabb_aabb::<CLOSED>(a.lo(), a.hi(), b.lo(), b.hi())
}

/// Whether two shapes with these bounds overlap, or touch.
#[inline]
fn meet<const CLOSED: bool>((a, b): (&impl Convex, &impl Convex), bounds: impl Fn() -> (Aabb, Aabb)) -> bool {
    if let Some(answer) = BoxPair::of(a, b).and_then(|pair| pair.meet::<CLOSED>()) {
        return answer;
    }
    if LONG {
        if let Some(answer) = gaps::box_point_meet(a, b) {
            return answer;
        }
        if let Some(answer) = Capsules::of(a, b).and_then(|near| near.meet::<CLOSED>()) {
            return answer;
        }
    } else if let Some(near) = BoxPoint::of(a, b) {
        return boxes_meet::<CLOSED>(&bounds()) && near.meets::<CLOSED>();
    }
    meet_cores::<CLOSED>((a, b), bounds)
}

/// The test for all other shapes. It is a call, so shorter tests need no saved registers. It reads
/// boxes again, so these keep no sides for it.
#[inline(never)]
fn meet_cores<const CLOSED: bool>((a, b): (&impl Convex, &impl Convex), bounds: impl Fn() -> (Aabb, Aabb)) -> bool {
    if let Some(answer) = BoxPair::of(a, b).and_then(|pair| pair.meet_exactly::<CLOSED>()) {
        return answer;
    }
    if LONG {
        if let Some(near) = BoxPoint::of(a, b) {
            return near.meets::<CLOSED>();
        }
    }
    let quads = Quads::of(a, b);
    if let Some(quads) = quads.as_ref() {
        if LONG {
            return float_quads::meet::<CLOSED>(quads.a, quads.b);
        } else if quads.are_apart::<CLOSED>() {
            return false;
        }
    }
    // On a chip the bounds of other shapes come first; elsewhere few sides take less than these.
    let in_bounds = !LONG && quads.is_none();
    if in_bounds && !boxes_meet::<CLOSED>(&bounds()) {
        return false;
    }
    let radius = a.rounding().wrapping_add(b.rounding());
    if let (true, Some(p), Some(q)) = (radius != 0, a.ends(), b.ends()) {
        return (in_bounds || boxes_meet::<CLOSED>(&bounds())) && capsules_meet::<CLOSED>(p, q, radius);
    }
    // Two boxes link no test of polygons.
    let are_boxes = a.half_sides().is_some() && b.half_sides().is_some();
    with_cores!(a, b, |a, b| {
        if radius == 0 && each_side::are_few(a, b) {
            return each_side::meet::<CLOSED>(a, b);
        }
        (!LONG || boxes_meet::<CLOSED>(&bounds())) && meets_by::<CLOSED>(a, b, !are_boxes)
    })
}

/// [`contact`] as a call, so the shorter way of boxes needs no saved registers.
#[inline(never)]
fn contact_call<A: Convex + Overlaps<B>, B: Convex>(a: &A, b: &B) -> Option<Contact> {
    contact(a, b)
}

/// The contact of two shapes, without floats.
#[inline(always)]
fn contact<A: Convex + Overlaps<B>, B: Convex>(a: &A, b: &B) -> Option<Contact> {
    if let Some(Ok(contact)) = Short::of(a, b).map(|both| both.contact()) {
        return contact;
    }
    // For capsules, the short test takes a tenth of a contact.
    if a.ends().is_some() && b.ends().is_some() && !a.overlaps(b) {
        return None;
    }
    with_cores!(a, b, |a, b| {
        if LONG {
            if let Ok(contact) = float_quads::contact(a, b) {
                return contact;
            }
        }
        Exit::of(a, b).map(|exit| exit.contact)
    })
}

/// The distance of two cores. It is a call, so shorter ways need no saved registers.
#[cfg_attr(target_pointer_width = "64", inline(never))]
#[cfg_attr(not(target_pointer_width = "64"), inline)]
fn distance(a: &impl Convex, b: &impl Convex) -> u32 {
    if let Some(core) = Short::of(a, b).and_then(|both| both.distance()) {
        return core;
    }
    with_cores!(a, b, |a, b| place_of(a, b).distance())
}

/// Implements all verbs of one ordered pair.
macro_rules! pair {
    ([$($n:tt)*] $a:ty, $b:ty) => {
        manifolds!([$($n)*] $a, $b);

        impl<$($n)*> Overlaps<$b> for $a {
            #[inline]
            fn overlaps(&self, b: &$b) -> bool {
                meet::<false>((self, b), || (self.aabb(), b.aabb()))
            }
        }

        impl<$($n)*> OverlapsFrom<$b> for $a {
            #[inline]
            fn overlaps_from(&self, b: &$b, last: &mut Separation) -> bool {
                if let Some(answer) = BoxPair::of(self, b).and_then(|pair| pair.meet::<false>()) {
                    return answer;
                }
                if let Some(quads) = Quads::of(self, b) {
                    return !quads.are_apart::<false>()
                        && with_cores!(self, b, |a, b| hint::overlaps(a, b, last));
                }
                let bounds = (self.aabb(), b.aabb());
                boxes_meet::<false>(&bounds) && with_cores!(self, b, |a, b| hint::overlaps(a, b, last))
            }
        }

        impl<$($n)*> Touches<$b> for $a {
            #[inline]
            fn touches(&self, b: &$b) -> bool {
                meet::<true>((self, b), || (self.aabb(), b.aabb()))
            }
        }

        impl<$($n)*> Contacts<$b> for $a {
            #[inline]
            fn contact(&self, b: &$b) -> Option<Contact> {
                if LONG && BoxPair::may_be(self, b) {
                    return box_contact::contact(self, b).unwrap_or_else(|_| contact_call(self, b));
                }
                contact(self, b)
            }
        }

        impl<$($n)*> Contains<$b> for $a {
            #[inline]
            fn contains(&self, b: &$b) -> bool {
                with_cores!(self, b, |a, b| point::holds_shape(a, b))
            }
        }

        impl<$($n)*> ClosestPoint<$b> for $a {
            #[inline]
            fn closest_points(&self, b: &$b) -> Option<(Vec2, Vec2)> {
                with_cores!(self, b, |a, b| near::closest_points(a, b)).map(|(p, q)| (p.vec2(), q.vec2()))
            }
        }

        impl<$($n)*> Enter<$b> for $a {
            type Moment = cast::ConvexGate;

            #[inline]
            fn enter(&self, b: &$b, d: Raw) -> Course<cast::ConvexGate> {
                with_cores!(self, b, |a, b| cast::enter(a, b, d))
            }
        }

        impl<$($n)*> CastShape<$b> for $a {}

        impl<$($n)*> Distance<$b> for $a {
            #[inline]
            fn distance(&self, b: &$b) -> Fx {
                let radius = self.rounding().wrapping_add(b.rounding());
                let core = if LONG { short::gap(self, b) } else { None };
                from_border(core.unwrap_or_else(|| distance(self, b)), radius)
            }
        }
    };
}

pair!([] Capsule, Capsule);
both_orders!(pair: [] Capsule, Aabb);
both_orders!(pair: [] Capsule, Circle);
both_orders!(pair: [] Capsule, Segment);
pair!([] OrientedBox, OrientedBox);
both_orders!(pair: [] OrientedBox, Aabb);
both_orders!(pair: [] OrientedBox, Circle);
both_orders!(pair: [] OrientedBox, Segment);
both_orders!(pair: [] OrientedBox, Capsule);
pair!([const N: usize, const M: usize] ConvexPolygon<N>, ConvexPolygon<M>);
both_orders!(pair: [const N: usize] ConvexPolygon<N>, Aabb);
both_orders!(pair: [const N: usize] ConvexPolygon<N>, Circle);
both_orders!(pair: [const N: usize] ConvexPolygon<N>, Segment);
both_orders!(pair: [const N: usize] ConvexPolygon<N>, Capsule);
both_orders!(pair: [const N: usize] ConvexPolygon<N>, OrientedBox);
pair!([const N: usize, const M: usize] AnyShape<N>, AnyShape<M>);
both_orders!(pair: [const N: usize] AnyShape<N>, Aabb);
both_orders!(pair: [const N: usize] AnyShape<N>, Circle);
both_orders!(pair: [const N: usize] AnyShape<N>, Segment);
both_orders!(pair: [const N: usize] AnyShape<N>, Capsule);
both_orders!(pair: [const N: usize] AnyShape<N>, OrientedBox);
both_orders!(pair: [const N: usize, const M: usize] AnyShape<N>, ConvexPolygon<M>);

// The other verbs of these pairs have separate kernels.
manifolds!([] Aabb, Aabb);
manifolds!([] Aabb, Circle);
manifolds!([] Aabb, Segment);
manifolds!([] Circle, Aabb);
manifolds!([] Circle, Circle);
manifolds!([] Circle, Segment);
manifolds!([] Segment, Aabb);
manifolds!([] Segment, Circle);
manifolds!([] Segment, Segment);

/// The queries about a shape and a point.
macro_rules! points {
    ([$($n:tt)*] $a:ty, $example:literal) => {
        impl<$($n)*> Contains<Vec2> for $a {
            #[inline]
            fn contains(&self, b: &Vec2) -> bool {
                point::contains(Core { corners: &self.outline(), radius: self.rounding() }, *b)
            }
        }

        impl<$($n)*> InDomain for $a {}

        impl<$($n)*> RayTarget for $a {
            fn ray_hit(&self, origin: Vec2, motion: Vec2, inside: Inside) -> Result<Option<CastHit>, RangeError> {
                self.cast_ray(origin, motion, inside)
            }

            fn ray_toi(&self, origin: Vec2, d: Raw) -> Option<Toi> {
                ray::exact_toi(Core { corners: &self.outline(), radius: self.rounding() }, origin, d)
            }
        }

        impl<$($n)*> Distance<Vec2> for $a {
            #[inline]
            fn distance(&self, b: &Vec2) -> Fx {
                point::distance(Core { corners: &self.outline(), radius: self.rounding() }, *b)
            }
        }

        impl<$($n)*> $a {
            /// The point of the shape that is nearest to `p`: `p` itself if it is inside.
            ///
            /// Each component is within a raw unit of the exact one; `p` may be anywhere. Mirrored
            /// points give mirrored bits.
            #[must_use]
            pub fn closest_point(&self, p: Vec2) -> Vec2 {
                point::closest(Core { corners: &self.outline(), radius: self.rounding() }, p)
            }

            /// The first point of the shape that a ray from `origin` along `motion` meets, or
            /// `None` if it ends before.
            ///
            /// Exact, by the rules of [`Aabb::cast_ray`] for sharp corners and of
            /// [`Circle::cast_ray`] for rounded shapes. A hit is the point at which the ray enters,
            /// even at the very end of the motion. A ray that starts on the border and moves in
            /// hits at 0. A shape without area and radius acts as a [segment](Segment::cast_ray) or
            /// a point. At a sharp corner the side whose normal is more along x is hit.
            ///
            /// The time at a sharp side is the exact floor. At a rounded shape it is a lower bound.
            /// It is early by less than a raw unit of travel for motions up to 4096 units, and by
            /// less than four for any. The displacement is never inside, and less than 2 raw short
            /// of the border for motions up to 4096 units.
            ///
            /// Cost: two products for each side, and one root if a slanted side or a corner of a
            /// rounded shape is hit.
            ///
            #[doc = concat!("```\n", $example, "\n# Ok::<(), tilesat::RangeError>(())\n```")]
            ///
            /// # Errors
            /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
            pub fn cast_ray(&self, origin: Vec2, motion: Vec2, inside: Inside) -> Result<Option<CastHit>, RangeError> {
                ray::cast_ray(Core { corners: &self.outline(), radius: self.rounding() }, origin, motion, inside)
            }
        }
    };
}

points!(
    [] Capsule,
    "use tilesat::{Axis, Capsule, Inside, Vec2, fx};
let hero = Capsule::new(Vec2::from_ints(20, 0), Vec2::from_ints(20, 16), fx!(4))?;
let hit = hero.cast_ray(Vec2::from_ints(0, 8), Vec2::from_ints(32, 0), Inside::Ignore)?.unwrap();
assert_eq!((hit.displacement, hit.axis), (Vec2::from_ints(16, 0), Axis::NEG_X));"
);
points!(
    [] OrientedBox,
    "use tilesat::{Axis, Inside, OrientedBox, Vec2};
let door = OrientedBox::new(Vec2::from_ints(20, 0), Vec2::from_ints(5, 5), Axis::new(3, 4))?;
let hit = door.cast_ray(Vec2::ZERO, Vec2::from_ints(40, 0), Inside::Ignore)?.unwrap();
assert_eq!(hit.axis.unit(), Axis::new(-4, 3).unit()); // above its left corner, (13, -1)"
);
points!(
    [const N: usize] ConvexPolygon<N>,
    "use tilesat::{Axis, ConvexPolygon, Inside, Vec2};
let corners = [Vec2::from_ints(10, 0), Vec2::from_ints(20, 10), Vec2::from_ints(10, 20)];
let ramp = ConvexPolygon::<3>::new(&corners).unwrap();
let hit = ramp.cast_ray(Vec2::from_ints(25, 5), Vec2::from_ints(-20, 0), Inside::Ignore)?.unwrap();
assert_eq!(hit.displacement, Vec2::from_ints(-10, 0));
assert_eq!(hit.axis.unit(), Axis::new(1, -1).unit());"
);
points!(
    [const N: usize] AnyShape<N>,
    "use tilesat::shape::AnyShape;
use tilesat::{Aabb, Axis, Inside, Vec2};
let crate_ = AnyShape::<4>::from(Aabb::new(Vec2::from_ints(16, -4), Vec2::from_ints(24, 4))?);
let hit = crate_.cast_ray(Vec2::ZERO, Vec2::from_ints(32, 0), Inside::Ignore)?.unwrap();
assert_eq!((hit.displacement, hit.axis), (Vec2::from_ints(16, 0), Axis::NEG_X));"
);
