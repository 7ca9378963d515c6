//! One convex solid: its shape, and its motion or turn in this frame.

use super::features::SolidBorder;
use crate::error::{Quantity, RangeError};
use crate::num::{MOTION, Raw, Vec2, check_motion, usqr};
use crate::query::Core;
use crate::shape::{Aabb, AnyShape, Capsule, Circle, Convex, ConvexPolygon, OrientedBox, Single};
use crate::world::cell::Cell;

/// A shape that a [`ConvexSolid`] may have: any but a segment or a compound. Sealed.
pub trait SolidShape: Single + Convex {
    /// Whether it may be rounded. A game of sharp solids links no arcs.
    #[doc(hidden)]
    const ROUND: bool;

    /// # Errors
    /// As [`ConvexSolid::new`].
    #[doc(hidden)]
    fn solid(self, key: u16) -> Result<ConvexSolid<Self>, RangeError>;
}

macro_rules! solid_shapes {
    ($([$($n:tt)*] $shape:ty, $name:literal, $round:literal, $outline:path, $make:literal => $made:literal;)*) => {$(
        impl<$($n)*> SolidShape for $shape {
            const ROUND: bool = $round;

            fn solid(self, key: u16) -> Result<ConvexSolid<Self>, RangeError> {
                self.convex_solid(key)
            }
        }

        impl<$($n)*> $shape {
            /// A solid of this shape at rest: [`ConvexSolid::new`] for constants.
            ///
            /// ```
            /// use tilesat::world::ConvexSolid;
            /// use tilesat::*;
            #[doc = concat!("const SHAPE: ", $name, " = match ", $make, " {")]
            #[doc = concat!("    Ok(it) => ", $made, ",")]
            ///     Err(_) => panic!("the shape"),
            /// };
            #[doc = concat!("static SOLID: ConvexSolid<", $name, "> = match SHAPE.convex_solid(7) {")]
            ///     Ok(it) => it,
            ///     Err(_) => panic!("the solid"),
            /// };
            /// assert_eq!(ConvexSolid::new(SHAPE, 7), Ok(SOLID));
            /// ```
            ///
            /// # Errors
            /// As [`ConvexSolid::new`].
            pub const fn convex_solid(self, key: u16) -> Result<ConvexSolid<Self>, RangeError> {
                let whole = self.aabb();
                match $outline(&self).check($round, &whole) {
                    Ok(()) => Ok(ConvexSolid {
                        shape: self,
                        next: self,
                        drive: Drive::Moves(Vec2::ZERO),
                        whole,
                        key,
                        flags: 0,
                    }),
                    Err(error) => Err(error),
                }
            }
        }
    )*};
}

solid_shapes! {
    [] Aabb, "Aabb", false, BorderKind::of_box,
        "Aabb::from_size(Vec2::ZERO, Vec2::from_ints(30, 8))" => "it";
    [] Circle, "Circle", true, BorderKind::of_circle,
        "Circle::new(Vec2::from_ints(30, 8), fx!(4))" => "it";
    [] Capsule, "Capsule", true, BorderKind::of_capsule,
        "Capsule::new(Vec2::ZERO, Vec2::from_ints(30, 0), fx!(4))" => "it";
    [] OrientedBox, "OrientedBox", false, BorderKind::of_turned_box,
        "OrientedBox::new(Vec2::ZERO, Vec2::from_ints(30, 4), Axis::new(9, 1))" => "it";
    [const N: usize] ConvexPolygon<N>, "ConvexPolygon<3>", false, BorderKind::of_polygon,
        "ConvexPolygon::new(&[Vec2::ZERO, Vec2::from_ints(30, 0), Vec2::from_ints(30, 9)])" => "it";
    [const N: usize] AnyShape<N>, "shape::AnyShape<4>", true, BorderKind::of_any,
        "Circle::new(Vec2::from_ints(30, 8), fx!(4))" => "shape::AnyShape::Circle(it)";
}

