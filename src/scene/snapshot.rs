//! The state that a scene carries from one step to the next, smaller than the scene.

use super::body::{Mode, Slot, Tally};
use super::body_path::{BodyPath, Drift};
use super::kernel::BodyShape;
use super::memory::Remembered;
use super::set::SleepDifference;
use super::{Scene, SceneBody, Shape, Sleep};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;

/// The state of a [`Scene`] between two steps: everything on which later steps depend, and nothing
/// else.
///
/// A copy of the scene is a snapshot, too. This type leaves out the data that a step needs only
/// while it runs, so a history of many frames takes less memory. [`restore`](Scene::restore) puts
/// it back: all later steps give the same bits and the same events in the same order.
///
/// Two snapshots are equal if all later steps and the bookkeeping of the broad phase are equal, to
/// the bit. If the same bodies are inserted in another order, the snapshots differ. A snapshot that
/// was written and read with the feature `serde` equals the original.
///
/// Size: 90 bytes for each of N slots, and the broad phase. With 64 bodies in a
/// [`SortSweep`](crate::broad::SortSweep) that is 7840 bytes; the scene itself has 164 for each
/// slot. Cost: one pass over the slots.
///
/// ```
/// use tilesat::scene::{SceneBody, SortSweepScene};
/// use tilesat::{Circle, TileKinds, TileMap, Vec2, fx};
/// let level = TileMap::from_ascii("....\n....\n", &TileKinds::EMPTY)?;
/// let mut scene = SortSweepScene::<8>::empty();
/// let ball = SceneBody::new(Circle::new(Vec2::from_ints(8, 8), fx!(2))?, 1);
/// scene.insert(&SceneBody { velocity: Vec2::from_ints(1, 0), ..ball })?;
///
/// let before = scene.snapshot();
/// scene.step(&level, Vec2::ZERO, |_| {})?;
/// let after = scene.snapshot();
/// assert_ne!(before, after);
/// scene.restore(&before);
/// scene.step(&level, Vec2::ZERO, |_| {})?;
/// assert_eq!(scene.snapshot(), after);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias("save state", "rollback"))]
pub struct Snapshot<B, const N: usize, S = Shape> {
    pub(crate) near: B,
    pub(super) kept: [Kept<S>; N],
    /// The slots of the bodies awake come first; the others are zero.
    pub(super) awake: [u16; N],
    pub(crate) count: u16,
    pub(crate) sleep: SleepDifference,
}

/// The state that one slot carries from step to step. Its generation is in the broad phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Kept<S> {
    pub(super) body: SceneBody<S>,
    pub(super) status: Status,
    pub(super) quiet: u8,
    pub(super) support: u8,
    pub(super) ground: u16,
    pub(super) drift: Drift,
}

/// The mode of a slot, and above it the sides to which it is blocked. In one byte, they leave a
/// slot at 88 bytes, and so a snapshot of 64 bodies below 8 KB.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Status(u8);

impl Status {
    pub(super) const fn of(mode: Mode, blocked: u8) -> Self {
        Self(mode as u8 | blocked << 3)
    }

    pub(super) const fn mode(self) -> Mode {
        match self.0 & 7 {
            1 => Mode::Fixed,
            2 => Mode::Woken,
            3 => Mode::Awake,
            4 => Mode::Asleep,
            _ => Mode::Free,
        }
    }

    pub(super) const fn blocked(self) -> u8 {
        self.0 >> 3
    }
}

impl<S: BodyShape> Kept<S> {
    const fn of(slot: &Slot<S>) -> Self {
        let Slot { body, mode, quiet, support, ground, blocked, tally, .. } = *slot;
        Self { body, status: Status::of(mode, blocked), quiet, support, ground, drift: tally.drift }
    }

    /// A step sets all other values before it reads them; sleeping and fixed bodies are not moved.
    const fn slot(&self, handle: Handle) -> Slot<S> {
        let Self { body, status, quiet, support, ground, drift } = *self;
        let (mode, blocked) = (status.mode(), status.blocked());
        let generation = if matches!(mode, Mode::Free) { 0 } else { handle.generation() };
        let tally = Tally { drift, ..Tally::of(handle.slot() as u16) };
        Slot { body, generation, mode, quiet, support, ground, blocked, tally, path: BodyPath::REST }
    }

    #[cfg(feature = "serde")]
    pub(super) const fn is_awake(&self) -> bool {
        self.status.mode().is_awake()
    }

