//! Moving solids of any convex shape as a level.
//!
//! Each solid serves the whole border of its shape, even if another one covers it. Bodies never
//! reach such a piece, because the other solid stops them before. A corner that lies on a flush
//! surface has no side in front of that surface, so a body slides past it.

use super::convex_solid::{ConvexSolid, SolidShape};
use crate::num::Raw;
use crate::query::{Core, meet, meets};
use crate::shape::{Aabb, Circle, Convex};
use crate::world::convex::ConvexBody;
use crate::world::level::{Feature, MotionPiece, Seen, World, levels, meets_as_world, sealed};
use crate::world::probes::Probe;

/// Moving convex solids as a level, at their present positions.
///
/// It borrows the list and needs no memory. [`Joined::new(&level, &solids)`](crate::Joined) is the
/// level with its lifts and bumpers in it. [`Solids::key_of`](crate::Solids::key_of) returns the
/// key of the solid of a hit. Bodies slide on the solids, bounce off them, and stand on them, as on
/// any level.
///
/// Cost: an overlap test compares each bounding box, and then the sides of those that are near.
/// Reading the surface takes some hundred instructions for each corner of a near solid, because its
/// directions have to be reduced.
///
/// ```
/// use tilesat::{Circle, Mover, Response, TileKinds, TileMap, Vec2, fx};
/// use tilesat::{Joined, world::{ConvexSolid, ConvexSolids}};
/// let level = TileMap::from_ascii("....\n....", &TileKinds::EMPTY)?;
/// let bumper = [ConvexSolid::new(Circle::new(Vec2::from_ints(40, 16), fx!(6))?, 1)?];
/// let solids = ConvexSolids::new(&bumper);
/// let ball = Circle::new(Vec2::from_ints(10, 16), fx!(4))?;
/// let mover = Mover::new().with_response(Response::Bounce);
/// let moved = mover.move_and_slide(&Joined::new(&level, &solids), &ball, Vec2::from_ints(30, 0))?;
/// assert_eq!(moved.velocity, Vec2::from_ints(-30, 0)); // straight back
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(alias = "moving platforms")]
pub struct ConvexSolids<'a, S> {
    list: &'a [ConvexSolid<S>],
}

impl<'a, S: SolidShape> ConvexSolids<'a, S> {
    /// A level of all solids of a list.
    #[must_use]
    pub const fn new(list: &'a [ConvexSolid<S>]) -> Self {
        Self { list }
    }

    /// The list.
    pub const fn list(&self) -> &'a [ConvexSolid<S>] {
        self.list
    }

    /// The faces, corners and arcs of the solids that have a point in the closed region.
    ///
    /// Pieces that another solid covers are included.
    pub const fn features(&self, region: &Aabb) -> ConvexFeatures<'a, S> {
        ConvexFeatures { list: self.list, region: *region, next: 0 }
    }

    /// Whether a shape with these bounds meets one of the solids, which are shifted by `offset`.
    fn any<const CLOSED: bool>(&self, core: Core<'_>, bounds: &Aabb, offset: Raw) -> bool {
        self.list.iter().any(|solid| {
            let in_box = |b: &Aabb| meet::aabb_aabb::<CLOSED>(b.lo(), b.hi(), bounds.lo(), bounds.hi());
            if !in_box(&solid.whole) || !in_box(&solid.shape.extent()) {
                return false;
            }
            let shape = if offset.is_zero() { solid.shape } else { solid.shape.shifted(offset) };
            meets::<CLOSED>(core, Core { corners: &shape.outline(), radius: shape.rounding() })
        })
    }

    fn meets<const CLOSED: bool>(&self, b: &impl Convex, bounds: &Aabb) -> bool {
        self.any::<CLOSED>(Core { corners: &b.outline(), radius: b.rounding() }, bounds, Raw::ZERO)
    }
}

