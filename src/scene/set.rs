//! The bodies of a scene, and the list of those awake.

use super::body::{Mode, Slot};
use super::kernel::BodyShape;
use super::memory::Remembered;
use super::{SceneBody, SceneError, Shape};
use crate::broad::{BroadError, BroadPhase, Handle, Keyed, Pair, SortSweep};
use crate::filter::Filter;
use crate::num::{Fx, MOTION, check_motion};

/// When bodies fall asleep. Bodies that touch fall asleep together, once each has rested for
/// `steps` steps.
///
/// In a step of rest a body moves by less than `still` on either axis. A faster step is also one of
/// rest, if the body has moved no farther than `still` times `steps` since its rest began. That
/// limit is at least the gravity of two steps, and at most a unit. Without this rule, bodies in a
/// heap that push each other to and fro would never sleep. If there is gravity, the body also runs
/// into the level or into another body. A step in the air does not count, and does not end the
/// rest. In its last step of rest something must hold it from below: a ball that rolls off a corner
/// stays awake. If it moves by less than that limit in all these steps, it sleeps on the corner,
/// also beside the top of a peg. [`NEVER`](Self::NEVER) prevents that. A body that wakes because
/// another one touches it keeps its steps of rest.
///
/// Without friction, heaps of round bodies may stay awake for ever: see the
/// [limits](crate::scene#limits). In a funnel 9 of 38 pairs of capsules did, and so did most heaps
/// of six and more. Friction mostly ends that. Between slopes that are steeper than 45 degrees, it
/// often does not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sleep {
    /// The speed of rest, in units per step. A body that moves more slowly than that on purpose
    /// stops.
    pub still: Fx,
    /// The number of steps; 0 means never.
    pub steps: u8,
}

impl Sleep {
    /// No body sleeps.
    pub const NEVER: Self = Self { still: Fx::ZERO, steps: 0 };
}

impl Default for Sleep {
    /// The default: after 30 steps of rest, with `still` at 1/32 of a unit.
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl Sleep {
    pub(super) const DEFAULT: Self = Self { still: Fx::from_bits(1 << 11), steps: 30 };
}

/// [`Sleep`] as its difference from the default, so a static scene without bodies is all zeros and
/// takes no flash.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct SleepDifference {
    still: i32,
    steps: u8,
}

impl SleepDifference {
    const DEFAULT: (i32, u8) = (Sleep::DEFAULT.still.to_bits(), Sleep::DEFAULT.steps);

    pub(super) const fn of(sleep: Sleep) -> Self {
        let (still, steps) = Self::DEFAULT;
        Self { still: sleep.still.to_bits() ^ still, steps: sleep.steps ^ steps }
    }

    pub(crate) const fn sleep(self) -> Sleep {
        let (still, steps) = Self::DEFAULT;
        Sleep { still: Fx::from_bits(self.still ^ still), steps: self.steps ^ steps }
    }
}

