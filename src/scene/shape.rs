//! The shapes of a scene's bodies.

use super::kernel::{BodyShape, BodyShapeKernel, Visit};
use crate::error::RangeError;
use crate::motion::Body;
use crate::num::{Raw, Toi, Vec2};
use crate::query::{CastHit, CastShape, Contact, Contacts, Inside, MovingHit, Overlaps, RayTarget, Touches};
use crate::shape::{Aabb, AnyShape, Capsule, Circle};
use crate::world::{World, probe};

/// A box or a circle: the default shapes of a scene.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::scene::Shape;
/// use tilesat::{Aabb, Axis, Circle, Vec2, fx};
/// let crate_: Shape = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(10, 10))?.into();
/// let ball: Shape = Circle::new(Vec2::from_ints(12, 5), fx!(3))?.into();
/// assert_eq!(crate_.contact(&ball).map(|contact| contact.axis()), Some(Axis::X));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Shape {
    /// A box.
    Aabb(Aabb),
    /// A circle.
    Circle(Circle),
}

/// A box, a circle, or a capsule that stands or lies: the shapes of a scene with round-footed
/// heroes, barrels and pills.
///
/// Use it as the last parameter of the scene, and make its bodies by
/// [`SceneBody::of`](super::SceneBody::of). A scene refuses capsules that are slanted or have no
/// radius, with [`Quantity::Capsule`](crate::Quantity::Capsule). Bodies do not turn, so a capsule
/// that stands does not fall over.
///
/// ```
/// use tilesat::broad::SortSweep;
/// use tilesat::scene::{SceneTag, WithCapsules};
/// use tilesat::{Aabb, Capsule, Scene, SceneBody, TileKind, TileKinds, TileMap, Vec2, fx};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let level = TileMap::from_ascii("....\n....\n....\n####\n", &KINDS)?; // the floor is at y = 48
/// let mut scene = Scene::<SortSweep<8, SceneTag>, 8, 0, WithCapsules>::new(SortSweep::new());
/// let lying = Capsule::new(Vec2::from_ints(24, 40), Vec2::from_ints(40, 40), fx!(8))?;
/// scene.insert(&SceneBody::of(lying, 1))?;
/// let crate_ = Aabb::new(Vec2::from_ints(28, 10), Vec2::from_ints(36, 18))?;
/// let crate_ = scene.insert(&SceneBody::of(crate_, 2))?;
/// for _ in 0..120 {
///     scene.step(&level, Vec2::new(fx!(0), fx!(0.1)), |_| {})?;
/// }
/// assert_eq!(scene.body(crate_)?.shape.aabb().max().y, 32); // it lies on the flat side
/// let slanted = Capsule::new(Vec2::from_ints(4, 4), Vec2::from_ints(8, 8), fx!(2))?;
/// assert!(scene.insert(&SceneBody::of(slanted, 3)).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum WithCapsules {
    /// A box.
    Aabb(Aabb),
    /// A circle.
    Circle(Circle),
    /// A capsule that stands or lies.
    Capsule(Capsule),
}

impl crate::world::Probe for Shape {}

impl probe::Probe for Shape {
    fn bounds(&self) -> (Raw, Raw) {
        let bounds = self.aabb();
        (bounds.lo(), bounds.hi())
    }

    fn reaches(&self, cell: (Raw, Raw)) -> bool {
        match self {
            Self::Aabb(it) => it.reaches(cell),
            Self::Circle(it) => it.reaches(cell),
        }
    }

    fn passes(&self, d: Raw, cell: (Raw, Raw)) -> bool {
        match self {
            Self::Aabb(it) => it.passes(d, cell),
            Self::Circle(it) => it.passes(d, cell),
        }
    }

    fn meets(&self, a: Raw, b: Raw) -> bool {
        match self {
            Self::Aabb(it) => it.meets(a, b),
            Self::Circle(it) => it.meets(a, b),
        }
    }

    fn touches_core(&self, corners: &[Vec2], radius: i32) -> bool {
        match self {
            Self::Aabb(it) => it.touches_core(corners, radius),
            Self::Circle(it) => it.touches_core(corners, radius),
        }
    }

    fn less(&self, offset: Raw) -> Self {
        match self {
            Self::Aabb(it) => Self::Aabb(it.less(offset)),
            Self::Circle(it) => Self::Circle(it.less(offset)),
        }
    }
}

