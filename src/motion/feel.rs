//! What a character takes and answers: the player's input, the numbers that decide how it moves,
//! and what happened in a frame.

use super::{Hits, SlopeSpeed};
use crate::num::{Axis, Fx};

/// The player's input for one frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Input {
    /// The speed to run at, in units per frame: negative to the left. On a moving solid it counts
    /// as seen from there, and after leaving one as [`Feel::on_leave`] says.
    pub run: Fx,
    /// Whether the jump button is down. The character detects presses and releases itself.
    pub jump: bool,
    /// Whether to drop through one-way floors in this frame. One frame is enough for the floor that
    /// it stands on; while it stays true, it passes all that follow. On a one-way floor it wins
    /// over `jump`.
    ///
    /// Off a one-way solid, which may sink, one frame counts until the feet are [`Feel::snap`] and
    /// its motion below it. Until then the character passes other one-way floors as well. A lift
    /// that speeds up by more than half the gravity per frame may still catch it.
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

/// What becomes of the motion of a [`Solid`](crate::Solid) that a [`Character`](crate::Character)
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
/// assert_eq!(flies(OnLeave::Keep)?, fx!(0.5)); // -1.5, seen from the lift
/// assert_eq!(flies(OnLeave::Add)?, fx!(-1.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias("platform_on_leave", "lift boost", "inherit velocity"))]
pub enum OnLeave {
    /// It goes on until the character lands or meets a wall. Seen from the solid, the flight is
    /// that on still ground: a hero that jumps on a train comes down where it jumped.
    /// [`Input::run`] counts as seen from the solid too.
    #[default]
    Keep,
    /// It is added once. Then [`Feel::air_acceleration`] brings the speed to [`Input::run`] as seen
    /// from the level.
    Add,
    /// As [`Add`](Self::Add), without the part of a jump off a solid that leads down: it rises as
    /// high as one off still ground.
    AddUpward,
}

/// How a [`Character`](crate::Character) moves. Lengths are units, times are frames.
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
    /// The velocity gained per frame. Positive pulls toward larger y, as on a screen. Negative
    /// pulls the other way, and "up" follows.
    pub gravity: Fx,
    /// The fastest fall. Off a solid that sinks it is faster by the speed of the solid.
    #[doc(alias("terminal_velocity", "max_fall_speed"))]
    pub fall: Fx,
    /// The speed at which a jump starts. With a gravity of g, a jump of n g rises by g n (n + 1) /
    /// 2 in n frames.
    #[doc(alias("jump_speed", "jump_velocity"))]
    pub jump: Fx,
    /// The speed that a rising jump keeps when the button is released. If it equals `jump`, all
    /// jumps are equally high.
    pub jump_cut: Fx,
    /// For how many frames after the body walked off the floor, or left a wall, it can still jump.
    #[doc(alias = "coyote_time")]
    pub coyote: u8,
    /// For how many more frames a press of the button counts, if it comes before the landing. Zero:
    /// only in the frame of the press. If the button is up again at the landing, the jump is cut
    /// from its first frame.
    #[doc(alias = "jump_buffer")]
    pub buffer: u8,
    /// How much the speed changes per frame on a floor, toward [`Input::run`].
    pub acceleration: Fx,
    /// How much the speed changes per frame in the air.
    pub air_acceleration: Fx,
    /// How far the body follows falling ground: [`Walker::with_snap`](crate::Walker::with_snap).
    /// One and a half times the running speed is always enough for tiles.
    pub snap: Fx,
    /// The highest step that it climbs: [`Walker::with_step`](crate::Walker::with_step). The
    /// default stops at half of a tile of 16.
    pub step: Fx,
    /// How fast it walks on slopes.
    pub slope_speed: SlopeSpeed,
    /// The speed away from a wall at the start of a wall jump. `None`: no wall jumps. It must have
    /// run against the wall in the last [`coyote`](Self::coyote) frames. The same wall counts
    /// again: if it comes back before it falls, it climbs.
    pub wall_jump: Option<Fx>,
    /// The fastest fall while it runs against a wall. `None`: as elsewhere.
    pub wall_slide: Option<Fx>,
    /// What becomes of the motion of a solid that it leaves.
    pub on_leave: OnLeave,
}

impl Feel {
    /// Gravity 0.25, fastest fall 6, jump 4.5 cut to 1.5, coyote and buffer 5 frames, acceleration
    /// 0.5 and in the air 0.25, snap 5, step 4, constant speed on slopes. Wall jump and wall slide
    /// are off. The motion of a solid is [kept](OnLeave::Keep).
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

    pub(super) const fn falls_to_larger_y(&self) -> bool {
        self.gravity.to_bits() >= 0
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
    /// A solid pressed it against something, and it stayed where it was: see [`Ride::Squashed`](super::Ride::Squashed).
    /// You get it in each frame until that solid turns back or has passed; a round body may get it
    /// for one frame more. Meanwhile the floor and the velocity stay as they were. A one-way solid
    /// squashes nobody: without room, it passes through the character.
    Squashed {
        /// The key of the solid.
        by: u16,
        /// Out of that solid, toward the body.
        normal: Axis,
    },
    /// It overlaps the level and did not move: it started in a wall, or a tile closed on it.
    /// `level.overlaps(hero.body())` is true.
    ///
    /// With [`step_carried`](crate::Character::step_carried) in a [`Joined`](crate::Joined) level, a
    /// solid that squashed it counts as level. [`step_on`](crate::Character::step_on) returns
    /// [`Squashed`](Self::Squashed) instead.
    Stuck,
    /// It is entirely below its limits, or beside them. It may fly above them.
    OutOfLevel,
}

/// What happened to a character in one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[must_use = "the outcome says whether the character lives"]
// Words first, as in a `Hit`.
#[repr(C)]
pub struct Step {
    /// The hits of the frame.
    pub hits: Hits,
    /// The state after the frame.
    pub outcome: Outcome,
    /// Whether it jumped.
    pub jumped: bool,
    /// Whether it landed on a floor. It may have slid off the end of that floor in the same frame.
    /// Then it can still jump, as after it [walks](Feel::coyote) off one.
    pub landed: bool,
    /// Whether a wall blocks it, or a ceiling that comes down to its floor.
    #[doc(alias = "is_on_wall")]
    pub wall: bool,
    /// Whether its head hit a ceiling.
    #[doc(alias = "is_on_ceiling")]
    pub ceiling: bool,
    /// The flags of all tiles, segments and solids that it hit, or-ed. A floor that it stands on,
    /// or walks on to, is no hit: see [`Character::floor`](crate::Character::floor).
    pub flags: u8,
}

impl Step {
    pub(super) const fn nothing(outcome: Outcome) -> Self {
        Self { outcome, jumped: false, landed: false, wall: false, ceiling: false, flags: 0, hits: Hits::none() }
    }
}
