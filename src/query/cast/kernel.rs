//! The arguments and answers of a cast, and the part of each pair in
//! [`CastShape`](super::CastShape); public in a private module.

use crate::error::RangeError;
use crate::num::{Axis, Raw, Toi, Vec2, check_coordinate};
use crate::shape::kernel::Movable;
use crate::shape::{Aabb, Circle, Segment};

/// The boundary that a motion meets, and when: decided, not yet computed.
pub trait Moment: Copy {
    /// The exact floor of the moment, in parts of the motion.
    fn exact_toi(&self, d: Raw) -> Toi;
    /// A lower bound of the moment, the displacement up to it, and the normal toward the moving
    /// shape. If the moment is a fraction, the bound is its exact floor. The displacement is
    /// rounded to a position at which the shapes do not overlap.
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
        exchanged(self.0.contact(d.reversed()))
    }
}

/// The contact of the exchanged pair.
#[inline]
pub(super) const fn exchanged((toi, step, axis): (Toi, Raw, Axis)) -> (Toi, Raw, Axis) {
    (toi, step.reversed(), axis.reversed())
}

/// The result of a motion.
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
    /// If there is no overlap before the motion.
    #[inline]
    pub(super) fn of(met: Option<M>) -> Self {
        met.map_or(Self::Free, Self::Meets)
    }

    /// A second question about the boundary that is met.
    #[inline]
    pub(super) fn then<N>(self, f: impl FnOnce(M) -> Option<N>) -> Course<N> {
        match self {
            Self::Free => Course::Free,
            Self::Inside => Course::Inside,
            Self::Meets(met) => Course::of(f(met)),
        }
    }

    #[inline]
    pub(crate) fn map<N>(self, f: impl FnOnce(M) -> N) -> Course<N> {
        match self {
            Self::Free => Course::Free,
            Self::Inside => Course::Inside,
            Self::Meets(moment) => Course::Meets(f(moment)),
        }
    }
}

/// A shape with a position.
pub trait InDomain {
    /// Refuses a shape that no constructor has checked.
    ///
    /// # Errors
    /// [`RangeError`] if it is outside the domain.
    #[inline]
    fn check(&self) -> Result<(), RangeError> {
        Ok(())
    }
}

/// A moving shape and the shape that it is cast against.
pub trait Enter<B: ?Sized>: InDomain {
    /// How the boundary of `b`, grown by this shape, may be met.
    type Moment: Moment;

    /// The hit of the motion `d`, below 2^29 per component. Its end may be outside the domain.
    fn enter(&self, b: &B, d: Raw) -> Course<Self::Moment>;

    /// [`enter`](Self::enter), with the answer of [`Moment::contact`]. A pair with several kinds of
    /// boundary then does not have to store which one it was.
    #[inline]
    fn first_contact(&self, b: &B, d: Raw) -> Course<(Toi, Raw, Axis)> {
        self.enter(b, d).map(|moment| moment.contact(d))
    }

    /// A displacement up to the hit of `d`, moved back until it overlaps nothing of `b`. For a
    /// single shape, the displacement is already rounded to such a position.
    #[inline]
    fn led_back(&self, _b: &B, _d: Raw, step: Raw) -> Raw {
        step
    }

    /// This answer without the numbers from which times are computed.
    #[inline]
    fn hits(&self, b: &B, d: Raw) -> Course<()> {
        self.enter(b, d).map(|_| ())
    }
}

/// A shape that a ray may hit, in the list of bodies of a scene.
pub trait RayTarget {
    /// Its `cast_ray`.
    ///
    /// # Errors
    /// [`RangeError`] if an end of the ray is outside the domain.
    fn ray_hit(&self, origin: Vec2, motion: Vec2, inside: Inside) -> Result<Option<CastHit>, RangeError>;

    /// The exact floor of the time of its hit from outside; `None` if the hit has it already.
    fn ray_toi(&self, origin: Vec2, d: Raw) -> Option<Toi>;
}

impl InDomain for Vec2 {
    #[inline]
    fn check(&self) -> Result<(), RangeError> {
        check_coordinate(*self)
    }
}

impl Movable for Vec2 {
    fn moved(&self, by: Vec2) -> Result<Self, RangeError> {
        let end = Raw::of(*self).add(Raw::of(by)).vec2();
        end.check().map(|()| end)
    }
}

impl InDomain for Aabb {}
impl InDomain for Circle {}
impl InDomain for Segment {}

/// The answer to a cast that starts inside: a ray in the solid, or a shape that overlaps the other
/// one.
///
/// The border is not inside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Inside {
    /// The motion continues to the first free position, and may hit after that.
    #[default]
    Ignore,
    /// It hits at once.
    Hit,
}

/// The hit of a shape or a ray on a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(alias("RaycastHit", "sweep result"))]
pub struct CastHit {
    /// The time of the hit: a fraction of the motion, 0 to 1. It is the exact floor in 2^-30 if
    /// straight sides meet, and for a circle that meets a side along x or y. For other circles it
    /// is a lower bound, early by less than a raw unit of travel.
    /// [`exact_toi`](super::CastShape::exact_toi) is exact for all.
    pub toi: Toi,
    /// The normal at the hit, from B toward A, against the motion. It is never zero, and has length
    /// one if it is parallel to x or y. For straight sides it is exact. For two circles it points
    /// from the centre of B to that of A at the hit. For a circle and a corner it lies on the line
    /// between the centre and the corner. Its resolution grows with the radius. In the closest
    /// graze it is perpendicular to the motion, within that rounding. Round shapes of a few raw
    /// units may have one that leans along the motion.
    pub axis: Axis,
    /// How far A moves until the hit. At `position + displacement` it touches B, or is less than 2
    /// raw units short of it, and does not overlap it. A motion longer than 4096 units may end four
    /// raw units short. If a [`Compound`](crate::shape::Compound) is met between two parts, the
    /// displacement is reduced until it overlaps neither.
    ///
    /// It may exceed the exact distance by less than a raw unit, if that is free. Along an axis
    /// parallel to x or y it is exact. Each component is between zero and that of the motion. So if
    /// the motion stays in the domain, the moved shape does, too.
    pub displacement: Vec2,
    /// Whether the shapes overlapped before the motion; only with [`Inside::Hit`]. The displacement
    /// is then zero, and the axis is opposite to the larger component of the motion (x on a tie).
    /// Without motion it is +x.
    pub inside: bool,
}

/// The hit of two moving shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MovingHit {
    /// The time of the hit, as [`CastHit::toi`], in parts of either motion.
    pub toi: Toi,
    /// The exact normal, out of B toward A.
    pub axis: Axis,
    /// How far A moves until the hit.
    pub displacement: Vec2,
    /// How far B moves until the hit. At these positions the two do not overlap. The difference of
    /// both is the [`displacement`](CastHit::displacement), and that of B is rounded toward its
    /// start.
    pub displacement_b: Vec2,
    /// Whether the shapes overlapped before the motion, as [`CastHit::inside`].
    pub inside: bool,
}

impl CastHit {
    /// A start inside, by a motion.
    pub(crate) const fn at_start(motion: Vec2) -> Self {
        let (x, y) = motion.raw();
        let axis = if y.unsigned_abs() > x.unsigned_abs() {
            Axis::new(0, if y > 0 { -1 } else { 1 })
        } else {
            Axis::new(if x > 0 { -1 } else { 1 }, 0)
        };
        Self { toi: Toi::ZERO, axis, displacement: Vec2::ZERO, inside: true }
    }
}
