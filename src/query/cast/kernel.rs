//! What a pair provides of [`CastShape`](super::CastShape); public in a private module.

use crate::error::RangeError;
use crate::num::{Axis, Raw, Toi, Vec2, check_coordinate};
use crate::shape::{Aabb, Circle, Segment};

/// The boundary that a motion comes through, and when: decided, not yet computed.
pub trait Moment: Copy {
    /// The exact floor of the moment, in parts of the motion.
    fn exact_toi(&self, d: Raw) -> Toi;
    /// A lower bound of the moment (where it is a fraction, the exact floor), the displacement up to it, rounded so that the shapes do not overlap there, and the normal toward what moves.
    fn contact(&self, d: Raw) -> (Toi, Raw, Axis);
}

/// A moment of the exchanged pair by the reversed motion.
#[derive(Clone, Copy, Debug)]
pub struct Exchanged<M>(pub(super) M);

impl<M: Moment> Moment for Exchanged<M> {
    #[inline]
    fn exact_toi(&self, d: Raw) -> Toi {
        self.0.exact_toi(d.reversed())
    }

    #[inline]
    fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        let (toi, step, axis) = self.0.contact(d.reversed());
        (toi, step.reversed(), axis.reversed())
    }
}

/// What becomes of a motion.
#[derive(Clone, Copy, Debug)]
pub enum Course<M> {
    /// It starts no overlap.
    Free,
    /// The shapes overlap before it: strict.
    Inside,
    /// It starts an overlap.
    Meets(M),
}

impl<M> Course<M> {
    /// Where there is no overlap before the motion.
    #[inline]
    pub(super) fn of(met: Option<M>) -> Self {
        met.map_or(Self::Free, Self::Meets)
    }

    #[inline]
    pub(super) fn map<N>(self, f: impl FnOnce(M) -> N) -> Course<N> {
        match self {
            Self::Free => Course::Free,
            Self::Inside => Course::Inside,
            Self::Meets(moment) => Course::Meets(f(moment)),
        }
    }
}

/// A shape with a place.
pub trait Placed {
    /// Refuses a shape that no constructor has checked.
    ///
    /// # Errors
    /// [`RangeError`] where it is outside of the domain.
    #[inline]
    fn check(&self) -> Result<(), RangeError> {
        Ok(())
    }
}

/// A moving shape and what it is cast against.
pub trait Enter<B: ?Sized>: Placed {
    /// How the boundary of `b`, grown by this shape, may be met.
    type Moment: Moment;

    /// What the motion `d` meets, below 2^29 a component; its end needs not be in the domain.
    fn enter(&self, b: &B, d: Raw) -> Course<Self::Moment>;

    /// The same without what times are computed from.
    #[inline]
    fn hits(&self, b: &B, d: Raw) -> Course<()> {
        self.enter(b, d).map(|_| ())
    }
}

impl Placed for Vec2 {
    #[inline]
    fn check(&self) -> Result<(), RangeError> {
        check_coordinate(*self)
    }
}

impl Placed for Aabb {}
impl Placed for Circle {}
impl Placed for Segment {}
