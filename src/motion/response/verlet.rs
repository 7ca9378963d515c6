//! Verlet points, the sticks that join them, and how they rest in a level.

use super::Law;
use crate::error::RangeError;
use crate::motion::{MoveError, Mover};
use crate::num::{Fx, Ratio, Raw, Vec2, check_length, toward, usqr};
use crate::shape::Circle;
use crate::world::World;
use core::fmt;

/// A point with a velocity given by its last two positions.
///
/// Anything that moves it, such as a [`Stick`](super::Stick), also changes its velocity. In a level
/// it is a small circle that only a mover moves: it never ends inside.
///
/// ```
/// use tilesat::{Ratio, Vec2, motion::response::Particle};
/// let mut spark = Particle::moving(Vec2::from_ints(0, 0), Vec2::from_ints(4, -8));
/// spark = spark.step(Vec2::from_ints(0, 1), Ratio::HALF);
/// assert_eq!(spark.position, Vec2::from_ints(2, -3));
/// assert_eq!(spark.velocity(), Vec2::from_ints(2, -3));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Particle {
    /// Its position.
    pub position: Vec2,
    /// Its position one step ago, as far as its velocity is concerned.
    pub previous: Vec2,
}

impl Particle {
    /// A point at rest.
    #[must_use]
    pub const fn at(position: Vec2) -> Self {
        Self { position, previous: position }
    }

    /// A point with a velocity in units per step.
    #[must_use]
    pub fn moving(position: Vec2, velocity: Vec2) -> Self {
        Self { position, previous: position - velocity }
    }

    /// The velocity in units per step.
    #[must_use]
    pub fn velocity(&self) -> Vec2 {
        self.position - self.previous
    }

    /// The velocity of the next step. It loses `drag` of this one, rounded toward rest (with drag,
    /// by at least a raw unit), and gains the acceleration.
    #[must_use]
    fn next_velocity(&self, acceleration: Vec2, drag: Ratio) -> Vec2 {
        let (v, keep) = (Raw::of(self.velocity()), drag.complement());
        Vec2::from_raw(keep.of_raw(v.x), keep.of_raw(v.y)) + acceleration
    }

    /// The point one step later, in free space. Saturates at the ends of 16.16. Mirrored input
    /// gives mirrored bits.
    #[must_use]
    pub fn step(self, acceleration: Vec2, drag: Ratio) -> Self {
        let velocity = self.next_velocity(acceleration, drag);
        Self { position: self.position + velocity, previous: self.position }
    }

    /// The point one step later in a level, as a circle of this radius. Its velocity is the one
    /// that the mover returned.
    ///
    /// Cost: one call of the mover.
    ///
    /// ```
    /// use tilesat::{Mover, Ratio, TileKind, TileKinds, TileMap, Vec2, fx, motion::response::Particle};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("..\n##", &KINDS)?; // the floor is at y = 16
    /// let mut point = Particle::at(Vec2::from_ints(8, 4));
    /// for _ in 0..20 {
    ///     point = point.step_in(&level, &Mover::new(), fx!(2), Vec2::from_ints(0, 1), Ratio::ZERO)?;
    /// }
    /// assert_eq!(point, Particle::at(Vec2::from_ints(8, 14))); // it lies on the floor
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Mover::move_and_slide`], and if the circle is outside of the domain.
    pub fn step_in<W: World, S: Law>(
        self,
        world: &W,
        mover: &Mover<S>,
        radius: Fx,
        acceleration: Vec2,
        drag: Ratio,
    ) -> Result<Self, MoveError> {
        let body = Circle::new(self.position, radius)?;
        let moved = mover.move_and_slide(world, &body, self.next_velocity(acceleration, drag))?;
        Ok(Self::moving(moved.position(), moved.velocity))
    }

    /// The point, pushed through a level as far as possible, along the surfaces that it meets. Its
    /// velocity changes by the part of the push that it made.
    ///
    /// ```
    /// use tilesat::{Mover, TileKind, TileKinds, TileMap, Vec2, fx, motion::response::Particle};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii(".#", &KINDS)?; // the wall is at x = 16
    /// let point = Particle::at(Vec2::from_ints(8, 8));
    /// let pushed = point.pushed_in(&level, &Mover::new(), fx!(2), Vec2::from_ints(10, 3))?;
    /// assert_eq!((pushed.position, pushed.velocity()), (Vec2::from_ints(14, 11), Vec2::from_ints(6, 3)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step_in`](Self::step_in).
    pub fn pushed_in<W: World, S: Law>(
        self,
        world: &W,
        mover: &Mover<S>,
        radius: Fx,
        by: Vec2,
    ) -> Result<Self, MoveError> {
        if by == Vec2::ZERO {
            return Ok(self);
        }
        let moved = mover.move_and_slide(world, &Circle::new(self.position, radius)?, by)?;
        Ok(Self { position: moved.position(), previous: self.previous })
    }
}

