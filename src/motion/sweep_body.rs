//! Sweeps a box and a circle against each kind of feature, and the sides of a box against corners
//! and arcs.

use super::body::Entry;
use super::body::kernel::Kernel;
use super::sweep_face::{Face, sweep_face, sweep_slope};
use super::sweep_round::{enter_quarter, is_square, leave_by_corner, leave_pipe, sweep_cone};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, MOTION, Raw};
use crate::query::meet;
use crate::shape::{Aabb, Circle};
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
        let Geometry::Arc { centre, radius, quadrant, convex } = feature.geometry else {
            return self.sweep_straight(d, feature);
        };
        let (corner, _) = self.toward(if convex { quadrant.reversed() } else { quadrant });
        let centre = Raw::of(centre);
        if convex {
            sweep_round((self.lo(), self.hi()), corner, d, (centre, radius, quadrant))
        } else {
            leave_by_corner(corner.sub(centre), radius, d, quadrant)
        }
    }

    fn sweep_straight(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        match feature.geometry {
            Geometry::Face { dir, .. } if dir.x == 0 || dir.y == 0 => self.sweep_block(d, feature),
            Geometry::Face { a, dir, len, joined } => {
                // A box reaches beyond the slope's line exactly if its corner nearest to the line
                // does. The normal is (dir.y, -dir.x).
                let (corner, _) = self.toward(dir.perp());
                let joined = self.stopped_by_ends(dir, d, joined);
                sweep_slope(corner, 0, d, &Face { a: Raw::of(a), dir, len, joined })
            }
            Geometry::Vertex { p, e_in, e_out } => sweep_peak(self.lo(), self.hi(), d, Raw::of(p), e_in, e_out),
            Geometry::Arc { .. } => None,
        }
    }

    #[inline]
    fn sweep_block(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        // A block's corners need no test: its faces, closed where the motion enters them, cover
        // everything that a box can hit.
        match feature.geometry {
            Geometry::Face { a, dir, len, joined } => {
                sweep_face((self.lo(), self.hi()), 0, d, &Face { a: Raw::of(a), dir, len, joined })
            }
            Geometry::Vertex { .. } | Geometry::Arc { .. } => None,
        }
    }

    fn core_box(&self) -> (Raw, Raw) {
        (self.lo(), self.hi())
    }

    fn rounding(&self) -> i32 {
        0
    }

    fn toward(&self, quadrant: Axis) -> (Raw, i32) {
        (corner(self.lo(), self.hi(), quadrant), 0)
    }

    fn is_within(&self, a: Raw, b: Raw, reach: i32) -> bool {
        let reach = Raw { x: reach, y: reach };
        meet::segment_aabb::<true>(a, b, self.lo().sub(reach), self.hi().add(reach))
    }

    fn faces_within(&self, dir: Axis, (a, b): (Raw, Raw), reach: i32) -> bool {
        let (p, _) = self.toward(dir.perp());
        Self::from_raw_unchecked(p, p).is_within(a, b, reach)
    }

    fn overlaps_world<W: World>(&self, world: &W) -> bool {
        world.overlaps_aabb(self)
    }

    fn is_inside<W: World>(world: &W, p: Raw) -> bool {
        world.overlaps_aabb(&Self::from_raw_unchecked(p, p))
    }
}

impl Kernel for Circle {
    const MEETS_CORNERS: bool = true;

    fn meets_joints(&self) -> bool {
        self.r() == 0
    }

    fn bounds(&self) -> Aabb {
        self.aabb()
    }

    fn extent(&self) -> Raw {
        let width = self.r().wrapping_mul(2);
        Raw { x: width, y: width }
    }

    fn check_size(&self) -> Result<(), RangeError> {
        if self.r() < MOTION { Ok(()) } else { Err(RangeError { what: Quantity::BodySize, value: self.r() }) }
    }

    fn shifted(&self, d: Raw) -> Self {
        Self::from_raw_unchecked(self.c().add(d), self.r())
    }

    #[inline]
    fn sweep(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let Geometry::Arc { centre, radius, quadrant, convex } = feature.geometry else {
            return self.sweep_straight(d, feature);
        };
        let (m, r) = (self.c().sub(Raw::of(centre)), self.r());
        if convex {
            enter_quarter(m, radius.wrapping_add(r), d, quadrant, true)
        } else {
            leave_pipe(m, radius.wrapping_sub(r), d, quadrant)
        }
    }

    #[inline]
    fn sweep_straight(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let (c, r) = (self.c(), self.r());
        match feature.geometry {
            Geometry::Face { a, dir, len, joined } if dir.x != 0 && dir.y != 0 => {
                sweep_slope(c, r, d, &Face { a: Raw::of(a), dir, len, joined })
            }
            Geometry::Vertex { p, e_in, e_out } if !is_square(e_in, e_out) => {
                sweep_cone(c.sub(Raw::of(p)), r, d, e_in, e_out)
            }
            _ => self.sweep_block(d, feature),
        }
    }

