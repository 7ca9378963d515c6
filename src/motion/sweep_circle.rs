//! A moving circle against faces along x and y, and what tells its other cases apart.

use super::body::{Entry, kernel::Kernel};
use super::sweep_box::{Face, sweep_face};
use super::sweep_round::{enter_quarter, leave_centre, leave_quarter};
use super::sweep_round::{is_square, sweep_cone};
use super::sweep_slope::sweep_slope;
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, MOTION, Raw};
use crate::shape::{Aabb, Circle};
use crate::world::{Feature, Geometry, World};

impl Kernel for Circle {
    const MEETS_CORNERS: bool = true;

    fn meets_joints(&self) -> bool {
        self.r() == 0
    }

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
                sweep_slope(c, r, d, &Face { a: Raw::of(a), dir, len, joined })
            }
            Geometry::Vertex { p, e_in, e_out } if !is_square(e_in, e_out) => {
                sweep_cone(c.sub(Raw::of(p)), r, d, e_in, e_out)
            }
            Geometry::Arc { centre, radius, quadrant, convex } => {
                let m = c.sub(Raw::of(centre));
                if convex {
                    enter_quarter(m, radius.wrapping_add(r), d, quadrant, true)
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
                // A circle without radius is a box without size: it may touch a face's free end and pass.
                let joined = if r == 0 { joined } else { [true; 2] };
                sweep_face((c, c), r, d, &Face { a: Raw::of(a), dir, len, joined })
            }
            // The cone of a block's corner is a quadrant; on its borders, and outside of it, the faces are in charge.
            Geometry::Vertex { p, e_in, e_out } => {
                let quadrant = Axis::new(e_in.x.wrapping_sub(e_out.x), e_in.y.wrapping_sub(e_out.y));
                enter_quarter(c.sub(Raw::of(p)), r, d, quadrant, false)
            }
            Geometry::Arc { .. } => None,
        }
    }

    fn toward(&self, _: Axis) -> (Raw, i32) {
        (self.c(), self.r())
    }

    fn overlaps_world<W: World>(&self, world: &W) -> bool {
        world.overlaps_circle(self)
    }

    fn is_inside<W: World>(world: &W, p: Raw) -> bool {
        world.overlaps_circle(&Self::from_raw_unchecked(p, 0))
    }
}
