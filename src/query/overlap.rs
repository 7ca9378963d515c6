//! Whether two shapes overlap (strict) or touch (closed).

use super::meet;
use crate::shape::{Aabb, Circle, Segment};

/// Whether the interiors of two shapes meet: exact, and strict.
///
/// Precisely: whether the origin is interior to the Minkowski sum A + (-B), so that moving A a little in any direction keeps the overlap.
/// Shapes that only touch do not overlap; a point or a segment overlaps a box or a circle whose inside it reaches; two
/// segments overlap only where they cross properly; a circle of radius zero overlaps only what has area.
/// The table of [degenerate cases](crate::query#degenerate-cases) has one line for each of the rest.
///
/// `a.overlaps(&b)` is `b.overlaps(&a)`, and is true exactly where [`contact`](super::Contacts::contact) is `Some`.
/// Cost on a Cortex-M0, in instructions: boxes 20; circles, and a circle and a box, 20 apart, 35 near, 85 within a rounding error of
/// touching; a circle and a segment 55 apart, 500 near. No root, no division. It cannot fail.
///
/// ```text
///   +----+            +----+----+          +------+
///   |  +-|--+         |    |    |          |   o--|---o
///   +--|-+  |         +----+----+          +------+
///      +----+          touches            overlaps
///    overlaps
/// ```
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Circle, Fx, Vec2};
/// let wall = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(16, 16))?;
/// let ball = Circle::new(Vec2::from_ints(21, 8), Fx::from_num(5))?;
/// assert!(!ball.overlaps(&wall)); // it touches the wall
/// assert!(Circle::new(ball.centre(), Fx::from_bits((5 << 16) + 1))?.overlaps(&wall));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
pub trait Overlaps<B: ?Sized> {
    /// Whether this shape overlaps `b`; strict and exact.
    fn overlaps(&self, b: &B) -> bool;
}

/// Whether two shapes have a point in common, borders included: exact.
///
/// True wherever [`overlaps`](Overlaps::overlaps) is. `a.touches(&b)` is `b.touches(&a)`.
/// Cost: as `overlaps`. It cannot fail.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Segment, Vec2};
/// let floor = Segment::new(Vec2::from_ints(0, 0), Vec2::from_ints(8, 0))?;
/// let wall = Segment::new(Vec2::from_ints(8, 0), Vec2::from_ints(8, 8))?;
/// assert!(floor.touches(&wall) && !floor.overlaps(&wall)); // a common end
/// # Ok::<(), tilesat::RangeError>(())
/// ```
pub trait Touches<B: ?Sized> {
    /// Whether this shape and `b` have a point in common; closed and exact.
    fn touches(&self, b: &B) -> bool;
}

/// Both traits of one ordered pair, from one expression that is generic over strict and closed.
macro_rules! meets {
    ($a:ty, $b:ty, |$x:ident, $y:ident, $closed:ident| $test:expr) => {
        impl Overlaps<$b> for $a {
            #[inline]
            fn overlaps(&self, b: &$b) -> bool {
                const fn test<const $closed: bool>($x: &$a, $y: &$b) -> bool {
                    $test
                }
                test::<false>(self, b)
            }
        }

        impl Touches<$b> for $a {
            #[inline]
            fn touches(&self, b: &$b) -> bool {
                const fn test<const $closed: bool>($x: &$a, $y: &$b) -> bool {
                    $test
                }
                test::<true>(self, b)
            }
        }
    };
}

/// A pair of different shapes, in both orders.
macro_rules! meets_both {
    ($a:ty, $b:ty, |$x:ident, $y:ident, $closed:ident| $test:expr) => {
        meets!($a, $b, |$x, $y, $closed| $test);
        meets!($b, $a, |$y, $x, $closed| $test);
    };
}

meets!(Aabb, Aabb, |a, b, CLOSED| meet::aabb_aabb::<CLOSED>(a.lo(), a.hi(), b.lo(), b.hi()));
meets!(Circle, Circle, |a, b, CLOSED| meet::circle_circle::<CLOSED>(a.c(), b.c(), a.r().wrapping_add(b.r())));
meets!(Segment, Segment, |a, b, CLOSED| meet::segment_segment::<CLOSED>(a.ra(), a.rb(), b.ra(), b.rb()));
meets_both!(Circle, Aabb, |a, b, CLOSED| meet::circle_aabb::<CLOSED>(a.c(), a.r(), b.lo(), b.hi()));
meets_both!(Circle, Segment, |a, b, CLOSED| meet::circle_segment::<CLOSED>(a.c(), a.r(), b.ra(), b.rb()));
meets_both!(Segment, Aabb, |a, b, CLOSED| meet::segment_aabb::<CLOSED>(a.ra(), a.rb(), b.lo(), b.hi()));
