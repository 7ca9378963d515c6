//! The surface of shaped tiles: halves of sides, slopes, arcs, and the corners that they make with
//! their neighbours.

use super::outline::{Form, InnerKind, Outline, Piece, direction, gaps, place};
use super::surface::{CellQuery, CellSurface, TileSource};
use crate::num::{Axis, Raw};
use crate::world::cell::{Block, Cell};
use crate::world::level::{Feature, Geometry};
use crate::world::tile_map::kind::{TileKind, TileShape};

/// The cell whose features are handed out. `ROUND`: whether there are arcs.
#[derive(Clone, Copy, Debug)]
pub struct ShapeSurface<const ROUND: bool> {
    /// The indices that are left to look at, from `index` on.
    left: u16,
    index: u8,
    /// For the vertices among them, the directions in which they are left: a nibble each from index
    /// 4 on, index 9 in the last one.
    outs: u32,
    /// None before the first.
    tile: Option<Tile>,
}

#[derive(Clone, Copy, Debug)]
struct Tile {
    kind: TileKind,
    outline: &'static Outline,
    cell: Cell,
    lines: NodeLines,
    /// The halves of sides that are faces, as the edges of an outline.
    faces: u8,
    /// The shapes across each side.
    beside: [TileShape; 4],
}

const INNER: u8 = 8;

/// The coordinates of a cell's nodes: of its sides and of the middle, by the halves of the cell
/// before them. The fourth one only fills the table.
#[derive(Clone, Copy, Debug)]
struct NodeLines {
    x: [i32; 4],
    y: [i32; 4],
}

impl NodeLines {
    const fn of((lo, hi): (Raw, Raw)) -> Self {
        let (x, y) = (along(lo.x, hi.x, 1), along(lo.y, hi.y, 1));
        Self { x: [lo.x, x, hi.x, hi.x], y: [lo.y, y, hi.y, hi.y] }
    }

    /// The position of a node, modulo eight.
    #[inline]
    #[expect(clippy::indexing_slicing, reason = "masked to the table's length")]
    fn node(&self, node: u8) -> Raw {
        let place = NODES[(node & 7) as usize];
        Raw { x: at(&self.x, place), y: at(&self.y, place >> 2) }
    }

    const fn corners(&self) -> (Raw, Raw) {
        let ([x0, _, x1, _], [y0, _, y1, _]) = (self.x, self.y);
        (Raw { x: x0, y: y0 }, Raw { x: x1, y: y1 })
    }
}

/// The [place] of each node: its column, and its row above two bits.
#[expect(clippy::indexing_slicing, reason = "runs in the compiler")]
static NODES: [u8; 8] = {
    let (mut nodes, mut node) = ([0; 8], 0u8);
    while node < 8 {
        let (i, j) = place(node);
        nodes[node as usize] = i | j << 2;
        node += 1;
    }
    nodes
};

impl<const ROUND: bool> CellSurface for ShapeSurface<ROUND> {
    const NONE: Self = Self { left: 0, index: 0, outs: 0, tile: None };

    #[inline]
    fn is_over(&self) -> bool {
        self.left == 0
    }

    #[inline(never)]
    fn load<M: TileSource>(&mut self, map: &M, block: &Block, look: &CellQuery) {
        let Block { x, y, kind } = *block;
        let outline = kind.shape.outline();
        let edges = match kind.one_way_side() {
            Some(side) => 3 << (2 * side),
            None => outline.edges,
        };
        let beside = map.beside(x, y);
        let [up, right, down, left] = beside.map(|shape| shape.outline().covers);
        let faces = edges & !(up & 0x03 | right & 0x0c | down & 0x30 | left & 0xc0);
        let any = faces | faces >> 1;
        self.left = u16::from(any & 1 | any >> 1 & 2 | any >> 2 & 4 | any >> 3 & 8);
        if !matches!(outline.inner_kind(), InnerKind::None) {
            self.left |= 1 << INNER;
        }
        if self.left == 0 {
            return;
        }
        let corners = map.corners(block);
        self.left &= reached(corners, look.region);
        (self.index, self.outs) = (0, 0);
        self.tile = Some(Tile { kind, outline, cell: Cell::of(x, y), lines: NodeLines::of(corners), faces, beside });
    }

