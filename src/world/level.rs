//! A level: the faces and vertices of its surface, which are all that motion uses, and the trait by
//! which movers use it.

use super::cell::{Block, Cell, Cells, Way};
use super::convex::ConvexBody;
use super::lines::{BlockHit, Lines};
pub(in crate::world) use super::methods::{levels, meets_as_world};
use super::probes::Probe;
use super::tangent::Tangent;
use super::tile_map::kind::Fill;
use crate::num::{Axis, Raw, Vec2, imul};
use crate::query::{Overlaps, Touches};
use crate::shape::{Aabb, Circle};

pub(crate) mod sealed {
    //! Only this crate implements the traits on which its exactness argument rests.

    /// A supertrait that nobody outside can implement.
    pub trait Sealed {}
}

/// One piece of a level's surface, with the properties of its tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Feature {
    /// Its position.
    pub geometry: Geometry,
    /// The cell whose solid it bounds.
    pub cell: Cell,
    /// Which piece of the cell. For a tile, 0..=3 are the faces on its sides: toward row 0, right,
    /// bottom, left. 4..=7 are their vertices; a vertex follows the face that ends in it. 8 is the
    /// slope, arc or inner face, 9 its vertex. For a segment map, it is twice the segment's index,
    /// plus one for the vertex at its end.
    pub index: u16,
    /// The user flags of the cell's tile.
    pub flags: u8,
    /// Whether it blocks only bodies that are entirely in front of it before they move in.
    pub one_way: bool,
    /// The level of a `Joined` pair that it is from: 0 for the first level, and for a single one.
    pub source: u8,
}

/// The shape of a [`Feature`].
///
/// Directions are reduced: one slope has one direction. At a vertex that ends an arc, its edge is
/// the arc's tangent there. A cusp (the end of a quarter pipe or of a wall) has `e_out == -e_in`.
///
/// ```text
///             n = (dir.y, -dir.x)            e_in     p
///                    ^                     -------->+   solid wedge: left of both
///      a +-----------+----------> dir      ..solid..|   edges (y up)
///        ....solid on the left....         .........| e_out
///                                          .........v
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Geometry {
    /// A straight one-sided edge from `a` to `a + dir * len`; its outward normal is
    /// `(dir.y, -dir.x)`.
    Face {
        /// Start.
        a: Vec2,
        /// Reduced direction.
        dir: Axis,
        /// Length in multiples of `dir`, raw. 0 only if a map that ends with the domain continues
        /// beyond it.
        len: i32,
        /// Whether the solid continues beyond the start and the end (a flat or concave joint). The
        /// end point itself then blocks.
        joined: [bool; 2],
    },
    /// A strictly convex corner of the solid.
    Vertex {
        /// The corner.
        p: Vec2,
        /// Direction of the edge that ends here.
        e_in: Axis,
        /// Direction of the edge that starts here.
        e_out: Axis,
    },
    /// A quarter of a circle that bounds the solid, ends included.
    ///
    /// ```text
    ///   convex, quadrant (1, -1)      concave, quadrant (1, 1)
    ///       ..._                          centre +         |
    ///       ....`.   solid inside                         ,'   solid
    ///       ......\                                     _.'    outside
    ///  centre +----                              ----''
    /// ```
    Arc {
        /// The centre.
        centre: Vec2,
        /// The radius, raw, above 0.
        radius: i32,
        /// Both components 1 or -1: from the centre toward the arc.
        quadrant: Axis,
        /// Whether the solid is on the side of the centre. The normal then points away from the
        /// centre, else toward it.
        convex: bool,
    },
}

/// The index of a cell's face with this normal.
#[inline]
pub(in crate::world) const fn face_against(axis: Axis) -> u16 {
    // -y, +x, +y, -x are 0 to 3.
    (if axis.x != 0 { 2 - axis.x } else { 1 + axis.y }) as u16
}

impl Feature {
    /// Moves it.
    pub(in crate::world) fn shift(&mut self, offset: Raw) {
        let (Geometry::Face { a: p, .. } | Geometry::Vertex { p, .. } | Geometry::Arc { centre: p, .. }) =
            &mut self.geometry;
        *p = Raw::of(*p).add(offset).vec2();
    }
}

pub(in crate::world) const fn raw(axis: Axis) -> Raw {
    Raw { x: axis.x, y: axis.y }
}

