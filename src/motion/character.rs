//! The hero of a platformer: one call per frame, built from [`Walker`], [`Mover::ride`] and
//! [`Joined`].

use super::feel::{Feel, Input};
use super::{Body, Hits, MoveError, Mover, Ride, Support, Walked, Walker};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, Fx, Vec2};
use crate::shape::Aabb;
use crate::world::{Joined, Solid, Solids, World};

/// The state of a character after one frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outcome {
    /// It moved, or stood.
    #[default]
    Moved,
    /// A solid pressed it against something, and it stayed where it was: see [`Ride::Squashed`].
    Squashed {
        /// The key of the solid.
        by: u16,
        /// Out of that solid, toward the body.
        normal: Axis,
    },
    /// It overlaps the level and did not move: a door closed on it, or a solid that squashed it has
    /// not passed yet.
    Stuck,
    /// It is entirely below its limits, or beside them. It may fly above them.
    OutOfLevel,
}

/// What happened to a character in one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[must_use = "the outcome says whether the character lives"]
#[expect(clippy::struct_excessive_bools, reason = "independent answers, each asked by name")]
// Words first, as in a `Hit`.
#[repr(C)]
pub struct Step {
    /// The hits of the frame.
    pub hits: Hits,
    /// The state after the frame.
    pub outcome: Outcome,
    /// Whether it jumped.
    pub jumped: bool,
    /// Whether it landed on a floor.
    pub landed: bool,
    /// Whether a wall blocks it.
    pub wall: bool,
    /// Whether its head hit a ceiling.
    pub ceiling: bool,
    /// The flags of all tiles, segments and solids that it hit, or-ed.
    pub flags: u8,
}

impl Step {
    const fn nothing(outcome: Outcome) -> Self {
        Self { outcome, jumped: false, landed: false, wall: false, ceiling: false, flags: 0, hits: Hits::none() }
    }
}

/// The hero of a platformer: it runs, jumps, walks on slopes and steps, drops through platforms and
/// rides on [`Solid`]s.
///
/// One call per frame does all of it: [`step`](Self::step), or [`step_on`](Self::step_on) if solids
/// move. Each links only the code that it uses. `B` is the body: an [`Aabb`], a
/// [`Circle`](crate::Circle), or a [`Capsule`](crate::Capsule). Plain data: a copy is a snapshot.
///
/// ```
/// use tilesat::{Aabb, Character, Feel, Input, Outcome, TileKind, TileKinds, TileMap, Vec2, fx};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let level = TileMap::from_ascii("........\n........\n####....", &KINDS)?;
/// let limits = Aabb::new(level.origin(), level.grid().end())?;
///
/// let body = Aabb::new(Vec2::from_ints(20, 10), Vec2::from_ints(30, 24))?;
/// let mut hero = Character::new(body, limits, Feel::DEFAULT);
/// let right = Input { run: fx!(2), ..Input::default() };
/// while hero.step(&level, right)?.outcome == Outcome::Moved {
///     // It lands, runs to the ledge, and falls.
/// }
/// assert!(hero.body().min().y > 48); // the frame in which the whole body is below the level
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// If you need another rule, call the pieces yourself: [`Walker::walk`], [`Mover::ride`],
/// [`Solid::move_all`], [`Joined`].
#[doc(alias = "CharacterBody2D")]
#[doc(alias = "KinematicCharacterController")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Character<B = Aabb> {
    /// Units per frame. Change it to throw the character: a spring sets `velocity.y`.
    pub velocity: Vec2,
    /// How it moves.
    pub feel: Feel,
    pub(super) body: B,
    pub(super) limits: Aabb,
    pub(super) floor: Option<Support>,
    /// The motion of the solid that it jumped off. Seen from there, its flight is that on still
    /// ground.
    pub(super) base: Vec2,
    /// Whether the button was down in the last frame.
    pub(super) held: bool,
    /// Whether it rises from its own jump.
    pub(super) jumps: bool,
    /// For how many more frames a press of the button counts.
    pub(super) wish: u8,
    /// Frames since it stood; the largest number after a jump.
    pub(super) away: u8,
    /// The side of the last wall, -1 or 1, and how many frames ago it was there.
    pub(super) wall: i8,
    pub(super) wall_age: u8,
}

/// The plan of a frame: the velocity, and the walker that will make it.
struct Plan {
    walker: Walker,
    /// The motion still to make in this frame.
    velocity: Vec2,
    /// The part of the motion that a solid has already made.
    made: Vec2,
    jumped: bool,
}

