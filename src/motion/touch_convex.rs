//! The surfaces that a body with sides in any direction touches, and bodies of several parts.

use super::body::{Body, Entry, kernel::Kernel};
use super::contact::{self, Bend, Plane};
use super::plane::{NEAR, rounding, way};
use super::sweep_body::keep_first;
use crate::error::RangeError;
use crate::num::{Axis, Raw, Vec2, less128, mul64, sqr64, usqr};
use crate::query::cast::side::along;
use crate::query::{Core, meets};
use crate::shape::{Aabb, Compound, Single};
use crate::world::{Feature, Geometry, World, ends, normal};

const REACH: i32 = NEAR as i32;

/// Whether it is within a distance of a segment.
pub(super) fn is_within(core: Core<'_>, a: Raw, b: Raw, reach: i32) -> bool {
    let (near, line) = (Core { radius: core.radius.wrapping_add(reach), ..core }, [a.vec2(), b.vec2()]);
    let corners = if a == b { &line[..1] } else { &line };
    meets::<true>(near, Core { corners, radius: 0 })
}

/// Passes the planes of a feature to `plane` if the body touches it. Returns whether it does.
pub(super) fn touched(core: Core<'_>, feature: &Feature, plane: &mut dyn FnMut(Plane)) -> bool {
    let is_near = |p: Raw| is_within(core, p, p, REACH);
    match feature.geometry {
        Geometry::Face { a, dir, len, .. } => {
            let (a, b) = ends(Raw::of(a), dir, len);
            let (first, last) = core.facing(dir);
            let (first, last) = (core.corner(first), core.corner(last));
            let aside = rounding(dir) as i64;
            let over = along(dir, last.sub(a)) >= -aside && along(dir, first.sub(b)) <= aside;
            let slope = !(feature.one_way || dir.x == 0 || dir.y == 0);
            let side = [first.vec2(), last.vec2()];
            let corners = match (slope, first == last) {
                (false, _) => core.corners,
                (true, false) => &side,
                (true, true) => &side[..1],
            };
            let touches = (over || !slope) && is_within(Core { corners, ..core }, a, b, REACH);
            if touches {
                plane(Plane { normal: normal(dir), bend: if over { Bend::Flat } else { Bend::End } });
                // The free end of a one-way face is no vertex. The body's sides lead past it.
                for end in [a, b] {
                    if feature.one_way && is_near(end) {
                        around(core, end, 0, &mut |_| true, plane);
                    }
                }
            }
            touches
        }
        Geometry::Vertex { p, .. } => {
            let p = Raw::of(p);
            let near = is_near(p);
            if near {
                around(core, p, 0, &mut |_| true, plane);
            }
            near
        }
        Geometry::Arc { centre, radius, quadrant, convex } => {
            let centre = Raw::of(centre);
            let toward =
                |n: Axis| n.x.signum().wrapping_mul(quadrant.x) >= 0 && n.y.signum().wrapping_mul(quadrant.y) >= 0;
            let within = if convex {
                around(core, centre, radius, &mut |n| toward(n), plane)
            } else {
                pipe(core, centre, radius, quadrant, plane)
            };
            if within {
                return true;
            }
            // Beyond its ends an arc is a corner; of a pipe that is a feature of its own.
            let mut corner = |x: i32, y: i32| {
                let p = centre.add(Raw { x: x.wrapping_mul(radius), y: y.wrapping_mul(radius) });
                is_near(p) && (!convex || around(core, p, 0, &mut |_| true, plane))
            };
            let (first, second) = (corner(quadrant.x, 0), corner(0, quadrant.y));
            first || second
        }
    }
}

/// The planes of a point with a radius: those of the body's sides that it is at. Also that of the
/// corner, if it is at its disc. Returns whether there are any.
fn around(
    core: Core<'_>,
    p: Raw,
    radius: i32,
    counts: &mut dyn FnMut(Axis) -> bool,
    plane: &mut dyn FnMut(Plane),
) -> bool {
    let rim = radius.wrapping_add(core.radius);
    let (far, mut any) = (usqr(rim.wrapping_add(REACH) as u32), false);
    for i in 0..core.corners.len() {
        let (here, next, last) = (core.corner(i), core.corner(core.after(i)), core.corner(core.before(i)));
        let (e, m) = (next.sub(here), p.sub(here));
        // For the side that begins here: the point in front of it, beside it by the rounding at
        // most.
        let (height, foot, slack) = (e.cross(m).wrapping_neg(), e.dot(m), rounding(Axis::new(e.x, e.y)) as i64);
        let beyond = foot.wrapping_sub(e.len2() as i64);
        let near = !less128(mul64(far, e.len2()), sqr64(height.unsigned_abs()));
        if !e.is_zero() && height >= -slack && foot >= -slack && beyond <= slack && near {
            let normal = core.facing_normal(i);
            if counts(normal) {
                let bend = if foot >= 0 && beyond <= 0 { Bend::Flat } else { Bend::End };
                plane(Plane { normal, bend });
                any = true;
            }
        }
        let out = m.reversed();
        let in_cone = next.sub(here).dot(out) >= 0 && last.sub(here).dot(out) >= 0;
        if rim > 0 && !out.is_zero() && in_cone && out.len2() <= far && counts(Axis::new(out.x, out.y)) {
            plane(Plane { normal: Axis::new(out.x, out.y), bend: Bend::Convex });
            any = true;
        }
    }
    any
}

