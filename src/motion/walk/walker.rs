//! A character that walks: its settings, and one frame of it.

use super::Support;
use super::ground::{Look, leads};
use super::stride::Stride;
use crate::error::{Quantity, RangeError};
use crate::motion::order::First;
use crate::motion::search::{Around, check_cells};
use crate::motion::{Body, MoveError, Moved, Mover};
use crate::num::{Fx, MOTION, Raw, Vec2};
use crate::world::World;

/// How fast a [`Walker`] is on a slope, at a velocity of `s` across "up".
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SlopeSpeed {
    /// The part of the velocity along the slope, `s cos a`: slower the steeper it is, upward and
    /// downward alike.
    #[default]
    Projected,
    /// `s` itself, along every floor.
    Constant,
}

/// A body that walks on floors: it keeps to the ground on slopes and small steps, climbs steps, and
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
/// It stands while the `floor` that the last frame returned is handed to [`walk`](Self::walk) and
/// its velocity does not rise; else it flies as [`Mover::move_and_slide`] says and lands on the
/// first floor that it meets. What is steeper than the mover's
/// [slope limit](Mover::with_slope_limit) is wall: a walker stops there, and what it falls on such
/// a slope it slides down.
///
/// Plain data: a copy is a snapshot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[doc(alias("character controller", "ground snapping"))]
pub struct Walker {
    pub(crate) mover: Mover,
    pub(crate) snap: i32,
    pub(crate) step: i32,
    pub(crate) speed: SlopeSpeed,
}

/// Where a walker ended up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Walked<B> {
    /// The motion. On a floor its velocity is level (across "up"): the speed that walking goes on
    /// with; in the air it is what it was when it left the ground or what flying left of it.
    ///
    /// Its `wall` is what still blocks after the last step that was made: true is the sign to turn
    /// round. A step's face is among its `hits` all the same.
    pub moved: Moved<B>,
    /// What it stands on; hand it to the next call.
    pub floor: Option<Support>,
    /// How far it rose on steps.
    pub stepped: Fx,
    /// How far it was drawn down to the ground; 0 for what is only rounding.
    pub snapped: Fx,
}

impl<B> Walked<B> {
    /// Whether it stands.
    #[must_use]
    pub const fn on_floor(&self) -> bool {
        self.floor.is_some()
    }
}

impl Walker {
    /// A walker without snap and steps, projected on slopes. Without an "up" it only flies.
    #[must_use]
    pub const fn new(mover: Mover) -> Self {
        Self { mover, snap: 0, step: 0, speed: SlopeSpeed::Projected }
    }

    /// The same walker that keeps to a ground which falls by up to `length` a call: one and a half
    /// of its speed is enough for slopes of 45 degrees and what lies between two of them. Ledges of
    /// exactly that height are followed down too.
    ///
    /// With moving solids, hand the same length to [`Mover::ride`] as `follow` while the body
    /// stands: a lift that sinks by more than `follow` and less than the snap would draw the walker
    /// down in each frame and never carry it across.
    ///
    /// # Errors
    /// [`RangeError`] where the length is negative or not below 2^28 raw.
    #[doc(alias("floor_snap_length", "snap_to_ground"))]
    pub const fn with_snap(self, length: Fx) -> Result<Self, RangeError> {
        match checked(length, Quantity::Snap) {
            Ok(snap) => Ok(Self { snap, ..self }),
            Err(e) => Err(e),
        }
    }

    /// The same walker that climbs steps of up to `height` on level ground.
    ///
    /// # Errors
    /// [`RangeError`] where the height is negative or not below 2^28 raw.
    #[doc(alias("autostep", "stair stepping"))]
    pub const fn with_step(self, height: Fx) -> Result<Self, RangeError> {
        match checked(height, Quantity::StepHeight) {
            Ok(step) => Ok(Self { step, ..self }),
            Err(e) => Err(e),
        }
    }

    /// The same walker with another speed on slopes.
    #[must_use]
    pub const fn with_slope_speed(self, speed: SlopeSpeed) -> Self {
        Self { speed, ..self }
    }

    /// The same walker that drops through one-way floors, or no longer does: see
    /// [`Mover::with_drop_through`].
    #[must_use]
    pub const fn with_drop_through(self, drop_through: bool) -> Self {
        Self { mover: self.mover.with_drop_through(drop_through), ..self }
    }

