//! The first thing on a path: the level, or a body of the scene.

use super::kernel::{BodyShape, Visit};
use super::query::SceneHit;
use super::{Scene, SceneBody};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::error::RangeError;
use crate::filter::Filter;
use crate::motion::{Body, Hit, cast_in, first_place};
use crate::num::{Axis, Raw, Toi, Vec2};
use crate::query::CastHit;
use crate::world::{RayHit, RayRules, RayWorld, World};

/// The level or a body, whichever a ray or a moving shape hits first.
///
/// `L` is the hit of the level: [`RayHit`] for rays, [`Hit`] for shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FirstHit<L> {
    /// The level.
    Level(L),
    /// A body.
    Body(SceneHit),
}

impl<L> FirstHit<L> {
    /// The body, if it is one.
    #[must_use]
    pub const fn body(&self) -> Option<Handle> {
        match self {
            Self::Level(_) => None,
            Self::Body(hit) => Some(hit.body),
        }
    }
}

/// `toi` and `axis` of what is first.
macro_rules! fields {
    ($hit:ty) => {
        impl FirstHit<$hit> {
            /// The part of the motion up to the hit, 0 to 1.
            #[must_use]
            pub const fn toi(&self) -> Toi {
                match self {
                    Self::Level(hit) => hit.toi,
                    Self::Body(hit) => hit.hit.toi,
                }
            }

            /// The normal of the surface that was hit, toward the start.
            #[must_use]
            pub const fn axis(&self) -> Axis {
                match self {
                    Self::Level(hit) => hit.axis,
                    Self::Body(hit) => hit.hit.axis,
                }
            }
        }
    };
}
fields!(Hit);
fields!(RayHit);

impl SceneCast {
    /// The body that it hits first, if it is one.
    #[must_use]
    pub const fn body(&self) -> Option<Handle> {
        self.first.body()
    }

    /// The part of the motion up to the hit, 0 to 1.
    #[must_use]
    pub const fn toi(&self) -> Toi {
        self.first.toi()
    }

    /// The normal of the surface that it hits first, toward the start.
    #[must_use]
    pub const fn axis(&self) -> Axis {
        self.first.axis()
    }
}

impl FirstHit<RayHit> {
    /// The point at which a ray from `origin` ends.
    #[must_use]
    pub fn point(&self, origin: Vec2) -> Vec2 {
        match self {
            Self::Level(hit) => hit.point,
            Self::Body(hit) => origin + hit.hit.displacement,
        }
    }
}

/// The first hit of a shape that moves through a level and among bodies, and how far it may move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SceneCast {
    /// What it hits first.
    pub first: FirstHit<Hit>,
    /// How far it may move. From a free start, the same cast by this displacement hits nothing: no
    /// level, and no wanted body. With [`Inside::Ignore`](crate::Inside::Ignore), the end may
    /// overlap what the shape overlapped at the start.
    pub displacement: Vec2,
    /// Whether it overlapped what it hits before the motion; only with
    /// [`Inside::Hit`](crate::Inside::Hit). If it also touches the level and moves into it, that
    /// hit at 0 is reported instead.
    pub inside: bool,
}

/// A cast through a level, with the displacement up to the hit, and whether it started inside.
struct Through<'w, W>(&'w W, Vec2, RayRules);

