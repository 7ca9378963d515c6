//! The surface of shaped tiles: halves of sides, slopes, arcs, and the corners that they make with their neighbours.

use super::features::Surface;
use super::form::Form;
use super::outline::{InnerKind, Outline, Piece, direction, gaps, place};
use crate::num::{Axis, Raw};
use crate::world::{Cell, Feature, Geometry, Set, Store, TileKind, TileMap, TileShape};

/// The cell whose features are handed out. `ROUND`: whether there are arcs.
#[derive(Clone, Copy, Debug)]
pub struct ShapeSurface<const ROUND: bool> {
    cell: Cell,
    corners: (Raw, Raw),
    kind: TileKind,
    /// The halves of sides that are faces, as the edges of an outline.
    faces: u8,
    /// The nibbles of the four tiles that meet at each corner; see [`Outline::corner`].
    around: [u32; 4],
    /// The sectors around the middle of each side that belong to the tile across.
    across: [u8; 4],
    /// Of a one-way tile: the ends of its face that are joined.
    joined: [bool; 2],
    /// The indices that are left to look at.
    left: u16,
    /// Of the vertices among them, the directions in which they are left: a nibble each from index 4 on, index 9 in the last one.
    outs: u32,
}

const INNER: u16 = 8;

impl<const ROUND: bool> Surface for ShapeSurface<ROUND> {
    const NONE: Self = Self {
        cell: Cell::new(0, 0),
        corners: (Raw { x: 0, y: 0 }, Raw { x: 0, y: 0 }),
        kind: TileKind::EMPTY,
        faces: 0,
        around: [0; 4],
        across: [0; 4],
        joined: [false; 2],
        left: 0,
        outs: 0,
    };

    #[inline]
    fn is_over(&self) -> bool {
        self.left == 0
    }

    #[inline]
    fn load<S: Set, T: Store>(&mut self, map: &TileMap<'_, S, T>, x: i32, y: i32, region: (Raw, Raw)) {
        let kind = map.kind_at(x, y);
        if kind.shape as u8 != TileShape::Empty as u8 {
            self.load_solid(map, kind, x, y, region);
        }
    }

    #[inline]
    fn take(&mut self, region: (Raw, Raw)) -> Option<Feature> {
        let index = self.left.trailing_zeros() as u16;
        self.left &= self.left.wrapping_sub(1);
        let geometry = match index {
            0..=3 => self.face(index, region),
            INNER => self.inner(region),
            _ => Some(self.vertex(index)),
        };
        let (kind, one_way) = (self.kind, self.kind.one_way_side().is_some());
        geometry.map(|geometry| Feature { geometry, cell: self.cell, index, flags: kind.flags, one_way, source: 0 })
    }
}

impl<const ROUND: bool> ShapeSurface<ROUND> {
    #[inline(never)]
    fn load_solid<S: Set, T: Store>(
        &mut self,
        map: &TileMap<'_, S, T>,
        kind: TileKind,
        x: i32,
        y: i32,
        region: (Raw, Raw),
    ) {
        let (own, one_way) = (kind.shape.outline(), kind.one_way_side());
        let edges = match one_way {
            Some(side) => 3 << (2 * side),
            None => own.edges,
        };
        let beside = map.quarter(x, y, 0, -1);
        let sides = beside.map(TileShape::outline);
        let [up, right, down, left] = sides;
        self.faces = edges & !(up.covers & 0x03 | right.covers & 0x0c | down.covers & 0x30 | left.covers & 0xc0);
        let any = self.faces | self.faces >> 1;
        self.left = u16::from(any & 1 | any >> 1 & 2 | any >> 2 & 4 | any >> 3 & 8);
        if !matches!(own.inner_kind(), InnerKind::None) {
            self.left |= 1 << INNER;
        }
        if self.left == 0 {
            return;
        }
        self.corners = map.extent(x, y);
        self.left &= self.reached(region);
        if self.left == 0 {
            return;
        }
        let diagonals = map.quarter(x, y, -1, -1).map(TileShape::outline);
        // At corner k this tile lies in quadrant k, the one before the corner in the next quadrant, and so on round.
        for (k, around) in (0..).zip(&mut self.around) {
            let (before, diagonal, side) = (at(&sides, k + 3), at(&diagonals, k), at(&sides, k));
            *around = own.corner(k) | before.corner(k + 1) | diagonal.corner(k + 2) | side.corner(k + 3);
        }
        self.across = [up.middle(2), right.middle(3), down.middle(0), left.middle(1)];
        if let Some(side) = one_way {
            self.joined = self.one_way_joined(side, beside, &sides, &diagonals);
        }
        self.kind = kind;
        self.cell = Cell::of(x, y);
        self.outs = 0;
    }