/// The outward normal of an edge.
pub(crate) const fn normal(dir: Axis) -> Axis {
    Axis::new(dir.y, dir.x.wrapping_neg())
}

/// The ends of a face, which are in the domain.
pub(crate) const fn ends(a: Raw, dir: Axis, len: i32) -> (Raw, Raw) {
    (a, a.add(Raw { x: dir.x.wrapping_mul(len), y: dir.y.wrapping_mul(len) }))
}

/// Two opposite corners of the box around a piece of a surface.
#[inline]
pub(crate) const fn corners_of(geometry: &Geometry) -> (Raw, Raw) {
    match *geometry {
        Geometry::Face { a, dir, len, .. } => ends(Raw::of(a), dir, len),
        Geometry::Vertex { p, .. } => (Raw::of(p), Raw::of(p)),
        Geometry::Arc { centre, radius, quadrant, .. } => {
            let c = Raw::of(centre);
            (c, c.add(Raw { x: quadrant.x.wrapping_mul(radius), y: quadrant.y.wrapping_mul(radius) }))
        }
    }
}

/// Whether a vector from an arc's centre leads to the closed quarter of the arc.
pub(in crate::world) const fn in_quadrant(m: Raw, quadrant: Axis) -> bool {
    imul(m.x, quadrant.x) >= 0 && imul(m.y, quadrant.y) >= 0
}

/// The order of features by their place and shape: the last resort in a tie.
#[inline(never)]
pub(in crate::world) fn precedes(a: &Feature, b: &Feature) -> bool {
    let of = |p: Vec2, v: Axis, w: (i32, i32)| [Raw::of(p).x, Raw::of(p).y, v.x, v.y, w.0, w.1];
    let key = |feature: &Feature| match feature.geometry {
        Geometry::Face { a, dir, len, .. } => of(a, dir, (len, 0)),
        Geometry::Vertex { p, e_in, e_out } => of(p, e_in, (e_out.x, e_out.y)),
        Geometry::Arc { centre, radius, quadrant, convex } => of(centre, quadrant, (radius, i32::from(convex))),
    };
    (key(a), a.source) < (key(b), b.source)
}

/// A piece of the motion of a body.
///
/// Public in a private module, because a sealed trait's method takes it.
#[derive(Clone, Copy, Debug)]
pub struct MotionPiece<'a> {
    /// Holds the part of the level that the inside of the body's bounds meets in this piece.
    pub(crate) piece: &'a Aabb,
    /// The cells that the inside of the piece meets, if they are known.
    pub(crate) cells: Option<Cells>,
    /// The box of the piece before.
    pub(crate) before: Option<&'a Aabb>,
    /// The box that they cover in the whole motion, a raw unit larger on every side.
    pub(crate) whole: Aabb,
    /// The whole motion, not zero.
    pub(crate) d: Raw,
    /// Whether it matters to the body how faces are joined: to one with corners, or without area.
    pub(crate) joints: bool,
}

/// The rounding of a body if only its bounds count. An option would be two words.
pub(crate) const ANY_BODY: i32 = -1;

/// The result of a look at a region.
///
/// Public in a private module, because a sealed trait's method writes it.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// A body meets and overlaps nothing with its inside while its bounds are in the region and out
    /// of this box, one-way faces included.
    pub(crate) held: Option<Aabb>,
    /// If there is a box, the cells inside it, if the level is one of cells.
    pub(crate) cells: Option<Cells>,
}

impl Seen {
    pub(crate) const NOTHING: Self = Self { held: None, cells: None };
}