    pub(super) const FREE: Self = Self::of(&Slot::FREE);
}

impl<B, const N: usize, S: BodyShape> Snapshot<B, N, S> {
    /// The state of a new scene on this empty broad phase, which
    /// [`snapshot_into`](Scene::snapshot_into) can overwrite. It may be a `static`, as
    /// [`Scene::new`].
    #[must_use]
    pub const fn new(near: B) -> Self {
        Self { near, kept: [Kept::FREE; N], awake: [0; N], count: 0, sleep: SleepDifference::of(Sleep::DEFAULT) }
    }
}

impl<B: BroadPhase<Tag = Keyed<Filter>> + Copy, const N: usize, const M: usize, S: BodyShape> Scene<B, N, M, S> {
    /// Returns the current state.
    ///
    /// Cost: one pass over the slots, and a copy of the broad phase. Returning the snapshot may
    /// need its size on the stack once or twice. If that is too much, use
    /// [`snapshot_into`](Self::snapshot_into).
    #[must_use]
    #[inline]
    pub fn snapshot(&self) -> Snapshot<B, N, S> {
        let mut taken = Snapshot::new(self.near);
        self.snapshot_into(&mut taken);
        taken
    }

    /// Writes the current state over another one, in place. It needs a few words of stack.
    ///
    /// ```
    /// use tilesat::broad::SortSweep;
    /// use tilesat::scene::{SceneTag, Snapshot};
    /// use tilesat::Scene;
    /// // The states before the last eight frames, as a ring. It may be a `static` as well.
    /// let mut states = [const { Snapshot::new(SortSweep::<8, SceneTag>::new()) }; 8];
    /// let scene = Scene::<_, 8>::new(SortSweep::new());
    /// let frame = 21;
    /// scene.snapshot_into(&mut states[frame % 8]);
    /// assert_eq!(states[frame % 8], scene.snapshot());
    /// ```
    pub fn snapshot_into(&self, snapshot: &mut Snapshot<B, N, S>) {
        snapshot.near = self.near;
        (snapshot.count, snapshot.sleep) = (self.count as u16, self.sleep);
        for (kept, slot) in snapshot.kept.iter_mut().zip(&self.slots) {
            *kept = Kept::of(slot);
        }
        snapshot.awake.fill(0);
        for (at, handle) in snapshot.awake.iter_mut().zip(self.awake()) {
            *at = handle.slot() as u16;
        }
    }

    /// Restores a state, and replaces the current one completely.
    ///
    /// Cost: as [`snapshot`](Self::snapshot).
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, SortSweepScene};
    /// use tilesat::{Circle, TileKinds, TileMap, Vec2, fx};
    /// let (level, mut scene) = (TileMap::from_ascii("....", &TileKinds::EMPTY)?, SortSweepScene::<8>::empty());
    /// let puck = scene.insert(&SceneBody::new(Circle::new(Vec2::from_ints(8, 8), fx!(4))?, 1))?;
    /// let before = scene.snapshot();
    /// scene.step(&level, Vec2::ZERO, |_| {})?; // with the guess that nobody hits it
    /// scene.restore(&before); // the input arrives: someone did
    /// scene.push(puck, Vec2::from_ints(6, 0))?;
    /// scene.step(&level, Vec2::ZERO, |_| {})?;
    /// assert_eq!(scene.body(puck)?.shape.centre(), Vec2::from_ints(14, 8));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[inline]
    pub fn restore(&mut self, snapshot: &Snapshot<B, N, S>) {
        let Snapshot { near, kept, awake, count, sleep } = snapshot;
        (self.near, self.count, self.sleep) = (*near, usize::from(*count), *sleep);
        self.memory = [Remembered::Empty; M];
        let bodies = near.table();
        for (at, (slot, kept)) in self.slots.iter_mut().zip(kept).enumerate() {
            *slot = kept.slot(bodies.handle(at));
        }
        for (handle, &at) in self.awake.iter_mut().zip(awake) {
            *handle = bodies.handle(usize::from(at));
        }
    }
}

impl<B: BroadPhase<Tag = Keyed<Filter>> + Copy, const N: usize, S: BodyShape> From<&Snapshot<B, N, S>>
    for Scene<B, N, 0, S>
{
    fn from(snapshot: &Snapshot<B, N, S>) -> Self {
        let mut scene = Self::with_sleep(snapshot.near, snapshot.sleep.sleep());
        scene.restore(snapshot);
        scene
    }
}
