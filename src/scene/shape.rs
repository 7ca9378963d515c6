//! The shapes of a scene's bodies.

use crate::num::{Raw, Vec2};
use crate::query::{Contact, Contacts, Overlaps, Touches};
use crate::shape::{Aabb, Circle};
use crate::world::World;

/// A box or a circle. Pair queries call the kernel of the two shapes.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::scene::Shape;
/// use tilesat::{Aabb, Axis, Circle, Fx, Vec2};
/// let crate_: Shape = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(10, 10))?.into();
/// let ball: Shape = Circle::new(Vec2::from_ints(12, 5), Fx::from_num(3))?.into();
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

impl From<Aabb> for Shape {
    fn from(aabb: Aabb) -> Self {
        Self::Aabb(aabb)
    }
}

impl From<Circle> for Shape {
    fn from(circle: Circle) -> Self {
        Self::Circle(circle)
    }
}

impl Shape {
    /// The same shape elsewhere. The caller ensures that it is inside of the domain.
    pub(super) fn shifted(&self, by: Vec2) -> Self {
        match self {
            Self::Aabb(aabb) => {
                let by = Raw::of(by);
                Self::Aabb(Aabb::from_raw_unchecked(aabb.lo().add(by), aabb.hi().add(by)))
            }
            Self::Circle(circle) => Self::Circle(Circle::from_raw_unchecked(circle.c().add(Raw::of(by)), circle.r())),
        }
    }

    /// The box around it.
    #[must_use]
    pub const fn aabb(&self) -> Aabb {
        match self {
            Self::Aabb(aabb) => *aabb,
            Self::Circle(circle) => circle.aabb(),
        }
    }

    /// The minimum corner of a box, the centre of a circle.
    #[must_use]
    pub const fn position(&self) -> Vec2 {
        match self {
            Self::Aabb(aabb) => aabb.min(),
            Self::Circle(circle) => circle.centre(),
        }
    }

    /// Whether it overlaps a level: strict and exact.
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
            Self::Aabb(aabb) => level.overlaps_aabb(aabb),
            Self::Circle(circle) => level.overlaps_circle(circle),
        }
    }
}

/// Generates a verb of the pair queries, which dispatches on the two shapes.
macro_rules! verb {
    ($a:ident, $b:ident, $verb:ident) => {
        match ($a, $b) {
            (Shape::Aabb(a), Shape::Aabb(b)) => a.$verb(b),
            (Shape::Aabb(a), Shape::Circle(b)) => a.$verb(b),
            (Shape::Circle(a), Shape::Aabb(b)) => a.$verb(b),
            (Shape::Circle(a), Shape::Circle(b)) => a.$verb(b),
        }
    };
}

impl Contacts<Shape> for Shape {
    fn contact(&self, b: &Shape) -> Option<Contact> {
        verb!(self, b, contact)
    }
}

impl Overlaps<Shape> for Shape {
    fn overlaps(&self, b: &Shape) -> bool {
        verb!(self, b, overlaps)
    }
}

impl Touches<Shape> for Shape {
    fn touches(&self, b: &Shape) -> bool {
        verb!(self, b, touches)
    }
}
