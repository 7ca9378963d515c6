//! Questions about the bodies of a scene: the first one on a ray or a motion, and those at a place.

use super::kernel::BodyShape;
use super::{Scene, SceneBody};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::error::RangeError;
use crate::filter::Filter;
use crate::num::{MOTION, Raw, Toi, Vec2, check_motion};
use crate::query::{CastHit, CastShape, Inside, Overlaps, Touches};
use crate::shape::Aabb;
use crate::shape::kernel::Extent;

/// The first body that a ray or a moving shape hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias = "RaycastHit")]
pub struct SceneHit {
    /// The body.
    pub body: Handle,
    /// The hit of its shape. Its time is the exact floor in parts of 2^30, also if the shape is
    /// round.
    pub hit: CastHit,
}

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, const M: usize, S: BodyShape> Scene<B, N, M, S> {
    /// The first body that a ray from `origin` along `motion` hits, for which `wanted` is true;
    /// `None` if the ray ends before. For hitscan weapons, lasers and lines of sight.
    ///
    /// Each body is hit by the `cast_ray` of its shape, such as
    /// [`Circle::cast_ray`](crate::Circle::cast_ray): exact. A ray that ends at a body hits it. One
    /// that only slides along it does not, nor does one that leaves its border. Bodies that sleep,
    /// fixed bodies and sensors count, at their current positions. `wanted` is called at most once
    /// per body, for bodies whose boxes the ray touches. Exclude the shooter by its handle, and
    /// choose layers by the body's [filter](SceneBody::filter).
    ///
    /// The times of all shapes are compared by their exact floors in parts of 2^30 of the motion.
    /// At the same time the smaller [key](SceneBody::key) comes first, then the smaller slot. So
    /// with unique keys, the answer does not depend on the order of insertion or on the broad
    /// phase. Mirrored scenes have the same first body, at the same time.
    ///
    /// The ray does not look at the level: [`cast_ray_in`](Self::cast_ray_in) does.
    ///
    /// Cost: that of [`BroadPhase::along`], and a ray for each wanted body in front of the first
    /// hit. For a round shape, a hit that may be first takes up to 60 exact comparisons.
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, SortSweepScene};
    /// use tilesat::{Aabb, Circle, Inside, Vec2, fx};
    /// let mut scene = SortSweepScene::<8>::empty();
    /// let gunner = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(8, 16))?;
    /// let gunner = scene.insert(&SceneBody::new(gunner, 1))?;
    /// let bat = scene.insert(&SceneBody::new(Circle::new(Vec2::from_ints(40, 8), fx!(8))?, 2))?;
    /// scene.insert(&SceneBody::new(Circle::new(Vec2::from_ints(100, 8), fx!(8))?, 3))?;
    ///
    /// let (from, motion) = (Vec2::from_ints(4, 8), Vec2::from_ints(112, 0));
    /// let shoot = |ghost| scene.cast_ray(from, motion, Inside::Hit, |body, _| body != gunner && Some(body) != ghost);
    /// let first = shoot(None)?.unwrap();
    /// assert!(first.body == bat && first.hit.displacement.x.round() == 28);
    /// assert_eq!(shoot(Some(bat))?.unwrap().hit.displacement.x.round(), 88); // the next one
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
    #[doc(alias("raycast", "hitscan", "linecast"))]
    pub fn cast_ray(
        &self,
        origin: Vec2,
        motion: Vec2,
        inside: Inside,
        wanted: impl FnMut(Handle, &SceneBody<S>) -> bool,
    ) -> Result<Option<SceneHit>, RangeError> {
        self.first_on_ray(origin, motion, inside, None, wanted)
    }

    /// [`cast_ray`](Self::cast_ray), before a time if there is one.
    pub(super) fn first_on_ray(
        &self,
        origin: Vec2,
        motion: Vec2,
        inside: Inside,
        before: Option<Toi>,
        wanted: impl FnMut(Handle, &SceneBody<S>) -> bool,
    ) -> Result<Option<SceneHit>, RangeError> {
        let cast = |shape: &S| shape.ray_hit(origin, motion, inside);
        let exact = |shape: &S| shape.ray_toi(origin, Raw::of(motion));
        self.first((&Aabb::new(origin, origin)?, motion), before, wanted, cast, exact)
    }

    /// The first body that a shape hits as it moves by `motion`, for which `wanted` is true; `None`
    /// if it starts no overlap.
    ///
    /// The shape is a body's [set of shapes](super::WithCapsules), any single shape, or a
    /// [`Compound`](crate::shape::Compound). Bodies do not move meanwhile. A hit is the start of an
    /// overlap, as in [`CastShape`]: shapes that only touch or slide along do not hit. Bodies,
    /// `wanted` and ties are as in [`cast_ray`](Self::cast_ray).
    ///
    /// The shape does not look at the level: [`cast_shape_in`](Self::cast_shape_in) does.
    ///
    /// Cost: as `cast_ray`, with a cast of the two shapes for each body.
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, SortSweepScene};
    /// use tilesat::{Aabb, Capsule, Inside, Vec2, fx};
    /// let at = |x, y| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + 8, y + 8));
    /// let mut scene = SortSweepScene::<8>::empty();
    /// let door = scene.insert(&SceneBody::fixed(at(50, 0)?, 1))?;
    /// scene.insert(&SceneBody::new(at(20, 12)?, 2))?; // the blade only passes along it
    /// let blade = Capsule::new(Vec2::from_ints(0, 0), Vec2::from_ints(0, 10), fx!(2))?;
    /// let hit = scene.cast_shape(&blade, Vec2::from_ints(64, 0), Inside::Hit, |_, _| true)?.unwrap();
    /// assert_eq!((hit.body, hit.hit.displacement), (door, Vec2::from_ints(48, 0)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if a component of the motion is not below 2^28 raw (4096 units), or the
    /// motion leads out of the [domain](crate::num::DOMAIN).
    #[doc(alias("sweep", "shapecast"))]
    pub fn cast_shape<A: CastShape<S> + Extent>(
        &self,
        shape: &A,
        motion: Vec2,
        inside: Inside,
        wanted: impl FnMut(Handle, &SceneBody<S>) -> bool,
    ) -> Result<Option<SceneHit>, RangeError> {
        self.first_on_path(shape, motion, inside, None, wanted)
    }

    /// [`cast_shape`](Self::cast_shape), before a time if there is one.
    pub(super) fn first_on_path<A: CastShape<S> + Extent>(
        &self,
        shape: &A,
        motion: Vec2,
        inside: Inside,
        before: Option<Toi>,
        wanted: impl FnMut(Handle, &SceneBody<S>) -> bool,
    ) -> Result<Option<SceneHit>, RangeError> {
        check_motion(motion, MOTION)?;
        let cast = |body: &S| shape.cast_shape(body, motion, inside);
        let exact = |body: &S| shape.exact_toi(body, motion, inside).ok().flatten();
        self.first((&shape.extent(), motion), before, wanted, cast, exact)
    }

    /// The first hit on the path of a box. `exact` is the time of a hit that has only a bound.
    fn first(
        &self,
        (start, motion): (&Aabb, Vec2),
        before: Option<Toi>,
        mut wanted: impl FnMut(Handle, &SceneBody<S>) -> bool,
        cast: impl Fn(&S) -> Result<Option<CastHit>, RangeError>,
        exact: impl Fn(&S) -> Option<Toi>,
    ) -> Result<Option<SceneHit>, RangeError> {
        let (mut first, mut last) = (None, before.unwrap_or(Toi::ONE));
        // What is as late as the limit is before it only if there is none.
        let mut rank = before.is_none().then_some((u32::MAX, usize::MAX));
        self.near.along(start, motion, |handle, _, _| {
            let Ok(body) = self.body(handle) else { return last };
            if !wanted(handle, body) {
                return last;
            }
            // A bound is never late. In range for the broad phase is in range for a shape.
            let Some(hit) = cast(&body.shape).ok().flatten().filter(|hit| hit.toi <= last) else { return last };
            let toi = if hit.inside { hit.toi } else { exact(&body.shape).unwrap_or(hit.toi) };
            let this = (body.key, handle.slot());
            if toi < last || (toi == last && rank.is_some_and(|rank| this <= rank)) {
                (first, last, rank) = (Some(SceneHit { body: handle, hit: CastHit { toi, ..hit } }), toi, Some(this));
            }
            last
        })?;
        Ok(first)
    }

    /// Calls `each` with every body that a shape overlaps, once, in no particular order. For
    /// explosions, swings of a sword, and positions where something is to appear.
    ///
    /// Strict and exact, as [`Overlaps`]: bodies that only touch the shape do not count, see
    /// [`touching`](Self::touching). All bodies count, whatever their filters, also if they sleep.
    /// The shape is as in [`cast_shape`](Self::cast_shape). Collect the handles to change bodies,
    /// and sort by keys if the order matters.
    ///
    /// Cost: a region query, and a test of two shapes for each body found. It cannot fail.
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, SortSweepScene};
    /// use tilesat::{Aabb, Circle, Vec2, fx};
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
    /// let mut scene = SortSweepScene::<8>::empty();
    /// for (x, key) in [(0, 1), (12, 2), (24, 3)] {
    ///     scene.insert(&SceneBody::new(at(x)?, key))?;
    /// }
    /// let blast = Circle::new(Vec2::from_ints(4, 4), fx!(8))?;
    /// let (mut hurt, mut near) = (0, 0);
    /// scene.overlapping(&blast, |_, body| hurt |= 1 << body.key);
    /// scene.touching(&blast, |_, body| near |= 1 << body.key);
    /// assert_eq!((hurt, near), (1 << 1, 1 << 1 | 1 << 2)); // it reaches to x = 12
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias("overlapShape", "intersectShape"))]
    pub fn overlapping<A: Overlaps<S> + Extent>(&self, shape: &A, mut each: impl FnMut(Handle, &SceneBody<S>)) {
        self.at(&shape.extent(), |handle, body| {
            if shape.overlaps(&body.shape) {
                each(handle, body);
            }
        });
    }

    /// Calls `each` with every body that has a point in common with a shape, borders included,
    /// once, in no particular order. Exact.
    ///
    /// For the rest, and for an example, see [`overlapping`](Self::overlapping).
    pub fn touching<A: Touches<S> + Extent>(&self, shape: &A, mut each: impl FnMut(Handle, &SceneBody<S>)) {
        self.at(&shape.extent(), |handle, body| {
            if shape.touches(&body.shape) {
                each(handle, body);
            }
        });
    }

    /// Calls `each` with every body that contains a point, border included, once, in no particular
    /// order. For clicks and cursors. Exact.
    ///
    /// No body contains a point outside the [domain](crate::num::DOMAIN). Cost: as
    /// [`overlapping`](Self::overlapping).
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, SortSweepScene};
    /// use tilesat::{Circle, Vec2, fx};
    /// let mut scene = SortSweepScene::<8>::empty();
    /// let ball = scene.insert(&SceneBody::new(Circle::new(Vec2::ZERO, fx!(5))?, 1))?;
    /// let (mut at_rim, mut in_corner) = (None, None);
    /// scene.at_point(Vec2::from_ints(3, 4), |body, _| at_rim = Some(body));
    /// scene.at_point(Vec2::from_ints(4, 4), |body, _| in_corner = Some(body)); // of its box
    /// assert_eq!((at_rim, in_corner), (Some(ball), None));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias("queryPoint", "overlapPoint"))]
    pub fn at_point(&self, point: Vec2, mut each: impl FnMut(Handle, &SceneBody<S>)) {
        let point = Aabb::from_raw_unchecked(Raw::of(point), Raw::of(point));
        self.at(&point, |handle, body| {
            if body.shape.touches(&S::from(point)) {
                each(handle, body);
            }
        });
    }

    /// Every body whose box touches a region.
    fn at(&self, region: &Aabb, mut each: impl FnMut(Handle, &SceneBody<S>)) {
        self.near.in_region(region, |handle| {
            if let Ok(body) = self.body(handle) {
                each(handle, body);
            }
        });
    }
}