    /// Walks or flies for one frame: `floor` is what the last call returned, `None` at first and
    /// for a body that was put elsewhere.
    ///
    /// **On a floor**, unless the velocity rises: what the velocity has across "up" is the speed of
    /// walking, what it has downward does not count, so nothing slips. It goes along the floor, up
    /// and down where that bends. At a wall, at what is steeper than the slope limit and under a
    /// ceiling it stops, and its velocity is zero. Where the ground falls away by more than the
    /// snap it flies on, with the velocity that it had along the floor.
    ///
    /// **In the air** it is [`Mover::move_and_slide`] until it meets a floor, where it walks for
    /// the rest of the frame; only that the walls, which steep slopes are, take what the velocity
    /// has against them across "up", so that pushing does not climb them. The mover's response is
    /// what it does there.
    ///
    /// The way of a frame is never longer than the velocity (and what it rose on steps and was
    /// drawn down), but for up to 4 raw of roundings at joints; shorter by less than 2 raw on a
    /// slope of tiles and up to 10 around the joints of slopes. A circle goes around a corner by
    /// the tangents to its way, so it loses up to a fifth of a frame's way there once, and more
    /// where corners follow each other within a frame. Through a quarter pipe it goes by chords,
    /// and stops before its slope passes the limit. Mirrored scenes give mirrored bits, tiles and
    /// polygons of the same ground the same bits.
    ///
    /// Steps lead to level ground alone. A circle climbs by its lowest point, so it takes some
    /// frames, and what it meets no steeper than the slope limit is no step. Its `floor` is then
    /// the one that the step leads to. Snapping and steps pass one-way faces as every motion does:
    /// they hold what is entirely above them.
    ///
    /// Cost: walking on even ground, two sweeps over the cells under the motion, at most four legs
    /// with two each; a step tried is up to ten more.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Fx, Mover, SlopeSpeed, Slopes, TileKind, TileKinds, TileMap, TileShape, Vec2, Walker};
    /// static KINDS: TileKinds = TileKinds::EMPTY
    ///     .with(b'#', TileKind::FULL)
    ///     .with(b'/', TileKind::of(TileShape::SlopeBottomRight));
    /// // The floor is at y = 32, and at 16 from x = 48 on.
    /// let map = TileMap::from_ascii("....\n../#\n####", &TileKinds::EMPTY)?.with_kinds::<Slopes>(&KINDS)?;
    /// let walker = Walker::new(Mover::platformer(Axis::NEG_Y))
    ///     .with_slope_speed(SlopeSpeed::Constant)
    ///     .with_snap(Fx::from_num(4))?;
    ///
    /// let player = Aabb::new(Vec2::from_ints(4, 20), Vec2::from_ints(12, 30))?;
    /// let mut walked = walker.walk(&map, &player, Vec2::from_ints(0, 3), None)?; // it lands
    /// assert!(walked.on_floor());
    /// for _ in 0..16 {
    ///     let velocity = Vec2::from_ints(2, 1); // gravity changes nothing on the ground
    ///     walked = walker.walk(&map, &walked.moved.body, velocity, walked.floor)?;
    /// }
    /// assert_eq!(walked.floor.map(|floor| floor.axis), Some(Axis::new(-1, -1))); // on its way up the slope
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Mover::move_and_slide`].
    pub fn walk<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        velocity: Vec2,
        floor: Option<Support>,
    ) -> Result<Walked<B>, MoveError> {
        let mut moved = Moved::freely(*body, velocity, 0);
        let mut around = Around::NOTHING;
        let mut run = self.mover.start(world, &mut moved, &mut around)?;
        let reach = self.snap.max(self.step);
        check_cells(world, &body.bounds(), Raw { x: reach, y: reach })?;
        let Some(up) = self.mover.up else {
            self.mover.slide::<W, B, true>(world, &mut run, &mut First::none())?;
            return Ok(Walked { moved: *run.end::<W>(), floor: None, stepped: Fx::ZERO, snapped: Fx::ZERO });
        };
        let passes = self.mover.passes_one_way();
        let rises = leads(run.v, up);
        let stands = floor.filter(|f| !(rises || (passes && f.one_way))).map(|f| f.axis);
        let axis = if stands.is_none() {
            self.mover.slide::<W, B, true>(world, &mut run, &mut First::none())?;
            run.moved.hits.iter().last().filter(|_| run.moved.floor).map(|hit| hit.axis)
        } else {
            stands
        };
        run.pass_one_way |= passes;
        if let Some(axis) = axis {
            return Stride::new(self, world, run, up, axis).walk();
        }
        let level = !(leads(run.v, up) || leads(run.v, up.reversed()));
        let floor = if level { run.floor_near(world, &self.mover, up) } else { None };
        Ok(Walked { moved: *run.end::<W>(), floor, stepped: Fx::ZERO, snapped: Fx::ZERO })
    }
}

pub(super) const fn checked(length: Fx, what: Quantity) -> Result<i32, RangeError> {
    let value = length.to_bits();
    if 0 <= value && value < MOTION { Ok(value) } else { Err(RangeError { what, value }) }
}

/// The longer component, as a length.
pub(super) fn length(d: Raw) -> Fx {
    Fx::from_bits(crate::motion::plane::way(d) as i32)
}
