//! Rays through everything: all hits in order, and whether there is none.

use super::scan::Scan;
use crate::error::RangeError;
use crate::num::Vec2;
use crate::world::shells::levels;
use crate::world::{RayHit, RayRules, Set, Store, TileMap};

/// The hits of a ray in order; see [`TileMap::cast_ray_all`].
#[derive(Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct RayHits<'w, 'a, S: Set, T: Store> {
    pub(in crate::world) scan: Scan<'w, TileMap<'a, S, T>>,
}

impl<S: Set, T: Store> Clone for RayHits<'_, '_, S, T> {
    fn clone(&self) -> Self {
        Self { scan: self.scan.clone() }
    }
}

/// Here and not with the others, because the cursor's parts are not known outside of levels.
#[cfg(feature = "defmt")]
impl<S: Set, T: Store> defmt::Format for RayHits<'_, '_, S, T> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "RayHits of {}", self.scan.level);
    }
}

impl<S: Set, T: Store> Iterator for RayHits<'_, '_, S, T> {
    type Item = RayHit;

    fn next(&mut self) -> Option<RayHit> {
        self.scan.advance()
    }
}

levels! {
    [S: Set, T: Store] TileMap<'_, S, T> {
        /// Whether a ray from `a` reaches `b` without a hit: the line between them is free of the closed solid.
        ///
        /// Exact, by the rules of [`cast_ray`](Self::cast_ray) with [`Inside::Hit`](crate::world::Inside::Hit): a start inside sees nothing, a corner that is touched blocks, a line that slides along a
        /// wall does not, one-way edges do not. On the surface `a` and `b` are not the same: a point on a wall sees what is in front of it, and is not seen,
        /// as the line ends in a hit. Cost: as [`cast_ray`](Self::cast_ray).
        ///
        /// ```
        /// use tilesat::{TileKind, TileKinds, TileMap, Vec2};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
        /// let map = TileMap::from_ascii("...\n.#.\n...", &KINDS)?;
        /// let (guard, near, far) = (Vec2::from_ints(8, 8), Vec2::from_ints(40, 8), Vec2::from_ints(40, 40));
        /// assert!(map.line_of_sight(guard, near).unwrap());
        /// assert!(!map.line_of_sight(guard, far).unwrap());
        /// # Ok::<(), tilesat::TileMapError>(())
        /// ```
        ///
        /// # Errors
        /// [`RangeError`] where a point is outside of the [domain](crate::num::DOMAIN).
        line_of_sight,
    }
}

impl<'a, S: Set, T: Store> TileMap<'a, S, T> {
    /// Every hit of a ray, nearest first, as if it went on through what it hits.
    ///
    /// By the rules of [`cast_ray`](Self::cast_ray), whose hit is the first: where the ray goes into the solid, or touches it at a corner. Where
    /// it comes out is no hit. Of several faces at one moment there is one hit, so the joint of two tiles is met once.
    ///
    /// Cost: a cursor that holds no hits, so none can be cut off. It walks as far as it is asked: at most width + height + 4 cells, and the
    /// cells of one step once more for each hit; no cell has more than three. [`RayHit::cells`] counts the cells up to that hit.
    ///
    /// ```
    /// use tilesat::{Inside, Slopes, TileKind, TileKinds, TileMap, TileShape, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'/', TileKind::of(TileShape::SlopeBottomRight));
    /// let map = TileMap::from_ascii("./..#.#", &TileKinds::EMPTY)?.with_kinds::<Slopes>(&KINDS)?;
    /// let hits = map.cast_ray_all(Vec2::from_ints(0, 12), Vec2::from_ints(112, 0), Inside::Ignore).unwrap();
    /// let found: Vec<_> = hits.map(|hit| (hit.point.x.to_num::<i32>(), hit.cell.x)).collect();
    /// assert_eq!(found, [(20, 1), (64, 4), (96, 6)]);
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] where the start or the end is outside of the [domain](crate::num::DOMAIN).
    pub fn cast_ray_all(
        &self,
        origin: Vec2,
        motion: Vec2,
        rules: impl Into<RayRules>,
    ) -> Result<RayHits<'_, 'a, S, T>, RangeError> {
        Ok(RayHits { scan: Scan::new(self, origin, motion, rules.into())? })
    }
}
