//! How tiles give their surface: the queries to a cell, and the answers of blocks, which are whole
//! sides of cells and their corners.

use crate::num::{Axis, Raw};
use crate::shape::Aabb;
use crate::world::cell::{Block, Cell};
use crate::world::level::{Feature, Geometry, MotionPiece};
use crate::world::tile_map::kind::{TileKind, TileShape};
use core::fmt::Debug;

/// The wanted part of a cell's surface.
///
/// Public in a private module, because a sealed trait names it.
#[derive(Clone, Copy, Debug)]
pub struct CellQuery {
    /// Closed.
    pub(super) region: (Raw, Raw),
    /// Only what opposes this motion; all if it is zero.
    pub(super) d: Raw,
    /// Whether the joints of faces matter.
    pub(super) joints: bool,
}

impl CellQuery {
    pub(super) const fn all(region: &Aabb) -> Self {
        Self { region: (region.lo(), region.hi()), d: Raw { x: 0, y: 0 }, joints: true }
    }

    pub(super) const fn ahead(way: &MotionPiece) -> Self {
        Self { region: (way.whole.lo(), way.whole.hi()), d: way.d, joints: way.joints }
    }

    /// Whether a face along `dir` opposes the motion, or all are wanted.
    ///
    /// |d| is below 2^29, components of directions are at most 2.
    #[inline]
    pub(super) const fn opposes(&self, dir: Axis) -> bool {
        dir.y.wrapping_mul(self.d.x).wrapping_sub(dir.x.wrapping_mul(self.d.y)) < 0 || self.d.is_zero()
    }

    /// Whether an arc opposes the motion: one of the normals at its ends does, since all others are
    /// between these. It is true for anything that is not an arc.
    pub(super) const fn opposes_arc(&self, arc: &Geometry) -> bool {
        let Geometry::Arc { quadrant, convex, .. } = *arc else { return true };
        let out = if convex { quadrant } else { quadrant.reversed() };
        out.x.wrapping_mul(self.d.x) < 0 || out.y.wrapping_mul(self.d.y) < 0 || self.d.is_zero()
    }

    /// Whether the corner between two edges opposes the motion. A normal of a corner is opposed to
    /// it only if that of an edge is. A wedge of no angle is the exception: it has all normals of
    /// half a turn.
    ///
    /// A body that meets joints in a motion is a box or a point. It meets a corner only by a side
    /// that lands there: both edges lead away from that side.
    pub(super) const fn opposes_corner(&self, (e_in, in_opposes): (Axis, bool), e_out: Axis) -> bool {
        let lands = e_in.x.wrapping_mul(e_out.x) < 0 || e_in.y.wrapping_mul(e_out.y) < 0;
        if self.joints && !lands && !self.d.is_zero() {
            return false;
        }
        in_opposes || self.opposes(e_out) || (e_in.x == -e_out.x && e_in.y == -e_out.y)
    }
}

/// The tiles that a surface is derived from.
///
/// Public in a private module, because a sealed trait names it.
pub trait TileSource {
    /// The kind of any cell.
    fn kind_at(&self, x: i32, y: i32) -> TileKind;

    fn full(&self, x: i32, y: i32) -> bool;

    /// The shapes across the sides of a cell.
    fn beside(&self, x: i32, y: i32) -> [TileShape; 4];

    /// The corners of a cell; those of one beyond the map reach to the end of the domain.
    fn cell_corners(&self, x: i32, y: i32) -> (Raw, Raw);

    /// The corners of a cell with the band that it stands for.
    fn extent(&self, x: i32, y: i32) -> (Raw, Raw);

    /// The corners of a cell that a walk has found, as [`extent`](Self::extent) has them.
    fn corners(&self, block: &Block) -> (Raw, Raw);
}

/// The features of one cell, found when asked.
///
/// Public in a private module, because a sealed trait names it.
pub trait CellSurface: Clone + Debug {
    /// That of no cell.
    const NONE: Self;

    /// Whether nothing is left to give.
    fn is_over(&self) -> bool;

    /// Goes on to a cell of the closed range of the region; the cell before is over.
    fn load<M: TileSource>(&mut self, map: &M, block: &Block, look: &CellQuery);

    /// The next of the remaining ones, if it is wanted.
    fn take<M: TileSource>(&mut self, map: &M, look: &CellQuery) -> Option<Feature>;
}

