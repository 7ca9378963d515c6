//! Points joined by sticks, which move until they lie still: limbs and ropes.

use tilesat::motion::response::{Link, Particle, Quiet, RelaxError, relax};
use tilesat::{Axis, Fx, MoveError, Mover, Ratio, Surface, Vec2, World};

use super::runner::GRAVITY;

/// It does not bounce, and has much friction.
const CLOTH: Surface = Surface::new(Ratio::ZERO, Ratio::HALF);
/// Half a second without motion.
const REST: u16 = 30;

#[derive(Clone, Copy, Debug)]
pub struct Sticks<const N: usize, const L: usize> {
    pub points: [Particle; N],
    pub links: [Link; L],
    /// Every point is a circle of this radius.
    pub radius: Fx,
    /// The first points are nailed down.
    pub nails: usize,
    pub rounds: u32,
    pub quiet: Quiet,
}

impl<const N: usize, const L: usize> Sticks<N, L> {
    /// Moves for one frame. Returns whether it lies still; then it does not change any more.
    pub fn step(&mut self, world: &impl World) -> Result<bool, Fault> {
        if self.quiet.for_steps(REST) {
            return Ok(true);
        }
        let mover = Mover::platformer(Axis::NEG_Y).with_surface(CLOTH);
        let drag = Ratio::percent(1).unwrap_or(Ratio::ZERO);
        for point in self.points.iter_mut().skip(self.nails) {
            *point = point.step_in(world, &mover, self.radius, Vec2::from_raw(0, GRAVITY), drag)?;
        }
        relax(&mut self.points, &self.links, self.rounds, world, &mover, self.radius)?;
        self.quiet = self.quiet.watch(&self.points, Fx::from_bits(2 * GRAVITY));
        Ok(self.quiet.for_steps(REST))
    }
}

/// The error of a point that could not move.
#[derive(Clone, Copy, Debug)]
pub enum Fault {
    Point(MoveError),
    Link(RelaxError),
}

impl From<MoveError> for Fault {
    fn from(e: MoveError) -> Self {
        Self::Point(e)
    }
}

impl From<RelaxError> for Fault {
    fn from(e: RelaxError) -> Self {
        Self::Link(e)
    }
}

impl core::fmt::Display for Fault {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Point(e) => e.fmt(f),
            Self::Link(e) => e.fmt(f),
        }
    }
}