impl BodyShape for Shape {}
impl BodyShape for WithCapsules {}

impl From<Shape> for WithCapsules {
    fn from(shape: Shape) -> Self {
        match shape {
            Shape::Aabb(it) => Self::Aabb(it),
            Shape::Circle(it) => Self::Circle(it),
        }
    }
}

/// The check of one shape, beyond that of its constructor.
trait CheckedShape {
    fn check(&self) -> Result<(), RangeError> {
        Ok(())
    }
}

impl CheckedShape for Aabb {}
impl CheckedShape for Circle {}

impl CheckedShape for Capsule {
    fn check(&self) -> Result<(), RangeError> {
        takes(self)
    }
}

/// Whether a mover accepts it.
fn takes<B: Body>(body: &B) -> Result<(), RangeError> {
    body.check_size()
}

fn shifted<B: Body>(body: &B, by: Vec2) -> B {
    body.shifted(Raw::of(by))
}

fn overlaps_level<B: Body>(body: &B, level: &impl World) -> bool {
    body.overlaps_world(level)
}

/// Generates the calls of a set of shapes: of each, and of all pairs.
macro_rules! shapes {
    ($name:ident: $($shape:ident.$position:ident)+, $(($a:ident $b:ident))+) => {
        $(impl From<$shape> for $name {
            fn from(shape: $shape) -> Self {
                Self::$shape(shape)
            }
        })+

        impl $name {
            /// The box around it.
            #[must_use]
            pub const fn aabb(&self) -> Aabb {
                match self {
                    $(Self::$shape(it) => bounds!($shape it),)+
                }
            }

            /// The minimum corner of a box, the centre of a circle, the first end of a capsule's
            /// core.
            #[must_use]
            pub const fn position(&self) -> Vec2 {
                match self {
                    $(Self::$shape(it) => it.$position(),)+
                }
            }

            /// The middle, as a target of a ray or a position to draw at. Half a raw unit is
            /// rounded toward the smaller coordinate.
            #[must_use]
            #[doc(alias = "center")]
            pub const fn centre(&self) -> Vec2 {
                self.aabb().centre()
            }

            /// This shape moved by `by`.
            ///
            /// # Errors
            /// [`RangeError`] if it would leave the [domain](crate::num::DOMAIN).
            #[inline]
            pub fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
                match self {
                    $(Self::$shape(it) => it.translated(by).map(Self::$shape),)+
                }
            }

            /// Whether this shape overlaps a level. Strict and exact.
            ///
            /// ```
            /// use tilesat::scene::Shape;
            /// use tilesat::{Circle, TileKind, TileKinds, TileMap, Vec2, fx};
            /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
            /// let level = TileMap::from_ascii("..\n##", &KINDS)?; // the floor is at y = 16
            /// let ball = |y| Circle::new(Vec2::from_ints(8, y), fx!(4)).map(Shape::Circle);
            /// assert!(ball(13)?.overlaps_level(&level) && !ball(12)?.overlaps_level(&level)); // touching is not overlapping
            /// # Ok::<(), Box<dyn std::error::Error>>(())
            /// ```
            #[must_use]
            pub fn overlaps_level(&self, level: &impl World) -> bool {
                match self {
                    $(Self::$shape(it) => overlaps_level(it, level),)+
                }
            }
        }

        impl $name {
            /// The first point of the shape that a ray from `origin` along `motion` meets, or
            /// `None` if it ends before. By the rules of the shape inside, as
            /// [`Circle::cast_ray`].
            ///
            /// ```
            /// use tilesat::scene::Shape;
            /// use tilesat::{Circle, Inside, Vec2, fx};
            /// let ball = Shape::Circle(Circle::new(Vec2::from_ints(20, 0), fx!(4))?);
            /// let hit = ball.cast_ray(Vec2::ZERO, Vec2::from_ints(32, 0), Inside::Hit)?.unwrap();
            /// assert_eq!(hit.displacement.x.round(), 16);
            /// # Ok::<(), tilesat::RangeError>(())
            /// ```
            ///
            /// # Errors
            /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
            pub fn cast_ray(&self, origin: Vec2, motion: Vec2, inside: Inside) -> Result<Option<CastHit>, RangeError> {
                match self {
                    $(Self::$shape(it) => it.cast_ray(origin, motion, inside),)+
                }
            }
        }

        impl RayTarget for $name {
            fn ray_hit(&self, origin: Vec2, motion: Vec2, inside: Inside) -> Result<Option<CastHit>, RangeError> {
                self.cast_ray(origin, motion, inside)
            }

            fn ray_toi(&self, origin: Vec2, d: Raw) -> Option<Toi> {
                match self {
                    $(Self::$shape(it) => it.ray_toi(origin, d),)+
                }
            }
        }

        impl BodyShapeKernel for $name {
            const POINT: Self = Self::Aabb(Aabb::from_raw_unchecked(Raw::ZERO, Raw::ZERO));

            #[inline]
            fn aabb(&self) -> Aabb {
                self.aabb()
            }

            #[inline]
            fn position(&self) -> Vec2 {
                self.position()
            }

            fn shifted(&self, by: Vec2) -> Self {
                match self {
                    $(Self::$shape(it) => Self::$shape(shifted(it, by)),)+
                }
            }

            #[inline]
            fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
                self.translated(by)
            }

            #[inline]
            fn is_round(&self) -> bool {
                !matches!(self, Self::Aabb(_))
            }

            #[inline]
            fn check_body(&self) -> Result<(), RangeError> {
                match self {
                    $(Self::$shape(it) => CheckedShape::check(it),)+
                }
            }

            fn run_into(&self, by: Vec2, other: &Self, other_by: Vec2) -> Option<MovingHit> {
                let hit = match (self, other) {
                    $((Self::$a(a), Self::$b(b)) => a.cast_moving(by, b, other_by, Inside::Hit),)+
                };
                hit.ok().flatten()
            }

            #[inline]
            fn visit<V: Visit<Self>>(&self, visit: V) -> V::Out {
                match self {
                    $(Self::$shape(it) => visit.of(it),)+
                }
            }
        }

        impl Contacts<$name> for $name {
            fn contact(&self, b: &$name) -> Option<Contact> {
                match (self, b) {
                    $((Self::$a(a), Self::$b(b)) => a.contact(b),)+
                }
            }
        }

        impl Overlaps<$name> for $name {
            fn overlaps(&self, b: &$name) -> bool {
                match (self, b) {
                    $((Self::$a(a), Self::$b(b)) => a.overlaps(b),)+
                }
            }
        }

        impl Touches<$name> for $name {
            fn touches(&self, b: &$name) -> bool {
                match (self, b) {
                    $((Self::$a(a), Self::$b(b)) => a.touches(b),)+
                }
            }
        }
    };
}

