//! Sweeps a body with sides in any direction: an oriented box, a convex polygon, a slanted capsule.
//!
//! Against a face it is its deepest corner, or the side that is parallel to the face. A corner or
//! an arc is a point with a radius. Each side of the body is a face that this point comes to, and
//! each corner of the body a disc. The normals decide which of them is met: a disc counts only
//! between the normals of the sides beside it. So each sweep is as exact as that of a circle.

use super::body::Entry;
use super::body::kernel::Kernel;
use super::sweep_body::keep_first;
use super::sweep_face::{Face, fraction, over, sweep_face, sweep_slope};
use super::sweep_round::{comes_along, enters_along, enters_quadrant, entry, leave_pipe, leave_quarter};
use super::touch_convex::{is_within, touched};
use super::touched_plane::Plane;
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, MOTION, Raw, Toi, Vec2};
use crate::query::cast::crossing::Crossing;
use crate::query::cast::moment::{gap_time, ratio};
use crate::query::cast::side::{along, is_below, meets_beyond, reach};
use crate::query::{Core, between};
use crate::shape::{Aabb, AnyShape, Circle, Convex, ConvexPolygon, OrientedBox};
use crate::world::{ConvexBody, Feature, Geometry, World, ends, normal};

macro_rules! angular {
    ([$($n:tt)*] $body:ty) => {
        impl<$($n)*> Kernel for $body {
            const MEETS_CORNERS: bool = true;
            const ANGULAR: bool = true;

            fn meets_joints(&self) -> bool {
                false
            }

            fn bounds(&self) -> Aabb {
                self.aabb()
            }

            fn check_size(&self) -> Result<(), RangeError> {
                let corners = self.outline();
                check_size(Core { corners: &corners, radius: Convex::rounding(self) }, &self.aabb())
            }

            fn shifted(&self, d: Raw) -> Self {
                // Inside the domain by its definition.
                self.translated(d.vec2()).unwrap_or(*self)
            }

            fn sweep(&self, d: Raw, feature: &Feature) -> Option<Entry> {
                let corners = self.outline();
                sweep(Core { corners: &corners, radius: Convex::rounding(self) }, d, feature)
            }

            fn sweep_block(&self, d: Raw, feature: &Feature) -> Option<Entry> {
                self.sweep(d, feature)
            }

            fn core_box(&self) -> (Raw, Raw) {
                let (bounds, r) = (self.aabb(), Convex::rounding(self));
                (bounds.lo().add(Raw { x: r, y: r }), bounds.hi().sub(Raw { x: r, y: r }))
            }

            fn rounding(&self) -> i32 {
                Convex::rounding(self)
            }

            fn foot(&self, up: Axis, forward: Axis) -> (Raw, i32) {
                let corners = self.outline();
                Core { corners: &corners, radius: Convex::rounding(self) }.foot(up, forward)
            }

            fn toward(&self, way: Axis) -> (Raw, i32) {
                let (corners, radius) = (self.outline(), Convex::rounding(self));
                let core = Core { corners: &corners, radius };
                (core.corner(core.facing(way.perp().reversed()).0), radius)
            }

            fn met_by(&self, p: Raw, entry: &Entry) -> (Raw, i32) {
                let corners = self.outline();
                let core = Core { corners: &corners, radius: Convex::rounding(self) };
                (core.corner(met_by(core, p, entry)), core.radius)
            }

            fn sides_toward(&self, solid: &[Vec2], each: &mut dyn FnMut(Axis)) {
                let corners = self.outline();
                sides_toward(Core { corners: &corners, radius: 0 }, solid, each);
            }

            fn touched(&self, feature: &Feature, plane: &mut dyn FnMut(Plane)) -> bool {
                let corners = self.outline();
                touched(Core { corners: &corners, radius: Convex::rounding(self) }, feature, plane)
            }

            fn is_within(&self, a: Raw, b: Raw, reach: i32) -> bool {
                let corners = self.outline();
                is_within(Core { corners: &corners, radius: Convex::rounding(self) }, a, b, reach)
            }

            fn overlaps_world<W: World>(&self, world: &W) -> bool {
                let corners = self.outline();
                let core = Core { corners: &corners, radius: Convex::rounding(self) };
                world.meets_convex(&ConvexBody { core, bounds: self.aabb(), offset: Raw::ZERO }, false)
            }

            fn is_inside<W: World>(world: &W, p: Raw) -> bool {
                world.overlaps_circle(&Circle::from_raw_unchecked(p, 0))
            }
        }
    };
}

