//! The surface that a level still shows where another level covers it: the rules of
//! [`Joined`](crate::world::Joined).
//!
//! Take a body with area that is outside of both solids and touches both at a point `p`. It has a
//! tangent there: the half-plane `n . x > 0` in front of it holds neither solid. So `n` is in the
//! cone of normals of each level at `p`. At a convex corner that is the closed cone between the
//! normals of its two edges. It is one ray at a flat point, and empty at anything more solid. All
//! rules follow:
//!
//! - A vertex in the other solid is touched only within both cones. Where the other level has no
//!   corner there, that is one ray at most, along a face of it. Where it has one, the first level
//!   shows the common part of both cones, the second nothing. A common part that is a ray is the
//!   normal of a face that one of them shows.
//! - A face is touched from its front. Where the points just in front of it are in the other solid,
//!   a body reaches only its ends. A touch there belongs to a face with a free front, or to a
//!   corner. The face is hidden only where its front is covered from end to end.
//!
//! Differences are below 2^30 and reduced directions too: sums of two products are below 2^61.

use crate::num::{Axis, Raw};
use crate::query::meet;
use crate::shape::Aabb;
use crate::world::level::{Feature, Geometry, World, normal};

/// Where a level is in a pair, or in a pair of pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PartPath {
    /// The last bits of its features' sources.
    bits: u8,
    depth: u32,
    /// Which one of a list it is.
    index: u16,
}

impl PartPath {
    /// The place of a part of the level at this place: 0 for the first, 1 for the second.
    pub(super) fn of_part(self, part: u8) -> Self {
        Self { bits: self.bits | part.wrapping_shl(self.depth), depth: self.depth.wrapping_add(1), ..self }
    }

    /// The place of an item of the list at this place.
    pub(in crate::world) const fn of_item(self, index: u16) -> Self {
        Self { index, ..self }
    }

    /// The source of a feature of the level here.
    pub(super) fn source(self, own: u8) -> u8 {
        own.wrapping_shl(self.depth) | self.bits
    }
}

/// The queries of the rules to the other level. They go through a pointer, because each of the two
/// levels asks the other one. A copy of the rules for each took 1.7 KB of flash.
pub trait Beside {
    fn touches_at(&self, p: Raw) -> bool;
    fn overlaps_at(&self, p: Raw) -> bool;
    /// Visits the features near a region, until a visit returns `false`.
    fn each(&self, region: &Aabb, visit: &mut dyn FnMut(&Feature) -> bool);
}

impl<W: World> Beside for W {
    fn touches_at(&self, p: Raw) -> bool {
        self.touches_aabb(&point(p))
    }

    fn overlaps_at(&self, p: Raw) -> bool {
        self.overlaps_aabb(&point(p))
    }

    fn each(&self, region: &Aabb, visit: &mut dyn FnMut(&Feature) -> bool) {
        let mut features = self.features(region);
        while let Some(feature) = &features.next() {
            if !visit(feature) {
                return;
            }
        }
    }
}

/// The rest of a feature beside the other level; `first` says whose corner stands for both if both
/// have one. `J` is both together: without arcs, no code for them is linked.
#[inline(never)]
pub(in crate::world) fn shown<J: World>(mut feature: Feature, other: &dyn Beside, first: bool) -> Option<Feature> {
    match &mut feature.geometry {
        Geometry::Vertex { p, e_in, e_out } => {
            let p = Raw::of(*p);
            if other.touches_at(p) {
                let cone = if first { common_cone((*e_in, *e_out), p, other) } else { None };
                (*e_in, *e_out) = cone?;
            }
        }
        Geometry::Face { a, dir, len, joined } => {
            let edge = FaceSegment::new(Raw::of(*a), *dir, *len);
            if covered::<J>(&edge, other) {
                return None;
            }
            *joined =
                [joined[0] || goes_on::<J>(edge.a, *dir, 1, other), joined[1] || goes_on::<J>(edge.b, *dir, -1, other)];
        }
        // Its corners are separate vertices; the arc itself stays, covered or not.
        Geometry::Arc { .. } => {}
    }
    Some(feature)
}

