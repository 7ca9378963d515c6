//! Looks ahead of a character for corners that it can pass, and for ledges.

use super::character::refused;
use super::feel::{Input, Outcome};
use super::{Body, Character, MoveError, SlopeSpeed, Support, Walked, Walker};
use crate::error::RangeError;
use crate::num::{Fx, Raw, Vec2, mul_div};
use crate::shape::Aabb;
use crate::world::World;

impl<B: Body> Character<B> {
    /// Moves the character aside by at most `reach`, if it rises and would hit a corner that it can
    /// pass from there: *corner correction*. Returns whether it moved.
    ///
    /// Call it before [`step`](Self::step) or [`step_on`](Self::step_on), with the same input. It
    /// looks at the velocity that this step will start with, as
    /// [`Mover::assist`](crate::Mover::assist) does: to the side to which it runs, if it runs.
    /// With moving solids, pass the level [`Joined`](crate::Joined) with them.
    ///
    /// Cost: that of [`Mover::assist`](crate::Mover::assist). You link it only if you call it.
    ///
    /// ```
    /// use tilesat::{Aabb, Character, Feel, Input, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("...\n...\n##.\n...\n...\n###", &KINDS)?;
    /// // Its head is a unit under the corner at x = 32.
    /// let body = Aabb::new(Vec2::from_ints(31, 66), Vec2::from_ints(41, 80))?;
    /// let mut hero = Character::new(body, level.bounds(), Feel::DEFAULT);
    /// let _ = hero.step(&level, Input::default())?; // it lands
    /// let (jump, mut top) = (Input { jump: true, ..Input::default() }, body.min().y);
    /// for _ in 0..18 {
    ///     let _ = hero.assist(&level, jump, fx!(3))?;
    ///     let _ = hero.step(&level, jump)?;
    ///     top = top.min(hero.body().min().y);
    /// }
    /// assert_eq!((hero.body().min().x, top), (fx!(32), fx!(23.25))); // 42.75 higher: the whole jump
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step`](Self::step), and [`RangeError`] if `reach` is negative or not below 4096 units.
    #[doc(alias("corner correction", "corner_correction"))]
    pub fn assist<W: World>(&mut self, level: &W, input: Input, reach: Fx) -> Result<bool, RangeError> {
        let mut next = *self;
        let velocity = next.plan(input, Vec2::ZERO)?.velocity;
        // If it does not rise, the call only checks the numbers.
        let rises = if self.downward(velocity.y) < 0 { velocity } else { Vec2::ZERO };
        match self.mover().assist(level, &self.body, rises, reach) {
            Ok(aside) => {
                let moved = aside.position() != self.body.position();
                self.body = aside;
                Ok(moved)
            }
            Err(e) => refused(e).map(|_| false),
        }
    }

    /// How far it still moves on a floor if it runs at [`Input::run`] for one more frame, and then
    /// brakes or turns. [`ledge_ahead`](Self::ledge_ahead) takes it. It has the sign of `run`.
    ///
    /// If the next frame brings it to a speed of `v` in that direction, that is `v + v * v / (2 *
    /// a)` with the [`Feel::acceleration`](crate::Feel::acceleration) `a`, rounded down. The exact
    /// distance is shorter by half of `v`. Without an acceleration it never stops: the result is
    /// then [`Fx::MAX`], or `Fx::MIN + 1` to the left, unless it stands.
    ///
    /// ```
    /// use tilesat::{Aabb, Character, Feel, Vec2, fx};
    /// let body = Aabb::new(Vec2::ZERO, Vec2::from_ints(10, 14))?;
    /// let mut enemy = Character::new(body, body, Feel { acceleration: fx!(0.5), ..Feel::DEFAULT });
    /// assert_eq!(enemy.stopping_distance(fx!(4)), fx!(0.75)); // it stands: 0.5, and 0.25 to brake
    /// enemy.velocity.x = fx!(-4);
    /// assert_eq!(enemy.stopping_distance(fx!(-4)), fx!(-20)); // 4, and 16 to brake
    /// assert_eq!(enemy.stopping_distance(fx!(4)), fx!(0.75)); // it has turned before
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    #[doc(alias = "braking distance")]
    pub const fn stopping_distance(&self, run: Fx) -> Fx {
        let (run, v, a) = (run.to_bits(), self.velocity.x.to_bits(), self.feel.acceleration.to_bits());
        let a = if a > 0 { a as u32 } else { 0 };
        let toward = if run < 0 { v.saturating_neg() } else { v };
        let faster = (if toward > 0 { toward as u32 } else { 0 }).saturating_add(a);
        let speed = if faster < run.unsigned_abs() { faster } else { run.unsigned_abs() };
        // Without a speed it is 0, also without an acceleration.
        let brakes = if speed == 0 { 0 } else { mul_div(speed, speed, a.saturating_mul(2)) };
        let far = speed.saturating_add(brakes);
        let far = if far > i32::MAX as u32 { i32::MAX } else { far as i32 };
        Fx::from_bits(if run < 0 { far.wrapping_neg() } else { far })
    }

    /// Returns whether the floor ends within `far` plus the width of the body. The sign of `far` is
    /// the direction. If the answer is `false`, the body's front can move on by `far` and stays on
    /// the floor.
    ///
    /// **How far.** A patrol that turns in the next frame still moves by that frame's motion and by
    /// its braking distance. Pass its [stopping distance](Self::stopping_distance): then its front
    /// never leaves the floor. The chapter on walkers in the guide has the program, also for short
    /// platforms.
    ///
    /// Slopes, steps and ground that falls by at most [`Feel::snap`](crate::Feel::snap) are not
    /// ledges, and neither are gaps that are narrower than the body. A gap as wide as a box is a
    /// ledge, even if the box would step over it, because the box may stop in it. One-way floors
    /// are floors. In the air the answer is `false`.
    ///
    /// It looks in steps of five eighths of the snap. If the body is not a box, one look may skip a
    /// gap that is wider than the body by less than a step. Call it in every frame.
    ///
    /// Cost: a [`Walker::walk`](crate::Walker::walk) for each of these steps, at most sixteen, and
    /// a look down for each that a box makes. For a body of 10 units at a speed of 1 that is four
    /// walks. On a Cortex-M0 they take six to seven times as long as the patrol's own step. Up to
    /// twenty more follow where the floor has a gap that is nearly as wide as the box. To save
    /// time, call it in every `n`-th frame, with `far` larger by `(n - 1) * v`. If `far` and the
    /// width are more than ten times the snap, the steps are longer. Slopes that lead down may then
    /// count as ledges: raise the snap.
    ///
    /// ```
    /// use tilesat::{Aabb, Character, Feel, Input, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'=', TileKind::ONE_WAY_UP);
    /// let level = TileMap::from_ascii("........\n.=====..", &KINDS)?; // from x = 16 to 96
    /// let body = Aabb::new(Vec2::from_ints(30, 2), Vec2::from_ints(40, 16))?;
    /// let mut enemy = Character::new(body, level.bounds(), Feel::DEFAULT);
    /// let (mut run, mut turns) = (fx!(1), 0);
    /// for _ in 0..400 {
    ///     let step = enemy.step(&level, Input::running(run))?;
    ///     if step.wall || enemy.ledge_ahead(&level, enemy.stopping_distance(run))? {
    ///         (run, turns) = (-run, turns + 1);
    ///     }
    ///     assert!(enemy.body().min().x >= 16 && enemy.body().max().x <= 96);
    /// }
    /// assert!(turns > 4 && turns < 10);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step`](Self::step), also if `far` and the width together are not below 4096 units.
    #[doc(alias("patrol", "edge detection", "cliff"))]
    pub fn ledge_ahead<W: World>(&self, level: &W, far: Fx) -> Result<bool, RangeError> {
        let bounds = self.body.bounds();
        let way = bounds.max().x.saturating_sub(bounds.min().x).saturating_add(far.saturating_abs());
        let walker = self.walker(false)?.with_slope_speed(SlopeSpeed::Constant);
        // Short of two thirds of the snap, it follows ground of 45 degrees; at most sixteen parts.
        let snap = self.feel.snap;
        let part = (snap >> 1_u32).saturating_add(snap >> 3_u32).max((way >> 4_u32).saturating_add(Fx::DELTA));
        let ahead = Ahead { walker, level };
        match ahead.finds_ledge(self.body, self.floor, (way, part), far < 0) {
            Ok(found) => Ok(found),
            Err(e) => Ok(refused(e)? == Outcome::OutOfLevel),
        }
    }
}

/// A walk that looks ahead and moves nothing.
struct Ahead<'a, W> {
    walker: Walker,
    level: &'a W,
}

