//! Two levels used as one: their surfaces, and rays against both.

mod hidden;

use super::level::{Feature, MotionPiece, Seen, World, levels, meets_as_world, sealed};
use super::ray::{Met, RayHit, RayRules, Time, checked, rays};
use crate::error::RangeError;
use crate::num::{Raw, Vec2, less128, mul64};
use crate::shape::{Aabb, Circle};
use crate::world::convex::ConvexBody;
use crate::world::ray::scan::{RayScan, RayWorld, ScanHit};
use core::cmp::Ordering;
use hidden::{Beside, hides, shown};

/// Two levels used as one: tiles and segments, or a level and its neighbour. It copies nothing.
///
/// A point that is solid in either level is solid. There is no seam between the two. A corner that
/// lies in the other level's solid is hidden, except where both together form a corner. A face is
/// hidden if the other solid covers its front from end to end. A floor of tiles that continues as a
/// floor of segments is one floor, also for a mover. Faces that are covered in part stay whole, and
/// so do arcs.
///
/// A pair is itself a level. For more than two levels, join pairs. The lowest bit of a
/// [`Feature::source`] is 0 for a feature of the first level, and 1 for the second. The other bits
/// are the source in that level.
///
/// Each level is tested separately. So a body without area overlaps a pair if it overlaps one of
/// the two. On the line between two solids that meet flush it overlaps neither.
///
/// Cost: that of both levels, and one or two look-ups of a point in the other level for each
/// feature. If that point is solid, also the other level's features along the face.
///
/// ```
/// use tilesat::{Aabb, Axis, Fx, Grid, Joined, Mover, TileKind, TileKinds, TileMap, Vec2};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// // A floor at y = 32, of cells of 16 units to x = 48, and of cells of 32 units from there on.
/// let fine = TileMap::from_ascii("   \n   \n###", &KINDS)?;
/// let coarse = TileMap::on_grid(b"  ##", Grid::new(2, 2, Fx::from_num(32), Vec2::from_ints(48, 0))?, &KINDS)?;
/// let level = Joined::new(&fine, &coarse);
///
/// let player = Aabb::new(Vec2::from_ints(30, 22), Vec2::from_ints(40, 32)).unwrap();
/// assert!(level.touches(&player) && !level.overlaps(&player));
/// let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&level, &player, Vec2::from_ints(40, 1)).unwrap();
/// assert_eq!(moved.position(), Vec2::from_ints(70, 22)); // over the joint, which has no effect
/// # Ok::<(), tilesat::TileMapError>(())
/// ```
#[derive(Debug)]
#[doc(alias("composite", "union"))]
pub struct Joined<'a, A, B> {
    a: &'a A,
    b: &'a B,
}

impl<A, B> Clone for Joined<'_, A, B> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<A, B> Copy for Joined<'_, A, B> {}

impl<'a, A: World, B: World> Joined<'a, A, B> {
    /// Joins two levels.
    #[must_use]
    pub const fn new(a: &'a A, b: &'a B) -> Self {
        Self { a, b }
    }

    /// The first level.
    #[must_use]
    pub const fn first(&self) -> &'a A {
        self.a
    }

    /// The second level.
    #[must_use]
    pub const fn second(&self) -> &'a B {
        self.b
    }

    /// The pieces of both surfaces that have a point in the closed region and that the other level
    /// does not hide. The first level's pieces come first.
    ///
    /// The directions of a corner are those of both solids together. Pieces near the region may be
    /// included. Cost: see [`Joined`].
    pub fn features(&self, region: &Aabb) -> JoinedFeatures<'_, A, B> {
        JoinedFeatures { pair: *self, a: self.a.features(region), b: self.b.features(region) }
    }
}

levels! {
    [A: World, B: World] Joined<'_, A, B> {
        /// Whether a shape overlaps the solid of either level; strict and exact.
        ///
        /// Cost: both levels' cost. It cannot fail.
        overlaps,
        /// Whether a shape has a point in common with the solid of either level, borders
        /// included; exact.
        ///
        /// Cost: both levels' cost. It cannot fail.
        touches,
    }
}

