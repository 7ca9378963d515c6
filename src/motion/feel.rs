//! The input and the results of a character: the player's buttons, the numbers that decide how it
//! moves, and what happened in a frame.

use super::walk::checked;
use super::{Hits, SlopeSpeed};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, Fx};

/// The player's input for one frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Input {
    /// The speed to run at, in units per frame: negative to the left. On a moving solid it is
    /// relative to the solid, and after leaving one as [`Feel::on_leave`] says.
    pub run: Fx,
    /// Whether the jump button is down. The character detects presses and releases itself.
    pub jump: bool,
    /// Whether to drop through one-way floors in this frame. One frame is enough for the floor on
    /// which the character stands. While `drop` stays true, the character passes all one-way floors
    /// that follow. On a one-way floor, `drop` wins over `jump`.
    ///
    /// After one frame of `drop` on a one-way solid, the character keeps passing it. This ends when
    /// its feet are below by [`Feel::snap`] plus the solid's downward motion. Until then the
    /// character passes other one-way floors as well. A lift that speeds up by more than half the
    /// gravity per frame may still catch it.
    pub drop: bool,
}

impl Input {
    /// To run at a speed, without a jump or a drop; 0 to stand. `Input::default()` is that.
    ///
    /// ```
    /// use tilesat::{Fx, Input, fx};
    /// assert_eq!(Input::running(fx!(1.5)), Input { run: fx!(1.5), jump: false, drop: false });
    /// assert_eq!(Input::running(Fx::ZERO), Input::default());
    /// ```
    #[must_use]
    pub const fn running(speed: Fx) -> Self {
        Self { run: speed, jump: false, drop: false }
    }
}

/// How a [`Character`](crate::Character) uses the motion of a [`Solid`](crate::Solid) that it
/// leaves, by a jump or over its edge.
///
/// ```
/// use tilesat::{Aabb, Character, Feel, Fx, Input, Solid, TileKind, TileKinds, TileMap, Vec2, fx, motion::OnLeave};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let level = TileMap::from_ascii("....................\n", &KINDS)?;
/// // It jumps off a lift that moves to the right by 2, and holds left.
/// let flies = |on_leave| -> Result<Fx, Box<dyn std::error::Error>> {
///     let mut lift = [Solid::new(Aabb::new(Vec2::from_ints(60, 100), Vec2::from_ints(120, 106))?, 1)?];
///     let body = Aabb::new(Vec2::from_ints(80, 86), Vec2::from_ints(90, 100))?;
///     let mut hero = Character::new(body, level.bounds(), Feel { on_leave, ..Feel::DEFAULT });
///     for frame in 0..30 {
///         lift[0].set_motion(Vec2::from_ints(2, 0))?;
///         let run = if frame < 4 { fx!(0) } else { fx!(-1.5) };
///         let _ = hero.step_on(&level, &mut lift, Input { run, jump: frame >= 4, drop: false })?;
///     }
///     Ok(hero.velocity.x)
/// };
/// assert_eq!(flies(OnLeave::Keep)?, fx!(0.5)); // -1.5, relative to the lift
/// assert_eq!(flies(OnLeave::Add)?, fx!(-1.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias("platform_on_leave", "lift boost", "inherit velocity"))]
pub enum OnLeave {
    /// The motion is kept until the character lands or meets a wall. Relative to the solid, the
    /// flight is the same as from still ground: a hero that jumps on a train lands where it jumped.
    /// [`Input::run`] is relative to the solid, too.
    #[default]
    Keep,
    /// The motion is added once. Then [`Feel::air_acceleration`] brings the speed to
    /// [`Input::run`], relative to the level.
    Add,
    /// Like [`Add`](Self::Add), but a jump ignores the downward part of the solid's motion, so it
    /// rises as high as from still ground.
    AddUpward,
}

