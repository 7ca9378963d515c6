//! A level at another position: its surface, and rays against it.

use super::level::{Feature, MotionPiece, Seen, World, levels, meets_as_world, sealed};
use super::probes::Probe;
use super::ray::scan::ScanHit;
use super::ray::world::{RayScan, RayWorld, rays};
use super::ray::{RayHit, RayRules, checked};
use crate::error::RangeError;
use crate::num::{DOMAIN, MOTION, Raw, Vec2, check_motion};
use crate::shape::{Aabb, Circle, Convex};
use crate::world::convex::ConvexBody;

/// A level shifted by an offset: a polygon that moves, or a room that slides in.
///
/// It is a level, too, and copies nothing.
///
/// ```text
///    the level's own origin      here
///      +------> x                :  offset
///      |  /\                     :......./\
///      v /__\                           /__\
/// ```
///
/// Give it another offset in each frame and [join](crate::Joined) it with the rest. It blocks
/// bodies and stops rays, but does not carry or push; for that, use [`Solid`](crate::Solid)s and
/// [`ConvexSolid`](crate::world::ConvexSolid)s. A body that overlaps it at the new position is
/// stuck until the game has moved it out.
///
/// Results are those of a level built there, bit for bit, because all kernels work on differences.
/// A tile map that continues beyond its cells ([`Outside`](crate::Outside)) has a surface up to the
/// end of its domain. Solid beyond that still stops a body, but the body does not slide along it.
///
/// Cost: that of the level, and a few additions for each call and each feature.
///
/// ```
/// use tilesat::{Aabb, Path, PathKind, Vec2, fx, segment_map, world::Placed};
/// const WEDGE: [Vec2; 3] = [Vec2::from_ints(0, 32), Vec2::from_ints(64, 0), Vec2::from_ints(64, 32)];
/// segment_map!(static WEDGES: [Path::new(PathKind::Solid, &WEDGE)], fx!(32));
///
/// let body = Aabb::new(Vec2::from_ints(30, 0), Vec2::from_ints(40, 10))?;
/// for frame in 0..4 {
///     let wedge = Placed::new(&WEDGES, Vec2::from_ints(0, -frame))?; // rises by 1 in each frame
///     assert_eq!(wedge.overlaps(&body), frame == 3); // at first it is at y = 12 below the right side of the box, whose bottom is at 10
/// }
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Debug)]
#[doc(alias("offset", "transform"))]
pub struct Placed<'a, W> {
    world: &'a W,
    offset: Raw,
}

impl<W> Clone for Placed<'_, W> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<W> Copy for Placed<'_, W> {}

impl<'a, W: World> Placed<'a, W> {
    /// The level, shifted: a point `p` of it is at `p + offset` here.
    ///
    /// # Errors
    /// [`RangeError`] if a component of the offset is not below [`MOTION`] (4096 units):
    /// coordinates relative to the level stay below 2^29 + 2^28. Their differences stay below 2^31,
    /// with products below 2^62, which all kernels accept.
    pub const fn new(world: &'a W, offset: Vec2) -> Result<Self, RangeError> {
        match check_motion(offset, MOTION) {
            Ok(()) => Ok(Self { world, offset: Raw::of(offset) }),
            Err(e) => Err(e),
        }
    }

    /// The level.
    #[must_use]
    pub const fn world(&self) -> &'a W {
        self.world
    }

    /// How far it is shifted.
    #[must_use]
    pub const fn offset(&self) -> Vec2 {
        self.offset.vec2()
    }

    /// The level's features near a region, at their shifted positions.
    pub fn features(&self, region: &Aabb) -> PlacedFeatures<'_, W> {
        PlacedFeatures { features: self.world.features(&self.seen(region)), offset: self.offset }
    }

    /// A shape relative to the level.
    fn seen<P: Probe>(&self, shape: &P) -> P {
        shape.less(self.offset)
    }
}

levels! {
    [W: World] Placed<'_, W> {
        /// Whether a shape overlaps the solid; strict and exact.
        overlaps,
        /// Whether a shape has a point in common with the solid, borders included; exact.
        touches,
        /// The flags, or-ed, of all that a box, circle or point touches: those of the level, for
        /// the shape less the offset.
        ///
        /// It is exact. Cost: that of the level.
        ///
        /// ```
        /// use tilesat::{TileKind, TileKinds, TileMap, Vec2, world::Placed};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'~', TileKind::EMPTY.with_flags(8));
        /// let pool = TileMap::from_ascii("~", &KINDS)?;
        /// let moved = Placed::new(&pool, Vec2::from_ints(100, 0))?;
        /// assert_eq!((moved.flags_touched(&Vec2::from_ints(116, 4)), moved.flags_touched(&Vec2::ZERO)), (8, 0));
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        flags_touched,
    }
}

/// The cursor of [`Placed::features`].
#[derive(Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct PlacedFeatures<'w, W: World + 'w> {
    pub(crate) features: W::Features<'w>,
    pub(crate) offset: Raw,
}

impl<W: World> Iterator for PlacedFeatures<'_, W> {
    type Item = Feature;

    fn next(&mut self) -> Option<Feature> {
        let mut feature = self.features.next()?;
        feature.shift(self.offset);
        Some(feature)
    }
}

impl<W: World> sealed::Sealed for Placed<'_, W> {}