/// The properties that decide whether a shape may be solid.
struct BorderKind {
    radius: i32,
    /// Less than three corners.
    is_flat: bool,
    /// A side is neither along x nor along y.
    is_slanted: bool,
}

const fn is_slanted(side: Raw) -> bool {
    side.x != 0 && side.y != 0
}

impl BorderKind {
    const fn of_box(it: &Aabb) -> Self {
        let size = it.hi().sub(it.lo());
        Self { radius: 0, is_flat: size.x == 0 || size.y == 0, is_slanted: false }
    }

    const fn of_circle(it: &Circle) -> Self {
        Self { radius: it.r(), is_flat: true, is_slanted: false }
    }

    const fn of_capsule(it: &Capsule) -> Self {
        let side = Raw::of(it.b()).sub(Raw::of(it.a()));
        Self { radius: it.radius().to_bits(), is_flat: true, is_slanted: is_slanted(side) }
    }

    const fn of_turned_box(it: &OrientedBox) -> Self {
        let (u, v) = (Raw::of(it.along()), Raw::of(it.across()));
        Self {
            radius: it.radius().to_bits(),
            is_flat: u.is_zero() || v.is_zero(),
            is_slanted: is_slanted(u) || is_slanted(v),
        }
    }

    const fn of_polygon<const N: usize>(it: &ConvexPolygon<N>) -> Self {
        let mut rest = it.vertices();
        let mut from = match rest {
            [.., last] => Raw::of(*last),
            [] => Raw::ZERO,
        };
        let (is_flat, mut slanted) = (rest.len() < 3, false);
        while let [first, after @ ..] = rest {
            slanted = slanted || is_slanted(Raw::of(*first).sub(from));
            (from, rest) = (Raw::of(*first), after);
        }
        Self { radius: it.radius().to_bits(), is_flat, is_slanted: slanted }
    }

    const fn of_any<const N: usize>(it: &AnyShape<N>) -> Self {
        match it {
            AnyShape::Aabb(it) => Self::of_box(it),
            AnyShape::Circle(it) => Self::of_circle(it),
            AnyShape::Segment(_) => Self { radius: 0, is_flat: true, is_slanted: false },
            AnyShape::Capsule(it) => Self::of_capsule(it),
            AnyShape::OrientedBox(it) => Self::of_turned_box(it),
            AnyShape::Polygon(it) => Self::of_polygon(it),
        }
    }

    /// # Errors
    /// As [`ConvexSolid::new`].
    const fn check(&self, may_be_round: bool, whole: &Aabb) -> Result<(), RangeError> {
        let size = whole.hi().sub(whole.lo());
        let (least, most) = if size.x < size.y { (size.x, size.y) } else { (size.y, size.x) };
        if self.radius == 0 && self.is_flat {
            return Err(RangeError { what: Quantity::Area, value: least });
        }
        if most >> 1 >= MOTION {
            return Err(RangeError { what: Quantity::BodySize, value: most });
        }
        if self.radius != 0 && (!may_be_round || self.is_slanted) {
            return Err(RangeError { what: Quantity::Rounding, value: self.radius });
        }
        Ok(())
    }
}

/// A convex shape that may move or turn: a sloped lift, a bumper, a seesaw.
///
/// It is plain data. Sharp shapes may have any direction. Round ones are circles, capsules along x
/// or y, and as [`AnyShape`] boxes along x and y with a radius. A box that only moves costs less as
/// a [`Solid`](crate::Solid). That type has conveyors and one-way sides, too.
///
/// A list of them is a level, [`ConvexSolids`](crate::world::ConvexSolids), and
/// [`Mover::ride_convex`](crate::Mover::ride_convex) carries and pushes bodies with them. Solids do
/// not push each other.
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
#[must_use = "a solid is a value: store it, or change it in place with `set_motion` or `set_turn`"]
pub struct ConvexSolid<S> {
    pub(super) shape: S,
    /// The shape after this frame.
    next: S,
    drive: Drive,
    /// The box around both. Every body needs it, so each change of the solid computes it once.
    pub(super) whole: Aabb,
    key: u16,
    flags: u8,
}

