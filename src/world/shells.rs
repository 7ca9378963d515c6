//! Methods that every kind of level has, each with its own words on what they mean there.
//!
//! They are inherent, so that no trait has to be imported to call them.

/// Methods by name, after the documentation of each: `levels! { [parameters] type { /// ... overlaps, ... } }`.
macro_rules! levels {
    ([$($parameters:tt)*] $level:ty { $($(#[$doc:meta])* $verb:ident,)* }) => {
        impl<$($parameters)*> $level {
            $($crate::world::shells::levels! { @$verb $(#[$doc])* })*
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
    (@cast_ray $(#[$doc:meta])*) => {
        $(#[$doc])*
        pub fn cast_ray(
            &self,
            origin: $crate::Vec2,
            motion: $crate::Vec2,
            rules: impl Into<$crate::world::RayRules>,
        ) -> Result<Option<$crate::world::RayHit>, $crate::RangeError> {
            Ok(self.cast_ray_all(origin, motion, rules)?.next())
        }
    };
    (@line_of_sight $(#[$doc:meta])*) => {
        $(#[$doc])*
        pub fn line_of_sight(&self, a: $crate::Vec2, b: $crate::Vec2) -> Result<bool, $crate::RangeError> {
            let (from, to) = ($crate::num::Raw::of(a), $crate::num::Raw::of(b));
            Ok(self.cast_ray(a, to.sub(from).vec2(), $crate::world::Inside::Hit)?.is_none())
        }
    };
    (@contacts $(#[$doc:meta])*) => {
        $(#[$doc])*
        pub fn contacts<Body: $crate::world::Pushable>(
            &self,
            body: &Body,
            one_way: $crate::world::OneWay,
            out: &mut heapless::VecView<$crate::world::WorldContact>,
        ) -> Result<u32, $crate::Truncated> {
            $crate::world::near::contacts::contacts(self, body, one_way, out)
        }
    };
    (@closest_point $(#[$doc:meta])*) => {
        $(#[$doc])*
        pub fn closest_point(
            &self,
            p: $crate::Vec2,
            within: $crate::Fx,
            one_way: $crate::world::OneWay,
        ) -> Result<Option<$crate::world::Near>, $crate::RangeError> {
            $crate::world::near::closest::closest_point(self, p, within, one_way)
        }
    };
}
pub(in crate::world) use levels;

/// The traits of a level whose own tests are those of its [`World`](crate::world::World).
macro_rules! meets_as_world {
    ([$($parameters:tt)*] $level:ty) => {
        $crate::world::shells::meets_as_world! { @ [$($parameters)*] $level, Overlaps, overlaps, overlaps_aabb, overlaps_circle }
        $crate::world::shells::meets_as_world! { @ [$($parameters)*] $level, Touches, touches, touches_aabb, touches_circle }
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
