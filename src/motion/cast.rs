//! Bodies cast through a level: the first hit of a motion, without a response.

use super::body::{Body, is_by_lines};
use super::order::First;
use super::run::{Run, check_inside};
use super::search::{Around, Search, box_here};
use super::{Hit, Moved, Work};
use crate::error::RangeError;
use crate::num::{MOTION, Raw, Toi, Vec2, check_motion, mul_div};
use crate::query::CastHit;
use crate::world::{
    Cell, ConvexSolids, Inside, Joined, Placed, RayRules, SegmentMap, ShapeSet, SolidShape, Solids, Store, TileMap,
    World,
};

/// The hit of a body that was cast through a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BodyHit<B> {
    /// The hit, its time and its normal. If the body starts inside, the time is 0, the axis is that
    /// of [`CastHit::inside`], and the other fields have no meaning.
    pub hit: Hit,
    /// The body at the hit. It overlaps the level only if it did before.
    pub body: B,
    /// Whether the body overlapped the level before the motion; only with [`Inside::Hit`].
    pub inside: bool,
    /// The work of the cast.
    pub work: Work,
}

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// The first hit of a body that moves by `motion`, or `None` if nothing is hit.
    ///
    /// Exact. A hit is where the motion would start to overlap the solid. A body that touches and
    /// moves in hits at 0. A body that slides along, moves away, grazes, or ends touching does not
    /// hit. A body without size is a point that walls and the inside of the solid stop; the border
    /// of the solid stops a [ray](Self::cast_ray), too.
    ///
    /// The result equals the first hit of [`Mover::move_and_slide`](crate::Mover::move_and_slide)
    /// only if you include one-way faces: `RayRules { one_way: true, ..Inside::Hit.into() }`.
    /// `Inside` alone passes them, like a mover that drops through.
    ///
    /// - [`RayRules::one_way`]: whether one-way faces stop a body that is entirely in front of them
    ///   and moves in, as they stop movers.
    /// - [`RayRules::inside`]: the answer if the body already overlaps the level. [`Inside::Hit`]
    ///   hits at 0. [`Inside::Ignore`] passes the parts of the surface that it overlaps and hits
    ///   others. The body at the hit may then still overlap the former.
    ///
    /// The body at the hit is on the faces along x and y that it hits. At slopes, corners and arcs
    /// it is at most 2 raw early. It is verified not to overlap the level. If it is wedged and no
    /// lattice point near the hit is free, it is at the start.
    ///
    /// ```text
    ///   +---+---+---+---+
    ///   | o |   |   |###|     o   a ball
    ///   +---+---+--o+###+     the second one: where it is at the hit,
    ///   |   |   |   |###|     axis (-1, 0)
    ///   +---+---+---+---+
    /// ```
    ///
    /// Cost: a look at the cells under the motion if they are empty. Otherwise one sweep over them,
    /// in pieces as long as a cell or the body, and one or two exact overlap tests. So it is linear
    /// in the length of the motion. [`BodyHit::work`] counts them.
    ///
    /// ```
    /// use tilesat::{Axis, Circle, Fx, Inside, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("...#\n...#", &KINDS)?; // the wall is at x = 48
    /// let ball = Circle::new(Vec2::from_ints(8, 8), Fx::from_num(4))?;
    /// let found = level.cast_shape(&ball, Vec2::from_ints(72, 18), Inside::Hit)?.unwrap();
    /// assert_eq!((found.hit.toi.to_fx(), found.hit.axis), (fx!(0.5), Axis::NEG_X));
    /// assert_eq!(found.body.centre(), Vec2::from_ints(44, 17));
    /// assert_eq!(level.cast_shape(&ball, Vec2::from_ints(36, 0), Inside::Hit)?, None); // it ends at the wall
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if a component of the motion or a half extent is not below 2^28 raw (4096
    /// units). Also if the motion would leave the [domain](crate::num::DOMAIN), or visits more than
    /// [`Mover::CELLS`](crate::Mover::CELLS) cells.
    #[doc(alias("sweep", "shapecast", "swept AABB"))]
    pub fn cast_shape<B: Body>(
        &self,
        body: &B,
        motion: Vec2,
        rules: impl Into<RayRules>,
    ) -> Result<Option<BodyHit<B>>, RangeError> {
        cast_in(self, body, motion, rules.into())
    }
}

