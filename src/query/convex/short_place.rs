//! Where the origin is relative to the sum of two shapes with few corners: the question of circles
//! and capsules.

use super::boxes::{self, Parallelogram};
use super::place::{NearestCorner, NearestPart};
use super::two_segments::TwoSegments;
use super::walk::{Core, PolygonSide};
use crate::num::{Raw, SPLIT};

/// [`NearestPart::of`], which takes half of the instructions for two segments, and a third for a
/// point.
pub(super) fn short_place_of(a: Core<'_>, b: Core<'_>) -> NearestPart {
    let place = match (a.corners.len(), b.corners.len()) {
        (2, 2) => TwoSegments::of(ends(a), ends(b)).and_then(|both| both.place()),
        (2.., 1) => of_point(a, b, true),
        (1, 2..) => of_point(b, a, false),
        (4, 4) => of_boxes(a, b),
        _ => None,
    };
    place.unwrap_or_else(|| NearestPart::of(a, b))
}

fn of_boxes(a: Core<'_>, b: Core<'_>) -> Option<NearestPart> {
    boxes::place(&Parallelogram::of(a)?, &Parallelogram::of(b)?)
}

fn ends(segment: Core<'_>) -> [Raw; 2] {
    [segment.corner(0), segment.corner(1)]
}

/// [`short_place_of`], also for the queries of levels and solids. If a product is a call, these use
/// the plain test: they would gain 2 %, for 1 000 bytes in a game with planks.
pub(super) fn place_of(a: Core<'_>, b: Core<'_>) -> NearestPart {
    if SPLIT { NearestPart::of(a, b) } else { short_place_of(a, b) }
}

/// The place of a polygon or a segment and a point, without a walk. None if the point is on the
/// border.
fn of_point(polygon: Core<'_>, point: Core<'_>, of_a: bool) -> Option<NearestPart> {
    let (mut nearest, at) = (NearestCorner::none(), point.corner(0));
    let mut begin = polygon.before(0);
    let mut from = polygon.corner(begin);
    for (end, to) in polygon.corners.iter().enumerate() {
        let to = Raw::of(*to);
        let (edge, way) = (to.sub(from), at.sub(from));
        let height = edge.cross(way);
        if height <= 0 {
            let ((i, j), end) = if of_a { ((begin, 0), (end, 0)) } else { ((0, begin), (0, end)) };
            let (from, edge) = if of_a { (way.reversed(), edge) } else { (way, edge.reversed()) };
            let side = PolygonSide { from, edge, a: i, b: j, of_a, of_b: !of_a };
            let place = nearest.add(&side, height.unsigned_abs(), end);
            if place.is_some() {
                return place.filter(|_| height != 0);
            }
        }
        (begin, from) = (end, to);
    }
    Some(nearest.place())
}
