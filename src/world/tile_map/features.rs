//! The surface of a level, derived from its tiles on request.

use super::surface::{CellQuery, CellSurface, TileSource};
use super::{ShapeSet, Store, TileMap};
use crate::num::Raw;
use crate::shape::Aabb;
use crate::world::cell::{Block, Cells, Range};
use crate::world::level::{Feature, MotionPiece, World};
use crate::world::tile_map::kind::{TileKind, TileShape};

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// The faces, arcs and vertices of the surface that have a point in the closed region, row
    /// after row.
    ///
    /// - A face is a slope, the inner side of a half tile, or a side of a tile's solid. Of a side,
    ///   only the halves count that the tile across does not cover.
    /// - An arc is that of a round tile.
    /// - A vertex is a point around which the solid is a wedge of less than half a turn. Tiles that
    ///   continue each other count as one solid. There is none on a flat line, where an arc leaves
    ///   a line smoothly, or in a concave corner. Two wedges that meet in one point have one vertex
    ///   each. The edge of an arc is its tangent. The thin end of a quarter pipe is a wedge of no
    ///   angle, with `e_out == -e_in`.
    /// - A one-way tile has only its edge, less the part that the tile before it covers.
    ///
    /// [`Outside`](crate::world::Outside) counts: in a closed room the solid cells around the map
    /// have faces inward. If the border is repeated, faces reach to the end of the domain. With
    /// [`Blocks`](crate::world::Blocks) alone they belong to the border's cells, else to separate
    /// cells beyond it.
    ///
    /// ```text
    ///   7          4                                    0..=3 sides, 4..=7 the vertices where they
    ///    +---0-->-+                       __-> 9        end; 8 slope or arc, 9 the vertex where it
    ///    ^  full  |                   _8--    | 1       ends: a Feature's index
    ///    3        1         +---->--+---------+
    ///    |        v         ^  full | full    v         between the three tiles there are no faces,
    ///    +-<--2---+         |       |         |         and no vertices where the slope begins and
    ///   6          5        +---<---+-----<---+         on the line on the right
    /// ```
    ///
    /// Cost: each cell of the region once. A full one adds its 4 neighbours, and a shaped one 8, if
    /// its sides or slope are in the region. On a Cortex-M0 a block with one face takes about 200
    /// instructions, or about 600 among shaped tiles. It cannot fail.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, TileKind, TileKinds, TileMap, Vec2, world::Geometry};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let map = TileMap::from_ascii("...\n###", &KINDS)?;
    /// // On top of the floor, near the seam between its first two tiles: two flat faces, no corner.
    /// let region = Aabb::new(Vec2::from_ints(10, 10), Vec2::from_ints(20, 20)).unwrap();
    /// let faces: Vec<_> = map.features(&region).map(|f| f.geometry).collect();
    /// let len = 16 << 16;
    /// assert_eq!(faces, [
    ///     Geometry::Face { a: Vec2::from_ints(0, 16), dir: Axis::X, len, joined: [false, true] },
    ///     Geometry::Face { a: Vec2::from_ints(16, 16), dir: Axis::X, len, joined: [true, true] },
    /// ]);
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    ///
    /// A floor, half a cell high, that continues into a slope of one cell in two, which ends at a
    /// ledge:
    ///
    /// ```
    /// use tilesat::{AllShapes, Axis, Fx, Grid, TileKind, TileKinds, TileMap, TileShape, Vec2, world::Geometry};
    /// static KINDS: TileKinds = TileKinds::EMPTY
    ///     .with(b'_', TileKind::of(TileShape::HalfBottom))
    ///     .with(b'/', TileKind::of(TileShape::MildHighBottomRight));
    /// let map = TileMap::<AllShapes>::of(b"_/", Grid::new(2, 1, Fx::from_num(16), Vec2::ZERO)?, &KINDS)?;
    /// let all = tilesat::Aabb::new(Vec2::ZERO, Vec2::from_ints(32, 15)).unwrap();
    /// let top: Vec<_> = map.features(&all).filter(|f| f.index >= 8).map(|f| f.geometry).collect();
    /// let (len, e_in) = (8 << 16, Axis::new(2, -1));
    /// assert_eq!(top, [
    ///     Geometry::Face { a: Vec2::from_ints(0, 8), dir: Axis::X, len: 2 * len, joined: [false, true] },
    ///     Geometry::Face { a: Vec2::from_ints(16, 8), dir: e_in, len, joined: [true, false] },
    ///     Geometry::Vertex { p: Vec2::from_ints(32, 0), e_in, e_out: Axis::Y },
    /// ]);
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    pub const fn features(&self, region: &Aabb) -> Features<'_, S, T> {
        self.features_for(&CellQuery::all(region))
    }

    /// The features of a query.
    #[inline(never)]
    pub(super) const fn features_for(&self, look: &CellQuery) -> Features<'_, S, T> {
        let ((lo, hi), one) = (look.region, Raw { x: 1, y: 1 });
        let cells = Cells::of(self.solid_range_of(lo.sub(one), hi.add(one)));
        Features { map: self, look: *look, cells, seen: Range::NONE, surface: S::CellSurface::NONE }
    }

    /// A cursor for the features of a query, at no cell yet.
    #[inline]
    pub(super) const fn features_of(&self, look: &CellQuery) -> Features<'_, S, T> {
        Features { map: self, look: *look, cells: Cells::NONE, seen: Range::NONE, surface: S::CellSurface::NONE }
    }

    /// Those of the features that a motion could run into, of the cells that a piece of it reaches
    /// and the piece before did not.
    ///
    /// A body whose inside enters a solid meets its border in a cell that its inside enters.
    pub(in crate::world) const fn features_ahead(&self, way: &MotionPiece) -> Features<'_, S, T> {
        let cells = match way.cells {
            Some(cells) => cells,
            None => self.cells(way.piece),
        };
        let seen = match way.before {
            Some(before) => self.cells(before).range,
            None => Range::NONE,
        };
        Features { map: self, look: CellQuery::ahead(way), cells, seen, surface: S::CellSurface::NONE }
    }
}

