//! The bodies of a scene: the values that a game sets, and the state that steps keep.

use super::Shape;
use super::at_boxes::AtBoxes;
use super::blocked_sides::{blocked_sides, still_blocked};
use super::body_path::{BodyPath, Drift};
use super::farthest_pushes::FarthestPushes;
use super::kernel::BodyShape;
use crate::broad::{Handle, Keyed};
use crate::filter::{Filter, LayerMask};
use crate::motion::{Responses, Surface};
use crate::num::{Raw, Vec2};
use core::num::NonZeroU8;

/// One body: its shape, and how it behaves. Plain data.
///
/// ```
/// use core::num::NonZeroU8;
/// use tilesat::scene::SceneBody;
/// use tilesat::{Circle, Filter, Fx, Ratio, Surface, Vec2};
/// let ball = Circle::new(Vec2::from_ints(20, 20), Fx::from_num(5))?;
/// let rubber = Surface::new(Ratio::percent(80).unwrap(), Ratio::ZERO).resting_below(Fx::ONE);
/// let body = SceneBody { surface: rubber, velocity: Vec2::from_ints(1, 0), ..SceneBody::new(ball, 7) };
/// let trigger = SceneBody { filter: Filter::default().with_sensor(true), ..SceneBody::fixed(ball, 8) };
/// assert_eq!((body.mass, trigger.mass), (NonZeroU8::new(1), None));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SceneBody<S = Shape> {
    /// Its shape and position.
    pub shape: S,
    /// The velocity in units per step. A body without a mass does not move by it, but it acts on
    /// others, as on a conveyor.
    pub velocity: Vec2,
    /// The mass in any unit that all bodies share. `None` is a wall, a platform or a trigger, which
    /// no step moves.
    pub mass: Option<NonZeroU8>,
    /// Its restitution and friction at the level. If two bodies meet, the surface that bounces more
    /// is used, on a tie the one with less friction. If that ties too, set
    /// [`resting_below`](Surface::resting_below) on both. That of the lower one counts if it
    /// carries the other one, or else that of the smaller key.
    pub surface: Surface,
    /// The response to level tiles with flags, and [to all others](Responses::otherwise), instead
    /// of a bounce by its [`surface`](Self::surface). A grenade that stops in mud touches it, a
    /// ball slides along grass, and a bullet touches all.
    pub responses: Responses,
    /// Which bodies it meets. [Sensors](Filter::sensor) are reported, but do not push and are not
    /// pushed. The scene sets [still](Filter::still).
    pub filter: Filter,
    /// A number that you choose, unique among the bodies. Unique keys make all results independent
    /// of the order of insertion. You can use it to identify the body, too. If two bodies share a
    /// key, the slot decides which of a pair is `a`; nothing else changes.
    pub key: u32,
    /// Whether gravity does not act on it, as on a balloon, a bullet or a lift. Such a body falls
    /// asleep in the air if it hardly moves.
    pub floats: bool,
    /// Whether it meets others [on its whole path](super#fast-bodies), however slow it is. Set it
    /// for a crusher among small things, or a hero. Without it, bodies that press against others in
    /// every step sink in. A body that moves by more than half of its smaller side in a step is
    /// always fast. Fast bodies are [expensive](super#fast-bodies) in a crowd.
    pub fast: bool,
}

impl SceneBody {
    /// A body of mass 1 at rest. It stops at surfaces, slides along them, and meets all bodies.
    #[must_use]
    pub fn new(shape: impl Into<Shape>, key: u32) -> Self {
        Self::of(shape, key)
    }

    /// A body that no step moves.
    #[must_use]
    pub fn fixed(shape: impl Into<Shape>, key: u32) -> Self {
        Self { mass: None, ..Self::new(shape, key) }
    }
}

