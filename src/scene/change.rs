//! What a game changes between steps, and whom that wakes.

use super::body::{Mode, Slot, Tally};
use super::{Scene, SceneBody, SceneError, Shape};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;
use crate::num::{MOTION, Vec2, check_motion};
use crate::shape::Aabb;

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize> Scene<B, N> {
    /// Changes a body's velocity by so much, and wakes it.
    ///
    /// # Errors
    /// [`Stale`](crate::broad::BroadError::Stale), and velocities that no step can make; nothing was changed.
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

    /// Puts a body somewhere else, also in another shape; wakes it, and what it touched before and touches then. A fixed body is moved by this alone.
    ///
    /// # Errors
    /// [`Stale`](crate::broad::BroadError::Stale) and what the broad phase refuses; nothing was changed. The level is not asked: the next step [holds](super::SceneEvent::Held) what overlaps it.
    pub fn place(&mut self, handle: Handle, shape: impl Into<Shape>) -> Result<(), SceneError> {
        let shape = shape.into();
        self.alter(handle, |body| body.shape = shape)
    }

    /// Changes a body in any way, also what it looks like, whom it meets, its key, and whether it has a mass; wakes it, and what it touched before and touches then.
    /// Sensors wake nobody else.
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
    /// [`Stale`](crate::broad::BroadError::Stale), velocities that no step can make, and what the broad phase refuses; nothing was changed. The level is not asked, as in [`place`](Self::place).
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
        // What it still touches is woken by the next step, but not where it is fixed; what it let go of by nothing else.
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

    /// Wakes the bodies whose boxes touch a region, borders included: that of a tile which changes, of an explosion. What they touch wakes in the step after.
    ///
    /// Cost: a region query.
    pub fn wake_region(&mut self, region: &Aabb) {
        let (from, slots) = (self.count, &mut self.slots);
        let (awake, count) = (&mut self.awake, &mut self.count);
        self.near.in_region(region, |handle| rouse(slots, awake, count, handle));
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

/// Puts a body that sleeps into the list of those awake.
pub(super) fn rouse(slots: &mut [Slot], awake: &mut [Handle], count: &mut usize, handle: Handle) {
    let Some(slot) = slots.get_mut(handle.slot()).filter(|slot| slot.mode == Mode::Asleep) else { return };
    let Some(place) = awake.get_mut(*count) else { return };
    (*place, slot.mode, slot.told, slot.quiet) = (handle, Mode::Awake, false, 0);
    slot.tally = Tally::of(handle.slot() as u16);
    *count += 1;
}