/// A distance between two points: a stick keeps it, a rope does not exceed it.
///
/// ```text
///    a o---->     <----o b     too long: both move together, each by its share
///        a o<-> <->o b         too short: a stick drives them apart, a rope lets them
/// ```
///
/// ```
/// use tilesat::{Fx, Vec2, motion::response::Stick};
/// let stick = Stick::new(Fx::from_num(10))?;
/// let (a, b) = (Vec2::from_ints(0, 0), Vec2::from_ints(16, 0));
/// assert_eq!(stick.pull(a, b), (Vec2::from_ints(3, 0), Vec2::from_ints(-3, 0)));
/// assert_eq!(Stick::rope(Fx::from_num(20))?.pull(a, b), (Vec2::ZERO, Vec2::ZERO));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Stick {
    pub(super) length: Fx,
    pub(super) share_of_a: Ratio,
    pub(super) slack: bool,
}

/// The largest error after one correction. A component of each share is short by less than a raw
/// unit, both together by one, which gives sqrt(2). The direction adds sqrt(1/2).
const NEAR: u32 = 3;

impl Stick {
    /// A stick between points of equal mass.
    ///
    /// # Errors
    /// [`RangeError`] if the length is negative or outside of the [domain](crate::num::DOMAIN).
    pub const fn new(length: Fx) -> Result<Self, RangeError> {
        match check_length(length) {
            Ok(()) => Ok(Self { length, share_of_a: Ratio::HALF, slack: false }),
            Err(e) => Err(e),
        }
    }

    /// A rope: it pulls and does not push.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub const fn rope(length: Fx) -> Result<Self, RangeError> {
        match Self::new(length) {
            Ok(stick) => Ok(Self { slack: true, ..stick }),
            bad => bad,
        }
    }

    /// Sets the share of A in the corrections: [`Masses::share_of_a`](super::Masses::share_of_a),
    /// or zero if A is fixed.
    #[must_use]
    pub const fn with_share_of_a(self, share_of_a: Ratio) -> Self {
        Self { share_of_a, ..self }
    }

    /// The length.
    #[must_use]
    pub const fn length(&self) -> Fx {
        self.length
    }

    /// How far to move each end. Zero if their distance is, exactly, less than 3 raw units off.
    ///
    /// The correction follows the exact difference of the ends, each component rounded to nearest.
    /// Each end receives its share rounded toward zero, so nothing is ever corrected too far. One
    /// correction leaves the distance less than 3 raw units off, where it stays. The result does
    /// not depend on which end is A, and mirrored input gives mirrored bits. If both ends are at
    /// the same point, they part along x, A to the left. The ends must be inside the
    /// [domain](crate::num::DOMAIN).
    ///
    /// Cost: two quotients by a root, about 1380 instructions on a Cortex-M0. Without a correction
    /// it takes 100.
    #[must_use]
    pub const fn pull(&self, a: Vec2, b: Vec2) -> (Vec2, Vec2) {
        let (e, length) = (Raw::of(b).sub(Raw::of(a)), self.length.to_bits());
        let square = e.len2();
        let too_long = square >= usqr(length as u32 + NEAR);
        let too_short = !self.slack && length as u32 >= NEAR && square <= usqr(length as u32 - NEAR);
        if !too_long && !too_short {
            return (Vec2::ZERO, Vec2::ZERO);
        }
        let along = if e.is_zero() { Raw { x: 1, y: 0 } } else { e };
        let excess = e.sub(toward(along, length));
        let (of_a, of_b) = (self.share_of_a, self.share_of_a.complement());
        let by_a = Raw { x: of_a.of_raw(excess.x), y: of_a.of_raw(excess.y) };
        let by_b = Raw { x: of_b.of_raw(excess.x).wrapping_neg(), y: of_b.of_raw(excess.y).wrapping_neg() };
        (by_a.vec2(), by_b.vec2())
    }
}

/// A stick between two points of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Link {
    /// The index of A.
    pub a: u8,
    /// The index of B, which differs from that of A.
    pub b: u8,
    /// The distance between them.
    pub stick: Stick,
}

/// Why points could not be brought to their distances. The links before the failed one were
/// corrected.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum RelaxError {
    /// The link of this index names a missing point, or one point twice.
    NoPoint {
        /// The index of the link.
        link: u32,
    },
    /// The mover refused a point of the link of this index.
    Move {
        /// The index of the link.
        link: u32,
        /// The refusal of the mover.
        error: MoveError,
    },
}

impl fmt::Display for RelaxError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoPoint { link } => write!(
                f,
                "link {link} names a point that is not in the list: its indices must be below the number of points"
            ),
            Self::Move { link, error } => write!(f, "link {link}: {error}"),
        }
    }
}

