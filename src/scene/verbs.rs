//! The verbs of pairs for sets of shapes: with each shape, compounds and points, in both roles.
//!
//! Separate from the pairs of bodies, which a step uses: a scene that only steps links none of it.

use super::{Shape, WithCapsules};
use crate::error::RangeError;
use crate::num::{Axis, Fx, Raw, Toi, Vec2};
use crate::query::{
    CastShape, ClosestPoint, Contact, Contacts, Contains, Course, Distance, Enter, InDomain, Manifold, Manifolds,
    Moment, Overlaps, Touches,
};
use crate::shape::kernel::{Extent, Movable};
use crate::shape::{Aabb, AnyShape, Capsule, Circle, Compound, ConvexPolygon, OrientedBox, Segment, Single};

/// A verb with a set as A.
macro_rules! of_set {
    ($verb:ident.$method:ident -> $out:ty, [$($n:tt)*] $set:ident: $($shape:ident)+, $other:ty) => {
        impl<$($n)*> $verb<$other> for $set
        where
            $($shape: $verb<$other>,)+
        {
            fn $method(&self, b: &$other) -> $out {
                match self {
                    $(Self::$shape(a) => a.$method(b),)+
                }
            }
        }
    };
}

/// A verb with a set as B.
macro_rules! on_set {
    ($verb:ident.$method:ident -> $out:ty, [$($n:tt)*] $set:ident: $($shape:ident)+, $other:ty) => {
        impl<$($n)*> $verb<$set> for $other {
            fn $method(&self, b: &$set) -> $out {
                match b {
                    $($set::$shape(b) => self.$method(b),)+
                }
            }
        }
    };
}

/// All verbs, by one of these.
macro_rules! verbs {
    ($role:ident: $($of:tt)*) => {
        $role!(Overlaps.overlaps -> bool, $($of)*);
        $role!(Touches.touches -> bool, $($of)*);
        $role!(Contacts.contact -> Option<Contact>, $($of)*);
        verbs!(@more $role: $($of)*);
    };
    (@more $role:ident: $($of:tt)*) => {
        $role!(Manifolds.manifold -> Option<Manifold>, $($of)*);
        $role!(Contains.contains -> bool, $($of)*);
        $role!(Distance.distance -> Fx, $($of)*);
        $role!(ClosestPoint.closest_points -> Option<(Vec2, Vec2)>, $($of)*);
    };
}

/// Casts with a set as A.
macro_rules! casts_of {
    ([$($n:tt)*] $set:ident: $($shape:ident)+, $moment:ident, $other:ty) => {
        impl<$($n)*> Enter<$other> for $set
        where
            $($shape: Enter<$other>,)+
        {
            type Moment = $moment<$(<$shape as Enter<$other>>::Moment,)+>;

            fn enter(&self, b: &$other, d: Raw) -> Course<Self::Moment> {
                match self {
                    $(Self::$shape(a) => a.enter(b, d).map($moment::$shape),)+
                }
            }

            fn first_contact(&self, b: &$other, d: Raw) -> Course<(Toi, Raw, Axis)> {
                match self {
                    $(Self::$shape(a) => a.first_contact(b, d),)+
                }
            }

            fn hits(&self, b: &$other, d: Raw) -> Course<()> {
                match self {
                    $(Self::$shape(a) => a.hits(b, d),)+
                }
            }

            fn led_back(&self, b: &$other, d: Raw, step: Raw) -> Raw {
                match self {
                    $(Self::$shape(a) => a.led_back(b, d, step),)+
                }
            }
        }

        impl<$($n)*> CastShape<$other> for $set where $($shape: Enter<$other>,)+ {}
    };
}

/// Casts with a set as B, which is no compound: nothing is led back.
macro_rules! casts_on {
    ([$($n:tt)*] $set:ident: $($shape:ident)+, $moment:ident, $other:ty) => {
        impl<$($n)*> Enter<$set> for $other {
            type Moment = $moment<$(<Self as Enter<$shape>>::Moment,)+>;

            fn enter(&self, b: &$set, d: Raw) -> Course<Self::Moment> {
                match b {
                    $($set::$shape(b) => self.enter(b, d).map($moment::$shape),)+
                }
            }

            fn first_contact(&self, b: &$set, d: Raw) -> Course<(Toi, Raw, Axis)> {
                match b {
                    $($set::$shape(b) => self.first_contact(b, d),)+
                }
            }

            fn hits(&self, b: &$set, d: Raw) -> Course<()> {
                match b {
                    $($set::$shape(b) => self.hits(b, d),)+
                }
            }
        }

        impl<$($n)*> CastShape<$set> for $other {}
    };
}

macro_rules! set {
    ($set:ident, $moment:ident: $($shape:ident)+) => {
        /// A moment of one of the shapes.
        #[derive(Clone, Copy, Debug)]
        pub enum $moment<$($shape,)+> {
            $(
                /// Of this one.
                $shape($shape),
            )+
        }

        impl<$($shape: Moment,)+> Moment for $moment<$($shape,)+> {
            fn exact_toi(&self, d: Raw) -> Toi {
                match self {
                    $(Self::$shape(it) => it.exact_toi(d),)+
                }
            }

            fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
                match self {
                    $(Self::$shape(it) => it.contact(d),)+
                }
            }
        }

        impl InDomain for $set {}

        impl Movable for $set {
            fn moved(&self, by: Vec2) -> Result<Self, RangeError> {
                self.translated(by)
            }
        }

        impl Extent for $set {
            fn extent(&self) -> Aabb {
                self.aabb()
            }
        }

        set!(@other $set, $moment: $($shape)+, [] Aabb);
        set!(@other $set, $moment: $($shape)+, [] Circle);
        set!(@other $set, $moment: $($shape)+, [] Segment);
        set!(@other $set, $moment: $($shape)+, [] Capsule);
        set!(@other $set, $moment: $($shape)+, [] OrientedBox);
        set!(@other $set, $moment: $($shape)+, [const N: usize] ConvexPolygon<N>);
        set!(@other $set, $moment: $($shape)+, [const N: usize] AnyShape<N>);

        // A compound as A takes all that has a bounding box.
        verbs!(of_set: [P: Single, const K: usize] $set: $($shape)+, Compound<P, K>);
        casts_of!([P: Single, const K: usize] $set: $($shape)+, $moment, Compound<P, K>);

        // The other verbs of two are those of two bodies.
        verbs!(@more of_set: [] $set: $($shape)+, $set);
        casts_of!([] $set: $($shape)+, $moment, $set);
        of_set!(Contains.contains -> bool, [] $set: $($shape)+, Vec2);
        of_set!(Distance.distance -> Fx, [] $set: $($shape)+, Vec2);
    };
    (@other $set:ident, $moment:ident: $($shape:ident)+, [$($n:tt)*] $other:ty) => {
        verbs!(of_set: [$($n)*] $set: $($shape)+, $other);
        verbs!(on_set: [$($n)*] $set: $($shape)+, $other);
        casts_of!([$($n)*] $set: $($shape)+, $moment, $other);
        casts_on!([$($n)*] $set: $($shape)+, $moment, $other);
    };
}

set!(Shape, ShapeMoment: Aabb Circle);
set!(WithCapsules, WithCapsulesMoment: Aabb Circle Capsule);
