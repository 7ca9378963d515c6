//! The bodies together: those in the scene, those awake, the changes that a game makes between
//! steps, and the bodies that these wake.

use super::body::{Mode, Slot, Tally};
use super::kernel::BodyShape;
use super::rest::Rest;
use super::{SceneBody, SceneError, Shape};
use crate::broad::{BroadError, BroadPhase, Handle, Keyed, Pair};
use crate::filter::Filter;
use crate::num::{Fx, MOTION, Vec2, check_motion};
use crate::shape::Aabb;

/// When bodies fall asleep: after this many steps of rest, for all bodies that touch, directly or
/// not.
///
/// In a step of rest a body moves by less than `still` on either axis. A faster step is one of rest
/// too, if the body has come no farther than `still` times `steps` since it rests: on the whole it
/// was slow. (At least that is the gravity of two steps, at most a unit.) Without this, bodies in a
/// heap that push each other to and fro would never sleep. If there is gravity, the body also runs
/// into the level or into another body. A step in the air does not count, and does not end the
/// rest.
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
    /// After 30 steps of less than 1/32 of a unit.
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl Sleep {
    pub(super) const DEFAULT: Self = Self { still: Fx::from_bits(1 << 11), steps: 30 };
}

/// Up to N bodies in a broad phase, moved through a level by one call per frame.
///
/// `B` is any [`BroadPhase`] with [`SceneTag`](super::SceneTag)s and room for N bodies:
/// `Scene<SortSweep<64, SceneTag>, 64>`. The [module](super) describes a step.
///
/// Plain data: a copy is a snapshot, and assigning it rolls back. The data that your game keeps
/// beside it is part of a snapshot too: its [`PairEvents`](crate::broad::PairEvents) and
/// [`Exceptions`](crate::broad::Exceptions), the bytes of tiles that change. RAM: 164 bytes per
/// body, plus the broad phase. A scene may also [remember](Self::remembering) how bodies lie.
/// `M` says for how many; without it, none.
#[derive(Clone, Copy, Debug)]
#[doc(alias("PhysicsWorld", "simulation"))]
pub struct Scene<B, const N: usize, const M: usize = 0, S = Shape> {
    pub(crate) near: B,
    pub(super) slots: [Slot<S>; N],
    /// The bodies awake come first.
    pub(super) awake: [Handle; N],
    pub(crate) count: usize,
    /// What is remembered of the bodies in the first M slots.
    pub(super) rests: [Option<Rest>; M],
    /// You may change it at any time.
    pub sleep: Sleep,
}

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, S: BodyShape> Scene<B, N, 0, S> {
    /// A scene without bodies, on an empty broad phase. It may be a `static`.
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
    /// assert_eq!(scene.sleep.steps, 120);
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
    /// In return, name each region of the level that [changes](Self::wake_region), even if no body
    /// sleeps: a tile, a [`Solid`](crate::Solid) that moves, another level for a body. If your
    /// replies about two bodies change, [wake](Self::wake) both. A snapshot has no memory; a
    /// restored scene looks once.
    ///
    /// RAM: 92 bytes for each of M.
    ///
    /// ```
    /// use tilesat::broad::SortSweep;
    /// use tilesat::scene::{SceneBody, SceneTag, Sleep};
    /// use tilesat::{Aabb, Scene, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("..\n##", &KINDS)?; // the floor is at y = 16
    /// type Crates = Scene<SortSweep<8, SceneTag>, 8, 8>;
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
        Self { near, slots: [Slot::FREE; N], awake: [Handle::new(0, 0); N], count: 0, rests: [None; M], sleep }
    }

    /// The broad phase: for rays, regions and nearest bodies, and for the tags of bodies (`still`
    /// marks those that rest or are fixed).
    #[must_use]
    pub const fn near(&self) -> &B {
        &self.near
    }

    /// Adds a body, awake, and wakes the bodies that it touches. A sensor wakes nobody.
    ///
    /// # Errors
    /// [`Full`](BroadError::Full), the errors of the broad phase, and velocities that no step can
    /// make. Nothing is changed then.
    pub fn insert(&mut self, body: &SceneBody<S>) -> Result<Handle, SceneError> {
        body.shape.check().map_err(SceneError::call)?;
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

    /// Removes a body, and wakes the bodies that it touched. A sensor wakes nobody.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    pub fn remove(&mut self, handle: Handle) -> Result<SceneBody<S>, SceneError> {
        let body = *self.body(handle)?;
        self.near.remove(handle).map_err(|e| SceneError::of(handle, e))?;
        self.strike(handle);
        if let Some(slot) = self.slots.get_mut(handle.slot()) {
            *slot = Slot::FREE;
        }
        self.stir(&body);
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

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, const M: usize, S: BodyShape> Scene<B, N, M, S> {
    /// Adds `by` to a body's velocity, and wakes the body.
    ///
    /// ```
    /// use tilesat::broad::{BroadPhase, SortSweep};
    /// use tilesat::scene::{SceneBody, SceneTag};
    /// use tilesat::{Aabb, Scene, Vec2};
    /// let mut scene = Scene::<SortSweep<8, SceneTag>, 8>::new(SortSweep::new());
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
    /// let (near, far) = (scene.insert(&SceneBody::new(at(10)?, 1))?, scene.insert(&SceneBody::new(at(90)?, 2))?);
    /// // An explosion at (0, 0), of 40 units.
    /// let mut hit = heapless::Vec::<_, 8>::new();
    /// let region = Aabb::new(Vec2::from_ints(-40, -40), Vec2::from_ints(40, 40))?;
    /// scene.near().in_region(&region, |handle| hit.push(handle).expect("as many places as bodies"));
    /// for handle in hit {
    ///     scene.push(handle, Vec2::from_ints(5, -5))?;
    /// }
    /// assert_eq!(scene.body(near)?.velocity, Vec2::from_ints(5, -5));
    /// assert_eq!(scene.body(far)?.velocity, Vec2::ZERO);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Stale`](crate::broad::BroadError::Stale), and velocities that no step can make. Nothing is
    /// changed then.
    pub fn push(&mut self, handle: Handle, by: Vec2) -> Result<(), SceneError> {
        let velocity = self.body(handle)?.velocity;
        self.set_velocity(handle, velocity.saturating_add(by))
    }

    /// Gives a body another velocity, and wakes it. For a fixed body it wakes those that touch it.
    ///
    /// # Errors
    /// As [`push`](Self::push).
    pub fn set_velocity(&mut self, handle: Handle, velocity: Vec2) -> Result<(), SceneError> {
        self.alter(handle, |body| body.velocity = velocity)
    }

    /// Moves a body elsewhere, or gives it another shape. Wakes it, and the bodies that it touched
    /// before and touches then. Only this call moves a fixed body.
    ///
    /// ```
    /// use tilesat::broad::SortSweep;
    /// use tilesat::scene::{SceneBody, SceneTag};
    /// use tilesat::{Aabb, Scene, Vec2};
    /// let mut scene = Scene::<SortSweep<8, SceneTag>, 8>::new(SortSweep::new());
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
    /// let lift = scene.insert(&SceneBody::fixed(at(0)?, 1))?;
    /// scene.place(lift, at(4)?)?;
    /// assert_eq!(scene.body(lift)?.shape.position(), Vec2::from_ints(4, 0));
    /// assert_eq!(scene.remove(lift)?.key, 1);
    /// assert!(scene.place(lift, at(8)?).is_err()); // its handle is stale
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Stale`](crate::broad::BroadError::Stale) and the errors of the broad phase. Nothing is
    /// changed then. The call does not look at the level: the next step
    /// [holds](super::SceneEvent::Held) a body that overlaps it.
    pub fn place(&mut self, handle: Handle, shape: impl Into<S>) -> Result<(), SceneError> {
        let shape = shape.into();
        self.alter(handle, |body| body.shape = shape)
    }

    /// Changes a body in any way: its shape, its filter, its key, whether it has a mass. Wakes it,
    /// and the bodies that it touched before and touches then. Sensors wake nobody else.
    ///
    /// `change` gets a copy, which is stored as a whole or not at all. The handle stays the same.
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
    /// [`Stale`](crate::broad::BroadError::Stale), velocities that no step can make, and the errors
    /// of the broad phase. Nothing is changed then. The call does not look at the level, like
    /// [`place`](Self::place).
    pub fn alter(&mut self, handle: Handle, change: impl FnOnce(&mut SceneBody<S>)) -> Result<(), SceneError> {
        let before = *self.body(handle)?;
        let mut body = before;
        change(&mut body);
        check_motion(body.velocity, MOTION).map_err(|e| SceneError::of(handle, e))?;
        if body.shape != before.shape {
            body.shape.check().map_err(|e| SceneError::of(handle, e))?;
            self.near.move_to(handle, &body.shape.aabb()).map_err(|e| SceneError::of(handle, e))?;
        }
        if body.mass.is_some() != before.mass.is_some() {
            self.strike(handle);
            *self.slot_mut(handle)? = Slot::of(&body, handle);
        }
        let slot = self.slot_mut(handle)?;
        slot.body = body;
        let tag = body.tag(!slot.is_awake());
        self.near.set_tag(handle, tag).map_err(|e| SceneError::of(handle, e))?;
        // The next step wakes the bodies that it still touches, except for a fixed body. Nothing
        // else would wake the bodies that it released.
        let what = |body: &SceneBody<S>| (body.shape, body.mass, body.filter);
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

    /// Wakes the bodies with boxes that touch a region, borders included: the region of a tile that
    /// changed, or of an explosion. The bodies that these touch wake one step later.
    ///
    /// ```
    /// use tilesat::broad::SortSweep;
    /// use tilesat::scene::{SceneBody, SceneTag};
    /// use tilesat::{Aabb, Scene, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let (closed, open) = ("..\n##", "..\n#."); // a trapdoor below x = 16
    /// let closed = TileMap::from_ascii(closed, &KINDS)?;
    /// let mut scene = Scene::<SortSweep<8, SceneTag>, 8>::new(SortSweep::new());
    /// let barrel = scene.insert(&SceneBody::new(Aabb::new(Vec2::from_ints(18, 8), Vec2::from_ints(26, 16))?, 1))?;
    /// let gravity = Vec2::from_raw(0, 1 << 14);
    /// for _ in 0..100 {
    ///     scene.step(&closed, gravity, |_| {})?;
    /// }
    /// assert!(!scene.is_awake(barrel)?);
    /// let open = TileMap::from_ascii(open, &KINDS)?;
    /// scene.wake_region(&Aabb::new(Vec2::from_ints(16, 16), Vec2::from_ints(32, 32))?);
    /// scene.step(&open, gravity, |_| {})?;
    /// assert!(scene.body(barrel)?.velocity.y > 0); // it falls
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Cost: a region query.
    pub fn wake_region(&mut self, region: &Aabb) {
        let (from, slots) = (self.count, &mut self.slots);
        let (awake, count, rests) = (&mut self.awake, &mut self.count, &mut self.rests);
        self.near.in_region(region, |handle| {
            rouse(slots, awake, count, handle);
            unsettle(slots, rests, handle);
        });
        self.tell_woken(from);
    }

    /// Wakes the bodies that a body touches, or could.
    pub(super) fn stir(&mut self, body: &SceneBody<S>) {
        if !body.filter.sensor() {
            self.wake_region(&body.shape.aabb());
        }
    }

    /// Removes a body from the list of those awake.
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
        unsettle(&mut self.slots, &mut self.rests, handle);
        if known {
            self.tell_woken(from);
        }
    }

    /// Marks the bodies woken since there were `from` awake in the broad phase.
    pub(super) fn tell_woken(&mut self, from: usize) {
        for handle in self.awake.iter().take(self.count).skip(from) {
            let Some(slot) = self.slots.get(handle.slot()) else { continue };
            let told = self.near.set_tag(*handle, slot.body.tag(false));
            debug_assert!(told.is_ok(), "a body of the scene is in its broad phase");
        }
    }
}

/// A change by the game is no rest.
fn unsettle<S>(slots: &mut [Slot<S>], rests: &mut [Option<Rest>], handle: Handle) {
    if let Some(rest) = rests.get_mut(handle.slot()) {
        *rest = None;
    }
    if let Some(slot) = slots.get_mut(handle.slot()) {
        slot.quiet = 0;
    }
}

/// Adds a sleeping body to the list of those awake. Its quiet steps stay: a body that only touches
/// it does not keep a heap from falling asleep.
pub(super) fn rouse<S>(slots: &mut [Slot<S>], awake: &mut [Handle], count: &mut usize, handle: Handle) {
    let Some(slot) = slots.get_mut(handle.slot()).filter(|slot| slot.mode == Mode::Asleep) else { return };
    let Some(place) = awake.get_mut(*count) else { return };
    (*place, slot.mode) = (handle, Mode::Woken);
    slot.tally = Tally::of(handle.slot() as u16);
    *count += 1;
}
