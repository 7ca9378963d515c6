//! A rope, nailed down on top of a block: it lies there, bends over the corner, and hangs.

use tilesat::motion::response::{Link, Particle, Quiet, Stick, relax};
use tilesat::{Axis, Fx, Mover, RangeError, Ratio, Vec2, World, fx};

use super::ragdoll::Fault;

/// How many points it has. With links as long as two radii, no corner gets between two points.
pub const POINTS: usize = 24;
pub const RADIUS: Fx = fx!(2);
const LINK: Fx = fx!(4);
const GRAVITY: Vec2 = Vec2::from_raw(0, 4400);
const ROUNDS: u32 = 24;
const REST: u16 = 30;

#[derive(Clone, Copy, Debug)]
pub struct Rope {
    pub points: [Particle; POINTS],
    links: [Link; POINTS - 1],
    quiet: Quiet,
}

impl Rope {
    /// A rope whose first point is nailed down here, straight to the right.
    pub fn at(nail: Vec2) -> Result<Self, RangeError> {
        let mut points = [Particle::at(nail); POINTS];
        for (k, point) in (0..).zip(&mut points) {
            *point = Particle::at(nail + Vec2::new(LINK * k, Fx::ZERO));
        }
        let mut links = [Link { a: 0, b: 1, stick: Stick::rope(LINK)?.with_share_of_a(Ratio::ZERO) }; POINTS - 1];
        for (k, link) in (1..).zip(links.iter_mut().skip(1)) {
            *link = Link { a: k, b: k + 1, stick: Stick::rope(LINK)? };
        }
        Ok(Self { points, links, quiet: Quiet::NOT })
    }

    /// One frame. Returns whether it hangs still, and then it stays as it is.
    pub fn step(&mut self, world: &impl World) -> Result<bool, Fault> {
        if self.quiet.for_steps(REST) {
            return Ok(true);
        }
        let mover = Mover::platformer(Axis::NEG_Y).with_surface(super::CLOTH);
        for point in self.points.iter_mut().skip(1) {
            *point = point.step_in(world, &mover, RADIUS, GRAVITY, Ratio::percent(1).unwrap_or(Ratio::ZERO))?;
        }
        relax(&mut self.points, &self.links, ROUNDS, world, &mover, RADIUS)?;
        self.quiet = self.quiet.watch(&self.points, Fx::from_bits(2 * 4400));
        Ok(self.quiet.for_steps(REST))
    }
}
