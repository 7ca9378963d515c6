//! The trait of all levels that a ray can meet, and their methods of the same names.

use super::scan::ScanHit;
use super::{Inside, RayHit, RayRules, checked};
use crate::error::RangeError;
use crate::num::{Raw, Vec2};
use crate::world::joined::hidden::{Beside, PartPath};
use crate::world::level::World;

/// A level that a ray can meet: every level of this crate.
///
/// Your code that takes any level and casts rays has this bound. It is sealed, as [`World`]:
/// [`Joined`](crate::Joined) needs the exact moments of both levels' hits.
///
/// ```
/// use tilesat::world::RayWorld;
/// use tilesat::{Joined, RangeError, Solids, TileKind, TileKinds, TileMap, Vec2};
/// fn sees<W: RayWorld>(level: &W, from: Vec2, to: Vec2) -> Result<bool, RangeError> {
///     level.line_of_sight(from, to)
/// }
///
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let (tiles, doors) = (TileMap::from_ascii(".#.", &KINDS)?, Solids::new(&[]));
/// let level = Joined::new(&tiles, &doors);
/// assert!(!sees(&level, Vec2::from_ints(4, 8), Vec2::from_ints(40, 8))?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait RayWorld: World {
    /// The cursor.
    #[doc(hidden)]
    type Scan<'w>: RayScan
    where
        Self: 'w;

    /// Whether a ray starts and ends in the domain, also relative to a level inside.
    #[doc(hidden)]
    fn check_ray(&self, origin: Vec2, motion: Vec2) -> Result<(Raw, Raw), RangeError> {
        checked(origin, motion)
    }

    /// The hits of a ray that was checked. It cannot fail: a result of a large cursor takes its
    /// size on the stack again.
    #[doc(hidden)]
    fn scan(&self, o: Raw, d: Raw, rules: RayRules) -> Self::Scan<'_>;

    /// The first hit of a ray, as [`TileMap::cast_ray`](crate::TileMap::cast_ray).
    ///
    /// # Errors
    /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
    fn cast_ray(&self, origin: Vec2, motion: Vec2, rules: impl Into<RayRules>) -> Result<Option<RayHit>, RangeError> {
        let (o, d) = self.check_ray(origin, motion)?;
        Ok(self.scan(o, d, rules.into()).next())
    }

    /// Whether a straight line is free of the level, as
    /// [`TileMap::line_of_sight`](crate::TileMap::line_of_sight).
    ///
    /// # Errors
    /// [`RangeError`] if a point is outside the [domain](crate::num::DOMAIN).
    fn line_of_sight(&self, a: Vec2, b: Vec2) -> Result<bool, RangeError> {
        let (from, to) = (Raw::of(a), Raw::of(b));
        Ok(self.cast_ray(a, to.sub(from).vec2(), Inside::Hit)?.is_none())
    }

    /// Visits the levels from which this one is joined, each with its path. No part covers one of
    /// its own faces.
    #[doc(hidden)]
    fn parts(&self, path: PartPath, visit: &mut dyn FnMut(PartPath, &dyn Beside))
    where
        Self: Sized,
    {
        visit(path, self);
    }
}

/// See [`RayWorld`].
pub trait RayScan: Iterator<Item = RayHit> {
    /// The next hit, with the piece that was met.
    fn next_found(&mut self) -> Option<ScanHit>;

    /// Whether the ray is inside the solid just after its start, which is not inside.
    fn goes_in(&self) -> bool;
}

/// The methods of each kind of level, which need no import of [`RayWorld`], after the documentation
/// of each:
/// `rays! { [parameters] type { /// ... cast_ray, /// ... cast_ray_all -> cursor, ... } }`.
macro_rules! rays {
    ([$($parameters:tt)*] $level:ty { $($(#[$doc:meta])* $verb:ident $(-> $hits:ty)?,)* }) => {
        impl<$($parameters)*> $level {
            $($crate::world::ray::world::rays! { @$verb $($hits,)? $(#[$doc])* })*
        }
    };
    (@cast_ray $(#[$doc:meta])*) => {
        $(#[$doc])*
        #[doc(alias("raycast", "linecast"))]
        pub fn cast_ray(
            &self,
            origin: $crate::Vec2,
            motion: $crate::Vec2,
            rules: impl Into<$crate::world::RayRules>,
        ) -> Result<Option<$crate::world::RayHit>, $crate::RangeError> {
            $crate::world::ray::world::RayWorld::cast_ray(self, origin, motion, rules)
        }
    };
    (@cast_ray_all $hits:ty, $(#[$doc:meta])*) => {
        $(#[$doc])*
        pub fn cast_ray_all(
            &self,
            origin: $crate::Vec2,
            motion: $crate::Vec2,
            rules: impl Into<$crate::world::RayRules>,
        ) -> Result<$hits, $crate::RangeError> {
            let (o, d) = $crate::world::ray::world::RayWorld::check_ray(self, origin, motion)?;
            Ok($crate::world::ray::world::RayWorld::scan(self, o, d, rules.into()))
        }
    };
    (@line_of_sight $(#[$doc:meta])*) => {
        $(#[$doc])*
        #[doc(alias("linecast", "visibility"))]
        pub fn line_of_sight(&self, a: $crate::Vec2, b: $crate::Vec2) -> Result<bool, $crate::RangeError> {
            $crate::world::ray::world::RayWorld::line_of_sight(self, a, b)
        }
    };
}
pub(in crate::world) use rays;