impl<S: BodyShape> SceneBody<S> {
    /// Like [`new`](SceneBody::new), for a scene of any [set of shapes](super::WithCapsules).
    ///
    /// ```
    /// use tilesat::scene::WithCapsules;
    /// use tilesat::{Capsule, SceneBody, Vec2, fx};
    /// let pill = Capsule::new(Vec2::from_ints(0, 0), Vec2::from_ints(8, 0), fx!(4))?;
    /// let wall = SceneBody::<WithCapsules> { mass: None, ..SceneBody::of(pill, 1) };
    /// assert_eq!(wall.shape, WithCapsules::Capsule(pill));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub fn of(shape: impl Into<S>, key: u32) -> Self {
        Self::of_shape(shape.into(), key)
    }

    /// Like [`of`](Self::of), usable in constants. So the bodies of a level can be a table in
    /// flash.
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, Shape};
    /// use tilesat::{Aabb, Fx, Vec2};
    /// const fn crate_at(x: i16, y: i16) -> Shape {
    ///     match Aabb::from_size(Vec2::from_ints(x, y), Vec2::from_ints(8, 8)) {
    ///         Ok(bounds) => Shape::Aabb(bounds),
    ///         Err(_) => panic!("a crate"),
    ///     }
    /// }
    /// static BODIES: [SceneBody; 2] = [
    ///     SceneBody::of_shape(crate_at(20, 0), 1),
    ///     SceneBody { mass: None, ..SceneBody::of_shape(crate_at(40, 0), 2) }, // a wall
    /// ];
    /// assert_eq!(BODIES[0], SceneBody::new(crate_at(20, 0), 1));
    /// assert_eq!(BODIES[1], SceneBody::fixed(crate_at(40, 0), 2));
    /// ```
    #[must_use]
    pub const fn of_shape(shape: S, key: u32) -> Self {
        Self {
            shape,
            velocity: Vec2::ZERO,
            mass: Some(NonZeroU8::MIN),
            surface: Surface::SLICK,
            responses: Responses::NONE,
            filter: Filter::new(LayerMask::ALL, LayerMask::ALL),
            key,
            floats: false,
            fast: false,
        }
    }

    /// All zero: see [`Slot::FREE`].
    const NOBODY: Self =
        Self { mass: None, filter: Filter::new(LayerMask::NONE, LayerMask::NONE), ..Self::of_shape(S::POINT, 0) };

    /// The velocity that a step of gravity adds.
    pub(super) fn weight(&self, gravity: Vec2) -> Vec2 {
        if self.floats { Vec2::ZERO } else { gravity }
    }

    pub(super) fn tag(&self, still: bool) -> Keyed<Filter> {
        Keyed { key: self.key, tag: self.filter.with_still(still) }
    }
}

/// The state of a slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Mode {
    /// Unused.
    Free = 0,
    /// No step moves it.
    Fixed = 1,
    /// Its body is in the list of those awake, and was not when the last step began. So that step
    /// did not report everything that it touched.
    Woken = 2,
    /// It was in the list then, too.
    Awake = 3,
    Asleep = 4,
}

impl Mode {
    pub(super) const fn is_awake(self) -> bool {
        matches!(self, Self::Awake | Self::Woken)
    }
}

/// A body, and the state that steps keep for it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slot<S> {
    pub(super) body: SceneBody<S>,
    /// The generation of the body's handle.
    pub(super) generation: u16,
    pub(super) mode: Mode,
    /// For how many steps it has hardly moved.
    pub(super) quiet: u8,
    /// How many bodies are between it and the level, or a fixed body that carries it, as of the
    /// last step.
    pub(super) support: u8,
    /// The slot of that fixed body.
    pub(super) ground: u16,
    /// The [sides](super::blocked_sides) to which it was last pushed without effect.
    pub(super) blocked: u8,
    pub(super) tally: Tally,
    pub(super) path: BodyPath,
}

/// The values that a step collects for a body before anything moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tally {
    pub(super) pushes: FarthestPushes,
    /// The sum of the changes of its velocity.
    pub(super) kick: Vec2,
    /// How many bodies run into it. After all have moved, the fewest quiet steps of the bodies that
    /// it represents.
    pub(super) hits: u16,
    /// How many of those change only its velocity along x, and along y.
    pub(super) straight: (u8, u8),
    /// Another body that it touches, directly or not; its own slot if it represents all of them.
    pub(super) link: u16,
    /// The slot of the one body below that it touches, if there is only one.
    pub(super) under: u16,
    /// How far it has come while quiet; kept from step to step.
    pub(super) drift: Drift,
    pub(super) at_boxes: AtBoxes,
}

/// No slot.
pub(super) const NOBODY: u16 = u16::MAX;

/// More than one slot.
pub(super) const SEVERAL: u16 = u16::MAX - 1;