pub(super) fn point(p: Raw) -> Aabb {
    Aabb::from_raw_unchecked(p, p)
}

/// The part of a corner's cone that is in the cones of the other level's corners at the same point.
/// `None` if it has no inside, or if the other level has no such cone: it is flat or concave there.
fn common_cone(cone: (Axis, Axis), p: Raw, other: &dyn Beside) -> Option<(Axis, Axis)> {
    let (mut cone, mut corners) = (Some(cone), false);
    other.each(&point(p), &mut |f| {
        if let Geometry::Vertex { p: at, e_in, e_out } = f.geometry {
            if Raw::of(at) == p {
                corners = true;
                // The cone is where n . e_in >= 0 and n . e_out <= 0.
                cone = cone.and_then(|cone| clipped(clipped(cone, e_in)?, e_out.reversed()));
            }
        }
        cone.is_some()
    });
    cone.filter(|_| corners)
}

/// The part of a cone with `n . h >= 0`, as the edges whose normals bound it. `None` if that has no
/// inside. The cone spans at most half a turn.
fn clipped((e_in, e_out): (Axis, Axis), h: Axis) -> Option<(Axis, Axis)> {
    let (start, end) = (normal(e_in).dot(h), normal(e_out).dot(h));
    if start >= 0 && end >= 0 {
        // A half turn that is bounded by the same line is in the half-plane as a whole, or not at
        // all.
        return (start > 0 || end > 0 || e_in.dot(h) > 0).then_some((e_in, e_out));
    }
    // The half-plane's own bounds are the normals of `h`, where it starts, and of `-h`, where it
    // ends.
    if start < 0 && end > 0 {
        Some((h, e_out))
    } else if start > 0 {
        Some((e_in, h.reversed()))
    } else {
        None
    }
}

/// A face's segment.
pub(super) struct FaceSegment {
    pub(super) a: Raw,
    pub(super) b: Raw,
    pub(super) dir: Axis,
    /// A lattice point near its middle.
    middle: Raw,
}

impl FaceSegment {
    pub(super) fn new(a: Raw, dir: Axis, len: i32) -> Self {
        // Both ends are inside the domain, so the products are.
        let at =
            |k: i32| Raw { x: a.x.wrapping_add(dir.x.wrapping_mul(k)), y: a.y.wrapping_add(dir.y.wrapping_mul(k)) };
        Self { a, b: at(len), dir, middle: at(len >> 1) }
    }

    fn bounds(&self) -> Aabb {
        let (lo, hi) = meet::corners(self.a, self.b);
        Aabb::from_raw_unchecked(lo, hi)
    }

    /// The distance in front of the face's line, scaled.
    fn in_front(&self, p: Raw) -> i64 {
        let d = p.sub(self.a);
        normal(self.dir).dot(Axis::new(d.x, d.y))
    }

    /// Whether a point of the face's line lies strictly between its ends.
    fn spans(&self, p: Raw) -> bool {
        let along = |from: Raw| {
            let d = p.sub(from);
            self.dir.dot(Axis::new(d.x, d.y))
        };
        along(self.a) > 0 && along(self.b) < 0
    }

    /// Whether a point lies on the face, ends included.
    pub(super) fn holds(&self, p: Raw) -> bool {
        self.in_front(p) == 0 && (p == self.a || p == self.b || self.spans(p))
    }