/// How a [`Character`](crate::Character) moves. Lengths are units, times are frames.
///
/// Only `gravity` has a sign. No other number may be negative, so write a jump speed of -4.5 of
/// another engine as 4.5.
///
/// The default suits cells of 16 units at 60 frames per second. A jump rises 42.75 units in 18
/// frames. Change any value, in any frame:
///
/// ```
/// use tilesat::{Feel, fx};
/// const MOON: Feel = Feel { gravity: fx!(0.0625), wall_jump: Some(fx!(2.5)), ..Feel::DEFAULT };
/// # let _ = MOON;
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Feel {
    /// The velocity gained per frame. A positive value pulls toward larger y, as on a screen. A
    /// negative one pulls toward smaller y, and "up" follows. While it is 0, as on a ladder, "up"
    /// stays where it was.
    ///
    /// If you turn it while the character stands, it leaves the floor in the next step. It keeps
    /// its run and the motion of a solid under it. That floor gives no coyote time.
    pub gravity: Fx,
    /// The fastest fall. After leaving a solid that sinks, it is faster by the speed of the solid,
    /// with [`OnLeave::Keep`].
    #[doc(alias("terminal_velocity", "max_fall_speed"))]
    pub fall: Fx,
    /// The speed at which a jump starts. With a gravity of g, a jump of n g rises by g n (n + 1) /
    /// 2 in n frames.
    #[doc(alias("jump_speed", "jump_velocity"))]
    pub jump: Fx,
    /// The speed that a rising jump keeps when the button is released. If it equals `jump`, all
    /// jumps are equally high.
    pub jump_cut: Fx,
    /// For how many frames the body can still jump after it walked off a floor or left a wall. More
    /// than 253 counts as 253.
    #[doc(alias = "coyote_time")]
    pub coyote: u8,
    /// For how many frames after a press the jump may still start. With zero, only in the frame of
    /// the press. 255 counts as 254. If the button is already released at the landing, the jump is
    /// cut from its first frame.
    #[doc(alias = "jump_buffer")]
    pub buffer: u8,
    /// How much the speed changes per frame on a floor, toward [`Input::run`].
    pub acceleration: Fx,
    /// How much the speed changes per frame in the air.
    pub air_acceleration: Fx,
    /// How far the body follows falling ground: [`Walker::with_snap`](crate::Walker::with_snap).
    /// One and a half times the running speed is always enough for tiles.
    pub snap: Fx,
    /// The highest step that the body climbs: [`Walker::with_step`](crate::Walker::with_step). By
    /// default it does not climb a half tile, which is 8 units high with tiles of 16.
    pub step: Fx,
    /// How fast it walks on slopes.
    pub slope_speed: SlopeSpeed,
    /// The speed away from a wall at the start of a wall jump, relative to the level, even if the
    /// wall moves. `None`: no wall jumps. The character must have run against the wall in the last
    /// [`coyote`](Self::coyote) frames. The same wall can be used again, so a small speed lets it
    /// climb a single wall.
    pub wall_jump: Option<Fx>,
    /// The fastest fall while the body runs against a wall, or did so in the last frame. `None`:
    /// the same as elsewhere.
    pub wall_slide: Option<Fx>,
    /// What happens to a solid's motion when the body leaves the solid.
    pub on_leave: OnLeave,
}

impl Feel {
    /// The default.
    ///
    /// | field | value |
    /// |---|---|
    /// | gravity, fastest fall | 0.25, 6 |
    /// | jump, cut to | 4.5, 1.5 |
    /// | coyote, buffer | 5, 5 frames |
    /// | acceleration, in the air | 0.5, 0.25 |
    /// | snap, step | 5, 4 |
    /// | slope speed | constant |
    /// | wall jump, wall slide | off |
    /// | motion of a solid | [kept](OnLeave::Keep) |
    pub const DEFAULT: Self = Self {
        gravity: Fx::from_bits(0x4000), // 0.25
        fall: Fx::from_bits(6 << 16),
        jump: Fx::from_bits(0x4_8000),     // 4.5
        jump_cut: Fx::from_bits(0x1_8000), // 1.5
        coyote: 5,
        buffer: 5,
        acceleration: Fx::from_bits(0x8000),     // 0.5
        air_acceleration: Fx::from_bits(0x4000), // 0.25
        snap: Fx::from_bits(5 << 16),
        step: Fx::from_bits(4 << 16),
        slope_speed: SlopeSpeed::Constant,
        wall_jump: None,
        wall_slide: None,
        on_leave: OnLeave::Keep,
    };

