//! One frame of a character: the walk that it planned, and what remains of its velocity.

use super::character::{Character, refused};
use super::feel::{Input, Outcome, Step};
use super::plan::Plan;
use super::walk::Footing;
use super::{Body, Moved};
use crate::error::RangeError;
use crate::num::{Fx, Vec2};
use crate::world::World;

impl<B: Body> Character<B> {
    /// The second half of [`step_on`](Self::step_on), in a level [`Joined`](crate::Joined) with the
    /// solids at their new positions. `carry` is the motion that [`ride`](Self::ride) returned. The
    /// example of `ride` shows both.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn step_carried<W: World>(&mut self, level: &W, input: Input, carry: Vec2) -> Result<Step, RangeError> {
        let before = self.memory;
        let step = self.walk_as_planned(level, input, carry);
        if step.is_err() {
            self.memory = before;
        }
        step
    }

    /// The result of the walk is read where it was written: copies of it and of the character took
    /// a fifth of a step.
    fn walk_as_planned<W: World>(&mut self, level: &W, input: Input, carry: Vec2) -> Result<Step, RangeError> {
        let plan = self.plan(input, carry)?;
        let mut moved = Moved::freely(self.body, plan.velocity, 0);
        let floor = if plan.stands { self.floor } else { None };
        match plan.walker.walk_in_place(level, &mut moved, floor) {
            Ok(footing) => Ok(self.settle(&plan, &moved, &footing)),
            Err(e) => {
                let outcome = refused(e)?;
                (self.velocity, self.floor) = (Vec2::ZERO, None);
                (self.memory.base, self.memory.left, self.memory.through) = (Vec2::ZERO, Fx::ZERO, Fx::ZERO);
                Ok(Step::nothing(outcome))
            }
        }
    }

    /// Applies the result of a walk.
    fn settle(&mut self, plan: &Plan, moved: &Moved<B>, footing: &Footing) -> Step {
        let stood = plan.stands;
        let landed = !stood && footing.met_floor;
        (self.body, self.floor) = (moved.body, footing.floor);
        // The components of the velocity that nothing changed are kept. On a solid, the velocity is
        // relative to the solid again.
        let (now, was) = (moved.velocity, plan.velocity);
        let free = if plan.walks { (!moved.wall, !moved.ceiling) } else { (now.x == was.x, now.y == was.y) };
        let kept = |v: Vec2| {
            let part = |free, v| if free { v } else { Fx::ZERO };
            Vec2::new(part(free.0, v.x), part(free.1, v.y))
        };
        let (base, full) = (kept(self.memory.base), now + kept(plan.made));
        (self.memory.base, self.velocity) = match footing.floor {
            None => (base, full),
            Some(floor) if stood || floor.solid().is_some() => (Vec2::ZERO, Vec2::new(full.x - base.x, now.y)),
            Some(_) => (Vec2::ZERO, Vec2::new(full.x, now.y)),
        };
        if footing.met_floor {
            self.memory.through = Fx::ZERO;
        }
        if landed {
            self.memory.away = 0; // if it slid off at once, it left this floor now
        }
        self.memory.left = self.velocity.y;
        self.memory.jumps &= !footing.met_floor;
        if plan.drops && footing.floor.is_none() {
            self.memory.wish = 0; // the press meant the drop
        }
        if moved.wall {
            // Steeper than 45 degrees: the mover's limit.
            let steep = moved.hits.iter().filter(|hit| hit.axis.x.unsigned_abs() > hit.axis.y.unsigned_abs());
            if let Some(hit) = steep.last() {
                (self.memory.wall, self.memory.wall_age) = (if hit.axis.x < 0 { 1 } else { -1 }, 0);
            }
        }
        Step {
            outcome: if self.is_out() { Outcome::OutOfLevel } else { Outcome::Moved },
            jumped: plan.jumped,
            landed,
            wall: moved.wall,
            ceiling: moved.ceiling,
            flags: moved.flags,
            hits: moved.hits,
        }
    }
}