    #[inline]
    fn sweep_block(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let (c, r) = (self.c(), self.r());
        match feature.geometry {
            Geometry::Face { a, dir, len, joined } => {
                // A circle without radius is a box without size: it may touch a face's free end and
                // pass.
                sweep_face((c, c), r, d, &Face { a: Raw::of(a), dir, len, joined })
            }
            // The cone of a block's corner is a quadrant. On its borders, and outside of it, the
            // faces are responsible.
            Geometry::Vertex { p, e_in, e_out } => {
                let quadrant = Axis::new(e_in.x.wrapping_sub(e_out.x), e_in.y.wrapping_sub(e_out.y));
                enter_quarter(c.sub(Raw::of(p)), r, d, quadrant, false)
            }
            Geometry::Arc { .. } => None,
        }
    }

    fn core_box(&self) -> (Raw, Raw) {
        (self.c(), self.c())
    }

    fn rounding(&self) -> i32 {
        self.r()
    }

    fn toward(&self, _: Axis) -> (Raw, i32) {
        (self.c(), self.r())
    }

    fn is_within(&self, a: Raw, b: Raw, reach: i32) -> bool {
        meet::circle_segment::<true>(self.c(), self.r().wrapping_add(reach), a, b)
    }

    fn is_within_straight(&self, a: Raw, b: Raw, reach: i32) -> bool {
        let lo = Raw { x: a.x.min(b.x), y: a.y.min(b.y) };
        let hi = Raw { x: a.x.max(b.x), y: a.y.max(b.y) };
        meet::circle_aabb::<true>(self.c(), self.r().wrapping_add(reach), lo, hi)
    }

    fn overlaps_world<W: World>(&self, world: &W) -> bool {
        world.overlaps_circle(self)
    }

    fn is_inside<W: World>(world: &W, p: Raw) -> bool {
        world.overlaps_circle(&Self::from_raw_unchecked(p, 0))
    }
}

impl Aabb {
    /// Which ends of a slope stop this box, if it meets only the end. Those that are joined do.
    ///
    /// A box without width or height moves with its side over the face, too. Another box then meets
    /// the next part of the surface.
    fn stopped_by_ends(&self, dir: Axis, d: Raw, joined: [bool; 2]) -> [bool; 2] {
        let size = Raw::of(self.size());
        let over = match (size.x == 0, size.y == 0) {
            (false, true) => dir.y.signum().wrapping_mul(d.y.signum()),
            (true, false) => dir.x.signum().wrapping_mul(d.x.signum()),
            _ => 0,
        };
        [joined[0] || over > 0, joined[1] || over < 0]
    }
}

/// The corner of a box that is farthest in a quadrant.
pub(super) const fn corner(lo: Raw, hi: Raw, quadrant: Axis) -> Raw {
    Raw { x: if quadrant.x > 0 { hi.x } else { lo.x }, y: if quadrant.y > 0 { hi.y } else { lo.y } }
}

/// Entry of a side of the box that lands on a convex corner: along x or y, wherever that direction
/// points out of both edges.
///
/// If one of the edges is parallel to the side, the whole side meets that edge's face. The corner
/// then adds nothing.
#[inline(never)]
pub(super) fn sweep_peak(lo: Raw, hi: Raw, d: Raw, p: Raw, e_in: Axis, e_out: Axis) -> Option<Entry> {
    let side = |out: i32, back: i32| if (out < 0) != (back < 0) && out != 0 && back != 0 { out.signum() } else { 0 };
    let mut first = sweep_end((lo, hi), 0, d, p, Axis::new(0, side(e_in.y, e_out.y)));
    keep_first(&mut first, sweep_end((lo, hi), 0, d, p, Axis::new(side(e_in.x, e_out.x), 0)).as_ref(), d);
    first
}

/// Entry of a side of the box, grown by `r`, that lands on a point of the surface. The normal there
/// is parallel to x or y. None if it is zero.
#[inline(never)]
pub(super) fn sweep_end(core: (Raw, Raw), r: i32, d: Raw, p: Raw, normal: Axis) -> Option<Entry> {
    if normal.is_zero() {
        return None;
    }
    let dir = normal.perp();
    sweep_face(core, r, d, &Face { a: p, dir, len: 0, joined: [false; 2] })
}

/// Entry through a convex arc. The corner of the box nearest to the arc's centre enters the arc
/// itself. Or a side lands on an end with a normal along x or y. The same side also meets a flat
/// face that continues from there.
#[inline(never)]
pub(super) fn sweep_round((lo, hi): (Raw, Raw), corner: Raw, d: Raw, arc: (Raw, i32, Axis)) -> Option<Entry> {
    let (centre, radius, quadrant) = arc;
    let end = |normal: Axis| {
        let p = centre.add(Raw { x: normal.x.wrapping_mul(radius), y: normal.y.wrapping_mul(radius) });
        sweep_end((lo, hi), 0, d, p, normal)
    };
    let mut first = end(Axis::new(quadrant.x, 0));
    keep_first(&mut first, end(Axis::new(0, quadrant.y)).as_ref(), d);
    keep_first(&mut first, enter_quarter(corner.sub(centre), radius, d, quadrant, true).as_ref(), d);
    first
}

/// Replaces an entry by another one that precedes it.
#[inline(never)]
pub(super) fn keep_first(first: &mut Option<Entry>, other: Option<&Entry>, d: Raw) {
    if let Some(other) = other {
        if first.as_ref().is_none_or(|first| other.before_askew(first, d)) {
            *first = Some(*other);
        }
    }
}