impl<S, W: World> Visit<S> for Through<'_, W> {
    type Out = Result<Option<(Hit, Vec2, bool)>, RangeError>;
    fn of<B: Body + Into<S>>(self, body: &B) -> Self::Out {
        let Self(level, motion, rules) = self;
        let found = cast_in(level, body, motion, rules)?;
        Ok(found.map(|found| (found.hit, found.body.position() - body.position(), found.inside)))
    }
}

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, const M: usize, S: BodyShape> Scene<B, N, M, S> {
    /// What a ray from `origin` along `motion` hits first: the level, or a body for which `wanted`
    /// is true. `None` if the ray ends before. For hitscan weapons, lasers and lines of sight.
    ///
    /// It is the earlier one of the level's [`cast_ray`](RayWorld::cast_ray) and of the scene's own
    /// [`cast_ray`](Self::cast_ray), which explain their rules. At the same time (in parts of 2^30)
    /// the level comes first. The [time](RayHit::toi) of a level's arc may be early by up to a raw
    /// unit. So an arc just behind a body can be reported in its place.
    ///
    /// Sensors count, too: leave them out by `!body.filter.sensor()`.
    ///
    /// Cost: that of both. The scene looks no farther than the hit of the level.
    ///
    /// ```
    /// use tilesat::scene::{FirstHit, SceneBody, SortSweepScene};
    /// use tilesat::{Circle, Inside, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("....#...\n", &KINDS)?; // a wall at x = 64
    /// let mut scene = SortSweepScene::<8>::empty();
    /// let ball = |x| Circle::new(Vec2::from_ints(x, 8), fx!(8));
    /// let bat = scene.insert(&SceneBody::new(ball(40)?, 1))?;
    /// scene.insert(&SceneBody::new(ball(100)?, 2))?; // behind the wall
    ///
    /// let (from, motion) = (Vec2::from_ints(4, 8), Vec2::from_ints(112, 0));
    /// let shot = scene.cast_ray_in(&level, from, motion, Inside::Hit, |_, _| true)?.unwrap();
    /// assert!(shot.body() == Some(bat) && shot.point(from).x.round() == 32);
    /// scene.remove(bat)?;
    /// let shot = scene.cast_ray_in(&level, from, motion, Inside::Hit, |_, _| true)?.unwrap();
    /// assert!(matches!(shot, FirstHit::Level(wall) if wall.point == Vec2::from_ints(64, 8)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN), here or
    /// relative to a [`Placed`](crate::world::Placed) level.
    #[doc(alias("raycast", "hitscan", "linecast", "intersect_ray"))]
    pub fn cast_ray_in<W: RayWorld>(
        &self,
        level: &W,
        origin: Vec2,
        motion: Vec2,
        rules: impl Into<RayRules>,
        wanted: impl FnMut(Handle, &SceneBody<S>) -> bool,
    ) -> Result<Option<FirstHit<RayHit>>, RangeError> {
        let rules = rules.into();
        let wall = level.cast_ray(origin, motion, rules)?;
        let body = self.first_on_ray(origin, motion, rules.inside, wall.map(|wall| wall.toi), wanted)?;
        Ok(body.map(FirstHit::Body).or(wall.map(FirstHit::Level)))
    }

    /// Finds the first surface or body that a shape hits as it moves by `motion`, and how far it
    /// may move. The level stops it, and so does each body for which `wanted` is true. `None` if it
    /// may move by all of `motion`.
    ///
    /// For a dash or a thrown body: add [`displacement`](SceneCast::displacement). Nothing slides,
    /// and a motion along a slanted wall that the shape touches may hit it at 0 by rounding. The
    /// shape is one that a body of the scene can have. Its own body and sensors count, so leave
    /// them out. `wanted` must give the same answer for a body each time.
    ///
    /// After a step two bodies may overlap a little. With [`Inside::Hit`](crate::Inside::Hit) the
    /// shape then cannot move at all. With [`Inside::Ignore`](crate::Inside::Ignore) it leaves
    /// them, and may end in one of them; the next step parts them.
    ///
    /// The first hit is the earlier one of the level's
    /// [`cast_shape`](crate::TileMap::cast_shape) and of the scene's own
    /// [`cast_shape`](Self::cast_shape), which explain their rules. At the same time (in parts of
    /// 2^30) the level comes first. At corners and arcs of a level, the time of a round shape is
    /// early by up to a raw unit of travel.
    ///
    /// Do not take the displacement from one of those two casts instead. It is rounded for what
    /// that cast has hit. Where level and body are hit at nearly the same time, it may end inside
    /// the other one, by a raw unit. This call casts again by the rounded displacement, and by
    /// others near it, until one hits nothing. It mostly ends within 3 raw units of the hit. In a
    /// gap that is only a few raw units wider than the shape, the search goes back toward the start
    /// in steps that double. It may give zero there, though there is room.
    ///
    /// Cost: both casts; mostly twice if something is hit, and at most some 190 times in a gap.
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, Shape, SortSweepScene};
    /// use tilesat::{Aabb, Circle, Inside, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii(".....#..\n", &KINDS)?; // a wall at x = 80
    /// let mut scene = SortSweepScene::<8>::empty();
    /// let hero = Shape::from(Circle::new(Vec2::from_ints(8, 8), fx!(6))?);
    /// let body = scene.insert(&SceneBody::of(hero, 1))?;
    /// let crate_ = Aabb::new(Vec2::from_ints(50, 4), Vec2::from_ints(58, 12))?;
    /// let crate_ = scene.insert(&SceneBody::new(crate_, 2))?;
    ///
    /// let dash = |scene: &SortSweepScene<8>| {
    ///     scene.cast_shape_in(&level, hero, Vec2::from_ints(90, 0), Inside::Hit, |other, _| other != body)
    /// };
    /// let found = dash(&scene)?.unwrap();
    /// assert_eq!((found.body(), found.displacement), (Some(crate_), Vec2::from_ints(36, 0)));
    /// scene.remove(crate_)?;
    /// let found = dash(&scene)?.unwrap();
    /// assert_eq!((found.body(), found.displacement), (None, Vec2::from_ints(66, 0)));
    /// scene.place(body, hero.translated(found.displacement)?)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of the level's [`cast_shape`](crate::TileMap::cast_shape).
    #[doc(alias("sweep", "shapecast", "cast_motion", "test_move"))]
    pub fn cast_shape_in<W: World>(
        &self,
        level: &W,
        shape: impl Into<S>,
        motion: Vec2,
        rules: impl Into<RayRules>,
        mut wanted: impl FnMut(Handle, &SceneBody<S>) -> bool,
    ) -> Result<Option<SceneCast>, RangeError> {
        let (shape, rules) = (shape.into(), rules.into());
        let Some(found) = self.first_of_both(level, &shape, motion, rules, &mut wanted)? else { return Ok(None) };
        let is_free = |by: Raw| matches!(self.first_of_both(level, &shape, by.vec2(), rules, &mut wanted), Ok(None));
        let by = first_place(Raw::of(found.displacement), Raw::of(motion), 0, is_free);
        Ok(Some(SceneCast { displacement: by.vec2(), ..found }))
    }

    /// What is first, and the displacement up to that alone.
    fn first_of_both<W: World>(
        &self,
        level: &W,
        shape: &S,
        motion: Vec2,
        rules: RayRules,
        wanted: impl FnMut(Handle, &SceneBody<S>) -> bool,
    ) -> Result<Option<SceneCast>, RangeError> {
        let wall = shape.visit(Through(level, motion, rules))?;
        let until = wall.map(|(hit, ..)| hit.toi);
        if let Some(hit) = self.first_on_path(shape, motion, rules.inside, until, wanted)? {
            let CastHit { displacement, inside, .. } = hit.hit;
            return Ok(Some(SceneCast { first: FirstHit::Body(hit), displacement, inside }));
        }
        Ok(wall.map(|(hit, displacement, inside)| SceneCast { first: FirstHit::Level(hit), displacement, inside }))
    }
}
