//! The results of a motion.

use super::{Body, Hits};
use crate::error::RangeError;
use crate::num::{Fx, Vec2};
use core::convert::Infallible;
use core::fmt;
use core::marker::PhantomData;

/// Where a body ended up, and what happened on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Moved<B> {
    /// The body at its new place; it does not overlap the level.
    pub body: B,
    /// The velocity that is left after the response; feed it to the next call.
    pub velocity: Vec2,
    /// Motion that was not made: what a stopped body had left, or what a body in a tight place could not use in
    /// [`Mover::ITERATIONS`](super::Mover::ITERATIONS) pieces.
    pub remaining: Vec2,
    /// What was hit.
    pub hits: Hits,
    /// Whether a hit faced up to 45 degrees around "up". Always false for a mover without an up. Only what the motion ran into counts: a
    /// body at rest reports no floor, so add gravity in every frame, on the ground too.
    pub floor: bool,
    /// Whether a hit was neither floor nor ceiling.
    pub wall: bool,
    /// Whether a hit faced up to 45 degrees around "down".
    pub ceiling: bool,
    /// The flags of all tiles that were hit, or-ed. Tiles that are not solid are never hit: ask
    /// [`TileMap::tiles_in`](crate::TileMap::tiles_in).
    pub flags: u8,
    /// What the call did.
    pub work: Work,
}

impl<B: Body> Moved<B> {
    /// The new position: the centre of a circle, the minimum corner of a box.
    #[must_use]
    pub fn position(&self) -> Vec2 {
        self.body.position()
    }
}

/// Counters of the work that a call did, for budgets and tests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Work {
    /// Sweeps of the whole remaining motion, at most [`Mover::ITERATIONS`](super::Mover::ITERATIONS).
    pub iterations: u32,
    /// Features that were swept against.
    pub features: u32,
    /// Exact overlap tests of the level.
    pub checks: u32,
}

/// The body overlaps the level before it moves; nothing was moved.
///
/// It comes from a level that changed (a door that closed), or from a body put into the solid. A way out, for games that want one: move it by
/// the [`push_out`](crate::world::WorldContact::push_out) of the nearest of its [`contacts`](crate::TileMap::contacts) and ask `overlaps` again, a few
/// times at most; deep in the solid, and in gaps narrower than the body, there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stuck {
    /// Where it is, as [`Moved::position`], raw.
    pub at: (i32, i32),
}

/// Why a motion was refused; the body stays as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum MoveError {
    /// The velocity or the body is too large, or the motion would leave the domain.
    Range(RangeError),
    /// The body overlaps the level already.
    Stuck(Stuck),
}

impl From<RangeError> for MoveError {
    fn from(e: RangeError) -> Self {
        Self::Range(e)
    }
}

impl fmt::Display for MoveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range(e) => e.fmt(f),
            Self::Stuck(Stuck { at: (x, y) }) => {
                let at = (Fx::from_bits(*x), Fx::from_bits(*y));
                write!(f, "the body at ({}, {}) = ({x}, {y}) raw overlaps the level", at.0, at.1)
            }
        }
    }
}

impl core::error::Error for MoveError {}

/// A solid that is placed into the level for one call: a platform, a door.
///
/// This version has none: no value of this type can be built, the slice that [`Mover::move_and_slide`](super::Mover::move_and_slide)
/// takes is `&[]`, and calls that are written today keep compiling when there are some.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    _none: Infallible,
    _level: PhantomData<&'a ()>,
}
