//! What is left of the ninja when a mine goes off: six points and the sticks between them.
//!
//! ```text
//!      0        0 shoulders, 1 hip
//!    / | \      2, 3 hands: on ropes, so that arms fold
//!   2  |  3
//!      1        4, 5 feet
//!     / \
//!    4   5
//! ```

use tilesat::motion::response::{Link, Particle, Quiet, RelaxError, Stick, relax};
use tilesat::{Axis, Fx, MoveError, Mover, RangeError, Ratio, Vec2, World, fx};

use super::runner::Ninja;

/// Every point is a circle of this radius, and all of them start inside the ninja.
pub const RADIUS: Fx = fx!(1.5);
/// From the ninja's centre, in raw units (1/65536 pixel).
const POINTS: [(i32, i32); 6] =
    [(0, -262_144), (0, 32_768), (-196_608, -98_304), (196_608, -98_304), (-131_072, 262_144), (131_072, 262_144)];
/// What the mine adds to each point's velocity.
const BLAST: [(i32, i32); 6] = [
    (20_000, -330_000),
    (0, -280_000),
    (-90_000, -300_000),
    (120_000, -360_000),
    (-60_000, -220_000),
    (80_000, -240_000),
];
const BONES: [(u8, u8, Bend); 5] =
    [(0, 2, Bend::Folds), (0, 3, Bend::Folds), (1, 4, Bend::Stiff), (1, 5, Bend::Stiff), (0, 1, Bend::Stiff)];
const GRAVITY: Vec2 = Vec2::from_raw(0, 4400);
const ROUNDS: u32 = 8;
/// Half a second without motion: then it lies.
const REST: u16 = 30;

#[derive(Clone, Copy)]
enum Bend {
    Stiff,
    Folds,
}

#[derive(Clone, Copy, Debug)]
pub struct Ragdoll {
    pub points: [Particle; 6],
    pub links: [Link; 5],
    quiet: Quiet,
}

impl Ragdoll {
    /// The ninja's limbs, with its velocity and their parts of the blast.
    pub fn of(ninja: &Ninja) -> Result<Self, RangeError> {
        let centre = ninja.body.centre();
        let mut points = [Particle::default(); 6];
        for ((point, at), by) in points.iter_mut().zip(POINTS).zip(BLAST) {
            let velocity = ninja.velocity + Vec2::from_raw(by.0, by.1);
            *point = Particle::moving(centre + Vec2::from_raw(at.0, at.1), velocity);
        }
        let mut links = [Link { a: 0, b: 1, stick: Stick::new(fx!(4.5))? }; 5];
        for (link, (a, b, bend)) in links.iter_mut().zip(BONES) {
            let at = |k: u8| POINTS.get(usize::from(k)).map_or(Vec2::ZERO, |at| Vec2::from_raw(at.0, at.1));
            let length = (at(a) - at(b)).length();
            let stick = if matches!(bend, Bend::Folds) { Stick::rope(length)? } else { Stick::new(length)? };
            *link = Link { a, b, stick };
        }
        Ok(Self { points, links, quiet: Quiet::NOT })
    }

    /// One frame. Returns whether it lies still, and then it stays as it is.
    pub fn step(&mut self, world: &impl World) -> Result<bool, Fault> {
        if self.quiet.for_steps(REST) {
            return Ok(true);
        }
        let mover = Mover::platformer(Axis::NEG_Y).with_surface(super::CLOTH);
        for point in &mut self.points {
            *point = point.step_in(world, &mover, RADIUS, GRAVITY, Ratio::percent(1).unwrap_or(Ratio::ZERO))?;
        }
        relax(&mut self.points, &self.links, ROUNDS, world, &mover, RADIUS)?;
        self.quiet = self.quiet.watch(&self.points, Fx::from_bits(2 * 4400));
        Ok(self.quiet.for_steps(REST))
    }
}

/// Why points could not be moved.
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