impl<B: Body> Character<B> {
    /// A character in the air. `limits` is usually the level's box. Once the body is outside of it
    /// at the sides or below, [`step`](Self::step) returns [`Outcome::OutOfLevel`].
    #[must_use]
    pub const fn new(body: B, limits: Aabb, feel: Feel) -> Self {
        Self {
            velocity: Vec2::ZERO,
            feel,
            body,
            limits,
            floor: None,
            base: Vec2::ZERO,
            held: false,
            jumps: false,
            wish: 0,
            away: u8::MAX,
            wall: 0,
            wall_age: u8::MAX,
        }
    }

    /// Puts the character at another position, in the air and at rest. Checks nothing: if it is in
    /// the solid, the next step returns [`Outcome::Stuck`].
    pub fn place(&mut self, body: B) {
        *self = Self { held: self.held, ..Self::new(body, self.limits, self.feel) };
    }

    /// The body at its current position.
    #[must_use]
    pub const fn body(&self) -> &B {
        &self.body
    }

    /// The floor that it stands on.
    #[must_use]
    pub const fn floor(&self) -> Option<Support> {
        self.floor
    }

    /// Whether it stands on a floor.
    #[doc(alias = "is_on_floor")]
    #[doc(alias = "grounded")]
    #[must_use]
    pub const fn on_floor(&self) -> bool {
        self.floor.is_some()
    }

    /// The key of the solid that it stands on.
    #[must_use]
    pub const fn ridden(&self) -> Option<u16> {
        match self.floor {
            Some(floor) => Solids::key_of(floor.cell),
            None => None,
        }
    }

    /// Moves the character for one frame in a level without moving solids.
    ///
    /// Cost: that of [`Walker::walk`].
    ///
    /// # Errors
    /// [`RangeError`] if a speed or the body's half extent is not below 4096 units, or the
    /// [`Feel`]'s snap or step is negative or not below that. The character is then unchanged.
    pub fn step<W: World>(&mut self, level: &W, input: Input) -> Result<Step, RangeError> {
        self.step_carried(level, input, Vec2::ZERO)
    }

    /// The second half of [`step_on`](Self::step_on), in a level [`Joined`] with the solids at
    /// their new positions. `carry` is the motion that [`ride`](Self::ride) returned, whose example
    /// shows both.
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

