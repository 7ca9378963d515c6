//! The input of a segment map: polygons and chains of points, their edges, and the remaining parts
//! of edges that polygons share.

use crate::error::Quantity;
use crate::num::{Axis, DOMAIN, Fx, Raw, Vec2};
use crate::world::error::SegmentMapError;
use crate::world::grid::Grid;

/// The kinds of a [`Path`].
///
/// ```text
///   Solid, either way round     Wall             OneWay, y down as on a screen
///      +-->--+                    both sides           ^      ^
///      |#####|                  +----+              +-->--+-->--+   to the right: blocks what falls on it
///      +--<--+                        `--+
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PathKind {
    /// A closed polygon, in either winding, that is solid inside.
    Solid,
    /// A closed polygon, in either winding, that removes its inside from the solids around it. A
    /// part outside of solids has edges with nothing behind them, and so have parts of polygons
    /// that cross or touch themselves. Bodies pass such edges from behind and stay there. `tilesat
    /// lint` finds them.
    Hole,
    /// An open chain without thickness that blocks from both sides. If the last point equals the
    /// first, it is a loop.
    Wall,
    /// An open chain whose faces block only bodies from their front, `(dir.y, -dir.x)`, also around
    /// the chain's convex corners. A free end carries only by its face: a body over the upper end
    /// of a slope falls past it. So end a slope with a level piece.
    OneWay,
}

impl PathKind {
    pub(super) const fn is_polygon(self) -> bool {
        matches!(self, Self::Solid | Self::Hole)
    }
}

/// A polygon or a chain of line segments, with common flags.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Path<'a> {
    /// The corners. The last one of a polygon joins the first, which is not repeated.
    pub points: &'a [Vec2],
    /// The kind of the path.
    pub kind: PathKind,
    /// The user's flags.
    pub flags: u8,
}

impl<'a> Path<'a> {
    /// A polygon or a chain without flags.
    #[must_use]
    pub const fn new(kind: PathKind, points: &'a [Vec2]) -> Self {
        Self { points, kind, flags: 0 }
    }

    /// Sets the flags that all segments of the path report.
    #[must_use]
    pub const fn with_flags(self, flags: u8) -> Self {
        Self { flags, ..self }
    }
}

/// An edge of a path, directed as its segment is.
#[derive(Clone, Copy, Debug)]
pub(super) struct PathEdge {
    pub(super) a: Raw,
    /// Reduced.
    pub(super) dir: Axis,
    /// In multiples of `dir`.
    pub(super) len: i32,
}

impl PathEdge {
    /// From `a` to `b`, which differ and are inside the domain.
    pub(super) const fn between(a: Raw, b: Raw) -> Self {
        let d = b.sub(a);
        let len = gcd(d.x.unsigned_abs(), d.y.unsigned_abs()) as i32;
        // The ends differ, so the divisor is not zero.
        match (d.x.checked_div(len), d.y.checked_div(len)) {
            (Some(x), Some(y)) => Self { a, dir: Axis::new(x, y), len },
            _ => Self { a, dir: Axis::X, len: 0 },
        }
    }

    /// The point after `t` multiples of the direction.
    pub(super) const fn at(&self, t: i32) -> Raw {
        Raw {
            x: self.a.x.wrapping_add(self.dir.x.wrapping_mul(t)),
            y: self.a.y.wrapping_add(self.dir.y.wrapping_mul(t)),
        }
    }
}

/// Euclid's algorithm. It takes 45 rounds at most, for neighbouring Fibonacci numbers below 2^31.
pub(super) const fn gcd(mut a: u32, mut b: u32) -> u32 {
    while let Some(rest) = a.checked_rem(b) {
        (a, b) = (b, rest);
    }
    a
}

/// The point of a path by its index, which wraps to the first one after the last.
#[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
pub(super) const fn point(path: &Path<'_>, index: usize) -> Raw {
    let points = path.points;
    if index < points.len() {
        Raw::of(points[index])
    } else if points.is_empty() {
        Raw { x: 0, y: 0 }
    } else {
        Raw::of(points[0])
    }
}

/// The number of edges.
pub(super) const fn edges(path: &Path<'_>) -> usize {
    if path.kind.is_polygon() { path.points.len() } else { path.points.len().saturating_sub(1) }
}

/// The sign of a polygon's signed area: 1 if the inside is on the left.
///
/// The triangles of the first point and an edge are below 2^61 (twice their area), and fewer than
/// 2^31. So the sum is kept as two: one of the low words and one of the high words.
pub(super) const fn area_sign(path: &Path<'_>) -> i32 {
    let first = point(path, 0);
    let (mut high, mut low) = (0i64, 0i64);
    let mut i = 1;
    while i < path.points.len() {
        let twice = point(path, i).sub(first).cross(point(path, i.wrapping_add(1)).sub(first));
        high = high.wrapping_add(twice >> 32);
        low = low.wrapping_add(twice as u32 as i64);
        i += 1;
    }
    high = high.wrapping_add(low >> 32);
    if high != 0 { high.signum() as i32 } else { (low as u32 != 0) as i32 }
}

/// Whether the segments of a path run against its points, which puts the solid on their left.
pub(super) const fn reversed(path: &Path<'_>) -> bool {
    match path.kind {
        PathKind::Solid => area_sign(path) < 0,
        PathKind::Hole => area_sign(path) > 0,
        PathKind::Wall | PathKind::OneWay => false,
    }
}

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

/// The cells of side `cell` that hold a box, from its first corner on, except where they would
/// leave the domain.
pub(super) const fn grid(lo: Raw, hi: Raw, cell: Fx) -> Result<Grid, SegmentMapError> {
    // The side is checked before the division.
    if let Err(e) = Grid::new(1, 1, cell, Vec2::ZERO) {
        return Err(SegmentMapError::Grid(e));
    }
    let ((x, width), (y, height)) = (axis(lo.x, hi.x, cell.to_bits()), axis(lo.y, hi.y, cell.to_bits()));
    match Grid::new(width, height, cell, Vec2::from_raw(x, y)) {
        Ok(grid) => Ok(grid),
        Err(e) => Err(SegmentMapError::Grid(e)),
    }
}

/// The origin and the count, at least 1, along an axis; a count that is too large for any grid
/// saturates.
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
