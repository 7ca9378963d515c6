//! The points of two shapes that are nearest to each other, and the point of a shape that is
//! nearest to any point.

use super::across::normal;
use super::face::{Facing, face};
use super::place::NearestPart;
use super::short_place::place_of;
use super::walk::{Core, PolygonSide};
use crate::num::{Axis, Raw, toward};
use crate::query::closest::on_segment;

/// A point of A and one of B, where they do not touch.
pub(super) fn closest_points(a: Core<'_>, b: Core<'_>) -> Option<(Raw, Raw)> {
    let place = place_of(a, b);
    if place.within::<true>(a.radius.wrapping_add(b.radius)) {
        return None;
    }
    // On the cores, and the exact direction from A to B.
    let (p, q, n) = match place {
        NearestPart::Inside => return None,
        NearestPart::Corner(corner) => (a.corner(corner.a), b.corner(corner.b), corner.at.reversed()),
        NearestPart::Side(side, _) => {
            let (p, q) = beside(&side, a, b);
            (p, q, normal(side.edge))
        }
    };
    let out = |radius: i32| if radius == 0 { Raw::ZERO } else { toward(n, radius) };
    Some((p.add(out(a.radius)), q.sub(out(b.radius))))
}

/// The direction from A to B between the points of their cores that are nearest to each other: the
/// one that leaves most room. A side's is its normal, of length one along x and y.
pub(crate) fn between(a: Core<'_>, b: Core<'_>) -> Option<Axis> {
    match place_of(a, b) {
        NearestPart::Inside => None,
        NearestPart::Corner(corner) => Some(Axis::new(corner.at.x, corner.at.y).reversed()),
        NearestPart::Side(side, _) if side.of_a => Some(a.facing_normal(side.a).reversed()),
        NearestPart::Side(side, _) => Some(b.facing_normal(side.b)),
    }
}

/// A corner and its foot, or one of the pairs of two parallel sides.
fn beside(side: &PolygonSide, a: Core<'_>, b: Core<'_>) -> (Raw, Raw) {
    let ((p, q), (s, t)) = (face(a, side.a), face(b, side.b));
    if !side.of_a {
        return (p, on_segment(p, s, t));
    }
    if !side.of_b {
        return (on_segment(s, p, q), s);
    }
    let facing = Facing::of(side, a, b);
    let at = if side.edge.x == 0 || side.edge.y == 0 { facing.middle().0 } else { facing.first_end() };
    (on_segment(at, p, q), on_segment(at, s, t))
}