/// A level, as a [mover](crate::motion::Mover) uses it: its surface near a box, and two exact
/// overlap tests.
///
/// Sealed: a mover never ends in the solid only because `features` and the tests are two views of
/// one set of points.
///
/// Code for any level tests boxes and circles by the same methods as a pair of shapes. For a body
/// of another shape, add a bound that every level meets: `W: World + Overlaps<Capsule>`. For a
/// shape that is known only at run time, call
/// [`AnyShape::overlaps_level`](crate::shape::AnyShape::overlaps_level).
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Blocks, Capsule, Joined, Solid, Solids, TileKind, TileKinds, TileMap, Vec2, World, fx};
///
/// /// Whether a crate fits here, and an upright hero on top of it.
/// fn fits<W: World + Overlaps<Capsule>>(level: &W, at: &Aabb, hero: &Capsule) -> bool {
///     !level.overlaps(at) && !level.overlaps(hero)
/// }
///
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let level = TileMap::<Blocks>::from_ascii("...\n...\n###", &KINDS)?; // the floor is at y = 32
/// let at = Aabb::new(Vec2::from_ints(20, 22), Vec2::from_ints(30, 32))?;
/// let hero = Capsule::new(Vec2::from_ints(25, 8), Vec2::from_ints(25, 18), fx!(4))?;
/// assert!(fits(&level, &at, &hero));
/// let lift = [Solid::new(Aabb::new(Vec2::from_ints(0, 10), Vec2::from_ints(48, 14))?, 1)?];
/// assert!(!fits(&Joined::new(&level, &Solids::new(&lift)), &at, &hero));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias("level", "map"))]
pub trait World: sealed::Sealed + Overlaps<Aabb> + Overlaps<Circle> + Touches<Aabb> + Touches<Circle> {
    /// Whether all faces are along x or y and all corners a block's: then a mover links no code for
    /// others.
    #[doc(hidden)]
    const BLOCKS: bool;

    /// Whether there may be arcs.
    #[doc(hidden)]
    const ROUND: bool;

    /// Whether there may be faces of other directions than tiles have.
    #[doc(hidden)]
    const WIDE: bool = false;

    /// The cursor of [`features`](Self::features).
    type Features<'w>: Iterator<Item = Feature>
    where
        Self: 'w;

    /// Every face and vertex of the surface that has a point in the closed region, in an order that
    /// depends on the level only.
    ///
    /// Pieces near the region may be included.
    fn features(&self, region: &Aabb) -> Self::Features<'_>;

