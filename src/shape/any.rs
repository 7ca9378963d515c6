//! One type for shapes of all kinds.

use super::{Aabb, Capsule, Circle, ConvexPolygon, OrientedBox, Segment};
use crate::error::RangeError;
use crate::num::Vec2;

/// A shape of any kind, for lists that mix them.
///
/// Polygons have at most `N` corners. It has all verbs against all shapes, and movers take it as a
/// [`Body`](crate::Body). A slanted capsule moves only in this form. All yes/no answers, depths and
/// distances are those of the shape inside. If several exits are equally short, the axis is chosen
/// as for polygons. Between boxes, circles and segments the axis may also have another length. A
/// cast of two of these may be rounded otherwise, within its bounds, or hit the other of two sides
/// at one moment.
///
/// Every pair with this type runs the code of
/// [polygons](crate::query#capsules-oriented-boxes-and-polygons), which costs more than that of two
/// boxes or circles.
///
/// It takes as much memory as the polygon, `8 N + 12` bytes on a chip. Your game links that code
/// once for all kinds of shapes.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Capsule, Circle, Vec2, fx, shape::AnyShape};
/// let rocks: [AnyShape<4>; 2] = [
///     Circle::new(Vec2::from_ints(10, 10), fx!(4))?.into(),
///     Capsule::new(Vec2::from_ints(20, 0), Vec2::from_ints(40, 10), fx!(2))?.into(),
/// ];
/// let hero = Aabb::new(Vec2::from_ints(28, 6), Vec2::from_ints(36, 20))?;
/// assert_eq!(rocks.map(|rock| rock.overlaps(&hero)), [false, true]);
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum AnyShape<const N: usize> {
    /// An axis-aligned box.
    Aabb(Aabb),
    /// A circle.
    Circle(Circle),
    /// A segment.
    Segment(Segment),
    /// A capsule, in any direction.
    Capsule(Capsule),
    /// An oriented box.
    OrientedBox(OrientedBox),
    /// A convex polygon.
    Polygon(ConvexPolygon<N>),
}

macro_rules! each {
    ($shape:expr, |$it:ident| $body:expr) => {
        match $shape {
            AnyShape::Aabb($it) => $body,
            AnyShape::Circle($it) => $body,
            AnyShape::Segment($it) => $body,
            AnyShape::Capsule($it) => $body,
            AnyShape::OrientedBox($it) => $body,
            AnyShape::Polygon($it) => $body,
        }
    };
}
pub(super) use each;

impl<const N: usize> AnyShape<N> {
    /// This shape moved by `by`.
    ///
    /// # Errors
    /// [`RangeError`] if it would leave the [domain](crate::num::DOMAIN).
    pub const fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        macro_rules! moved {
            ($kind:ident, $it:expr) => {
                match $it.translated(by) {
                    Ok(moved) => Ok(Self::$kind(moved)),
                    Err(e) => Err(e),
                }
            };
        }
        match self {
            Self::Aabb(it) => moved!(Aabb, it),
            Self::Circle(it) => moved!(Circle, it),
            Self::Segment(it) => moved!(Segment, it),
            Self::Capsule(it) => moved!(Capsule, it),
            Self::OrientedBox(it) => moved!(OrientedBox, it),
            Self::Polygon(it) => moved!(Polygon, it),
        }
    }

    /// The bounding box; exact.
    #[must_use]
    pub const fn aabb(&self) -> Aabb {
        each!(self, |it| it.aabb())
    }
}

macro_rules! from {
    ($($kind:ident: $shape:ty),*) => {$(
        impl<const N: usize> From<$shape> for AnyShape<N> {
            fn from(shape: $shape) -> Self {
                Self::$kind(shape)
            }
        }
    )*};
}

from!(Aabb: Aabb, Circle: Circle, Segment: Segment, Capsule: Capsule, OrientedBox: OrientedBox, Polygon: ConvexPolygon<N>);
