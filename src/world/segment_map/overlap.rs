//! Overlap with what is solid in a segment map (strict) and touch (closed).

use super::{Kind, Seg, SegmentMap};
use crate::num::Raw;
use crate::query::{Overlaps, Touches, meet};
use crate::shape::{Aabb, Circle};
use crate::world::Probe;
use crate::world::shells::levels;
use crate::world::tile_map::range::Range;

levels! {
    [] SegmentMap<'_> {
        /// Whether a box or circle overlaps the solid: whether a wall or the boundary of a polygon reaches its inside, or it lies within a polygon.
        ///
        /// Strict and exact: a body that touches a wall or fills a gap exactly does not overlap. A wall has no thickness, and is overlapped by
        /// what it crosses; a body without area (a circle of radius 0, a box of no width or height) overlaps only what has area. One-way
        /// segments are never overlapped. Outside of the grid nothing is solid.
        ///
        /// Cost: the segments of the cells under the body, one test each in each cell, until the first hit; one winding number. It cannot fail.
        ///
        /// ```
        /// use tilesat::{Circle, Fx, Path, PathKind, Vec2, segment_map};
        /// const HILL: [Vec2; 3] = [Vec2::from_ints(0, 64), Vec2::from_ints(64, 0), Vec2::from_ints(128, 64)];
        /// const DOOR: [Vec2; 2] = [Vec2::from_ints(128, 64), Vec2::from_ints(128, 0)];
        /// segment_map!(static LEVEL: [Path::new(PathKind::Solid, &HILL), Path::new(PathKind::Wall, &DOOR)], Fx::lit("32"));
        /// let ball = |x, y, r| Circle::new(Vec2::from_ints(x, y), Fx::from_num(r)).unwrap();
        /// assert!(LEVEL.overlaps(&ball(64, 40, 2))); // deep in the hill
        /// assert!(LEVEL.touches(&ball(120, 10, 8)) && !LEVEL.overlaps(&ball(120, 10, 8))); // at the door
        /// assert!(LEVEL.overlaps(&ball(120, 10, 9)) && LEVEL.overlaps(&ball(136, 10, 9))); // from both sides
        /// ```
        overlaps,
        /// Whether a box or circle has a point in common with the solid or a wall, borders included.
        ///
        /// Exact. One-way segments are not solid. Cost: as [`overlaps`](Self::overlaps).
        touches,
    }
}

impl SegmentMap<'_> {
    /// The flags, joined by or, of all segments that a box, circle or point has a point in common with: boundaries, walls and one-way
    /// segments, ends included.
    ///
    /// The flags are those of the lines: a body inside a polygon that touches none of its edges has none. Exact. Cost: one test for each
    /// segment with other flags, of each cell under the shape.
    #[must_use]
    pub fn flags_touched<B: Probe>(&self, shape: &B) -> u8 {
        let (lo, hi) = shape.bounds();
        let mut flags = 0;
        self.any(self.cells(lo, hi), |seg| {
            if seg.flags & !flags != 0 && shape.meets(seg.a, seg.b()) {
                flags |= seg.flags;
            }
            false
        });
        flags
    }

    /// Whether something is true of a segment of a range of cells; it is asked once in each cell.
    fn any(&self, range: Range, mut test: impl FnMut(&Seg) -> bool) -> bool {
        let mut y = range.y0;
        while y <= range.y1 {
            let mut x = range.x0;
            while x <= range.x1 {
                for index in self.refs(x, y) {
                    if test(&self.segment(index)) {
                        return true;
                    }
                }
                x = x.wrapping_add(1);
            }
            y = y.wrapping_add(1);
        }
        false
    }

    /// Whether a body meets a segment that blocks from both sides, or a point of it that is on no such segment is in a polygon.
    fn meets(&self, range: Range, inner: Raw, test: impl Fn(Raw, Raw) -> bool) -> bool {
        self.any(range, |seg| seg.kind != Kind::OneWay && test(seg.a, seg.b())) || self.winding_beside(inner) > 0
    }
}

impl Overlaps<Aabb> for SegmentMap<'_> {
    fn overlaps(&self, b: &Aabb) -> bool {
        let (lo, hi) = (b.lo(), b.hi());
        if lo.x == hi.x || lo.y == hi.y {
            return self.thin_overlaps(lo, hi);
        }
        // Just beside its first corner is inside the box.
        self.meets(self.open_cells(lo, hi), lo, |p, q| meet::segment_aabb::<false>(p, q, lo, hi))
    }
}

impl Overlaps<Circle> for SegmentMap<'_> {
    fn overlaps(&self, b: &Circle) -> bool {
        let (c, r, bounds) = (b.c(), b.r(), b.aabb());
        if r == 0 {
            return self.point_inside(c);
        }
        self.meets(self.open_cells(bounds.lo(), bounds.hi()), c, |p, q| meet::circle_segment::<false>(c, r, p, q))
    }
}

impl Touches<Aabb> for SegmentMap<'_> {
    fn touches(&self, b: &Aabb) -> bool {
        let (lo, hi) = (b.lo(), b.hi());
        self.meets(self.cells(lo, hi), lo, |p, q| meet::segment_aabb::<true>(p, q, lo, hi))
    }
}

impl Touches<Circle> for SegmentMap<'_> {
    fn touches(&self, b: &Circle) -> bool {
        let (c, r, bounds) = (b.c(), b.r(), b.aabb());
        self.meets(self.cells(bounds.lo(), bounds.hi()), c, |p, q| meet::circle_segment::<true>(c, r, p, q))
    }
}
