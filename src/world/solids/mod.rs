//! Moving boxes: platforms, doors and crushers. A list of them is a level.
//!
//! Its surface consists of the faces and corners of each box that no other box of the list covers.
//!
//! At a point, a box fills some of the four quadrants around it. Corners are counted as faces are.
//! Around its own corner c, a box fills quadrant c + 2. The quadrants beside that one are c + 1 and
//! c + 3, and the one across is c:
//!
//! ```text
//!    0 | 1        corner 0 of a box (its minimum) has the box in quadrant 2,
//!   ---p---       corner 1 in quadrant 3, and so on.
//!    3 | 2
//! ```
//!
//! So the corner of a union is convex if c + 1 and c + 3 are empty. Face c continues beyond its
//! start, which is corner c, if c + 3 is filled and c + 1, before it, is empty.

pub(super) mod convex;
pub(super) mod convex_ray;
pub(super) mod convex_solid;
pub(super) mod features;
pub(super) mod ray;
pub(super) mod solid;
#[cfg(feature = "serde")]
mod stored;

use super::cell::Cell;
use super::level::{MotionPiece, Seen, World, levels, meets_as_world, sealed};
use crate::error::RangeError;
use crate::num::{Raw, Vec2};
use crate::query::meet;
use crate::shape::{Aabb, Circle};
use crate::world::convex::ConvexBody;
use crate::world::probes::Probe;
use crate::world::tile_map::region::{bounds_of_trail, bounds_of_way};
use crate::world::trail::Trail;
use features::SolidFeatures;
use solid::Solid;

/// Moving boxes as a level, at their current positions.
///
/// It borrows the list and needs no memory. [`Joined::new(&level, &solids)`](crate::Joined) is the
/// level with its platforms and doors in it. A platform that is flush with a floor, or with another
/// platform, is one floor with it: no seam trips a walker.
///
/// ```text
///   ####      +------+        level and solids, joined:  ____  ______
///   ####______|      |  --->  the walker's floor         ####__|    |
///   ####|  a  |  b   |                                   ####         (no face between a and b, no corner at their joint)
/// ```
///
/// The order of the list changes no result. If several solids give the same answer, a hit may name
/// any of them. A [one-way](Solid::with_one_way) solid is a single face, which blocks only bodies
/// that are entirely in front of it. `overlaps` and `touches` ignore it. A feature's
/// [`cell`](crate::world::Feature::cell) holds the key: see [`Solids::key_of`].
///
/// Each box is tested separately, so a point (a body without area) on the line between two flush
/// solids overlaps neither.
///
/// Cost: an overlap test looks at each of the n boxes. Reading the surface looks at all of them for
/// each piece near the region; a box has 8 pieces. A face that k other boxes cover together takes k
/// such looks. Keep only the platforms of one screen in a list. It cannot fail.
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
#[doc(alias = "moving platforms")]
pub struct Solids<'a> {
    list: &'a [Solid],
}

impl<'a> Solids<'a> {
    /// A level of all boxes of a list.
    #[must_use]
    pub const fn new(list: &'a [Solid]) -> Self {
        Self { list }
    }

