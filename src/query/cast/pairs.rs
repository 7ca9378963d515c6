//! The pairs that can be cast.

use super::CastShape;
use super::boxes::{Side, enter_box};
use super::capsule::{self, Capsule};
use super::circles::{Disc, enter_disc, hit_disc};
use super::kernel::{Course, Enter, Exchanged};
use super::rounded::{self, Rounded};
use super::slabs::{Edge, enter_crossing, enter_segment};
use crate::num::{Raw, Vec2};
use crate::query::Overlaps;
use crate::shape::{Aabb, Circle, Segment};

/// One ordered pair and its kernel, and another one for a yes or no: a call, where it is not small, so that what it takes of stack and flash is not
/// the caller's.
macro_rules! casts {
    ($a:ty, $b:ty, $moment:ty, |$x:ident, $y:ident, $d:ident| $course:expr $(, #[$call:meta] $hits:expr)?) => {
        impl Enter<$b> for $a {
            type Moment = $moment;

            #[inline]
            fn enter(&self, b: &$b, $d: Raw) -> Course<$moment> {
                let ($x, $y) = (self, b);
                $course
            }

            $(#[$call]
            fn hits(&self, b: &$b, $d: Raw) -> Course<()> {
                let ($x, $y) = (self, b);
                $hits
            })?
        }

        impl CastShape<$b> for $a {}
    };
}

/// A pair of different shapes, in both orders.
macro_rules! casts_both {
    ($a:ty, $b:ty, $moment:ty, |$x:ident, $y:ident, $d:ident| $course:expr $(, #[$call:meta] $hits:expr)?) => {
        casts!($a, $b, $moment, |$x, $y, $d| $course $(, #[$call] $hits)?);
        casts!(
            $b,
            $a,
            Exchanged<$moment>,
            |$y, $x, d| {
                let $d = d.reversed();
                $course.map(Exchanged)
            },
            #[inline]
            $x.hits($y, d.reversed())
        );
    };
}

/// The kernel's answer, unless the shapes overlap already.
#[inline]
fn unless<M>(overlap: bool, enter: impl FnOnce() -> Option<M>) -> Course<M> {
    if overlap { Course::Inside } else { Course::of(enter()) }
}

casts!(
    Aabb,
    Aabb,
    Side,
    |a, b, d| enter_box(a.lo(), a.hi(), b.lo(), b.hi(), d),
    #[inline]
    enter_box(a.lo(), a.hi(), b.lo(), b.hi(), d).map(|_| ())
);
casts!(
    Circle,
    Circle,
    Disc,
    |a, b, d| enter_disc(a.c(), b.c(), a.r().wrapping_add(b.r()), d),
    #[inline(never)]
    hit_disc(a.c(), b.c(), a.r().wrapping_add(b.r()), d)
);
casts!(Segment, Segment, Edge, |a, b, d| enter_crossing((a.ra(), a.rb()), (b.ra(), b.rb()), d));
casts_both!(
    Circle,
    Aabb,
    Rounded,
    |a, b, d| unless(a.overlaps(b), || rounded::gate(a, b, d)?.enter(a, d)),
    #[inline(never)]
    unless(a.overlaps(b), || rounded::gate_here(a, b, d)?.hits(a, d).then_some(()))
);
casts_both!(
    Circle,
    Segment,
    Capsule,
    |a, b, d| unless(a.overlaps(b), || capsule::gate(a, b, d)?.enter(a, d)),
    #[inline(never)]
    unless(a.overlaps(b), || capsule::gate(a, b, d)?.hits(a, d).then_some(()))
);
casts_both!(Aabb, Segment, Edge, |a, b, d| enter_segment(a.lo(), a.hi(), b.ra(), b.rb(), d));
// A point is a box or a circle of no size.
casts!(Vec2, Aabb, Side, |p, b, d| enter_box(Raw::of(*p), Raw::of(*p), b.lo(), b.hi(), d));
casts!(
    Vec2,
    Circle,
    Disc,
    |p, b, d| enter_disc(Raw::of(*p), b.c(), b.r(), d),
    #[inline(never)]
    hit_disc(Raw::of(*p), b.c(), b.r(), d)
);
