//! Where a body without area stops that no feature opposes.

use super::around::hull;
use super::body::{Body, Entry};
use super::order::First;
use super::plane::way;
use super::search::Search;
use crate::num::{Axis, Raw};
use crate::world::{Geometry, World};

impl<B: Body> Search<'_, B> {
    /// Takes the first end of an arc at which a body that has no extent across its motion runs into the solid, where that is before all else that
    /// it meets.
    ///
    /// The gap between a convex arc and the surface that it touches closes to nothing: both are tangent to the motion, and what is solid behind the
    /// end of the arc has no face there. A quarter pipe ends on the line of the wall beside it, where a body that comes down the wall passes the arc.
    /// Only a motion along x or y gets to either. From the end on it is in the inside of the
    /// solid, or in none for at least half a cell: a raw unit farther tells which. What has a face there is met by that, at the same moment.
    ///
    /// ```text
    ///       ....          the arc ends at P with the motion's direction;      ....|o         the pipe ends at P, across the motion
    ///   .solid..`.        the floor goes on behind P, and so does the         wall|V       .
    ///   ..........P<--- o solid above it                                      ....P    . `
    ///   .......solid.....                                                     ......solid..
    /// ```
    #[inline(never)]
    pub(super) fn meet_cusp<W: World>(&mut self, world: &W, d: Raw, first: &mut First) {
        let bounds = self.body.bounds();
        let (lo, hi) = (bounds.lo(), bounds.hi());
        let front = Raw { x: if d.x > 0 { hi.x } else { lo.x }, y: if d.y > 0 { hi.y } else { lo.y } };
        let step = Raw { x: d.x.signum(), y: d.y.signum() };
        let mut features = world.features(&hull(&bounds, Raw::ZERO, d, 1));
        while let Some(feature) = &features.next() {
            self.features += 1;
            let Geometry::Arc { centre, radius, quadrant, convex } = feature.geometry else { continue };
            let (x, y) = if convex == (d.x == 0) { (quadrant.x, 0) } else { (0, quadrant.y) };
            let end = Raw::of(centre).add(Raw { x: x.wrapping_mul(radius), y: y.wrapping_mul(radius) });
            let q = end.sub(front);
            if q.cross(d) != 0 || q.dot(d) < 0 || way(q) >= way(d) || first.is_within(way(q), way(d)) {
                continue;
            }
            if B::is_inside(world, end.add(step)) {
                let normal = Axis::new(step.x.wrapping_neg(), step.y.wrapping_neg());
                let entry = Entry { num: way(q), den: way(d), normal, at_end: true, step: Some(q) };
                first.only(&entry, feature);
            }
        }
    }

    /// Whether the motion is along x or y and the body has no extent across it.
    pub(super) fn may_meet_cusp(&self, d: Raw) -> bool {
        let bounds = self.body.bounds();
        (d.x == 0 && bounds.lo().x == bounds.hi().x) || (d.y == 0 && bounds.lo().y == bounds.hi().y)
    }
}
