//! Verlet points.

use super::Law;
use crate::motion::{MoveError, Mover};
use crate::num::{Fx, Ratio, Raw, Vec2};
use crate::shape::Circle;
use crate::world::World;

/// A point whose velocity is the way from where it was to where it is.
///
/// So whatever moves it, a [`Stick`](super::Stick) for example, changes its velocity with it, and nothing has to be told to the others. In a level it is
/// a small circle that only a mover moves: it never ends inside.
///
/// ```
/// use tilesat::{Ratio, Vec2, motion::response::Particle};
/// let mut spark = Particle::moving(Vec2::from_ints(0, 0), Vec2::from_ints(4, -8));
/// spark = spark.step(Vec2::from_ints(0, 1), Ratio::HALF);
/// assert_eq!(spark.position, Vec2::from_ints(2, -3));
/// assert_eq!(spark.velocity(), Vec2::from_ints(2, -3));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Particle {
    /// Where it is.
    pub position: Vec2,
    /// Where it was a step ago, as far as its velocity is concerned.
    pub previous: Vec2,
}

impl Particle {
    /// A point at rest.
    #[must_use]
    pub const fn at(position: Vec2) -> Self {
        Self { position, previous: position }
    }

    /// A point with a velocity in units per step.
    #[must_use]
    pub fn moving(position: Vec2, velocity: Vec2) -> Self {
        Self { position, previous: position - velocity }
    }

    /// The velocity in units per step.
    #[must_use]
    pub fn velocity(&self) -> Vec2 {
        self.position - self.previous
    }

    /// The velocity of the next step: `drag` of this one is lost, rounded so that it always loses (toward rest, a raw unit at least where there is
    /// drag), and the acceleration is added.
    #[must_use]
    fn next_velocity(&self, acceleration: Vec2, drag: Ratio) -> Vec2 {
        let (v, keep) = (Raw::of(self.velocity()), drag.complement());
        Vec2::from_raw(keep.of_raw(v.x), keep.of_raw(v.y)) + acceleration
    }

    /// The point a step later, in free space. Saturates at the ends of 16.16. Mirrored input gives mirrored bits.
    #[must_use]
    pub fn step(self, acceleration: Vec2, drag: Ratio) -> Self {
        let velocity = self.next_velocity(acceleration, drag);
        Self { position: self.position + velocity, previous: self.position }
    }

    /// The point a step later in a level, as a circle of this radius; its velocity is what the mover left of it.
    ///
    /// Cost: one call of the mover.
    ///
    /// # Errors
    /// As [`Mover::move_and_slide`], and where the circle is outside of the domain.
    pub fn step_in<W: World, S: Law>(
        self,
        world: &W,
        mover: &Mover<S>,
        radius: Fx,
        acceleration: Vec2,
        drag: Ratio,
    ) -> Result<Self, MoveError> {
        let body = Circle::new(self.position, radius)?;
        let moved = mover.move_and_slide(world, &body, self.next_velocity(acceleration, drag))?;
        Ok(Self::moving(moved.position(), moved.velocity))
    }

    /// The point pushed through a level as far as that lets it, along what it meets; its velocity changes by what it made of the push.
    ///
    /// # Errors
    /// As [`step_in`](Self::step_in).
    pub fn pushed_in<W: World, S: Law>(
        self,
        world: &W,
        mover: &Mover<S>,
        radius: Fx,
        by: Vec2,
    ) -> Result<Self, MoveError> {
        if by == Vec2::ZERO {
            return Ok(self);
        }
        let moved = mover.move_and_slide(world, &Circle::new(self.position, radius)?, by)?;
        Ok(Self { position: moved.position(), previous: self.previous })
    }
}
