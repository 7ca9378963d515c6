//! The hero of a platformer: one call per frame, built from [`Walker`].

use super::feel::{Feel, Input, Outcome, Step};
use super::{Body, MoveError, Mover, Support, Walker};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, Fx, Raw, Vec2};
use crate::shape::Aabb;
use crate::world::World;

/// The hero of a platformer. It runs, jumps, walks on slopes and steps, drops through platforms and
/// rides on [`Solid`](crate::Solid)s, or on solids of [any convex
/// shape](crate::world::ConvexSolid).
///
/// Make one call per frame: [`step`](Self::step), or [`step_on`](Self::step_on) if solids move.
/// Each links only the code that it uses. `B` is the [body](crate::Body): an [`Aabb`], a
/// [`Circle`](crate::Circle), a [`Capsule`](crate::Capsule), an oriented box or a polygon. Plain
/// data: a copy is a snapshot.
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
/// If you need other rules, call the parts yourself: [`Walker::walk`], [`Mover::ride`],
/// [`Solid::move_all`](crate::Solid::move_all), [`Joined`](crate::Joined).
#[doc(alias("CharacterBody2D", "player", "enemy", "knockback", "dash", "spring"))]
#[doc(alias = "KinematicCharacterController")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Character<B = Aabb> {
    /// The velocity, in units per frame. You may change it: a spring or a stomp sets `velocity.y`
    /// once, a ladder in each frame, with a [`Feel::gravity`] of 0. The next [`step`](Self::step)
    /// adds gravity first: a launch at -4 rises by 3.75 in its first frame, a jump at 4 by 4.
    ///
    /// If you set a faster rise than the last step left, the character leaves its floor as by a
    /// jump, without coyote time. Releasing the button does not cut this rise.
    ///
    /// On a moving solid, the velocity is relative to the solid. When the character leaves the
    /// solid (by a jump, a drop, a launch, or over its edge), the solid's motion is added.
    /// [`Feel::on_leave`] says how it is used.
    pub velocity: Vec2,
    /// How it moves.
    pub feel: Feel,
    pub(super) body: B,
    pub(super) limits: Aabb,
    pub(super) floor: Option<Support>,
    pub(super) memory: Memory,
}

/// What it remembers from one frame to the next. If a step is refused, it is put back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Memory {
    /// The motion of the solid that it left, relative to which it flies as from still ground.
    pub(super) base: Vec2,
    /// How far it still falls through one-way floors below the solid that it dropped from.
    pub(super) through: Fx,
    /// The velocity along y that the last step left: the caller has launched it if it rises faster.
    pub(super) left: Fx,
    /// Whether the button was down in the last frame.
    pub(super) held: bool,
    /// Whether it rises from its own jump.
    pub(super) jumps: bool,
    /// For how many more frames a press of the button starts a jump.
    pub(super) wish: u8,
    /// Frames since it stood; the largest number after a jump.
    pub(super) away: u8,
    /// Whether gravity last pulled toward smaller y. It decides where "up" is while it is 0.
    pub(super) flipped: bool,
    /// The side of the last wall, -1 or 1, and how many frames ago it was there.
    pub(super) wall: i8,
    pub(super) wall_age: u8,
}

impl<B: Body> Character<B> {
    /// A character in the air. `limits` is usually the box of the level. Once the body is entirely
    /// beside or below it, [`step`](Self::step) returns [`Outcome::OutOfLevel`]. The body may be
    /// above it, so a hero can jump over a side wall that ends there.
    #[must_use]
    pub const fn new(body: B, limits: Aabb, feel: Feel) -> Self {
        Self {
            velocity: Vec2::ZERO,
            feel,
            body,
            limits,
            floor: None,
            memory: Memory {
                base: Vec2::ZERO,
                through: Fx::ZERO,
                left: Fx::ZERO,
                held: false,
                jumps: false,
                wish: 0,
                away: u8::MAX,
                flipped: feel.gravity.to_bits() < 0,
                wall: 0,
                wall_age: u8::MAX,
            },
        }
    }

    /// Puts the character at another position, in the air and at rest. Checks nothing: if the body
    /// is in the solid, the next step returns [`Outcome::Stuck`].
    pub fn place(&mut self, body: B) {
        let Memory { held, flipped, .. } = self.memory;
        *self = Self::new(body, self.limits, self.feel);
        (self.memory.held, self.memory.flipped) = (held, flipped);
    }

