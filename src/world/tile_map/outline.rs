//! Each shape in its cell: the part that it fills, as one inequality, and all that joins
//! its border to its neighbours.

use crate::num::Axis;
use crate::world::tile_map::kind::{TileKind, TileShape};

/// The solid of a tile in its own frame. `u` and `v` are the distances along x and y from the
/// corner at which it is solid. Both go from 0 to a side S of the cell; `h = S / 2`.
///
/// ```text
///   corner +----> u      Line: p u + q v <= k h     p, q, k in 0..=4
///          |####/        Convex: u u + v v <= S S
///          |###/         Concave: (S - u)(S - u) + (S - v)(S - v) >= S S
///          v|#/
/// ```
///
/// All are monotone: with a point, every point of the cell nearer to the corner on both axes is in
/// the solid.
///
/// In words: six single bytes would be copied by a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(align(4))]
pub(in crate::world) struct Form {
    /// Whether the corner is the one with the larger x; else the smaller.
    pub(in crate::world) right: bool,
    /// Whether the corner is the one with the larger y; else the smaller.
    pub(in crate::world) bottom: bool,
    pub(in crate::world) kind: FormKind,
}

/// See [`Form`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::world) enum FormKind {
    /// Nothing is solid: empty and one-way tiles.
    Empty,
    Full,
    Line {
        p: u8,
        q: u8,
        k: u8,
    },
    Convex,
    Concave,
}

/// That of each group of four shapes; of the halves it is every other one's.
static GROUPS: [FormKind; 8] = [
    FormKind::Line { p: 0, q: 1, k: 1 },
    FormKind::Line { p: 1, q: 1, k: 2 },
    FormKind::Convex,
    FormKind::Concave,
    FormKind::Line { p: 1, q: 2, k: 2 },
    FormKind::Line { p: 1, q: 2, k: 4 },
    FormKind::Line { p: 2, q: 1, k: 2 },
    FormKind::Line { p: 2, q: 1, k: 4 },
];

impl TileShape {
    /// The solid part of the shape.
    #[expect(clippy::indexing_slicing, reason = "masked to the table's length")]
    pub(in crate::world) const fn form(self) -> Form {
        // After empty and full, groups of four: halves by their side, the others by their corner,
        // both turning right from the top (left).
        let id = (self as u8).wrapping_sub(2);
        let (group, turn) = (id >> 2, id & 3);
        let kind = if group >= 8 {
            if matches!(self, Self::Full) { FormKind::Full } else { FormKind::Empty }
        } else if group == 0 && turn & 1 != 0 {
            FormKind::Line { p: 1, q: 0, k: 1 }
        } else {
            GROUPS[(group & 7) as usize]
        };
        Form { right: turn == 1 || turn == 2, bottom: turn >= 2, kind }
    }
}

/// The border of a tile's solid, on a lattice of half cells.
///
/// Eight nodes lie around a cell, counted with its sides. Around any node there are sixteen
/// directions, those of all lines that tiles have. Between them are sixteen sectors: sector d goes
/// from direction d to d + 1. Each direction has an opposite one, and eight sectors in a row are
/// exactly half a turn. Whether a corner is convex is a matter of counting.
///
/// ```text
///   0---1---2  --> x             12
///   |       |               10   |   14         0, 4, 8, 12: the directions of sides 0 to 3
///   7       3  nodes           \ | /            2, 6, 10, 14: the diagonals
///   |       |             8 -----+----- 0       the odd ones between: (2, 1), (1, 2) and so on
///   6---5---4                  / | \
///   y                        6   |   2
///                                4              sector 0: from direction 0 to 1
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::world) struct Outline {
    /// Bits 2k and 2k + 1: whether the first and the second half of side k, as the side runs, bound
    /// the solid.
    pub(in crate::world) edges: u8,
    /// The same bits for the tile across: which halves of its side k this tile covers, from the
    /// other side and in the opposite direction.
    pub(in crate::world) covers: u8,
    /// The inner piece: its first node, and its last one in the high nibble.
    ends: u8,
    /// The direction in which it ends, and its [`InnerKind`] in the high nibble.
    last: u8,
    /// Nibble k: which of the sectors 4k to 4k + 3 are solid at corner k (node 2k). Nibble 4 + k:
    /// whether an arc ends there. Bit 0 if it leaves the line of side k, bit 1 if it leaves that of
    /// the side before. Solid across that line is not joined to this tile.
    corners: u32,
    /// Byte k: which of the sectors 4k to 4k + 7 are solid at the middle of side k (node 2k + 1).
    middles: u32,
}

/// The piece of a tile's border that is not on its cell's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::world) enum InnerKind {
    None,
    Line,
    Convex,
    Concave,
}

/// From node to node, with the solid on its left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::world) struct Piece {
    pub(in crate::world) start: u8,
    pub(in crate::world) end: u8,
    /// The direction in which it ends: of a line its own, of an arc the tangent.
    pub(in crate::world) dir: u8,
}

/// By discriminant. Empty and one-way tiles have no solid.
static OUTLINES: [Outline; 38] = outlines();