angular!([] OrientedBox);
angular!([const N: usize] ConvexPolygon<N>);
angular!([const N: usize] AnyShape<N>);

/// Refuses bodies without area, and those with a half extent of 2^28 or more.
fn check_size(core: Core<'_>, bounds: &Aabb) -> Result<(), RangeError> {
    let size = Raw::of(bounds.size());
    if core.radius == 0 && core.corners.len() < 3 {
        return Err(RangeError { what: Quantity::Area, value: size.x.min(size.y) });
    }
    let largest = size.x.max(size.y);
    if largest >> 1 < MOTION { Ok(()) } else { Err(RangeError { what: Quantity::BodySize, value: largest }) }
}

/// The directions into the sides, and the one between the nearest points: it alone is between two
/// corners.
fn sides_toward(core: Core<'_>, solid: &[Vec2], each: &mut dyn FnMut(Axis)) {
    for i in 0..core.corners.len() {
        each(core.facing_normal(i));
    }
    if let Some(n) = between(Core { corners: solid, radius: 0 }, core) {
        each(n);
    }
}

/// The corner that an entry is of: on the line through `p` along the normal, of several the first
/// against it.
fn met_by(core: Core<'_>, p: Raw, entry: &Entry) -> usize {
    let (step, n) = (entry.step.unwrap_or(Raw::ZERO), entry.normal);
    let at = |i: usize| core.corner(i).add(step).sub(p);
    let on_line = (0..core.corners.len()).filter(|&i| Raw { x: n.x, y: n.y }.cross(at(i)) == 0 && !at(i).is_zero());
    on_line.min_by_key(|&i| along(n, at(i))).unwrap_or_else(|| core.facing(n.perp()).0)
}

/// The part of a sum with a point that a motion comes through.
fn sweep(core: Core<'_>, d: Raw, feature: &Feature) -> Option<Entry> {
    match feature.geometry {
        Geometry::Face { a, dir, len, joined } => sweep_straight(core, d, &Face { a: Raw::of(a), dir, len, joined }),
        Geometry::Vertex { p, e_in, e_out } => sweep_corner(core, d, Raw::of(p), e_in, e_out),
        Geometry::Arc { centre, radius, quadrant, convex } => {
            let arc = Quarter { centre: Raw::of(centre), radius, quadrant };
            if convex { arc.sweep_bulge(core, d) } else { arc.sweep_pipe(core, d) }
        }
    }
}

/// Entry through a face. As for a box the deepest part must be over the face when it meets the
/// face's line.
///
/// A sharp corner may meet the line exactly at an end of the face. It then enters if the body,
/// which is a wedge there, is then behind the face itself: whatever continues beyond the end.
#[inline(never)]
fn sweep_straight(core: Core<'_>, d: Raw, face: &Face) -> Option<Entry> {
    let Face { a, dir, len, .. } = *face;
    if along(normal(dir), d) >= 0 {
        return None;
    }
    let (i, j) = core.facing(dir);
    let (first, last) = (core.corner(i), core.corner(j));
    if core.radius != 0 {
        return sweep_wide((first, last), core.radius, d, face);
    }
    let (gap, into) = (along(normal(dir), first.sub(a)), along(normal(dir), d).wrapping_neg());
    if gap < 0 || gap >= into {
        return None;
    }
    let b = ends(a, dir, len).1;
    let (over_start, over_end) = (last.sub(a).cross(d), first.sub(b).cross(d).wrapping_neg());
    let enters = |over: i64, corner: usize, inward: Axis| {
        over > 0 || (over == 0 && covers(core, corner, d, normal(dir), inward))
    };
    if !enters(over_start, j, dir) || !enters(over_end, i, dir.reversed()) {
        return None;
    }
    let (num, den) = fraction(gap as u64, into as u64);
    Some(Entry { num, den, normal: normal(dir), at_end: over_start == 0 || over_end == 0, step: None })
}

