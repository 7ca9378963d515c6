//! A moving circle against faces along x and y, and what tells its other cases apart.

use super::body::{Entry, kernel::Kernel};
use super::sweep_arc::{enter_quarter, leave_centre, leave_quarter};
use super::sweep_box::{Face, over, sweep_face};
use super::sweep_corner::sweep_slope;
use super::sweep_slope::sweep_disc_slope;
use super::sweep_vertex::{is_square, sweep_cone, sweep_square};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, MOTION, Raw, usqr};
use crate::shape::{Aabb, Circle};
use crate::world::{Feature, Geometry, World};

impl Kernel for Circle {
    const MEETS_CORNERS: bool = true;

    fn bounds(&self) -> Aabb {
        self.aabb()
    }

    fn check_size(&self) -> Result<(), RangeError> {
        if self.r() < MOTION { Ok(()) } else { Err(RangeError { what: Quantity::BodySize, value: self.r() }) }
    }

    fn shifted(&self, d: Raw) -> Self {
        Self::from_raw_unchecked(self.c().add(d), self.r())
    }

    #[inline]
    fn sweep(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let (c, r) = (self.c(), self.r());
        match feature.geometry {
            Geometry::Face { a, dir, len, joined } if dir.x != 0 && dir.y != 0 => {
                let a = Raw::of(a);
                // As below: without radius it is a box without size.
                if r == 0 { sweep_slope(c, c, d, a, dir, len, joined) } else { sweep_disc_slope(c, r, d, a, dir, len) }
            }
            Geometry::Vertex { p, e_in, e_out } if !is_square(e_in, e_out) => {
                let m = c.sub(Raw::of(p));
                // A one-way corner is passed by what is over it already; a solid one never is.
                if feature.one_way && m.len2() < usqr(r as u32) { None } else { sweep_cone(m, r, d, e_in, e_out) }
            }
            Geometry::Arc { centre, radius, quadrant, convex } => {
                let m = c.sub(Raw::of(centre));
                if convex {
                    enter_quarter(m, radius.wrapping_add(r), d, quadrant)
                } else if r < radius {
                    leave_quarter(m, radius.wrapping_sub(r), d, quadrant)
                } else if r == radius {
                    leave_centre(m, d, quadrant)
                } else {
                    // It meets the arc's ends first.
                    None
                }
            }
            _ => self.sweep_block(d, feature),
        }
    }

    #[inline]
    fn sweep_block(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let (c, r) = (self.c(), self.r());
        match feature.geometry {
            Geometry::Face { a, dir, len, joined } => {
                let face = Face::new(Raw::of(a), dir, len, joined);
                // A circle without radius is a box without size: it may touch a face's free end and pass.
                if r == 0 { sweep_face(c, c, d, &face) } else { sweep_disc_face(c, r, d, &face) }
            }
            Geometry::Vertex { p, e_in, e_out } => sweep_square(c.sub(Raw::of(p)), r, d, e_in, e_out),
            Geometry::Arc { .. } => None,
        }
    }

    fn toward(&self, _: Axis) -> (Raw, i32) {
        (self.c(), self.r())
    }

    fn overlaps_world<W: World>(&self, world: &W) -> bool {
        world.overlaps_circle(self)
    }
}

/// As [`sweep_face`], for the point of the disc that faces the wall: it must meet the closed face.
fn sweep_disc_face(c: Raw, r: i32, d: Raw, face: &Face) -> Option<Entry> {
    let (speed, along) = face.split(d);
    let into = face.away(speed).wrapping_neg();
    if into <= 0 {
        return None;
    }
    let (c_n, c_t) = face.split(c);
    let gap = face.in_front(c_n).wrapping_sub(r);
    if gap < 0 || gap >= into {
        return None;
    }
    let over_lo = over(c_t.wrapping_sub(face.lo), along, gap, into);
    let over_hi = over(face.hi.wrapping_sub(c_t), along.wrapping_neg(), gap, into);
    (over_lo >= 0 && over_hi >= 0).then_some(Entry {
        num: gap as u32,
        den: into as u32,
        normal: face.normal,
        at_end: false,
        step: None,
    })
}
