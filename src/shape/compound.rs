//! A few shapes that are one.

use super::{Aabb, AnyShape, Capsule, Circle, ConvexParts, ConvexPolygon, OrientedBox, Segment};
use crate::error::RangeError;
use crate::num::{Raw, Vec2};
use core::fmt;

/// Why shapes have not become one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum CompoundError {
    /// There is no part.
    Empty,
    /// There are more parts than there is room for.
    TooMany {
        /// How many there is room for.
        capacity: usize,
    },
}

impl fmt::Display for CompoundError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "a compound needs a part"),
            Self::TooMany { capacity } => write!(f, "more parts than the {capacity} that there is room for"),
        }
    }
}

impl core::error::Error for CompoundError {}

pub(crate) mod kernel {
    //! What a compound asks of shapes.

    use super::{Aabb, RangeError, Vec2};

    /// A shape with a bounding box.
    pub trait Extent {
        fn extent(&self) -> Aabb;
    }

    /// A shape that may be a part.
    pub trait Movable: Extent + Copy {
        /// # Errors
        /// Where it would leave the domain.
        fn moved(&self, by: Vec2) -> Result<Self, RangeError>;
    }
}

/// A shape that may be a part of a [`Compound`]: any but a compound. Sealed.
pub trait Single: kernel::Movable {}

macro_rules! single {
    ($([$($n:tt)*] $shape:ty),*) => {$(
        impl<$($n)*> kernel::Extent for $shape {
            #[inline]
            fn extent(&self) -> Aabb {
                self.aabb()
            }
        }

        impl<$($n)*> kernel::Movable for $shape {
            #[inline]
            fn moved(&self, by: Vec2) -> Result<Self, RangeError> {
                self.translated(by)
            }
        }

        impl<$($n)*> Single for $shape {}
    )*};
}

single!([] Aabb, [] Circle, [] Segment, [] Capsule, [] OrientedBox);
single!([const N: usize] ConvexPolygon<N>, [const N: usize] AnyShape<N>);

/// Up to `M` shapes of one type that move as one: a concave shape by its convex parts, a body with
/// a shield. [`AnyShape`] mixes types.
///
/// Parts have absolute positions: apply the offset of each part before you build the compound.
/// Every verb looks at the bounding box of all parts first, and at the parts only if that is met.
/// The answers are those of the parts:
///
/// | verb | answer |
/// |---|---|
/// | `overlaps`, `touches` | whether any part does |
/// | `contact`, `manifold` | of the part that is deepest, by the depth rounded up |
/// | `distance`, `closest_points` | of the part that is nearest, by the distance rounded down |
/// | `contains` | a point: whether any part does; a compound in a shape: whether all parts are |
/// | `cast_shape`, `cast_ray` | the earliest hit of a part; inside where any part is |
///
/// So a shape that lies exactly along the border between two parts overlaps neither. `contains`
/// cannot ask whether a compound contains a shape, because the shape may lie in several parts
/// together.
///
/// A compound is a [`Body`](crate::Body): movers slide it along levels, by its parts. Levels answer
/// the same questions about it as about its parts, and list the
/// [deepest contact](crate::TileMap::contacts) with each feature.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Circle, Vec2, fx, shape::Compound};
/// // An L.
/// let tall = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(10, 30))?;
/// let flat = Aabb::new(Vec2::from_ints(10, 20), Vec2::from_ints(30, 30))?;
/// let l = Compound::<Aabb, 2>::new(&[tall, flat])?;
/// let ball = Circle::new(Vec2::from_ints(20, 10), fx!(9))?;
/// assert!(l.aabb().overlaps(&ball) && !l.overlaps(&ball)); // in the corner of the L
/// assert_eq!(l.distance(&ball), fx!(1));
/// assert_eq!(l.translated(Vec2::from_ints(2, -2))?.contact(&ball).unwrap().depth(), fx!(1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Compound<S, const M: usize> {
    /// Those beyond `count` are the first one.
    parts: [S; M],
    count: usize,
    bounds: Aabb,
}

impl<S: Single, const M: usize> Compound<S, M> {
    /// The shape of some parts, in any order.
    ///
    /// # Errors
    /// [`CompoundError`]: no part, or more than `M`.
    pub fn new(parts: &[S]) -> Result<Self, CompoundError> {
        let Some(first) = parts.first() else { return Err(CompoundError::Empty) };
        if parts.len() > M {
            return Err(CompoundError::TooMany { capacity: M });
        }
        let bounds = parts.iter().fold(first.extent(), |all, part| all.union(&part.extent()));
        let parts_of = |i: usize| *parts.get(i).unwrap_or(first);
        Ok(Self { parts: core::array::from_fn(parts_of), count: parts.len(), bounds })
    }

    /// The parts, where they are.
    #[must_use]
    pub fn parts(&self) -> &[S] {
        self.parts.get(..self.count).unwrap_or(&self.parts)
    }

    /// The bounding box of all parts; exact.
    #[must_use]
    pub const fn aabb(&self) -> Aabb {
        self.bounds
    }

    /// This shape moved by `by`.
    ///
    /// # Errors
    /// [`RangeError`] where it would leave the [domain](crate::num::DOMAIN).
    pub fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        let mut moved = Self { bounds: self.bounds.translated(by)?, ..*self };
        for part in &mut moved.parts {
            *part = part.moved(by)?;
        }
        Ok(moved)
    }

    /// The same by a displacement that keeps it inside the domain.
    pub(crate) fn shifted(&self, by: Raw) -> Self {
        self.translated(by.vec2()).unwrap_or(*self)
    }
}

impl<S: Single, const M: usize> kernel::Extent for Compound<S, M> {
    #[inline]
    fn extent(&self) -> Aabb {
        self.bounds
    }
}

impl<const N: usize, const M: usize> TryFrom<ConvexParts<N, M>> for Compound<ConvexPolygon<N>, M> {
    type Error = CompoundError;

    fn try_from(parts: ConvexParts<N, M>) -> Result<Self, CompoundError> {
        Self::new(parts.parts())
    }
}
