//! The faces and vertices of a segment map, served by a cursor.

use super::{Kind, Refs, Seg, SegmentMap};
use crate::num::Raw;
use crate::query::meet;
use crate::shape::Aabb;
use crate::world::tile_map::range::Range;
use crate::world::{Cell, Feature, Geometry};

impl SegmentMap<'_> {
    /// The segments that may have a point in the closed region as faces, each followed by the vertex at its end, if that is in the region.
    ///
    /// Each comes once. They come in the order of the region's cells, row after row, and within a cell by index; faces near the region
    /// may come too. The boundary of a polygon is one face a segment, a wall has one on each side, a one-way segment one on its
    /// outward normal's side. A feature's cell is the one that holds its start, or its corner.
    ///
    /// Cost: the references of the cells of the region, up to three tests each; for each end without a vertex, the segments of its cell.
    ///
    /// ```
    /// use tilesat::{Aabb, Fx, Geometry, Path, PathKind, Vec2, segment_map};
    /// const HILL: [Vec2; 3] = [Vec2::from_ints(0, 64), Vec2::from_ints(64, 0), Vec2::from_ints(128, 64)];
    /// segment_map!(static LEVEL: [Path::new(PathKind::Solid, &HILL)], Fx::lit("32"));
    /// // Around the top: both slopes, and the corner between them.
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
    /// The cell and what is left of it.
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
    /// Goes to the next cell; false where there is none.
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
    /// What it has in common with the range's part of a row is one piece, and so is what it has in common with the columns of the range:
    /// if it was in an earlier row it was in the last one, if in an earlier cell of this row it was in the last one.
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
