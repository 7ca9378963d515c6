//! The methods and traits that every kind of level has, by macros.

/// Methods by name, after the documentation of each:
/// `levels! { [parameters] type { /// ... overlaps, ... } }`.
macro_rules! levels {
    ([$($parameters:tt)*] $level:ty { $($(#[$doc:meta])* $verb:ident,)* }) => {
        impl<$($parameters)*> $level {
            $($crate::world::methods::levels! { @$verb $(#[$doc])* })*
        }
    };
    (@overlaps $(#[$doc:meta])*) => {
        $(#[$doc])*
        #[inline]
        #[must_use]
        pub fn overlaps<Body>(&self, body: &Body) -> bool
        where
            Self: $crate::query::Overlaps<Body>,
        {
            $crate::query::Overlaps::overlaps(self, body)
        }
    };
    (@flags_touched $(#[$doc:meta])*) => {
        $(#[$doc])*
        #[must_use]
        pub fn flags_touched<P: $crate::world::Probe>(&self, shape: &P) -> u8 {
            $crate::world::World::flags_touched(self, shape)
        }
    };
    (@touches $(#[$doc:meta])*) => {
        $(#[$doc])*
        #[inline]
        #[must_use]
        pub fn touches<Body>(&self, body: &Body) -> bool
        where
            Self: $crate::query::Touches<Body>,
        {
            $crate::query::Touches::touches(self, body)
        }
    };
}
pub(in crate::world) use levels;

/// The traits of a level whose own tests are those of its [`World`](crate::world::World).
macro_rules! meets_as_world {
    ([$($parameters:tt)*] $level:ty) => {
        $crate::world::methods::meets_as_world! { @ [$($parameters)*] $level, Overlaps, overlaps, overlaps_aabb, overlaps_circle }
        $crate::world::methods::meets_as_world! { @ [$($parameters)*] $level, Touches, touches, touches_aabb, touches_circle }
    };
    (@ [$($parameters:tt)*] $level:ty, $verb:ident, $method:ident, $aabb:ident, $circle:ident) => {
        impl<$($parameters)*> $crate::query::$verb<$crate::Aabb> for $level {
            fn $method(&self, b: &$crate::Aabb) -> bool {
                self.$aabb(b)
            }
        }

        impl<$($parameters)*> $crate::query::$verb<$crate::Circle> for $level {
            fn $method(&self, c: &$crate::Circle) -> bool {
                self.$circle(c)
            }
        }
    };
}
pub(in crate::world) use meets_as_world;
