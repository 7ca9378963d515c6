//! Rays through a grid of solid cells: the walk of Amanatides and Woo in a number format, and the
//! same in exact integers.

use crate::Scalar;
use crate::shape::Vector;

/// Square cells of a side in pixels, a power of two, one byte each: not zero is solid. A ray ends
/// outside the grid.
#[derive(Clone, Copy, Debug)]
pub struct Grid<'a, const SIDE: i32 = CELL> {
    pub cells: &'a [u8],
    pub width: i32,
    pub height: i32,
}

/// A cell as most levels have it, in pixels.
pub const CELL: i32 = 16;

impl<const SIDE: i32> Grid<'_, SIDE> {
    /// A cell in raw units, as a power of two.
    const SHIFT: u32 = 16 + SIDE.trailing_zeros();

    /// `None` outside.
    #[inline]
    pub(crate) fn solid(&self, x: i32, y: i32) -> Option<bool> {
        if x < 0 || y < 0 || x >= self.width || y >= self.height {
            return None;
        }
        self.cells.get((y * self.width + x) as usize).map(|&tile| tile != 0)
    }
}

/// The point where a ray enters the first solid cell.
#[derive(Clone, Copy, Debug)]
pub struct Hit<S> {
    /// A fraction of the motion.
    pub t: S,
    pub point: Vector<S>,
    /// Across x, or across y.
    pub across_x: bool,
}

/// One axis of the walk: the time of its next line, the time between lines, and the step.
#[inline]
fn axis<S: Scalar, const SIDE: i32>(o: S, d: S, cell: i32) -> (S, S, i32) {
    let size = S::of_int(SIDE);
    if d > S::ZERO {
        ((S::of_int((cell + 1) * SIDE) - o) / d, size / d, 1)
    } else if d < S::ZERO {
        ((S::of_int(cell * SIDE) - o) / d, size / -d, -1)
    } else {
        (S::NEVER, S::NEVER, 0)
    }
}

pub fn cast<S: Scalar, const SIDE: i32>(grid: &Grid<'_, SIDE>, o: Vector<S>, d: Vector<S>) -> Option<Hit<S>> {
    let (mut x, mut y) = (o.x.floor().div_euclid(SIDE), o.y.floor().div_euclid(SIDE));
    let (mut next_x, each_x, step_x) = axis::<S, SIDE>(o.x, d.x, x);
    let (mut next_y, each_y, step_y) = axis::<S, SIDE>(o.y, d.y, y);
    loop {
        let across_x = next_x < next_y;
        let t = if across_x { next_x } else { next_y };
        if t > S::ONE {
            return None;
        }
        if across_x {
            x += step_x;
            next_x = next_x + each_x;
        } else {
            y += step_y;
            next_y = next_y + each_y;
        }
        if grid.solid(x, y)? {
            return Some(Hit { t, point: o + d * t, across_x });
        }
    }
}

/// The point where the exact walk enters the first solid cell: at `num / den` of the motion.
#[derive(Clone, Copy, Debug)]
pub struct ExactHit {
    pub num: i32,
    pub den: i32,
    pub across_x: bool,
}

/// The distance to the next line, the length of the motion, and the step.
#[inline]
fn exact_axis<const SIDE: i32>(o: i32, d: i32) -> (i32, i32, i32) {
    let cell = 1 << Grid::<SIDE>::SHIFT;
    let low = o & (cell - 1);
    if d < 0 { (low, -d, -1) } else { (cell - low, d, 1) }
}

/// Compares products to order the lines. Through a corner it steps to the opposite cell. Motions
/// are below 2^30.
pub fn cast_exact<const SIDE: i32>(grid: &Grid<'_, SIDE>, o: (i32, i32), d: (i32, i32)) -> Option<ExactHit> {
    let shift = Grid::<SIDE>::SHIFT;
    let (mut x, mut y) = (o.0 >> shift, o.1 >> shift);
    let (mut way_x, w, step_x) = exact_axis::<SIDE>(o.0, d.0);
    let (mut way_y, h, step_y) = exact_axis::<SIDE>(o.1, d.1);
    // The sign of (time of the next line of x) - (that of y), times w h.
    let mut order = i64::from(way_x) * i64::from(h) - i64::from(way_y) * i64::from(w);
    let (each_x, each_y) = (i64::from(h) << shift, i64::from(w) << shift);
    loop {
        let (across_x, across_y) = (order <= 0, order >= 0);
        let (num, den) = if across_x && w != 0 { (way_x, w) } else { (way_y, h) };
        if num > den {
            return None;
        }
        if across_x {
            x += step_x;
            way_x += 1 << shift;
            order += each_x;
        }
        if across_y {
            y += step_y;
            way_y += 1 << shift;
            order -= each_y;
        }
        if grid.solid(x, y)? {
            return Some(ExactHit { num, den, across_x });
        }
    }
}