    /// The information of another level's face about the points just in front of this one.
    fn beside(&self, o: &Self) -> Front {
        let (from, to) = (self.in_front(o.a), self.in_front(o.b));
        let bared = match (from.signum(), to.signum()) {
            (0, 0) => {
                // On one line, in either direction: a common part is where the later start is
                // before the earlier end.
                let along = self.dir.dot(o.dir) > 0;
                let (lo, hi) = if along { (o.a, o.b) } else { (o.b, o.a) };
                let before = |p: Raw, q: Raw| self.dir.dot(Axis::new(q.x.wrapping_sub(p.x), q.y.wrapping_sub(p.y))) > 0;
                if before(lo, self.b) && before(self.a, hi) {
                    return if along { Front::Bare } else { Front::Covered };
                }
                false
            }
            (0, 1) => self.spans(o.a),
            (1, 0) => self.spans(o.b),
            // It crosses the line: between the ends where they are on different sides of it.
            (1, -1) | (-1, 1) => o.in_front(self.a).signum() * o.in_front(self.b).signum() < 0,
            _ => false,
        };
        if bared { Front::Bare } else { Front::Unknown }
    }

    /// Whether an arc can have a point in front of the face's inside. It lies in the inside of its
    /// square, except its ends.
    fn meets_arc(&self, centre: Raw, radius: i32, quadrant: Axis) -> bool {
        let (x, y) = (radius.wrapping_mul(quadrant.x), radius.wrapping_mul(quadrant.y));
        let at = |x: i32, y: i32| centre.add(Raw { x, y });
        let (lo, hi) = meet::corners(centre, at(x, y));
        let ends_on = |p: Raw| self.in_front(p) == 0 && self.spans(p);
        meet::segment_aabb::<false>(self.a, self.b, lo, hi) || ends_on(at(x, 0)) || ends_on(at(0, y))
    }
}

/// The points just in front of a face.
enum Front {
    /// Some of them are free.
    Bare,
    /// Some of them are in the other solid.
    Covered,
    Unknown,
}

/// Whether the points just in front of a face are in the other solid, from end to end.
///
/// If nothing of the other surface meets the face's inside from the front, its points are all in
/// the other solid or all outside. So one point decides: a point of the face inside the solid, or a
/// face of the other that runs against this one.
fn covered<J: World>(edge: &FaceSegment, other: &dyn Beside) -> bool {
    let points = [edge.a, edge.b, edge.middle];
    // For most faces the first end, far away, already decides.
    if !points.iter().all(|&p| other.touches_at(p)) {
        return false;
    }
    let (mut known, mut bare) = (points.iter().any(|&p| other.overlaps_at(p)), false);
    other.each(&edge.bounds(), &mut |f| {
        let front = match f.geometry {
            _ if f.one_way => Front::Unknown,
            Geometry::Face { a, dir, len, .. } => edge.beside(&FaceSegment::new(Raw::of(a), dir, len)),
            Geometry::Arc { centre, radius, quadrant, .. }
                if J::ARCS && edge.meets_arc(Raw::of(centre), radius, quadrant) =>
            {
                Front::Bare
            }
            _ => Front::Unknown,
        };
        bare = matches!(front, Front::Bare);
        known |= matches!(front, Front::Covered);
        !bare
    });
    known && !bare
}

/// Whether the points just in front of a face's end `p` are in the other solid. `along` leads from
/// there along the face, and `n` is its normal. `None` if an arc ends there, too.
///
/// The place is in the direction `along`, tilted to the front by an infinitesimal. It is on the
/// right of the part of the surface that comes next to the left.
pub(super) fn front_of_end<J: World>(p: Raw, along: Axis, n: Axis, other: &dyn Beside) -> Option<bool> {
    if !other.touches_at(p) {
        return Some(false);
    }
    let (mut next, mut at_arc): (Option<(u8, Axis, bool)>, bool) = (None, false);
    other.each(&point(p), &mut |f| {
        let edge = match f.geometry {
            Geometry::Face { a, dir, len, .. } if !f.one_way => FaceSegment::new(Raw::of(a), dir, len),
            Geometry::Arc { centre, radius, quadrant, .. } => {
                at_arc = J::ARCS && ends_at(p, Raw::of(centre), radius, quadrant);
                return !at_arc;
            }
            _ => return true,
        };
        if edge.in_front(p) != 0 {
            return true;
        }
        // A segment that leaves `p` has its solid on the left, one that arrives there on the right
        // of the way back.
        for (there, dir, solid) in
            [(edge.a == p || edge.spans(p), edge.dir, false), (edge.b == p || edge.spans(p), edge.dir.reversed(), true)]
        {
            let turn = turn(along, dir, along.perp_dot(n) < 0);
            let nearer = next.is_none_or(|(t, d, _)| turn < t || (turn == t && dir.perp_dot(d) > 0));
            if there && nearer {
                next = Some((turn, dir, solid));
            }
        }
        true
    });
    if at_arc {
        return None;
    }
    // With no surface at all it is inside.
    Some(next.is_none_or(|(_, _, solid)| solid))
}