/// Up to N bodies in a broad phase, moved through a level by one call per frame.
///
/// `B` is any [`BroadPhase`] with [`SceneTag`](super::SceneTag)s and room for N bodies:
/// `Scene<SortSweep<64, SceneTag>, 64>` is a [`SortSweepScene<64>`](super::SortSweepScene). The
/// [module](super) describes a step.
///
/// Plain data: a copy is a snapshot, and assigning it rolls back. A snapshot also needs the data
/// that your game keeps beside it: its [`PairEvents`](crate::broad::PairEvents) and
/// [`Exceptions`](crate::broad::Exceptions), the bytes of tiles that change. RAM: 164 bytes per
/// body, plus the broad phase. A scene may also [remember](Self::remembering) how bodies lie; `M`
/// is the number of places, 0 by default.
///
/// Costs on a Cortex-M0 with a `SortSweep`. Flash and stack are at opt-level "s". Instructions are
/// at opt-level 3, per step of 64 boxes and circles among tiles of all shapes.
///
/// <!-- costs:begin (benches/chips/run.sh --readme writes this) -->
/// | scene | flash, bytes | stack of a step, bytes | of a [ride](Self::ride) |
/// |---|--:|--:|--:|
/// | boxes and circles | 88 601 | 5 960 |  |
/// | the same, with [`Solid`](crate::Solid) lifts | 101 295 | 6 280 | 3 656 |
/// | the same, with [`ConvexSolid`](crate::world::ConvexSolid) lifts | 131 549 | 6 280 | 4 408 |
/// | [`WithCapsules`](super::WithCapsules) |  | 6 216 | 3 784 |
/// | [`AnyShape`](crate::shape::AnyShape) |  | 7 136 | 4 784 |
///
/// | 64 bodies | instructions per step |
/// |---|--:|
/// | fly and land, mean | 207 783 |
/// | fly and land, at most | 375 069 |
/// | lie in nooks of slopes, none may sleep | 730 904 |
/// | the same, if the scene [remembers](Self::remembering) | 108 671 |
/// | sleep | 58 |
/// <!-- costs:end -->
#[derive(Clone, Copy, Debug)]
#[doc(alias("PhysicsWorld", "simulation"))]
pub struct Scene<B, const N: usize, const M: usize = 0, S = Shape> {
    pub(crate) near: B,
    pub(super) slots: [Slot<S>; N],
    /// The bodies awake come first.
    pub(super) awake: [Handle; N],
    pub(crate) count: usize,
    /// How the bodies in the first slots lie, and beyond N the short motions of any.
    pub(super) memory: [Remembered; M],
    pub(crate) sleep: SleepDifference,
}

/// A [`Scene`] of up to N boxes and circles on a [`SortSweep`](crate::broad::SortSweep), as most
/// games need it: begin with [`SortSweepScene::empty`](Scene::empty).
///
/// Write the type of [`Scene`] itself for another broad phase, for other shapes, or for a scene
/// that [remembers](Scene::remembering).
pub type SortSweepScene<const N: usize> = Scene<SortSweep<N, Keyed<Filter>>, N>;