/// The cell whose features are handed out. The corners of its solid, its tile's flags, all its
/// features as a mask of indices, and those left to give.
#[derive(Clone, Copy, Debug)]
pub struct BlockSurface {
    cell: Cell,
    solid: (Raw, Raw),
    flags: u8,
    all: PieceBits,
    left: PieceBits,
}

/// Bits 0..=3: faces by index; 4..=7: vertices; 8: a one-way tile. There the bits of the vertices
/// at the ends of its face mean that the face is not joined.
type PieceBits = u16;

const ONE_WAY: PieceBits = 1 << 8;

/// Face k runs from corner k to corner k + 1: corners are counted from the one nearest the origin,
/// turning with the faces.
const DIRECTIONS: [Axis; 4] = [Axis::X, Axis::Y, Axis::NEG_X, Axis::NEG_Y];

impl CellSurface for BlockSurface {
    /// Not all zero: clearing it would link 160 bytes of the compiler's code.
    const NONE: Self =
        Self { cell: Cell::new(0, 0), solid: (Raw { x: 0, y: 0 }, Raw { x: 1, y: 1 }), flags: 0, all: 0, left: 0 };

    #[inline]
    fn is_over(&self) -> bool {
        self.left == 0
    }

    #[inline]
    fn load<M: TileSource>(&mut self, map: &M, block: &Block, look: &CellQuery) {
        let Block { x, y, kind } = *block;
        if kind.is_full() {
            self.solid = map.corners(block);
            let asked = self.asked(look);
            if asked == 0 {
                return;
            }
            self.all = surface(map, x, y);
            self.left = self.all & asked;
        } else if let Some(side) = self.load_one_way(map, kind, (x, y)) {
            // If the region is beyond a repeated border, the line can be on either side of it.
            let ((lo, hi), region) = (self.solid, look.region);
            let met = lo.x <= region.1.x && hi.x >= region.0.x && lo.y <= region.1.y && hi.y >= region.0.y;
            self.left = ((met && look.opposes(direction(side))) as PieceBits) << side;
        }
        self.flags = kind.flags;
        self.cell = Cell::of(x, y);
    }

    #[inline]
    fn take<M: TileSource>(&mut self, _: &M, _: &CellQuery) -> Option<Feature> {
        let mut index = 0u16;
        while index < 7 && self.left >> index & 1 == 0 {
            index += 1;
        }
        self.left &= !(1 << index);
        Some(self.feature(index))
    }
}

impl BlockSurface {
    /// The face of a cell that is not full, if it has one that nothing covers.
    pub(super) fn one_way<M: TileSource>(map: &M, x: i32, y: i32) -> Option<Feature> {
        let (mut surface, kind) = (Self { cell: Cell::of(x, y), ..Self::NONE }, map.kind_at(x, y));
        let side = surface.load_one_way(map, kind, (x, y))?;
        surface.flags = kind.flags;
        Some(surface.feature(side.into()))
    }

    /// A cell with one face; not there before a full one. Returns which. Out of line: a level has
    /// few.
    #[inline(never)]
    fn load_one_way<M: TileSource>(&mut self, map: &M, kind: TileKind, (x, y): (i32, i32)) -> Option<u8> {
        let side = kind.one_way_side()?;
        let (dx, dy) = across(side);
        if map.full(x.wrapping_add(dx), y.wrapping_add(dy)) {
            return None;
        }
        // The next side is turned by a right angle.
        let end = !goes_on(map, x.wrapping_sub(dy), y.wrapping_add(dx), side) as PieceBits;
        let start = !goes_on(map, x.wrapping_add(dy), y.wrapping_sub(dx), side) as PieceBits;
        self.all = ONE_WAY | 1 << side | end << (4 + side) | start << (4 + (side.wrapping_sub(1) & 3));
        // Across its line a one-way edge is not repeated: the band's corners are not its own.
        let (band, (lo, hi)) = (map.extent(x, y), map.cell_corners(x, y));
        let a = corner(lo, hi, side);
        self.solid = if dx == 0 {
            (Raw { x: band.0.x, y: a.y }, Raw { x: band.1.x, y: a.y })
        } else {
            (Raw { x: a.x, y: band.0.y }, Raw { x: a.x, y: band.1.y })
        };
        Some(side)
    }

