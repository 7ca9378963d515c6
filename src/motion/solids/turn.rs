//! Solids that turn: how their corners move, and how they push a body.

use super::push::Press;
use super::room::HalfPlane;
use crate::motion::body::Body;
use crate::num::{Axis, Raw, div_sqrt, leading_zeros32, toward};
use crate::query::Core;
use crate::query::cast::moment::{along, is_below, reach};
use crate::world::{ConvexSolid, Feature, Geometry, SolidShape, ends};

/// A solid that turns: its corners before and after the turn.
pub(super) struct Turn<'a, S: SolidShape> {
    solid: &'a ConvexSolid<S>,
    here: S::Corners<'a>,
    there: S::Corners<'a>,
    /// The corner of the next shape to which the first one moves.
    shift: usize,
}

impl<'a, S: SolidShape> Turn<'a, S> {
    pub(super) fn of(solid: &'a ConvexSolid<S>) -> Self {
        let (here, there, shift) = solid.corners();
        Self { solid, here, there, shift }
    }

    fn cores(&self) -> (Core<'_>, Core<'_>) {
        (Core { corners: &self.here, radius: 0 }, Core { corners: &self.there, radius: 0 })
    }

    /// The number in the next shape of the corner to which a corner moves.
    fn goes_to(&self, corner: usize) -> usize {
        self.cores().1.wrapped(corner.wrapping_add(self.shift))
    }

    fn of_corner(&self, corner: usize) -> Raw {
        let (p, q) = self.cores();
        q.corner(self.goes_to(corner)).sub(p.corner(corner))
    }

    /// The motion of the point that a body touches: on a face it is between those of the ends.
    pub(super) fn of_contact(&self, feature: &Feature, first: Raw, last: Raw) -> Raw {
        let corner = usize::from(feature.index / 5);
        let from = self.of_corner(corner);
        let Geometry::Face { a, dir, len, .. } = feature.geometry else { return from };
        let (a, b) = ends(Raw::of(a), dir, len);
        let to = self.of_corner(self.cores().0.after(corner));
        let (change, whole) = (to.sub(from), b.sub(a).len2());
        let part = |v: Raw, far: i64| Raw { x: part_of(v.x, far, whole), y: part_of(v.y, far, whole) };
        // From both ends, so that mirrored faces give mirrored bits.
        let at = |p: Raw| {
            let (before, after) = (b.sub(a).dot(p.sub(a)), b.sub(a).dot(b.sub(p)));
            from.add(part(change, before)).add(to.add(part(change.reversed(), after)))
        };
        // Each is below 2^29. A round body has one lowest point.
        let one = at(first);
        let sum = one.add(if first == last { one } else { at(last) });
        Raw { x: sum.x / 4, y: sum.y / 4 }
    }

    /// The bound of a turn, if the body does not keep clear of it by `d`. The body stays in front
    /// of the face or corner that was between the two.
    ///
    /// This separation is a face of the solid, which moves with its corners, or a direction in
    /// which a corner of the solid is first. Such a direction is along x or y, into a side of the
    /// body, or between the points that are nearest to each other. Before the turn the last one or
    /// a face leaves most room, so there always is a separation. None counts if another one is
    /// still between them at the end.
    pub(super) fn held<B: Body>(&self, body: &B, d: Raw) -> Option<(Feature, HalfPlane, Press)> {
        let (p, q) = self.cores();
        let mut best: Option<TurnFront> = None;
        let mut keep = |front: TurnFront| {
            if best.as_ref().is_none_or(|kept| front.rank() > kept.rank()) {
                best = Some(front);
            }
        };
        for i in 0..p.corners.len() {
            let there = self.goes_to(i);
            let (n, next_n) = (p.facing_normal(i).reversed(), q.facing_normal(there).reversed());
            let Some(gap) = TurnGap::of(body, n, p.corner(i)) else { continue };
            let front = TurnFront {
                face: true,
                corner: i,
                n,
                next_n,
                gap,
                to: q.corner(there).sub(body.toward(next_n.reversed()).0),
            };
            if front.is_clear(d) {
                return None;
            }
            keep(front);
        }
        // A direction, and the corner of the solid that is first in it, before and after.
        let mut is_clear = false;
        let mut beside = |n: Axis| {
            if is_clear || n.is_zero() {
                return;
            }
            let ahead = n.perp().reversed();
            let corner = p.facing(ahead).0;
            let Some(gap) = TurnGap::of(body, n, p.corner(corner)) else { return };
            let to = q.corner(q.facing(ahead).0).sub(gap.foot);
            let front = TurnFront { face: false, corner, n, next_n: n, gap, to };
            is_clear = front.is_clear(d);
            keep(front);
        };
        for n in [Axis::X, Axis::NEG_X, Axis::Y, Axis::NEG_Y] {
            beside(n);
        }
        if B::ANGULAR {
            body.sides_toward(p.corners, &mut beside);
        } else if B::MEETS_CORNERS {
            for i in 0..p.corners.len() {
                let (here, (lo, hi)) = (p.corner(i), body.core_box());
                let m = Raw { x: here.x.clamp(lo.x, hi.x), y: here.y.clamp(lo.y, hi.y) }.sub(here);
                beside(Axis::new(m.x, m.y));
            }
        }
        if is_clear { None } else { best.and_then(|front| self.bound(body, &front)) }
    }

