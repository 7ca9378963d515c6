//! A shape and a point that may be anywhere, and whether a shape holds another one.

use super::face::face;
use super::meets::meets;
use super::walk::Core;
use crate::num::{Fx, Raw, Vec2, check_coordinate, less128, mul64, sqr64, toward, usqr};
use crate::query::closest::{Square, from_border, on_disc, on_segment, to_segment};
use crate::query::meet::{Region, region};

/// Closed and exact. Points outside the domain are in no shape.
pub(super) fn contains(core: Core<'_>, p: Vec2) -> bool {
    check_coordinate(p).is_ok() && holds(core, p, core.radius)
}

/// Rounded down: the least of rounded distances is the rounded least. `Fx::MAX` where the core is
/// 2^31 raw away or more.
pub(super) fn distance(core: Core<'_>, p: Vec2) -> Fx {
    if contains(core, p) {
        return Fx::ZERO;
    }
    let to_sides = (0..core.corners.len()).map(|i| {
        let (a, b) = face(core, i);
        to_segment(Raw::of(p), a, b)
    });
    match to_sides.min() {
        Some(far) if far > i32::MAX as u32 => Fx::MAX,
        near => from_border(near.unwrap_or(0), core.radius),
    }
}

/// The point itself where the shape holds it.
pub(super) fn closest(core: Core<'_>, p: Vec2) -> Vec2 {
    if contains(core, p) {
        return p;
    }
    let p = Raw::of(p);
    let mut best: Option<(Square, usize)> = None;
    for i in 0..core.corners.len() {
        let (a, b) = face(core, i);
        let square = match region::<true>(p, a, b, false) {
            // Of differences below 2^31 + 2^29: the sum of squares is below 2^64.
            Region::End(end) => {
                let square = usqr(p.x.abs_diff(end.x)).wrapping_add(usqr(p.y.abs_diff(end.y)));
                Square { num: (0, square), den: 1 }
            }
            Region::Line { cross, len2 } => Square { num: sqr64(cross.unsigned_abs()), den: len2 },
        };
        if best.is_none_or(|(least, _)| square.less(least)) {
            best = Some((square, i));
        }
    }
    let (a, b) = face(core, best.map_or(0, |(_, i)| i));
    match region::<true>(p, a, b, false) {
        Region::End(end) => on_disc(p, end, core.radius).vec2(),
        Region::Line { cross, .. } => {
            let e = b.sub(a);
            let n =
                if cross > 0 { Raw { x: e.y.wrapping_neg(), y: e.x } } else { Raw { x: e.y, y: e.x.wrapping_neg() } };
            let out = if core.radius == 0 { Raw::ZERO } else { toward(n, core.radius) };
            on_segment(p, a, b).add(out).vec2()
        }
    }
}

/// Whether every point of B is one of A; closed and exact.
///
/// A convex shape is determined by its extent in every direction. So A grown by r holds B grown by
/// s if A grown by r - s holds B. If r - s is negative, A must have room for a disc of s - r around
/// every corner of B.
pub(super) fn holds_shape(a: Core<'_>, b: Core<'_>) -> bool {
    let rest = a.radius.wrapping_sub(b.radius);
    b.corners
        .iter()
        .all(|p| if rest < 0 { holds_disc(a, Raw::of(*p), rest.unsigned_abs()) } else { holds(a, *p, rest) })
}

/// Whether the core of A, grown by a radius, holds a point of the domain.
fn holds(a: Core<'_>, p: Vec2, radius: i32) -> bool {
    meets::<true>(Core { radius, ..a }, Core { corners: &[p], radius: 0 })
}

/// Whether the disc is on the left of all sides. A shape without area holds none.
fn holds_disc(a: Core<'_>, p: Raw, radius: u32) -> bool {
    let clear = |(i, from): (usize, &Vec2)| {
        let from = Raw::of(*from);
        let e = a.corner(a.after(i)).sub(from);
        // Heights below 2^61, square lengths below 2^61 and radii below 2^29.
        let height = e.cross(p.sub(from));
        height >= 0 && !less128(sqr64(height.unsigned_abs()), mul64(usqr(radius), e.len2()))
    };
    a.corners.len() > 2 && a.corners.iter().enumerate().all(clear)
}
