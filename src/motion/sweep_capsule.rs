//! Sweeps a moving capsule: its round ends like a circle, its flat sides like a box.

use super::body::Entry;
use super::body::kernel::Kernel;
use super::sweep_body::{corner, keep_first, sweep_end};
use super::sweep_face::{Face, over, sweep_face, sweep_slope};
use super::sweep_round::{enter_quarter, is_square, leave_pipe, sweep_cone};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, MOTION, Raw};
use crate::query::meet;
use crate::shape::{Aabb, Capsule, Circle};
use crate::world::{Feature, Geometry, World};

/// A capsule consists of the discs around the two ends of its core, and the box between them. A
/// surface with a normal not across the core meets one of the discs before the box. Each sweep is
/// therefore as exact as that of a circle or of a box.
///
/// ```text
///      .---.
///     (  a  )      disc around a
///     |  |  |      flat sides: the box
///     (  b  )      disc around b
///      `---'
/// ```
impl Kernel for Capsule {
    const MEETS_CORNERS: bool = true;

    fn meets_joints(&self) -> bool {
        false
    }

    fn bounds(&self) -> Aabb {
        self.aabb()
    }

    fn check_size(&self) -> Result<(), RangeError> {
        let (lo, hi) = self.core_box();
        let (size, r) = (hi.sub(lo), self.rounding());
        let slant = size.x.min(size.y);
        if slant != 0 || r == 0 {
            return Err(RangeError { what: Quantity::Capsule, value: slant });
        }
        // Below 2^30, as the capsule is inside the domain.
        let largest = size.x.max(size.y).wrapping_add(r << 1);
        if largest >> 1 < MOTION { Ok(()) } else { Err(RangeError { what: Quantity::BodySize, value: largest }) }
    }

    fn shifted(&self, d: Raw) -> Self {
        Self::from_raw_unchecked(Raw::of(self.a()).add(d), Raw::of(self.b()).add(d), self.radius())
    }

    #[inline]
    fn sweep(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let Geometry::Arc { centre, radius, quadrant, convex } = feature.geometry else {
            return self.sweep_straight(d, feature);
        };
        let (centre, r) = (Raw::of(centre), self.rounding());
        if convex {
            return self.sweep_bulge(d, (centre, radius, quadrant));
        }
        let m = self.toward(quadrant).0.sub(centre);
        leave_pipe(m, radius.wrapping_sub(r), d, quadrant)
    }

    #[inline]
    fn sweep_straight(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let r = self.rounding();
        match feature.geometry {
            Geometry::Face { a, dir, len, joined } if dir.x != 0 && dir.y != 0 => {
                let (end, _) = self.toward(dir.perp());
                sweep_slope(end, r, d, &Face { a: Raw::of(a), dir, len, joined })
            }
            Geometry::Vertex { p, e_in, e_out } if !is_square(e_in, e_out) => {
                self.sweep_corner(d, Raw::of(p), e_in, e_out)
            }
            _ => self.sweep_block(d, feature),
        }
    }

    #[inline]
    fn sweep_block(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let r = self.rounding();
        match feature.geometry {
            Geometry::Face { a, dir, len, joined } => {
                sweep_face(self.core_box(), r, d, &Face { a: Raw::of(a), dir, len, joined })
            }
            // Only the quadrant inside of its faces remains of a block's corner; a flat side meets
            // the faces.
            Geometry::Vertex { p, e_in, e_out } => {
                let quadrant = Axis::new(e_in.x.wrapping_sub(e_out.x), e_in.y.wrapping_sub(e_out.y));
                let (end, _) = self.toward(quadrant.reversed());
                enter_quarter(end.sub(Raw::of(p)), r, d, quadrant, false)
            }
            Geometry::Arc { .. } => None,
        }
    }

    fn core_box(&self) -> (Raw, Raw) {
        let core = self.core().aabb();
        (core.lo(), core.hi())
    }

    fn rounding(&self) -> i32 {
        self.radius().to_bits()
    }

    fn toward(&self, quadrant: Axis) -> (Raw, i32) {
        let (lo, hi) = self.core_box();
        (corner(lo, hi, quadrant), self.rounding())
    }

    fn is_within(&self, a: Raw, b: Raw, reach: i32) -> bool {
        let ((lo, hi), r) = (self.core_box(), self.rounding().wrapping_add(reach));
        let flat = Raw { x: if lo.x == hi.x { r } else { 0 }, y: if lo.x == hi.x { 0 } else { r } };
        meet::circle_segment::<true>(lo, r, a, b)
            || meet::circle_segment::<true>(hi, r, a, b)
            || meet::segment_aabb::<true>(a, b, lo.sub(flat), hi.add(flat))
    }

