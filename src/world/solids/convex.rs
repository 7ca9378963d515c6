//! Moving solids of any convex shape: sloped lifts, round bumpers, platforms that turn. A list of
//! them is a level.
//!
//! Each serves the whole border of its shape, also where another one covers it. Bodies never come
//! to such a piece: the other solid stops them before. A corner that lies on a flush surface has
//! no side in front of that surface, so a body slides past it.

use super::solid::Solid;
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, MOTION, Raw, Vec2, check_motion};
use crate::query::{Core, meet, meets};
use crate::shape::{Aabb, AnyShape, Capsule, Circle, Convex, ConvexPolygon, OrientedBox, Single};
use crate::world::cell::Cell;
use crate::world::convex::ConvexBody;
use crate::world::level::{Feature, Geometry, MotionPiece, Seen, World, corners_of, levels, meets_as_world, sealed};

/// A shape that a [`ConvexSolid`] may have: any but a segment or a compound. Sealed.
pub trait SolidShape: Single + Convex {
    /// Whether it may be rounded. A game of sharp solids links no arcs.
    #[doc(hidden)]
    const ROUND: bool;
}

macro_rules! solid_shapes {
    ($([$($n:tt)*] $shape:ty: $round:literal),*) => {$(
        impl<$($n)*> SolidShape for $shape {
            const ROUND: bool = $round;
        }
    )*};
}

solid_shapes!([] Aabb: false, [] Circle: true, [] Capsule: true, [] OrientedBox: false);
solid_shapes!([const N: usize] ConvexPolygon<N>: false, [const N: usize] AnyShape<N>: true);

/// A convex shape that may move or turn: a sloped lift, a bumper, a seesaw. Plain data.
///
/// Sharp shapes may have any direction. Round ones are circles, capsules along x or y, and as
/// [`AnyShape`] boxes along x and y with a radius. A box that only moves costs less as a
/// [`Solid`](crate::Solid). That type has conveyors and one-way sides, too.
///
/// A list of them is a level, [`ConvexSolids`], and [`Mover::ride_convex`](crate::Mover::ride_convex)
/// carries and pushes bodies with them. Solids do not push each other.
///
/// ```
/// use tilesat::{Axis, Fx, OrientedBox, Vec2, world::ConvexSolid};
/// let plank = |degrees: i32| OrientedBox::new(Vec2::from_ints(50, 40), Vec2::from_ints(20, 2), Axis::new(90, degrees));
/// let seesaw = ConvexSolid::new(plank(0)?, 7)?.with_turn(plank(3)?)?;
/// assert_eq!(seesaw.moved().shape(), plank(3)?);
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias("AnimatableBody2D", "moving platform", "kinematic body", "seesaw", "flipper", "bumper"))]
#[must_use = "a solid is a value: store it"]
pub struct ConvexSolid<S> {
    shape: S,
    /// The shape after this frame.
    next: S,
    /// The motion that leads there; none where it turns.
    motion: Option<Vec2>,
    key: u16,
    flags: u8,
}

impl<S: SolidShape> ConvexSolid<S> {
    /// A shape at rest. The `key` is the game's name for it: results carry it, and ties go to the
    /// smaller one.
    ///
    /// # Errors
    /// [`RangeError`] of [`Quantity::Area`] if nothing could overlap it, of [`Quantity::BodySize`]
    /// if a half extent is not below 2^28 raw, and of [`Quantity::Rounding`] if it has a radius and
    /// slanted sides. An `OrientedBox` or `ConvexPolygon` with a radius is refused, too.
    pub fn new(shape: S, key: u16) -> Result<Self, RangeError> {
        let (corners, radius) = (shape.outline(), shape.rounding());
        let size = Raw::of(shape.extent().size());
        if radius == 0 && corners.len() < 3 {
            return Err(RangeError { what: Quantity::Area, value: size.x.min(size.y) });
        }
        let largest = size.x.max(size.y);
        if largest >> 1 >= MOTION {
            return Err(RangeError { what: Quantity::BodySize, value: largest });
        }
        let core = Core { corners: &corners, radius };
        let is_slanted = |i: usize| {
            let n = core.facing_normal(i);
            n.x != 0 && n.y != 0
        };
        if radius != 0 && (!S::ROUND || (0..corners.len()).any(is_slanted)) {
            return Err(RangeError { what: Quantity::Rounding, value: radius });
        }
        Ok(Self { shape, next: shape, motion: Some(Vec2::ZERO), key, flags: 0 })
    }