impl<const N: usize> SortSweepScene<N> {
    /// A scene without bodies: [`new`](Self::new) on an empty broad phase. In a `static` it takes
    /// no flash.
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, SortSweepScene};
    /// use tilesat::{Circle, Vec2, fx};
    /// let mut scene = SortSweepScene::<64>::empty();
    /// scene.insert(&SceneBody::new(Circle::new(Vec2::ZERO, fx!(4))?, 1))?;
    /// assert_eq!(scene.bodies().count(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub const fn empty() -> Self {
        Self::new(SortSweep::new())
    }
}

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, S: BodyShape> Scene<B, N, 0, S> {
    /// A scene without bodies, on an empty broad phase. It may be a `static`. This takes no flash
    /// with a [`SortSweep`](crate::broad::SortSweep) or a [`BruteForce`](crate::broad::BruteForce),
    /// because all its bits are zero.
    #[must_use]
    pub const fn new(near: B) -> Self {
        Self::with_sleep(near, Sleep::DEFAULT)
    }

    /// Like [`new`](Self::new), with other conditions for sleep.
    ///
    /// ```
    /// use tilesat::broad::{Keyed, SortSweep};
    /// use tilesat::scene::{Scene, Sleep};
    /// use tilesat::Filter;
    /// type Near = SortSweep<64, Keyed<Filter>>;
    /// let late = Sleep { steps: 120, ..Sleep::default() };
    /// let scene = Scene::<Near, 64>::with_sleep(Near::new(), late);
    /// assert_eq!(scene.sleep().steps, 120);
    /// ```
    #[must_use]
    pub const fn with_sleep(near: B, sleep: Sleep) -> Self {
        Self::remembering(near, sleep)
    }
}

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, const M: usize, S: BodyShape> Scene<B, N, M, S> {
    /// A scene that remembers how bodies at rest lie, in the first M of its N slots.
    ///
    /// A body that lies tries the same motion through the level in each step, and does not move.
    /// Such a motion is answered from memory, with the same bits and the same events in the same
    /// order. Bodies that a step did not change, with all that they touch, repeat that step until
    /// another body comes near.
    ///
    /// Some bodies never rest: a ball on a slope leans on a box, which pushes it away, and it rolls
    /// back. If M is larger than N, the scene also remembers the last M - N short motions of such
    /// bodies. 16 are enough for two or three of them.
    ///
    /// In return, name each region of the level that [changes](Self::wake_region), even if no body
    /// sleeps. It may change by a tile, a [`Solid`](crate::Solid) that moves, or another level for
    /// a body. If your replies about two bodies change, [wake](Self::wake) both. A snapshot has no
    /// memory; a restored scene looks at the level once.
    ///
    /// RAM: 124 bytes for each of M.
    ///
    /// ```
    /// use tilesat::broad::SortSweep;
    /// use tilesat::scene::{SceneBody, SceneTag, Sleep};
    /// use tilesat::{Aabb, Scene, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("..\n##", &KINDS)?; // the floor is at y = 16
    /// type Crates = Scene<SortSweep<8, SceneTag>, 8, 8>; // `8, 12` also keeps four motions
    /// let mut scene = Crates::remembering(SortSweep::new(), Sleep::NEVER);
    /// let body = Aabb::new(Vec2::from_ints(4, 8), Vec2::from_ints(12, 16))?;
    /// let crate_ = scene.insert(&SceneBody::new(body, 1))?;
    /// let gravity = Vec2::new(fx!(0), fx!(0.25));
    /// for _ in 0..100 {
    ///     scene.step(&level, gravity, |_| {})?; // looks at the level once
    /// }
    /// let gone = TileMap::from_ascii("..\n..", &KINDS)?;
    /// scene.wake_region(&gone.bounds());
    /// scene.step(&gone, gravity, |_| {})?;
    /// assert!(scene.body(crate_)?.velocity.y > 0); // it falls
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub const fn remembering(near: B, sleep: Sleep) -> Self {
        Self {
            near,
            slots: [Slot::FREE; N],
            awake: [Handle::new(0, 0); N],
            count: 0,
            memory: [Remembered::Empty; M],
            sleep: SleepDifference::of(sleep),
        }
    }

    /// When its bodies fall asleep.
    #[must_use]
    pub const fn sleep(&self) -> Sleep {
        self.sleep.sleep()
    }

    /// Sets when bodies fall asleep, from the next step on.
    ///
    /// ```
    /// use tilesat::scene::{Sleep, SortSweepScene};
    /// let mut scene = SortSweepScene::<8>::empty();
    /// assert_eq!(scene.sleep(), Sleep::default());
    /// scene.set_sleep(Sleep::NEVER);
    /// assert_eq!(scene.sleep(), Sleep::NEVER);
    /// ```
    pub const fn set_sleep(&mut self, sleep: Sleep) {
        self.sleep = SleepDifference::of(sleep);
    }

    /// The broad phase: for nearest bodies and those in a region, by their boxes, and for the tags
    /// of bodies. [`cast_ray`](Self::cast_ray), [`overlapping`](Self::overlapping) and
    /// [`at_point`](Self::at_point) ask about the shapes of bodies.
    ///
    /// The tag of a body is a [`Keyed`], and its field `tag` is the body's filter:
    /// `|_, tag| tag.tag.layers.intersects(FOES)`. A filter with `still` marks a body that rests or
    /// is fixed.
    #[must_use]
    pub const fn near(&self) -> &B {
        &self.near
    }

    /// Adds a body, awake, and wakes the bodies that it touches. A sensor wakes no other body.
    ///
    /// The call does not look at the level. A body that overlaps the level stays there, and each
    /// step that would move it reports it as [`Held`](super::SceneEvent::Held). A body that floats
    /// at rest is not tested, so it is not reported. If that can happen, test
    /// [`Shape::overlaps_level`] first.
    ///
    /// # Errors
    /// [`Full`](BroadError::Full), the errors of the broad phase, or a velocity that no step can
    /// make. Nothing is changed then.
    pub fn insert(&mut self, body: &SceneBody<S>) -> Result<Handle, SceneError> {
        body.shape.check_body().map_err(SceneError::call)?;
        check_motion(body.velocity, MOTION).map_err(SceneError::call)?;
        // The broad phase may have room for more bodies.
        let Some(slot) = self.slots.get_mut(self.near.table().state.next_slot()) else {
            return Err(SceneError::call(BroadError::Full { capacity: N as u16 }));
        };
        let handle = self.near.insert(&body.shape.aabb(), body.tag(body.mass.is_none())).map_err(SceneError::call)?;
        *slot = Slot::of(body, handle);
        self.wake_body(handle, false);
        self.wake_neighbours(body);
        Ok(handle)
    }

    /// Removes a body, and wakes the bodies that it touched. A sensor wakes no body.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn remove(&mut self, handle: Handle) -> Result<SceneBody<S>, SceneError> {
        let body = *self.body(handle)?;
        self.near.remove(handle).map_err(|e| SceneError::of(handle, e))?;
        // No enumeration of pairs is running.
        self.near.forget(handle.slot());
        self.remove_from_awake(handle);
        if let Some(slot) = self.slots.get_mut(handle.slot()) {
            *slot = Slot::FREE;
        }
        self.wake_neighbours(&body);
        Ok(body)
    }

    /// All bodies, including those that sleep or are fixed, in the order of their slots. That order
    /// depends on insertion; sort by keys if you need a canonical one.
    ///
    /// Cost: a look at each of the N slots.
    pub fn bodies(&self) -> impl Iterator<Item = (Handle, &SceneBody<S>)> {
        let taken = self.slots.iter().enumerate().filter(|(_, slot)| slot.mode != Mode::Free);
        taken.map(|(at, slot)| (Handle::new(at, slot.generation), &slot.body))
    }

    /// The current state of a body.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn body(&self, handle: Handle) -> Result<&SceneBody<S>, SceneError> {
        self.slot(handle).map(|slot| &slot.body)
    }

    /// Whether a body is awake, so steps move it. Fixed bodies are never awake.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn is_awake(&self, handle: Handle) -> Result<bool, SceneError> {
        self.slot(handle).map(Slot::is_awake)
    }

    /// Whether the level, or bodies that the level carries, carried a body in the last step. Always
    /// true for fixed bodies.
    ///
    /// Only floors carry. For a body that is wedged between two slopes above 45 degrees it is
    /// false. [`Mover::supported`](crate::Mover::supported) also looks for wedges.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn is_supported(&self, handle: Handle) -> Result<bool, SceneError> {
        self.slot(handle).map(|slot| slot.support != super::body::ALOFT)
    }

    /// Whether two bodies touch of which none moves by itself: each sleeps, is fixed, or has just
    /// been woken. The next step may not report such a pair. Call it in the closure of
    /// [`PairEvents::finish`](crate::broad::PairEvents::finish), which asks for pairs that it
    /// knows. It does not ask the filters. False if one was removed.
    #[must_use]
    pub fn rests(&self, pair: &Pair) -> bool {
        let rested = |slot: &&Slot<S>| slot.mode != Mode::Awake;
        let [a, b] = [pair.a, pair.b].map(|handle| self.slot(handle).ok().filter(rested));
        a.zip(b).is_some_and(|(a, b)| a.body.shape.touches(&b.body.shape))
    }

    /// The bodies awake, in no particular order.
    #[must_use]
    pub fn awake(&self) -> &[Handle] {
        self.awake.get(..self.count).unwrap_or_default()
    }

    pub(super) fn slot(&self, handle: Handle) -> Result<&Slot<S>, SceneError> {
        let slot = self.slots.get(handle.slot()).filter(|slot| slot.mode != Mode::Free && self.near.contains(handle));
        slot.ok_or(SceneError::of(handle, BroadError::Stale(handle)))
    }

    pub(super) fn slot_mut(&mut self, handle: Handle) -> Result<&mut Slot<S>, SceneError> {
        self.slot(handle)?;
        self.slots.get_mut(handle.slot()).ok_or(SceneError::of(handle, BroadError::Stale(handle)))
    }
}
