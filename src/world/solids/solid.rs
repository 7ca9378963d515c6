//! One box that moves: its shape, and its motion in this frame.

use crate::error::{Quantity, RangeError};
use crate::num::{Axis, MOTION, Raw, Vec2, check_motion};
use crate::shape::Aabb;

/// The side of a one-way [`Solid`] that blocks. "Up" is the side of the smaller y, as in
/// [`TileShape`](crate::TileShape)'s names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Side {
    /// Blocks bodies from the smaller y.
    Up,
    /// Blocks bodies from the larger x.
    Right,
    /// Blocks bodies from the larger y.
    Down,
    /// Blocks bodies from the smaller x.
    Left,
}

impl Side {
    /// The outward normal of that side.
    #[must_use]
    pub const fn normal(self) -> Axis {
        match self {
            Self::Up => Axis::NEG_Y,
            Self::Right => Axis::X,
            Self::Down => Axis::Y,
            Self::Left => Axis::NEG_X,
        }
    }
}

/// A box that may move: a platform, a door, a crusher.
///
/// It is plain data, and takes 36 bytes.
///
/// ```text
///            one-way Up: blocks from this side only
///        min +----------+
///            | key  ->->|-> conveyor: added to what stands on it
///            +----------+ max
///                  motion: from where it is to where it will be after this frame
/// ```
///
/// A list of them is a level, [`Solids`](crate::world::Solids), and
/// [`Mover::ride`](crate::Mover::ride) carries and pushes bodies with them. Solids do not push each
/// other, and nothing stops them: give a platform that stands on another one the same motion.
/// Solids of other shapes are [`ConvexSolid`](crate::world::ConvexSolid)s.
///
/// ```
/// use tilesat::{Aabb, Fx, Solid, Vec2};
/// let lift = Solid::new(Aabb::new(Vec2::from_ints(0, 40), Vec2::from_ints(32, 48))?, 7)?.with_motion(Vec2::from_ints(0, -2))?;
/// assert_eq!(lift.moved().shape().min().y, 38);
/// assert_eq!(lift.moved().motion(), Vec2::ZERO); // set a motion in each frame
/// # Ok::<(), tilesat::RangeError>(())
/// ```
///
/// A solid is a value. The compiler warns if you drop a changed one:
///
/// ```compile_fail
/// #![deny(unused_must_use)]
/// # fn lift(list: &mut [tilesat::Solid; 1], motion: tilesat::Vec2) -> Result<(), tilesat::RangeError> {
/// list[0].with_motion(motion)?; // the lift in the list does not move: use `set_motion`
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias("AnimatableBody2D", "moving platform", "kinematic body", "lift", "door", "elevator"))]
#[must_use = "a solid is a value: store it, or change it in place with `set_motion`"]
pub struct Solid {
    shape: Aabb,
    motion: Vec2,
    conveyor: Vec2,
    key: u16,
    flags: u8,
    side: Option<Side>,
}

impl Solid {
    /// A box at rest, solid from all sides.
    ///
    /// Choose the `key`: results contain it, and on a tie the smaller key wins.
    ///
    /// # Errors
    /// [`RangeError`] if the box has no width or no height.
    pub const fn new(shape: Aabb, key: u16) -> Result<Self, RangeError> {
        let size = shape.lo().sub(shape.hi());
        if size.x == 0 {
            return Err(RangeError { what: Quantity::Width, value: 0 });
        }
        if size.y == 0 {
            return Err(RangeError { what: Quantity::Height, value: 0 });
        }
        Ok(Self { shape, motion: Vec2::ZERO, conveyor: Vec2::ZERO, key, flags: 0, side: None })
    }

    /// Sets the user flags, which hits report as those of a tile.
    pub const fn with_flags(self, flags: u8) -> Self {
        Self { flags, ..self }
    }

    /// Makes it a one-way platform: it blocks, carries and pushes only bodies that are entirely in
    /// front of that side.
    pub const fn with_one_way(self, side: Side) -> Self {
        Self { side: Some(side), ..self }
    }

    /// Adds a conveyor: a motion per frame for the bodies that stand on the solid.
    ///
    /// ```
    /// use tilesat::{Aabb, Solid, Vec2, world::Side};
    /// let belt = Aabb::new(Vec2::from_ints(0, 40), Vec2::from_ints(64, 48))?;
    /// let belt = Solid::new(belt, 1)?.with_one_way(Side::Up).with_flags(4).with_conveyor(Vec2::from_ints(1, 0))?;
    /// assert_eq!((belt.one_way(), belt.flags(), belt.conveyor().x.to_num()), (Some(Side::Up), 4, 1));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the conveyor, or its sum with the motion of this frame, has a component of
    /// [`MOTION`] or more.
    pub const fn with_conveyor(self, conveyor: Vec2) -> Result<Self, RangeError> {
        Self { conveyor, ..self }.checked()
    }