/// How a solid changes to its next shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Drive {
    Moves(Vec2),
    /// The first corner moves to the corner `shift` of the next shape, and so on around. `longest`
    /// is the longest displacement of a corner along x or y.
    Turns {
        shift: usize,
        longest: u32,
    },
}

impl Drive {
    /// Maps each side to one of equal length, if all have one, as in a turned shape. If there are
    /// several choices, it takes the least turn, in which the sides agree best.
    fn of_turn(p: Core<'_>, q: Core<'_>) -> Self {
        let side = |core: Core<'_>, i: usize| core.corner(core.after(i)).sub(core.corner(i));
        // A turn rounds corners: lengths differ by 8 raw at most, and their squares by 16 lengths.
        let as_long = |far: u64, square: u64| far >> 36 == 0 && usqr((far >> 4) as u32) <= square;
        let (mut best, mut shift) = ((false, i64::MIN), 0);
        for to in 0..q.corners.len() {
            let mut found = (true, 0i64);
            for i in 0..p.corners.len() {
                let (e, f) = (side(p, i), side(q, q.wrapped(i.wrapping_add(to))));
                found.0 &= as_long(e.len2().abs_diff(f.len2()), e.len2());
                found.1 = found.1.saturating_add(e.dot(f) >> 6);
            }
            if found >= best {
                (best, shift) = (found, to);
            }
        }
        let ways = (0..p.corners.len()).map(|i| q.corner(q.wrapped(i.wrapping_add(shift))).sub(p.corner(i)));
        let longest = ways.map(longer).max().unwrap_or(0);
        Self::Turns { shift, longest }
    }
}

fn longer(d: Raw) -> u32 {
    d.x.unsigned_abs().max(d.y.unsigned_abs())
}

impl<S: SolidShape> ConvexSolid<S> {
    /// A solid at rest.
    ///
    /// Choose the `key`: results contain it, and on a tie the smaller key wins. In a constant, call
    /// `convex_solid` of the [shape](OrientedBox::convex_solid).
    ///
    /// # Errors
    /// [`RangeError`] of [`Quantity::Area`] if the shape has no area. Of [`Quantity::BodySize`] if
    /// a half extent is not below 2^28 raw. Of [`Quantity::Rounding`] if it has a radius and
    /// slanted sides. An `OrientedBox` or `ConvexPolygon` with a radius is refused, too.
    pub fn new(shape: S, key: u16) -> Result<Self, RangeError> {
        shape.solid(key)
    }

    /// Sets the user flags, which hits report as those of a tile.
    pub const fn with_flags(mut self, flags: u8) -> Self {
        self.flags = flags;
        self
    }

    /// This solid with a motion for this frame, from its current position.
    ///
    /// The result is a new value. To change a solid in a list, call
    /// [`set_motion`](Self::set_motion), which has an example.
    ///
    /// # Errors
    /// [`RangeError`] if the motion has a component of [`MOTION`] or more, or would take the shape
    /// out of the [domain](crate::num::DOMAIN).
    pub fn with_motion(self, motion: Vec2) -> Result<Self, RangeError> {
        check_motion(motion, MOTION)?;
        let next = self.shape.moved(motion)?;
        Ok(Self { drive: Drive::Moves(motion), ..self.goes_to(next) })
    }

    /// Sets the motion of this frame in place, as [`with_motion`](Self::with_motion).
    ///
    /// ```
    /// use tilesat::{Circle, Vec2, fx, world::ConvexSolid};
    /// let mut lifts = [ConvexSolid::new(Circle::new(Vec2::from_ints(20, 64), fx!(6))?, 1)?];
    /// lifts[0].set_motion(Vec2::from_ints(0, -2))?;
    /// assert!(lifts[0].set_motion(Vec2::from_ints(0, 4096)).is_err());
    /// assert_eq!(lifts[0].motion(), Some(Vec2::from_ints(0, -2))); // refused: unchanged
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// As [`with_motion`](Self::with_motion). The solid is then unchanged.
    pub fn set_motion(&mut self, motion: Vec2) -> Result<(), RangeError> {
        *self = self.with_motion(motion)?;
        Ok(())
    }