impl core::error::Error for RelaxError {}

/// Brings linked points nearer to their distances, link after link, until nothing moves or for at
/// most `rounds` rounds. Returns the rounds taken.
///
/// Each correction moves a circle of this radius with the mover, so no point ends inside the level,
/// however hard it is pulled. More rounds make stiffer links. If a blocked point cannot move, its
/// partner does in the next round. The order of the links is part of the model: the last ones are
/// kept best.
///
/// A frame of a ragdoll is [`Particle::step_in`] for each point, then this, then
/// [`Quiet::watch`](super::Quiet::watch). If points are much faster than the links are long, split
/// a frame into two or four, with a part of the velocity each.
///
/// Cost: a [`pull`](Stick::pull) for each round and link, and two calls of the mover for each link
/// that is not satisfied.
///
/// ```
/// use tilesat::{Mover, TileKinds, TileMap, Vec2, fx, motion::response::{Link, Particle, Stick, relax}};
/// let level = TileMap::from_ascii("....\n....", &TileKinds::EMPTY)?;
/// let mut points = [Particle::at(Vec2::from_ints(10, 8)), Particle::at(Vec2::from_ints(30, 8))];
/// let links = [Link { a: 0, b: 1, stick: Stick::new(fx!(12))? }];
/// relax(&mut points, &links, 4, &level, &Mover::new(), fx!(1))?;
/// assert_eq!(points.map(|point| point.position), [Vec2::from_ints(14, 8), Vec2::from_ints(26, 8)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`RelaxError`] if a link names a missing point, or the mover refuses one.
pub fn relax<W: World, S: Law>(
    points: &mut [Particle],
    links: &[Link],
    rounds: u32,
    world: &W,
    mover: &Mover<S>,
    radius: Fx,
) -> Result<u32, RelaxError> {
    for round in 0..rounds {
        let mut moved = false;
        for (index, link) in links.iter().enumerate() {
            let missing = RelaxError::NoPoint { link: index as u32 };
            let refused = |error| RelaxError::Move { link: index as u32, error };
            let (i, j) = (usize::from(link.a), usize::from(link.b));
            if i == j {
                return Err(missing);
            }
            let (a, b) = (*points.get(i).ok_or(missing)?, *points.get(j).ok_or(missing)?);
            let (by_a, by_b) = link.stick.pull(a.position, b.position);
            for (at, point, by) in [(i, a, by_a), (j, b, by_b)] {
                let pushed = point.pushed_in(world, mover, radius, by).map_err(refused)?;
                if let Some(slot) = points.get_mut(at) {
                    moved |= slot.position != pushed.position;
                    *slot = pushed;
                }
            }
        }
        if !moved {
            return Ok(round);
        }
    }
    Ok(rounds)
}

/// The number of consecutive steps in which points have hardly moved.
///
/// Corrections that work against each other and against a floor may jitter for ever, by about a
/// hundredth of a unit. Put such a body of points to sleep once it has been
/// [quiet](Self::for_steps) for some steps. Make each point [`Particle::at`] its position, and step
/// none of them until something touches it. Plain data: keep it beside the points.
///
/// ```
/// use tilesat::{Fx, Vec2, motion::response::{Particle, Quiet}};
/// let mut points = [Particle::at(Vec2::from_ints(1, 2)), Particle::moving(Vec2::from_ints(3, 4), Vec2::from_raw(0, 40))];
/// let mut quiet = Quiet::NOT;
/// for _ in 0..30 {
///     quiet = quiet.watch(&points, Fx::from_bits(4096));
/// }
/// assert!(quiet.for_steps(30));
/// points[0] = Particle::moving(points[0].position, Vec2::from_ints(0, 1));
/// assert_eq!(quiet.watch(&points, Fx::from_bits(4096)), Quiet::NOT);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Quiet {
    steps: u16,
}

impl Quiet {
    /// A body of points in motion.
    pub const NOT: Self = Self { steps: 0 };

    /// Counts one more step if no component of a velocity reached `still`; otherwise starts again
    /// at zero.
    ///
    /// Call it after the corrections of the step. Twice the acceleration of one step is a good
    /// `still`: a falling point exceeds it in its third step.
    #[must_use]
    pub fn watch(self, points: &[Particle], still: Fx) -> Self {
        let all = points.iter().all(|point| {
            let v = Raw::of(point.velocity());
            v.x.unsigned_abs().max(v.y.unsigned_abs()) < still.to_bits().max(0).unsigned_abs()
        });
        Self { steps: if all { self.steps.saturating_add(1) } else { 0 } }
    }

    /// Whether the points have been quiet for this many steps.
    #[must_use]
    pub const fn for_steps(self, steps: u16) -> bool {
        self.steps >= steps
    }
}
