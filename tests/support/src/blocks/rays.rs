//! The hits of a ray, from the rules: all faces of the solid, each tested separately.

use super::level::{Cell, Level};
use std::ops::RangeInclusive;
use tilesat::Outside;

/// A boundary face: between a full cell (its owner) and one that is not.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    /// Whether its normal is along y.
    pub vertical: bool,
    /// 1 or -1: the sign of the normal.
    pub normal: i64,
    pub line: i64,
    pub from: i64,
    pub to: i64,
    pub owner: (i64, i64),
}

/// A level, ready for many rays.
#[derive(Debug)]
pub struct Scene {
    pub cells: Vec<Cell>,
    pub faces: Vec<Face>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expected {
    pub num: i64,
    pub den: i64,
    pub vertical: bool,
    pub inside: bool,
    /// The cells that own an equally good face.
    pub owners: Vec<(i64, i64)>,
}

impl Scene {
    pub fn new(level: &Level) -> Self {
        let cells = level.cells();
        let mut faces = Vec::new();
        for a in &cells {
            for b in &cells {
                if !a.full || b.full {
                    continue;
                }
                let owner = (a.column, a.row);
                let (y, x) = ((a.y0, a.y1), (a.x0, a.x1));
                if a.row == b.row && (a.x1 == b.x0 || b.x1 == a.x0) {
                    let (line, normal) = if a.x1 == b.x0 { (a.x1, 1) } else { (a.x0, -1) };
                    faces.push(Face { vertical: false, normal, line, from: y.0, to: y.1, owner });
                }
                if a.column == b.column && (a.y1 == b.y0 || b.y1 == a.y0) {
                    let (line, normal) = if a.y1 == b.y0 { (a.y1, 1) } else { (a.y0, -1) };
                    faces.push(Face { vertical: true, normal, line, from: x.0, to: x.1, owner });
                }
            }
        }
        Self { cells, faces }
    }

    pub fn inside(&self, x: i64, y: i64) -> bool {
        self.cells.iter().filter(|c| c.holds(x, y)).all(|c| c.full)
    }

    /// Whether the points just after the start are inside the solid: whether all cells that contain
    /// them are full.
    fn enters(&self, o: (i64, i64), d: (i64, i64)) -> bool {
        let holds =
            |v: i64, d: i64, lo: i64, hi: i64| (v > lo || (v == lo && d >= 0)) && (v < hi || (v == hi && d <= 0));
        d != (0, 0)
            && self.cells.iter().filter(|c| holds(o.0, d.0, c.x0, c.x1) && holds(o.1, d.1, c.y0, c.y1)).all(|c| c.full)
    }

    pub fn cast(&self, o: (i64, i64), d: (i64, i64), hit_inside: bool) -> Option<Expected> {
        if self.inside(o.0, o.1) {
            if hit_inside {
                let owners = self.cells.iter().filter(|c| c.holds(o.0, o.1)).map(|c| (c.column, c.row)).collect();
                return Some(Expected { num: 0, den: 1, vertical: d.1.abs() > d.0.abs(), inside: true, owners });
            }
        } else if self.enters(o, d) {
            return self.first(o, d, true);
        }
        self.first(o, d, false)
    }

    /// The best face at the start, or the first one after it.
    fn first(&self, o: (i64, i64), d: (i64, i64), start: bool) -> Option<Expected> {
        let mut best: Option<Expected> = None;
        for face in &self.faces {
            let (along, across) = if face.vertical { ((o.1, d.1), (o.0, d.0)) } else { ((o.0, d.0), (o.1, d.1)) };
            if along.1 * face.normal >= 0 {
                continue;
            }
            // t = num / den; the other coordinate times den.
            let den = along.1.abs();
            let num = (face.line - along.0) * along.1.signum();
            if (start && num != 0) || (!start && (num <= 0 || num > den)) {
                continue;
            }
            let place = i128::from(across.0) * i128::from(den) + i128::from(across.1) * i128::from(num);
            if place < i128::from(face.from) * i128::from(den) || place > i128::from(face.to) * i128::from(den) {
                continue;
            }
            let found = Expected { num, den, vertical: face.vertical, inside: false, owners: vec![face.owner] };
            best = Some(match best {
                None => found,
                Some(mut best) => {
                    let (a, b) = (i128::from(num) * i128::from(best.den), i128::from(best.num) * i128::from(den));
                    if a < b || (a == b && best.vertical && !face.vertical) {
                        found
                    } else {
                        if a == b && best.vertical == face.vertical {
                            best.owners.push(face.owner);
                        }
                        best
                    }
                }
            });
        }
        best
    }
}

impl Expected {
    /// The coordinates of the hit, rounded toward the start.
    pub fn point(&self, o: (i64, i64), d: (i64, i64)) -> (i64, i64) {
        let part = |d: i64| (i128::from(d) * i128::from(self.num) / i128::from(self.den)) as i64;
        (o.0 + part(d.0), o.1 + part(d.1))
    }

    pub fn toi(&self) -> u32 {
        ((i128::from(self.num) << 30) / i128::from(self.den)) as u32
    }

    pub fn axis(&self, d: (i64, i64)) -> (i32, i32) {
        if self.vertical { (0, if d.1 > 0 { -1 } else { 1 }) } else { (if d.0 > 0 { -1 } else { 1 }, 0) }
    }
}

/// The cells that a ray has entered up to a hit: the first one, and one for each line crossed after
/// the start, including the last. If it crosses two at the hit, one of them may be missing.
pub fn cells_entered(level: &Level, o: (i64, i64), d: (i64, i64), num: i64, den: i64) -> RangeInclusive<u32> {
    let crossed = |line: i64, o: i64, d: i64| {
        let distance = (line - o) * d.signum();
        distance > 0 && i128::from(distance) * i128::from(den) <= i128::from(num) * i128::from(d.abs())
    };
    let count = |lines: Vec<i64>, o: i64, d: i64| {
        // Between a repeated border and its continuation there is no line. With an empty outside,
        // no line leads there.
        let last = lines.len() - 1;
        let (first, last) = match level.outside {
            Outside::Solid => (0, last),
            Outside::Edge => (1, last - 1),
            Outside::Empty => (usize::from(d < 0), last - usize::from(d > 0)),
        };
        let at_end = |l: i64| i128::from((l - o).abs()) * i128::from(den) == i128::from(num) * i128::from(d.abs());
        let all: Vec<_> =
            lines.into_iter().enumerate().filter(|&(i, l)| first <= i && i <= last && crossed(l, o, d)).collect();
        (all.len() as u32, all.iter().any(|&(_, l)| at_end(l)))
    };
    let (x, y) = (count(level.lines_x().collect(), o.0, d.0), count(level.lines_y().collect(), o.1, d.1));
    let all = 1 + x.0 + y.0;
    all - u32::from(x.1 && y.1)..=all
}