    /// The list.
    pub const fn list(&self) -> &'a [Solid] {
        self.list
    }

    /// The key of a solid, from the cell of a feature, a contact, a floor or a hit.
    ///
    /// It is `None` for the cell of a tile or a segment. Hits and floors have methods for it:
    /// [`Hit::solid`](crate::Hit::solid), [`Support::solid`](crate::Support::solid),
    /// [`RayHit::solid`](crate::RayHit::solid). The [`source`](crate::world::Feature::source)
    /// distinguishes the keys of two [joined](crate::Joined) lists.
    ///
    /// ```
    /// use tilesat::{Aabb, Cell, Solid, Solids, Vec2};
    /// let region = Aabb::new(Vec2::from_ints(16, 8), Vec2::from_ints(32, 12))?;
    /// let lift = [Solid::new(region, 7)?];
    /// assert!(Solids::new(&lift).features(&region).all(|feature| Solids::key_of(feature.cell) == Some(7)));
    /// assert_eq!(Solids::key_of(Cell::new(7, 0)), None); // the cell of a tile
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub const fn key_of(cell: Cell) -> Option<u16> {
        cell.solid()
    }

    /// The faces and corners of the solids' union that have a point in the closed region, and
    /// one-way faces.
    ///
    /// A face that others cover in part is returned whole. Cost: see [`Solids`].
    pub const fn features(&self, region: &Aabb) -> SolidFeatures<'a> {
        SolidFeatures::new(self.list, region)
    }

    /// The solids that a box, circle or point touches anywhere on a straight motion, in the order
    /// of the list.
    ///
    /// Use it for triggers, pick-ups, and doors that a ghost passes. One-way solids count as boxes.
    /// Exact; borders count. Cost: one or a few exact tests per solid.
    ///
    /// The solids that a body passes are not in the list that its mover sees. Sort the solids so
    /// that each kind of body sees a part of the list:
    ///
    /// ```
    /// use tilesat::{Aabb, Joined, Mover, Solid, Solids, TileKinds, TileMap, Vec2};
    /// let solid = |x, key| Solid::new(Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 4, 16))?, key);
    /// let all = [solid(40, 1)?, solid(20, 2)?, solid(30, 3)?]; // a door and two curtains
    /// let (doors, curtains) = all.split_at(1);
    /// let level = TileMap::from_ascii("....", &TileKinds::EMPTY)?;
    ///
    /// let ghost = Aabb::new(Vec2::from_ints(4, 4), Vec2::from_ints(12, 12))?;
    /// let seen = Solids::new(doors);
    /// let moved = Mover::new().move_and_slide(&Joined::new(&level, &seen), &ghost, Vec2::from_ints(50, 0))?;
    /// assert_eq!(moved.position(), Vec2::from_ints(32, 4)); // at the door
    ///
    /// let way = moved.position() - ghost.min();
    /// let passed = Solids::new(curtains).swept(&ghost, way)?.map(Solid::key);
    /// assert_eq!(passed.collect::<Vec<_>>(), [2, 3]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if a component of the motion is not below 2^28 raw, or it leads out of the
    /// [domain](crate::num::DOMAIN).
    #[doc(alias = "cross")]
    pub fn swept<'b, B: Probe>(
        &self,
        shape: &'b B,
        motion: Vec2,
    ) -> Result<impl Iterator<Item = &'a Solid> + use<'a, 'b, B>, RangeError> {
        let d = Raw::of(motion);
        bounds_of_way(shape, motion)?;
        Ok(self.list.iter().filter(move |solid| shape.passes(d, (solid.lo(), solid.hi()))))
    }

    /// The solids that a box, circle or point touches anywhere on the path of a mover, in the order
    /// of the list.
    ///
    /// It is [`swept`](Self::swept) for a path of several parts; `shape` is the body before the
    /// call of [`Mover::move_along`](crate::Mover::move_along).
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Mover, Solid, Solids, TileKind, TileKinds, TileMap, Vec2, world::Trail};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("...\n...\n###", &KINDS)?; // the floor is at y = 32
    /// let gem = |x, key| Solid::new(Aabb::from_size(Vec2::from_ints(x, 22), Vec2::from_ints(4, 4))?, key);
    /// let gems = [gem(12, 1)?, gem(30, 2)?, gem(40, 3)?];
    /// let (hero, mut trail) = (Aabb::from_size(Vec2::from_ints(4, 0), Vec2::from_ints(8, 10))?, Trail::default());
    /// let _ = Mover::platformer(Axis::NEG_Y).move_along(&level, &hero, Vec2::from_ints(24, 60), &mut trail)?;
    /// // Down to the floor, and along it up to x = 36.
    /// assert!(Solids::new(&gems).on(&hero, &trail)?.map(Solid::key).eq([1, 2]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the path leads out of the [domain](crate::num::DOMAIN).
    #[doc(alias = "cross")]
    pub fn on<'b, B: Probe>(
        &self,
        shape: &'b B,
        trail: &Trail,
    ) -> Result<impl Iterator<Item = &'a Solid> + use<'a, 'b, B>, RangeError> {
        bounds_of_trail(shape, trail)?;
        let legs = trail.legs();
        let on = move |solid: &&Solid| legs.clone().any(|leg| shape.passes_on(leg, (solid.lo(), solid.hi())));
        Ok(self.list.iter().filter(on))
    }

    fn any(&self, meets: impl Fn(&Solid) -> bool) -> bool {
        self.list.iter().any(|solid| solid.one_way().is_none() && meets(solid))
    }
}

