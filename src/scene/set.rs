//! The bodies together: who is in, who is awake, what a game changes between steps, and whom that
//! wakes.

use super::body::{Mode, Slot, Tally};
use super::{SceneBody, SceneError, Shape};
use crate::broad::{BroadError, BroadPhase, Handle, Keyed, Pair};
use crate::filter::Filter;
use crate::num::{Fx, MOTION, Vec2, check_motion};
use crate::query::Touches;
use crate::shape::Aabb;

/// When bodies fall asleep: after so many steps in a row in which each of those that touch,
/// directly or not, has moved by less than `still` on either axis, or in all of them together by no
/// more than what gravity gives in two steps; and, where there is gravity, ran into the level or
/// into another body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sleep {
    /// Units a step. What moves more slowly than that on purpose never gets there.
    pub still: Fx,
    /// 0 is never.
    pub steps: u8,
}

impl Sleep {
    /// Nobody sleeps.
    pub const NEVER: Self = Self { still: Fx::ZERO, steps: 0 };
}

impl Default for Sleep {
    /// After 30 steps of less than 1/32 of a unit.
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl Sleep {
    const DEFAULT: Self = Self { still: Fx::from_bits(1 << 11), steps: 30 };
}

/// Up to N bodies in a broad phase, moved through a level by one call a frame.
///
/// `B` is any [`BroadPhase`] with [`SceneTag`](super::SceneTag)s and room for N bodies:
/// `Scene<SortSweep<64, SceneTag>, 64>`. The [module](super) says what a step does.
///
/// Plain data: a copy is a snapshot, and to assign it is to roll back. What the game keeps beside
/// it is part of a snapshot too: its [`PairEvents`](crate::broad::PairEvents) and
/// [`Exceptions`](crate::broad::Exceptions), the bytes of tiles that change. RAM: 156 bytes a body
/// and those of the broad phase.
#[derive(Clone, Copy, Debug)]
pub struct Scene<B, const N: usize> {
    pub(crate) near: B,
    pub(super) slots: [Slot; N],
    /// The bodies awake come first.
    pub(super) awake: [Handle; N],
    pub(crate) count: usize,
    /// May be changed at any time.
    pub sleep: Sleep,
}

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize> Scene<B, N> {
    /// A scene without bodies, of a broad phase without any; may be a `static`.
    #[must_use]
    pub const fn new(near: B) -> Self {
        Self::with_sleep(near, Sleep::DEFAULT)
    }

    /// The same where bodies fall asleep sooner, later or never.
    #[must_use]
    pub const fn with_sleep(near: B, sleep: Sleep) -> Self {
        Self { near, slots: [Slot::FREE; N], awake: [Handle::new(0, 0); N], count: 0, sleep }
    }

    /// The broad phase: for rays, regions and nearest bodies, and for the tags of bodies (`still`
    /// is who rests or is fixed).
    #[must_use]
    pub const fn near(&self) -> &B {
        &self.near
    }

    /// Takes a body in, awake; what it touches wakes up, but nobody where it is a sensor.
    ///
    /// # Errors
    /// [`Full`](BroadError::Full), what the broad phase refuses, and velocities that no step can
    /// make; nothing was changed.
    pub fn insert(&mut self, body: &SceneBody) -> Result<Handle, SceneError> {
        check_motion(body.velocity, MOTION).map_err(SceneError::call)?;
        let handle = self.near.insert(&body.shape.aabb(), body.tag(body.mass.is_none())).map_err(SceneError::call)?;
        let Some(slot) = self.slots.get_mut(handle.slot()) else {
            let taken_back = self.near.remove(handle);
            debug_assert!(taken_back.is_ok(), "it has just been inserted");
            return Err(SceneError::call(BroadError::Full { capacity: N as u16 }));
        };
        *slot = Slot::of(body, handle);
        self.rouse(handle, false);
        self.stir(body);
        Ok(handle)
    }

    /// Takes a body out; what it touched wakes up, but nobody where it is a sensor.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn remove(&mut self, handle: Handle) -> Result<SceneBody, SceneError> {
        let body = *self.body(handle)?;
        self.near.remove(handle).map_err(|e| SceneError::of(handle, e))?;
        self.strike(handle);
        if let Some(slot) = self.slots.get_mut(handle.slot()) {
            *slot = Slot::FREE;
        }
        self.stir(&body);
        Ok(body)
    }

    /// All bodies, also those that sleep or are fixed, in the order of their slots; that is no
    /// canonical order, for which there are keys.
    ///
    /// Cost: a look at each of the N slots.
    pub fn bodies(&self) -> impl Iterator<Item = (Handle, &SceneBody)> {
        let taken = self.slots.iter().enumerate().filter(|(_, slot)| slot.mode != Mode::Free);
        taken.map(|(at, slot)| (Handle::new(at, slot.generation), &slot.body))
    }

