//! Two levels used as one: their surfaces, and rays against both.

pub(in crate::world) mod hidden;
pub(in crate::world) mod ray;
mod start;

use super::level::{Feature, MotionPiece, Seen, World, levels, meets_as_world, sealed};
use super::probes::Probe;
use crate::shape::{Aabb, Circle};
use crate::world::convex::ConvexBody;
use hidden::shown;

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
        /// The flags, or-ed, of all that a box, circle or point touches in either level, hidden
        /// parts included. Exact. Cost: both levels' cost.
        ///
        /// ```
        /// use tilesat::{Aabb, Joined, Solid, Solids, TileKind, TileKinds, TileMap, Vec2};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'^', TileKind::FULL.with_flags(1));
        /// let level = TileMap::from_ascii("   \n ^ ", &KINDS)?;
        /// let saw = [Solid::new(Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(8, 16))?, 1)?.with_flags(2)];
        /// let saw = Solids::new(&saw);
        /// let level = Joined::new(&level, &saw);
        /// let hero = Aabb::new(Vec2::from_ints(8, 8), Vec2::from_ints(20, 16))?; // it touches both
        /// assert_eq!(level.flags_touched(&hero), 1 | 2);
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        flags_touched,
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

    fn flags_touched<P: Probe>(&self, shape: &P) -> u8 {
        self.a.flags_touched(shape) | self.b.flags_touched(shape)
    }
}

meets_as_world! { [A: World, B: World] Joined<'_, A, B> }
