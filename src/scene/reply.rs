//! How two bodies of a scene respond when they meet.

use crate::broad::Pair;
use crate::world::sealed::Sealed;

/// How two bodies respond when they meet.
///
/// `Cross`, `Slide`, `Touch` and `Bounce` are named after the responses of bump.lua. A
/// [`SceneEvent::Touch`](super::SceneEvent::Touch) or [`Meet`](super::SceneEvent::Meet) says that
/// two bodies met, and nothing about their reply.
///
/// A reply applies to a pair, so it can depend on both bodies. A bullet crosses friends, and a
/// ghost ignores crates. A ball bounces off one kind of body and sticks to another. In piles, a
/// body that lies on another one is carried, whatever the reply at its landing is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Reply {
    /// Nothing happens, and nothing is reported.
    Ignore,
    /// They pass each other. Each step in which they touch is reported, and each meeting on the
    /// path of a fast body, as for [sensors](crate::Filter::sensor).
    Cross,
    /// Their surfaces decide.
    #[default]
    Meet,
    /// They do not bounce, and their friction acts.
    Slide,
    /// They stop each other: both continue with the same velocity, by their masses.
    Touch,
    /// They bounce like mirror images, without friction and without a loss.
    Bounce,
}

impl Reply {
    /// Whether they push each other.
    pub(super) const fn acts(self) -> bool {
        !matches!(self, Self::Ignore | Self::Cross)
    }
}

/// The answer of a game about a pair: a [`Reply`], or whether the pair [meets](Reply::Meet) at all.
pub trait Answer: Copy + Sealed {
    /// Whether it may be [`Reply::Cross`]. A scene that never crosses pays nothing for it.
    #[doc(hidden)]
    const CROSSES: bool;

    /// The reply.
    fn reply(self) -> Reply;
}

impl Sealed for bool {}
impl Sealed for Reply {}

impl Answer for bool {
    const CROSSES: bool = false;
    fn reply(self) -> Reply {
        if self { Reply::Meet } else { Reply::Ignore }
    }
}

impl Answer for Reply {
    const CROSSES: bool = true;
    fn reply(self) -> Reply {
        self
    }
}

/// The game's answers about pairs.
pub(super) trait Replies {
    /// Whether there is more than one answer.
    const ASKS: bool;
    const CROSSES: bool;
    fn to(&mut self, pair: Pair) -> Reply;
}

/// No closure: every pair meets.
pub(super) struct Unasked;

impl Replies for Unasked {
    const ASKS: bool = false;
    const CROSSES: bool = false;
    fn to(&mut self, _: Pair) -> Reply {
        Reply::Meet
    }
}

/// A closure that answers.
pub(super) struct ByCall<F>(pub(super) F);

impl<A: Answer, F: FnMut(Pair) -> A> Replies for ByCall<F> {
    const ASKS: bool = true;
    const CROSSES: bool = A::CROSSES;
    fn to(&mut self, pair: Pair) -> Reply {
        (self.0)(pair).reply()
    }
}