levels! {
    [] Solids<'_> {
        /// Whether a shape overlaps one of the solids; strict and exact.
        ///
        /// One-way solids do not count.
        ///
        /// ```
        /// use tilesat::{Aabb, Solid, Solids, Vec2};
        /// let lift = [Solid::new(Aabb::from_size(Vec2::from_ints(16, 40), Vec2::from_ints(32, 8))?, 1)?];
        /// let lift = Solids::new(&lift);
        /// let hero = |y| Aabb::from_size(Vec2::from_ints(20, y), Vec2::from_ints(10, 14)).unwrap();
        /// assert!(lift.touches(&hero(26)) && !lift.overlaps(&hero(26))); // stands on it
        /// assert!(lift.overlaps(&hero(27)) && !lift.touches(&hero(25)));
        /// # Ok::<(), tilesat::RangeError>(())
        /// ```
        overlaps,
        /// Whether a shape has a point in common with one of the solids, borders included; exact.
        ///
        /// One-way solids do not count.
        touches,
        /// The flags, or-ed, of all solids that a box, circle or point touches, one-way ones
        /// included.
        ///
        /// Borders count. Exact. Cost: a look at each solid.
        ///
        /// ```
        /// use tilesat::{Aabb, Solid, Solids, Vec2};
        /// let saw = [Solid::new(Aabb::new(Vec2::ZERO, Vec2::from_ints(8, 8))?, 1)?.with_flags(2)];
        /// let flags = |x| Solids::new(&saw).flags_touched(&Vec2::from_ints(x, 4));
        /// assert_eq!((flags(8), flags(9)), (2, 0));
        /// # Ok::<(), tilesat::RangeError>(())
        /// ```
        flags_touched,
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

    fn features_ahead(&self, way: &MotionPiece) -> SolidFeatures<'_> {
        Solids::features(self, way.piece).against(way.d)
    }

    fn look(&self, region: &Aabb, _: i32, seen: &mut Seen) -> bool {
        let mut held: Option<Aabb> = None;
        // A fold would divide by the size of a solid, which links a division.
        for solid in self.list {
            if meet::aabb_aabb::<true>(solid.lo(), solid.hi(), region.lo(), region.hi()) {
                held = Some(held.map_or(solid.shape(), |all| all.union(&solid.shape())));
            }
        }
        // A raw unit larger, for one-way faces on its border.
        let one = Raw { x: 1, y: 1 };
        let held = held.map(|all| Aabb::from_raw_unchecked(all.lo().sub(one), all.hi().add(one)));
        *seen = Seen { held, cells: None };
        false
    }

    /// No motion is cut into pieces for these solids, because each piece would look at all of them.
    fn cell_size(&self) -> u32 {
        u32::MAX >> 1
    }

    fn overlaps_aabb(&self, b: &Aabb) -> bool {
        self.any(|s| meet::aabb_aabb::<false>(s.lo(), s.hi(), b.lo(), b.hi()))
    }

    fn meets_convex(&self, body: &ConvexBody<'_>, closed: bool) -> bool {
        let meets = |s: &Solid| {
            let (lo, hi) = (s.lo(), s.hi());
            if closed { body.meets_box::<true>(lo, hi) } else { body.meets_box::<false>(lo, hi) }
        };
        self.any(meets)
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

    fn flags_touched<P: Probe>(&self, shape: &P) -> u8 {
        let (lo, hi) = shape.bounds();
        let touches = |s: &&Solid| meet::aabb_aabb::<true>(s.lo(), s.hi(), lo, hi) && shape.reaches((s.lo(), s.hi()));
        self.list.iter().filter(touches).fold(0, |flags, solid| flags | solid.flags())
    }
}

meets_as_world! { [] Solids<'_> }
