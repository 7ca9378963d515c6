//! The surface of a segment map, returned by a cursor; a segment map as a level. Also which ends of
//! segments block by themselves.

use super::{Kind, Refs, Seg, SegmentMap};
use crate::num::{Axis, Raw};
use crate::query::meet;
use crate::shape::{Aabb, Circle};
use crate::world::cell::{Cell, Range};
use crate::world::convex::ConvexBody;
use crate::world::level::{Feature, Geometry, World, sealed};
use crate::world::probes::Probe;

impl SegmentMap<'_> {
    /// The faces of the segments that may have a point in the closed region.
    ///
    /// Each is followed by the vertex at its end, if that is in the region. Each comes once, in the
    /// order of the region's cells, row after row, and within a cell by index. Faces near the
    /// region may be included. The boundary of a polygon is one face per segment. A wall has one on
    /// each side, a one-way segment one on its outward normal's side. A feature's cell is the one
    /// that holds its start, or its corner.
    ///
    /// Cost: up to three tests for each reference of the cells of the region. For each end without
    /// a vertex, also the segments of a cell.
    ///
    /// ```
    /// use tilesat::{Aabb, Path, PathKind, Vec2, fx, segment_map, world::Geometry};
    /// const HILL: [Vec2; 3] = [Vec2::from_ints(0, 64), Vec2::from_ints(64, 0), Vec2::from_ints(128, 64)];
    /// segment_map!(static LEVEL: [Path::new(PathKind::Solid, &HILL)], fx!(32));
    /// // Around the top there are both slopes, and the corner between them.
    /// let region = Aabb::new(Vec2::from_ints(60, 0), Vec2::from_ints(68, 8)).unwrap();
    /// let corners = LEVEL.features(&region).filter(|f| matches!(f.geometry, Geometry::Vertex { .. }));
    /// assert_eq!((LEVEL.features(&region).count(), corners.count()), (3, 1));
    /// ```
    pub const fn features(&self, region: &Aabb) -> SegmentFeatures<'_> {
        let (lo, hi) = (region.lo(), region.hi());
        let range = self.cells(lo, hi);
        let refs =
            if range.y0 <= range.y1 && range.x0 <= range.x1 { self.refs(range.x0, range.y0) } else { Refs::NONE };
        SegmentFeatures { map: *self, lo, hi, range, x: range.x0, y: range.y0, refs, vertex: None }
    }

    /// The cell of a feature by its index.
    pub(super) const fn home(&self, index: u16) -> Cell {
        let seg = self.segment(index >> 1);
        self.holder(if index & 1 == 0 { seg.a } else { seg.b() })
    }

    /// The cell that holds a point of the closed grid.
    const fn holder(&self, p: Raw) -> Cell {
        let cell = self.cells(p, p);
        Cell::of(cell.x0, cell.y0)
    }
}

/// The cursor of [`SegmentMap::features`].
#[derive(Clone, Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct SegmentFeatures<'w> {
    pub(crate) map: SegmentMap<'w>,
    lo: Raw,
    hi: Raw,
    range: Range,
    /// The cell and the rest of it.
    x: i32,
    y: i32,
    refs: Refs<'w>,
    /// The vertex at the end of the last face.
    vertex: Option<Feature>,
}

impl Iterator for SegmentFeatures<'_> {
    type Item = Feature;

    fn next(&mut self) -> Option<Feature> {
        if let Some(vertex) = self.vertex.take() {
            return Some(vertex);
        }
        loop {
            while let Some(index) = self.refs.advance() {
                let seg = self.map.segment(index);
                let b = seg.b();
                let (lo, hi) = meet::corners(seg.a, b);
                if meet::aabb_aabb::<true>(lo, hi, self.lo, self.hi) && self.is_first(seg.a, b) {
                    return Some(self.serve(&seg, b, index));
                }
            }
            if !self.advance() {
                return None;
            }
        }
    }
}

impl SegmentFeatures<'_> {
    /// Goes to the next cell. False at the end.
    fn advance(&mut self) -> bool {
        if self.x < self.range.x1 {
            self.x = self.x.wrapping_add(1);
        } else if self.y < self.range.y1 {
            (self.x, self.y) = (self.range.x0, self.y.wrapping_add(1));
        } else {
            return false;
        }
        self.refs = self.map.refs(self.x, self.y);
        true
    }

    /// Whether the segment has been in no cell of the range before this one, which it meets.
    ///
    /// Its part in the range's part of a row is one piece, and so is its part in the columns of the
    /// range. If it was in an earlier row, it was in the last one. If it was in an earlier cell of
    /// this row, it was in the last one.
    fn is_first(&self, a: Raw, b: Raw) -> bool {
        let (x, y, range) = (self.x, self.y, &self.range);
        let meets = |x0: i32, x1: i32, y: i32| {
            let ((lo, _), (_, hi)) = (self.map.grid.corners(x0, y), self.map.grid.corners(x1, y));
            meet::segment_aabb::<true>(a, b, lo, hi)
        };
        let (before, above) = (x.wrapping_sub(1), y.wrapping_sub(1));
        !(x > range.x0 && meets(before, before, y) || y > range.y0 && meets(range.x0, range.x1, above))
    }

    fn serve(&mut self, seg: &Seg, b: Raw, index: u16) -> Feature {
        let twice = index.wrapping_mul(2);
        self.vertex = match seg.next {
            Some(next) if meet::aabb_aabb::<true>(b, b, self.lo, self.hi) => {
                let e_out = self.map.segment(next).dir;
                let geometry = Geometry::Vertex { p: b.vec2(), e_in: seg.dir, e_out };
                Some(seg.feature(geometry, self.map.holder(b), twice.wrapping_add(1)))
            }
            _ => None,
        };
        let joined = [
            seg.start_joined && (seg.kind == Kind::OneWay || self.map.end_blocks(seg.a, seg.dir, false)),
            seg.end_joined && (seg.kind == Kind::OneWay || self.map.end_blocks(b, seg.dir.reversed(), true)),
        ];
        seg.feature(seg.face(joined), self.map.holder(seg.a), twice)
    }
}

