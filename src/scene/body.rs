//! The bodies of a scene: what a game gives, boxes and circles mixed, what a step keeps of each, and what becomes of two that run into each other.

use super::Shape;
use crate::broad::{Handle, Keyed};
use crate::filter::Filter;
use crate::motion::response::exchange;
use crate::motion::{Masses, Surface};
use crate::num::{Axis, Fx, Ratio, Raw, Toi, Vec2, mul_div};
use crate::shape::Aabb;
use core::num::NonZeroU8;

/// One body: what it looks like and how it behaves. Plain data.
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
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SceneBody {
    /// What it looks like, and where.
    pub shape: Shape,
    /// Units a step. A body without a mass does not move by it, but others feel it: a conveyor.
    pub velocity: Vec2,
    /// In any unit that all bodies share; `None` is a wall, a platform, a trigger: no step moves it.
    pub mass: Option<NonZeroU8>,
    /// Its friction and restitution at the level. Where two bodies meet, the surface of the one that bounces more counts, at a tie the one with less friction.
    pub surface: Surface,
    /// Whom it meets. [Sensors](Filter::sensor) are told, push nobody and are pushed by nobody; [still](Filter::still) is the scene's to say.
    pub filter: Filter,
    /// Given by the game, unique among the bodies: with that no result depends on the order of insertion. A name for the game's own use, too. Where two have one key, the
    /// slot decides which of a pair is `a`; nothing else changes.
    pub key: u32,
    /// Gravity does nothing to it: a balloon, a bullet, a lift. It falls asleep in the air where it hardly moves.
    pub floats: bool,
    /// It meets others [on its whole way](super#fast-bodies), however slow it is: a crusher among small things. What moves by more than half of its smaller side in a
    /// step does so without being told to.
    pub fast: bool,
}

impl SceneBody {
    /// A body of mass 1 at rest that stops at what it runs into and slides along it, and meets all.
    #[must_use]
    pub fn new(shape: impl Into<Shape>, key: u32) -> Self {
        Self { shape: shape.into(), mass: Some(NonZeroU8::MIN), key, ..Self::NOBODY }
    }

    /// One that no step moves.
    #[must_use]
    pub fn fixed(shape: impl Into<Shape>, key: u32) -> Self {
        Self { mass: None, ..Self::new(shape, key) }
    }

    const NOBODY: Self = Self {
        shape: Shape::Aabb(Aabb::from_raw_unchecked(Raw::ZERO, Raw::ZERO)),
        velocity: Vec2::ZERO,
        mass: None,
        surface: Surface::SLICK,
        filter: Filter::new(crate::LayerMask::ALL, crate::LayerMask::ALL),
        key: 0,
        floats: false,
        fast: false,
    };

    /// What a step of gravity gives it.
    pub(super) fn weight(&self, gravity: Vec2) -> Vec2 {
        if self.floats { Vec2::ZERO } else { gravity }
    }

    pub(super) fn tag(&self, still: bool) -> Keyed<Filter> {
        Keyed { key: self.key, tag: self.filter.with_still(still) }
    }
}

/// What a slot is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    /// Nobody's.
    Free,
    /// No step moves it.
    Fixed,
    /// It is in the list of those.
    Awake,
    Asleep,
}

/// A body and what steps know of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slot {
    pub(super) body: SceneBody,
    /// That of the body's handle.
    pub(super) generation: u16,
    pub(super) mode: Mode,
    /// It was awake when the last step began, which told of all that it touched.
    pub(super) told: bool,
    /// For how many steps it has hardly moved.
    pub(super) quiet: u8,
    /// How many bodies are between it and the level or a fixed body that carries it, as of the last step.
    pub(super) support: u8,
    pub(super) tally: Tally,
    pub(super) way: Way,
}

/// What a body does in a step, once its velocity is known: straight ways only.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    /// Units in a whole step, of which it makes what is left.
    pub(super) rate: Vec2,
    /// When it is where its shape is: at the step's end, but for those that are swept.
    pub(super) since: Toi,
    /// What ends this way, and when.
    pub(super) end: (Toi, End),
    /// The slots of those that it has met in this step, and how many there are.
    pub(super) met: ([u16; 3], u8),
    /// How often it was turned.
    pub(super) turns: u8,
    pub(super) pace: Pace,
}

/// How often a way may be turned in a step; then the body waits for the next one. Between plates that close there is no last time.
pub(super) const TURNS: u8 = 8;

/// How a body makes its step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pace {
    /// It meets others where they are at the step's start, or nobody is in its reach.
    Slow,
    /// From one thing that it meets to the next.
    Swept,
}

/// What ends a straight way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum End {
    Level,
    /// The one in this slot.
    Body(u16),
    /// The step.
    Step,
}

impl Way {
    pub(super) const REST: Self = Self::made(Vec2::ZERO);

    /// It has been made.
    pub(super) const fn made(rate: Vec2) -> Self {
        Self { rate, since: Toi::ONE, end: (Toi::ONE, End::Step), met: ([0; 3], 0), turns: 0, pace: Pace::Slow }
    }