    #[inline]
    fn take<M: TileSource>(&mut self, map: &M, look: &CellQuery) -> Option<Feature> {
        let Some(tile) = &self.tile else {
            self.left = 0;
            return None;
        };
        while self.left & 1 == 0 && self.left != 0 {
            (self.left, self.index) = (self.left >> 1, self.index.wrapping_add(1));
        }
        let index = self.index;
        let piece = tile.piece(index);
        let (end, dir) = (tile.lines.node(piece.end), direction(piece.dir));
        (self.left, self.index) = (self.left >> 1, index.wrapping_add(1));
        if VERTICES >> index & 1 != 0 {
            let out = direction((self.outs >> (4 * (index & 7))) as u8);
            return Some(tile.feature(index, Geometry::Vertex { p: end.vec2(), e_in: dir, e_out: out }));
        }
        let inner = if index == INNER { tile.outline.inner_kind() } else { InnerKind::Line };
        let convex = matches!(inner, InnerKind::Convex);
        let arc_here = ROUND && !matches!(inner, InnerKind::Line);
        let one_way = tile.kind.one_way_side();
        let corner = one_way.is_none() && holds(look.region, end);
        let ahead = look.opposes(dir);
        let opposes = arc_here || ahead;
        if !corner && !opposes {
            return None;
        }
        let start = tile.lines.node(piece.start);
        // The line of a side is in the region, and so is a part of the cell: of a whole side too.
        let whole = index < INNER && piece.end & 1 == 0 && piece.start & 1 == 0;
        if !corner && !whole && !meets(look.region, start, end) {
            return None;
        }
        let mut joined = true;
        if corner || (one_way.is_none() && look.joints && !arc_here && opposes) {
            if let Some(out) = tile.end::<ROUND, _>(map, piece, arc_here && !convex) {
                joined = false;
                if corner && look.opposes_corner((dir, ahead), direction(out)) {
                    let vertex = if index == INNER { INNER + 1 } else { index + 4 };
                    self.left |= 1 << vertex.wrapping_sub(self.index);
                    self.outs |= u32::from(out) << (4 * (vertex & 7));
                }
            }
        }
        if arc_here {
            let arc = arc(tile.kind.shape.form(), convex, tile.lines.corners());
            return if look.opposes_arc(&arc) { Some(tile.feature(index, arc)) } else { None };
        }
        if !opposes {
            return None;
        }
        // One component of a reduced direction is one: the other way is the length.
        let way = end.sub(start);
        let len = if dir.x & 1 != 0 { way.x } else { way.y }.wrapping_abs();
        let joined = match one_way {
            _ if !look.joints => [false; 2],
            Some(side) => tile.one_way_joined(map, side),
            None => [tile.joined_at_start::<ROUND, _>(map, piece), joined],
        };
        Some(tile.feature(index, Geometry::Face { a: start.vec2(), dir, len, joined }))
    }
}

/// The indices of vertices.
const VERTICES: u16 = 0b10_1111_0000;

/// The inner piece, and the sides whose line is in the region. The cell is known to reach into it.
const fn reached((lo, hi): (Raw, Raw), region: (Raw, Raw)) -> u16 {
    (lo.y >= region.0.y) as u16
        | ((hi.x <= region.1.x) as u16) << 1
        | ((hi.y <= region.1.y) as u16) << 2
        | ((lo.x >= region.0.x) as u16) << 3
        | 1 << INNER
}

impl Tile {
    #[inline]
    fn feature(&self, index: u8, geometry: Geometry) -> Feature {
        let one_way = self.kind.one_way_side().is_some();
        Feature { geometry, cell: self.cell, index: index.into(), flags: self.kind.flags, one_way, source: 0 }
    }

    /// The start and end of a piece, and its directions there. For a vertex, those of the piece
    /// that ends in it.
    fn piece(&self, index: u8) -> Piece {
        if index >= INNER {
            return self.outline.inner_piece();
        }
        let k = index & 3;
        let halves = self.faces >> (2 * k) & 3;
        Piece { start: 2 * k + u8::from(halves == 2), end: (2 * k + 2 - u8::from(halves == 1)) & 7, dir: 4 * k }
    }

    /// The sectors around a node that are solid, by this tile and those around, and the directions
    /// at which two of them are not joined.
    #[inline(never)]
    fn sectors<const ROUND: bool, M: TileSource>(&self, map: &M, node: u8) -> (u16, u16) {
        let k = node >> 1 & 3;
        let side = at(&self.beside, k).outline();
        if node & 1 == 0 {
            // At corner k this tile lies in quadrant k, the one before the corner in the next
            // quadrant, and so on round.
            let (before, diagonal) = (at(&self.beside, k + 3).outline(), self.diagonal(map, k).outline());
            let around = self.outline.corner(k) | before.corner(k + 1) | diagonal.corner(k + 2) | side.corner(k + 3);
            return (around as u16, if ROUND { gaps(around) } else { 0 });
        }
        let middle = u16::from_le_bytes([self.outline.middle(k), side.middle(k + 2)]);
        (middle.rotate_left(4 * u32::from(k)), 0)
    }

    /// The shape across corner `k`, modulo four.
    fn diagonal<M: TileSource>(&self, map: &M, k: u8) -> TileShape {
        let (x, y) = (i32::from(self.cell.x), i32::from(self.cell.y));
        let dx = if k.wrapping_add(1) & 2 == 0 { -1 } else { 1 };
        let dy = if k & 2 == 0 { -1 } else { 1 };
        map.kind_at(x.wrapping_add(dx), y.wrapping_add(dy)).shape
    }

