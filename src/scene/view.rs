//! Which level a body sees.

use super::SceneBody;
use crate::world::World;
use core::marker::PhantomData;

/// The level of each body. One name for a call and for the level that it returns.
pub(super) trait View {
    type Level: World;
    fn level(&self, body: &SceneBody) -> &Self::Level;
}

/// A call that says which.
pub(super) struct Each<'l, W, F> {
    of: F,
    level: PhantomData<&'l W>,
}

impl<'l, W, F: Fn(&SceneBody) -> &'l W> Each<'l, W, F> {
    pub(super) fn by(of: F) -> Self {
        Self { of, level: PhantomData }
    }
}

impl<'l, W: World, F: Fn(&SceneBody) -> &'l W> View for Each<'l, W, F> {
    type Level = W;
    fn level(&self, body: &SceneBody) -> &W {
        (self.of)(body)
    }
}
