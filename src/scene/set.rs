//! The bodies together: those in the scene, and those awake.

use super::body::{Mode, Slot};
use super::kernel::BodyShape;
use super::memory::Place;
use super::{SceneBody, SceneError, Shape};
use crate::broad::{BroadError, BroadPhase, Handle, Keyed, Pair, SortSweep};
use crate::filter::Filter;
use crate::num::{Fx, MOTION, check_motion};

/// When bodies fall asleep: after this many steps of rest, for all bodies that touch, directly or
/// not.
///
/// In a step of rest a body moves by less than `still` on either axis. A faster step is one of rest
/// too, if the body has come no farther than `still` times `steps` since it rests: on the whole it
/// was slow. (At least that is the gravity of two steps, at most a unit.) Without this, bodies in a
/// heap that push each other to and fro would never sleep. If there is gravity, the body also runs
/// into the level or into another body. A step in the air does not count, and does not end the
/// rest. In its last step of rest something must hold it from below: a ball that rolls off a corner
/// stays awake. A body that wakes because another one touches it keeps its steps of rest.
///
/// Without friction, heaps of round bodies in a funnel may stay awake for ever: 9 of 38 pairs of
/// capsules did, and most heaps of six and more. Friction ends that.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sleep {
    /// Units per step. A body that moves more slowly than that on purpose never arrives.
    pub still: Fx,
    /// 0 means never.
    pub steps: u8,
}

impl Sleep {
    /// No body sleeps.
    pub const NEVER: Self = Self { still: Fx::ZERO, steps: 0 };
}

impl Default for Sleep {
    /// After 30 steps of rest, with `still` at 1/32 of a unit.
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl Sleep {
    pub(super) const DEFAULT: Self = Self { still: Fx::from_bits(1 << 11), steps: 30 };
}

/// [`Sleep`] as its difference from the default, so that a static scene without bodies takes no
/// flash: all its bits are zero.
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
/// Plain data: a copy is a snapshot, and assigning it rolls back. The data that your game keeps
/// beside it is part of a snapshot too: its [`PairEvents`](crate::broad::PairEvents) and
/// [`Exceptions`](crate::broad::Exceptions), the bytes of tiles that change. RAM: 164 bytes per
/// body, plus the broad phase. A scene may also [remember](Self::remembering) how bodies lie.
/// `M` says for how many; without it, none.
///
/// Flash and the most stack that a step takes, with a `SortSweep`, at opt-level "s":
///
/// | scene | flash, KB | stack of a step, bytes | of a [ride](Self::ride) |
/// |---|--:|--:|--:|
/// | boxes and circles | 74 | 5952 | |
/// | the same, with [`Solid`](crate::Solid) lifts | 89 | 6208 | 3600 |
/// | the same, with [`ConvexSolid`](crate::world::ConvexSolid) lifts | 117 | 6200 | 4344 |
/// | [`WithCapsules`](super::WithCapsules) | | 6088 | 3688 |
/// | [`AnyShape`](crate::shape::AnyShape) | | 6868 | 4568 |
#[derive(Clone, Copy, Debug)]
#[doc(alias("PhysicsWorld", "simulation"))]
pub struct Scene<B, const N: usize, const M: usize = 0, S = Shape> {
    pub(crate) near: B,
    pub(super) slots: [Slot<S>; N],
    /// The bodies awake come first.
    pub(super) awake: [Handle; N],
    pub(crate) count: usize,
    /// How the bodies in the first slots lie, and beyond N the ways of any.
    pub(super) memory: [Place; M],
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
    /// A scene without bodies, on an empty broad phase. It may be a `static`, which takes no flash
    /// with a [`SortSweep`](crate::broad::SortSweep) or a [`BruteForce`](crate::broad::BruteForce):
    /// all its bits are zero.
    #[must_use]
    pub const fn new(near: B) -> Self {
        Self::with_sleep(near, Sleep::DEFAULT)
    }

