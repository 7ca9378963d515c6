//! What a character plans for a frame before it moves: its timers, jumps and velocity.

use super::character::Character;
use super::feel::{Input, OnLeave};
use super::walk::CONTACT;
use super::{Body, Support, Walker};
use crate::error::RangeError;
use crate::num::{Fx, Vec2};

/// The plan of a frame: the velocity, and the walker that will make it.
#[expect(clippy::struct_excessive_bools, reason = "facts that are independent of each other")]
pub(super) struct Plan {
    pub(super) walker: Walker,
    /// Whether it stands on its floor, which is one if gravity has not turned since.
    pub(super) stands: bool,
    /// The motion still to make in this frame.
    pub(super) velocity: Vec2,
    /// The part of the motion that a solid has already made.
    pub(super) made: Vec2,
    pub(super) jumped: bool,
    /// Whether it drops through the one-way floor that it stands on.
    pub(super) drops: bool,
    /// Whether it stands and stays a walker: the velocity then has no part along "up".
    pub(super) walks: bool,
}

/// The speeds of a frame, relative to the solid that the character left.
struct Speeds {
    run: Fx,
    /// Downward.
    fall: Fx,
    /// Downward, relative to the level.
    falls: Fx,
}

impl<B: Body> Character<B> {
    /// Updates the timers, and returns the velocity of this frame after all rules.
    pub(super) fn plan(&mut self, input: Input, carry: Vec2) -> Result<Plan, RangeError> {
        self.heed_gravity();
        // If gravity has turned since, what it stood on is no floor: it leaves that in this frame.
        let is_floor = |floor: Support| (floor.axis.y < 0) == self.falls_to_larger_y();
        let (stood, stands) = (self.floor.is_some(), self.floor.is_some_and(is_floor));
        self.count_frames(input.jump, stands);
        let keeps = stood || self.feel.on_leave == OnLeave::Keep;
        let mut speeds = self.run_and_fall(input.run, if keeps { self.memory.base } else { Vec2::ZERO }, stands);
        let launched = speeds.fall < 0 && self.falls() < self.downward(self.memory.left);
        if launched {
            (self.memory.away, self.memory.jumps) = (u8::MAX, false);
        }
        if stood {
            self.memory.base = carry; // if it leaves the floor in this frame
        }
        let drops = input.drop && stands && self.floor.is_some_and(|floor| floor.one_way);
        let jumped = self.memory.wish > 0 && !drops && self.jump(&mut speeds, !launched, stands);
        if stands && jumped && self.feel.on_leave == OnLeave::AddUpward && self.downward(carry.y) > 0 {
            self.memory.base.y = Fx::ZERO;
        }
        self.cut_rise(&mut speeds, input.jump);
        if input.drop {
            self.memory.away = u8::MAX;
        }
        let walker = self.walker(self.passes(input.drop))?;
        self.count_drop(drops, carry, speeds.fall);
        let base = if keeps { self.memory.base } else { Vec2::ZERO };
        let velocity = Vec2::new(speeds.run, self.downward(speeds.fall)) + base;
        let made = if stood { carry } else { already_made(velocity, base, carry) };
        let walks = stands && !(jumped || launched || drops);
        Ok(Plan { walker, stands, velocity: velocity - made, made, jumped, drops, walks })
    }

