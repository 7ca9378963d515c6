//! Overlap and touch of boxes, circles and points with a level, from the definitions.

use super::level::{Cell, Level};

#[derive(Clone, Copy, Debug)]
pub enum Body {
    /// Corners.
    Box { x0: i64, y0: i64, x1: i64, y1: i64 },
    /// Centre and radius.
    Circle { x: i64, y: i64, r: i64 },
}

fn sqr(v: i64) -> i128 {
    i128::from(v) * i128::from(v)
}

/// The square of the distance from a point to a closed rectangle.
fn distance2(x: i64, y: i64, c: &Cell) -> i128 {
    sqr((c.x0 - x).max(x - c.x1).max(0)) + sqr((c.y0 - y).max(y - c.y1).max(0))
}

/// Whether the body has area.
pub fn has_area(body: Body) -> bool {
    match body {
        Body::Box { x0, y0, x1, y1 } => x0 < x1 && y0 < y1,
        Body::Circle { r, .. } => r > 0,
    }
}

pub fn overlaps(level: &Level, body: Body) -> bool {
    let cells = level.cells();
    match body {
        Body::Circle { x, y, r } if r > 0 => cells.iter().any(|c| c.full && distance2(x, y, c) < sqr(r)),
        Body::Circle { x, y, .. } => meets_inside(&cells, x, y, x, y),
        Body::Box { x0, y0, x1, y1 } if has_area(body) => {
            cells.iter().any(|c| c.full && x0 < c.x1 && c.x0 < x1 && y0 < c.y1 && c.y0 < y1)
        }
        Body::Box { x0, y0, x1, y1 } => meets_inside(&cells, x0, y0, x1, y1),
    }
}

/// Whether a point or segment meets the inside of the solid. The lines cut it into points and open
/// pieces, and one point represents each piece: all cells that contain it must be full. Coordinates
/// are doubled, so that the middles are integers.
fn meets_inside(cells: &[Cell], x0: i64, y0: i64, x1: i64, y1: i64) -> bool {
    let samples = |lo: i64, hi: i64, cuts: Vec<i64>| {
        let mut ends: Vec<i64> = cuts.into_iter().filter(|&v| lo < v && v < hi).chain([lo, hi]).collect();
        ends.sort_unstable();
        ends.dedup();
        let middles: Vec<i64> = ends.windows(2).map(|w| w[0] + w[1]).collect();
        ends.iter().map(|v| 2 * v).chain(middles).collect::<Vec<_>>()
    };
    let xs = samples(x0, x1, cells.iter().flat_map(|c| [c.x0, c.x1]).collect());
    let ys = samples(y0, y1, cells.iter().flat_map(|c| [c.y0, c.y1]).collect());
    let inside = |x: i64, y: i64| {
        cells.iter().filter(|c| 2 * c.x0 <= x && x <= 2 * c.x1 && 2 * c.y0 <= y && y <= 2 * c.y1).all(|c| c.full)
    };
    xs.iter().any(|&x| ys.iter().any(|&y| inside(x, y)))
}

fn touches_cell(c: &Cell, body: Body) -> bool {
    match body {
        Body::Circle { x, y, r } => distance2(x, y, c) <= sqr(r),
        Body::Box { x0, y0, x1, y1 } => x0 <= c.x1 && c.x0 <= x1 && y0 <= c.y1 && c.y0 <= y1,
    }
}

pub fn touches(level: &Level, body: Body) -> bool {
    level.cells().iter().any(|c| c.full && touches_cell(c, body))
}

pub fn flags(level: &Level, body: Body) -> u8 {
    let flags = |id: u8| if id < 3 { 0 } else { 1 << (id - 3) };
    let cells = level.cells();
    let touched = cells.iter().filter(|c| level.in_map(c.column, c.row) && touches_cell(c, body));
    touched.fold(0, |all, c| all | flags(level.id(c.column, c.row)))
}

/// The cells of the map whose inside meets a closed region. On a line, both cells beside it.
pub fn tiles_in(level: &Level, x0: i64, y0: i64, x1: i64, y1: i64) -> Vec<(i64, i64)> {
    let meets = |lo: i64, hi: i64, c0: i64, c1: i64| if lo == hi { c0 <= lo && lo <= c1 } else { lo < c1 && c0 < hi };
    let cells = level.cells();
    let met = cells
        .iter()
        .filter(|c| level.in_map(c.column, c.row) && meets(x0, x1, c.x0, c.x1) && meets(y0, y1, c.y0, c.y1));
    met.map(|c| (c.column, c.row)).collect()
}