impl Seg {
    pub(super) const fn face(&self, joined: [bool; 2]) -> Geometry {
        Geometry::Face { a: self.a.vec2(), dir: self.dir, len: self.len, joined }
    }

    pub(super) fn feature(&self, geometry: Geometry, cell: Cell, index: u16) -> Feature {
        Feature { geometry, cell, index, flags: self.flags, one_way: self.kind == Kind::OneWay, source: 0 }
    }
}

impl sealed::Sealed for SegmentMap<'_> {}

impl World for SegmentMap<'_> {
    const BLOCKS: bool = false;

    #[doc(hidden)]
    const ARCS: bool = false;
    const ROUND: bool = false;
    const WIDE: bool = true;

    type Features<'w>
        = SegmentFeatures<'w>
    where
        Self: 'w;

    fn features(&self, region: &Aabb) -> SegmentFeatures<'_> {
        SegmentMap::features(self, region)
    }

    fn cell_size(&self) -> u32 {
        self.grid.cell as u32
    }

    fn most_cells(&self, width: u32, height: u32) -> u32 {
        self.grid.most_cells(width, height)
    }

    fn overlaps_aabb(&self, b: &Aabb) -> bool {
        SegmentMap::overlaps(self, b)
    }

    fn meets_convex(&self, body: &ConvexBody<'_>, closed: bool) -> bool {
        if closed { self.convex_meets::<true>(body) } else { self.convex_meets::<false>(body) }
    }

    fn overlaps_circle(&self, c: &Circle) -> bool {
        SegmentMap::overlaps(self, c)
    }

    fn touches_aabb(&self, b: &Aabb) -> bool {
        SegmentMap::touches(self, b)
    }

    fn touches_circle(&self, c: &Circle) -> bool {
        SegmentMap::touches(self, c)
    }

    fn flags_touched<P: Probe>(&self, shape: &P) -> u8 {
        SegmentMap::flags_touched(self, shape)
    }
}

/// A direction from a point in which segments run, less than half a turn from another one.
#[derive(Clone, Copy)]
struct Branch {
    dir: Axis,
    /// Whether the part after it, in the direction of the turn, is solid by one of them.
    after: bool,
    /// Whether the part before it is.
    before: bool,
}

impl SegmentMap<'_> {
    /// Whether the solid continues from the end `p` of a face, where `p` itself then blocks the
    /// front. `along` leads from `p` along the face, and `left` says on which side of that the
    /// front is.
    ///
    /// It does if the surface continues straight, or turns toward the front and is solid up to
    /// beyond `p`. It does, too, in the nook of two walls, if that contains the quadrant of the box
    /// whose corner meets the front. It does not if the face meets a wall or a spike from below, or
    /// the surface of a solid that contains it. A body above then reaches `p`.
    ///
    /// ```text
    ///      |####        ####|####         box                 f: the face, its front is on the right
    ///      |####        ####|####        -----P========  wall
    ///      P----- yes   ----P----  no         |          or spike: no
    ///      f                f                 f
    /// ```
    ///
    /// Cost: the segments of a cell, three products for each one through `p`.
    pub(super) fn end_blocks(&self, p: Raw, along: Axis, left: bool) -> bool {
        let turn = |from: Axis, to: Axis| if left { from.perp_dot(to) } else { to.perp_dot(from) };
        let (mut last, mut straight): (Option<Branch>, bool) = (None, false);
        for seg in self.around(p) {
            if seg.kind == Kind::OneWay || !seg.holds(p) {
                continue;
            }
            for (there, dir, leaves) in [(seg.b() != p, seg.dir, true), (seg.a != p, seg.dir.reversed(), false)] {
                // The solid is on the left of a leaving segment, so it comes after it in the left
                // turn.
                let ray = Branch { dir, after: leaves == left, before: leaves != left };
                let ahead = turn(along, dir);
                if there && ahead > 0 {
                    last = Some(match last {
                        Some(last) if last.dir == dir => {
                            Branch { dir, after: last.after || ray.after, before: last.before || ray.before }
                        }
                        Some(last) if turn(last.dir, dir) < 0 => last,
                        _ => ray,
                    });
                }
                straight |= there && ahead == 0 && dir != along && ray.after;
            }
        }
        // The corner of a box that meets the front is in the quadrant of `p` into which the front
        // faces.
        let front = if left { along.perp() } else { along.perp().reversed() };
        let in_nook = |last: Axis| {
            let is_before = |side: Axis| !side.is_zero() && turn(last, side) <= 0;
            is_before(Axis::new(front.x.signum(), 0)) && is_before(Axis::new(0, front.y.signum()))
        };
        straight || last.is_some_and(|last| last.after && (!last.before || in_nook(last.dir)))
    }
}
