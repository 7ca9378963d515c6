//! Rays against a level at another place.

use super::joined::ray::{RayScan, RayWorld};
use super::ray::cast::checked;
use super::ray::scan::Found;
use super::{Placed, RayHit, RayRules};
use crate::error::RangeError;
use crate::num::{Raw, Vec2};
use crate::world::shells::levels;

impl<W: RayWorld> Placed<'_, W> {
    /// All hits of a ray in order, as if it went on through what it hits. Of hits at one moment there is one.
    ///
    /// # Errors
    /// As [`cast_ray`](Self::cast_ray).
    pub fn cast_ray_all(
        &self,
        origin: Vec2,
        motion: Vec2,
        rules: impl Into<RayRules>,
    ) -> Result<PlacedRayHits<'_, W>, RangeError> {
        let (o, _) = checked(origin, motion)?;
        let offset = Raw::of(self.offset());
        Ok(PlacedRayHits { scan: self.world().scan(o.sub(offset).vec2(), motion, rules.into())?, offset })
    }
}

levels! {
    [W: RayWorld] Placed<'_, W> {
        /// The first point of the level that a ray from `origin` along `motion` meets, or `None` where it ends before.
        ///
        /// By the rules of the level's own `cast_ray`, of which it is the result, bit for bit, shifted.
        ///
        /// ```
        /// use tilesat::{Axis, Inside, Placed, TileKind, TileKinds, TileMap, Vec2};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
        /// let room = TileMap::from_ascii("#.#", &KINDS)?;
        /// let slides_in = Placed::new(&room, Vec2::from_ints(100, 7))?;
        /// let hit = slides_in.cast_ray(Vec2::from_ints(120, 10), Vec2::from_ints(90, 0), Inside::Hit)?.unwrap();
        /// assert_eq!((hit.point, hit.axis, hit.cell.x), (Vec2::from_ints(132, 10), Axis::NEG_X, 2));
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        ///
        /// # Errors
        /// [`RangeError`] where the start or the end is outside of the [domain](crate::num::DOMAIN), here or as the level sees it: less the offset.
        cast_ray,
        /// Whether the straight line from `a` to `b` is free of the level, as a ray from `a` sees it, and does not start inside.
        ///
        /// # Errors
        /// As [`cast_ray`](Self::cast_ray).
        line_of_sight,
    }
}

/// The hits of a ray in order; see [`Placed::cast_ray_all`].
#[derive(Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct PlacedRayHits<'w, W: RayWorld + 'w> {
    pub(crate) scan: W::Scan<'w>,
    pub(crate) offset: Raw,
}

impl<W: RayWorld> RayScan for PlacedRayHits<'_, W> {
    fn next_found(&mut self) -> Option<Found> {
        let mut found = self.scan.next_found()?;
        found.hit.point = Raw::of(found.hit.point).add(self.offset).vec2();
        if let Some(met) = &mut found.met {
            met.feature.shift(self.offset);
        }
        Some(found)
    }
}

impl<W: RayWorld> Iterator for PlacedRayHits<'_, W> {
    type Item = RayHit;

    fn next(&mut self) -> Option<RayHit> {
        self.next_found().map(|found| found.hit)
    }
}

impl<W: RayWorld> RayWorld for Placed<'_, W> {
    type Scan<'w>
        = PlacedRayHits<'w, W>
    where
        Self: 'w;

    fn scan(&self, origin: Vec2, motion: Vec2, rules: RayRules) -> Result<Self::Scan<'_>, RangeError> {
        self.cast_ray_all(origin, motion, rules)
    }
}