    /// This solid with another shape after this frame, which may be turned and moved.
    ///
    /// The result is a new value: to change a solid in a list, call [`set_turn`](Self::set_turn).
    /// Its corners move to those of `next` between sides of the same lengths. If there are several
    /// choices, the least turn is used. So turn a plank by less than 90 degrees, and a square by
    /// less than 45. The part of the border that a body touches carries it, and the body stays in
    /// front of it. Smaller steps give rounder paths.
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

    /// Sets the shape after this frame in place, as [`with_turn`](Self::with_turn).
    ///
    /// ```
    /// use tilesat::{Axis, OrientedBox, Vec2, world::ConvexSolid};
    /// let plank = |rise| OrientedBox::new(Vec2::from_ints(50, 40), Vec2::from_ints(20, 2), Axis::new(90, rise));
    /// let mut seesaws = [ConvexSolid::new(plank(0)?, 7)?];
    /// seesaws[0].set_turn(plank(3)?)?;
    /// assert!(seesaws[0].set_turn(plank(0)?.with_radius(tilesat::fx!(1))?).is_err());
    /// assert_eq!((seesaws[0].motion(), seesaws[0].next()), (None, plank(3)?)); // refused: unchanged
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// As [`with_turn`](Self::with_turn). The solid is then unchanged.
    pub fn set_turn(&mut self, next: S) -> Result<(), RangeError> {
        *self = self.with_turn(next)?;
        Ok(())
    }

    fn goes_to(self, next: S) -> Self {
        Self { next, whole: self.shape.extent().union(&next.extent()), ..self }
    }

    /// The solid after this frame, at its new position and without a motion.
    pub fn moved(mut self) -> Self {
        self.go();
        self
    }

    /// In place: a copy of a part of the whole over the rest would link a move of overlapping
    /// memory, 1.3 KB.
    fn go(&mut self) {
        (self.shape, self.drive, self.whole) = (self.next, Drive::Moves(Vec2::ZERO), self.next.extent());
    }

    /// Moves all solids of a list at once.
    ///
    /// Call it after the bodies [ride](crate::Mover::ride_convex), and before they move by
    /// themselves.
    pub fn move_all(list: &mut [Self]) {
        for solid in list {
            solid.go();
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

    /// Its motion in this frame; `None` if it turns.
    #[must_use]
    pub const fn motion(&self) -> Option<Vec2> {
        match self.drive {
            Drive::Moves(motion) => Some(motion),
            Drive::Turns { .. } => None,
        }
    }

    /// The key that you chose.
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

    /// The box that it covers in this frame; `None` if it moves nothing.
    pub(crate) fn passes(&self) -> Option<Aabb> {
        (self.motion() != Some(Vec2::ZERO)).then_some(self.whole)
    }

    /// The longest displacement of a corner in this frame, along x or y.
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

    /// The corners now and after a turn, and the second list's corner to which the first one goes.
    pub(crate) fn corners(&self) -> (S::Corners<'_>, S::Corners<'_>, usize) {
        let shift = match self.drive {
            Drive::Moves(_) => 0,
            Drive::Turns { shift, .. } => shift,
        };
        (self.shape.outline(), self.next.outline(), shift)
    }

    /// The cell of its features, which holds the key.
    pub(super) const fn cell(&self) -> Cell {
        Cell::of_solid(self.key)
    }

    /// The border with these corners: its own, or those after this frame.
    pub(crate) fn border<'c>(&self, corners: &'c [Vec2]) -> SolidBorder<'c> {
        SolidBorder { core: Core { corners, radius: self.shape.rounding() }, cell: self.cell(), flags: self.flags }
    }
}

/// Without the fields that follow from the rest.
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
