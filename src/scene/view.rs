//! Which level a body sees.

use super::SceneBody;
use crate::world::World;
use core::marker::PhantomData;

pub(super) trait View {
    type Level: World;
    fn level(&self, body: &SceneBody) -> &Self::Level;
}

/// One level for all.
pub(super) struct One<'l, W>(pub(super) &'l W);

impl<W: World> View for One<'_, W> {
    type Level = W;
    fn level(&self, _: &SceneBody) -> &W {
        self.0
    }
}

/// A level for each.
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