/// The cursor of [`TileMap::features`]: holds no features, derives the next one from the tiles.
#[derive(Clone, Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct Features<'w, S: ShapeSet, T: Store> {
    pub(crate) map: &'w TileMap<'w, S, T>,
    look: CellQuery,
    cells: Cells,
    /// Cells that are passed over.
    seen: Range,
    /// The features of the current cell.
    surface: S::CellSurface,
}

impl<S: ShapeSet, T: Store> Iterator for Features<'_, S, T> {
    type Item = Feature;

    fn next(&mut self) -> Option<Feature> {
        loop {
            if let Some(feature) = self.next_here() {
                return Some(feature);
            }
            let block = &self.map.next_cell(&mut self.cells)?;
            if !self.seen.holds(block.x, block.y) {
                self.surface.load(self.map, block, &self.look);
            }
        }
    }
}

impl<S: ShapeSet, T: Store> Features<'_, S, T> {
    /// Goes to the features of a cell; the cell before is over.
    pub(super) fn enter(&mut self, block: &Block) {
        self.surface.load(self.map, block, &self.look);
    }

    /// The next feature of the current cell.
    /// [`next`](Self::next) for a query without a motion. The compiler sees that there is none, and
    /// leaves out 250 bytes.
    #[inline]
    pub(super) fn next_near(&mut self) -> Option<Feature> {
        loop {
            let look = CellQuery { d: Raw { x: 0, y: 0 }, ..self.look };
            while !self.surface.is_over() {
                if let Some(feature) = self.surface.take(self.map, &look) {
                    return Some(feature);
                }
            }
            let block = &self.map.next_cell(&mut self.cells)?;
            self.surface.load(self.map, block, &look);
        }
    }

    #[inline]
    pub(super) fn next_here(&mut self) -> Option<Feature> {
        while !self.surface.is_over() {
            if let Some(feature) = self.surface.take(self.map, &self.look) {
                return Some(feature);
            }
        }
        None
    }
}

impl<S: ShapeSet, T: Store> TileSource for TileMap<'_, S, T> {
    #[inline]
    fn kind_at(&self, x: i32, y: i32) -> TileKind {
        TileMap::kind_at(self, x, y)
    }

    #[inline]
    fn full(&self, x: i32, y: i32) -> bool {
        TileMap::full(self, x, y)
    }

    #[inline(never)]
    fn beside(&self, x: i32, y: i32) -> [TileShape; 4] {
        let last = (self.grid.x.count as i32 - 1, self.grid.y.count as i32 - 1);
        if 0 < x && x < last.0 && 0 < y && y < last.1 {
            // All are tiles of the map, at a constant distance in its data.
            let (tile, row) = (self.place(x, y), u32::from(self.stride));
            let tiles = [tile.wrapping_sub(row), tile.wrapping_add(1), tile.wrapping_add(row), tile.wrapping_sub(1)];
            return tiles.map(|tile| self.kinds.get(self.id_at(tile)).shape);
        }
        [(0, -1), (1, 0), (0, 1), (-1, 0)].map(|(dx, dy)| self.kind_at(x.wrapping_add(dx), y.wrapping_add(dy)).shape)
    }

    #[inline]
    fn cell_corners(&self, x: i32, y: i32) -> (Raw, Raw) {
        self.grid.corners(x, y)
    }

    #[inline]
    fn extent(&self, x: i32, y: i32) -> (Raw, Raw) {
        TileMap::extent(self, x, y)
    }

    /// Out of line: only the walk over cells takes a copy, for its speed. A second and a third one
    /// would take 100 bytes.
    #[cfg_attr(target_pointer_width = "64", inline)]
    #[cfg_attr(not(target_pointer_width = "64"), inline(never))]
    fn corners(&self, block: &Block) -> (Raw, Raw) {
        World::corners(self, block)
    }
}
