//! One frame of a character: the walk that it planned, and what remains of its velocity.

use super::character::{Character, refused};
use super::feel::{Input, Outcome, Step};
use super::plan::Plan;
use super::{Body, MoveError, Walked};
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
        let mut next = *self;
        let plan = next.plan(input, carry)?;
        let walked = plan.walker.walk(level, &next.body, plan.velocity, next.floor);
        let step = next.settle(&plan, walked)?;
        *self = next;
        Ok(step)
    }

    /// Applies the result of a walk.
    fn settle(&mut self, plan: &Plan, walked: Result<Walked<B>, MoveError>) -> Result<Step, RangeError> {
        let walked = match walked {
            Ok(walked) => walked,
            Err(e) => {
                let outcome = refused(e)?;
                (self.velocity, self.floor, self.base, self.left) = (Vec2::ZERO, None, Vec2::ZERO, Fx::ZERO);
                self.through = Fx::ZERO;
                return Ok(Step::nothing(outcome));
            }
        };
        let moved = &walked.moved;
        let stood = self.floor.is_some();
        let landed = !stood && walked.met_floor;
        (self.body, self.floor) = (moved.body, walked.floor);
        // The components of the velocity that nothing changed are kept. On a solid, the velocity is
        // relative to the solid again.
        let (now, was) = (moved.velocity, plan.velocity);
        let free = if plan.walks { (!moved.wall, !moved.ceiling) } else { (now.x == was.x, now.y == was.y) };
        let kept = |v: Vec2| {
            let part = |free, v| if free { v } else { Fx::ZERO };
            Vec2::new(part(free.0, v.x), part(free.1, v.y))
        };
        let (base, full) = (kept(self.base), now + kept(plan.made));
        (self.base, self.velocity) = match walked.floor {
            None => (base, full),
            Some(floor) if stood || floor.solid().is_some() => (Vec2::ZERO, Vec2::new(full.x - base.x, now.y)),
            Some(_) => (Vec2::ZERO, Vec2::new(full.x, now.y)),
        };
        if walked.met_floor {
            self.through = Fx::ZERO;
        }
        if landed {
            self.away = 0; // if it slid off at once, it left this floor now
        }
        self.left = self.velocity.y;
        self.jumps &= !walked.met_floor;
        if plan.drops && walked.floor.is_none() {
            self.wish = 0; // the press meant the drop
        }
        if moved.wall {
            // Steeper than 45 degrees: the mover's limit.
            let steep = moved.hits.iter().filter(|hit| hit.axis.x.unsigned_abs() > hit.axis.y.unsigned_abs());
            if let Some(hit) = steep.last() {
                (self.wall, self.wall_age) = (if hit.axis.x < 0 { 1 } else { -1 }, 0);
            }
        }
        Ok(Step {
            outcome: if self.is_out() { Outcome::OutOfLevel } else { Outcome::Moved },
            jumped: plan.jumped,
            landed,
            wall: moved.wall,
            ceiling: moved.ceiling,
            flags: moved.flags,
            hits: moved.hits,
        })
    }
}