/// Sweeps a rounded body, which meets the face with all of a parallel side, grown by its radius.
fn sweep_wide((first, last): (Raw, Raw), r: i32, d: Raw, face: &Face) -> Option<Entry> {
    let Face { a, dir, len, .. } = *face;
    if dir.x == 0 || dir.y == 0 {
        let lo = Raw { x: first.x.min(last.x), y: first.y.min(last.y) };
        let hi = Raw { x: first.x.max(last.x), y: first.y.max(last.y) };
        return sweep_face((lo, hi), r, d, face);
    }
    // As `sweep_slope` with two points of one height.
    let normal = normal(dir);
    let (gap, into, reach) = (along(normal, first.sub(a)), along(normal, d).wrapping_neg(), reach(r, dir));
    let left = gap.wrapping_sub(into);
    if gap < 0 || is_below(gap as u64, reach) || (left >= 0 && !is_below(left as u64, reach)) {
        return None;
    }
    let b = ends(a, dir, len).1;
    if !meets_beyond(last.sub(a), d, dir, false, r) || !meets_beyond(first.sub(b), d, dir, true, r) {
        return None;
    }
    let time = gap_time(gap as u64, into as u64, reach);
    Some(Entry { num: time.raw(), den: Toi::ONE.raw(), normal, at_end: false, step: None })
}

/// Whether a sharp corner that moves by `d` through a line is then behind it in the direction `way`
/// from where it met the line. A side along the line covers that, or one that follows.
fn covers(core: Core<'_>, corner: usize, d: Raw, out: Axis, way: Axis) -> bool {
    let here = core.corner(corner);
    let is_flat = |other: usize| {
        let q = core.corner(other).sub(here);
        along(out, q) == 0 && along(way, q) > 0
    };
    is_flat(core.after(corner)) || is_flat(core.before(corner)) || follows(core, corner, d, out, way)
}

/// Whether a side beside such a corner follows it over the line, in the direction `way`.
///
/// The side leads back in front of the line. Take positions relative to the point at which the
/// corner met it. A side that leads along `q` crosses the line at `d + t q`. It does so on the side
/// of the sign of `d x q` over that of `way x q`. Below 2^58.
fn follows(core: Core<'_>, corner: usize, d: Raw, out: Axis, way: Axis) -> bool {
    let here = core.corner(corner);
    [core.after(corner), core.before(corner)].into_iter().any(|other| {
        let q = core.corner(other).sub(here);
        along(out, q) > 0 && d.cross(q).signum() == Raw { x: way.x, y: way.y }.cross(q).signum()
    })
}

/// Entry of a side through a point with a radius, to which the body's own radius is added. It is
/// where the point, as the side sees it, comes to the side.
fn sweep_side(core: Core<'_>, corner: usize, p: Raw, radius: i32, d: Raw) -> Option<Entry> {
    let a = core.corner(corner);
    let e = core.corner(core.after(corner)).sub(a);
    let back = d.reversed();
    let entry = if e.x == 0 || e.y == 0 {
        let (dir, len) = (Axis::new(e.x.signum(), e.y.signum()), e.x.wrapping_add(e.y).wrapping_abs());
        sweep_face((p, p), radius, back, &Face { a, dir, len, joined: [false; 2] })
    } else {
        sweep_slope(p, radius, back, &Face { a, dir: Axis::new(e.x, e.y), len: 1, joined: [false; 2] })
    }?;
    Some(Entry { normal: entry.normal.reversed(), ..entry })
}

/// How the disc of a radius around a corner of the body reaches a point, in the body's own cone of
/// normals there.
fn sweep_disc(core: Core<'_>, corner: usize, p: Raw, radius: i32, d: Raw) -> Option<(Raw, Crossing)> {
    let here = core.corner(corner);
    let m = here.sub(p);
    let sides = [core.before(corner), core.after(corner)].map(|other| {
        let e = core.corner(other).sub(here);
        Axis::new(e.x, e.y)
    });
    // A single corner has no sides.
    let has = |e: &&Axis| !e.is_zero();
    if !sides.iter().filter(has).all(|e| comes_along(m, d, *e)) {
        return None;
    }
    let hit = Crossing::of(m, radius, d)?;
    let inside = sides.iter().filter(has).all(|e| enters_along(m, d, *e, hit.cross, radius));
    inside.then_some((m, hit))
}