macro_rules! bounds {
    (Aabb $it:ident) => {
        *$it
    };
    ($round:ident $it:ident) => {
        $it.aabb()
    };
}

shapes!(Shape: Aabb.min Circle.centre, (Aabb Aabb) (Aabb Circle) (Circle Aabb) (Circle Circle));
shapes!(
    WithCapsules: Aabb.min Circle.centre Capsule.a,
    (Aabb Aabb) (Aabb Circle) (Aabb Capsule)
    (Circle Aabb) (Circle Circle) (Circle Capsule)
    (Capsule Aabb) (Capsule Circle) (Capsule Capsule)
);

/// Bodies of every convex shape. A scene refuses segments, and other bodies without area.
impl<const N: usize> BodyShape for AnyShape<N> {}

impl<const N: usize> BodyShapeKernel for AnyShape<N> {
    const POINT: Self = Self::Aabb(Aabb::from_raw_unchecked(Raw::ZERO, Raw::ZERO));

    fn aabb(&self) -> Aabb {
        self.aabb()
    }

    fn position(&self) -> Vec2 {
        Body::position(self)
    }

    fn shifted(&self, by: Vec2) -> Self {
        shifted(self, by)
    }

    fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        self.translated(by)
    }

    fn is_round(&self) -> bool {
        !matches!(self, Self::Aabb(_))
    }

    fn check_body(&self) -> Result<(), RangeError> {
        takes(self)
    }

    fn run_into(&self, by: Vec2, other: &Self, other_by: Vec2) -> Option<MovingHit> {
        CastShape::cast_moving(self, by, other, other_by, Inside::Hit).ok().flatten()
    }

    fn visit<V: Visit<Self>>(&self, visit: V) -> V::Out {
        visit.of(self)
    }
}