    /// [`features`](Self::features), where `joints` is whether the body needs to know how faces are
    /// joined.
    #[doc(hidden)]
    fn features_near(&self, region: &Aabb, joints: bool) -> Self::Features<'_> {
        let _ = joints;
        self.features(region)
    }

    /// The next one of [`features_near`](Self::features_near). A level of blocks links no code for
    /// motions there.
    #[doc(hidden)]
    fn next_near(&self, features: &mut Self::Features<'_>) -> Option<Feature> {
        features.next()
    }

    /// At least those features that a piece of a motion could run into and the piece before could
    /// not. There may be more.
    #[doc(hidden)]
    fn features_ahead(&self, way: &MotionPiece) -> Self::Features<'_> {
        self.features(way.piece)
    }

    /// Whether the surface and the overlap tests are two views of one solid wherever a body can be.
    /// The end of a motion that meets nothing then needs no test.
    #[doc(hidden)]
    const CERTAIN: bool = Self::BLOCKS;

    /// Whether its surface may have arcs. A level without them links no code for them.
    #[doc(hidden)]
    const ARCS: bool = !Self::BLOCKS;

    /// Whether the level is a grid of tiles and nothing else: then the surface of its full cells is
    /// known from [`fill`](Self::fill).
    #[doc(hidden)]
    const GRID: bool = false;

    /// A walk over the cells of a grid that hold something and whose inside meets a region, row
    /// after row.
    #[doc(hidden)]
    fn cells(&self, region: &Aabb) -> Cells {
        let _ = region;
        Cells::NONE
    }

    #[doc(hidden)]
    fn next_cell(&self, cells: &mut Cells) -> Option<Block> {
        let _ = cells;
        None
    }

    /// The cells of a grid that a body passes, strip by strip; `r` rounds its core.
    #[doc(hidden)]
    fn way(&self, bounds: &Aabb, r: i32, d: Raw) -> Way {
        let _ = (bounds, r, d);
        Way::NONE
    }

    #[doc(hidden)]
    fn next_strip(&self, way: &mut Way) {
        let _ = way;
    }

    /// The next cell of the current strip that holds something.
    #[doc(hidden)]
    fn next_on_way(&self, way: &mut Way) -> Option<Block> {
        let _ = way;
        None
    }

    /// The lines of a grid of blocks that a moving box reaches.
    #[doc(hidden)]
    fn lines(&self, _bounds: &Aabb, _d: Raw) -> Lines {
        Lines::NONE
    }

    /// Whether the box overlaps something at the start of such a motion.
    #[doc(hidden)]
    fn starts_inside(&self, _lines: &Lines, bounds: &Aabb) -> bool {
        self.overlaps_aabb(bounds)
    }

    /// The hit at the next line that has one. Counts the lines.
    #[doc(hidden)]
    fn next_block(&self, _lines: &mut Lines, _pass_one_way: bool, _seen: &mut u32) -> Option<BlockHit> {
        None
    }

    /// The corners of a cell of a grid. At a repeated border it continues beyond the map.
    #[doc(hidden)]
    fn corners(&self, block: &Block) -> (Raw, Raw) {
        let _ = block;
        (Raw { x: 0, y: 0 }, Raw { x: 0, y: 0 })
    }

    /// A cursor over the features that oppose a motion in the region, not yet at a cell of the
    /// grid.
    #[doc(hidden)]
    fn features_of_cells(&self, region: &Aabb, d: Raw, joints: bool) -> Self::Features<'_> {
        let _ = (d, joints);
        self.features(region)
    }

    /// Moves such a cursor to a cell of the grid.
    #[doc(hidden)]
    fn enter(&self, features: &mut Self::Features<'_>, block: &Block) {
        let _ = (features, block);
    }

    /// The next feature of that cell.
    #[doc(hidden)]
    fn next_here(&self, features: &mut Self::Features<'_>) -> Option<Feature> {
        features.next()
    }

    /// How much of a cell of a grid is solid.
    #[doc(hidden)]
    fn fill(&self, x: i32, y: i32) -> Fill {
        let _ = (x, y);
        Fill::None
    }

    /// The face of a one-way cell of a grid, if nothing covers it.
    #[doc(hidden)]
    fn one_way_face(&self, block: &Block) -> Option<Feature> {
        let _ = block;
        None
    }

    /// Called with each displacement that a mover makes.
    #[doc(hidden)]
    fn made(&self, by: Raw) {
        let _ = by;
    }

    /// Writes the part of a region with area that a body in it may meet. The body is the disc of
    /// radius `r` in its bounds, fills them if `r` is 0, or is [any](ANY_BODY). Returns whether the
    /// region is known to be in the domain.
    #[doc(hidden)]
    fn look(&self, region: &Aabb, r: i32, seen: &mut Seen) -> bool {
        let _ = r;
        *seen = Seen { held: Some(*region), cells: None };
        false
    }

    /// Whether a region of a grid is small and holds nothing.
    #[doc(hidden)]
    fn is_known_empty(&self, region: &Aabb) -> bool {
        let _ = region;
        false
    }

    /// Whether a region is in a grid, and no body in it, rounded by `r`, reaches solid in front of
    /// a line. A cell touches the line, and the solid of that cell must be convex, or the answer is
    /// false.
    #[doc(hidden)]
    fn is_behind(&self, region: &Aabb, r: i32, line: &Tangent) -> bool {
        let _ = (region, r, line);
        false
    }

    /// The side of a cell, raw and not zero: longer motions are enumerated in pieces of about this
    /// length.
    fn cell_size(&self) -> u32;

    /// How many cells a box of this size may meet with its inside, in raw units below 2^30; 1 if
    /// there are none.
    #[doc(hidden)]
    fn most_cells(&self, width: u32, height: u32) -> u32 {
        let _ = (width, height);
        1
    }

    /// Whether a box overlaps the solid; strict and exact.
    fn overlaps_aabb(&self, b: &Aabb) -> bool;

    /// Whether a circle overlaps the solid; strict and exact.
    fn overlaps_circle(&self, c: &Circle) -> bool;

    #[doc(hidden)]
    fn meets_convex(&self, body: &ConvexBody<'_>, closed: bool) -> bool;

    /// Whether a box has a point in common with the solid, borders included; exact.
    fn touches_aabb(&self, b: &Aabb) -> bool;

    /// Whether a circle has a point in common with the solid, borders included; exact.
    fn touches_circle(&self, c: &Circle) -> bool;

    /// The flags, or-ed, of everything that a box, circle or point touches, as
    /// [`TileMap::flags_touched`](crate::TileMap::flags_touched): borders included, exact.
    fn flags_touched<P: Probe>(&self, shape: &P) -> u8;
}