impl<W: World> Ahead<'_, W> {
    /// Whether a body on a floor reaches a position without a floor, part by part.
    fn finds_ledge<B: Body>(
        &self,
        mut body: B,
        floor: Option<Support>,
        (mut left, part): (Fx, Fx),
        back: bool,
    ) -> Result<bool, MoveError> {
        let Some(mut floor) = floor else { return Ok(false) };
        while left > 0 {
            let way = left.min(part);
            let walked = self.walk(&body, if back { way.saturating_neg() } else { way }, floor)?;
            let Some(next) = walked.floor else { return Ok(true) };
            let to = walked.moved.body;
            // Bodies with round or slanted feet sink into such gaps, and the walk finds that.
            if !B::MEETS_CORNERS && self.passes_gap(body.bounds(), to.bounds(), floor)? {
                return Ok(true);
            }
            (body, floor) = (to, next);
            left = if walked.moved.wall { Fx::ZERO } else { left.saturating_sub(way) };
        }
        Ok(false)
    }

    fn walk<B: Body>(&self, body: &B, way: Fx, floor: Support) -> Result<Walked<B>, MoveError> {
        self.walker.walk(self.level, body, Vec2::new(way, Fx::ZERO), Some(floor))
    }

    /// Whether a box has a place without a floor between two that have one.
    ///
    /// All positions between contain the part that the two have in common. If that part alone
    /// stands, so do they. Else the middle decides: if it stands, one half has enough in common.
    fn passes_gap(&self, mut from: Aabb, mut to: Aabb, floor: Support) -> Result<bool, MoveError> {
        while !self.is_bridged(&from, &to, floor)? {
            let half = (to.lo().x.wrapping_sub(from.lo().x)) / 2;
            if half == 0 {
                return Ok(false);
            }
            let middle = self.walk(&from, Fx::from_bits(half), floor)?;
            if middle.floor.is_none() {
                return Ok(true);
            }
            let middle = middle.moved.body;
            // On a slope a way of a few raw may be rounded to nothing.
            let (a, x, b) = (from.lo().x, middle.lo().x, to.lo().x);
            if x <= a.min(b) || x >= a.max(b) {
                return Ok(false);
            }
            if self.is_bridged(&from, &middle, floor)? {
                from = middle;
            } else {
                to = middle;
            }
        }
        Ok(false)
    }

    /// Whether the part of a box that is also over the ground below another place stands.
    fn is_bridged(&self, from: &Aabb, to: &Aabb, floor: Support) -> Result<bool, MoveError> {
        let (lo, hi) = (from.lo().x.max(to.lo().x), from.hi().x.min(to.hi().x));
        if lo >= hi {
            return Ok(false);
        }
        let common = Aabb::from_raw_unchecked(Raw { x: lo, y: from.lo().y }, Raw { x: hi, y: from.hi().y });
        Ok(self.walk(&common, Fx::ZERO, floor)?.floor.is_some())
    }
}
