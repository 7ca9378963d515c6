//! Classes of rays through a grid. No ray starts on or in the solid, so only the closed and the
//! open answer exist.

use super::level::{CELL, Level, SIDE};
use tilesat_judge::Random;

pub type Point = (i64, i64);

/// A start and a motion, raw.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub o: Point,
    pub d: Point,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// From anywhere to anywhere.
    Generic,
    /// Up to 128 pixels in any direction.
    Short,
    /// Along a line between cells.
    Lines,
    /// Through corners of cells, in small slopes.
    Corners,
    /// The same, its end moved by up to 2 raw units.
    NearCorners,
}

pub const CLASSES: [Class; 5] = [Class::Generic, Class::Short, Class::Lines, Class::Corners, Class::NearCorners];

impl Class {
    pub fn name(self) -> &'static str {
        match self {
            Self::Generic => "generic",
            Self::Short => "up to 128 px",
            Self::Lines => "on lines",
            Self::Corners => "through corners",
            Self::NearCorners => "2 raw beside corners",
        }
    }

    pub fn rays(self, level: &Level, n: usize) -> Vec<Ray> {
        let mut r = Random::new(0x4a75 + self as u64);
        let mut rays = Vec::with_capacity(n);
        while rays.len() < n {
            rays.extend(self.propose(&mut r).filter(|ray| starts_free(level, ray.o)));
        }
        rays
    }

    fn propose(self, r: &mut Random) -> Option<Ray> {
        let size = SIDE as i64 * CELL;
        let o = (r.within(1, size - 1), r.within(1, size - 1));
        let to = |end: Point, o: Point| Ray { o, d: (end.0 - o.0, end.1 - o.1) };
        let ray = match self {
            Self::Generic => to((r.within(1, size - 1), r.within(1, size - 1)), o),
            Self::Short => {
                let d = (r.around(128 << 16), r.around(128 << 16));
                if i128::from(d.0).pow(2) + i128::from(d.1).pow(2) > 1 << 46 {
                    return None;
                }
                Ray { o, d }
            }
            Self::Lines => {
                let along = r.within(1, SIDE as i64 - 1) * CELL;
                let end = r.within(1, size - 1);
                if r.one_in(2) { to((along, end), (along, o.1)) } else { to((end, along), (o.0, along)) }
            }
            Self::Corners | Self::NearCorners => {
                let corner = (r.within(1, SIDE as i64 - 1) * CELL, r.within(1, SIDE as i64 - 1) * CELL);
                let step = (r.around(8), r.around(8));
                // A fraction of the slope before the corner, so that the start is on no lattice.
                let (unit, back, on) = (CELL >> 8, r.within(1, 1 << 12), r.within(1, 1 << 14));
                let at = |k: i64| (corner.0 + step.0 * unit * k, corner.1 + step.1 * unit * k);
                let mut end = at(on);
                if self == Self::NearCorners {
                    end = (end.0 + r.around(2), end.1 + r.around(2));
                }
                to(end, at(-back))
            }
        };
        let end = (ray.o.0 + ray.d.0, ray.o.1 + ray.d.1);
        let inside = |p: Point| p.0 > 0 && p.1 > 0 && p.0 < size && p.1 < size;
        (ray.d != (0, 0) && inside(ray.o) && inside(end)).then_some(ray)
    }
}

/// None of the cells that hold the point, borders included, is solid.
fn starts_free(level: &Level, o: Point) -> bool {
    let cells = |v: i64| (v - 1).div_euclid(CELL)..=v.div_euclid(CELL);
    cells(o.0).all(|x| cells(o.1).all(|y| !level.solid(x, y)))
}
