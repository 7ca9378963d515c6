//! The settings of a character that walks.

use crate::error::{Quantity, RangeError};
use crate::motion::Mover;
use crate::num::{Fx, MOTION};

/// How fast a [`Walker`] is on a slope, if its velocity across "up" is `s`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SlopeSpeed {
    /// The part of the velocity along the slope, `s cos a`: slower on steeper slopes, upward and
    /// downward alike.
    #[default]
    Projected,
    /// `s` itself, along every floor.
    Constant,
}

/// A body that walks on floors. It keeps to the ground on slopes and small steps, climbs steps, and
/// does not slip.
///
/// ```text
///   snap                  step                slope
///      o-->                       _____             _,o
///    ______  o               o-->|                ,'  `.
///          `. v                __|             o-'      `.
///            `._____
/// ```
///
/// It stands while you pass the `floor` of the last frame to [`walk`](Self::walk) and its velocity
/// does not rise. Otherwise it flies as with [`Mover::move_and_slide`] and lands on the first floor
/// that it meets. Ground steeper than the mover's [slope limit](Mover::with_slope_limit) is wall. A
/// walker stops there, and slides down a steep slope that it falls on. If you change "up", pass
/// `None` in that frame: the old floor is no floor then.
///
/// Plain data: a copy is a snapshot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[doc(alias("character controller", "ground snapping"))]
pub struct Walker {
    pub(crate) mover: Mover,
    pub(crate) snap: i32,
    pub(crate) step: i32,
    pub(crate) speed: SlopeSpeed,
}

impl Walker {
    /// A walker without snap and steps, and projected speed on slopes. Without an "up" it only
    /// flies.
    #[must_use]
    pub const fn new(mover: Mover) -> Self {
        Self { mover, snap: 0, step: 0, speed: SlopeSpeed::Projected }
    }

    /// Sets how far down the walker follows the ground per call. One and a half times its speed is
    /// enough for slopes of 45 degrees and the bends between two of them. It also follows ledges of
    /// exactly that height down.
    ///
    /// With moving solids, pass the same length to [`Mover::ride`] as `follow` while the body
    /// stands. Otherwise a lift that sinks by more than `follow` and less than the snap would pull
    /// the walker down in each frame. It would never carry the walker sideways.
    ///
    /// ```
    /// use tilesat::{AllShapes, Aabb, Axis, Mover, TileKind, TileKinds, TileMap, TileShape, Vec2, Walker, fx};
    /// static KINDS: TileKinds =
    ///     TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'\\', TileKind::of(TileShape::SlopeBottomLeft));
    /// let level = TileMap::<AllShapes>::of_ascii("...\n#\\.", &KINDS)?; // a slope down from (16, 16)
    /// let (mut body, run) = (Aabb::new(Vec2::from_ints(12, 6), Vec2::from_ints(20, 16))?, Vec2::from_ints(4, 0));
    /// let walker = Walker::new(Mover::platformer(Axis::NEG_Y)).with_snap(fx!(6))?;
    /// let (mut floor, mut feet) = (walker.walk(&level, &body, Vec2::from_ints(0, 1), None)?.floor, Vec::new());
    /// for _ in 0..3 {
    ///     let walked = walker.walk(&level, &body, run, floor)?;
    ///     (body, floor) = (walked.moved.body, walked.floor);
    ///     feet.push(body.max().y.to_num::<i32>());
    ///     assert!(walked.on_floor());
    /// }
    /// assert!(feet[2] > feet[1] && feet[1] > 16); // down the slope, and never in the air
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the length is negative or not below 2^28 raw.
    #[doc(alias("floor_snap_length", "snap_to_ground"))]
    pub const fn with_snap(self, length: Fx) -> Result<Self, RangeError> {
        match checked(length, Quantity::Snap) {
            Ok(snap) => Ok(Self { snap, ..self }),
            Err(e) => Err(e),
        }
    }

    /// Sets the highest step that the walker climbs, onto level ground and onto slopes.
    ///
    /// ```
    /// use tilesat::{AllShapes, Aabb, Axis, Mover, TileKind, TileKinds, TileMap, TileShape, Vec2, Walker, fx};
    /// static KINDS: TileKinds =
    ///     TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'_', TileKind::of(TileShape::HalfBottom));
    /// let level = TileMap::<AllShapes>::of_ascii("...\n.__\n###", &KINDS)?; // a step of 8 units at x = 16
    /// let body = Aabb::new(Vec2::from_ints(2, 22), Vec2::from_ints(12, 32))?;
    /// let walker = Walker::new(Mover::platformer(Axis::NEG_Y));
    /// let floor = walker.walk(&level, &body, Vec2::from_ints(0, 1), None)?.floor;
    /// let walk = |walker: Walker| walker.walk(&level, &body, Vec2::from_ints(8, 0), floor);
    /// assert_eq!(walk(walker)?.moved.position(), Vec2::from_ints(6, 22)); // up to the step
    /// assert_eq!(walk(walker.with_step(fx!(8))?)?.moved.position(), Vec2::from_ints(10, 14));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the height is negative or not below 2^28 raw.
    #[doc(alias("autostep", "stair stepping"))]
    pub const fn with_step(self, height: Fx) -> Result<Self, RangeError> {
        match checked(height, Quantity::StepHeight) {
            Ok(step) => Ok(Self { step, ..self }),
            Err(e) => Err(e),
        }
    }

    /// Sets the speed on slopes.
    #[must_use]
    pub const fn with_slope_speed(self, speed: SlopeSpeed) -> Self {
        Self { speed, ..self }
    }

    /// Sets whether the walker drops through one-way floors, as [`Mover::with_drop_through`] does.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Mover, TileKind, TileKinds, TileMap, Vec2, Walker};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'-', TileKind::ONE_WAY_UP);
    /// let level = TileMap::from_ascii("..\n--\n..\n--", &KINDS)?; // shelves at y = 16 and y = 48
    /// let hero = Aabb::from_size(Vec2::from_ints(4, 6), Vec2::from_ints(8, 10))?; // on the upper one
    /// let (walker, fall) = (Walker::new(Mover::platformer(Axis::NEG_Y)), Vec2::from_ints(0, 2));
    /// let floor = walker.walk(&level, &hero, fall, None)?.floor;
    /// assert!(walker.walk(&level, &hero, fall, floor)?.on_floor());
    /// let dropped = walker.with_drop_through(true).walk(&level, &hero, fall, floor)?;
    /// assert_eq!((dropped.on_floor(), dropped.moved.position()), (false, Vec2::from_ints(4, 8)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub const fn with_drop_through(self, drop_through: bool) -> Self {
        Self { mover: self.mover.with_drop_through(drop_through), ..self }
    }
}

pub(in crate::motion) const fn checked(length: Fx, what: Quantity) -> Result<i32, RangeError> {
    let value = length.to_bits();
    if 0 <= value && value < MOTION { Ok(value) } else { Err(RangeError { what, value }) }
}
