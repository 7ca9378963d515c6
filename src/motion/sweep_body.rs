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
                let (corner, _) = self.toward(Axis::new(dir.y.wrapping_neg(), dir.x));
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

/// Entry of a side of the box, grown by `r`, that lands on a point of the surface with a normal
/// parallel to x or y. None if the normal is zero.
#[inline(never)]
pub(super) fn sweep_end(core: (Raw, Raw), r: i32, d: Raw, p: Raw, normal: Axis) -> Option<Entry> {
    if normal.is_zero() {
        return None;
    }
    let dir = Axis::new(normal.y.wrapping_neg(), normal.x);
    sweep_face(core, r, d, &Face { a: p, dir, len: 0, joined: [false; 2] })
}

/// Entry through a convex arc. Either the corner of the box nearest to the arc's centre enters the
/// arc itself, or a side lands on an end with a normal along x or y. The same side also meets a
/// flat face that continues from there.
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

#[cfg(test)]
#[allow(clippy::expect_used, clippy::indexing_slicing, clippy::panic, reason = "a test")]
mod tests {
    extern crate std;

    use super::super::body::kernel::Kernel;
    use crate::num::{Axis, Raw, Vec2};
    use crate::shape::Aabb;
    use crate::world::{Cell, Feature, Geometry};
    use std::{format, vec, vec::Vec};

    type Point = (i32, i32);

    /// Triangles, trapezoids and a diamond, on a lattice of four, turning from x toward y.
    const SOLIDS: [&[Point]; 8] = [
        &[(0, 4), (4, 0), (4, 4)],
        &[(0, 0), (4, 4), (0, 4)],
        &[(0, 0), (4, 0), (0, 4)],
        &[(0, 4), (4, 2), (4, 4)],
        &[(0, 2), (4, 0), (4, 4), (0, 4)],
        &[(2, 0), (4, 4), (0, 4)],
        &[(0, 2), (2, 0), (4, 2), (2, 4)],
        &[(1, 0), (3, 1), (2, 3)],
    ];

    fn features(solid: &[Point]) -> impl Iterator<Item = Feature> + '_ {
        let n = solid.len();
        let edge = move |i: usize| {
            let (a, b) = (solid[i % n], solid[(i + 1) % n]);
            let (x, y) = (b.0 - a.0, b.1 - a.1);
            let len = (1..=4).rev().find(|k| x % k == 0 && y % k == 0).unwrap_or(1);
            (Vec2::from_raw(a.0, a.1), Axis::new(x / len, y / len), len)
        };
        let feature =
            |geometry| Feature { geometry, cell: Cell::default(), index: 0, flags: 0, one_way: false, source: 0 };
        (0..n).flat_map(move |i| {
            let ((a, dir, len), (p, e_out, _)) = (edge(i), edge(i + 1));
            let face = Geometry::Face { a, dir, len, joined: [false; 2] };
            [feature(face), feature(Geometry::Vertex { p, e_in: dir, e_out })]
        })
    }

    /// When the box starts to overlap, as a fraction. It clips the motion by the half-planes of the
    /// sum of the solid and the mirrored box. The edges of that sum are the solid's and those along
    /// x and y.
    fn oracle(solid: &[Point], lo: Point, size: Point, d: Point) -> Option<(i64, i64)> {
        let n = solid.len();
        let mut normals = vec![(1, 0), (-1, 0), (0, 1), (0, -1)];
        normals.extend((0..n).map(|i| {
            let (a, b) = (solid[i], solid[(i + 1) % n]);
            (b.1 - a.1, a.0 - b.0)
        }));
        let (mut from, mut to) = ((0i64, 1i64), (1i64, 1i64));
        for (x, y) in normals {
            let dot = |p: Point| i64::from(x) * i64::from(p.0) + i64::from(y) * i64::from(p.1);
            let solid = solid.iter().map(|&p| dot(p)).max()?;
            let corner = (if x > 0 { lo.0 } else { lo.0 + size.0 }, if y > 0 { lo.1 } else { lo.1 + size.1 });
            let (at, speed) = (dot(corner) - solid, dot(d));
            // Inside while at + speed t < 0.
            match speed.signum() {
                0 if at >= 0 => return None,
                -1 if at * from.1 > from.0 * -speed => from = (at, -speed),
                1 if -at * to.1 < to.0 * speed => to = (-at, speed),
                _ => {}
            }
        }
        (from.0 * to.1 < to.0 * from.1).then_some(from)
    }

    /// All solids, small boxes (also without width or height), positions and motions: hit or not,
    /// and when, exactly.
    #[test]
    fn box_against_convex_solids() {
        let mut hits = 0u32;
        for solid in SOLIDS {
            let features: Vec<_> = features(solid).collect();
            for (w, h) in [(0, 0), (1, 0), (0, 2), (1, 1), (3, 2), (6, 6)] {
                for (x, y) in (-8..8).flat_map(|x| (-8..8).map(move |y| (x, y))) {
                    if oracle(solid, (x, y), (w, h), (0, 0)).is_some() {
                        continue;
                    }
                    let body =
                        Aabb::new(Vec2::from_raw(x, y), Vec2::from_raw(x + w, y + h)).expect("a box of the lattice");
                    for (dx, dy) in (-7..8).flat_map(|x| (-7..8).map(move |y| (x, y))) {
                        let d = Raw { x: dx, y: dy };
                        let first = features
                            .iter()
                            .filter_map(|f| body.sweep(d, f))
                            .reduce(|a, b| if b.before(&a, d) { b } else { a });
                        let expected = oracle(solid, (x, y), (w, h), (dx, dy));
                        let case = || format!("{solid:?} {:?} by {:?}", (x, y, w, h), (dx, dy));
                        match (first, expected) {
                            (None, None) => {}
                            (Some(entry), Some((num, den))) => {
                                hits += 1;
                                let (n, d) = (i64::from(entry.num), i64::from(entry.den));
                                assert_eq!(n * den, num * d, "{}", case());
                            }
                            // See `sweep_slope`: a body without area at an acute corner.
                            (Some(entry), None) if entry.at_end && w * h == 0 => {}
                            (found, wanted) => panic!("{found:?}, not {wanted:?}: {}", case()),
                        }
                    }
                }
            }
        }
        assert!(hits > 100_000);
    }
}
