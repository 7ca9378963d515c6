//! Where a point stops that no feature opposes.

use super::around::hull;
use super::body::{Body, Entry};
use super::plane::way;
use super::run::Run;
use crate::num::{Axis, Raw};
use crate::world::{Feature, Geometry, World};

impl<B: Body> Run<'_, B> {
    /// Makes a motion that meets nothing; where the solid refuses it all the same, what it did meet.
    ///
    /// Among blocks its end is certain: the sweeps are exact, so what starts outside of the solid and hits nothing ends outside of it.
    pub(super) fn arrive<W: World>(&mut self, world: &W, d: Raw) -> Option<(Entry, Feature)> {
        if self.place(world, d, W::CERTAIN, &[d]).is_zero() && W::ROUND { self.cusp(world, d) } else { None }
    }

    /// Where a point runs into the cusp between a convex arc and the surface that it touches. Both are tangent to the motion, and behind the end
    /// of the arc there is no face.
    ///
    /// ```text
    ///       ....          the arc ends at P with the motion's direction; the floor goes on behind P, and so does the solid above it
    ///   .solid..`.
    ///   ..........P<--- o
    ///   .......solid.....
    /// ```
    #[inline(never)]
    fn cusp<W: World>(&self, world: &W, d: Raw) -> Option<(Entry, Feature)> {
        if d.x != 0 && d.y != 0 {
            return None;
        }
        let normal = Axis::new(d.x.signum().wrapping_neg(), d.y.signum().wrapping_neg());
        let mut first: Option<(Entry, Feature)> = None;
        for feature in world.features(&hull(&self.moved.body.bounds(), Raw::ZERO, d, 1)) {
            let Geometry::Arc { centre, radius, quadrant, convex: true } = feature.geometry else { continue };
            let (at, r) = self.moved.body.toward(quadrant.reversed());
            let (x, y) = if d.x == 0 { (quadrant.x, 0) } else { (0, quadrant.y) };
            let end = Raw { x: x.wrapping_mul(radius), y: y.wrapping_mul(radius) };
            let q = Raw::of(centre).add(end).sub(at);
            if r != 0 || q.cross(d) != 0 || q.dot(d) < 0 || way(q) > way(d) {
                continue;
            }
            if first.is_none_or(|(entry, _)| way(q) < entry.num) {
                let entry = Entry { num: way(q), den: way(d), normal, at_end: true, step: Some(q) };
                first = Some((entry, feature));
            }
        }
        first
    }
}
