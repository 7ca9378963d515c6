//! Points that sticks join, in a level.

use super::{Law, Particle, Stick};
use crate::motion::{MoveError, Mover};
use crate::num::Fx;
use crate::world::World;
use core::fmt;

/// A stick between two points of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Link {
    /// The index of A.
    pub a: u8,
    /// The index of B, another one.
    pub b: u8,
    /// Their distance.
    pub stick: Stick,
}

/// Why points could not be brought to their distances; those before it have been.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RelaxError {
    /// The link of this index names a point that is not there, or one point twice.
    NoPoint {
        /// Which link.
        link: u32,
    },
    /// The mover refused a point of the link of this index.
    Move {
        /// Which link.
        link: u32,
        /// Why.
        error: MoveError,
    },
}

impl fmt::Display for RelaxError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoPoint { link } => write!(f, "link {link} is not between two of the points"),
            Self::Move { link, error } => write!(f, "link {link}: {error}"),
        }
    }
}

impl core::error::Error for RelaxError {}

/// Brings linked points nearer to their distances, link after link, at most `rounds` times, or until nothing moves: the rounds taken.
///
/// Each correction goes through the mover as a circle of this radius, so no point ends inside the level, however hard it is pulled. More
/// rounds make stiffer links; what a blocked point cannot give, its partner gives in the next round. The order of the links is part of
/// the model: the last ones are kept best.
///
/// A frame of a ragdoll is [`Particle::step_in`] for each point, then this, then [`Quiet::watch`](super::Quiet::watch). Split a frame in two or four, with a part of the velocity each, where
/// points are much faster than the links are long.
///
/// Cost: for each round and link a [`pull`](Stick::pull), and where it is not satisfied two calls of the mover.
///
/// # Errors
/// [`RelaxError`] where a link names a point that is not there, or the mover refuses one.
pub fn relax<W: World, S: Law>(
    points: &mut [Particle],
    links: &[Link],
    rounds: u32,
    world: &W,
    mover: &Mover<S>,
    radius: Fx,
) -> Result<u32, RelaxError> {
    for round in 0..rounds {
        let mut moved = false;
        for (index, link) in links.iter().enumerate() {
            let missing = RelaxError::NoPoint { link: index as u32 };
            let refused = |error| RelaxError::Move { link: index as u32, error };
            let (i, j) = (usize::from(link.a), usize::from(link.b));
            if i == j {
                return Err(missing);
            }
            let (a, b) = (*points.get(i).ok_or(missing)?, *points.get(j).ok_or(missing)?);
            let (by_a, by_b) = link.stick.pull(a.position, b.position);
            for (at, point, by) in [(i, a, by_a), (j, b, by_b)] {
                let pushed = point.pushed_in(world, mover, radius, by).map_err(refused)?;
                if let Some(slot) = points.get_mut(at) {
                    moved |= slot.position != pushed.position;
                    *slot = pushed;
                }
            }
        }
        if !moved {
            return Ok(round);
        }
    }
    Ok(rounds)
}