    /// What is left of it at a time.
    pub(super) fn left(&self, at: Toi) -> Vec2 {
        Toi::exact(Toi::ONE.raw().wrapping_sub(at.raw())).of(self.rate)
    }

    /// From a time on with another velocity.
    pub(super) fn go_on(&mut self, time: Toi, velocity: Vec2) {
        (self.since, self.rate) = (time, if self.waits() { Vec2::ZERO } else { velocity });
    }

    /// It is turned no more in this step.
    pub(super) fn waits(&self) -> bool {
        self.turns >= TURNS
    }

    /// It is held: nothing that it is hit by moves it in this step.
    pub(super) const HELD: u8 = u8::MAX;

    pub(super) fn is_held(&self) -> bool {
        self.turns == Self::HELD
    }

    /// Whether it may be led elsewhere.
    pub(super) fn goes(&self) -> bool {
        self.pace == Pace::Swept && !self.waits()
    }

    /// Whether two have met in this step already, or one of them so many that it cannot know.
    pub(super) fn has_met(&self, other: Handle) -> bool {
        let (slots, count) = &self.met;
        let known = slots.iter().take((*count).into());
        usize::from(*count) >= slots.len() || known.into_iter().any(|&slot| usize::from(slot) == other.slot())
    }

    pub(super) fn note(&mut self, other: Handle) {
        let (slots, count) = &mut self.met;
        if let Some(place) = slots.get_mut(usize::from(*count)) {
            (*place, *count) = (other.slot() as u16, *count + 1);
        }
    }
}

/// What a step collects for a body before anything moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tally {
    /// The farthest that anything pushes it to each side.
    pub(super) low: Vec2,
    pub(super) high: Vec2,
    /// The sum of the changes of its velocity.
    pub(super) kick: Vec2,
    /// How many bodies run into it.
    pub(super) hits: u16,
    /// Another body that it touches, directly or not; itself where it stands for all of them.
    pub(super) link: u16,
    /// What `support` becomes.
    pub(super) support: u8,
    /// Of those that it stands for, the fewest quiet steps.
    pub(super) calm: u8,
}

/// Carried by nothing.
pub(super) const ALOFT: u8 = u8::MAX;

impl Slot {
    pub(super) const FREE: Self = Self {
        body: SceneBody::NOBODY,
        generation: 0,
        mode: Mode::Free,
        told: false,
        quiet: 0,
        support: ALOFT,
        tally: Tally::of(0),
        way: Way::REST,
    };

    pub(super) fn of(body: &SceneBody, handle: Handle) -> Self {
        let fixed = body.mass.is_none();
        let mode = if fixed { Mode::Fixed } else { Mode::Asleep };
        let support = if fixed { 0 } else { ALOFT };
        Self { body: *body, generation: handle.generation(), mode, support, ..Self::FREE }
    }

    /// Whether a look at where it starts does not do.
    pub(super) fn is_fast(&self) -> bool {
        // Each is a motion: no sum wraps.
        let Tally { low, high, kick, .. } = self.tally;
        let Raw { x, y } = Raw::of(self.body.velocity).add(Raw::of(kick)).add(Raw::of(low)).add(Raw::of(high));
        let bounds = self.body.shape.aabb();
        let size = bounds.hi().sub(bounds.lo());
        let speed = x.unsigned_abs().max(y.unsigned_abs());
        self.body.fast || speed.saturating_mul(2) > size.x.min(size.y).unsigned_abs()
    }
}

impl Tally {
    pub(super) const fn of(slot: u16) -> Self {
        let none = Vec2::ZERO;
        Self { low: none, high: none, kick: none, hits: 0, link: slot, support: ALOFT, calm: u8::MAX }
    }

    /// Where all that pushes it brings it.
    pub(super) fn push(&self) -> Vec2 {
        self.low + self.high
    }

    pub(super) fn pushed(&mut self, by: Vec2) {
        (self.low, self.high) = (self.low.min(by), self.high.max(by));
    }
}

/// How two overlapping bodies act on each other.
#[derive(Clone, Copy)]
pub(super) struct Meeting {
    axis: Axis,
    pub(super) masses: Masses,
    surface: Surface,
    /// The velocities that meet.
    a: Vec2,
    b: Vec2,
    pub(super) moves_a: bool,
    pub(super) moves_b: bool,
}

/// Which of two bodies is on top of the other, as gravity sees it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Top {
    A,
    B,
    Neither,
}

impl Top {
    /// The contact's axis, from A to B, must be nearer to gravity than to its perpendicular.
    pub(super) fn of(axis: Axis, gravity: Axis) -> Self {
        let along = axis.dot(gravity);
        if along.unsigned_abs() <= axis.perp_dot(gravity).unsigned_abs() {
            Self::Neither
        } else if along > 0 {
            Self::A
        } else {
            Self::B
        }
    }
}