    /// A body as it is.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn body(&self, handle: Handle) -> Result<&SceneBody, SceneError> {
        self.slot(handle).map(|slot| &slot.body)
    }

    /// Whether steps move it; fixed bodies are never awake.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn is_awake(&self, handle: Handle) -> Result<bool, SceneError> {
        self.slot(handle).map(|slot| slot.mode == Mode::Awake)
    }

    /// Whether the level carried it in the last step, or bodies that the level carries did; fixed
    /// bodies are.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn is_supported(&self, handle: Handle) -> Result<bool, SceneError> {
        self.slot(handle).map(|slot| slot.support != super::body::ALOFT)
    }

    /// Whether two bodies touch of whom the last step did not tell, because both rested when it
    /// began: for [`PairEvents::finish`](crate::broad::PairEvents::finish). Not where one was
    /// removed.
    #[must_use]
    pub fn rests(&self, pair: &Pair) -> bool {
        let rested = |slot: &&Slot| slot.mode != Mode::Awake || !slot.told;
        let [a, b] = [pair.a, pair.b].map(|handle| self.slot(handle).ok().filter(rested));
        a.zip(b).is_some_and(|(a, b)| a.body.shape.touches(&b.body.shape))
    }

    /// The bodies awake, in no particular order.
    #[must_use]
    pub fn awake(&self) -> &[Handle] {
        self.awake.get(..self.count).unwrap_or_default()
    }

    pub(super) fn slot(&self, handle: Handle) -> Result<&Slot, SceneError> {
        let slot = self.slots.get(handle.slot()).filter(|slot| slot.mode != Mode::Free && self.near.contains(handle));
        slot.ok_or(SceneError::of(handle, BroadError::Stale(handle)))
    }

    pub(super) fn slot_mut(&mut self, handle: Handle) -> Result<&mut Slot, SceneError> {
        self.slot(handle)?;
        self.slots.get_mut(handle.slot()).ok_or(SceneError::of(handle, BroadError::Stale(handle)))
    }
}

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize> Scene<B, N> {
    /// Changes a body's velocity by so much, and wakes it.
    ///
    /// # Errors
    /// [`Stale`](crate::broad::BroadError::Stale), and velocities that no step can make; nothing
    /// was changed.
    pub fn push(&mut self, handle: Handle, by: Vec2) -> Result<(), SceneError> {
        let velocity = self.body(handle)?.velocity;
        self.set_velocity(handle, velocity.saturating_add(by))
    }

    /// Gives a body another velocity, and wakes it; where it is fixed, what it touches.
    ///
    /// # Errors
    /// As [`push`](Self::push).
    pub fn set_velocity(&mut self, handle: Handle, velocity: Vec2) -> Result<(), SceneError> {
        self.alter(handle, |body| body.velocity = velocity)
    }

    /// Puts a body somewhere else, also in another shape; wakes it, and what it touched before and
    /// touches then. A fixed body is moved by this alone.
    ///
    /// # Errors
    /// [`Stale`](crate::broad::BroadError::Stale) and what the broad phase refuses; nothing was
    /// changed. The level is not asked: the next step [holds](super::SceneEvent::Held) what
    /// overlaps it.
    pub fn place(&mut self, handle: Handle, shape: impl Into<Shape>) -> Result<(), SceneError> {
        let shape = shape.into();
        self.alter(handle, |body| body.shape = shape)
    }

    /// Changes a body in any way, also what it looks like, whom it meets, its key, and whether it
    /// has a mass; wakes it, and what it touched before and touches then. Sensors wake nobody else.
    ///
    /// `change` gets a copy, which is taken as a whole or not at all. The handle stays what it was.
    ///
    /// ```
    /// # use core::num::NonZeroU8;
    /// # use tilesat::broad::SortSweep;
    /// # use tilesat::scene::{SceneBody, SceneTag};
    /// # use tilesat::{Aabb, Scene, Vec2};
    /// let mut scene = Scene::<SortSweep<8, SceneTag>, 8>::new(SortSweep::new());
    /// let bridge = scene.insert(&SceneBody::fixed(Aabb::new(Vec2::ZERO, Vec2::from_ints(40, 8))?, 1))?;
    /// scene.alter(bridge, |body| body.mass = NonZeroU8::new(5))?; // from now on it falls
    /// assert!(scene.is_awake(bridge)?);
    /// scene.alter(bridge, |body| body.filter = body.filter.with_sensor(true))?; // and hits nobody
    /// assert!(scene.alter(bridge, |body| body.velocity = Vec2::from_ints(0, 4096)).is_err());
    /// assert!(scene.body(bridge)?.filter.sensor());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Stale`](crate::broad::BroadError::Stale), velocities that no step can make, and what the
    /// broad phase refuses; nothing was changed. The level is not asked, as in
    /// [`place`](Self::place).
    pub fn alter(&mut self, handle: Handle, change: impl FnOnce(&mut SceneBody)) -> Result<(), SceneError> {
        let before = *self.body(handle)?;
        let mut body = before;
        change(&mut body);
        check_motion(body.velocity, MOTION).map_err(|e| SceneError::of(handle, e))?;
        if body.shape != before.shape {
            self.near.move_to(handle, &body.shape.aabb()).map_err(|e| SceneError::of(handle, e))?;
        }
        if body.mass.is_some() != before.mass.is_some() {
            self.strike(handle);
            *self.slot_mut(handle)? = Slot::of(&body, handle);
        }
        let slot = self.slot_mut(handle)?;
        slot.body = body;
        let tag = body.tag(slot.mode != Mode::Awake);
        self.near.set_tag(handle, tag).map_err(|e| SceneError::of(handle, e))?;
        // What it still touches is woken by the next step, but not where it is fixed; what it let
        // go of by nothing else.
        let what = |body: &SceneBody| (body.shape, body.mass, body.filter);
        if body.mass.is_none() || what(&body) != what(&before) {
            self.stir(&before);
            self.stir(&body);
        }
        self.wake(handle)
    }

    /// Wakes a body.
    ///
    /// # Errors
    /// [`Stale`](crate::broad::BroadError::Stale).
    pub fn wake(&mut self, handle: Handle) -> Result<(), SceneError> {
        self.slot(handle)?;
        self.rouse(handle, true);
        Ok(())
    }

    /// Wakes the bodies whose boxes touch a region, borders included: that of a tile which changes,
    /// of an explosion. What they touch wakes in the step after.
    ///
    /// Cost: a region query.
    pub fn wake_region(&mut self, region: &Aabb) {
        let (from, slots) = (self.count, &mut self.slots);
        let (awake, count) = (&mut self.awake, &mut self.count);
        self.near.in_region(region, |handle| {
            rouse(slots, awake, count, handle);
            unsettle(slots, handle);
        });
        self.tell_woken(from);
    }

    /// Wakes what a body touches, or could.
    pub(super) fn stir(&mut self, body: &SceneBody) {
        if !body.filter.sensor() {
            self.wake_region(&body.shape.aabb());
        }
    }

    /// Takes a body out of the list of those awake.
    pub(super) fn strike(&mut self, handle: Handle) {
        let awake = self.awake.get_mut(..self.count).unwrap_or_default();
        if let (Some(last), Some(at)) = (awake.last().copied(), awake.iter().position(|&other| other == handle)) {
            awake.iter_mut().skip(at).take(1).for_each(|place| *place = last);
            self.count -= 1;
        }
    }

    pub(super) fn rouse(&mut self, handle: Handle, known: bool) {
        let from = self.count;
        rouse(&mut self.slots, &mut self.awake, &mut self.count, handle);
        unsettle(&mut self.slots, handle);
        if known {
            self.tell_woken(from);
        }
    }

    /// Tells the broad phase who is awake since there were so many.
    pub(super) fn tell_woken(&mut self, from: usize) {
        for handle in self.awake.iter().take(self.count).skip(from) {
            let Some(slot) = self.slots.get(handle.slot()) else { continue };
            let told = self.near.set_tag(*handle, slot.body.tag(false));
            debug_assert!(told.is_ok(), "a body of the scene is in its broad phase");
        }
    }
}

/// What the game does to a body is no rest.
fn unsettle(slots: &mut [Slot], handle: Handle) {
    if let Some(slot) = slots.get_mut(handle.slot()) {
        slot.quiet = 0;
    }
}

/// Puts a body that sleeps into the list of those awake. It has been quiet as long as before: what
/// only touches it does not keep a heap from falling asleep.
pub(super) fn rouse(slots: &mut [Slot], awake: &mut [Handle], count: &mut usize, handle: Handle) {
    let Some(slot) = slots.get_mut(handle.slot()).filter(|slot| slot.mode == Mode::Asleep) else { return };
    let Some(place) = awake.get_mut(*count) else { return };
    (*place, slot.mode, slot.told) = (handle, Mode::Awake, false);
    slot.tally = Tally::of(handle.slot() as u16);
    *count += 1;
}