    /// The bound on a displacement, with the body in front of the plane by its radius.
    fn bound<B: Body>(&self, body: &B, front: &TurnFront) -> Option<(Feature, HalfPlane, Press)> {
        let (n, r) = (front.next_n, front.gap.radius);
        let out = if r == 0 { Raw::ZERO } else { toward(Raw { x: n.x, y: n.y }, r) };
        let out = out.add(Raw { x: out.x.signum(), y: out.y.signum() });
        let index = (front.corner as u16).wrapping_mul(5).wrapping_add(u16::from(!front.face));
        let feature = self.solid.border(&self.here).piece(index, self.solid.whole())?;
        // The ends of a face may move in opposite directions.
        let (first, last) = lowest(body, front.n);
        let press = Press::of::<true>(self.solid.key(), self.of_contact(&feature, first, last), n);
        Some((feature, HalfPlane { normal: n, at: front.to.add(out) }, press))
    }
}

/// The separation of a body and a solid before a turn: a face, or a direction and a corner.
struct TurnFront {
    face: bool,
    corner: usize,
    /// Out of the solid, before the turn and after it.
    n: Axis,
    next_n: Axis,
    gap: TurnGap,
    /// The displacement that would take the body's core to the plane after the turn.
    to: Raw,
}

impl TurnFront {
    /// How much room it leaves; on a tie a face wins, then the order of normals.
    fn rank(&self) -> (u32, bool, u32, u32) {
        (self.gap.size, self.face, self.n.x.unsigned_abs(), self.n.y.unsigned_abs())
    }

    /// Whether it is still between them after the turn, if the body moves by `d`.
    fn is_clear(&self, d: Raw) -> bool {
        let gap = along(self.next_n, d.sub(self.to));
        gap >= 0 && !is_below(gap as u64, reach(self.gap.radius, self.next_n))
    }
}

/// The room between a body and a plane.
struct TurnGap {
    size: u32,
    /// The nearest point of the body's core, and its radius.
    foot: Raw,
    radius: i32,
}

impl TurnGap {
    /// None if the body is not in front of the plane through a point.
    fn of<B: Body>(body: &B, n: Axis, at: Raw) -> Option<Self> {
        let (foot, radius) = body.toward(n.reversed());
        let gap = along(n, foot.sub(at));
        if gap < 0 || is_below(gap as u64, reach(radius, n)) {
            return None;
        }
        let size = div_sqrt(gap as u64, n.length_squared()).saturating_sub(radius.unsigned_abs());
        Some(Self { size, foot, radius })
    }
}

/// `v far / whole`, with `far` between 0 and `whole`, rounded toward zero.
fn part_of(v: i32, far: i64, whole: u64) -> i32 {
    let size = crate::num::mul_div_wide((far.max(0) as u64).min(whole), v.unsigned_abs(), whole) as i32;
    if v < 0 { size.wrapping_neg() } else { size }
}

/// The points of a body that are lowest over a face with the normal `n`. If a side lies on the
/// face, they are both of its ends, in the direction of the face.
///
/// Along x and y that is exact. Corners differ by less than 2^29 along the face. So of two at
/// unequal heights the lower one is farther in both directions. Otherwise a side counts that is
/// within 1 : 512 of the face.
pub(super) fn lowest<B: Body>(body: &B, n: Axis) -> (Raw, Raw) {
    let size = n.x.unsigned_abs().max(n.y.unsigned_abs());
    let (up, slack) = if n.x == 0 || n.y == 0 { (29, 29) } else { (leading_zeros32(size) & 31, 9) };
    // Below 2^28, or 2^29 along x and y.
    let n = if slack == 9 {
        Raw { x: n.x << up.saturating_sub(4), y: n.y << up.saturating_sub(4) }
    } else {
        Raw { x: n.x.signum() << up, y: n.y.signum() << up }
    };
    let toward = |aside: i32| {
        let part = |across: i32, along: i32| {
            let size = (along.unsigned_abs() >> slack) as i32;
            aside.wrapping_mul(along.signum()).wrapping_mul(size).wrapping_sub(across)
        };
        body.toward(Axis::new(part(n.x, n.y.wrapping_neg()), part(n.y, n.x))).0
    };
    (toward(-1), toward(1))
}