    /// Sets the user flags. Hits report them as those of a tile.
    pub const fn with_flags(mut self, flags: u8) -> Self {
        self.flags = flags;
        self
    }

    /// The same solid with a motion for this frame, from its present position.
    ///
    /// # Errors
    /// [`RangeError`] if the motion has a component of [`MOTION`] or more, or would take the shape
    /// out of the [domain](crate::num::DOMAIN).
    pub fn with_motion(self, motion: Vec2) -> Result<Self, RangeError> {
        check_motion(motion, MOTION)?;
        Ok(Self { next: self.shape.moved(motion)?, motion: Some(motion), ..self })
    }

    /// The same solid with another shape after this frame: turned, and moved if you like.
    ///
    /// Its corners go to those of `next` that need the least turn. So turn by less than half of
    /// the angle between two of its sides: a plank by less than 90 degrees, a square by less than
    /// 45. Bodies are taken along by the part of the border that they touch, and stay in front of
    /// it. The smaller the steps, the rounder the way.
    ///
    /// # Errors
    /// [`RangeError`] as for [`new`](Self::new), of [`Quantity::Rounding`] if one of both has a
    /// radius, and of [`Quantity::Corners`] if `next` has more or fewer corners.
    pub fn with_turn(self, next: S) -> Result<Self, RangeError> {
        let _ = Self::new(next, self.key)?;
        let radius = self.shape.rounding().max(next.rounding());
        if radius != 0 {
            return Err(RangeError { what: Quantity::Rounding, value: radius });
        }
        let corners = self.shape.outline().len();
        if corners != next.outline().len() {
            return Err(RangeError { what: Quantity::Corners, value: corners as i32 });
        }
        Ok(Self { next, motion: None, ..self })
    }

    /// The solid after this frame: at its new position, without a motion.
    pub fn moved(self) -> Self {
        Self { shape: self.next, motion: Some(Vec2::ZERO), ..self }
    }

    /// Moves all solids of a list at once. Call it after you have asked where the bodies
    /// [ride](crate::Mover::ride_convex), and before they move by themselves.
    pub fn move_all(list: &mut [Self]) {
        for solid in list {
            *solid = solid.moved();
        }
    }

    /// Its shape.
    #[must_use]
    pub const fn shape(&self) -> S {
        self.shape
    }

    /// Its shape after this frame.
    #[must_use]
    pub const fn next(&self) -> S {
        self.next
    }

    /// Its motion in this frame. `None` if it turns.
    #[must_use]
    pub const fn motion(&self) -> Option<Vec2> {
        self.motion
    }

    /// Your key for it.
    #[must_use]
    pub const fn key(&self) -> u16 {
        self.key
    }

    /// The user flags.
    #[must_use]
    pub const fn flags(&self) -> u8 {
        self.flags
    }

    /// The cell of its features, which holds the key.
    pub(super) const fn cell(&self) -> Cell {
        Cell::new(self.key as i16, Solid::ROW)
    }

    /// A piece of its border: of a corner number i, 5 i is the face that begins there, and 5 i + 1
    /// its vertex. Of a rounded one those from 5 i + 1 on are arcs.
    pub(crate) fn piece(&self, index: u16) -> Option<Feature> {
        let (corners, radius) = (self.shape.outline(), self.shape.rounding());
        let core = Core { corners: &corners, radius };
        let geometry = piece(core, usize::from(index / 5), index % 5)?;
        Some(Feature { geometry, cell: self.cell(), index, flags: self.flags, one_way: false, source: 0 })
    }

    /// How many pieces there may be.
    pub(crate) fn pieces(&self) -> u16 {
        (self.shape.outline().len() as u16).wrapping_mul(5)
    }
}