    /// How far the body may come from its position in the next step, on each axis. A walk along x
    /// on a slope rises or sinks, too, by as much at the default slope limit.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub(crate) fn reach(&self, input: Input, carry: Vec2) -> Result<u32, RangeError> {
        let plan = { *self }.plan(input, carry)?;
        let [x, y] = [plan.velocity.x, plan.velocity.y].map(|c| c.to_bits().unsigned_abs());
        let [snap, step] = [self.feel.snap, self.feel.step].map(|c| c.to_bits().unsigned_abs());
        Ok([y, x, snap, step, CONTACT as u32].into_iter().fold(x, u32::saturating_add))
    }

    /// Remembers where gravity pulls. If it has turned, the floor that the character left gives no
    /// coyote time.
    pub(super) fn heed_gravity(&mut self) {
        let flipped = !self.falls_to_larger_y();
        if flipped != self.memory.flipped {
            (self.memory.flipped, self.memory.away) = (flipped, u8::MAX);
        }
    }

    /// Counts the frames since it stood and since it was at a wall, and those for which a press
    /// still counts.
    fn count_frames(&mut self, jump: bool, stands: bool) {
        self.memory.away = if stands { 0 } else { self.memory.away.saturating_add(1) };
        self.memory.wall_age = self.memory.wall_age.saturating_add(1);
        self.memory.wish =
            if jump && !self.memory.held { self.feel.buffer.saturating_add(1) } else { self.memory.wish };
        self.memory.held = jump;
    }

    /// Running and gravity.
    fn run_and_fall(&self, run: Fx, base: Vec2, stands: bool) -> Speeds {
        let feel = &self.feel;
        let rate = if stands { feel.acceleration } else { feel.air_acceleration };
        let base_fall = self.downward(base.y);
        // Off a sinking solid it falls faster by the solid's speed; above a rising one no slower.
        let fastest = feel.fall.saturating_add(base_fall.max(Fx::ZERO));
        let against_wall =
            self.memory.wall_age <= 1 && run.signum() == Fx::from(self.memory.wall) && self.memory.wall != 0;
        let limit = feel.wall_slide.filter(|_| against_wall).map_or(fastest, |slide| slide.min(feel.fall));
        let falls = self.falls().saturating_add(self.pull()).min(limit);
        let run = toward(self.velocity.x.saturating_sub(base.x), run, rate);
        Speeds { run, fall: falls.saturating_sub(base_fall), falls }
    }

    /// Jumps off the floor, or off a wall, if it can. Returns whether it does.
    fn jump(&mut self, speeds: &mut Speeds, may_leave_floor: bool, stands: bool) -> bool {
        let feel = &self.feel;
        let off_floor = may_leave_floor && (stands || self.memory.away <= feel.grace());
        let off_wall = feel.wall_jump.filter(|_| self.memory.wall != 0 && self.memory.wall_age <= feel.grace() + 1);
        if !off_floor && off_wall.is_none() {
            return false;
        }
        // A jump takes no upward speed away, which a spring or a ramp gave. It is cut only if its
        // own speed is the larger one.
        if let Some(push) = off_wall.filter(|_| !off_floor) {
            speeds.run = if self.memory.wall > 0 { push.saturating_neg() } else { push };
            (self.memory.base, speeds.fall) = (Vec2::ZERO, speeds.falls);
        }
        let jump = self.feel.jump.saturating_neg();
        self.memory.jumps = speeds.fall >= jump;
        speeds.fall = speeds.fall.min(jump);
        (self.memory.wish, self.memory.away, self.memory.wall) = (0, u8::MAX, 0);
        true
    }

    /// Cuts the rise of a jump whose button was released.
    fn cut_rise(&mut self, speeds: &mut Speeds, jump: bool) {
        self.memory.wish = self.memory.wish.saturating_sub(1);
        self.memory.jumps &= speeds.fall < 0;
        if self.memory.jumps && !jump {
            speeds.fall = speeds.fall.max(self.feel.jump_cut.saturating_neg());
        }
    }

    /// Counts how far it still falls through one-way floors.
    ///
    /// A solid that sinks moves below the feet first, before the body falls. The drop is over once
    /// the body is farther below the solid than that sinks in a frame. It sinks by at most the
    /// snap; the rest is for a solid that speeds up.
    fn count_drop(&mut self, drops: bool, carry: Vec2, fall: Fx) {
        if drops && self.ridden().is_some() {
            let sinks = self.downward(carry.y).max(Fx::ZERO);
            self.memory.through = self.feel.snap.saturating_add(sinks).saturating_add(Fx::DELTA);
        }
        self.memory.through = if fall > 0 { self.memory.through.saturating_sub(fall).max(Fx::ZERO) } else { Fx::ZERO };
    }
}

/// The part of a velocity in the air that solids have already made.
///
/// A push along the velocity has already made a part of this frame's motion. So has the solid that
/// the character left, if that solid moves under the feet in the frame of the landing.
fn already_made(velocity: Vec2, base: Vec2, carry: Vec2) -> Vec2 {
    let (all, left) = (carry.common(velocity), carry.common(base));
    Vec2::new(farther(all.x, left.x), farther(all.y, left.y))
}

/// The longer one of two motions.
fn farther(a: Fx, b: Fx) -> Fx {
    if a.unsigned_abs() < b.unsigned_abs() { b } else { a }
}

/// A speed, changed by at most `rate` toward another.
fn toward(speed: Fx, target: Fx, rate: Fx) -> Fx {
    if speed < target { speed.saturating_add(rate).min(target) } else { speed.saturating_sub(rate).max(target) }
}
