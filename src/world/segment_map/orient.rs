//! Which way round a polygon goes, and its edges in the direction that has the solid on the left.

use super::{Path, PathKind};
use crate::num::{Axis, Raw};

/// An edge of a path, directed as its segment is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) a: Raw,
    /// Reduced.
    pub(super) dir: Axis,
    /// In multiples of `dir`.
    pub(super) len: i32,
}

impl Edge {
    /// From `a` to `b`, which are not the same and inside the domain.
    pub(super) const fn between(a: Raw, b: Raw) -> Self {
        let d = b.sub(a);
        let len = gcd(d.x.unsigned_abs(), d.y.unsigned_abs()) as i32;
        // Both ends are different: the divisor is not zero.
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

/// Euclid's; 45 rounds at most, where both are neighbours of Fibonacci's below 2^31.
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

/// The sign of a polygon's signed area: 1 where the inside is on the left.
///
/// The triangles of the first point and an edge are below 2^61 (twice their area), and fewer than 2^31: the sum is kept as two, one of the
/// low words and one of the high.
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

/// Whether the segments of a path run against its points, so that the solid is on their left.
pub(super) const fn reversed(path: &Path<'_>) -> bool {
    match path.kind {
        PathKind::Solid => area_sign(path) < 0,
        PathKind::Hole => area_sign(path) > 0,
        PathKind::Wall | PathKind::OneWay => false,
    }
}
