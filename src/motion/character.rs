//! The hero of a platformer: one call per frame, built from [`Walker`].

use super::feel::{Feel, Input, OnLeave, Outcome, Step};
use super::{Body, MoveError, Mover, Support, Walked, Walker};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, Fx, Raw, Vec2};
use crate::shape::Aabb;
use crate::world::World;

/// The hero of a platformer: it runs, jumps, walks on slopes and steps, drops through platforms and
/// rides on [`Solid`](crate::Solid)s, or on solids of
/// [any convex shape](crate::world::ConvexSolid).
///
/// One call per frame does all of it: [`step`](Self::step), or [`step_on`](Self::step_on) if solids
/// move. Each links only the code that it uses. `B` is the [body](crate::Body): an [`Aabb`], a
/// [`Circle`](crate::Circle), a [`Capsule`](crate::Capsule), a turned box or a polygon. Plain data:
/// a copy is a snapshot.
///
/// ```
/// use tilesat::{Aabb, Character, Feel, Input, Outcome, TileKind, TileKinds, TileMap, Vec2, fx};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let level = TileMap::from_ascii("........\n........\n####....", &KINDS)?;
/// let limits = Aabb::new(level.origin(), level.grid().end())?;
///
/// let body = Aabb::new(Vec2::from_ints(20, 10), Vec2::from_ints(30, 24))?;
/// let mut hero = Character::new(body, limits, Feel::DEFAULT);
/// let right = Input::running(fx!(2));
/// while hero.step(&level, right)?.outcome == Outcome::Moved {
///     // It lands, runs to the ledge, and falls.
/// }
/// assert!(hero.body().min().y > 48); // the frame in which the whole body is below the level
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// If you need another rule, call the pieces yourself: [`Walker::walk`], [`Mover::ride`],
/// [`Solid::move_all`](crate::Solid::move_all), [`Joined`](crate::Joined).
#[doc(alias("CharacterBody2D", "player", "enemy", "knockback", "dash", "spring"))]
#[doc(alias = "KinematicCharacterController")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Character<B = Aabb> {
    /// Units per frame. Change it to throw the character: a spring or a stomp sets `velocity.y`, a
    /// ladder does in each frame, with a [`Feel::gravity`] of 0. The next [`step`](Self::step) adds
    /// gravity first: a launch at -4 rises by 3.75 in its first frame. (A jump at 4 rises by 4.)
    ///
    /// If you make it rise faster than the last step left it, it leaves its floor as by a jump, and
    /// has no coyote time. No release of the button cuts the rise.
    ///
    /// On a moving solid it is the velocity seen from there. However the character leaves it (by a
    /// jump, a drop, a launch, or over its edge), the solid's motion is added, and stays as
    /// [`Feel::on_leave`] says.
    pub velocity: Vec2,
    /// How it moves.
    pub feel: Feel,
    pub(super) body: B,
    pub(super) limits: Aabb,
    pub(super) floor: Option<Support>,
    /// The motion of the solid that it left. Seen from there, its flight is that on still ground.
    pub(super) base: Vec2,
    /// How far it still falls through one-way floors below the solid that it dropped from.
    pub(super) through: Fx,
    /// The velocity along y that the last step left: the caller has launched it if it rises faster.
    pub(super) left: Fx,
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
pub(super) struct Plan {
    walker: Walker,
    /// The motion still to make in this frame.
    pub(super) velocity: Vec2,
    /// The part of the motion that a solid has already made.
    made: Vec2,
    jumped: bool,
    /// Whether it drops through the one-way floor that it stands on.
    drops: bool,
    /// Whether it stands and stays a walker: the velocity then has no part along "up".
    walks: bool,
}

