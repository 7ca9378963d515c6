//! A list of moving boxes as a level.

use super::features::SolidFeatures;
use super::solid::Solid;
use crate::num::Raw;
use crate::query::meet;
use crate::shape::{Aabb, Circle};
use crate::world::shells::{levels, meets_as_world};
use crate::world::{Cell, Way, World, sealed};

/// Moving boxes as a level, at the places where they are now. Borrows the list, needs no memory.
///
/// [`Joined::new(&level, &solids)`](crate::Joined) is the level with its platforms and doors in it. A platform that lies flush with a floor,
/// or with another platform, is one floor with it: no seam trips a walker.
///
/// ```text
///   ####      +------+        level and solids, joined:  ____  ______
///   ####______|      |  --->  the walker's floor         ####__|    |
///   ####|  a  |  b   |                                   ####         (no face between a and b, no corner at their joint)
/// ```
///
/// The order of the list changes no result; of solids that say the same, the ids of a hit may be either one's. [One-way](Solid::with_one_way)
/// solids are one face each, which blocks what comes from entirely in front, and no part of `overlaps` and `touches`. A feature's
/// [`cell`](crate::Feature::cell) holds the key: see [`Solids::key_of`].
///
/// The boxes are asked one by one, so a point (a body without area) on the line between two flush solids overlaps neither.
///
/// Cost: an overlap test looks at each of the n boxes. So does each piece of a surface near the region, of which a box has 8; a face that is
/// covered by k others together takes k looks. Lists are meant to be short, the platforms of a screen. It cannot fail.
///
/// ```
/// use tilesat::{Aabb, Axis, Joined, Mover, Solid, Solids, TileKind, TileKinds, TileMap, Vec2};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let level = TileMap::from_ascii("     \n##  #", &KINDS)?; // a pit from x = 32 to x = 64
/// let bridge = [Solid::new(Aabb::new(Vec2::from_ints(32, 16), Vec2::from_ints(64, 24))?, 3)?];
/// let solids = Solids::new(&bridge);
///
/// let walker = Aabb::new(Vec2::from_ints(2, 6), Vec2::from_ints(10, 16))?;
/// let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&Joined::new(&level, &solids), &walker, Vec2::from_ints(60, 1))?;
/// assert_eq!(moved.position(), Vec2::from_ints(62, 6)); // over both joints
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Solids<'a> {
    list: &'a [Solid],
}

impl<'a> Solids<'a> {
    /// All boxes of a list.
    #[must_use]
    pub const fn new(list: &'a [Solid]) -> Self {
        Self { list }
    }

    /// The list.
    #[must_use]
    pub const fn list(&self) -> &'a [Solid] {
        self.list
    }

    /// The key of the solid that a feature, a contact, a floor or a hit names by its cell; `None` where it is a tile's or a segment's.
    ///
    /// So it can be asked of whatever a [joined](crate::Joined) level reports. The keys of two lists that are joined are told apart by the
    /// [`source`](crate::Feature::source).
    ///
    /// ```
    /// use tilesat::{Aabb, Cell, Fx, Inside, Joined, Solid, Solids, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("   \n###", &KINDS)?;
    /// let lift = [Solid::new(Aabb::new(Vec2::from_ints(16, 8), Vec2::from_ints(32, 12))?, 7)?];
    /// let solids = Solids::new(&lift);
    /// let level = Joined::new(&level, &solids);
    /// let below = |x| level.cast_ray(Vec2::from_ints(x, 0), Vec2::from_ints(0, 20), Inside::Hit);
    /// assert_eq!(below(20)?.map(|hit| Solids::key_of(hit.cell)), Some(Some(7)));
    /// assert_eq!(below(8)?.map(|hit| Solids::key_of(hit.cell)), Some(None)); // the floor
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub const fn key_of(cell: Cell) -> Option<u16> {
        if cell.y == Solid::ROW { Some(cell.x as u16) } else { None }
    }

    /// The faces and corners of the solids' union that have a point in the closed region, and one-way faces.
    ///
    /// A face that others cover in part stays as it is. Cost: see [`Solids`].
    pub const fn features(&self, region: &Aabb) -> SolidFeatures<'a> {
        SolidFeatures::new(*self, region)
    }

    fn any(&self, meets: impl Fn(&Solid) -> bool) -> bool {
        self.list.iter().any(|solid| solid.one_way().is_none() && meets(solid))
    }
}

levels! {
    [] Solids<'_> {
        /// Whether a box or circle overlaps one of the solids; strict and exact. One-way ones are never overlapped.
        overlaps,
        /// Whether a box or circle has a point in common with one of the solids, borders included; exact. Not with one-way ones.
        touches,
    }
}

impl sealed::Sealed for Solids<'_> {}

impl World for Solids<'_> {
    const BLOCKS: bool = true;
    const ROUND: bool = false;

    type Features<'w>
        = SolidFeatures<'w>
    where
        Self: 'w;

    fn features(&self, region: &Aabb) -> SolidFeatures<'_> {
        Solids::features(self, region)
    }

    fn features_ahead(&self, way: &Way) -> SolidFeatures<'_> {
        Solids::features(self, way.piece).against(way.d)
    }

    fn occupied(&self, region: &Aabb) -> Option<Aabb> {
        let meets = |s: &&Solid| meet::aabb_aabb::<true>(s.lo(), s.hi(), region.lo(), region.hi());
        let all = self.list.iter().filter(meets).map(Solid::shape);
        // A raw unit larger, for one-way faces on its border.
        let one = Raw { x: 1, y: 1 };
        all.reduce(|a, b| a.union(&b)).map(|all| Aabb::from_raw_unchecked(all.lo().sub(one), all.hi().add(one)))
    }

    /// No motion is cut into pieces for them: each piece would look at all of them.
    fn cell_size(&self) -> u32 {
        u32::MAX >> 1
    }

    fn overlaps_aabb(&self, b: &Aabb) -> bool {
        self.any(|s| meet::aabb_aabb::<false>(s.lo(), s.hi(), b.lo(), b.hi()))
    }

    fn overlaps_circle(&self, c: &Circle) -> bool {
        self.any(|s| meet::circle_aabb::<false>(c.c(), c.r(), s.lo(), s.hi()))
    }

    fn touches_aabb(&self, b: &Aabb) -> bool {
        self.any(|s| meet::aabb_aabb::<true>(s.lo(), s.hi(), b.lo(), b.hi()))
    }

    fn touches_circle(&self, c: &Circle) -> bool {
        self.any(|s| meet::circle_aabb::<true>(c.c(), c.r(), s.lo(), s.hi()))
    }
}

meets_as_world! { [] Solids<'_> }