/// How far to the left a direction is from `from`, in half turns: 0 to 4. The same direction comes
/// first or last.
fn turn(from: Axis, to: Axis, first: bool) -> u8 {
    match (from.perp_dot(to).signum(), from.dot(to) > 0) {
        (1, _) => 1,
        (0, false) => 2,
        (0, true) if first => 0,
        (0, true) => 4,
        _ => 3,
    }
}

fn ends_at(p: Raw, centre: Raw, radius: i32, quadrant: Axis) -> bool {
    let (x, y) = (radius.wrapping_mul(quadrant.x), radius.wrapping_mul(quadrant.y));
    p == centre.add(Raw { x, y: 0 }) || p == centre.add(Raw { x: 0, y })
}

/// Whether the solid continues beyond the end `p` of a face that runs along `dir`. `inward` is 1
/// for its start, -1 for its end.
///
/// It does if three conditions hold. The points in front of the face's end are free. The cones of
/// the other level's corners there omit the normals next to the face's own, which are those of the
/// corner at its end. A body reaches `p` from beyond it only along a face on the same line. (Above
/// a thin wall or a spike that ends in the face, a body reaches `p`, and the solid below would stop
/// it.)
fn goes_on<J: World>(p: Raw, dir: Axis, inward: i32, other: &dyn Beside) -> bool {
    let n = normal(dir);
    let along = Axis::new(dir.x.wrapping_mul(inward), dir.y.wrapping_mul(inward));
    if !other.touches_at(p) || front_of_end::<J>(p, along, n, other) != Some(false) {
        return false;
    }
    // The sign of `x`, or of `then` where it is zero.
    let sign = |x: i64, then: i64| if x == 0 { then.signum() } else { x.signum() };
    let (mut corners, mut cornered, mut straight) = (false, true, false);
    other.each(&point(p), &mut |f| {
        match f.geometry {
            Geometry::Vertex { p: at, e_in, e_out } if Raw::of(at) == p => {
                corners = true;
                // Next to the normal, away from the face: n - along.
                cornered &= sign(n.dot(e_in), -along.dot(e_in)) > 0 && sign(n.dot(e_out), -along.dot(e_out)) < 0;
            }
            Geometry::Face { a, dir: d, len, .. } if d == dir && !f.one_way => {
                let next = FaceSegment::new(Raw::of(a), d, len);
                straight |= next.spans(p) || p == if inward > 0 { next.b } else { next.a };
            }
            _ => {}
        }
        true
    });
    !(corners && cornered) && (straight || front_of_end::<J>(p, along.reversed(), n, other) == Some(true))
}

/// Whether the other level hides a piece: a face that is not there beside it.
pub(super) fn hides<J: World>(geometry: &Geometry, other: &dyn Beside) -> bool {
    let Geometry::Face { a, dir, len, .. } = *geometry else { return false };
    covered::<J>(&FaceSegment::new(Raw::of(a), dir, len), other)
}

/// The end of a face through which a ray from `o` by `d` meets it, and the direction from there
/// along the face.
pub(super) fn end_met(geometry: &Geometry, o: Raw, d: Raw) -> Option<(Raw, Axis)> {
    let Geometry::Face { a, dir, len, .. } = *geometry else { return None };
    let edge = FaceSegment::new(Raw::of(a), dir, len);
    [(edge.a, dir), (edge.b, dir.reversed())].into_iter().find(|&(p, _)| o.sub(p).cross(d) == 0)
}