    /// Moves the character for one frame among moving solids. They carry or push it, then all go by
    /// their [motions](Solid::with_motion), and then the character walks.
    ///
    /// When the call returns, all solids have moved, even if it returns an error. With several
    /// characters, call [`ride`](Self::ride) for each, then [`Solid::move_all`], then
    /// [`step_carried`](Self::step_carried) for each.
    ///
    /// A jump off a solid adds the solid's motion. Seen from a solid that keeps its motion, the
    /// flight is that on still ground. In the frame of the jump the character moves by its own
    /// velocity only.
    ///
    /// Cost: [`Mover::ride`] and [`Walker::walk`] in a [`Joined`] level.
    ///
    /// ```
    /// use tilesat::{Aabb, Character, Feel, Input, Outcome, Solid, TileKinds, TileMap, Vec2};
    /// let level = TileMap::from_ascii("....\n....", &TileKinds::EMPTY)?;
    /// let limits = Aabb::new(level.origin(), level.grid().end())?;
    /// let boxed = |x, y, w, h| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h));
    /// let mut lift = [Solid::new(boxed(0, 24, 48, 4)?, 7)?];
    /// let mut hero = Character::new(boxed(20, 10, 10, 14)?, limits, Feel::DEFAULT);
    /// for _ in 0..3 {
    ///     lift[0] = lift[0].with_motion(Vec2::from_ints(1, 0))?; // for one frame
    ///     assert!(hero.step_on(&level, &mut lift, Input::default())?.outcome == Outcome::Moved);
    /// }
    /// assert_eq!((hero.ridden(), hero.body().min()), (Some(7), Vec2::from_ints(23, 10)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn step_on<W: World>(&mut self, level: &W, solids: &mut [Solid], input: Input) -> Result<Step, RangeError> {
        let mut next = *self;
        // Both calls use one type of level, which links the mover once.
        let nothing = Solids::new(&[]);
        let ridden = next.ride(&Joined::new(level, &nothing), solids, input.drop);
        Solid::move_all(solids);
        let (outcome, carry) = ridden?;
        let step = if outcome == Outcome::Moved {
            next.step_carried(&Joined::new(level, &Solids::new(solids)), input, carry)?
        } else {
            Step::nothing(outcome)
        };
        *self = next;
        Ok(step)
    }

    /// The first half of [`step_on`](Self::step_on): moves the character as far as the solids carry
    /// or push it. The solids are still at their old positions.
    ///
    /// Returns the outcome and a motion: that of the solid that it stood on, or in the air how far
    /// it was pushed.
    ///
    /// ```
    /// use tilesat::{Aabb, Character, Feel, Input, Joined, Outcome, Solid, Solids, TileKinds, TileMap, Vec2};
    /// let level = TileMap::from_ascii("....\n....", &TileKinds::EMPTY)?;
    /// let limits = Aabb::new(level.origin(), level.grid().end())?;
    /// let lift = Solid::new(Aabb::new(Vec2::from_ints(0, 20), Vec2::from_ints(40, 24))?, 7)?;
    /// let mut solids = [lift.with_motion(Vec2::from_ints(1, 0))?];
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 10), Vec2::from_ints(x + 8, 20));
    /// let mut heroes = [4, 24].map(|x| Character::new(at(x).unwrap(), limits, Feel::DEFAULT));
    /// for _ in 0..4 {
    ///     let mut carries = [Vec2::ZERO; 2];
    ///     for (hero, carry) in heroes.iter_mut().zip(&mut carries) {
    ///         let (outcome, by) = hero.ride(&level, &solids, false)?;
    ///         assert_eq!(outcome, Outcome::Moved);
    ///         *carry = by;
    ///     }
    ///     Solid::move_all(&mut solids);
    ///     let moved = solids.map(|solid| solid.with_motion(Vec2::from_ints(1, 0)).unwrap());
    ///     for (hero, carry) in heroes.iter_mut().zip(carries) {
    ///         hero.step_carried(&Joined::new(&level, &Solids::new(&moved)), Input::default(), carry)?;
    ///     }
    ///     solids = moved;
    /// }
    /// assert_eq!(heroes.map(|hero| hero.body().min()), [Vec2::from_ints(8, 10), Vec2::from_ints(28, 10)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn ride<W: World>(&mut self, level: &W, solids: &[Solid], drop: bool) -> Result<(Outcome, Vec2), RangeError> {
        let follow = if self.floor.is_some() { self.feel.snap } else { self.falls().saturating_add(self.pull()) };
        let ridden = self.mover().with_drop_through(drop).ride(level, solids, &self.body, follow.max(Fx::ZERO));
        match ridden {
            Ok(ridden) => {
                self.body = ridden.body;
                let outcome = match ridden.ride {
                    Ride::Squashed { by, normal } => Outcome::Squashed { by, normal },
                    _ => Outcome::Moved,
                };
                Ok((outcome, if self.floor.is_some() { ridden.carry } else { ridden.motion }))
            }
            Err(e) => Ok((refused(e)?, Vec2::ZERO)),
        }
    }

    const fn mover(&self) -> Mover {
        Mover::platformer(if self.feel.falls_to_larger_y() { Axis::NEG_Y } else { Axis::Y })
    }

    /// The magnitude of gravity.
    const fn pull(&self) -> Fx {
        if self.feel.falls_to_larger_y() { self.feel.gravity } else { self.feel.gravity.saturating_neg() }
    }

    /// The speed of its fall.
    const fn falls(&self) -> Fx {
        if self.feel.falls_to_larger_y() { self.velocity.y } else { self.velocity.y.saturating_neg() }
    }

    /// Timers, gravity, jumps and running: the velocity of this frame.
    fn plan(&mut self, input: Input, carry: Vec2) -> Result<Plan, RangeError> {
        let feel = self.feel;
        let stands = self.floor.is_some();
        self.away = if stands { 0 } else { self.away.saturating_add(1) };
        self.wall_age = self.wall_age.saturating_add(1);
        self.wish = if input.jump && !self.held { feel.buffer.saturating_add(1) } else { self.wish };
        self.held = input.jump;

        let rate = if stands { feel.acceleration } else { feel.air_acceleration };
        let (base, base_fall) =
            (self.base, if feel.falls_to_larger_y() { self.base.y } else { self.base.y.saturating_neg() });
        // Off a sinking solid it falls faster by the solid's speed. Above a rising one it falls no
        // slower.
        let fastest = feel.fall.saturating_add(base_fall.max(Fx::ZERO));
        let mut run = toward(self.velocity.x.saturating_sub(base.x), input.run, rate);
        let against_wall = self.wall_age <= 1 && input.run.signum() == Fx::from(self.wall) && self.wall != 0;
        let limit = feel.wall_slide.filter(|_| against_wall).map_or(fastest, |slide| slide.min(feel.fall));
        let mut fall = self.falls().saturating_add(self.pull()).min(limit).saturating_sub(base_fall);
        let mut jumped = false;

        let off_wall = feel.wall_jump.filter(|_| self.wall != 0 && self.wall_age <= feel.coyote.saturating_add(1));
        let off_floor = stands || self.away <= feel.coyote;
        if self.wish > 0 && (off_floor || off_wall.is_some()) {
            fall = feel.jump.saturating_neg();
            self.base = if stands { carry } else { Vec2::ZERO };
            if let Some(push) = off_wall.filter(|_| !off_floor) {
                run = if self.wall > 0 { push.saturating_neg() } else { push };
            }
            (self.wish, self.away, self.wall, self.jumps, jumped) = (0, u8::MAX, 0, true, true);
        }
        self.wish = self.wish.saturating_sub(1);
        self.jumps &= fall < 0;
        if self.jumps && !input.jump {
            fall = fall.max(feel.jump_cut.saturating_neg());
        }
        if input.drop {
            self.away = u8::MAX;
        }

        let y = if feel.falls_to_larger_y() { fall } else { fall.saturating_neg() };
        let walker = Walker::new(self.mover().with_drop_through(input.drop)).with_slope_speed(feel.slope_speed);
        let walker = walker.with_snap(feel.snap)?.with_step(feel.step)?;
        let velocity = Vec2::new(run, y) + self.base;
        let made = match (stands, jumped) {
            (true, true) => carry,
            (true, false) => Vec2::ZERO,
            // A push in its own direction makes a part of its way.
            (false, _) => Vec2::new(shared(carry.x, velocity.x), shared(carry.y, velocity.y)),
        };
        Ok(Plan { walker, velocity: velocity - made, made, jumped })
    }

    /// Applies the result of a walk.
    fn settle(&mut self, plan: &Plan, walked: Result<Walked<B>, MoveError>) -> Result<Step, RangeError> {
        let walked = match walked {
            Ok(walked) => walked,
            Err(e) => {
                let outcome = refused(e)?;
                (self.velocity, self.floor, self.base) = (Vec2::ZERO, None, Vec2::ZERO);
                return Ok(Step::nothing(outcome));
            }
        };
        let moved = &walked.moved;
        let landed = self.floor.is_none() && walked.floor.is_some();
        (self.body, self.floor) = (moved.body, walked.floor);
        // The parts of the velocity that nothing changed go on. On a solid, the velocity counts as
        // seen from the solid again.
        let (now, was) = (moved.velocity, plan.velocity);
        let kept = |v: Vec2| {
            let part = |now, was, v| if now == was { v } else { Fx::ZERO };
            Vec2::new(part(now.x, was.x, v.x), part(now.y, was.y, v.y))
        };
        let base = kept(self.base);
        (self.base, self.velocity) = match walked.floor {
            None => (base, now + kept(plan.made)),
            Some(floor) if Solids::key_of(floor.cell).is_some() => (Vec2::ZERO, Vec2::new(now.x - base.x, now.y)),
            Some(_) => (Vec2::ZERO, now),
        };
        self.jumps &= walked.floor.is_none();
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

    fn is_out(&self) -> bool {
        let (bounds, lo, hi) = (self.body.bounds(), self.limits.lo(), self.limits.hi());
        let beside = bounds.hi().x < lo.x || bounds.lo().x > hi.x;
        beside || if self.feel.falls_to_larger_y() { bounds.lo().y > hi.y } else { bounds.hi().y < lo.y }
    }
}

/// The outcome that a refused motion means. The remaining errors are the caller's.
fn refused(e: MoveError) -> Result<Outcome, RangeError> {
    match e {
        MoveError::Stuck(_) => Ok(Outcome::Stuck),
        // The end of the domain.
        MoveError::Range(RangeError { what: Quantity::X | Quantity::Y, .. }) => Ok(Outcome::OutOfLevel),
        MoveError::Range(e) => Err(e),
    }
}

/// The part that two motions have in common.
fn shared(a: Fx, b: Fx) -> Fx {
    if a < 0 { a.max(b).min(Fx::ZERO) } else { a.min(b).max(Fx::ZERO) }
}

/// A speed, changed by at most `rate` toward another.
fn toward(speed: Fx, target: Fx, rate: Fx) -> Fx {
    if speed < target { speed.saturating_add(rate).min(target) } else { speed.saturating_sub(rate).max(target) }
}
