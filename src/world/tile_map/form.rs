//! What part of its cell a tile's shape fills, as one inequality.

use crate::world::TileShape;

/// The solid of a tile in its own frame: `u` and `v` are the distances from the corner at which it is solid, along x and along y, both
/// 0 to a side S of the cell; `h = S / 2`.
///
/// ```text
///   corner +----> u      Line: p u + q v <= k h     p, q, k in 0..=4
///          |####/        Convex: u u + v v <= S S
///          |###/         Concave: (S - u)(S - u) + (S - v)(S - v) >= S S
///          v|#/
/// ```
///
/// All are monotone: with a point, every point of the cell nearer to the corner on both axes is in the solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    /// Where the shape is solid.
    #[expect(clippy::indexing_slicing, reason = "masked to the table's length")]
    pub(in crate::world) const fn form(self) -> Form {
        // After empty and full, groups of four: halves by their side, the others by their corner, both turning right from the top (left).
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

#[cfg(test)]
#[allow(clippy::panic, clippy::indexing_slicing, reason = "a test")]
mod tests {
    use super::{FormKind, TileShape};

    /// The twelve slopes as the corners that N++ gives them, in halves of a cell, y down.
    #[test]
    fn slopes_end_where_they_should() {
        let lines = [
            (6, (0, 2), (2, 0)),
            (7, (0, 0), (2, 2)),
            (8, (2, 0), (0, 2)),
            (9, (2, 2), (0, 0)),
            (18, (0, 1), (2, 0)),
            (19, (0, 0), (2, 1)),
            (20, (2, 1), (0, 2)),
            (21, (2, 2), (0, 1)),
            (22, (0, 2), (2, 1)),
            (23, (0, 1), (2, 2)),
            (24, (2, 0), (0, 1)),
            (25, (2, 1), (0, 0)),
            (26, (0, 2), (1, 0)),
            (27, (1, 0), (2, 2)),
            (28, (2, 0), (1, 2)),
            (29, (1, 2), (0, 0)),
            (30, (1, 2), (2, 0)),
            (31, (0, 0), (1, 2)),
            (32, (1, 0), (0, 2)),
            (33, (2, 2), (1, 0)),
            (2, (0, 1), (2, 1)),
            (3, (1, 0), (1, 2)),
            (4, (2, 1), (0, 1)),
            (5, (1, 2), (1, 0)),
        ];
        for (id, a, b) in lines {
            let form = TileShape::ALL[id].form();
            let FormKind::Line { p, q, k } = form.kind else { panic!("{id}") };
            for (x, y) in [a, b] {
                let (u, v) = (if form.right { 2 - x } else { x }, if form.bottom { 2 - y } else { y });
                assert_eq!(p * u + q * v, k, "{id} at {x}, {y}");
            }
        }
        for (id, right, bottom) in [(10, false, false), (11, true, false), (16, true, true), (17, false, true)] {
            let form = TileShape::ALL[id].form();
            assert_eq!((form.right, form.bottom), (right, bottom), "{id}");
            assert_eq!(form.kind == FormKind::Convex, id < 14);
        }
        // All shapes are there, each once.
        assert!(TileShape::ALL.iter().enumerate().all(|(i, &s)| s as usize == i));
    }
}