/// The cursor of [`Joined::features`].
#[derive(Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct JoinedFeatures<'w, A: World, B: World> {
    pub(crate) pair: Joined<'w, A, B>,
    a: A::Features<'w>,
    b: B::Features<'w>,
}

impl<A: World, B: World> Iterator for JoinedFeatures<'_, A, B> {
    type Item = Feature;

    fn next(&mut self) -> Option<Feature> {
        for f in self.a.by_ref() {
            if let Some(shown) = shown::<Joined<'_, A, B>>(f, self.pair.b, true) {
                return Some(Feature { source: shown.source << 1, ..shown });
            }
        }
        for f in self.b.by_ref() {
            if let Some(shown) = shown::<Joined<'_, A, B>>(f, self.pair.a, false) {
                return Some(Feature { source: shown.source << 1 | 1, ..shown });
            }
        }
        None
    }
}

impl<A: World, B: World> sealed::Sealed for Joined<'_, A, B> {}

impl<A: World, B: World> World for Joined<'_, A, B> {
    const BLOCKS: bool = A::BLOCKS && B::BLOCKS;
    const ROUND: bool = A::ROUND || B::ROUND;
    const WIDE: bool = A::WIDE || B::WIDE;
    const CERTAIN: bool = A::CERTAIN && B::CERTAIN;

    #[doc(hidden)]
    const ARCS: bool = A::ARCS || B::ARCS;

    type Features<'w>
        = JoinedFeatures<'w, A, B>
    where
        Self: 'w;

    fn features(&self, region: &Aabb) -> JoinedFeatures<'_, A, B> {
        Joined::features(self, region)
    }

    fn features_ahead(&self, way: &MotionPiece) -> JoinedFeatures<'_, A, B> {
        JoinedFeatures { pair: *self, a: self.a.features_ahead(way), b: self.b.features_ahead(way) }
    }

    fn look(&self, region: &Aabb, r: i32, seen: &mut Seen) -> bool {
        let mut other = Seen::NOTHING;
        let known = self.a.look(region, r, seen) | self.b.look(region, r, &mut other);
        seen.cells = None;
        seen.held = match (seen.held, other.held) {
            (Some(a), Some(b)) => Some(a.union(&b)),
            (a, b) => a.or(b),
        };
        known
    }

    /// The shorter of the two: a piece of a motion then reaches few cells of either level.
    fn cell_size(&self) -> u32 {
        self.a.cell_size().min(self.b.cell_size())
    }

    fn most_cells(&self, width: u32, height: u32) -> u32 {
        self.a.most_cells(width, height).saturating_add(self.b.most_cells(width, height))
    }

    fn overlaps_aabb(&self, b: &Aabb) -> bool {
        self.a.overlaps_aabb(b) || self.b.overlaps_aabb(b)
    }

    fn meets_convex(&self, body: &ConvexBody<'_>, closed: bool) -> bool {
        self.a.meets_convex(body, closed) || self.b.meets_convex(body, closed)
    }

    fn overlaps_circle(&self, c: &Circle) -> bool {
        self.a.overlaps_circle(c) || self.b.overlaps_circle(c)
    }

    fn touches_aabb(&self, b: &Aabb) -> bool {
        self.a.touches_aabb(b) || self.b.touches_aabb(b)
    }

    fn touches_circle(&self, c: &Circle) -> bool {
        self.a.touches_circle(c) || self.b.touches_circle(c)
    }
}

meets_as_world! { [A: World, B: World] Joined<'_, A, B> }

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
    /// All hits of a ray in order, as if it continued through what it hits. Hits at the same moment
    /// count as one.
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
        Ok(JoinedRayHits { pair: *self, o, d, a: OneAhead::new(a), b: OneAhead::new(b) })
    }
}