    /// Checks the numbers, as each [`step`](crate::Character::step) does. In a constant, it finds
    /// the fault when you compile:
    ///
    /// ```
    /// use tilesat::{Feel, Quantity, fx};
    /// const FROG: Feel = Feel { jump: fx!(6), ..Feel::DEFAULT };
    /// const _: () = assert!(FROG.check().is_ok());
    ///
    /// let upward = Feel { jump: fx!(-6), ..Feel::DEFAULT };
    /// let error = upward.check().unwrap_err();
    /// assert_eq!(error.what, Quantity::Jump);
    /// assert!(error.to_string().starts_with("Jump is out of range: -6 (-393216 raw); only the gravity"));
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] for the first number that is negative, though only
    /// [`gravity`](Self::gravity) may be. Also for a snap or a step of 4096 units and more.
    pub const fn check(&self) -> Result<(), RangeError> {
        if let Err(e) = self.check_signs() {
            return Err(e);
        }
        if let Err(e) = checked(self.snap, Quantity::Snap) {
            return Err(e);
        }
        match checked(self.step, Quantity::StepHeight) {
            Ok(_) => Ok(()),
            Err(e) => Err(e),
        }
    }

    /// Refuses speeds with a sign, as other engines have them: the hero would jump into the ground.
    pub(super) const fn check_signs(&self) -> Result<(), RangeError> {
        use Quantity::{Acceleration, AirAcceleration, Fall, Jump, JumpCut, WallJump, WallSlide};

        let Self { fall, jump, jump_cut, acceleration, air_acceleration, wall_jump, wall_slide, .. } = *self;
        let off = if let Some(speed) = wall_jump { speed.to_bits() } else { 0 };
        let along = if let Some(speed) = wall_slide { speed.to_bits() } else { 0 };
        let up = fall.to_bits() | jump.to_bits() | jump_cut.to_bits();
        // One test of all signs: a step checks them in each frame.
        if up | acceleration.to_bits() | air_acceleration.to_bits() | off | along >= 0 {
            return Ok(());
        }
        let (what, value) = match (fall.to_bits(), jump.to_bits(), jump_cut.to_bits(), acceleration.to_bits()) {
            (value @ ..0, ..) => (Fall, value),
            (_, value @ ..0, ..) => (Jump, value),
            (_, _, value @ ..0, _) => (JumpCut, value),
            (_, _, _, value @ ..0) => (Acceleration, value),
            _ => match (air_acceleration.to_bits(), off) {
                (value @ ..0, _) => (AirAcceleration, value),
                (_, value @ ..0) => (WallJump, value),
                _ => (WallSlide, along),
            },
        };
        Err(RangeError { what, value })
    }

    /// The frames of [`coyote`](Self::coyote). Counters of frames end at the largest number, which
    /// stands for ever. A wall's counter is one ahead.
    pub(super) const fn grace(&self) -> u8 {
        if self.coyote > u8::MAX - 2 { u8::MAX - 2 } else { self.coyote }
    }
}

impl Default for Feel {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// The state of a character after one frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outcome {
    /// It moved, or stood.
    #[default]
    Moved,
    /// A solid pressed it against something, and it stayed where it was: see
    /// [`Ride::Squashed`](super::Ride::Squashed). It is reported in every frame until that solid
    /// turns back or has passed. A round body may report it for one frame longer. Meanwhile the
    /// floor, the velocity and a buffered jump stay as they were. A one-way solid squashes no
    /// character: without room, it passes through.
    Squashed {
        /// The key of the solid.
        by: u16,
        /// Out of that solid, toward the body.
        normal: Axis,
    },
    /// It overlaps the level and did not move: it started in a wall, or a tile closed on it.
    /// `level.overlaps(hero.body())` is true.
    ///
    /// With [`step_carried`](crate::Character::step_carried) in a [`Joined`](crate::Joined) level,
    /// a solid that squashed it counts as level. [`step_on`](crate::Character::step_on) returns
    /// [`Squashed`](Self::Squashed) instead.
    Stuck,
    /// The body is entirely below its limits, or beside them. It may be above them. Also if
    /// its motion would leave the [domain](crate::num::DOMAIN): then it stays.
    OutOfLevel,
}

/// What happened to a character in one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[must_use = "the outcome says whether the character lives"]
// Words come first, as in a `Hit`.
#[repr(C)]
pub struct Step {
    /// The hits of the frame.
    pub hits: Hits,
    /// The state after the frame.
    pub outcome: Outcome,
    /// Whether it jumped.
    pub jumped: bool,
    /// Whether it landed on a floor. It may have slid off the end of that floor in the same frame.
    /// It can then still jump, as after [walking](Feel::coyote) off a floor.
    pub landed: bool,
    /// Whether a wall blocks it, or a ceiling that comes down to its floor.
    #[doc(alias = "is_on_wall")]
    pub wall: bool,
    /// Whether its head hit a ceiling.
    #[doc(alias = "is_on_ceiling")]
    pub ceiling: bool,
    /// The flags of all tiles, segments and solids that it hit, or-ed. A floor on which it stands
    /// or walks is no hit: see [`Character::floor`](crate::Character::floor).
    pub flags: u8,
}

impl Step {
    pub(super) const fn nothing(outcome: Outcome) -> Self {
        Self { outcome, jumped: false, landed: false, wall: false, ceiling: false, flags: 0, hits: Hits::none() }
    }
}