    /// This solid with a motion for this frame, from its current position.
    ///
    /// The result is a new value: to change a solid in a list, call
    /// [`set_motion`](Self::set_motion).
    ///
    /// # Errors
    /// [`RangeError`] if the motion, or its sum with the conveyor, has a component of [`MOTION`] or
    /// more. Also if it would take the box out of the [domain](crate::num::DOMAIN).
    ///
    /// ```
    /// use tilesat::{Aabb, Solid, Vec2};
    /// let lift = Solid::new(Aabb::new(Vec2::from_ints(0, 64), Vec2::from_ints(32, 70))?, 1)?;
    /// let mut lifts = [lift.with_motion(Vec2::from_ints(0, -2))?];
    /// Solid::move_all(&mut lifts);
    /// assert_eq!(lifts[0].shape().min(), Vec2::from_ints(0, 62));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    pub const fn with_motion(self, motion: Vec2) -> Result<Self, RangeError> {
        Self { motion, ..self }.checked()
    }

    /// Sets the motion of this frame in place: [`with_motion`](Self::with_motion) for a solid in a
    /// list.
    ///
    /// ```
    /// use tilesat::{Aabb, Solid, Vec2};
    /// let mut lifts = [Solid::new(Aabb::new(Vec2::from_ints(0, 64), Vec2::from_ints(32, 70))?, 1)?];
    /// lifts[0].set_motion(Vec2::from_ints(0, -2))?;
    /// assert!(lifts[0].set_motion(Vec2::from_ints(0, 4096)).is_err());
    /// assert_eq!(lifts[0].motion(), Vec2::from_ints(0, -2)); // refused: unchanged
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// As [`with_motion`](Self::with_motion). The solid is then unchanged.
    pub const fn set_motion(&mut self, motion: Vec2) -> Result<(), RangeError> {
        match self.with_motion(motion) {
            Ok(solid) => {
                *self = solid;
                Ok(())
            }
            Err(e) => Err(e),
        }
    }

    const fn checked(self) -> Result<Self, RangeError> {
        // Each below 2^28: neither sum saturates.
        let sums = [self.motion, self.conveyor, self.motion.saturating_add(self.conveyor)];
        let mut left: &[Vec2] = &sums;
        while let [v, rest @ ..] = left {
            if let Err(e) = check_motion(*v, MOTION) {
                return Err(e);
            }
            left = rest;
        }
        match self.shape.translated(self.motion) {
            Ok(_) => Ok(self),
            Err(e) => Err(e),
        }
    }

    /// The solid after this frame, at its new position and without a motion.
    pub const fn moved(self) -> Self {
        let d = Raw::of(self.motion);
        let shape = Aabb::from_raw_unchecked(self.shape.lo().add(d), self.shape.hi().add(d));
        Self { shape, motion: Vec2::ZERO, ..self }
    }

    /// Moves all solids of a list at once.
    ///
    /// Call it after the bodies [ride](crate::Mover::ride), and before they move by themselves.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Fx, Joined, Mover, Solid, Solids, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("        \n        ", &KINDS)?;
    /// let boxed = |x, y, w, h| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h));
    /// let mover = Mover::platformer(Axis::NEG_Y);
    /// let mut solids = [Solid::new(boxed(0, 20, 30, 4)?, 1)?, Solid::new(boxed(60, 0, 8, 30)?, 2)?];
    /// let mut player = boxed(10, 6, 8, 14)?;
    ///
    /// for frame in 0..30 {
    ///     solids[0] = solids[0].with_motion(Vec2::from_ints(1, 0))?; // 1: the solids carry the bodies
    ///     player = mover.ride(&level, &solids, &player, Fx::ONE)?.body;
    ///     Solid::move_all(&mut solids); // 2
    ///     let here = Solids::new(&solids); // 3: the player falls, and lands on the platform
    ///     player = mover.move_and_slide(&Joined::new(&level, &here), &player, Vec2::from_ints(0, 1))?.body;
    ///     assert_eq!(player.min(), Vec2::from_ints(11 + frame, 6));
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn move_all(list: &mut [Self]) {
        for solid in list {
            *solid = solid.moved();
        }
    }

    /// Its box.
    #[must_use]
    pub const fn shape(&self) -> Aabb {
        self.shape
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

    /// The side that blocks; `None` if all do.
    #[must_use]
    pub const fn one_way(&self) -> Option<Side> {
        self.side
    }

    /// The motion that it adds to the bodies that stand on it.
    #[must_use]
    pub const fn conveyor(&self) -> Vec2 {
        self.conveyor
    }

    /// Its motion in this frame.
    #[must_use]
    pub const fn motion(&self) -> Vec2 {
        self.motion
    }

    /// The box that it covers in this frame; `None` if it moves nothing.
    pub(crate) fn passes(&self) -> Option<Aabb> {
        let moves = self.motion != Vec2::ZERO || self.conveyor != Vec2::ZERO;
        moves.then(|| self.shape.union(&self.moved().shape))
    }

    pub(crate) const fn lo(&self) -> Raw {
        self.shape.lo()
    }

    pub(crate) const fn hi(&self) -> Raw {
        self.shape.hi()
    }
}
