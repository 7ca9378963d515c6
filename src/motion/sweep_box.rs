//! A moving box against faces along x and y, and what tells its other cases apart.

use super::body::{Entry, kernel::Kernel};
use super::sweep_arc::{enter_quarter, leave_quarter};
use super::sweep_corner::{sweep_peak, sweep_round, sweep_slope};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, MOTION, Raw, imul};
use crate::shape::Aabb;
use crate::world::{Feature, Geometry, World};

impl Kernel for Aabb {
    const MEETS_CORNERS: bool = false;

    fn bounds(&self) -> Aabb {
        *self
    }

    fn check_size(&self) -> Result<(), RangeError> {
        let size = Raw::of(self.size());
        let largest = size.x.max(size.y);
        if largest >> 1 < MOTION { Ok(()) } else { Err(RangeError { what: Quantity::BodySize, value: largest }) }
    }

    fn shifted(&self, d: Raw) -> Self {
        Self::from_raw_unchecked(self.lo().add(d), self.hi().add(d))
    }

    fn sweep(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let (lo, hi) = (self.lo(), self.hi());
        match feature.geometry {
            Geometry::Face { dir, .. } if dir.x == 0 || dir.y == 0 => self.sweep_block(d, feature),
            Geometry::Face { a, dir, len, joined } => sweep_slope(lo, hi, d, Raw::of(a), dir, len, joined),
            Geometry::Vertex { p, e_in, e_out } => sweep_peak(lo, hi, d, Raw::of(p), e_in, e_out),
            Geometry::Arc { centre, radius, quadrant, convex } => {
                let (corner, _) = self.toward(if convex { quadrant.reversed() } else { quadrant });
                let centre = Raw::of(centre);
                let m = corner.sub(centre);
                if convex {
                    sweep_round(lo, hi, d, centre, radius, quadrant, enter_quarter(m, radius, d, quadrant))
                } else {
                    leave_quarter(m, radius, d, quadrant)
                }
            }
        }
    }

    #[inline]
    fn sweep_block(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        // A block's corners need no test: its faces, closed where the motion enters them, cover what a box can hit.
        match feature.geometry {
            Geometry::Face { a, dir, len, joined } => {
                sweep_face(self.lo(), self.hi(), d, &Face::new(Raw::of(a), dir, len, joined))
            }
            Geometry::Vertex { .. } | Geometry::Arc { .. } => None,
        }
    }

    fn toward(&self, quadrant: Axis) -> (Raw, i32) {
        let (lo, hi) = (self.lo(), self.hi());
        (Raw { x: if quadrant.x > 0 { hi.x } else { lo.x }, y: if quadrant.y > 0 { hi.y } else { lo.y } }, 0)
    }

    fn overlaps_world<W: World>(&self, world: &W) -> bool {
        world.overlaps_aabb(self)
    }
}

/// An axis-parallel face in its own frame: `normal` is a unit axis, `lo..hi` its extent along the other axis.
pub(super) struct Face {
    pub(super) normal: Axis,
    /// The face's coordinate on the axis of its normal.
    pub(super) at: i32,
    pub(super) lo: i32,
    pub(super) hi: i32,
    /// Whether the solid goes on beyond `lo`, `hi`.
    joined: [bool; 2],
}

impl Face {
    pub(super) fn new(a: Raw, dir: Axis, len: i32, joined: [bool; 2]) -> Self {
        let normal = Axis::new(dir.y, dir.x.wrapping_neg());
        let (at, start, step) = if dir.x == 0 { (a.x, a.y, dir.y) } else { (a.y, a.x, dir.x) };
        if step > 0 {
            Self { normal, at, lo: start, hi: start.wrapping_add(len), joined }
        } else {
            Self { normal, at, lo: start.wrapping_sub(len), hi: start, joined: [joined[1], joined[0]] }
        }
    }

    /// `(along the normal's axis, along the face)`.
    pub(super) fn split(&self, v: Raw) -> (i32, i32) {
        if self.normal.x == 0 { (v.y, v.x) } else { (v.x, v.y) }
    }

    /// Distance in front of the face, of a coordinate on the axis of the normal.
    pub(super) fn in_front(&self, coordinate: i32) -> i32 {
        let d = coordinate.wrapping_sub(self.at);
        if self.normal.x + self.normal.y > 0 { d } else { d.wrapping_neg() }
    }

    /// The speed away from the face.
    pub(super) fn away(&self, speed: i32) -> i32 {
        if self.normal.x + self.normal.y > 0 { speed } else { speed.wrapping_neg() }
    }
}

/// Entry of the box `lo..hi` moving by `d` through a face, if the motion would start to overlap beyond it.
///
/// With gap g >= 0 and speed s > 0 into the face, the entry time is g/s; the motion overlaps beyond the face only if it goes on
/// after touching (g < s). At that moment the box must span a part of the face: strictly, or touch the face's end while moving
/// over it, or touch an end beyond which the solid goes on (this last only matters for boxes without width).
pub(super) fn sweep_face(lo: Raw, hi: Raw, d: Raw, face: &Face) -> Option<Entry> {
    let (speed, along) = face.split(d);
    let into = face.away(speed).wrapping_neg();
    if into <= 0 {
        return None;
    }
    let ((lo_n, lo_t), (hi_n, hi_t)) = (face.split(lo), face.split(hi));
    let leading = if speed > 0 { hi_n } else { lo_n };
    let gap = face.in_front(leading);
    if gap < 0 || gap >= into {
        return None;
    }
    let over_lo = over(hi_t.wrapping_sub(face.lo), along, gap, into);
    let over_hi = over(face.hi.wrapping_sub(lo_t), along.wrapping_neg(), gap, into);
    let meets = |over: i32, moving_over: bool, joined: bool| over > 0 || (over == 0 && (moving_over || joined));
    let spans = meets(over_lo, along > 0, face.joined[0]) && meets(over_hi, along < 0, face.joined[1]);
    let at_end = (over_lo == 0 && !face.joined[0]) || (over_hi == 0 && !face.joined[1]);
    spans.then_some(Entry { num: gap as u32, den: into as u32, normal: face.normal, at_end, step: None })
}

/// The sign of `reach + along * gap / into`, for `0 <= gap < into`: how far a body is over a face's end when it meets the face's line.
///
/// Where it has the same sign at both ends of the motion, that is the answer: no product. Else differences are below 2^31 and speeds
/// below 2^30, so the products are below 2^61.
pub(super) fn over(reach: i32, along: i32, gap: i32, into: i32) -> i32 {
    let end = reach.wrapping_add(along);
    if gap == 0 || reach.signum() == end.signum() {
        return reach.signum();
    }
    imul(reach, into).wrapping_add(imul(along, gap)).signum() as i32
}