    /// The requested indices, if they exist.
    fn asked(&self, look: &CellQuery) -> PieceBits {
        let (d, reached) = (look.d, self.reached(look.region));
        if d.is_zero() {
            return reached;
        }
        // The faces that the motion can reach. At the start, its front is beyond the others, up to
        // the raw unit by which the region is larger.
        let ((lo, hi), (from, to)) = (self.solid, look.region);
        let up = d.y > 0 && lo.y >= to.y.wrapping_sub(d.y).wrapping_sub(1);
        let right = d.x < 0 && hi.x <= from.x.wrapping_sub(d.x).wrapping_add(1);
        let down = d.y < 0 && hi.y <= from.y.wrapping_sub(d.y).wrapping_add(1);
        let left = d.x > 0 && lo.x >= to.x.wrapping_sub(d.x).wrapping_sub(1);
        let faces = up as PieceBits | (right as PieceBits) << 1 | (down as PieceBits) << 2 | (left as PieceBits) << 3;
        if look.joints {
            // A body that meets the joints of faces meets no corners.
            return faces & reached;
        }
        // Only a body that moves toward one of its faces meets a corner.
        let toward = (d.y > 0) as PieceBits
            | ((d.x < 0) as PieceBits) << 1
            | ((d.y < 0) as PieceBits) << 2
            | ((d.x > 0) as PieceBits) << 3;
        (faces | (toward | toward >> 1 | toward << 3) << 4) & reached
    }

    /// The indices whose place is in the region. The cell is known to reach into it.
    fn reached(&self, region: (Raw, Raw)) -> PieceBits {
        let (lo, hi) = self.solid;
        let mut out = 0;
        if lo.y < region.0.y {
            out |= 0b1001_0001;
        }
        if hi.x > region.1.x {
            out |= 0b0011_0010;
        }
        if hi.y > region.1.y {
            out |= 0b0110_0100;
        }
        if lo.x < region.0.x {
            out |= 0b1100_1000;
        }
        !out & 0xff
    }

    fn feature(&self, index: u16) -> Feature {
        let (lo, hi) = self.solid;
        let k = index as u8 & 3;
        let dir = direction(k);
        let geometry = if index < 4 {
            let a = corner(lo, hi, k);
            let len = if k & 1 == 0 { hi.x.wrapping_sub(lo.x) } else { hi.y.wrapping_sub(lo.y) };
            let (start, end) = (4 + (k.wrapping_sub(1) & 3), 4 + k);
            let joined = [self.all >> start & 1 == 0, self.all >> end & 1 == 0];
            Geometry::Face { a: a.vec2(), dir, len, joined }
        } else {
            let next = k.wrapping_add(1) & 3;
            Geometry::Vertex { p: corner(lo, hi, next).vec2(), e_in: dir, e_out: direction(next) }
        };
        Feature { geometry, cell: self.cell, index, flags: self.flags, one_way: self.all & ONE_WAY != 0, source: 0 }
    }
}

#[expect(clippy::indexing_slicing, reason = "masked to the table's length")]
const fn direction(k: u8) -> Axis {
    DIRECTIONS[(k & 3) as usize]
}

/// The start of face k.
const fn corner(lo: Raw, hi: Raw, k: u8) -> Raw {
    Raw { x: if k == 1 || k == 2 { hi.x } else { lo.x }, y: if k >= 2 { hi.y } else { lo.y } }
}

/// The faces and vertices of a full cell.
fn surface<M: TileSource>(map: &M, x: i32, y: i32) -> PieceBits {
    let up = !map.full(x, y.wrapping_sub(1)) as PieceBits;
    let right = !map.full(x.wrapping_add(1), y) as PieceBits;
    let down = !map.full(x, y.wrapping_add(1)) as PieceBits;
    let left = !map.full(x.wrapping_sub(1), y) as PieceBits;
    let faces = up | right << 1 | down << 2 | left << 3;
    // Vertex k is where face k ends and the next one starts.
    faces | (faces & (faces >> 1 | faces << 3) & 0xf) << 4
}

/// Whether a full cell, or a one-way cell with the same face, lies beside a one-way face and blocks
/// from the same side.
fn goes_on<M: TileSource>(map: &M, x: i32, y: i32, side: u8) -> bool {
    let kind = map.kind_at(x, y);
    let (dx, dy) = across(side);
    let same = matches!(kind.one_way_side(), Some(other) if other == side);
    kind.is_full() || (same && !map.full(x.wrapping_add(dx), y.wrapping_add(dy)))
}

/// The step to the cell across a side.
const fn across(side: u8) -> (i32, i32) {
    let normal = direction(side.wrapping_sub(1));
    (normal.x, normal.y)
}
