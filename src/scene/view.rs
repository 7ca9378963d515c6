//! Which level a body sees.

use super::SceneBody;
use crate::world::World;
use core::marker::PhantomData;

/// The level of each body. One name for a call and for the level that it returns.
pub(super) trait View<S> {
    type Level: World;
    fn level(&self, body: &SceneBody<S>) -> &Self::Level;
}

/// A call that says which.
pub(super) struct Each<'l, W, F> {
    of: F,
    level: PhantomData<&'l W>,
}

impl<'l, W, F> Each<'l, W, F> {
    pub(super) fn by<S>(of: F) -> Self
    where
        F: Fn(&SceneBody<S>) -> &'l W,
    {
        Self { of, level: PhantomData }
    }
}

impl<'l, W: World, S, F: Fn(&SceneBody<S>) -> &'l W> View<S> for Each<'l, W, F> {
    type Level = W;
    fn level(&self, body: &SceneBody<S>) -> &W {
        (self.of)(body)
    }
}
