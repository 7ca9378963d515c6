//! The surface of a level, derived from its tiles when asked.

use super::range::Range;
use super::walk::Walk;
use crate::num::{Axis, Raw};
use crate::shape::Aabb;
use crate::world::{Feature, Geometry, Set, Store, TileMap, Way};
use core::fmt::Debug;

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// The faces, arcs and vertices of the surface that have a point in the closed region, row after row.
    ///
    /// - A face is a side of a tile's solid, or half of one, where the tile across does not cover it; a slope; or the inner side of a half tile.
    /// - An arc is that of a round tile.
    /// - A vertex is where the solid around a point is a wedge of less than half a turn, tiles that continue each other taken together. So there is
    ///   none on a flat line, where an arc leaves a line smoothly, and in concave corners. Two wedges that meet in one point have one each. The
    ///   edge of an arc is its tangent; the thin end of a quarter pipe is a wedge of no angle, with `e_out == -e_in`.
    /// - A one-way tile has its edge alone, less what the tile before it covers.
    ///
    /// What is [`Outside`](crate::world::Outside) counts: in a closed room the solid cells around the map have faces inward. Where the border is
    /// repeated, faces reach to the end of the domain: those of the border's cells where there are only [`Blocks`](crate::world::Blocks), else those of cells
    /// of their own beyond it.
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
    /// Cost: the cells of the region once each, with 4 neighbours of each full one; 8 of a shaped tile's cell whose sides or slope are in the
    /// region. On a Cortex-M0 a block with one face takes about 200 instructions, as one of shaped tiles about 600. It cannot fail.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Geometry, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let map = TileMap::from_ascii("...\n###", &KINDS)?;
    /// // Across the floor's top near the seam between its first two tiles: two flat faces, no corner.
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
    /// A floor, half a cell high, that goes on into a slope of one cell in two, which ends at a ledge:
    ///
    /// ```
    /// use tilesat::{AllShapes, Axis, Fx, Geometry, Grid, TileKind, TileKinds, TileMap, TileShape, Vec2};
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
        let range = self.solid_range(self.closed_range(region.lo(), region.hi()));
        Features {
            map: self,
            look: Look::all(region),
            walk: self.walk_of(range, Range::NONE),
            surface: S::Surface::NONE,
        }
    }

    /// Those of the features that a motion could run into, of the cells that a piece of it reaches and the piece before did not.
    ///
    /// What a body enters with its inside it meets at the border of a solid in a cell that its inside enters.
    pub(in crate::world) const fn features_ahead(&self, way: &Way) -> Features<'_, S, T> {
        let range = match way.cells {
            Some(cells) => cells.range(),
            None => self.solid_range(self.open_range(way.piece.lo(), way.piece.hi())),
        };
        let seen = match way.before {
            Some(before) => self.solid_range(self.open_range(before.lo(), before.hi())),
            None => Range::NONE,
        };
        Features { map: self, look: Look::ahead(way), walk: self.walk_of(range, seen), surface: S::Surface::NONE }
    }
}

/// The cursor of [`TileMap::features`]: holds no features, derives the next one from the tiles.
#[derive(Clone, Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct Features<'w, S: Set, T: Store> {
    pub(crate) map: &'w TileMap<'w, S, T>,
    look: Look,
    walk: Walk,
    /// The features of the cell that the walk has come to.
    surface: S::Surface,
}

/// What of a cell's surface is asked for.
///
/// Public in a private module, because a sealed trait names it.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Closed.
    pub(super) region: (Raw, Raw),
    /// Only what opposes this motion; all where it is zero.
    pub(super) d: Raw,
    /// Whether the joints of faces matter.
    pub(super) joints: bool,
}

impl Look {
    pub(super) const fn all(region: &Aabb) -> Self {
        Self { region: (region.lo(), region.hi()), d: Raw { x: 0, y: 0 }, joints: true }
    }

    const fn ahead(way: &Way) -> Self {
        Self { region: (way.whole.lo(), way.whole.hi()), d: way.d, joints: way.joints }
    }

    /// Whether a face along `dir` is opposed to the motion, or all are asked for.
    ///
    /// |d| is below 2^29, components of directions are at most 2.
    #[inline]
    pub(super) const fn opposes(&self, dir: Axis) -> bool {
        dir.y.wrapping_mul(self.d.x).wrapping_sub(dir.x.wrapping_mul(self.d.y)) < 0 || self.d.is_zero()
    }

    /// The same of an arc, if that is one: of the normals at its ends, since all others are between these.
    pub(super) const fn opposes_arc(&self, arc: &Geometry) -> bool {
        let Geometry::Arc { quadrant, convex, .. } = *arc else { return true };
        let out = if convex { quadrant } else { quadrant.reversed() };
        out.x.wrapping_mul(self.d.x) < 0 || out.y.wrapping_mul(self.d.y) < 0 || self.d.is_zero()
    }

    /// The same of the corner between two edges: some normal of a corner is opposed to the motion only where that of an edge is, but for a
    /// wedge of no angle, which has all normals of half a turn.
    pub(super) const fn opposes_corner(&self, e_in: Axis, e_out: Axis) -> bool {
        self.opposes(e_in) || self.opposes(e_out) || (e_in.x == -e_out.x && e_in.y == -e_out.y)
    }
}

/// The features of one cell, found when asked.
///
/// Public in a private module, because a sealed trait names it.
pub trait Surface: Clone + Debug {
    /// That of no cell.
    const NONE: Self;

    /// Whether nothing is left to give.
    fn is_over(&self) -> bool;

    /// Goes on to the cell that a walk over the closed range of the region has come to; the cell before is over.
    fn load<S: Set, T: Store>(&mut self, map: &TileMap<'_, S, T>, walk: &Walk, look: &Look);

    /// The next of what is left, if it is asked for.
    fn take<S: Set, T: Store>(&mut self, map: &TileMap<'_, S, T>, look: &Look) -> Option<Feature>;
}

impl<S: Set, T: Store> Iterator for Features<'_, S, T> {
    type Item = Feature;

    fn next(&mut self) -> Option<Feature> {
        loop {
            while self.surface.is_over() {
                if !self.map.walk(&mut self.walk) {
                    return None;
                }
                self.surface.load(self.map, &self.walk, &self.look);
            }
            if let Some(feature) = self.surface.take(self.map, &self.look) {
                return Some(feature);
            }
        }
    }
}
