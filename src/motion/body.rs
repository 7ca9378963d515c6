//! What a mover can move.

use crate::num::{Axis, Raw, Vec2, mul_div, umul};
use crate::shape::{Aabb, Circle};
use core::cmp::Ordering;

/// A shape that [`Mover::move_and_slide`](super::Mover::move_and_slide) can move: [`Aabb`] or [`Circle`].
///
/// Sealed: its kernels are part of the exactness argument.
pub trait Body: kernel::Kernel {
    /// The reference position: the centre of a circle, the minimum corner of a box.
    fn position(&self) -> Vec2;
}

impl Body for Aabb {
    fn position(&self) -> Vec2 {
        self.min()
    }
}

impl Body for Circle {
    fn position(&self) -> Vec2 {
        self.centre()
    }
}

/// A hit of one feature by one motion: entry time `num / den` in `[0, 1]`, with `0 < den <= 2^30`.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    pub(super) num: u32,
    pub(super) den: u32,
    /// Out of the solid, toward the body.
    pub(super) normal: Axis,
    /// Whether a box meets a face at its free end only, corner to corner: another face that it meets over a length goes first, and then
    /// the motion along that one passes this end.
    pub(super) at_end: bool,
    /// The displacement up to a vertex, rounded away from it; faces have `None`, their part of the motion is rounded toward the start.
    pub(super) step: Option<Raw>,
}

impl Entry {
    /// Whether this hit comes before `other`: earlier, else face before its end before vertex, else more opposed to the motion, else by the
    /// normal, x first. Only geometry decides, never the order of visits.
    pub(super) fn before(&self, other: &Self, d: Raw) -> bool {
        match self.time(other) {
            Ordering::Equal => {}
            earlier => return earlier == Ordering::Less,
        }
        if self.kind() != other.kind() {
            return self.kind() < other.kind();
        }
        let key = |e: &Self| (-e.normal.dot(Axis::new(d.x, d.y)), e.normal.x.unsigned_abs(), e.normal.x, e.normal.y);
        key(self) > key(other)
    }

    /// (vertex, end of a face).
    fn kind(&self) -> (bool, bool) {
        (self.step.is_some(), self.at_end)
    }

    /// Whether both are the same moment and the same surface.
    pub(super) fn same_as(&self, other: &Self) -> bool {
        self.normal == other.normal && self.kind() == other.kind() && self.time(other) == Ordering::Equal
    }

    /// Exact comparison of the times. Faces in one plane have equal fractions, which needs no product.
    fn time(&self, other: &Self) -> Ordering {
        if (self.num, self.den) == (other.num, other.den) {
            return Ordering::Equal;
        }
        umul(self.num, other.den).cmp(&umul(other.num, self.den))
    }

    /// The displacement up to the hit. On the face's axis it is exact, on the other one the exact part rounded toward the start; an
    /// integer half-plane that the exact point keeps, the rounded point keeps too.
    pub(super) fn displacement(&self, d: Raw) -> Raw {
        self.step.unwrap_or_else(|| Raw { x: self.part(d.x), y: self.part(d.y) })
    }

    fn part(&self, d: i32) -> i32 {
        let part = mul_div(d.unsigned_abs(), self.num, self.den) as i32;
        if d < 0 { part.wrapping_neg() } else { part }
    }
}

pub(super) mod kernel {
    //! The part of [`Body`](super::Body) that only this crate calls.

    use super::Entry;
    use crate::error::RangeError;
    use crate::num::Raw;
    use crate::shape::Aabb;
    use crate::world::{Feature, World};

    pub trait Kernel: Copy {
        /// Whether normals may be askew: where not, the code for them is not linked.
        const MEETS_CORNERS: bool;
        /// The bounding box.
        fn bounds(&self) -> Aabb;
        /// Refuses bodies with a half extent or radius of 2^28 or more.
        fn check_size(&self) -> Result<(), RangeError>;
        /// Moved by a displacement that keeps it inside the domain.
        fn shifted(&self, d: Raw) -> Self;
        /// The first moment of the motion at which the body would start to overlap the feature, if any.
        fn sweep(&self, d: Raw, feature: &Feature) -> Option<Entry>;
        /// Whether the body overlaps the level: strict and exact.
        fn overlaps_world<W: World>(&self, world: &W) -> bool;
    }
}