    /// The inner piece, and the sides whose line is in the region; that the cell is is known.
    fn reached(&self, region: (Raw, Raw)) -> u16 {
        let (lo, hi) = self.corners;
        u16::from(lo.y >= region.0.y)
            | u16::from(hi.x <= region.1.x) << 1
            | u16::from(hi.y <= region.1.y) << 2
            | u16::from(lo.x >= region.0.x) << 3
            | 1 << INNER
    }

    /// Where a piece starts and ends, and in which direction it does.
    fn piece(&self, index: u16) -> Piece {
        if index >= INNER {
            return self.kind.shape.outline().inner_piece();
        }
        let k = index as u8 & 3;
        let halves = self.faces >> (2 * k) & 3;
        Piece { start: 2 * k + u8::from(halves == 2), end: (2 * k + 2 - u8::from(halves == 1)) & 7, dir: 4 * k }
    }

    fn node(&self, node: u8) -> Raw {
        let (i, j) = place(node);
        let (lo, hi) = self.corners;
        Raw { x: along(lo.x, hi.x, i), y: along(lo.y, hi.y, j) }
    }

    fn face(&mut self, index: u16, region: (Raw, Raw)) -> Option<Geometry> {
        let piece = self.piece(index);
        let (a, b) = (self.node(piece.start), self.node(piece.end));
        if !meets(region, a, b) {
            return None;
        }
        let dir = direction(piece.dir);
        // One component of a reduced direction is one, so that the other way is the length.
        let way = b.sub(a);
        let len = if dir.x.unsigned_abs() == 1 { way.x } else { way.y }.wrapping_abs();
        let joined = if self.kind.one_way_side().is_some() {
            self.joined
        } else {
            [self.joined_at_start(piece), self.joined_at_end(index, piece, false, region)]
        };
        Some(Geometry::Face { a: a.vec2(), dir, len, joined })
    }

    fn inner(&mut self, region: (Raw, Raw)) -> Option<Geometry> {
        let kind = self.kind.shape.outline().inner_kind();
        if !ROUND || matches!(kind, InnerKind::Line) {
            return self.face(INNER, region);
        }
        let piece = self.piece(INNER);
        if !meets(region, self.node(piece.start), self.node(piece.end)) {
            return None;
        }
        let convex = matches!(kind, InnerKind::Convex);
        self.joined_at_end(INNER, piece, !convex, region);
        Some(arc(self.kind.shape.form(), convex, self.corners))
    }

    fn vertex(&self, index: u16) -> Geometry {
        let piece = self.piece(if index > INNER { INNER } else { index });
        let out = self.outs >> (4 * (index & 7)) & 15;
        Geometry::Vertex { p: self.node(piece.end).vec2(), e_in: direction(piece.dir), e_out: direction(out as u8) }
    }

    /// The sectors around a node that are solid, by this tile and those around, and the directions at which two of them are not joined.
    fn sectors(&self, node: u8) -> (u16, u16) {
        let k = node >> 1;
        if node & 1 == 0 {
            let around = at(&self.around, k);
            return (around as u16, if ROUND { gaps(around) } else { 0 });
        }
        let middle = u16::from_le_bytes([self.kind.shape.outline().middle(k), at(&self.across, k)]);
        (middle.rotate_left(4 * u32::from(k)), 0)
    }

    /// Whether no vertex is at the start of a face: from its direction on, solid covers eight sectors, which are half a turn, without a gap.
    fn joined_at_start(&self, piece: Piece) -> bool {
        let (solid, gaps) = self.sectors(piece.start);
        let first = 1u16.rotate_left(u32::from(piece.dir));
        (solid & (!gaps | first)).rotate_right(u32::from(piece.dir)) as u8 == u8::MAX
    }

