//! Boxes that move, frame by frame, as many to the area whatever their number.

use tilesat_judge::Random;
use tilesat_judge::oracle::figure::Point;
use tilesat_judge::oracle::generate::UNIT;

/// Corners, raw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    pub lo: Point,
    pub hi: Point,
}

pub type Frame = Vec<Bounds>;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Anywhere in a square of 64 x 64 pixels for each; up to 2 pixels per frame.
    Scattered,
    /// The same, and three in a hundred jump anywhere.
    Leaping,
    /// 32 on top of each other, within 2 raw units of touching; the columns sway.
    Columns,
}

#[derive(Clone, Copy, Debug)]
pub struct Class {
    pub kind: Kind,
    pub bodies: usize,
    /// Where the scene begins, in pixels.
    pub origin: i64,
}

const fn class(kind: Kind, bodies: usize, origin: i64) -> Class {
    Class { kind, bodies, origin }
}

pub const CLASSES: [Class; 13] = [
    class(Kind::Scattered, 8, 0),
    class(Kind::Scattered, 64, 0),
    class(Kind::Scattered, 256, 0),
    class(Kind::Scattered, 1024, 0),
    class(Kind::Scattered, 4096, 0),
    class(Kind::Scattered, 1024, 6000),
    class(Kind::Leaping, 8, 0),
    class(Kind::Leaping, 64, 0),
    class(Kind::Leaping, 256, 0),
    class(Kind::Leaping, 1024, 0),
    class(Kind::Leaping, 4096, 0),
    class(Kind::Columns, 256, 0),
    class(Kind::Columns, 256, 7000),
];

/// Boxes in a column.
const HIGH: usize = 32;

impl Class {
    pub fn name(self) -> String {
        let what = match self.kind {
            Kind::Scattered => "boxes",
            Kind::Leaping => "boxes that leap",
            Kind::Columns => "boxes in columns",
        };
        let place = if self.origin > 0 { format!(" {} px from the origin", self.origin) } else { String::new() };
        format!("{} {what}{place}", self.bodies)
    }

    /// A side of the scene in pixels.
    pub fn side(self) -> i64 {
        ((self.bodies as f64).sqrt() * 64.0).ceil() as i64
    }

    /// Cells of 32 pixels along it: a power of two.
    pub fn grid_columns(self) -> u16 {
        (self.side() as u64).div_ceil(32).next_power_of_two() as u16
    }

    pub fn frames(self, n: usize) -> Vec<Frame> {
        let mut r = Random::new(0xb0c5 + self.bodies as u64);
        let frames = match self.kind {
            Kind::Scattered | Kind::Leaping => self.scattered(&mut r, n),
            Kind::Columns => self.columns(&mut r, n),
        };
        let by = self.origin * UNIT;
        let moved = |p: Point| (p.0 + by, p.1 + by);
        let frame = |f: Frame| f.into_iter().map(|b| Bounds { lo: moved(b.lo), hi: moved(b.hi) }).collect();
        frames.into_iter().map(frame).collect()
    }

    fn scattered(self, r: &mut Random, n: usize) -> Vec<Frame> {
        struct Moving {
            at: Point,
            size: Point,
            v: Point,
        }
        let side = self.side() * UNIT;
        let mut bodies: Vec<Moving> = (0..self.bodies)
            .map(|_| {
                let size = (r.within(6 * UNIT, 24 * UNIT), r.within(6 * UNIT, 24 * UNIT));
                let at = (r.within(0, side - size.0), r.within(0, side - size.1));
                Moving { at, size, v: (r.around(2 * UNIT), r.around(2 * UNIT)) }
            })
            .collect();
        let mut step = |b: &mut Moving| {
            if self.kind == Kind::Leaping && r.below(100) < 3 {
                b.at = (r.within(0, side - b.size.0), r.within(0, side - b.size.1));
                return;
            }
            for (at, v, size) in [(&mut b.at.0, &mut b.v.0, b.size.0), (&mut b.at.1, &mut b.v.1, b.size.1)] {
                if !(0..=side - size).contains(&(*at + *v)) {
                    *v = -*v;
                }
                *at += *v;
            }
        };
        let frame = |bodies: &[Moving]| {
            let bounds = |b: &Moving| Bounds { lo: b.at, hi: (b.at.0 + b.size.0, b.at.1 + b.size.1) };
            bodies.iter().map(bounds).collect()
        };
        (0..n)
            .map(|_| {
                bodies.iter_mut().for_each(&mut step);
                frame(&bodies)
            })
            .collect()
    }

    fn columns(self, r: &mut Random, n: usize) -> Vec<Frame> {
        let size = 16 * UNIT;
        let mut sway = vec![0; self.bodies / HIGH];
        (0..n)
            .map(|_| {
                sway.iter_mut().for_each(|x| *x = (*x + r.around(UNIT)).clamp(-4 * UNIT, 4 * UNIT));
                let mut below = 0;
                (0..self.bodies)
                    .map(|i| {
                        let (column, level) = (i / HIGH, i % HIGH);
                        let x = (8 + 32 * column as i64) * UNIT + sway[column];
                        below = if level == 0 { 8 * UNIT } else { below + size + r.around(2) };
                        Bounds { lo: (x, below), hi: (x + size, below + size) }
                    })
                    .collect()
            })
            .collect()
    }
}
