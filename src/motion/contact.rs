//! The surfaces that a body touches: the features within the rounding distance of its position.
//! Each has the direction in which it faces there, and whether the body touched it before.

use super::body::{Body, Entry, may_be_round};
use super::plane::{NEAR, Pipe, across, into, rounding, tangential};
use super::search::hull;
pub(super) use super::touched_plane::{Bend, Plane};
use crate::num::{Axis, Raw, isqrt64, umul, usqr};
use crate::query::meet;
use crate::shape::Aabb;
use crate::world::{Feature, Geometry, World, corners_of, ends, normal};

impl Plane {
    /// Whether it is the tangent of a pipe, and a way in this direction leads into the pipe. False
    /// at its ends, or if the way leads past one.
    pub(super) fn is_pipe_ahead(&self, v: Raw) -> bool {
        let is_inside = self.normal.x != 0 && self.normal.y != 0;
        is_inside && into(v, self.normal) < 0 && self.pipe().is_some_and(|pipe| pipe.is_left_along(v))
    }

    /// The pipe of this tangent.
    pub(super) fn pipe(&self) -> Option<Pipe> {
        let Bend::Concave { signs: (x, y), room } = self.bend else { return None };
        let (n, quadrant) = (self.normal, Axis::new(x.into(), y.into()));
        Some(Pipe { m: Raw { x: n.x.wrapping_neg(), y: n.y.wrapping_neg() }, r: room, quadrant })
    }
}

const REACH: i32 = NEAR as i32;

/// The box that holds all features this near to a body.
pub(super) fn surroundings(bounds: &Aabb, distance: u32) -> Aabb {
    hull(bounds, Raw::ZERO, Raw::ZERO, distance as i32 + 1)
}

/// Whether the bounds of a feature have a point in a region. Cursors return the features of all
/// cells that the region touches.
pub(super) fn reaches(feature: &Feature, region: &Aabb) -> bool {
    let (a, b) = corners_of(&feature.geometry);
    let (lo, hi) = (region.lo(), region.hi());
    let overlap = |a: i32, b: i32, lo: i32, hi: i32| a.min(b) <= hi && a.max(b) >= lo;
    overlap(a.x, b.x, lo.x, hi.x) && overlap(a.y, b.y, lo.y, hi.y)
}

/// Whether a body may reach a feature by a displacement of at most `distance` along x and y. Arcs
/// are not tested closely.
pub(super) fn may_reach<W: World, B: Body>(body: &B, feature: &Feature, distance: u32) -> bool {
    let (a, b) = match feature.geometry {
        Geometry::Face { a, dir, len, .. } => ends(Raw::of(a), dir, len),
        Geometry::Vertex { p, .. } => (Raw::of(p), Raw::of(p)),
        Geometry::Arc { .. } => return true,
    };
    // The diagonal is shorter than twice the side.
    is_within(body, a, b, distance as i32 * 2, W::BLOCKS)
}

/// Whether a body is within a distance of a segment. `straight` says that it is along x or y.
fn is_within<B: Body>(body: &B, a: Raw, b: Raw, distance: i32, straight: bool) -> bool {
    if straight { body.is_within_straight(a, b, distance) } else { body.is_within(a, b, distance) }
}

/// Whether a body is within the rounding distance of a segment. The answer does not depend on how a
/// face is cut.
fn is_near<B: Body>(body: &B, a: Raw, b: Raw, straight: bool) -> bool {
    is_within(body, a, b, REACH, straight)
}

/// Whether the part of a rounded body nearest to a face is over the face. It may be beside it by at
/// most 1 to 1.5 times the rounding distance. A body farther aside can only touch the face's end.
fn is_over<B: Body>(body: &B, a: Raw, end: Raw, dir: Axis) -> bool {
    // For a face along x or y all of the core may be nearest, for a slope one end.
    let (first, last) = if dir.x == 0 || dir.y == 0 {
        (body.toward(dir.reversed()).0, body.toward(dir).0)
    } else {
        let (nearest, _) = body.toward(dir.perp());
        (nearest, nearest)
    };
    let along = |v: Raw| dir.dot(Axis::new(v.x, v.y));
    let aside = rounding(dir) as i64;
    along(last.sub(a)) >= -aside && along(first.sub(end)) <= aside
}

/// Whether a point is in the closed disc around the origin.
fn in_disc(m: Raw, r: i32) -> bool {
    r >= 0 && meet::in_disc::<true>(m.x.unsigned_abs(), m.y.unsigned_abs(), r as u32)
}

/// Passes the planes of a feature to `plane` if the body touches the feature. Returns whether it
/// does.
///
/// A box meets corners and arcs by its corners, and either of its sides may move along them. The
/// visitor is called through a pointer: three copies took 1.5 KB of flash.
#[inline]
pub(super) fn touched<W: World, B: Body>(body: &B, feature: &Feature, plane: &mut dyn FnMut(Plane)) -> bool {
    if W::BLOCKS && !B::ANGULAR {
        return touched_straight(body, feature, true, plane);
    }
    (W::ARCS || !matches!(feature.geometry, Geometry::Arc { .. })) && touched_any(body, feature, plane)
}