/// The tangents of a quarter pipe at the corners of the body that are at it. A corner outside of
/// the disc is behind the pipe: beside its end, where the solid between is a cusp. The outermost of
/// the corners within the rounding distance of each other stands for all, because more would fill
/// the list of ways.
fn pipe(core: Core<'_>, centre: Raw, radius: i32, quadrant: Axis, plane: &mut dyn FnMut(Plane)) -> bool {
    let room = radius.wrapping_sub(core.radius);
    if room <= 0 {
        return false;
    }
    let signs = (quadrant.x.signum() as i8, quadrant.y.signum() as i8);
    let in_disc = |m: Raw, r: i32| r >= 0 && m.len2() <= usqr(r as u32);
    let from_centre = |i: usize| core.corner(i).sub(centre);
    let is_at = |m: Raw| {
        let within = m.x.wrapping_mul(quadrant.x) >= 0 && m.y.wrapping_mul(quadrant.y) >= 0 && !m.is_zero();
        within && !in_disc(m, room.wrapping_sub(REACH + 1)) && in_disc(m, room)
    };
    let mut any = false;
    for m in (0..core.corners.len()).map(from_centre).filter(|&m| is_at(m)) {
        let hides = |other: Raw| is_at(other) && way(other.sub(m)) <= NEAR && other.len2() > m.len2();
        if !(0..core.corners.len()).map(from_centre).any(hides) {
            let normal = Axis::new(m.x.wrapping_neg(), m.y.wrapping_neg());
            plane(Plane { normal, bend: Bend::Concave { signs, room } });
            any = true;
        }
    }
    any
}

impl<S: Single + Body, const M: usize> Body for Compound<S, M> {
    fn position(&self) -> Vec2 {
        self.aabb().min()
    }
}

/// A body of several parts enters what one of them enters first, and touches what any touches.
impl<S: Single + Body, const M: usize> Kernel for Compound<S, M> {
    const MEETS_CORNERS: bool = true;
    const ANGULAR: bool = true;
    const NOTCHED: bool = true;

    fn meets_joints(&self) -> bool {
        self.parts().iter().any(Kernel::meets_joints)
    }

    fn bounds(&self) -> Aabb {
        self.aabb()
    }

    fn check_size(&self) -> Result<(), RangeError> {
        self.aabb().check_size()?;
        self.parts().iter().try_for_each(Kernel::check_size)
    }

    fn shifted(&self, d: Raw) -> Self {
        Self::shifted(self, d)
    }

    fn sweep(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let mut first = None;
        for part in self.parts() {
            keep_first(&mut first, part.sweep(d, feature).as_ref(), d);
        }
        first
    }

    fn sweep_straight(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let mut first = None;
        for part in self.parts() {
            keep_first(&mut first, part.sweep_straight(d, feature).as_ref(), d);
        }
        first
    }

    fn sweep_block(&self, d: Raw, feature: &Feature) -> Option<Entry> {
        let mut first = None;
        for part in self.parts() {
            keep_first(&mut first, part.sweep_block(d, feature).as_ref(), d);
        }
        first
    }

    fn core_box(&self) -> (Raw, Raw) {
        (self.aabb().lo(), self.aabb().hi())
    }

    /// What fills its bounds.
    fn rounding(&self) -> i32 {
        0
    }

    fn toward(&self, way: Axis) -> (Raw, i32) {
        let farthest = self.parts().iter().map(|part| part.toward(way)).max_by_key(|(p, _)| along(way, *p));
        farthest.unwrap_or((Raw::ZERO, 0))
    }

    fn met_by(&self, p: Raw, entry: &Entry) -> (Raw, i32) {
        let (step, n) = (entry.step.unwrap_or(Raw::ZERO), Raw { x: entry.normal.x, y: entry.normal.y });
        let of_part = |part: &S| {
            if S::ANGULAR { part.met_by(p, entry) } else { part.toward(entry.normal.reversed()) }
        };
        let all = self.parts().iter().map(of_part);
        let mut on_line = all.filter(|(c, _)| n.cross(c.add(step).sub(p)) == 0);
        on_line.next().unwrap_or_else(|| self.toward(entry.normal.reversed()))
    }

    fn sides_toward(&self, solid: &[Vec2], each: &mut dyn FnMut(Axis)) {
        for part in self.parts() {
            part.sides_toward(solid, each);
        }
    }

    fn touched(&self, feature: &Feature, plane: &mut dyn FnMut(Plane)) -> bool {
        let mut any = false;
        for part in self.parts() {
            any |= contact::touched_any(part, feature, &mut *plane);
        }
        any
    }

    fn is_within(&self, a: Raw, b: Raw, reach: i32) -> bool {
        self.parts().iter().any(|part| part.is_within(a, b, reach))
    }

    fn overlaps_world<W: World>(&self, world: &W) -> bool {
        world.overlaps_aabb(&self.aabb()) && self.parts().iter().any(|part| part.overlaps_world(world))
    }

    fn is_inside<W: World>(world: &W, p: Raw) -> bool {
        S::is_inside(world, p)
    }
}
