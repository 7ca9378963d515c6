//! Rays against two levels at once: both levels' hits, in order, less what the other level hides.

use super::hidden::hides;
use crate::error::RangeError;
use crate::num::{Raw, Vec2, less128, mul64};
use crate::world::ray::cast::checked;
use crate::world::ray::piece::{Met, Time};
use crate::world::ray::scan::Found;
use crate::world::shells::levels;
use crate::world::{
    Joined, RayHit, RayHits, RayRules, SegmentMap, SegmentRayHits, Set, SolidRayHits, Solids, Store, TileMap, World,
};
use core::cmp::Ordering;

/// A level that can be asked for the hits of a ray with their exact moments. Public in a private module, because [`Joined`] needs it of both.
pub trait RayWorld: World {
    /// The cursor.
    type Scan<'w>: RayScan
    where
        Self: 'w;

    /// # Errors
    /// [`RangeError`] where the start or the end is outside of the domain.
    fn scan(&self, origin: Vec2, motion: Vec2, rules: RayRules) -> Result<Self::Scan<'_>, RangeError>;
}

/// See [`RayWorld`].
pub trait RayScan {
    /// The next hit.
    fn next_found(&mut self) -> Option<Found>;
}

impl<'a, S: Set, T: Store> RayWorld for TileMap<'a, S, T> {
    type Scan<'w>
        = RayHits<'w, 'a, S, T>
    where
        Self: 'w;

    fn scan(&self, origin: Vec2, motion: Vec2, rules: RayRules) -> Result<Self::Scan<'_>, RangeError> {
        self.cast_ray_all(origin, motion, rules)
    }
}

impl<S: Set, T: Store> RayScan for RayHits<'_, '_, S, T> {
    fn next_found(&mut self) -> Option<Found> {
        self.scan.find()
    }
}

impl<'a> RayWorld for SegmentMap<'a> {
    type Scan<'w>
        = SegmentRayHits<'w, 'a>
    where
        Self: 'w;

    fn scan(&self, origin: Vec2, motion: Vec2, rules: RayRules) -> Result<Self::Scan<'_>, RangeError> {
        self.cast_ray_all(origin, motion, rules)
    }
}

impl RayScan for SegmentRayHits<'_, '_> {
    fn next_found(&mut self) -> Option<Found> {
        SegmentRayHits::find(self)
    }
}

impl RayWorld for Solids<'_> {
    type Scan<'w>
        = SolidRayHits<'w>
    where
        Self: 'w;

    fn scan(&self, origin: Vec2, motion: Vec2, rules: RayRules) -> Result<Self::Scan<'_>, RangeError> {
        self.cast_ray_all(origin, motion, rules)
    }
}

impl RayScan for SolidRayHits<'_> {
    fn next_found(&mut self) -> Option<Found> {
        self.find()
    }
}

impl<A: RayWorld, B: RayWorld> RayWorld for Joined<'_, A, B> {
    type Scan<'w>
        = JoinedRayHits<'w, A, B>
    where
        Self: 'w;

    fn scan(&self, origin: Vec2, motion: Vec2, rules: RayRules) -> Result<Self::Scan<'_>, RangeError> {
        self.cast_ray_all(origin, motion, rules)
    }
}

impl<A: RayWorld, B: RayWorld> Joined<'_, A, B> {
    /// All hits of a ray in order, as if it went on through what it hits. Of hits at one moment there is one.
    ///
    /// Cost: as [`cast_ray`](Self::cast_ray).
    ///
    /// # Errors
    /// As [`cast_ray`](Self::cast_ray).
    pub fn cast_ray_all(
        &self,
        origin: Vec2,
        motion: Vec2,
        rules: impl Into<RayRules>,
    ) -> Result<JoinedRayHits<'_, A, B>, RangeError> {
        let rules = rules.into();
        let (o, d) = checked(origin, motion)?;
        let (a, b) = (self.first().scan(origin, motion, rules)?, self.second().scan(origin, motion, rules)?);
        Ok(JoinedRayHits { pair: *self, o, d, a: Side::new(a), b: Side::new(b) })
    }
}