/// [`touched`] in any level.
#[inline]
pub(super) fn touched_any<B: Body>(body: &B, feature: &Feature, plane: &mut dyn FnMut(Plane)) -> bool {
    if B::ANGULAR {
        body.touched(feature, plane)
    } else if matches!(feature.geometry, Geometry::Arc { .. }) {
        touched_arc(body, feature, plane)
    } else {
        touched_straight(body, feature, false, plane)
    }
}

/// [`touched`] for a face or a vertex. `straight` says that all faces are along x or y.
#[inline]
fn touched_straight<B: Body>(body: &B, feature: &Feature, straight: bool, plane: &mut dyn FnMut(Plane)) -> bool {
    match feature.geometry {
        Geometry::Face { a, dir, len, .. } => {
            let (a, end) = ends(Raw::of(a), dir, len);
            // The rest of a body may be near a slope too: beside it, or behind a wall's other side.
            // It meets the slope's end there, which has planes of its own, or nothing. Only at one
            // point does the answer not depend on how the slope is cut. The free end of a one-way
            // face has no other plane.
            let slope = !(straight || feature.one_way || dir.x == 0 || dir.y == 0);
            let near = if slope { body.faces_within(dir, (a, end), REACH) } else { is_near(body, a, end, straight) };
            let over = !B::MEETS_CORNERS || (near && is_over(body, a, end, dir));
            let touches = near && (over || !slope);
            if touches {
                let bend = if over { Bend::Flat } else { Bend::End };
                plane(Plane { normal: normal(dir), bend });
            }
            touches
        }
        Geometry::Vertex { p, .. } => is_at_corner(body, Raw::of(p), straight, plane),
        Geometry::Arc { .. } => false,
    }
}

/// [`touched`] for an arc.
#[inline(never)]
fn touched_arc<B: Body>(body: &B, feature: &Feature, plane: &mut dyn FnMut(Plane)) -> bool {
    let Geometry::Arc { centre, radius, quadrant, convex } = feature.geometry else { return false };
    let (at, r) = body.toward(if convex { quadrant.reversed() } else { quadrant });
    let m = at.sub(Raw::of(centre));
    let end = |x: i32, y: i32| Raw::of(centre).add(Raw { x: x.wrapping_mul(radius), y: y.wrapping_mul(radius) });
    let (along_x, along_y) = (end(quadrant.x, 0), end(0, quadrant.y));
    let within = m.x.wrapping_mul(quadrant.x.signum()) >= 0 && m.y.wrapping_mul(quadrant.y.signum()) >= 0;
    if within && !m.is_zero() {
        let near = if convex {
            in_disc(m, radius.wrapping_add(r).wrapping_add(REACH))
        } else {
            let room = radius.wrapping_sub(r);
            room > 0 && !in_disc(m, room.wrapping_sub(REACH + 1)) && in_disc(m, room.wrapping_add(REACH))
        };
        if near {
            if !B::MEETS_CORNERS {
                sides(plane);
            }
            if convex {
                plane(Plane { normal: Axis::new(m.x, m.y), bend: Bend::Convex });
            } else {
                let signs = (quadrant.x.signum() as i8, quadrant.y.signum() as i8);
                let bend = Bend::Concave { signs, room: radius.wrapping_sub(r) };
                plane(Plane { normal: Axis::new(m.x.wrapping_neg(), m.y.wrapping_neg()), bend });
            }
            return true;
        }
    }
    // Beyond its ends an arc is a corner. For a circle the end of a pipe is also the end of a face,
    // or a cusp, which is a separate corner.
    let mut corner = |end: Raw| {
        is_near(body, end, end, false) && (!convex && B::MEETS_CORNERS || is_at_corner(body, end, false, plane))
    };
    let (first, second) = (corner(along_x), corner(along_y));
    first || second
}

fn is_at_corner<B: Body>(body: &B, p: Raw, straight: bool, plane: &mut dyn FnMut(Plane)) -> bool {
    let near = is_near(body, p, p, straight);
    if near && B::MEETS_CORNERS {
        let (lo, hi) = body.core_box();
        let nearest = Raw { x: p.x.max(lo.x).min(hi.x), y: p.y.max(lo.y).min(hi.y) };
        let m = nearest.sub(p);
        if (lo.x < p.x && p.x < hi.x) || (lo.y < p.y && p.y < hi.y) {
            // Beside the flat side of a capsule, along which the motion is straight.
            plane(Plane::flat(Axis::new(m.x.signum(), m.y.signum())));
        } else if !m.is_zero() {
            plane(Plane { normal: Axis::new(m.x, m.y), bend: Bend::Convex });
        }
    } else if near {
        sides(plane);
    }
    near
}