/// Generates `cast_shape` for another kind of level.
macro_rules! casts {
    ($(#[$doc:meta])* [$($parameters:tt)*] $world:ty $({ $(#[$example:meta])* })?) => {
        impl<$($parameters)*> $world {
            $(#[$doc])*
            /// Follows the rules of [`TileMap::cast_shape`].
            ///
            $($(#[$example])*)?
            /// # Errors
            /// Those of [`TileMap::cast_shape`].
            pub fn cast_shape<B: Body>(
                &self,
                body: &B,
                motion: Vec2,
                rules: impl Into<RayRules>,
            ) -> Result<Option<BodyHit<B>>, RangeError> {
                cast_in(self, body, motion, rules.into())
            }
        }
    };
}

casts! {
    /// The first hit of a body that moves by `motion`, walls included.
    [] SegmentMap<'_> {
        /// ```
        /// use tilesat::{Circle, Inside, Path, PathKind, Vec2, fx, segment_map};
        /// const ROOF: [Vec2; 2] = [Vec2::from_ints(0, 64), Vec2::from_ints(64, 0)];
        /// segment_map!(static LEVEL: [Path::new(PathKind::Wall, &ROOF)], fx!(32));
        /// let shell = Circle::new(Vec2::from_ints(0, 14), fx!(5))?;
        /// let hit = LEVEL.cast_shape(&shell, Vec2::from_ints(100, 0), Inside::Hit)?.unwrap();
        /// assert!(hit.body.centre().x < fx!(43) && fx!(42.8) < hit.body.centre().x); // 50 less 5 sqrt(2)
        /// # Ok::<(), tilesat::RangeError>(())
        /// ```
        ///
    }
}
casts! {
    /// The first hit of a body that moves by `motion`, in either level, on the
    /// surface that [`features`](Self::features) returns.
    [A: World, C: World] Joined<'_, A, C> {
        /// ```
        /// use tilesat::{Aabb, Inside, Joined, Solid, Solids, TileKind, TileKinds, TileMap, Vec2};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
        /// let level = TileMap::from_ascii("....#", &KINDS)?; // a wall at x = 64
        /// let barrel = [Solid::new(Aabb::from_size(Vec2::from_ints(40, 4), Vec2::from_ints(8, 12))?, 9)?];
        /// let hero = Aabb::from_size(Vec2::from_ints(4, 2), Vec2::from_ints(10, 14))?;
        /// let dash = Joined::new(&level, &Solids::new(&barrel)).cast_shape(&hero, Vec2::from_ints(60, 0), Inside::Hit)?;
        /// let dash = dash.unwrap();
        /// assert_eq!((dash.body.max().x.to_num::<i32>(), dash.hit.solid()), (40, Some(9))); // not the wall
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        ///
    }
}
casts! {
    /// The first hit of a body that moves by `motion`, with the level at its
    /// current position.
    [W: World] Placed<'_, W>
}
casts! {
    /// The first hit of a body that moves by `motion`, with the solids at their
    /// current positions.
    [] Solids<'_>
}
casts! {
    /// The first hit of a body that moves by `motion`, with the solids at their
    /// current positions.
    [C: SolidShape] ConvexSolids<'_, C>
}

pub(crate) fn cast_in<W: World, B: Body>(
    world: &W,
    body: &B,
    motion: Vec2,
    rules: RayRules,
) -> Result<Option<BodyHit<B>>, RangeError> {
    check_motion(motion, MOTION)?;
    body.check_size()?;
    let d = Raw::of(motion);
    check_inside(&body.bounds(), d)?;
    let mut around = Around::nothing();
    // A walk through a grid visits all that the body may overlap.
    let pieces = around.begin(world, body, d, !W::GRID)?;
    if pieces == 0 {
        return Ok(None);
    }
    let mut work = Work { iterations: 0, features: 0, checks: 0 };
    let starts_inside = |work: &mut Work| {
        work.checks += 1;
        body.overlaps_world(world)
    };
    let mut inside = (!W::GRID || d.is_zero()) && starts_inside(&mut work);
    if inside && matches!(rules.inside, Inside::Hit) {
        return Ok(Some(at_start(body, motion, work)));
    }
    if d.is_zero() {
        return Ok(None);
    }
    let mut first = First::none();
    let mut search = Search::new(body, &mut around);
    search.pass_one_way = !rules.one_way;
    let beside = if is_by_lines::<W, B>() || (W::GRID && pieces > 1) {
        // A hit at the start ends the walk before it has visited all cells.
        search.find_on_way(world, d, &mut first) || first.is_within(0, 1)
    } else {
        search.find_first_in(world, pieces, d, &mut first);
        W::GRID && !search.around.is_free_in_sight(&box_here(body))
    };
    let guarded = search.guarded;
    (work.iterations, work.features) = (1, search.features);
    if beside {
        inside = starts_inside(&mut work);
        if inside && matches!(rules.inside, Inside::Hit) {
            return Ok(Some(at_start(body, motion, work)));
        }
    }
    let Some((entry, feature)) = first.hit::<B, W>(body, d) else { return Ok(None) };
    let mut moved = Moved { work, ..Moved::freely(*body, motion, 0) };
    let mut run = Run::new(&mut moved, &mut around);
    (run.pass_one_way, run.guarded) = (!rules.one_way, guarded);
    if inside {
        run.moved.body = body.shifted(entry.displacement(d));
    } else {
        run.advance(world, d, entry);
    }
    let toi = Toi::clamped(mul_div(Toi::ONE.raw(), entry.num, entry.den));
    let hit = Hit::of(entry.normal, feature, toi);
    Ok(Some(BodyHit { hit, body: moved.body, inside: false, work: moved.work }))
}

fn at_start<B: Body>(body: &B, motion: Vec2, work: Work) -> BodyHit<B> {
    let CastHit { toi, axis, .. } = CastHit::at_start(motion);
    let hit = Hit { toi, axis, cell: Cell::default(), index: 0, flags: 0, one_way: false, source: 0 };
    BodyHit { hit, body: *body, inside: true, work }
}