impl Meeting {
    /// `None` where neither can be moved.
    ///
    /// What is below, and fixed or [carried](carries), counts as falling for one step: then what lies on it falls by as much as it is pushed up in each step, and
    /// rests. That body has no more energy afterwards. Seen from the one below, whose velocity is g, it has not; its change is `j n + f t` with `|f| <= j`, for no
    /// friction is above 1, and n is nearer to -g than to its perpendicular: so the change is against g, and adding g back gains nothing.
    /// For one that floats it stands still, and nothing is added.
    pub(super) fn of(a: &Slot, b: &Slot, axis: Axis, gravity: Vec2) -> Option<Self> {
        let (one, other) = (&a.body, &b.body);
        let masses = match (one.mass, other.mass) {
            (None, None) => return None,
            (None, Some(_)) => Masses::A_FIXED,
            (Some(_), None) => Masses::B_FIXED,
            (Some(m), Some(n)) => Masses::new(m.get(), n.get()).unwrap_or(Masses::EQUAL),
        };
        let surface = acting(&one.surface, &other.surface);
        let (moves_a, moves_b) = (one.mass.is_some(), other.mass.is_some());
        let (v, w) = (one.velocity, other.velocity);
        let own = Self { axis, masses, surface, a: v, b: w, moves_a, moves_b };
        let slick = surface.friction() == Ratio::ZERO;
        Some(match Top::of(axis, toward(gravity)) {
            Top::A if !moves_b => Self { b: w + one.weight(gravity), ..own },
            Top::B if !moves_a => Self { a: v + other.weight(gravity), ..own },
            Top::A if moves_a && carries(b, a, gravity, slick) => {
                Self { masses: Masses::B_FIXED, b: one.weight(gravity), moves_b: false, ..own }
            }
            Top::B if moves_b && carries(a, b, gravity, slick) => {
                Self { masses: Masses::A_FIXED, a: other.weight(gravity), moves_a: false, ..own }
            }
            _ => own,
        })
    }

    /// Whether they approach.
    pub(super) fn is_hit(&self) -> bool {
        self.axis.dot_vec(self.a - self.b) > 0
    }

    /// By what the velocities change, where the body with more hits has so many.
    ///
    /// Of each change only that part counts, so of the changes of one body no more than one whole one does; what it ends with is then a mean of what it had and
    /// of what its hits give it, and no mean of velocities has more energy than the mean of their energies.
    pub(super) fn kicks(&self, hits: u16) -> (Vec2, Vec2) {
        let Ok((a, b)) = exchange(self.a, self.b, self.axis, self.masses, &self.surface) else {
            return (Vec2::ZERO, Vec2::ZERO);
        };
        (part(a - self.a, hits), part(b - self.b, hits))
    }
}

/// Whether a body does not give way to one on top of it: it lies on the level, or on bodies that do, and the push that it gets goes into the ground. If it gave
/// way, a pile would sink into itself.
///
/// Not where it rises; nor, where there is friction, where it goes sideways by more than gravity gives in a step: then it takes the one on top along.
fn carries(lower: &Slot, upper: &Slot, gravity: Vec2, slick: bool) -> bool {
    let v = lower.body.velocity;
    lower.support < upper.support
        && gravity.dot(v) >= 0
        && (slick || gravity.perp_dot(v).unsigned_abs() <= gravity.length_squared())
}

/// How many are between a body on top and what carries all, if the one below it has so many.
pub(super) fn carried(below: u8) -> u8 {
    if below == ALOFT { ALOFT } else { below + 1 }
}

/// Which of two surfaces counts: not a matter of which is A.
fn acting(a: &Surface, b: &Surface) -> Surface {
    let rank = |s: &Surface| (s.restitution().raw(), !s.friction().raw());
    if rank(a) < rank(b) { *b } else { *a }
}

/// The direction of a vector.
pub(super) fn toward(v: Vec2) -> Axis {
    let (x, y) = v.raw();
    Axis::new(x, y)
}

/// `v / n`, toward zero.
fn part(v: Vec2, n: u16) -> Vec2 {
    if n <= 1 {
        return v;
    }
    let of = |c: i32| {
        let size = mul_div(c.unsigned_abs(), 1, n.into()) as i32;
        if c < 0 { size.wrapping_neg() } else { size }
    };
    let (x, y) = v.raw();
    Vec2::from_raw(of(x), of(y))
}

/// A part of what is left of the step from a time on, as a time of the step, rounded down.
pub(super) fn later(from: Toi, part: Toi) -> Toi {
    let left = Toi::ONE.raw().wrapping_sub(from.raw());
    Toi::clamped(from.raw().wrapping_add(part.of_raw(left as i32) as u32))
}

/// How fast the ends of a normal come nearer, to nearest.
pub(super) fn approach(axis: Axis, velocity: Vec2) -> Fx {
    let ((x, y), Raw { x: vx, y: vy }) = (axis.unit().raw(), Raw::of(velocity));
    let sum = i64::from(x) * i64::from(vx) + i64::from(y) * i64::from(vy);
    Fx::from_bits(((sum + (1 << 29)) >> 30).clamp(0, i32::MAX.into()) as i32)
}
