//! Repeats the answer to the last call of a body without a look at the level.

use super::response::{Law, Smooth};
use super::{Body, MoveError, Moved, Mover, Work};
use crate::num::Vec2;
use crate::world::World;

/// The last call that left its body where it was, and the answer.
///
/// A body at rest makes the same call in each frame: the same position, the same velocity
/// (gravity's first step), the same mover. A memo answers such a call by comparing the arguments.
/// It works for every support: a floor, a V, two domes. The answer is that of
/// [`Mover::move_and_slide`], bit for bit, except [`Moved::work`], which is zero.
///
/// One memo belongs to one body. It is plain data: a copy is a snapshot.
///
/// ```
/// use tilesat::{Aabb, Axis, Mover, TileKind, TileKinds, TileMap, Vec2, fx, motion::Memo};
///
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let map = TileMap::from_ascii("  \n##\n", &KINDS)?; // the floor is at y = 16
/// let (mover, mut memo) = (Mover::platformer(Axis::NEG_Y), Memo::new());
/// let mut body = Aabb::new(Vec2::from_ints(4, 6), Vec2::from_ints(12, 16))?;
/// let gravity = Vec2::new(fx!(0), fx!(0.25));
///
/// for frame in 0..10 {
///     let moved = memo.move_and_slide(&mover, &map, 0, &body, gravity)?;
///     body = moved.body;
///     assert!(moved.floor);
///     assert_eq!(moved.work.iterations, u32::from(frame == 0)); // one look at the level in ten frames
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Memo<B, S = Smooth> {
    last: Option<Last<B, S>>,
}

/// A call and its answer; the body is in the answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Last<B, S> {
    mover: Mover<S>,
    version: u32,
    velocity: Vec2,
    answer: Moved<B>,
}

impl<B, S> Memo<B, S> {
    /// An empty memo.
    #[must_use]
    pub const fn new() -> Self {
        Self { last: None }
    }

    /// Forgets the last call.
    pub fn clear(&mut self) {
        self.last = None;
    }
}

impl<B, S> Default for Memo<B, S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<B: Body + PartialEq, S: Law + PartialEq> Memo<B, S> {
    /// Moves a body as [`Mover::move_and_slide`] does, or repeats the last answer.
    ///
    /// `version` stands for the level. Pass another number whenever the level may have changed: a
    /// door opened, a [`Solid`](crate::Solid) moved, or the body is in another room. A counter is
    /// enough, and one number serves all bodies.
    ///
    /// Cost: a repeated call compares the memo with the arguments and copies the answer. Any other
    /// call costs as much as `move_and_slide`, plus a copy if the body stays.
    ///
    /// # Errors
    /// Those of `move_and_slide`. The memo is then empty.
    ///
    /// # Panics
    /// Builds with debug assertions also make the repeated call. They panic if the level changed
    /// and `version` did not.
    pub fn move_and_slide<W: World>(
        &mut self,
        mover: &Mover<S>,
        world: &W,
        version: u32,
        body: &B,
        velocity: Vec2,
    ) -> Result<Moved<B>, MoveError> {
        if let Some(last) = &self.last {
            if last.answer.body == *body && last.velocity == velocity && last.version == version && last.mover == *mover
            {
                debug_assert!(
                    mover.move_and_slide(world, body, velocity).map(without_work) == Ok(last.answer),
                    "the level changed, but not its version"
                );
                return Ok(last.answer);
            }
        }
        self.last = None;
        let moved = mover.move_and_slide(world, body, velocity)?;
        if moved.body == *body {
            let answer = without_work(moved);
            self.last = Some(Last { mover: *mover, version, velocity, answer });
        }
        Ok(moved)
    }
}

fn without_work<B>(moved: Moved<B>) -> Moved<B> {
    Moved { work: Work::default(), ..moved }
}