/// Entry of a sharp side through a corner, in the open cone of which its normal is.
///
/// Where a corner of the body meets it exactly, both are wedges. Two normals bound what their cones
/// share: this side's, and the nearer one of the other side's and the edge's. The motion leads from
/// one wedge into the other if it is against both.
fn sweep_sharp(core: Core<'_>, side: usize, p: Raw, d: Raw, (e_in, e_out): (Axis, Axis)) -> Option<Entry> {
    let (next, normal) = (core.after(side), core.facing_normal(side));
    let (m, n) = (p.sub(core.corner(side)), p.sub(core.corner(next)));
    let (gap, into) = (along(normal, m).wrapping_neg(), along(normal, d).wrapping_neg());
    if gap < 0 || gap >= into {
        return None;
    }
    // The point goes by -d, as the side sees it.
    let (over_start, over_end) = (m.cross(d).wrapping_neg(), n.cross(d));
    let enters = |over: i64, beside: usize, edge: Axis| {
        let other = core.facing_normal(beside);
        let bound = if other.dot(e_in) >= 0 && other.dot(e_out) <= 0 { other } else { crate::world::normal(edge) };
        over > 0 || (over == 0 && along(bound, d) < 0)
    };
    if !enters(over_start, core.before(side), e_in) || !enters(over_end, next, e_out) {
        return None;
    }
    let (num, den) = fraction(gap as u64, into as u64);
    Some(Entry { num, den, normal, at_end: over_start == 0 || over_end == 0, step: None })
}

/// Entry of a convex corner of any angle. The faces are responsible where a side is parallel to one
/// of its edges, and where a sharp corner has no side between them.
///
/// Two sides can meet it at one moment, where it comes exactly to the corner between them. Geometry
/// chooses, and not the order of the corners.
#[inline(never)]
fn sweep_corner(core: Core<'_>, d: Raw, p: Raw, e_in: Axis, e_out: Axis) -> Option<Entry> {
    let (r, mut first) = (core.radius, None);
    for i in 0..core.corners.len() {
        let normal = core.facing_normal(i);
        if along(normal, d) < 0 && normal.dot(e_in) > 0 && normal.dot(e_out) < 0 {
            let met = if r == 0 { sweep_sharp(core, i, p, d, (e_in, e_out)) } else { sweep_side(core, i, p, r, d) };
            keep_first(&mut first, met.as_ref(), d);
        }
    }
    if r == 0 || first.is_some() {
        return first;
    }
    let e_out = e_out.reversed();
    for i in 0..core.corners.len() {
        let m = core.corner(i).sub(p);
        if !comes_along(m, d, e_in) || !comes_along(m, d, e_out) {
            continue;
        }
        let Some((m, hit)) = sweep_disc(core, i, p, r, d) else { continue };
        if enters_along(m, d, e_in, hit.cross, r) && enters_along(m, d, e_out, hit.cross, r) {
            keep_first(&mut first, entry(&hit, m, d).as_ref(), d);
        }
    }
    first
}

/// An arc of a quadrant.
struct Quarter {
    centre: Raw,
    radius: i32,
    quadrant: Axis,
}

impl Quarter {
    fn holds(&self, normal: Axis) -> bool {
        normal.x.signum().wrapping_mul(self.quadrant.x) >= 0 && normal.y.signum().wrapping_mul(self.quadrant.y) >= 0
    }

    /// From an end of the arc, which the direction leads to from the centre, along the arc.
    fn inward(&self, end: Axis) -> Axis {
        if end.x == 0 { Axis::new(self.quadrant.x, 0) } else { Axis::new(0, self.quadrant.y) }
    }

