//! Moving solids of any convex shape: sloped lifts, round bumpers, platforms that turn. A list of
//! them is a level.
//!
//! Each serves the whole border of its shape, also where another one covers it. Bodies never come
//! to such a piece: the other solid stops them before. A corner that lies on a flush surface has
//! no side in front of that surface, so a body slides past it.

use super::features::SolidBorder;
use super::solid::Solid;
use crate::error::{Quantity, RangeError};
use crate::num::{MOTION, Raw, Vec2, check_motion};
use crate::query::{Core, meet, meets};
use crate::shape::{Aabb, AnyShape, Capsule, Circle, Convex, ConvexPolygon, OrientedBox, Single};
use crate::world::cell::Cell;
use crate::world::convex::ConvexBody;
use crate::world::level::{Feature, MotionPiece, Seen, World, levels, meets_as_world, sealed};

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
#[doc(alias("AnimatableBody2D", "moving platform", "kinematic body", "seesaw", "flipper", "bumper"))]
#[must_use = "a solid is a value: store it"]
pub struct ConvexSolid<S> {
    shape: S,
    /// The shape after this frame.
    next: S,
    drive: Drive,
    /// The box around both. Every body asks for it, so each change of the solid computes it once.
    whole: Aabb,
    key: u16,
    flags: u8,
}

/// How a solid gets to its next shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Drive {
    Moves(Vec2),
    /// The first corner goes to the corner `shift` of the next shape, and so on around. The longest
    /// way of a corner along x or y is `longest`.
    Turns {
        shift: usize,
        longest: u32,
    },
}

impl Drive {
    /// By the least turn: the sides agree best.
    fn of_turn(p: Core<'_>, q: Core<'_>) -> Self {
        let side = |core: Core<'_>, i: usize| core.corner(core.after(i)).sub(core.corner(i));
        let agreement = |shift: usize| {
            let all = (0..p.corners.len()).map(|i| side(p, i).dot(side(q, q.wrapped(i.wrapping_add(shift)))) >> 6);
            all.fold(0i64, i64::saturating_add)
        };
        let shift = (0..q.corners.len()).max_by_key(|&shift| agreement(shift)).unwrap_or(0);
        let ways = (0..p.corners.len()).map(|i| q.corner(q.wrapped(i.wrapping_add(shift))).sub(p.corner(i)));
        let longest = ways.map(longer).max().unwrap_or(0);
        Self::Turns { shift, longest }
    }
}

fn longer(d: Raw) -> u32 {
    d.x.unsigned_abs().max(d.y.unsigned_abs())
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
        let whole = shape.extent();
        let size = Raw::of(whole.size());
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
        Ok(Self { shape, next: shape, drive: Drive::Moves(Vec2::ZERO), whole, key, flags: 0 })
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
        let next = self.shape.moved(motion)?;
        Ok(Self { drive: Drive::Moves(motion), ..self.goes_to(next) })
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
        let (here, there) = (self.shape.outline(), next.outline());
        if here.len() != there.len() {
            return Err(RangeError { what: Quantity::Corners, value: here.len() as i32 });
        }
        let drive = Drive::of_turn(Core { corners: &here, radius: 0 }, Core { corners: &there, radius: 0 });
        Ok(Self { drive, ..self.goes_to(next) })
    }

    fn goes_to(self, next: S) -> Self {
        Self { next, whole: self.shape.extent().union(&next.extent()), ..self }
    }

    /// The solid after this frame: at its new position, without a motion.
    pub fn moved(self) -> Self {
        Self { shape: self.next, drive: Drive::Moves(Vec2::ZERO), whole: self.next.extent(), ..self }
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
        match self.drive {
            Drive::Moves(motion) => Some(motion),
            Drive::Turns { .. } => None,
        }
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

    /// The box around its shape now and after this frame.
    pub(crate) const fn whole(&self) -> &Aabb {
        &self.whole
    }

    /// Where it is in this frame, unless it moves nothing.
    pub(crate) fn passes(&self) -> Option<Aabb> {
        (self.motion() != Some(Vec2::ZERO)).then_some(self.whole)
    }

    /// The longest way of a corner in this frame, along x or y.
    pub(crate) fn longest(&self) -> u32 {
        match self.drive {
            Drive::Moves(motion) => longer(Raw::of(motion)),
            Drive::Turns { longest, .. } => longest,
        }
    }

    /// Its corners.
    pub(crate) fn outline(&self) -> S::Corners<'_> {
        self.shape.outline()
    }

    /// The corners now and after a turn, and the corner of the second list that the first one goes
    /// to.
    pub(crate) fn corners(&self) -> (S::Corners<'_>, S::Corners<'_>, usize) {
        let shift = match self.drive {
            Drive::Moves(_) => 0,
            Drive::Turns { shift, .. } => shift,
        };
        (self.shape.outline(), self.next.outline(), shift)
    }

    /// The cell of its features, which holds the key.
    pub(super) const fn cell(&self) -> Cell {
        Cell::new(self.key as i16, Solid::ROW)
    }

    /// The border with these corners: its own, or those after this frame.
    pub(crate) fn border<'c>(&self, corners: &'c [Vec2]) -> SolidBorder<'c> {
        SolidBorder { core: Core { corners, radius: self.shape.rounding() }, cell: self.cell(), flags: self.flags }
    }
}

/// Without what follows from the rest.
#[cfg(feature = "defmt")]
impl<S: SolidShape + defmt::Format> defmt::Format for ConvexSolid<S> {
    fn format(&self, f: defmt::Formatter<'_>) {
        let (shape, next, motion) = (self.shape, self.next, self.motion());
        let (key, flags) = (self.key, self.flags);
        defmt::write!(
            f,
            "ConvexSolid {{ shape: {}, next: {}, motion: {}, key: {}, flags: {} }}",
            shape,
            next,
            motion,
            key,
            flags
        );
    }
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

    fn look(&self, region: &Aabb, _: Option<i32>, seen: &mut Seen) -> bool {
        let all = self.list.iter().map(|solid| solid.whole);
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
