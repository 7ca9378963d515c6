//! Rays against a segment map.

use super::overlap::Spoke;
use super::{Kind, Refs, Seg, SegmentMap};
use crate::num::Raw;
use crate::world::cell::Cell;
use crate::world::grid::Grid;
use crate::world::level::Feature;
use crate::world::ray::scan::{RayLevel, Scan, ScanHit};
use crate::world::ray::walk::{Beyond, RayWalk};
use crate::world::ray::world::{RayScan, RayWorld, rays};
use crate::world::ray::{RayHit, RayPieces, RayRules};

impl SegmentMap<'_> {
    /// Whether a ray is strictly inside the solid just after its start: on both of its sides.
    fn goes_in(&self, o: Raw, d: Raw) -> bool {
        let (start, ahead) = (self.winding_beside(o), Spoke { dir: d, change: 0 });
        let sum =
            |test: &dyn Fn(&Spoke) -> bool| self.spokes(o).filter(test).fold(start, |w, r| w.wrapping_add(r.change));
        sum(&|r| r.up_to(&ahead)) > 0 && sum(&|r| !ahead.up_to(r)) > 0
    }
}

rays! {
    ['a] SegmentMap<'a> {
        /// The first point of a boundary or wall that a ray from `origin` along `motion` meets, or
        /// `None` if it ends before.
        ///
        /// Every decision is exact, by the rules of
        /// [`TileMap::cast_ray`](crate::TileMap::cast_ray). A start on a wall has no side: a ray
        /// that leaves the line in any direction hits the wall at 0. A start inside has no flags
        /// and no index.
        ///
        /// Cost: one test for each segment in each cell that the ray passes. A rejected segment
        /// needs no division.
        ///
        /// ```
        /// use tilesat::{Axis, Inside, Path, PathKind, Vec2, fx, segment_map};
        /// const HILL: [Vec2; 3] = [Vec2::from_ints(0, 64), Vec2::from_ints(64, 0), Vec2::from_ints(128, 64)];
        /// segment_map!(static LEVEL: [Path::new(PathKind::Solid, &HILL)], fx!(32));
        /// let hit = LEVEL.cast_ray(Vec2::from_ints(0, 16), Vec2::from_ints(64, 0), Inside::Ignore)?.unwrap();
        /// assert_eq!((hit.point, hit.axis), (Vec2::from_ints(48, 16), Axis::new(-1, -1)));
        /// # Ok::<(), tilesat::RangeError>(())
        /// ```
        ///
        /// # Errors
        /// [`RangeError`](crate::RangeError) if the start or the end is outside the
        /// [domain](crate::num::DOMAIN).
        cast_ray,
        /// Whether the straight line from `a` to `b` meets no boundary and no wall and does not
        /// start inside.
        ///
        /// A line that ends on a surface is blocked; one that starts there is not.
        ///
        /// ```
        /// use tilesat::{Path, PathKind, Vec2, fx, segment_map};
        /// const HILL: [Vec2; 3] = [Vec2::from_ints(0, 64), Vec2::from_ints(64, 16), Vec2::from_ints(128, 64)];
        /// segment_map!(static LEVEL: [Path::new(PathKind::Solid, &HILL)], fx!(32));
        /// let sees = |y| LEVEL.line_of_sight(Vec2::from_ints(10, y), Vec2::from_ints(118, y));
        /// assert!(sees(15)? && !sees(17)?);
        /// # Ok::<(), tilesat::RangeError>(())
        /// ```
        ///
        /// # Errors
        /// [`RangeError`](crate::RangeError) if a point is outside the
        /// [domain](crate::num::DOMAIN).
        line_of_sight,
        /// All hits of a ray in order, as if it continued through what it hits.
        ///
        /// Hits at the same moment count as one.
        ///
        /// Cost: as [`cast_ray`](Self::cast_ray), and the step's segments once more for each hit.
        ///
        /// # Errors
        /// As [`cast_ray`](Self::cast_ray).
        cast_ray_all -> SegmentRayHits<'_, 'a>,
    }
}

/// The hits of a ray in order; see [`SegmentMap::cast_ray_all`].
#[derive(Clone, Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct SegmentRayHits<'w, 'a> {
    scan: Scan<'w, SegmentMap<'a>>,
    pub(crate) map: &'w SegmentMap<'a>,
}

impl Iterator for SegmentRayHits<'_, '_> {
    type Item = RayHit;

    fn next(&mut self) -> Option<RayHit> {
        self.find().map(|found| found.hit)
    }
}

impl SegmentRayHits<'_, '_> {
    pub(in crate::world) fn find(&mut self) -> Option<ScanHit> {
        let mut found = self.scan.find()?;
        if found.met.is_some() {
            found.hit.cell = self.map.home(found.hit.index);
        }
        Some(found)
    }
}

impl RayPieces for SegmentMap<'_> {
    const WIDE: bool = true;
    const ROUND: bool = false;
}

impl RayLevel for SegmentMap<'_> {
    type Pieces<'w>
        = CellFaces<'w>
    where
        Self: 'w;

    fn grid(&self) -> &Grid {
        &self.grid
    }

    fn beyond(&self) -> Beyond {
        Beyond::Nothing
    }

    fn pieces(&self, x: i32, y: i32, _: Raw) -> Option<CellFaces<'_>> {
        Some(CellFaces { map: self, refs: self.refs(x, y), cell: Cell::of(x, y) })
    }

    fn holds_start(&self, o: Raw, _: &RayWalk) -> bool {
        self.point_inside(o)
    }

    /// Walls have no inside, but stop rays that cross them.
    fn enters(&self, o: Raw, d: Raw, _: &RayWalk) -> bool {
        let crosses =
            |seg: &Seg| seg.kind == Kind::Wall && seg.holds(o) && Raw { x: seg.dir.x, y: seg.dir.y }.cross(d) != 0;
        self.around(o).any(|seg| crosses(&seg)) || self.goes_in(o, d)
    }

    fn flags(&self, _: i32, _: i32) -> u8 {
        0
    }
}

/// The faces of the segments of a cell, as far as rays need them: they belong to that cell, and no
/// end is joined.
#[derive(Clone, Debug)]
pub(in crate::world) struct CellFaces<'w> {
    map: &'w SegmentMap<'w>,
    refs: Refs<'w>,
    cell: Cell,
}

impl Iterator for CellFaces<'_> {
    type Item = Feature;

    fn next(&mut self) -> Option<Feature> {
        let index = self.refs.next()?;
        let seg = self.map.segment(index);
        Some(seg.feature(seg.face([false; 2]), self.cell, index.wrapping_mul(2)))
    }
}

impl<'a> RayWorld for SegmentMap<'a> {
    type Scan<'w>
        = SegmentRayHits<'w, 'a>
    where
        Self: 'w;

    #[inline]
    fn scan(&self, o: Raw, d: Raw, rules: RayRules) -> Self::Scan<'_> {
        SegmentRayHits { scan: Scan::of(self, o, d, rules), map: self }
    }
}

impl RayScan for SegmentRayHits<'_, '_> {
    fn next_found(&mut self) -> Option<ScanHit> {
        SegmentRayHits::find(self)
    }

    fn goes_in(&self) -> bool {
        self.scan.goes_in()
    }
}