impl<B: Body> Character<B> {
    /// A character in the air. `limits` is usually the level's box. Once the body is outside of it
    /// at the sides or below, [`step`](Self::step) returns [`Outcome::OutOfLevel`]. Above is
    /// allowed, so a hero can jump over a side wall that ends there.
    #[must_use]
    pub const fn new(body: B, limits: Aabb, feel: Feel) -> Self {
        Self {
            velocity: Vec2::ZERO,
            feel,
            body,
            limits,
            floor: None,
            base: Vec2::ZERO,
            through: Fx::ZERO,
            left: Fx::ZERO,
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

    /// Takes the character into another [`Room`](crate::world::Room): its position changes by `by`,
    /// and its limits become those of the room. Velocity, floor and timers go on.
    ///
    /// Call it between two steps, with what [`Rooms::next`](crate::world::Rooms::next) or
    /// [`Room::next_of`](crate::world::Room::next_of) returns. Checks nothing in the level: both
    /// rooms hold the tiles around their border.
    ///
    /// ```
    /// use tilesat::{Aabb, Blocks, Character, Feel, Fx, Input, Room, Rooms, TileKind, TileKinds, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);
    /// let mut tiles = [0; 120];
    /// tiles[80..].fill(1); // 40 columns with a floor, in rooms of 20
    /// const APRON: u16 = Room::<Blocks>::apron_for(fx!(16), fx!(16), fx!(8));
    /// let world = Rooms::<Blocks>::of(&tiles, (40, 3), fx!(16), &KINDS, (20, 3), APRON)?;
    /// let mut room = world.room(0, 0).unwrap();
    ///
    /// let body = Aabb::new(Vec2::from_ints(290, 16), Vec2::from_ints(300, 32))?;
    /// let mut hero = Character::new(body, room.map().bounds(), Feel::DEFAULT);
    /// for _ in 0..30 {
    ///     let _ = hero.step(room.map(), Input::running(fx!(2)))?;
    ///     if let Some((next, by)) = world.next(&room, hero.body().min()) {
    ///         hero.translate(by, next.map().bounds())?;
    ///         room = next;
    ///     }
    /// }
    /// assert_eq!((room.first(), hero.velocity.x), ((20, 0), fx!(2)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the body would leave the [domain](crate::num::DOMAIN). The character is
    /// then unchanged.
    pub fn translate(&mut self, by: Vec2, limits: Aabb) -> Result<(), RangeError> {
        self.body.bounds().translated(by)?;
        self.body = self.body.shifted(Raw::of(by));
        self.limits = limits;
        Ok(())
    }

    /// Changes the body where it stands, and keeps everything else: to crouch, to grow, to nudge
    /// it. Returns whether there is room. If the new body would overlap the level, nothing changes.
    ///
    /// Keep the feet where they are, or the character falls. With moving solids, pass the level
    /// [`Joined`](crate::Joined) with them.
    ///
    /// Cost: one overlap test.
    ///
    /// ```
    /// use tilesat::{Aabb, Character, Feel, Fx, Input, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii(".....\n..##.\n.....\n#####", &KINDS)?; // a low passage
    /// let tall = Aabb::new(Vec2::from_ints(4, 24), Vec2::from_ints(14, 48))?;
    /// let mut hero = Character::new(tall, level.bounds(), Feel::DEFAULT);
    /// let sized = |hero: &Character, height: Fx| {
    ///     let (lo, hi) = (hero.body().min(), hero.body().max());
    ///     Aabb::new(Vec2::new(lo.x, hi.y - height), hi) // the feet stay
    /// };
    /// let low = sized(&hero, fx!(14))?;
    /// assert!(hero.set_body(&level, low)); // it crouches
    /// for _ in 0..20 {
    ///     let _ = hero.step(&level, Input::running(fx!(1)))?;
    /// }
    /// let up = sized(&hero, fx!(24))?;
    /// assert!(!hero.set_body(&level, up)); // under the ceiling it has to stay low
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias("crouch", "resize"))]
    #[must_use = "without room, nothing changes"]
    pub fn set_body<W: World>(&mut self, level: &W, body: B) -> bool {
        let fits = !body.overlaps_world(level);
        if fits {
            self.body = body;
        }
        fits
    }

    /// The body at its current position.
    #[must_use]
    pub const fn body(&self) -> &B {
        &self.body
    }

    /// Moves the character for one frame in a level without moving solids.
    ///
    /// Cost: that of [`Walker::walk`].
    ///
    /// # Errors
    /// [`RangeError`] if a speed or the body's half extent is not below 4096 units, or the
    /// [`Feel`]'s snap or step is negative or not below that. Always if the body cannot move: a
    /// slanted capsule, or one without radius. The character is then unchanged.
    pub fn step<W: World>(&mut self, level: &W, input: Input) -> Result<Step, RangeError> {
        self.step_carried(level, input, Vec2::ZERO)
    }

    /// The second half of [`step_on`](Self::step_on), in a level [`Joined`](crate::Joined) with the
    /// solids at their new positions. `carry` is the motion that [`ride`](Self::ride) returned, whose
    /// example shows both.
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

    pub(super) const fn mover(&self) -> Mover {
        Mover::platformer(if self.feel.falls_to_larger_y() { Axis::NEG_Y } else { Axis::Y })
    }

    /// The magnitude of gravity.
    pub(super) const fn pull(&self) -> Fx {
        if self.feel.falls_to_larger_y() { self.feel.gravity } else { self.feel.gravity.saturating_neg() }
    }

    /// A component along y as a speed of falling.
    pub(super) const fn downward(&self, y: Fx) -> Fx {
        if self.feel.falls_to_larger_y() { y } else { y.saturating_neg() }
    }

    /// The speed of its fall.
    pub(super) const fn falls(&self) -> Fx {
        self.downward(self.velocity.y)
    }

