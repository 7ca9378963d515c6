//! Boxes that move frame by frame. The density does not depend on their number.

use tilesat_judge::Random;
use tilesat_judge::oracle::figure::Point;
use tilesat_judge::oracle::generate::UNIT;

/// Corners, raw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    pub lo: Point,
    pub hi: Point,
}

/// Converts a raw position to pixels.
pub fn px(raw: i64) -> f32 {
    (raw as f64 / 65536.0) as f32
}

pub type Frame = Vec<Bounds>;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Anywhere, with 64 x 64 pixels per box. At most 2 pixels per frame.
    Scattered,
    /// The same, and three in a hundred jump anywhere.
    Leaping,
    /// 32 in each clump of 128 x 128 pixels, and nothing between the clumps.
    Clumps,
    /// Scattered, with one resting box of half the scene's side.
    Huge,
    /// Sides from 4 to 512 pixels, half as many of twice the side. One box in sixteen moves.
    Uneven,
    /// 32 on top of each other, within 2 raw units of touching. The columns sway.
    Columns,
}

#[derive(Clone, Copy, Debug)]
pub struct Class {
    pub kind: Kind,
    pub bodies: usize,
    /// The first corner of the scene, in pixels.
    pub origin: i64,
}

const fn class(kind: Kind, bodies: usize, origin: i64) -> Class {
    Class { kind, bodies, origin }
}

pub const CLASSES: [Class; 20] = [
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
    class(Kind::Clumps, 64, 0),
    class(Kind::Clumps, 256, 0),
    class(Kind::Clumps, 1024, 0),
    class(Kind::Huge, 256, 0),
    class(Kind::Huge, 1024, 0),
    class(Kind::Uneven, 256, 0),
    class(Kind::Uneven, 1024, 0),
];

/// Boxes per column.
const HIGH: usize = 32;

impl Class {
    pub fn name(self) -> String {
        let what = match self.kind {
            Kind::Scattered => "boxes",
            Kind::Leaping => "boxes that leap",
            Kind::Columns => "boxes in columns",
            Kind::Clumps => "boxes in clumps",
            Kind::Huge => "boxes and a huge one",
            Kind::Uneven => "boxes of uneven size",
        };
        let place = if self.origin > 0 { format!(" {} px from the origin", self.origin) } else { String::new() };
        format!("{} {what}{place}", self.bodies)
    }

    /// Whether there are boxes larger than a cell.
    pub fn has_large(self) -> bool {
        matches!(self.kind, Kind::Huge | Kind::Uneven)
    }

    /// A side of the scene in pixels.
    pub fn side(self) -> i64 {
        ((self.bodies as f64).sqrt() * 64.0).ceil() as i64
    }

    /// The side of a cell in pixels, as one would choose it: few boxes are larger. For uneven sizes
    /// it is the best of 32, 64, 128 and 256. Only regions among 256 boxes would prefer 64.
    pub fn cell(self) -> u16 {
        if self.kind == Kind::Uneven { 128 } else { 32 }
    }

    /// Cells along a side of the scene: a power of two.
    pub fn grid_columns(self) -> u16 {
        (self.side() as u64).div_ceil(self.cell().into()).next_power_of_two() as u16
    }

    pub fn frames(self, n: usize) -> Vec<Frame> {
        let mut r = Random::new(0xb0c5 + self.bodies as u64);
        let frames = match self.kind {
            Kind::Scattered | Kind::Leaping | Kind::Huge => self.scattered(&mut r, n),
            Kind::Clumps | Kind::Uneven => self.drifting(&mut r, n),
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
        if let (Kind::Huge, Some(first)) = (self.kind, bodies.first_mut()) {
            *first = Moving { at: (side / 4, side / 4), size: (side / 2, side / 2), v: (0, 0) };
        }
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

    /// Each box moves a pixel or two to and fro around a fixed position.
    fn drifting(self, r: &mut Random, n: usize) -> Vec<Frame> {
        let side = self.side() * UNIT;
        let mut clump = (0, 0);
        let bodies: Vec<(Bounds, Point)> = (0..self.bodies)
            .map(|k| {
                let most = side - 160 * UNIT;
                if k % 32 == 0 {
                    clump = (r.within(0, most), r.within(0, most));
                }
                let (at, size, moves) = if self.kind == Kind::Clumps {
                    let size = (r.within(6 * UNIT, 24 * UNIT), r.within(6 * UNIT, 24 * UNIT));
                    ((clump.0 + r.within(0, 128 * UNIT), clump.1 + r.within(0, 128 * UNIT)), size, true)
                } else {
                    // Of 256, 128 are 4 to 8 wide, 64 are 8 to 16, and so on.
                    let wide = 4 << (k + 1).trailing_zeros().min(6);
                    let size = (r.within(wide * UNIT, 2 * wide * UNIT), r.within(wide * UNIT, 2 * wide * UNIT));
                    ((r.within(0, side - size.0), r.within(0, side - size.1)), size, k % 16 == 0)
                };
                let v = if moves { (r.around(2 * UNIT), r.around(2 * UNIT)) } else { (0, 0) };
                (Bounds { lo: at, hi: (at.0 + size.0, at.1 + size.1) }, v)
            })
            .collect();
        let at = |frame: usize| {
            // Eight frames forth, eight frames back.
            let k = (frame % 16).min(16 - frame % 16) as i64;
            let place = |(b, v): &(Bounds, Point)| {
                let moved = |p: Point| (p.0 + v.0 * k, p.1 + v.1 * k);
                Bounds { lo: moved(b.lo), hi: moved(b.hi) }
            };
            bodies.iter().map(place).collect()
        };
        (0..n).map(at).collect()
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
