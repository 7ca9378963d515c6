//! The bodies together: who is in, who is awake.

use super::body::{Mode, Slot};
use super::{SceneBody, SceneError};
use crate::broad::{BroadError, BroadPhase, Handle, Keyed, Pair};
use crate::filter::Filter;
use crate::num::{Fx, MOTION, check_motion};
use crate::query::Touches;

/// When bodies fall asleep: after so many steps in a row in which each of those that touch, directly or not, has moved by less than `still` on either axis,
/// and, where there is gravity, ran into the level or into another body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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
/// `B` is any [`BroadPhase`] with [`SceneTag`](super::SceneTag)s and room for N bodies: `Scene<SortSweep<64, SceneTag>, 64>`. The [module](super) says what a step does.
///
/// Plain data: a copy is a snapshot, and to assign it is to roll back. What the game keeps beside it is part of a snapshot too: its
/// [`PairEvents`](crate::broad::PairEvents) and [`Exceptions`](crate::broad::Exceptions), the bytes of tiles that change. RAM: 124 bytes a body and those of the broad phase.
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

    /// The broad phase: for rays, regions and nearest bodies, and for the tags of bodies (`still` is who rests or is fixed).
    #[must_use]
    pub const fn near(&self) -> &B {
        &self.near
    }

    /// Takes a body in, awake; what it touches wakes up, but nobody where it is a sensor.
    ///
    /// # Errors
    /// [`Full`](BroadError::Full), what the broad phase refuses, and velocities that no step can make; nothing was changed.
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

    /// All bodies, also those that sleep or are fixed, in the order of their slots; that is no canonical order, for which there are keys.
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

    /// Whether the level carried it in the last step, or bodies that the level carries did; fixed bodies are.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn is_supported(&self, handle: Handle) -> Result<bool, SceneError> {
        self.slot(handle).map(|slot| slot.support != super::body::ALOFT)
    }

    /// Whether two bodies touch of whom the last step did not tell, because both rested when it began: for
    /// [`PairEvents::finish`](crate::broad::PairEvents::finish). Not where one was removed.
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