impl TileShape {
    #[inline]
    #[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
    pub(in crate::world) const fn outline(self) -> &'static Outline {
        let [nothing, ..] = &OUTLINES;
        // The table has every shape: the program never takes the other branch.
        let id = self as usize;
        if id < OUTLINES.len() { &OUTLINES[id] } else { nothing }
    }
}

impl Outline {
    /// The nibbles of corner `k`, in their places.
    #[inline]
    pub(in crate::world) const fn corner(&self, k: u8) -> u32 {
        self.corners & 0x000f_000f << (4 * (k & 3))
    }

    /// The sectors at the middle of side `k`: bit i is sector 4k + i.
    #[inline]
    pub(in crate::world) const fn middle(&self, k: u8) -> u8 {
        (self.middles >> (8 * (k & 3))) as u8
    }

    /// Which halves of side `k` are solid: bit 0 the first half as the side runs.
    #[inline]
    pub(in crate::world) const fn halves(&self, k: u8) -> u8 {
        self.edges >> (2 * (k & 3)) & 3
    }

    pub(in crate::world) const fn inner_kind(&self) -> InnerKind {
        match self.last >> 4 {
            0 => InnerKind::None,
            1 => InnerKind::Line,
            2 => InnerKind::Convex,
            _ => InnerKind::Concave,
        }
    }

    pub(in crate::world) const fn inner_piece(&self) -> Piece {
        Piece { start: self.ends & 7, end: self.ends >> 4 & 7, dir: self.last & 15 }
    }
}

/// From the nibbles of the four tiles around a corner: the directions in which solid lies on both
/// sides and is not joined. Along side k that is 4k, back along the side before it 4k + 4.
#[inline]
pub(in crate::world) const fn gaps(around: u32) -> u16 {
    let marks = (around >> 16) as u16;
    marks & 0x1111 | (marks & 0x2222).rotate_left(3)
}

/// The continuation of a border tile beyond the map. `k` is the side; `corner` selects the corner
/// where it begins.
///
/// A band is as solid as the tile's edge, and a half edge gives half a band. A one-way tile
/// continues along its edge. A corner region is solid if both half edges that meet there are.
pub(in crate::world) const fn beyond(kind: TileKind, k: u8, corner: bool) -> TileKind {
    let outline = kind.shape.outline();
    let halves = outline.halves(k);
    let shape = if corner {
        let before = outline.halves(k.wrapping_sub(1));
        if halves & 1 != 0 && before & 2 != 0 { TileShape::Full } else { TileShape::Empty }
    } else if let Some(side) = kind.one_way_side() {
        if (side ^ k) & 1 != 0 { kind.shape } else { TileShape::Empty }
    } else {
        match (halves, k & 3) {
            (0, _) => TileShape::Empty,
            (1, 1) | (2, 3) => TileShape::HalfTop,
            (1, 2) | (2, 0) => TileShape::HalfRight,
            (1, 3) | (2, 1) => TileShape::HalfBottom,
            (1 | 2, _) => TileShape::HalfLeft,
            _ => TileShape::Full,
        }
    };
    TileKind { shape, flags: kind.flags }
}

/// The x of directions 0 to 15; y is that of the direction a right angle before.
const X: [i8; 16] = [1, 2, 1, 1, 0, -1, -1, -2, -1, -2, -1, -1, 0, 1, 1, 2];

/// Direction `d`, modulo a full turn.
#[inline]
#[expect(clippy::indexing_slicing, reason = "masked to the table's length")]
pub(in crate::world) const fn direction(d: u8) -> Axis {
    Axis::new(X[(d & 15) as usize] as i32, X[(d.wrapping_add(12) & 15) as usize] as i32)
}

/// The column of half cells, 0 to 2, of each node from the last to the first; the row is that of
/// two nodes before.
const COLUMNS: u16 = 0b00_00_01_10_10_10_01_00;

/// Column and row of half cells of a node, each 0 to 2.
#[inline]
pub(in crate::world) const fn place(node: u8) -> (u8, u8) {
    let node = node & 7;
    ((COLUMNS >> (2 * node) & 3) as u8, (COLUMNS >> (2 * (node.wrapping_add(6) & 7)) & 3) as u8)
}

/// A point in quarters of a cell against the inequality of a form: below 0 inside, above outside.
/// On the border (0), the second number is the direction's: in or out.
const fn side_of(form: Form, x: i32, y: i32, (dx, dy): (i32, i32)) -> (i32, i32) {
    let (u, du) = if form.right { (4 - x, -dx) } else { (x, dx) };
    let (v, dv) = if form.bottom { (4 - y, -dy) } else { (y, dy) };
    match form.kind {
        FormKind::Empty => (1, 0),
        FormKind::Full => (-1, 0),
        FormKind::Line { p, q, k } => (p as i32 * u + q as i32 * v - 2 * k as i32, p as i32 * du + q as i32 * dv),
        FormKind::Convex => (u * u + v * v - 16, u * du + v * dv),
        FormKind::Concave => (16 - (4 - u) * (4 - u) - (4 - v) * (4 - v), (4 - u) * du + (4 - v) * dv),
    }
}