    /// The same at the end, from the opposite direction backward; what is found there is put on the list where it is in the region.
    ///
    /// A gap in the direction of a face itself does not matter, its solid is on this side. That of a concave arc is nothing but the line itself
    /// there, so that it does.
    fn joined_at_end(&mut self, index: u16, piece: Piece, cusp: bool, region: (Raw, Raw)) -> bool {
        let (solid, gaps) = self.sectors(piece.end);
        let back = piece.dir.wrapping_add(8) & 15;
        // The sector before a direction is entered across it.
        let blocked = gaps.rotate_right(1);
        let first = if cusp { 0 } else { 1u16.rotate_left(u32::from(back) + 15) };
        let covered = (solid & (!blocked | first)).rotate_right(u32::from(back));
        if covered >> 8 == 0xff {
            return true;
        }
        let p = self.node(piece.end);
        if meets(region, p, p) {
            let vertex = if index == INNER { INNER + 1 } else { index + 4 };
            let out = u32::from(back).wrapping_sub(covered.leading_ones()) & 15;
            self.left |= 1 << vertex;
            self.outs |= out << (4 * (vertex & 7));
        }
        false
    }

    /// At which ends of a one-way face something that blocks from its side goes on beside it.
    #[inline(never)]
    fn one_way_joined(
        &self,
        k: u8,
        beside: [TileShape; 4],
        sides: &[&Outline; 4],
        diagonals: &[&Outline; 4],
    ) -> [bool; 2] {
        // Solid at the corner or along the half of its side there, or with the same edge, not covered from its other side.
        let goes_on = |side: u8, diagonal: u8, corner: u8, half: u8| {
            if TileKind::of(at(&beside, side)).one_way_side() == Some(k) {
                return at(diagonals, diagonal).covers >> (2 * k) & half == 0;
            }
            let tile = at(sides, side);
            tile.halves(k) & half != 0 || tile.corner(corner) as u16 != 0
        };
        let halves = self.faces >> (2 * k);
        [halves & 1 != 0 && goes_on(k + 3, k, k + 1, 2), halves & 2 != 0 && goes_on(k + 1, k + 1, k, 1)]
    }
}

/// That of side or corner `k`, modulo four.
#[inline]
#[expect(clippy::indexing_slicing, reason = "masked to the array's length")]
fn at<V: Copy>(values: &[V; 4], k: u8) -> V {
    values[(k & 3) as usize]
}

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// The shapes of the cells a step from a cell, in this direction and after each quarter turn.
    #[inline(never)]
    fn quarter(&self, x: i32, y: i32, dx: i32, dy: i32) -> [TileShape; 4] {
        let last = (i32::from(self.grid.x.count) - 1, i32::from(self.grid.y.count) - 1);
        if 0 < x && x < last.0 && 0 < y && y < last.1 {
            // All are tiles of the map, a fixed way apart in its data.
            let way = |x: i32, y: i32| y.wrapping_mul(i32::from(self.stride)).wrapping_add(x) as u32;
            let (tile, first, second) = (way(x, y), way(dx, dy), way(dy.wrapping_neg(), dx));
            let (a, b) = (tile.wrapping_add(first), tile.wrapping_add(second));
            let (c, d) = (tile.wrapping_sub(first), tile.wrapping_sub(second));
            return [a, b, c, d].map(|tile| self.kinds.get(self.id_at(tile)).shape);
        }
        let steps =
            [(dx, dy), (dy.wrapping_neg(), dx), (dx.wrapping_neg(), dy.wrapping_neg()), (dy, dx.wrapping_neg())];
        steps.map(|(dx, dy)| self.kind_at(x.wrapping_add(dx), y.wrapping_add(dy)).shape)
    }
}

/// The arc of a cell that has one.
pub(in crate::world) const fn arc(form: Form, convex: bool, (lo, hi): (Raw, Raw)) -> Geometry {
    // The centre is the solid corner of a convex arc, the opposite one of a concave one.
    let (right, bottom) = (form.right == convex, form.bottom == convex);
    Geometry::Arc {
        centre: Raw { x: if right { hi.x } else { lo.x }, y: if bottom { hi.y } else { lo.y } }.vec2(),
        radius: hi.x.wrapping_sub(lo.x),
        quadrant: Axis::new(if right { -1 } else { 1 }, if bottom { -1 } else { 1 }),
        convex,
    }
}

/// The ends of a cell's side, or its middle. Sides that end with the domain have no nodes in the middle.
pub(in crate::world) const fn along(lo: i32, hi: i32, halves: u8) -> i32 {
    match halves {
        0 => lo,
        1 => lo.wrapping_add(hi.wrapping_sub(lo) >> 1),
        _ => hi,
    }
}

/// Whether the box around a line meets a closed region.
fn meets(region: (Raw, Raw), a: Raw, b: Raw) -> bool {
    a.x.min(b.x) <= region.1.x && a.x.max(b.x) >= region.0.x && a.y.min(b.y) <= region.1.y && a.y.max(b.y) >= region.0.y
}