impl<W: World> World for Placed<'_, W> {
    const BLOCKS: bool = W::BLOCKS;
    const ROUND: bool = W::ROUND;
    const WIDE: bool = W::WIDE;
    // Beyond its own domain a level has no surface, but a map can be solid there.
    const CERTAIN: bool = false;

    #[doc(hidden)]
    const ARCS: bool = W::ARCS;

    type Features<'w>
        = PlacedFeatures<'w, W>
    where
        Self: 'w;

    fn features(&self, region: &Aabb) -> PlacedFeatures<'_, W> {
        Placed::features(self, region)
    }

    fn features_ahead(&self, way: &MotionPiece) -> PlacedFeatures<'_, W> {
        let (piece, before) = (self.seen(way.piece), way.before.map(|before| self.seen(before)));
        let way = MotionPiece { piece: &piece, whole: self.seen(&way.whole), before: before.as_ref(), ..*way };
        PlacedFeatures { features: self.world.features_ahead(&way), offset: self.offset }
    }

    fn look(&self, region: &Aabb, r: i32, seen: &mut Seen) -> bool {
        let there = self.seen(region);
        if !is_inside(there.lo()) || !is_inside(there.hi()) {
            *seen = Seen { held: Some(*region), cells: None };
            return false;
        }
        self.world.look(&there, r, seen);
        if let Some(held) = &mut seen.held {
            *held = held.shifted(self.offset);
        }
        // The other level's answer is about its own place.
        false
    }

    fn cell_size(&self) -> u32 {
        self.world.cell_size()
    }

    fn most_cells(&self, width: u32, height: u32) -> u32 {
        self.world.most_cells(width, height)
    }

    fn overlaps_aabb(&self, b: &Aabb) -> bool {
        self.world.overlaps_aabb(&self.seen(b))
    }

    fn meets_convex(&self, body: &ConvexBody<'_>, closed: bool) -> bool {
        self.world.meets_convex(&body.seen_from(self.offset), closed)
    }

    fn overlaps_circle(&self, c: &Circle) -> bool {
        self.world.overlaps_circle(&self.seen(c))
    }

    fn touches_aabb(&self, b: &Aabb) -> bool {
        self.world.touches_aabb(&self.seen(b))
    }

    fn touches_circle(&self, c: &Circle) -> bool {
        self.world.touches_circle(&self.seen(c))
    }

    fn flags_touched<P: Probe>(&self, shape: &P) -> u8 {
        self.world.flags_touched(&self.seen(shape))
    }
}

const fn is_inside(p: Raw) -> bool {
    p.x > -DOMAIN && p.x < DOMAIN && p.y > -DOMAIN && p.y < DOMAIN
}

meets_as_world! { [W: World] Placed<'_, W> }

rays! {
    [W: RayWorld] Placed<'_, W> {
        /// The first point of the level that a ray from `origin` along `motion` meets, or `None` if
        /// it ends before.
        ///
        /// It is the result of the level's own `cast_ray`, shifted, bit for bit.
        ///
        /// ```
        /// use tilesat::{Axis, Inside, TileKind, TileKinds, TileMap, Vec2, world::Placed};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
        /// let room = TileMap::from_ascii("#.#", &KINDS)?;
        /// let slides_in = Placed::new(&room, Vec2::from_ints(100, 7))?;
        /// let hit = slides_in.cast_ray(Vec2::from_ints(120, 10), Vec2::from_ints(90, 0), Inside::Hit)?.unwrap();
        /// assert_eq!((hit.point, hit.axis, hit.cell.x), (Vec2::from_ints(132, 10), Axis::NEG_X, 2));
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        ///
        /// # Errors
        /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN), here
        /// or relative to the level (less the offset).
        cast_ray,
        /// Whether the straight line from `a` to `b` is free of the level and does not start
        /// inside.
        ///
        /// A line that ends on a surface is blocked; one that starts there is not.
        ///
        /// # Errors
        /// As [`cast_ray`](Self::cast_ray).
        line_of_sight,
        /// All hits of a ray in order, as if it continued through what it hits.
        ///
        /// Hits at the same moment count as one.
        ///
        /// # Errors
        /// As [`cast_ray`](Self::cast_ray).
        cast_ray_all -> PlacedRayHits<'_, W>,
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
    fn next_found(&mut self) -> Option<ScanHit> {
        let mut found = self.scan.next_found()?;
        found.hit.point = Raw::of(found.hit.point).add(self.offset).vec2();
        if let Some(met) = &mut found.met {
            met.feature.shift(self.offset);
        }
        Some(found)
    }

    fn goes_in(&self) -> bool {
        self.scan.goes_in()
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

    fn check_ray(&self, origin: Vec2, motion: Vec2) -> Result<(Raw, Raw), RangeError> {
        let (o, d) = checked(origin, motion)?;
        self.world().check_ray(o.sub(self.offset).vec2(), motion)?;
        Ok((o, d))
    }

    fn scan(&self, o: Raw, d: Raw, rules: RayRules) -> Self::Scan<'_> {
        PlacedRayHits { scan: self.world().scan(o.sub(self.offset), d, rules), offset: self.offset }
    }

    fn cast_ray(&self, origin: Vec2, motion: Vec2, rules: impl Into<RayRules>) -> Result<Option<RayHit>, RangeError> {
        let (o, _) = checked(origin, motion)?;
        let hit = self.world().cast_ray(o.sub(self.offset).vec2(), motion, rules)?;
        Ok(hit.map(|hit| RayHit { point: Raw::of(hit.point).add(self.offset).vec2(), ..hit }))
    }
}
