//! What a character looks for before it moves: corners that it can pass, and ledges.

use super::character::refused;
use super::feel::{Input, Outcome};
use super::{Body, Character, SlopeSpeed};
use crate::error::RangeError;
use crate::num::{Fx, Vec2};
use crate::world::World;

impl<B: Body> Character<B> {
    /// Moves the character aside by at most `reach`, if it rises and would hit a corner that it can
    /// pass from there: *corner correction*. Returns whether it moved.
    ///
    /// Call it before [`step`](Self::step) or [`step_on`](Self::step_on), with the same input. It
    /// looks at the velocity that this step will start with, as [`Mover::assist`](crate::Mover::assist) does. With moving
    /// solids, pass the level [`Joined`](crate::Joined) with them.
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
        // Level, it only makes sure of the numbers.
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

    /// Whether the floor ends ahead: whether it would fall if it walked on by `far` and its own
    /// width. If the answer is `false`, its front can go on by `far`, and stays on the floor. The
    /// sign of `far` is the direction.
    ///
    /// **How far.** A patrol that turns a frame later goes on by the way of that frame and by its
    /// braking distance. If its speed is then `v`, pass `v + v * v / (2 * a)` with the
    /// [`Feel::acceleration`](crate::Feel::acceleration) `a`, and the sign of its direction. Then its front never leaves
    /// the floor. If `a` is at least `v`, it stops in one frame, and `v` is enough. The chapter on
    /// walkers in the guide has the program, also for short platforms.
    ///
    /// Slopes, steps and ground that falls by at most [`Feel::snap`](crate::Feel::snap) are no ledges, and neither
    /// are gaps that it walks over. It looks in steps of five eighths of the snap. A gap that is
    /// wider than the body by less than that counts only if one of them ends over it: where a level
    /// has such gaps, ask in every frame. One-way floors are floors. In the air the answer is
    /// `false`.
    ///
    /// Cost: a [`Walker::walk`](crate::Walker::walk) for each of these steps, and at most sixteen: four for a body of 10 units at a speed of 1. That is more than all else that a
    /// patrol does in a frame. To save it, ask in every `n`-th frame, with `far` larger by
    /// `(n - 1) * v`. If `far` and the width are more than ten times the snap, the steps are
    /// longer, and slopes that lead down may count as ledges: raise the snap.
    ///
    /// ```
    /// use tilesat::{Aabb, Character, Feel, Input, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'=', TileKind::ONE_WAY_UP);
    /// let level = TileMap::from_ascii("........\n.=====..", &KINDS)?; // from x = 16 to 96
    /// let body = Aabb::new(Vec2::from_ints(30, 2), Vec2::from_ints(40, 16))?;
    /// let mut enemy = Character::new(body, level.bounds(), Feel::DEFAULT);
    /// // A unit for a frame, and at most a unit to brake.
    /// let (mut run, mut turns) = (fx!(1), 0);
    /// for _ in 0..400 {
    ///     let step = enemy.step(&level, Input { run, ..Input::default() })?;
    ///     if step.wall || enemy.ledge_ahead(&level, run * 2)? {
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
        let (mut body, mut floor, mut left) = (self.body, self.floor, way);
        while floor.is_some() && left > 0 {
            let way = left.min(part);
            let velocity = Vec2::new(if far < 0 { way.saturating_neg() } else { way }, Fx::ZERO);
            let walked = match walker.walk(level, &body, velocity, floor) {
                Ok(walked) => walked,
                Err(e) => return Ok(refused(e)? == Outcome::OutOfLevel),
            };
            (body, floor) = (walked.moved.body, walked.floor);
            left = if walked.moved.wall { Fx::ZERO } else { left.saturating_sub(way) };
        }
        Ok(self.floor.is_some() && floor.is_none())
    }
}
