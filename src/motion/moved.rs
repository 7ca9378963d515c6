//! The results of a motion.

use super::{Body, Hits};
use crate::error::RangeError;
use crate::num::{Fx, Vec2};
use core::fmt;

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
    /// Whether a hit faced "up" within the mover's [slope limit](super::Mover::with_slope_limit), 45 degrees at first. Always false for a mover
    /// without an up. Only what the motion ran into counts: a body at rest reports no floor, so add gravity in every frame, on the ground too.
    pub floor: bool,
    /// Whether a hit was neither floor nor ceiling.
    pub wall: bool,
    /// Whether a hit faced "down" within the same limit.
    pub ceiling: bool,
    /// The flags of all tiles that were hit, or-ed. Tiles that are not solid are never hit: ask
    /// [`TileMap::flags_touched`](crate::TileMap::flags_touched), or [`TileMap::flags_swept`](crate::TileMap::flags_swept) at high speed.
    pub flags: u8,
    /// What the call did.
    pub work: Work,
}

impl<B: Body> Moved<B> {
    /// A body that has hit nothing yet, in as many sweeps.
    #[inline]
    pub(super) fn freely(body: B, velocity: Vec2, iterations: u32) -> Self {
        Self {
            body,
            velocity,
            remaining: Vec2::ZERO,
            hits: Hits::none(),
            floor: false,
            wall: false,
            ceiling: false,
            flags: 0,
            work: Work { iterations, features: 0, checks: 0 },
        }
    }

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

/// The body overlaps the level before it moves; nothing was moved. A call without velocity moves nothing and does not look.
///
/// It comes from a level that changed (a [door](crate::motion#doors) that closed), or from a body put into the solid. A way out, for games that want
/// one: [`escape`](super::escape) pushes it out by the nearest surface that it reaches. It is `Stuck` too where it reaches none, or none is free.
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

impl From<Stuck> for MoveError {
    fn from(e: Stuck) -> Self {
        Self::Stuck(e)
    }
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