/// Whether a sector at a node is solid: whether its middle direction leads in.
const fn solid(form: Form, node: u8, sector: u8) -> bool {
    let (i, j) = place(node);
    let (a, b) = (direction(sector), direction(sector + 1));
    let (side, turn) = side_of(form, 2 * i as i32, 2 * j as i32, (a.x + b.x, a.y + b.y));
    side < 0 || side == 0 && turn < 0
}

/// The direction in which a piece arrives at `b`: of a line its own, of an arc the perpendicular of
/// the normal there.
const fn last_direction(kind: InnerKind, a: (i32, i32), b: (i32, i32), centre: (i32, i32)) -> u8 {
    let way = match kind {
        InnerKind::Convex => Axis::new(centre.1 - b.1, b.0 - centre.0),
        InnerKind::Concave => Axis::new(b.1 - centre.1, centre.0 - b.0),
        _ => Axis::new(b.0 - a.0, b.1 - a.1),
    };
    let mut d = 0;
    while direction(d).perp_dot(way) != 0 || direction(d).dot(way) <= 0 {
        d += 1;
    }
    d
}

/// The two nodes where the form's border meets that of the cell, in the order that leaves the solid
/// corner on the left.
const fn inner(form: Form) -> (InnerKind, Piece) {
    let kind = match form.kind {
        FormKind::Empty | FormKind::Full => return (InnerKind::None, Piece { start: 0, end: 0, dir: 0 }),
        FormKind::Line { .. } => InnerKind::Line,
        FormKind::Convex => InnerKind::Convex,
        FormKind::Concave => InnerKind::Concave,
    };
    let corner = (2 * form.right as i32, 2 * form.bottom as i32);
    let centre = if matches!(kind, InnerKind::Concave) { (2 - corner.0, 2 - corner.1) } else { corner };
    let mut piece = Piece { start: 0, end: 0, dir: 0 };
    while piece.start < 8 {
        piece.end = 0;
        while piece.end < 8 {
            let ((ax, ay), (bx, by)) = (place(piece.start), place(piece.end));
            let (a, b) = ((ax as i32, ay as i32), (bx as i32, by as i32));
            let (at_a, _) = side_of(form, 2 * a.0, 2 * a.1, (0, 0));
            let (at_b, _) = side_of(form, 2 * b.0, 2 * b.1, (0, 0));
            let left = (b.0 - a.0) * (corner.1 - a.1) - (b.1 - a.1) * (corner.0 - a.0);
            if at_a == 0 && at_b == 0 && left > 0 {
                piece.dir = last_direction(kind, a, b, centre);
                return (kind, piece);
            }
            piece.end += 1;
        }
        piece.start += 1;
    }
    (InnerKind::None, piece)
}

const fn outline(form: Form) -> Outline {
    let (mut edges, mut corners, mut middles) = (0u8, 0, 0);
    let mut k = 0;
    while k < 4 {
        let (corner, middle, next) = (2 * k, 2 * k + 1, (2 * k + 2) & 7);
        let ((ax, ay), (mx, my), (bx, by)) = (place(corner), place(middle), place(next));
        // The middles of the halves. No form's border passes through one.
        if side_of(form, (ax + mx) as i32, (ay + my) as i32, (0, 0)).0 < 0 {
            edges |= 1 << (2 * k);
        }
        if side_of(form, (bx + mx) as i32, (by + my) as i32, (0, 0)).0 < 0 {
            edges |= 2 << (2 * k);
        }
        let mut i = 0;
        while i < 8 {
            if i < 4 && solid(form, corner, 4 * k + i) {
                corners |= 1 << (4 * k + i);
            }
            if solid(form, middle, 4 * k + i) {
                middles |= 1 << (8 * k + i);
            }
            i += 1;
        }
        k += 1;
    }
    k = 0;
    while k < 4 {
        // A solid quarter at a corner whose border line is not solid: the arc leaves that line
        // slowly.
        let before = (k + 3) & 3;
        if corners >> (4 * k) & 15 == 15 && edges >> (2 * k) & 1 == 0 {
            corners |= 1 << (16 + 4 * k);
        }
        if corners >> (4 * k) & 15 == 15 && edges >> (2 * before) & 2 == 0 {
            corners |= 2 << (16 + 4 * k);
        }
        k += 1;
    }
    // Side k faces side k + 2, whose first half is its second.
    let across = edges.rotate_left(4);
    let covers = across >> 1 & 0x55 | across << 1 & 0xaa;
    let (kind, piece) = inner(form);
    Outline { edges, covers, ends: piece.start | piece.end << 4, last: piece.dir | (kind as u8) << 4, corners, middles }
}

#[expect(clippy::indexing_slicing, reason = "runs in the compiler")]
const fn outlines() -> [Outline; 38] {
    let mut out = [outline(TileShape::Empty.form()); 38];
    let mut id = 0;
    while id < out.len() {
        out[id] = outline(TileShape::ALL[id].form());
        id += 1;
    }
    out
}