/// No slot: the body does not fall asleep in this step. At its end nothing holds it, or it begins
/// to touch another one.
pub(super) const UNSETTLED: u16 = u16::MAX - 2;

/// Nothing carries it.
pub(super) const ALOFT: u8 = u8::MAX;

impl<S: BodyShape> Slot<S> {
    /// A slot without a body. All its bits are zero, so a static scene without bodies takes no
    /// flash. Only the mode matters.
    pub(super) const FREE: Self = Self {
        body: SceneBody::NOBODY,
        generation: 0,
        mode: Mode::Free,
        quiet: 0,
        support: 0,
        ground: 0,
        blocked: 0,
        tally: Tally { under: 0, ..Tally::of(0) },
        path: BodyPath::BLANK,
    };

    pub(super) fn of(body: &SceneBody<S>, handle: Handle) -> Self {
        let fixed = body.mass.is_none();
        let mode = if fixed { Mode::Fixed } else { Mode::Asleep };
        let support = if fixed { 0 } else { ALOFT };
        Self {
            body: *body,
            generation: handle.generation(),
            mode,
            quiet: 0,
            support,
            ground: NOBODY,
            blocked: 0,
            tally: Tally::of(0),
            path: BodyPath::REST,
        }
    }

    pub(super) fn is_awake(&self) -> bool {
        self.mode.is_awake()
    }

    /// Updates the blocked sides in a step that moved it by `made`: the level stopped it, or others
    /// pushed back.
    pub(super) fn block(&mut self, by_level: u8, made: Vec2) {
        let FarthestPushes { low, high } = self.tally.pushes;
        let (pushed, one_sided) = (low + high, low == Vec2::ZERO || high == Vec2::ZERO);
        let by_others = if one_sided { 0 } else { blocked_sides(low, pushed) | blocked_sides(high, pushed) };
        self.blocked = still_blocked(still_blocked(self.blocked, low, made), high, made) | by_level | by_others;
    }

    /// Whether it lay on other bodies in the last step.
    pub(super) fn lies(&self, gravity: Vec2) -> bool {
        gravity != Vec2::ZERO && self.support != 0 && self.support != ALOFT
    }

    /// Whether a test of its start is not enough.
    pub(super) fn is_fast(&self) -> bool {
        // Each is a motion: no sum wraps.
        let Tally { pushes: FarthestPushes { low, high }, kick, .. } = self.tally;
        self.makes_fast(Raw::of(self.body.velocity).add(Raw::of(kick)).add(Raw::of(low)).add(Raw::of(high)))
    }

    /// Whether it is fast already by its own velocity, before others push it.
    pub(super) fn leads_fast(&self) -> bool {
        self.makes_fast(Raw::of(self.body.velocity))
    }

    fn makes_fast(&self, Raw { x, y }: Raw) -> bool {
        let bounds = self.body.shape.aabb();
        let size = bounds.hi().sub(bounds.lo());
        let speed = x.unsigned_abs().max(y.unsigned_abs());
        self.body.fast || speed.saturating_mul(2) > size.x.min(size.y).unsigned_abs()
    }
}

impl Tally {
    pub(super) const fn of(slot: u16) -> Self {
        Self {
            pushes: FarthestPushes::NONE,
            kick: Vec2::ZERO,
            hits: 0,
            straight: (0, 0),
            link: slot,
            under: NOBODY,
            drift: Drift::NONE,
            at_boxes: AtBoxes::NONE,
        }
    }

    pub(super) fn hit(&mut self, (along_x, along_y): (bool, bool)) {
        self.hits = self.hits.saturating_add(1);
        let (x, y) = &mut self.straight;
        (*x, *y) = (x.saturating_add(along_x.into()), y.saturating_add(along_y.into()));
    }

    /// How many hits share the change of its velocity by one of them. If each changes only one of
    /// its components, those that change the other do not count.
    pub(super) fn sharers(&self, (along_x, along_y): (bool, bool)) -> u16 {
        let (x, y) = (u16::from(self.straight.0), u16::from(self.straight.1));
        match (x + y == self.hits, along_x, along_y) {
            (true, true, false) => x,
            (true, false, true) => y,
            _ => self.hits,
        }
    }

    /// The sum of all pushes on it.
    pub(super) fn push(&self) -> Vec2 {
        self.pushes.sum()
    }
}