fn sides(plane: &mut dyn FnMut(Plane)) {
    plane(Plane { normal: Axis::X, bend: Bend::End });
    plane(Plane { normal: Axis::Y, bend: Bend::End });
}

/// How a body came to the surface that it hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Came {
    /// It was already there: on the plane of the surface within the rounding distance, wherever the
    /// surface is cut, or on a hop.
    Lay,
    /// On a hop, but so fast that it moves around the corner or arc.
    Hopped,
    Flew,
}

/// A body that meets a convex corner or arc was on it one call ago if it left along a tangent.
/// Moving `s` along a tangent, it rises off a circle of radius `rho` by at most `s^2 / 2 rho`.
pub(super) fn came<W: World, B: Body>(body: &B, u: Raw, made: Raw, hit: &Entry, feature: &Feature) -> Came {
    if into(made, hit.normal).unsigned_abs() <= rounding(hit.normal) {
        return Came::Lay;
    }
    let mut came = Came::Flew;
    if may_be_round::<W, B>() && hit.step.is_some() {
        touched::<W, B>(body, feature, &mut |plane| came = came.min(came_to(&plane, u, made)));
    }
    came
}

fn came_to(plane: &Plane, u: Raw, made: Raw) -> Came {
    let Plane { normal: n, bend: Bend::Convex } = *plane else { return Came::Flew };
    let m = Raw { x: n.x, y: n.y };
    if is_no_hop(m, u, made) { Came::Flew } else { hops(m, across(u, n), made) }
}

/// How a body came from `m - made` to `m`, relative to the centre: `|m|` is rho, `along / |m|` is
/// the speed along the tangent.
///
/// That speed limits a hop, but it is not the hop's own. The game adds gravity before each call,
/// and for small bodies that is most of the speed. So the position shows how far the hop went. It
/// is one if the tangent turned by less than a quarter of its length.
fn hops(m: Raw, along: i64, made: Raw) -> Came {
    let (rho, was) = (isqrt64(m.len2()), isqrt64(m.sub(made).len2()));
    let (speed, most) = (tangential(along, Axis::new(m.x, m.y)), rho >> 2);
    if umul(rho, was.saturating_sub(rho).saturating_sub(NEAR)) * 2 > usqr(speed.min(most)) {
        Came::Flew
    } else if speed <= most {
        Came::Lay
    } else {
        Came::Hopped
    }
}

/// Whether it is known without a root that a body did not hop, because it was too far off, as in
/// most cases.
///
/// With the squares M of rho and W of the distance before, the gap between their roots is
/// `(W - M) / (sqrt W + sqrt M)`. For W up to 4 M that is at least `(W - M) / 3 sqrt M`. Roundings
/// and NEAR take less than 5 from it and 1 from rho. So `2 rho gap` is at least
/// `2 (W - M) / 3 - 12 sqrt M`. A hop's square is at most `|u|^2`, and a sixteenth of M. For a
/// larger W the gap is about rho or more. `sum` is at least rho.
fn is_no_hop(m: Raw, u: Raw, made: Raw) -> bool {
    let (size, sum) = (m.len2(), u64::from(m.x.unsigned_abs().wrapping_add(m.y.unsigned_abs())));
    let (before, most) = (m.sub(made).len2(), (u.len2() << 1).min(size >> 3));
    (size >= 64 && before >> 2 > size) || before > size.wrapping_add(most).wrapping_add(sum << 6)
}

#[cfg(test)]
mod tests {
    use super::{Axis, Came, Raw, across, hops, is_no_hop};
    use tilesat_judge::{Random, cases, enough};

    /// The answers without roots agree with those by roots: at all scales, also beside the limits.
    #[test]
    fn no_hop_is_told_without_roots() {
        let (mut random, mut seen, mut told) = (Random::new(17), 0u32, 0u32);
        for _ in 0..cases(400_000) {
            let (size, speed, far) = (random.within(1, 26), random.within(1, 26), random.within(1, 26));
            let mut part = |bits: i64| {
                let most = 1 << bits;
                random.around(most) as i32
            };
            let m = Raw { x: part(size), y: part(size) };
            let u = Raw { x: part(speed), y: part(speed) };
            let made = Raw { x: part(far), y: part(far) };
            if m.is_zero() {
                continue;
            }
            let along = across(u, Axis::new(m.x, m.y));
            let (hop, none) = (hops(m, along, made) != Came::Flew, is_no_hop(m, u, made));
            assert!(!(hop && none), "{m:?} by {made:?}, {u:?}");
            seen += u32::from(hop);
            told += u32::from(none);
        }
        assert!(enough(seen > 100 && told > 1000), "{seen} hops, {told} told");
    }
}
