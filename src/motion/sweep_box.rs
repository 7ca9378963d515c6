//! A moving box against faces along x and y, and what tells its other cases apart.

use super::body::{Entry, kernel::Kernel};
use super::sweep_arc::leave_by_corner;
use super::sweep_corner::{sweep_peak, sweep_round};
use super::sweep_slope::sweep_slope;
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, MOTION, Raw, imul};
use crate::shape::Aabb;
use crate::world::{Feature, Geometry, World};

impl Kernel for Aabb {
    const MEETS_CORNERS: bool = false;

    fn meets_joints(&self) -> bool {
        true
    }

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
            Geometry::Face { a, dir, len, joined } => {
                // A box reaches beyond the slope's line exactly where the corner does that is nearest to it; the normal is (dir.y, -dir.x).
                let (corner, _) = self.toward(Axis::new(dir.y.wrapping_neg(), dir.x));
                sweep_slope(corner, 0, d, &Face { a: Raw::of(a), dir, len, joined })
            }
            Geometry::Vertex { p, e_in, e_out } => sweep_peak(lo, hi, d, Raw::of(p), e_in, e_out),
            Geometry::Arc { centre, radius, quadrant, convex } => {
                let (corner, _) = self.toward(if convex { quadrant.reversed() } else { quadrant });
                let centre = Raw::of(centre);
                if convex {
                    sweep_round((lo, hi), corner, d, (centre, radius, quadrant))
                } else {
                    leave_by_corner(corner.sub(centre), radius, d, quadrant)
                }
            }
        }
    }

    #[inline]
    fn sweep_block(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        // A block's corners need no test: its faces, closed where the motion enters them, cover what a box can hit.
        match feature.geometry {
            Geometry::Face { a, dir, len, joined } => {
                sweep_face((self.lo(), self.hi()), 0, d, &Face { a: Raw::of(a), dir, len, joined })
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

    fn is_inside<W: World>(world: &W, p: Raw) -> bool {
        world.overlaps_aabb(&Self::from_raw_unchecked(p, p))
    }
}

/// Entry of the box `lo..hi`, grown by `r` all around, moving by `d` through a face along x or y, if the motion would start to overlap beyond it.
///
/// With gap g >= 0 and speed s > 0 into the face, the entry time is g/s; the motion overlaps beyond the face only if it goes on
/// after touching (g < s). At that moment the box must span a part of the face: strictly, or touch the face's end while moving
/// over it, or, without width, touch an end beyond which the solid goes on. (One with width then spans a part of what goes on there.) Of a disc the
/// point that is nearest to the line must meet the closed face: it is a box without size to which all ends are joined.
#[inline(never)]
pub(super) fn sweep_face((lo, hi): (Raw, Raw), r: i32, d: Raw, face: &Face) -> Option<Entry> {
    let Face { a, dir, len, joined } = *face;
    // (across the face, along it)
    let split = |v: Raw| if dir.x == 0 { (v.x, v.y) } else { (v.y, v.x) };
    let outward = dir.y.wrapping_sub(dir.x);
    let (speed, along) = split(d);
    let into = if outward < 0 { speed } else { speed.wrapping_neg() };
    if into <= 0 {
        return None;
    }
    let ((lo_n, lo_t), (hi_n, hi_t), (at, start)) = (split(lo), split(hi), split(a));
    let gap = if outward < 0 { at.wrapping_sub(hi_n) } else { lo_n.wrapping_sub(at) }.wrapping_sub(r);
    if gap < 0 || gap >= into {
        return None;
    }
    let (first, last) = (lo_t.wrapping_sub(start), hi_t.wrapping_sub(start));
    let (first, last, along) = if dir.x.wrapping_add(dir.y) > 0 {
        (first, last, along)
    } else {
        (last.wrapping_neg(), first.wrapping_neg(), along.wrapping_neg())
    };
    let over_start = over(last, along, gap, into);
    let over_end = over(len.wrapping_sub(first), along.wrapping_neg(), gap, into);
    let thin = lo_t == hi_t;
    let meets =
        |over: i32, moving_over: bool, joined: bool| over > 0 || (over == 0 && (moving_over || (thin && joined)));
    let spans = meets(over_start, along > 0, joined[0]) && meets(over_end, along < 0, joined[1]);
    let at_end = (over_start == 0 && !joined[0]) || (over_end == 0 && !joined[1]);
    let normal = Axis::new(dir.y, dir.x.wrapping_neg());
    spans.then_some(Entry { num: gap as u32, den: into as u32, normal, at_end, step: None })
}

/// A [`Geometry::Face`].
pub(super) struct Face {
    pub(super) a: Raw,
    pub(super) dir: Axis,
    pub(super) len: i32,
    pub(super) joined: [bool; 2],
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
