//! The level of each body, and the closure that receives its paths.

use super::SceneBody;
use super::kernel::BodyShape;
use crate::broad::Handle;
use crate::motion::{Body, ByFlags, MoveError, Moved, Mover, Responses, Surface};
use crate::num::Vec2;
use crate::world::{Traced, Trail, World};
use core::cell::Cell;
use core::marker::PhantomData;

/// A mover that slides.
pub(super) type Sliding = Mover<ByFlags<Surface>>;

/// The mover of all motions. There is one type, because another one would link most of a mover
/// again.
pub(super) fn sliding(mover: Mover) -> Sliding {
    mover.with_surface(Surface::SLICK).with_responses(Responses::NONE)
}

/// How a step finds the level of a body: one level for all, or a closure that returns one.
pub(super) trait View<S> {
    type Level: World;
    fn level(&self, body: &SceneBody<S>) -> &Self::Level;
    /// Moves a body. `from` is its shape.
    fn go<B: Body + Into<S>>(
        &self,
        mover: &Sliding,
        (_, body): (Handle, &SceneBody<S>),
        from: &B,
        by: Vec2,
    ) -> Result<Moved<B>, MoveError> {
        mover.move_and_slide(self.level(body), from, by)
    }
    /// A body has moved on a straight path.
    fn report_path(&self, _: Handle, _: &S, _: Vec2) {}
}

/// One level for all bodies.
pub(super) struct Common<'l, W>(pub(super) &'l W);

impl<W: World, S> View<S> for Common<'_, W> {
    type Level = W;

    fn level(&self, _: &SceneBody<S>) -> &W {
        self.0
    }
}

/// A closure that returns the level of each body.
pub(super) struct EachLevel<'l, W, F> {
    of: F,
    level: PhantomData<&'l W>,
}

impl<'l, W, F> EachLevel<'l, W, F> {
    pub(super) fn by<S>(of: F) -> Self
    where
        F: Fn(&SceneBody<S>) -> &'l W,
    {
        Self { of, level: PhantomData }
    }
}

impl<'l, W: World, S, F: Fn(&SceneBody<S>) -> &'l W> View<S> for EachLevel<'l, W, F> {
    type Level = W;

    fn level(&self, body: &SceneBody<S>) -> &W {
        (self.of)(body)
    }
}

/// [`EachLevel`], and a closure that receives each path.
pub(super) struct EachLevelTraced<'l, W, F, T> {
    levels: EachLevel<'l, W, F>,
    /// `None` while the closure runs.
    receiver: Cell<Option<T>>,
}

impl<'l, W, F, T> EachLevelTraced<'l, W, F, T> {
    pub(super) fn by<S>(of: F, receiver: T) -> Self
    where
        F: Fn(&SceneBody<S>) -> &'l W,
        T: FnMut(Handle, &S, &Trail),
    {
        Self { levels: EachLevel::by(of), receiver: Cell::new(Some(receiver)) }
    }

    fn passed<S>(&self, handle: Handle, from: &S, trail: &Trail)
    where
        T: FnMut(Handle, &S, &Trail),
    {
        if trail.parts().next().is_none() {
            return;
        }
        if let Some(mut receiver) = self.receiver.take() {
            receiver(handle, from, trail);
            self.receiver.set(Some(receiver));
        }
    }
}

impl<'l, W: World, S: BodyShape, F: Fn(&SceneBody<S>) -> &'l W, T: FnMut(Handle, &S, &Trail)> View<S>
    for EachLevelTraced<'l, W, F, T>
{
    type Level = W;

    fn level(&self, body: &SceneBody<S>) -> &W {
        (self.levels.of)(body)
    }

    fn go<B: Body + Into<S>>(
        &self,
        mover: &Sliding,
        (handle, body): (Handle, &SceneBody<S>),
        from: &B,
        by: Vec2,
    ) -> Result<Moved<B>, MoveError> {
        let traced = Traced::new((self.levels.of)(body));
        let moved = mover.move_and_slide(&traced, from, by)?;
        self.passed(handle, &(*from).into(), &traced.trail());
        Ok(moved)
    }

    fn report_path(&self, handle: Handle, from: &S, by: Vec2) {
        self.passed(handle, from, &Trail::straight(by));
    }
}