levels! {
    [S: SolidShape] ConvexSolids<'_, S> {
        /// Whether a shape overlaps one of the solids; strict and exact.
        overlaps,
        /// Whether a shape has a point in common with one of the solids, borders included;
        /// exact.
        touches,
        /// The flags, or-ed, of all solids that a box, circle or point touches.
        ///
        /// Borders count. Exact. Cost: as [`touches`](Self::touches), but it always looks at every
        /// solid.
        ///
        /// ```
        /// use tilesat::world::{ConvexSolid, ConvexSolids};
        /// use tilesat::{Circle, Vec2, fx};
        /// let bumper = [ConvexSolid::new(Circle::new(Vec2::ZERO, fx!(5))?, 1)?.with_flags(4)];
        /// let flags = |x, y| ConvexSolids::new(&bumper).flags_touched(&Vec2::from_ints(x, y));
        /// assert_eq!((flags(3, 4), flags(4, 4)), (4, 0));
        /// # Ok::<(), tilesat::RangeError>(())
        /// ```
        flags_touched,
    }
}

/// The cursor of [`ConvexSolids::features`].
#[derive(Clone, Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct ConvexFeatures<'w, S> {
    /// Those that are not done.
    pub(crate) list: &'w [ConvexSolid<S>],
    region: Aabb,
    /// The next piece of the first one.
    next: u16,
}

impl<S: SolidShape> Iterator for ConvexFeatures<'_, S> {
    type Item = Feature;

    fn next(&mut self) -> Option<Feature> {
        while let Some((solid, rest)) = self.list.split_first() {
            if meet::aabb_aabb::<true>(solid.whole.lo(), solid.whole.hi(), self.region.lo(), self.region.hi()) {
                let corners = solid.shape.outline();
                let feature = solid.border(&corners).next_in(&mut self.next, &self.region);
                if feature.is_some() {
                    return feature;
                }
            }
            (self.list, self.next) = (rest, 0);
        }
        None
    }
}

impl<S: SolidShape> sealed::Sealed for ConvexSolids<'_, S> {}

impl<S: SolidShape> World for ConvexSolids<'_, S> {
    const BLOCKS: bool = false;
    const ROUND: bool = S::ROUND;
    const WIDE: bool = true;
    const CERTAIN: bool = false;

    #[doc(hidden)]
    const ARCS: bool = S::ROUND;

    type Features<'w>
        = ConvexFeatures<'w, S>
    where
        Self: 'w;

    fn features(&self, region: &Aabb) -> ConvexFeatures<'_, S> {
        ConvexSolids::features(self, region)
    }

    fn features_ahead(&self, way: &MotionPiece) -> ConvexFeatures<'_, S> {
        ConvexSolids::features(self, way.piece)
    }

    fn look(&self, region: &Aabb, _: i32, seen: &mut Seen) -> bool {
        let all = self.list.iter().map(|solid| solid.whole);
        let near = all.filter(|e| meet::aabb_aabb::<true>(e.lo(), e.hi(), region.lo(), region.hi()));
        // A raw unit larger, for bodies without area on its border.
        let one = Raw { x: 1, y: 1 };
        let held = near.reduce(|a, b| a.union(&b));
        let held = held.map(|all| Aabb::from_raw_unchecked(all.lo().sub(one), all.hi().add(one)));
        *seen = Seen { held, cells: None };
        false
    }

    /// No motion is cut into pieces for these solids, because each piece would look at all of them.
    fn cell_size(&self) -> u32 {
        u32::MAX >> 1
    }

    fn overlaps_aabb(&self, b: &Aabb) -> bool {
        self.meets::<false>(b, b)
    }

    fn meets_convex(&self, body: &ConvexBody<'_>, closed: bool) -> bool {
        let (core, bounds, offset) = (body.core, &body.bounds, body.offset);
        if closed { self.any::<true>(core, bounds, offset) } else { self.any::<false>(core, bounds, offset) }
    }

    fn overlaps_circle(&self, c: &Circle) -> bool {
        self.meets::<false>(c, &c.aabb())
    }

    fn touches_aabb(&self, b: &Aabb) -> bool {
        self.meets::<true>(b, b)
    }

    fn touches_circle(&self, c: &Circle) -> bool {
        self.meets::<true>(c, &c.aabb())
    }

    fn flags_touched<P: Probe>(&self, shape: &P) -> u8 {
        let (lo, hi) = shape.bounds();
        let touches = |solid: &&ConvexSolid<S>| {
            let (whole, it) = (solid.shape.extent(), &solid.shape);
            meet::aabb_aabb::<true>(whole.lo(), whole.hi(), lo, hi) && shape.touches_core(&it.outline(), it.rounding())
        };
        self.list.iter().filter(touches).fold(0, |flags, solid| flags | solid.flags())
    }
}

meets_as_world! { [S: SolidShape] ConvexSolids<'_, S> }
