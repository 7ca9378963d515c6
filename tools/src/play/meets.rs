//! Decides whether a body and the solid of a tile overlap, in whole numbers wide enough for any
//! product.

use super::figure::Figure;
use super::outline::{Outline, edges, winding};

/// Whether the interiors of a body and of the outline of the cell at `corner` overlap.
pub(super) fn meets(figure: &Figure, outline: &Outline, corner: (i64, i64), cell: i64) -> bool {
    let wide = |(x, y): (i64, i64)| (i128::from(x - corner.0), i128::from(y - corner.1));
    match *figure {
        Figure::Box { min, max } => square_meets(wide(min), wide(max), outline, i128::from(cell)),
        Figure::Disc { centre, radius } => disc_meets(wide(centre), i128::from(radius), outline, i128::from(cell)),
    }
}

type Wide = (i128, i128);

fn square_meets(min: Wide, max: Wide, outline: &Outline, cell: i128) -> bool {
    let corners = [min, (max.0, min.1), max, (min.0, max.1)];
    let (lo, hi) = ((min.0.max(0), min.1.max(0)), (max.0.min(cell), max.1.min(cell)));
    let shared = lo.0 < hi.0 && lo.1 < hi.1;
    match outline {
        Outline::Nothing => false,
        // Convex bodies overlap unless one of their sides separates them. The cell's sides have the
        // box's directions.
        Outline::Polygon(points) => {
            let along = |axis: fn(Wide) -> i128| {
                let all = points.iter().map(|&p| axis(raw(p, cell)));
                all.fold((i128::MAX, i128::MIN), |(lo, hi), v| (lo.min(v), hi.max(v)))
            };
            let ((left, right), (top, bottom)) = (along(|p| p.0), along(|p| p.1));
            let apart = left >= max.0 || right <= min.0 || top >= max.1 || bottom <= min.1;
            !apart && edges(points).all(|(a, b)| corners.iter().any(|&c| inward(points, a, b, c, cell) > 0))
        }
        Outline::Quarter(c) => {
            let (near, _) = reach(raw(*c, cell), lo, hi);
            shared && near < cell * cell
        }
        Outline::Bite(c) => {
            let (_, far) = reach(raw(*c, cell), lo, hi);
            shared && far > cell * cell
        }
    }
}

fn disc_meets(c: Wide, r: i128, outline: &Outline, cell: i128) -> bool {
    let near = |a: Wide, b: Wide| near_segment(c, r, a, b);
    match outline {
        Outline::Nothing => false,
        Outline::Polygon(points) => {
            let within = edges(points).all(|(a, b)| inward(points, a, b, c, cell) > 0);
            within || edges(points).any(|(a, b)| near(raw(a, cell), raw(b, cell)))
        }
        // In the frame of the arc's centre, with its quarter of the plane as the first.
        Outline::Quarter(at) | Outline::Bite(at) => {
            let at = raw(*at, cell);
            let first = |p: Wide| {
                ((p.0 - at.0) * if at.0 == 0 { 1 } else { -1 }, (p.1 - at.1) * if at.1 == 0 { 1 } else { -1 })
            };
            let (p, square) = (first(c), first(c).0.pow(2) + first(c).1.pow(2));
            let legs = |corner: Wide| {
                let ends = [(cell, 0), (0, cell)];
                ends.iter().any(|&end| near_segment(p, r, corner, end))
            };
            let quarter = p.0 >= 0 && p.1 >= 0;
            if matches!(outline, Outline::Quarter(_)) {
                (quarter && square < (cell + r).pow(2)) || legs((0, 0))
            } else {
                let inside = quarter && p.0 < cell && p.1 < cell && square > cell * cell;
                let arc = quarter && square <= cell * cell && (r > cell || square > (cell - r).pow(2));
                inside || arc || legs((cell, cell))
            }
        }
    }
}

/// A point of an outline, in raw units from its cell's corner. Cells are even.
fn raw(p: (i64, i64), cell: i128) -> Wide {
    (i128::from(p.0) * cell / 2, i128::from(p.1) * cell / 2)
}

/// Above 0 if `c` is on the inner side of the polygon's side from `a` to `b`.
fn inward(points: &[(i64, i64)], a: (i64, i64), b: (i64, i64), c: Wide, cell: i128) -> i128 {
    let from = raw(a, cell);
    let (dx, dy) = (i128::from(b.0 - a.0), i128::from(b.1 - a.1));
    (dx * (c.1 - from.1) - dy * (c.0 - from.0)) * i128::from(winding(points))
}

/// Whether a segment has a point nearer to `c` than `r`.
fn near_segment(c: Wide, r: i128, a: Wide, b: Wide) -> bool {
    let ((dx, dy), (ex, ey)) = ((b.0 - a.0, b.1 - a.1), (c.0 - a.0, c.1 - a.1));
    let (dot, length) = (dx * ex + dy * ey, dx * dx + dy * dy);
    if dot <= 0 {
        ex * ex + ey * ey < r * r
    } else if dot >= length {
        (c.0 - b.0).pow(2) + (c.1 - b.1).pow(2) < r * r
    } else {
        (dx * ey - dy * ex).pow(2) < r * r * length
    }
}

/// The squares of the least and of the greatest distance from a point to a box.
fn reach(from: Wide, lo: Wide, hi: Wide) -> (i128, i128) {
    let near = |v: i128, lo: i128, hi: i128| (lo - v).max(v - hi).max(0).pow(2);
    let far = |v: i128, lo: i128, hi: i128| (lo - v).abs().max((hi - v).abs()).pow(2);
    (near(from.0, lo.0, hi.0) + near(from.1, lo.1, hi.1), far(from.0, lo.0, hi.0) + far(from.1, lo.1, hi.1))
}