    /// Whether no vertex is at the start of a face. Then, from its direction on, solid covers eight
    /// sectors without a gap: half a turn.
    fn joined_at_start<const ROUND: bool, M: TileSource>(&self, map: &M, piece: Piece) -> bool {
        let (solid, gaps) = self.sectors::<ROUND, _>(map, piece.start);
        let first = 1u16.rotate_left(u32::from(piece.dir));
        (solid & (!gaps | first)).rotate_right(u32::from(piece.dir)) as u8 == u8::MAX
    }

    /// The direction in which the surface leaves the vertex at the end of a piece. None if the
    /// piece is joined there: as above, from the opposite direction backward.
    ///
    /// A gap in the direction of a face itself does not matter: its solid is on this side. At a
    /// concave arc (`cusp`) there is nothing but the line itself, and it does matter.
    fn end<const ROUND: bool, M: TileSource>(&self, map: &M, piece: Piece, cusp: bool) -> Option<u8> {
        let (solid, gaps) = self.sectors::<ROUND, _>(map, piece.end);
        let back = piece.dir.wrapping_add(8) & 15;
        // The sector before a direction is entered across it.
        let blocked = gaps.rotate_right(1);
        let first = if cusp { 0 } else { 1u16.rotate_left(u32::from(back) + 15) };
        let mut covered = (solid & (!blocked | first)).rotate_right(u32::from(back));
        if covered >> 8 == 0xff {
            return None;
        }
        let mut out = back;
        while covered >> 15 != 0 {
            (covered, out) = (covered << 1, out.wrapping_sub(1));
        }
        Some(out & 15)
    }

    /// The ends of a one-way face beside which something that blocks from its side continues.
    #[inline(never)]
    fn one_way_joined<M: TileSource>(&self, map: &M, k: u8) -> [bool; 2] {
        let halves = self.faces >> (2 * k);
        [0, 1].map(|end| halves >> end & 1 != 0 && self.one_way_goes_on(map, k, end))
    }

    /// Solid at the corner or along the half of its side there, or with the same edge, not covered
    /// from its other side.
    #[inline(never)]
    fn one_way_goes_on<M: TileSource>(&self, map: &M, k: u8, end: u8) -> bool {
        let (beside, half) = (at(&self.beside, k + 3 + 2 * end), 2 - end);
        if TileKind::of(beside).one_way_side() == Some(k) {
            return self.diagonal(map, k + end).outline().covers >> (2 * k) & half == 0;
        }
        let tile = beside.outline();
        tile.halves(k) & half != 0 || tile.corner(k + 1 - end) as u16 != 0
    }
}

/// That of side or corner `k`, modulo four.
#[inline]
#[expect(clippy::indexing_slicing, reason = "masked to the array's length")]
fn at<V: Copy>(values: &[V; 4], k: u8) -> V {
    values[(k & 3) as usize]
}

/// The arc of a cell that has one.
pub(in crate::world) const fn arc(form: Form, convex: bool, square: (Raw, Raw)) -> Geometry {
    // The centre is the solid corner of a convex arc, the opposite one of a concave one.
    let (right, bottom) = (form.right == convex, form.bottom == convex);
    Geometry::Arc {
        centre: corner(square, right, bottom).vec2(),
        radius: square.1.x.wrapping_sub(square.0.x),
        quadrant: Axis::new(if right { -1 } else { 1 }, if bottom { -1 } else { 1 }),
        convex,
    }
}

/// The corner of a square with the larger x, or the smaller; the same of y.
#[inline]
pub(super) const fn corner((lo, hi): (Raw, Raw), right: bool, bottom: bool) -> Raw {
    Raw { x: if right { hi.x } else { lo.x }, y: if bottom { hi.y } else { lo.y } }
}

/// The ends of a cell's side, or its middle. Sides that end with the domain have no nodes in the
/// middle.
pub(in crate::world) const fn along(lo: i32, hi: i32, halves: u8) -> i32 {
    match halves {
        0 => lo,
        1 => lo.wrapping_add(hi.wrapping_sub(lo) >> 1),
        _ => hi,
    }
}

/// Whether a closed region holds a point. By signs: four comparisons take 8 instructions more.
/// Coordinates are below 2^29, so differences are below 2^30.
fn holds((lo, hi): (Raw, Raw), p: Raw) -> bool {
    let (a, b) = (p.sub(lo), hi.sub(p));
    a.x | a.y | b.x | b.y >= 0
}

/// Whether the box around a line meets a closed region.
fn meets(region: (Raw, Raw), a: Raw, b: Raw) -> bool {
    a.x.min(b.x) <= region.1.x && a.x.max(b.x) >= region.0.x && a.y.min(b.y) <= region.1.y && a.y.max(b.y) >= region.0.y
}
