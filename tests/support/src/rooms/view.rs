//! Another view of a level: mirrored, turned over its diagonal, shifted.

use super::P;
use super::body::Body;
use crate::shapes::level::Level;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    MirrorX,
    MirrorY,
    Transpose,
    Moved(P),
}

impl View {
    pub fn direction(self, v: P) -> P {
        match self {
            Self::MirrorX => (-v.0, v.1),
            Self::MirrorY => (v.0, -v.1),
            Self::Transpose => (v.1, v.0),
            Self::Moved(_) => v,
        }
    }

    fn point(self, p: P) -> P {
        if let Self::Moved(by) = self { (p.0 + by.0, p.1 + by.1) } else { self.direction(p) }
    }

    pub fn body(self, b: Body) -> Body {
        match b {
            Body::Disc(c, r) => Body::Disc(self.point(c), r),
            Body::Pill(c, core, r) => Body::Pill(self.point(c), self.direction(core), r),
            Body::Rect(..) => {
                let (lo, hi) = b.bounds();
                let (p, q) = (self.point(lo), self.point(hi));
                Body::Rect((p.0.min(q.0), p.1.min(q.1)), ((p.0 - q.0).abs(), (p.1 - q.1).abs()))
            }
        }
    }

    /// Halves and one-ways go by side (top, right, bottom, left), the others by corner (top left,
    /// turning right). A slope turned over its diagonal is steep where it was mild.
    fn shape(self, id: u8) -> u8 {
        if id < 2 {
            return id;
        }
        let (group, turn) = ((id - 2) / 4, (id - 2) % 4);
        let sides = group == 0 || group == 8;
        let turn = match (self, sides) {
            (Self::MirrorX, false) => [1, 0, 3, 2][turn as usize],
            (Self::MirrorY, true) => [2, 1, 0, 3][turn as usize],
            (Self::MirrorX, true) | (Self::Transpose, false) => [0, 3, 2, 1][turn as usize],
            (Self::MirrorY, false) | (Self::Transpose, true) => [3, 2, 1, 0][turn as usize],
            (Self::Moved(_), _) => turn,
        };
        let group = match (self, group) {
            (Self::Transpose, 4) => 6,
            (Self::Transpose, 5) => 7,
            (Self::Transpose, 6) => 4,
            (Self::Transpose, 7) => 5,
            _ => group,
        };
        2 + 4 * group + turn
    }

    pub fn level(self, l: &Level) -> Level {
        let (w, h) = (l.width, l.height);
        let end = (l.x + w * l.cell, l.y + h * l.cell);
        let (size, (x, y)) = match self {
            Self::MirrorX => ((w, h), (-end.0, l.y)),
            Self::MirrorY => ((w, h), (l.x, -end.1)),
            Self::Transpose => ((h, w), (l.y, l.x)),
            Self::Moved(by) => ((w, h), (l.x + by.0, l.y + by.1)),
        };
        let from = |i: i64, j: i64| match self {
            Self::MirrorX => (w - 1 - i, j),
            Self::MirrorY => (i, h - 1 - j),
            Self::Transpose => (j, i),
            Self::Moved(_) => (i, j),
        };
        let tiles = (0..size.0 * size.1).map(|k| {
            let (i, j) = from(k % size.0, k / size.0);
            self.shape(l.tiles[(j * w + i) as usize])
        });
        Level { tiles: tiles.collect(), width: size.0, height: size.1, x, y, ..l.clone() }
    }
}