    /// The same scene with other conditions for sleep.
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
    /// A body that lies tries the same way through the level in each step, and gets nowhere. Such a
    /// way is answered from memory, with the same bits and the same events. Bodies that a step left
    /// as they were, with all that they touch, repeat that step until something else comes near.
    ///
    /// Some bodies never rest: a ball on a slope leans on a box, which pushes it away, and it rolls
    /// back. If M is larger than N, the scene remembers the last M - N short ways of such bodies
    /// too. 16 are enough for two or three of them.
    ///
    /// In return, name each region of the level that [changes](Self::wake_region), even if no body
    /// sleeps: a tile, a [`Solid`](crate::Solid) that moves, another level for a body. If your
    /// replies about two bodies change, [wake](Self::wake) both. A snapshot has no memory; a
    /// restored scene looks once.
    ///
    /// RAM: 104 bytes for each of M.
    ///
    /// ```
    /// use tilesat::broad::SortSweep;
    /// use tilesat::scene::{SceneBody, SceneTag, Sleep};
    /// use tilesat::{Aabb, Scene, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("..\n##", &KINDS)?; // the floor is at y = 16
    /// type Crates = Scene<SortSweep<8, SceneTag>, 8, 8>; // `8, 12` also keeps four ways
    /// let mut scene = Crates::remembering(SortSweep::new(), Sleep::NEVER);
    /// let body = Aabb::new(Vec2::from_ints(4, 8), Vec2::from_ints(12, 16))?;
    /// let crate_ = scene.insert(&SceneBody::new(body, 1))?;
    /// let gravity = Vec2::from_raw(0, 1 << 14);
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
            memory: [Place::Empty; M],
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
    /// use tilesat::broad::SortSweep;
    /// use tilesat::scene::{SceneTag, Sleep};
    /// use tilesat::Scene;
    /// let mut scene = Scene::<SortSweep<8, SceneTag>, 8>::new(SortSweep::new());
    /// assert_eq!(scene.sleep(), Sleep::default());
    /// scene.set_sleep(Sleep::NEVER);
    /// assert_eq!(scene.sleep(), Sleep::NEVER);
    /// ```
    pub const fn set_sleep(&mut self, sleep: Sleep) {
        self.sleep = SleepDifference::of(sleep);
    }

    /// The broad phase: for rays, regions and nearest bodies, and for the tags of bodies (`still`
    /// marks those that rest or are fixed).
    #[must_use]
    pub const fn near(&self) -> &B {
        &self.near
    }

    /// Adds a body, awake, and wakes the bodies that it touches. A sensor wakes nobody.
    ///
    /// It does not know the level. A body that overlaps it stays there, and each step reports it as
    /// [`Held`](super::SceneEvent::Held). Ask [`Shape::overlaps_level`] before, if that can be.
    ///
    /// # Errors
    /// [`Full`](BroadError::Full), the errors of the broad phase, and velocities that no step can
    /// make. Nothing is changed then.
    pub fn insert(&mut self, body: &SceneBody<S>) -> Result<Handle, SceneError> {
        body.shape.check().map_err(SceneError::call)?;
        check_motion(body.velocity, MOTION).map_err(SceneError::call)?;
        let handle = self.near.insert(&body.shape.aabb(), body.tag(body.mass.is_none())).map_err(SceneError::call)?;
        let Some(slot) = self.slots.get_mut(handle.slot()) else {
            let taken_back = self.leave(handle);
            debug_assert!(taken_back.is_ok(), "it has just been inserted");
            return Err(SceneError::call(BroadError::Full { capacity: N as u16 }));
        };
        *slot = Slot::of(body, handle);
        self.rouse(handle, false);
        self.stir(body);
        Ok(handle)
    }

    /// Removes a body, and wakes the bodies that it touched. A sensor wakes nobody.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn remove(&mut self, handle: Handle) -> Result<SceneBody<S>, SceneError> {
        let body = *self.body(handle)?;
        self.leave(handle).map_err(|e| SceneError::of(handle, e))?;
        self.strike(handle);
        if let Some(slot) = self.slots.get_mut(handle.slot()) {
            *slot = Slot::FREE;
        }
        self.stir(&body);
        Ok(body)
    }

    /// Takes a body out of the broad phase. No enumeration of pairs is under way.
    fn leave(&mut self, handle: Handle) -> Result<(), BroadError> {
        self.near.remove(handle)?;
        self.near.forget(handle.slot());
        Ok(())
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

    /// Whether steps move it. Fixed bodies are never awake.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn is_awake(&self, handle: Handle) -> Result<bool, SceneError> {
        self.slot(handle).map(Slot::is_awake)
    }

    /// Whether, in the last step, the level carried it, or bodies that the level carries. Always
    /// true for fixed bodies.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn is_supported(&self, handle: Handle) -> Result<bool, SceneError> {
        self.slot(handle).map(|slot| slot.support != super::body::ALOFT)
    }

    /// Whether two bodies touch, but the last step did not report it because both rested when it
    /// began. Pass it to [`PairEvents::finish`](crate::broad::PairEvents::finish). False if one was
    /// removed.
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