    /// Timers, gravity, launches, jumps and running: the velocity of this frame.
    pub(super) fn plan(&mut self, input: Input, carry: Vec2) -> Result<Plan, RangeError> {
        let feel = self.feel;
        let stands = self.floor.is_some();
        self.away = if stands { 0 } else { self.away.saturating_add(1) };
        self.wall_age = self.wall_age.saturating_add(1);
        self.wish = if input.jump && !self.held { feel.buffer.saturating_add(1) } else { self.wish };
        self.held = input.jump;

        let rate = if stands { feel.acceleration } else { feel.air_acceleration };
        let keeps = stands || feel.on_leave == OnLeave::Keep;
        let base = if keeps { self.base } else { Vec2::ZERO };
        let base_fall = self.downward(base.y);
        // Off a sinking solid it falls faster by the solid's speed. Above a rising one it falls no
        // slower.
        let fastest = feel.fall.saturating_add(base_fall.max(Fx::ZERO));
        let mut run = toward(self.velocity.x.saturating_sub(base.x), input.run, rate);
        let against_wall = self.wall_age <= 1 && input.run.signum() == Fx::from(self.wall) && self.wall != 0;
        let limit = feel.wall_slide.filter(|_| against_wall).map_or(fastest, |slide| slide.min(feel.fall));
        let falls = self.falls().saturating_add(self.pull()).min(limit);
        let mut fall = falls.saturating_sub(base_fall);
        let (mut jumped, launched) = (false, fall < 0 && self.falls() < self.downward(self.left));
        if launched {
            (self.away, self.jumps) = (u8::MAX, false);
        }
        if stands {
            self.base = carry; // if it leaves the floor in this frame
        }

        let drops = input.drop && self.floor.is_some_and(|floor| floor.one_way);
        let can_jump = self.wish > 0 && !drops;
        let off_floor = !launched && (stands || self.away <= feel.coyote);
        let off_wall = feel.wall_jump.filter(|_| self.wall != 0 && self.wall_age <= feel.coyote.saturating_add(1));
        if can_jump && (off_floor || off_wall.is_some()) {
            // A jump takes no upward speed away, which a spring or a ramp gave. It is cut only if
            // its own speed is the larger one.
            if let Some(push) = off_wall.filter(|_| !off_floor) {
                run = if self.wall > 0 { push.saturating_neg() } else { push };
                (self.base, fall) = (Vec2::ZERO, falls);
            }
            let jump = feel.jump.saturating_neg();
            self.jumps = fall >= jump;
            fall = fall.min(jump);
            (self.wish, self.away, self.wall, jumped) = (0, u8::MAX, 0, true);
        }
        if stands && jumped && feel.on_leave == OnLeave::AddUpward && self.downward(carry.y) > 0 {
            self.base.y = Fx::ZERO;
        }
        self.wish = self.wish.saturating_sub(1);
        self.jumps &= fall < 0;
        if self.jumps && !input.jump {
            fall = fall.max(feel.jump_cut.saturating_neg());
        }
        if input.drop {
            self.away = u8::MAX;
        }
        let walker = self.walker(self.passes(input.drop))?;
        // A solid that sinks comes below the feet again, before the body falls. Farther below it
        // than it sinks in a frame, the drop is over. It sinks by at most the snap; the rest is for
        // one that speeds up.
        if drops && self.ridden().is_some() {
            let sinks = self.downward(carry.y).max(Fx::ZERO);
            self.through = feel.snap.saturating_add(sinks).saturating_add(Fx::DELTA);
        }
        self.through = if fall > 0 { self.through.saturating_sub(fall).max(Fx::ZERO) } else { Fx::ZERO };

        let base = if keeps { self.base } else { Vec2::ZERO };
        let velocity = Vec2::new(run, self.downward(fall)) + base;
        // A push in its own direction makes a part of its way. So does the solid that it left, if
        // that comes below its feet in the frame in which it lands.
        let part = |carry, velocity, base| farther(shared(carry, velocity), shared(carry, base));
        let pushed = Vec2::new(part(carry.x, velocity.x, base.x), part(carry.y, velocity.y, base.y));
        let made = if stands { carry } else { pushed };
        let walks = stands && !(jumped || launched || drops);
        Ok(Plan { walker, velocity: velocity - made, made, jumped, drops, walks })
    }

    /// Whether it passes one-way floors, if the button for that is down or not.
    pub(super) const fn passes(&self, drop: bool) -> bool {
        drop || self.through.to_bits() > 0
    }

    pub(super) fn walker(&self, drop: bool) -> Result<Walker, RangeError> {
        let Feel { snap, step, slope_speed, .. } = self.feel;
        let walker = Walker::new(self.mover().with_drop_through(drop)).with_slope_speed(slope_speed);
        walker.with_snap(snap)?.with_step(step)
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
        // The parts of the velocity that nothing changed go on. On a solid, the velocity counts as
        // seen from the solid again.
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

    fn is_out(&self) -> bool {
        let (bounds, lo, hi) = (self.body.bounds(), self.limits.lo(), self.limits.hi());
        let beside = bounds.hi().x < lo.x || bounds.lo().x > hi.x;
        beside || if self.feel.falls_to_larger_y() { bounds.lo().y > hi.y } else { bounds.hi().y < lo.y }
    }
}

/// The outcome that a refused motion means. The remaining errors are the caller's.
pub(super) fn refused(e: MoveError) -> Result<Outcome, RangeError> {
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

/// The longer one of two motions.
fn farther(a: Fx, b: Fx) -> Fx {
    if a.unsigned_abs() < b.unsigned_abs() { b } else { a }
}

/// A speed, changed by at most `rate` toward another.
fn toward(speed: Fx, target: Fx, rate: Fx) -> Fx {
    if speed < target { speed.saturating_add(rate).min(target) } else { speed.saturating_sub(rate).max(target) }
}