/// A piece of an outline at a corner: its face, its vertex, or one of its four arcs.
fn piece(core: Core<'_>, corner: usize, which: u16) -> Option<Geometry> {
    let (here, next, last) = (core.corner(corner), core.corner(core.after(corner)), core.corner(core.before(corner)));
    let r = core.radius;
    if which == 0 {
        let (dir, len) = reduced(next.sub(here))?;
        // Rounded ones are along x or y, with a direction of length one.
        let out = Raw { x: dir.y.wrapping_mul(r), y: dir.x.wrapping_mul(r).wrapping_neg() };
        let a = here.add(if r == 0 { Raw::ZERO } else { out });
        return Some(Geometry::Face { a: a.vec2(), dir, len, joined: [false; 2] });
    }
    if r == 0 {
        let (e_in, e_out) = (reduced(here.sub(last))?.0, reduced(next.sub(here))?.0);
        return (which == 1).then_some(Geometry::Vertex { p: here.vec2(), e_in, e_out });
    }
    let quadrant = Axis::new(if which & 1 == 0 { -1 } else { 1 }, if which < 3 { -1 } else { 1 });
    let is_outside = |other: Raw| Raw { x: quadrant.x, y: quadrant.y }.dot(other.sub(here)) <= 0;
    (is_outside(next) && is_outside(last)).then_some(Geometry::Arc {
        centre: here.vec2(),
        radius: r,
        quadrant,
        convex: true,
    })
}

/// A side as a reduced direction and its multiple; none of a point.
fn reduced(e: Raw) -> Option<(Axis, i32)> {
    let (x, y) = (e.x.unsigned_abs(), e.y.unsigned_abs());
    let len = gcd(x, y) as i32;
    Some((Axis::new(e.x.checked_div(len)?, e.y.checked_div(len)?), len))
}

/// By halving and differences: a Cortex-M0 has no division.
fn gcd(mut a: u32, mut b: u32) -> u32 {
    if a == 0 || b == 0 {
        return a | b;
    }
    let twos = (a | b).trailing_zeros();
    a >>= a.trailing_zeros() & 31;
    while b != 0 {
        b >>= b.trailing_zeros() & 31;
        (a, b) = (a.min(b), a.abs_diff(b));
    }
    a << (twos & 31)
}

/// Moving convex solids as a level, at their present positions. It borrows the list and needs no
/// memory.
///
/// [`Joined::new(&level, &solids)`](crate::Joined) is the level with its lifts and bumpers in it.
/// Hits name a solid by its key: [`Solids::key_of`](crate::Solids::key_of) reads it. Bodies slide on the solids, bounce
/// off them, and stand on them as on any level.
///
/// Cost: an overlap test compares each bounding box, and then the sides of those that are near.
/// Reading the surface takes some hundred instructions for each corner of a near solid, for its
/// directions are reduced on the way.
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
    /// Pieces that another solid covers come too.
    pub const fn features(&self, region: &Aabb) -> ConvexFeatures<'a, S> {
        ConvexFeatures { list: self.list, region: *region, next: 0 }
    }

    /// Whether a shape with these bounds meets one of the solids, which are shifted by `offset`.
    fn any<const CLOSED: bool>(&self, core: Core<'_>, bounds: &Aabb, offset: Raw) -> bool {
        self.list.iter().any(|solid| {
            let extent = solid.shape.extent();
            if !meet::aabb_aabb::<CLOSED>(extent.lo(), extent.hi(), bounds.lo(), bounds.hi()) {
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
        let meets_region = |lo: Raw, hi: Raw| meet::aabb_aabb::<true>(lo, hi, self.region.lo(), self.region.hi());
        while let Some((solid, rest)) = self.list.split_first() {
            let extent = solid.shape.extent();
            let count = if meets_region(extent.lo(), extent.hi()) { solid.pieces() } else { 0 };
            while self.next < count {
                let index = self.next;
                self.next = index.wrapping_add(1);
                let Some(feature) = solid.piece(index) else { continue };
                let (a, b) = corners_of(&feature.geometry);
                let (lo, hi) = meet::corners(a, b);
                if meets_region(lo, hi) {
                    return Some(feature);
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

    fn look(&self, region: &Aabb, _: Option<i32>, seen: &mut Seen) -> bool {
        let all = self.list.iter().map(|solid| solid.shape.extent());
        let near = all.filter(|e| meet::aabb_aabb::<true>(e.lo(), e.hi(), region.lo(), region.hi()));
        // A raw unit larger, for bodies without area on its border.
        let one = Raw { x: 1, y: 1 };
        let held = near.reduce(|a, b| a.union(&b));
        let held = held.map(|all| Aabb::from_raw_unchecked(all.lo().sub(one), all.hi().add(one)));
        *seen = Seen { held, cells: None };
        false
    }

    /// No motion is cut into pieces for them: each piece would look at all of them.
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
}

meets_as_world! { [S: SolidShape] ConvexSolids<'_, S> }