    /// Moves the character into another [`Room`](crate::world::Room). Its position changes by `by`,
    /// and `limits` replaces its limits. Velocity, floor and timers are unchanged.
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

    /// Replaces the body, and keeps everything else: to crouch, to grow, or to nudge it. Returns
    /// whether there is room. If the new body would overlap the level, nothing changes.
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
    /// assert!(!hero.set_body(&level, up)); // no room to stand up under the ceiling
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

    /// The [reference position](Body::position) of the body: the minimum corner of a box, the
    /// centre of a circle.
    #[must_use]
    pub fn position(&self) -> Vec2 {
        self.body.position()
    }

    /// The limits beyond which it is [out of the level](Outcome::OutOfLevel).
    /// [`translate`](Self::translate) sets them, by zero if the character stays where it is.
    #[must_use]
    pub const fn limits(&self) -> Aabb {
        self.limits
    }

    /// Moves the character for one frame in a level without moving solids.
    ///
    /// Cost: one [`Walker::walk`].
    ///
    /// # Errors
    /// [`RangeError`] if a speed or the body's half extent is not below 4096 units. Also if the
    /// [`Feel`]'s snap or step is negative or not below that. Always if the body cannot move, such
    /// as a slanted capsule or one without radius. The character is then unchanged.
    pub fn step<W: World>(&mut self, level: &W, input: Input) -> Result<Step, RangeError> {
        self.step_carried(level, input, Vec2::ZERO)
    }

    pub(super) const fn mover(&self) -> Mover {
        mover(self.falls_to_larger_y())
    }

    /// Whether it falls toward larger y, as on a screen.
    pub(crate) const fn falls_to_larger_y(&self) -> bool {
        match self.feel.gravity.to_bits() {
            0 => !self.memory.flipped,
            pull => pull > 0,
        }
    }

    /// The magnitude of gravity.
    pub(super) const fn pull(&self) -> Fx {
        if self.falls_to_larger_y() { self.feel.gravity } else { self.feel.gravity.saturating_neg() }
    }

    /// A component along y as a speed of falling.
    pub(super) const fn downward(&self, y: Fx) -> Fx {
        if self.falls_to_larger_y() { y } else { y.saturating_neg() }
    }

    /// The speed at which it falls.
    pub(super) const fn falls(&self) -> Fx {
        self.downward(self.velocity.y)
    }

    /// Whether it passes one-way floors, if the button for that is down or not.
    pub(super) const fn passes(&self, drop: bool) -> bool {
        drop || self.memory.through.to_bits() > 0
    }

    pub(super) fn walker(&self, drop: bool) -> Result<Walker, RangeError> {
        self.feel.check_signs()?;
        let Feel { snap, step, slope_speed, .. } = self.feel;
        let walker = Walker::new(self.mover().with_drop_through(drop)).with_slope_speed(slope_speed);
        walker.with_snap(snap)?.with_step(step)
    }

    /// Whether the whole body is outside of its limits, at the sides or below.
    pub(super) fn is_out(&self) -> bool {
        let (bounds, lo, hi) = (self.body.bounds(), self.limits.lo(), self.limits.hi());
        let beside = bounds.hi().x < lo.x || bounds.lo().x > hi.x;
        beside || if self.falls_to_larger_y() { bounds.lo().y > hi.y } else { bounds.hi().y < lo.y }
    }
}

/// The mover of a character that falls toward larger y, or smaller.
pub(super) const fn mover(to_larger_y: bool) -> Mover {
    Mover::platformer(if to_larger_y { Axis::NEG_Y } else { Axis::Y })
}

/// The outcome that a refused motion means. The remaining errors are the caller's.
pub(super) fn refused(e: MoveError) -> Result<Outcome, RangeError> {
    match e {
        MoveError::Stuck(_) => Ok(Outcome::Stuck),
        // The end of the domain.
        MoveError::Range(RangeError { what: Quantity::X | Quantity::Y | Quantity::EndX | Quantity::EndY, .. }) => {
            Ok(Outcome::OutOfLevel)
        }
        MoveError::Range(e) => Err(e),
    }
}
