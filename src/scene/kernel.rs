//! The shapes that bodies of a scene can have: a scene links only the code of its set.

use crate::error::RangeError;
use crate::motion::Body;
use crate::num::Vec2;
use crate::query::{CastShape, Contacts, MovingHit, Overlaps, RayTarget, Touches};
use crate::shape::kernel::Extent;
use crate::shape::{Aabb, Circle};
use core::fmt::Debug;

/// The shapes that bodies of a scene can have: [`Shape`](super::Shape),
/// [`WithCapsules`](super::WithCapsules), or [`AnyShape`](crate::shape::AnyShape).
///
/// It is a parameter of [`Scene`](crate::Scene) and [`SceneBody`](super::SceneBody), as the set of
/// tile shapes is one of [`TileMap`](crate::TileMap). So a scene of boxes and circles links no code
/// for capsules. `AnyShape` adds oriented boxes, polygons and slanted capsules. Each pair then
/// costs as much as a pair of polygons. Bodies do not turn.
///
/// ```
/// use tilesat::broad::SortSweep;
/// use tilesat::scene::{SceneBody, SceneTag};
/// use tilesat::shape::AnyShape;
/// use tilesat::{Aabb, Axis, OrientedBox, Scene, TileKind, TileKinds, TileMap, Vec2, fx};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let level = TileMap::from_ascii("....\n....\n....\n####\n", &KINDS)?; // the floor is at y = 48
/// let mut scene = Scene::<SortSweep<8, SceneTag>, 8, 0, AnyShape<4>>::new(SortSweep::new());
/// let diamond = OrientedBox::new(Vec2::from_ints(32, 20), Vec2::from_ints(5, 5), Axis::new(3, 4))?;
/// let diamond = scene.insert(&SceneBody::of(diamond, 1))?;
/// let crate_ = scene.insert(&SceneBody::of(Aabb::new(Vec2::from_ints(26, 2), Vec2::from_ints(38, 10))?, 2))?;
/// for _ in 0..120 {
///     scene.step(&level, Vec2::new(fx!(0), fx!(0.1)), |_| {})?;
/// }
/// assert_eq!(scene.body(diamond)?.shape.aabb().max().y, 48); // it stands on its corner
/// assert_eq!(scene.body(crate_)?.shape.aabb().max().y, 34); // and the crate lies on the other one
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Sealed: its kernels are part of the exactness argument.
pub trait BodyShape: BodyShapeKernel {}

/// The part of [`BodyShape`] that only this crate calls.
pub trait BodyShapeKernel:
    Copy
    + Debug
    + Eq
    + From<Aabb>
    + From<Circle>
    + Contacts<Self>
    + Overlaps<Self>
    + Touches<Self>
    + CastShape<Self>
    + RayTarget
    + Extent
{
    /// A point, for slots without a body.
    const POINT: Self;

    /// The box around it.
    fn aabb(&self) -> Aabb;

    /// The reference position, as of [`Body`].
    fn position(&self) -> Vec2;

    /// This shape moved by `by`. The caller ensures that it is inside of the domain.
    fn shifted(&self, by: Vec2) -> Self;

    /// This shape moved by `by`.
    ///
    /// # Errors
    /// [`RangeError`] if it would leave the domain.
    fn translated(&self, by: Vec2) -> Result<Self, RangeError>;

    /// Whether it rolls or tilts: it then touches others at any angle.
    fn is_round(&self) -> bool;

    /// Refuses shapes that no mover accepts. Movers accept all boxes and circles.
    ///
    /// # Errors
    /// [`RangeError`] for a capsule that is slanted or has no radius.
    fn check_body(&self) -> Result<(), RangeError>;

    /// When two moving shapes run into each other. `None` if a motion is too large.
    fn run_into(&self, by: Vec2, other: &Self, other_by: Vec2) -> Option<MovingHit>;

    /// Calls `visit` with the inner shape.
    fn visit<V: Visit<Self>>(&self, visit: V) -> V::Out;
}

/// A call for a body of any shape.
pub trait Visit<S> {
    /// The answer.
    type Out;
    /// The call.
    fn of<B: Body + Into<S>>(self, body: &B) -> Self::Out;
}