    fn faces_within(&self, dir: Axis, (a, b): (Raw, Raw), reach: i32) -> bool {
        let (end, r) = self.toward(dir.perp());
        meet::circle_segment::<true>(end, r.wrapping_add(reach), a, b)
    }

    /// The inside of a capsule is that of its discs and its box. Every point of the sides between
    /// them, except the ends, is inside of a disc.
    fn overlaps_world<W: World>(&self, world: &W) -> bool {
        let ((lo, hi), r) = (self.core_box(), self.rounding());
        let flat = Raw { x: if lo.x == hi.x { r } else { 0 }, y: if lo.x == hi.x { 0 } else { r } };
        world.overlaps_aabb(&Aabb::from_raw_unchecked(lo.sub(flat), hi.add(flat)))
            || world.overlaps_circle(&Circle::from_raw_unchecked(lo, r))
            || world.overlaps_circle(&Circle::from_raw_unchecked(hi, r))
    }

    fn is_inside<W: World>(world: &W, p: Raw) -> bool {
        world.overlaps_circle(&Circle::from_raw_unchecked(p, 0))
    }
}

/// The part of a capsule that a moving point meets.
enum CapsulePart {
    /// The disc around an end of the core.
    End(Raw),
    /// A flat side that faces this way.
    Side(Axis),
}

impl Capsule {
    /// Entry of a convex corner of any angle.
    #[inline(never)]
    fn sweep_corner(&self, d: Raw, p: Raw, e_in: Axis, e_out: Axis) -> Option<Entry> {
        match self.part_toward(d, p)? {
            CapsulePart::End(end) => sweep_cone(end.sub(p), self.rounding(), d, e_in, e_out),
            // If the side is parallel to an edge, the face is responsible.
            CapsulePart::Side(normal) => {
                let leads_out = |e: Axis| normal.dot(e) > 0;
                let is_met = leads_out(e_in) && leads_out(e_out.reversed());
                if is_met { sweep_end(self.core_box(), self.rounding(), d, p, normal) } else { None }
            }
        }
    }

    /// Entry through a convex arc: of an end of the core, or of a flat side that lands on the
    /// parallel end of the arc.
    #[inline(never)]
    fn sweep_bulge(&self, d: Raw, (centre, radius, quadrant): (Raw, i32, Axis)) -> Option<Entry> {
        let ((lo, hi), r) = (self.core_box(), self.rounding());
        let (end, _) = self.toward(quadrant.reversed());
        let mut first = enter_quarter(end.sub(centre), radius.wrapping_add(r), d, quadrant, true);
        let normal = if lo.x == hi.x { Axis::new(quadrant.x, 0) } else { Axis::new(0, quadrant.y) };
        let p = centre.add(Raw { x: normal.x.wrapping_mul(radius), y: normal.y.wrapping_mul(radius) });
        keep_first(&mut first, sweep_end((lo, hi), r, d, p, normal).as_ref(), d);
        first
    }

    /// The part of the capsule that meets a point on its way, if it passes beside it. Exact: it
    /// depends on where along the core the point is when it reaches the line of a flat side.
    ///
    /// ```text
    ///        |   disc
    ///   p->  |---------- hi      beyond hi the disc around hi, if any
    ///        |
    ///        |  flat side        between: the side
    ///        |---------- lo
    /// ```
    fn part_toward(&self, d: Raw, p: Raw) -> Option<CapsulePart> {
        let ((lo, hi), r) = (self.core_box(), self.rounding());
        let stands = lo.x == hi.x;
        // (across the core, along it)
        let split = |v: Raw| if stands { (v.x, v.y) } else { (v.y, v.x) };
        let ((at, first), (_, last), (speed, along), (place, beside)) = (split(lo), split(hi), split(d), split(p));
        let (into, aside) =
            (speed.wrapping_abs(), if speed < 0 { at.wrapping_sub(place) } else { place.wrapping_sub(at) });
        let gap = if speed == 0 { aside.wrapping_abs() } else { aside }.wrapping_sub(r);
        let (beyond, before) = (last.wrapping_sub(beside), beside.wrapping_sub(first));
        let (beyond, before) = if gap < 0 {
            (beyond, before)
        } else if gap < into {
            (over(beyond, along, gap, into), over(before, along.wrapping_neg(), gap, into))
        } else {
            return None;
        };
        if beyond < 0 {
            Some(CapsulePart::End(hi))
        } else if before < 0 {
            Some(CapsulePart::End(lo))
        } else if gap < 0 {
            // The point is inside.
            None
        } else {
            let out = speed.signum().wrapping_neg();
            Some(CapsulePart::Side(if stands { Axis::new(out, 0) } else { Axis::new(0, out) }))
        }
    }
}