    /// Entry through a convex arc, of which the centre is a point with the radius.
    #[inline(never)]
    fn sweep_bulge(&self, core: Core<'_>, d: Raw) -> Option<Entry> {
        let radius = self.radius.wrapping_add(core.radius);
        let (mut first, mut by_side) = (None, false);
        for i in 0..core.corners.len() {
            let normal = core.facing_normal(i);
            if along(normal, d) < 0 && self.holds(normal) {
                let Some(met) = sweep_side(core, i, self.centre, radius, d) else { continue };
                by_side = true;
                let flat = core.radius == 0 && (normal.x == 0 || normal.y == 0);
                let at_end = if flat { self.lands_at_end(core, i, d, normal) } else { Some(false) };
                if let Some(at_end) = at_end {
                    keep_first(&mut first, Some(&Entry { at_end, ..met }), d);
                }
            }
        }
        if by_side {
            return first;
        }
        for i in 0..core.corners.len() {
            let Some((m, hit)) = sweep_disc(core, i, self.centre, radius, d) else { continue };
            let enters = |closed| enters_quadrant(m, radius, d, self.quadrant, hit.cross, closed);
            let inside = if core.radius != 0 {
                enters(true)
            } else {
                enters(false) || (enters(true) && self.corner_covers(core, i, d))
            };
            if inside {
                keep_first(&mut first, entry(&hit, m, d).as_ref(), d);
            }
        }
        first
    }

    /// Whether a sharp side that lands flat on an end of the arc ends there itself. `None` if it
    /// is then not behind the arc.
    fn lands_at_end(&self, core: Core<'_>, side: usize, d: Raw, normal: Axis) -> Option<bool> {
        let (way, p) = (self.inward(normal), self.end(normal));
        let (i, j) = (side, core.after(side));
        let ahead = |k: usize| along(way, core.corner(k).sub(p)) as i32;
        let far = if ahead(i) > ahead(j) { i } else { j };
        let (gap, into) = (along(normal, core.corner(far).sub(p)), along(normal, d).wrapping_neg());
        let over = over(ahead(far), along(way, d) as i32, gap as i32, into as i32);
        (over > 0 || (over == 0 && covers(core, far, d, normal, way))).then_some(over == 0)
    }

    /// Whether a sharp corner that meets an end of the arc, where its way leads through it, comes
    /// to be behind the arc.
    fn corner_covers(&self, core: Core<'_>, corner: usize, d: Raw) -> bool {
        let (x, y) = (Axis::new(self.quadrant.x, 0), Axis::new(0, self.quadrant.y));
        let at = |end: Axis| self.end(end).sub(core.corner(corner)).cross(d) == 0;
        let end = if at(x) && (!at(y) || along(x, d) < 0) { x } else { y };
        covers(core, corner, d, end, self.inward(end))
    }

    fn end(&self, way: Axis) -> Raw {
        let r = self.radius;
        self.centre.add(Raw { x: way.x.wrapping_mul(r), y: way.y.wrapping_mul(r) })
    }

    /// Entry out of a quarter pipe: of the first corner that leaves it.
    #[inline(never)]
    fn sweep_pipe(&self, core: Core<'_>, d: Raw) -> Option<Entry> {
        let room = self.radius.wrapping_sub(core.radius);
        let mut first = None;
        for i in 0..core.corners.len() {
            let m = core.corner(i).sub(self.centre);
            let is_sharp = core.radius == 0 && room > 0;
            let left = if is_sharp { self.leave_by_corner(core, i, d) } else { leave_pipe(m, room, d, self.quadrant) };
            keep_first(&mut first, left.as_ref(), d);
        }
        first
    }

    /// Sweeps a sharp corner. Exactly through an end of the arc it leaves only if a side follows
    /// it. A side along the tangent there leaves the arc: the solid is a cusp between the two.
    fn leave_by_corner(&self, core: Core<'_>, corner: usize, d: Raw) -> Option<Entry> {
        let here = core.corner(corner);
        for end in [Axis::new(self.quadrant.x, 0), Axis::new(0, self.quadrant.y)] {
            let way = self.end(end).sub(here);
            if way.cross(d) != 0 || way.dot(d) < 0 || along(end, d) < 0 {
                continue;
            }
            let (made, whole) = (way.dot(d) as u64, d.len2());
            if made >= whole || !follows(core, corner, d, end.reversed(), self.inward(end)) {
                return None;
            }
            let time = ratio(made, whole);
            let normal = end.reversed();
            return Some(Entry { num: time.raw(), den: Toi::ONE.raw(), normal, at_end: true, step: Some(way) });
        }
        leave_quarter(here.sub(self.centre), self.radius, d, self.quadrant)
    }
}
