//! Several shapes that act as one.

use super::{Aabb, AnyShape, Capsule, Circle, ConvexParts, ConvexPolygon, OrientedBox, Segment};
use crate::error::RangeError;
use crate::num::{Raw, Vec2};
use core::fmt;

/// Why shapes could not be combined into one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum CompoundError {
    /// There is no part.
    Empty,
    /// There are more parts than the compound can hold.
    TooMany {
        /// How many it can hold.
        capacity: usize,
    },
}

impl fmt::Display for CompoundError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "a compound needs at least one part"),
            Self::TooMany { capacity } => {
                write!(f, "the compound has more than {capacity} parts: raise the capacity, or leave parts out")
            }
        }
    }
}

impl core::error::Error for CompoundError {}

pub(crate) mod kernel {
    //! The requirements of a compound to its parts.

    use super::{Aabb, RangeError, Vec2};

    /// A shape with a bounding box.
    pub trait Extent {
        fn extent(&self) -> Aabb;
    }

    /// A shape with a position.
    pub trait Movable: Copy {
        /// # Errors
        /// [`RangeError`] if it would leave the domain.
        fn moved(&self, by: Vec2) -> Result<Self, RangeError>;
    }
}

/// A shape that may be a part of a [`Compound`]: any shape but a compound.
///
/// The trait is sealed.
pub trait Single: kernel::Movable + kernel::Extent {}

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

/// Up to `M` shapes of one type that move as one: a concave shape as its convex parts, or a body
/// with a shield.
///
/// [`AnyShape`] mixes types. Parts have absolute positions: apply the offset of each part before
/// you build the compound. Every verb looks at the bounding box of all parts first, and at the
/// parts only if that box is met. The answers are those of the parts:
///
/// | verb | answer |
/// |---|---|
/// | `overlaps`, `touches` | whether any part does |
/// | `contact`, `manifold` | that of the deepest part, by the depth rounded up |
/// | `distance`, `closest_points` | that of the nearest part, by the distance rounded down |
/// | `contains` | of a point: whether any part contains it; of a compound in a shape: whether all parts are in it |
/// | `cast_shape`, `cast_ray` | the earliest hit of a part; inside if any part is |
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
/// assert!(l.aabb().overlaps(&ball) && !l.overlaps(&ball)); // in the notch of the L
/// assert_eq!(l.distance(&ball), fx!(1));
/// assert_eq!(l.translated(Vec2::from_ints(2, -2))?.contact(&ball).unwrap().depth(), fx!(1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Compound<S, const M: usize> {
    /// Entries beyond `count` repeat the first part.
    parts: [S; M],
    count: usize,
    bounds: Aabb,
}

impl<S: Single, const M: usize> Compound<S, M> {
    /// A compound from its parts, in any order.
    ///
    /// # Errors
    /// [`CompoundError`] if there is no part, or more than `M`.
    pub fn new(parts: &[S]) -> Result<Self, CompoundError> {
        let Some(first) = parts.first() else { return Err(CompoundError::Empty) };
        if parts.len() > M {
            return Err(CompoundError::TooMany { capacity: M });
        }
        let bounds = parts.iter().fold(first.extent(), |all, part| all.union(&part.extent()));
        let parts_of = |i: usize| *parts.get(i).unwrap_or(first);
        Ok(Self { parts: core::array::from_fn(parts_of), count: parts.len(), bounds })
    }

    /// The parts, at their positions.
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
    /// [`RangeError`] if it would leave the [domain](crate::num::DOMAIN).
    pub fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        let mut moved = Self { bounds: self.bounds.translated(by)?, ..*self };
        for part in &mut moved.parts {
            *part = part.moved(by)?;
        }
        Ok(moved)
    }

    /// This shape moved by a displacement that keeps it inside the domain.
    pub(crate) fn shifted(&self, by: Raw) -> Self {
        self.translated(by.vec2()).unwrap_or(*self)
    }
}

impl<S: Single, const M: usize> kernel::Movable for Compound<S, M> {
    fn moved(&self, by: Vec2) -> Result<Self, RangeError> {
        self.translated(by)
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
