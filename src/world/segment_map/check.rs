//! What paths must be, and the grid that they need.

use super::orient::{area_sign, edges, point};
use super::{Path, SegmentMapError};
use crate::error::Quantity;
use crate::num::{DOMAIN, Fx, Raw, Vec2};
use crate::world::Grid;

/// The box of all points, if every path is one.
#[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
pub(super) const fn bounds(paths: &[Path<'_>]) -> Result<(Raw, Raw), SegmentMapError> {
    let (mut lo, mut hi) = (Raw { x: DOMAIN, y: DOMAIN }, Raw { x: -DOMAIN, y: -DOMAIN });
    let mut i = 0;
    while i < paths.len() {
        let path = &paths[i];
        let count = path.points.len();
        if count < if path.kind.is_polygon() { 3 } else { 2 } {
            return Err(SegmentMapError::TooFewPoints { path: i as u32, points: count as u32 });
        }
        let mut k = 0;
        while k < count {
            let p = point(path, k);
            if let Some((what, value)) = outside(p) {
                return Err(SegmentMapError::OutOfDomain { path: i as u32, point: k as u32, what, value });
            }
            lo = Raw { x: if p.x < lo.x { p.x } else { lo.x }, y: if p.y < lo.y { p.y } else { lo.y } };
            hi = Raw { x: if p.x > hi.x { p.x } else { hi.x }, y: if p.y > hi.y { p.y } else { hi.y } };
            let next = point(path, k + 1);
            if k < edges(path) && p.x == next.x && p.y == next.y {
                return Err(SegmentMapError::ZeroLength { path: i as u32, point: k as u32 });
            }
            k += 1;
        }
        if path.kind.is_polygon() && area_sign(path) == 0 {
            return Err(SegmentMapError::NoArea { path: i as u32 });
        }
        i += 1;
    }
    if i == 0 { Err(SegmentMapError::Empty) } else { Ok((lo, hi)) }
}

const fn outside(p: Raw) -> Option<(Quantity, i32)> {
    if p.x <= -DOMAIN || p.x >= DOMAIN {
        Some((Quantity::X, p.x))
    } else if p.y <= -DOMAIN || p.y >= DOMAIN {
        Some((Quantity::Y, p.y))
    } else {
        None
    }
}

/// The cells of side `cell` that hold a box: from its first corner on, save where they would leave the domain.
pub(super) const fn grid(lo: Raw, hi: Raw, cell: Fx) -> Result<Grid, SegmentMapError> {
    // The side is checked before it divides.
    if let Err(e) = Grid::new(1, 1, cell, Vec2::ZERO) {
        return Err(SegmentMapError::Grid(e));
    }
    let ((x, width), (y, height)) = (axis(lo.x, hi.x, cell.to_bits()), axis(lo.y, hi.y, cell.to_bits()));
    match Grid::new(width, height, cell, Vec2::from_raw(x, y)) {
        Ok(grid) => Ok(grid),
        Err(e) => Err(SegmentMapError::Grid(e)),
    }
}

/// The origin and the count, at least 1, along an axis; a count that is too large for any grid saturates.
const fn axis(lo: i32, hi: i32, cell: i32) -> (i32, u16) {
    let size = hi.wrapping_sub(lo) as u32;
    let count = match size.wrapping_add(cell as u32).wrapping_sub(1).checked_div(cell as u32) {
        Some(0) | None => 1,
        Some(count) => count,
    };
    // Less than a cell more than the size: below 2^31.
    let last = (DOMAIN - 1).wrapping_sub(count.wrapping_mul(cell as u32) as i32);
    (if lo < last { lo } else { last }, if count > u16::MAX as u32 { u16::MAX } else { count as u16 })
}

/// Whether every point is on a given grid.
#[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
pub(super) const fn on_grid(paths: &[Path<'_>], grid: &Grid) -> Result<(), SegmentMapError> {
    let (lo, hi) = (Raw::of(grid.origin()), Raw::of(grid.end()));
    let mut i = 0;
    while i < paths.len() {
        let path = &paths[i];
        let mut k = 0;
        while k < path.points.len() {
            let p = point(path, k);
            if p.x < lo.x || p.y < lo.y || p.x > hi.x || p.y > hi.y {
                return Err(SegmentMapError::OutsideGrid { path: i as u32, point: k as u32 });
            }
            k += 1;
        }
        i += 1;
    }
    Ok(())
}