levels! {
    [A: RayWorld, B: RayWorld] Joined<'_, A, B> {
        /// The first point of either level's solid that a ray meets, or `None` where it ends before.
        ///
        /// By the rules of the levels' own `cast_ray`, for the faces that [`features`](Self::features) shows: a ray along a floor that goes on
        /// from level to level meets nothing. A ray along the very line between two solids that meet flush is in neither: it is stopped
        /// where it comes to that line, but one that starts there is not.
        ///
        /// Cost: both levels' cost, and for each hit a look at the other level along the face. [`RayHit::cells`] counts those of the level
        /// that was hit.
        ///
        /// ```
        /// use tilesat::{Fx, Grid, Inside, Joined, TileKind, TileKinds, TileMap, Vec2};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
        /// let floor = TileMap::from_ascii("  \n##", &KINDS)?;
        /// // Another floor goes on from there, and ends in a wall.
        /// let other = floor.with_origin(Vec2::from_ints(32, 0))?;
        /// let wall = TileMap::from_ascii(" #\n##", &KINDS)?.with_origin(Vec2::from_ints(64, 0))?;
        /// let floors = Joined::new(&floor, &other);
        /// let level = Joined::new(&floors, &wall);
        /// let hit = level.cast_ray(Vec2::from_ints(4, 16), Vec2::from_ints(200, 0), Inside::Hit).unwrap().unwrap();
        /// assert_eq!((hit.point, hit.source), (Vec2::from_ints(80, 16), 1));
        /// # Ok::<(), tilesat::TileMapError>(())
        /// ```
        ///
        /// # Errors
        /// [`RangeError`] where the start or the end is outside of the [domain](crate::num::DOMAIN).
        cast_ray,
        /// Whether the straight line from `a` to `b` is free of both levels, as a ray from `a` sees it, and does not start inside.
        ///
        /// # Errors
        /// [`RangeError`] where a point is outside of the [domain](crate::num::DOMAIN).
        line_of_sight,
    }
}

/// The hits of a ray in order; see [`Joined::cast_ray_all`].
#[derive(Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct JoinedRayHits<'w, A: RayWorld, B: RayWorld> {
    pub(crate) pair: Joined<'w, A, B>,
    o: Raw,
    d: Raw,
    a: Side<A::Scan<'w>>,
    b: Side<B::Scan<'w>>,
}

/// The hits of one level, one ahead.
#[derive(Debug)]
struct Side<S> {
    scan: S,
    next: Option<Found>,
}

impl<S: RayScan> Side<S> {
    fn new(scan: S) -> Self {
        Self { scan, next: None }
    }

    /// Has the next hit that the other level does not hide at hand.
    fn fill<W: World>(&mut self, o: Raw, d: Raw, other: &W) {
        while self.next.is_none() {
            let Some(found) = self.scan.next_found() else { return };
            if !found.met.is_some_and(|met| hides(&met.feature.geometry, o, d, other)) {
                self.next = Some(found);
            }
        }
    }
}

impl<A: RayWorld, B: RayWorld> RayScan for JoinedRayHits<'_, A, B> {
    fn next_found(&mut self) -> Option<Found> {
        self.a.fill(self.o, self.d, self.pair.second());
        self.b.fill(self.o, self.d, self.pair.first());
        let order = match (&self.a.next, &self.b.next) {
            (Some(a), Some(b)) => order(a, b),
            (None, _) => Ordering::Greater,
            (_, None) => Ordering::Less,
        };
        let (from_a, from_b) = (self.a.next, self.b.next);
        let met = |f: Option<Found>| f.and_then(|f| f.met);
        let ranks = |(b, a): (Met, Met)| b.touch.ranks_above(&b.feature, &a, self.d);
        // One hit a moment.
        let second = order.is_gt() || (order.is_eq() && met(from_b).zip(met(from_a)).is_some_and(ranks));
        let (found, source) = if second { (from_b, 1) } else { (from_a, 0) };
        if order.is_le() {
            self.a.next = None;
        }
        if order.is_ge() {
            self.b.next = None;
        }
        found.map(|f| Found { hit: RayHit { source: f.hit.source << 1 | source, ..f.hit }, ..f })
    }
}

impl<A: RayWorld, B: RayWorld> Iterator for JoinedRayHits<'_, A, B> {
    type Item = RayHit;

    fn next(&mut self) -> Option<RayHit> {
        self.next_found().map(|found| found.hit)
    }
}

/// Which is first: starts inside, then by the exact moments. A hit within an arc has none, and is compared by its `toi`, after a straight one.
fn order(a: &Found, b: &Found) -> Ordering {
    let (Some(met_a), Some(met_b)) = (a.met, b.met) else { return a.met.is_some().cmp(&b.met.is_some()) };
    match (met_a.touch.time, met_b.touch.time) {
        (Some(s), Some(t)) if before(s, t) => Ordering::Less,
        (Some(s), Some(t)) if before(t, s) => Ordering::Greater,
        (Some(_), Some(_)) => Ordering::Equal,
        (s, t) => (a.hit.toi.raw(), s.is_none(), false).cmp(&(b.hit.toi.raw(), t.is_none(), true)),
    }
}

fn before(s: Time, t: Time) -> bool {
    less128(mul64(s.num, t.den), mul64(t.num, s.den))
}
