//! The sides of two polygons one by one, each against all corners of the other polygon.
//!
//! On cores with an instruction for the product, this is for up to 64 pairs of a side and a corner.
//! It takes about half of what a walk around the sum takes.

use super::nearness::{Least, Nearness, Unsure};
use super::walk::{Core, PolygonSide};
use crate::num::{Raw, SPLIT, Vec2};
use core::mem::replace;

/// Whether two shapes are polygons with few sides, on a core with such a product.
pub(super) const fn are_few(a: Core<'_>, b: Core<'_>) -> bool {
    let (n, m) = (a.corners.len(), b.corners.len());
    !SPLIT && n > 2 && m > 2 && n.saturating_mul(m) <= 64
}

/// How far a point is on the left of a line through the origin along an edge, times its length.
/// Below 2^60.
fn left_of(edge: Raw, p: Vec2) -> i64 {
    edge.cross(Raw::of(p))
}

/// Whether a corner of the other polygon is inside of a side, or on it.
#[inline(always)]
pub(super) fn reaches<const CLOSED: bool>(from: Raw, to: Raw, other: &[Vec2]) -> bool {
    let edge = to.sub(from);
    // On a core with 32-bit words, one word shows whether a product is negative.
    other.iter().any(|p| {
        let way = Raw::of(*p).sub(from);
        if CLOSED { edge.cross(way) >= 0 } else { way.cross(edge) < 0 }
    })
}

/// Whether two polygons overlap, or touch: none is beyond a side of the other one.
pub(super) fn meet<const CLOSED: bool>(a: Core<'_>, b: Core<'_>) -> bool {
    if let (Ok(p), Ok(q)) = (<&[Vec2; 4]>::try_from(a.corners), <&[Vec2; 4]>::try_from(b.corners)) {
        return corners_meet::<CLOSED>(p, q);
    }
    corners_meet::<CLOSED>(a.corners, b.corners)
}

#[inline(always)]
fn corners_meet<const CLOSED: bool>(a: &[Vec2], b: &[Vec2]) -> bool {
    let reach_inside = |of: &[Vec2], other: &[Vec2]| {
        let mut from = of.last().map_or(Raw::ZERO, |p| Raw::of(*p));
        of.iter().all(|to| {
            let to = Raw::of(*to);
            reaches::<CLOSED>(replace(&mut from, to), to, other)
        })
    };
    reach_inside(a, b) && reach_inside(b, a)
}

/// The side of the sum that is nearest to the origin. Parallel sides are equally near, and are one
/// side of the sum.
pub(super) fn nearest(a: Core<'_>, b: Core<'_>) -> Result<Option<PolygonSide>, Unsure> {
    let mut best = Least::new();
    for (of, other, of_a) in [(a, b, true), (b, a, false)] {
        let mut begin = of.before(0);
        let mut from = of.corner(begin);
        for (end, to) in of.corners.iter().enumerate() {
            let to = Raw::of(*to);
            let edge = to.sub(from);
            let line = edge.cross(replace(&mut from, to));
            let begin = replace(&mut begin, end);
            let most = reach(edge, other);
            let height = most.wrapping_sub(line);
            if height <= 0 {
                return Ok(None);
            }
            best.add(Nearness::of(height, edge.len2()), || (of_a, begin, edge, most))?;
        }
    }
    let (of_a, begin, edge, most) = best.get()?;
    Ok(Some(side_of(a, b, (of_a, begin, edge), most)))
}

/// The side of the sum that is a side of one shape. Only for this side is the other shape's corner
/// searched that is as far on its left.
fn side_of(a: Core<'_>, b: Core<'_>, (of_a, begin, edge): (bool, usize, Raw), most: i64) -> PolygonSide {
    let other = if of_a { b } else { a };
    let farthest = other.corners.iter().position(|p| left_of(edge, *p) == most).unwrap_or(0);
    let (i, j, edge) = if of_a { (begin, farthest, edge) } else { (farthest, begin, edge.reversed()) };
    PolygonSide { from: a.corner(i).sub(b.corner(j)), edge, a: i, b: j, of_a, of_b: !of_a }
}

/// How far the farthest corner is on the left of an edge, times its length.
fn reach(edge: Raw, of: Core<'_>) -> i64 {
    of.corners.iter().fold(i64::MIN, |most, p| most.max(left_of(edge, *p)))
}

/// The side of the sum that is the side of A or of B that begins at a corner, parallel to no other.
pub(super) fn side_from(a: Core<'_>, b: Core<'_>, of_a: bool, begin: usize) -> PolygonSide {
    let (of, other) = if of_a { (a, b) } else { (b, a) };
    let edge = of.corner(of.after(begin)).sub(of.corner(begin));
    side_of(a, b, (of_a, begin, edge), reach(edge, other))
}