rays! {
    [A: RayWorld, B: RayWorld] Joined<'_, A, B> {
        /// The first point of either level's solid that a ray meets, or `None` if it ends
        /// before.
        ///
        /// It follows the rules of the levels' own `cast_ray`, for the faces that
        /// [`features`](Self::features) shows. A ray along a floor that continues from level to
        /// level meets nothing. A ray along the very line between two solids that meet flush is in
        /// neither. It stops if it reaches that line, but not if it starts on it. Nor does a ray
        /// that starts on that line in another direction always stop, even from the line's end at
        /// the surface. Start it a raw unit outside of the solid.
        ///
        /// Cost: that of both levels, and a look at the other level along the face for each hit.
        /// [`RayHit::cells`] counts the cells of the level that was hit.
        ///
        /// ```
        /// use tilesat::{Fx, Grid, Inside, Joined, TileKind, TileKinds, TileMap, Vec2};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
        /// let floor = TileMap::from_ascii("  \n##", &KINDS)?;
        /// // Another floor continues from there, and ends in a wall.
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
        /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
        cast_ray,
        /// Whether the straight line from `a` to `b` is free of both levels, and does not start
        /// inside. A ray from `a` decides it.
        ///
        /// # Errors
        /// [`RangeError`] if a point is outside the [domain](crate::num::DOMAIN).
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
    a: OneAhead<A::Scan<'w>>,
    b: OneAhead<B::Scan<'w>>,
}

/// The hits of one level, one ahead.
#[derive(Debug)]
struct OneAhead<S> {
    scan: S,
    next: Option<ScanHit>,
}

impl<S: RayScan> OneAhead<S> {
    fn new(scan: S) -> Self {
        Self { scan, next: None }
    }

    /// Prepares the next hit that the other level does not hide.
    fn fill<J: World>(&mut self, o: Raw, d: Raw, other: &dyn Beside) {
        while self.next.is_none() {
            let Some(found) = self.scan.next_found() else { return };
            if !found.met.is_some_and(|met| hides::<J>(&met.feature.geometry, o, d, other)) {
                self.next = Some(found);
            }
        }
    }
}

impl<A: RayWorld, B: RayWorld> RayScan for JoinedRayHits<'_, A, B> {
    fn next_found(&mut self) -> Option<ScanHit> {
        self.a.fill::<Joined<'_, A, B>>(self.o, self.d, self.pair.second());
        self.b.fill::<Joined<'_, A, B>>(self.o, self.d, self.pair.first());
        let order = match (&self.a.next, &self.b.next) {
            (Some(a), Some(b)) => order(a, b),
            (None, _) => Ordering::Greater,
            (_, None) => Ordering::Less,
        };
        let (from_a, from_b) = (self.a.next, self.b.next);
        let met = |f: Option<ScanHit>| f.and_then(|f| f.met);
        let ranks = |(b, a): (Met, Met)| b.touch.ranks_above(&b.feature, &a, self.d);
        // One hit per moment.
        let second = order.is_gt() || (order.is_eq() && met(from_b).zip(met(from_a)).is_some_and(ranks));
        let (found, source) = if second { (from_b, 1) } else { (from_a, 0) };
        if order.is_le() {
            self.a.next = None;
        }
        if order.is_ge() {
            self.b.next = None;
        }
        found.map(|f| ScanHit { hit: RayHit { source: f.hit.source << 1 | source, ..f.hit }, ..f })
    }
}

impl<A: RayWorld, B: RayWorld> Iterator for JoinedRayHits<'_, A, B> {
    type Item = RayHit;

    fn next(&mut self) -> Option<RayHit> {
        self.next_found().map(|found| found.hit)
    }
}

/// Which hit is first: a start inside, then by the exact moments. A hit within an arc has no exact
/// moment, and is compared by its `toi`, after a straight one.
fn order(a: &ScanHit, b: &ScanHit) -> Ordering {
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
