//! Two levels used as one.

use super::hidden::shown;
use crate::shape::{Aabb, Circle};
use crate::world::shells::{levels, meets_as_world};
use crate::world::{Feature, Way, World, sealed};

/// Two levels used as one: tiles and segments, or a level and its neighbour. Copies nothing.
///
/// What is solid in either is solid. Where the two meet there is no seam: a corner that lies in the other level's solid is no corner, save
/// where both together have one, and a face whose front the other solid covers from end to end is not there. So a floor of tiles that goes
/// on as a floor of segments is one floor, for a mover too. A face that is covered in part stays as it is, and so do arcs.
///
/// A pair is a level itself: more than two are pairs of pairs. Of a [`Feature::source`] the lowest bit says which of the pair it is from, 0 for
/// the first; the other bits are what the source was in that level.
///
/// The levels are asked one after the other, so a body without area overlaps a pair where it overlaps one of the two; on the line
/// between two solids that meet flush it overlaps neither.
///
/// Cost: both levels' cost, and for each feature a look-up or two of a point in the other level; where that is solid, the other level's
/// features along the face.
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
/// assert_eq!(moved.position(), Vec2::from_ints(70, 22)); // over the joint as if there were none
/// # Ok::<(), tilesat::TileMapError>(())
/// ```
#[derive(Debug)]
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
    /// Both levels as one.
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

    /// The pieces of both surfaces that have a point in the closed region and are not hidden by the other level: first the one's, then the
    /// other's.
    ///
    /// A corner's directions are those of both solids together. Pieces near the region may come too. Cost: see [`Joined`].
    pub fn features(&self, region: &Aabb) -> JoinedFeatures<'_, A, B> {
        JoinedFeatures { pair: *self, a: self.a.features(region), b: self.b.features(region) }
    }
}

levels! {
    [A: World, B: World] Joined<'_, A, B> {
        /// Whether a box or circle overlaps the solid of either level; strict and exact.
        ///
        /// Cost: both levels' cost. It cannot fail.
        overlaps,
        /// Whether a box or circle has a point in common with the solid of either level, borders included; exact.
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
            if let Some(shown) = shown(f, self.pair.b, true) {
                return Some(Feature { source: shown.source << 1, ..shown });
            }
        }
        for f in self.b.by_ref() {
            if let Some(shown) = shown(f, self.pair.a, false) {
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

    type Features<'w>
        = JoinedFeatures<'w, A, B>
    where
        Self: 'w;

    fn features(&self, region: &Aabb) -> JoinedFeatures<'_, A, B> {
        Joined::features(self, region)
    }

    fn features_ahead(&self, way: &Way) -> JoinedFeatures<'_, A, B> {
        JoinedFeatures { pair: *self, a: self.a.features_ahead(way), b: self.b.features_ahead(way) }
    }

    fn occupied(&self, region: &Aabb) -> Option<Aabb> {
        match (self.a.occupied(region), self.b.occupied(region)) {
            (Some(a), Some(b)) => Some(a.union(&b)),
            (a, b) => a.or(b),
        }
    }

    /// The shorter of both: a piece of a motion then reaches few cells of either level.
    fn cell_size(&self) -> u32 {
        self.a.cell_size().min(self.b.cell_size())
    }

    fn overlaps_aabb(&self, b: &Aabb) -> bool {
        self.a.overlaps_aabb(b) || self.b.overlaps_aabb(b)
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
