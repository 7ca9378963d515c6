//! Solids that turn: where their corners go, and how they hold a body off.

use super::push::Press;
use super::room::HalfPlane;
use crate::motion::body::Body;
use crate::motion::plane::way;
use crate::num::{Axis, Raw, div_sqrt, toward};
use crate::query::Core;
use crate::query::cast::moment::{along, is_below, reach};
use crate::world::{ConvexSolid, Feature, Geometry, SolidShape, ends};

/// How a solid's corners go to those of its next shape.
pub(super) struct Turn<'a, S> {
    solid: &'a ConvexSolid<S>,
    /// The corner of the next shape that the first one goes to.
    shift: usize,
}

impl<'a, S: SolidShape> Turn<'a, S> {
    /// By the least turn: the sides agree best.
    pub(super) fn of(solid: &'a ConvexSolid<S>) -> Self {
        if solid.motion().is_some() {
            return Self { solid, shift: 0 };
        }
        let (here, there) = (solid.shape(), solid.next());
        let (p, q) = (here.outline(), there.outline());
        let (p, q) = (Core { corners: &p, radius: 0 }, Core { corners: &q, radius: 0 });
        let side = |core: &Core<'_>, i: usize| core.corner(core.after(i)).sub(core.corner(i));
        let agreement = |shift: usize| {
            let all = (0..p.corners.len()).map(|i| side(&p, i).dot(side(&q, wrapped(i.wrapping_add(shift), &q))) >> 6);
            all.fold(0i64, i64::saturating_add)
        };
        let shift = (0..q.corners.len()).max_by_key(|&shift| agreement(shift));
        Self { solid, shift: shift.unwrap_or(0) }
    }

    /// The longest displacement of a corner, along x or y.
    pub(super) fn longest(solid: &ConvexSolid<S>) -> u32 {
        if let Some(motion) = solid.motion() {
            return way(Raw::of(motion));
        }
        let turn = Turn::of(solid);
        (0..solid.shape().outline().len()).map(|i| way(turn.of_corner(i))).max().unwrap_or(0)
    }

    fn of_corner(&self, corner: usize) -> Raw {
        if let Some(motion) = self.solid.motion() {
            return Raw::of(motion);
        }
        let (here, there) = (self.solid.shape(), self.solid.next());
        let (p, q) = (here.outline(), there.outline());
        let (p, q) = (Core { corners: &p, radius: 0 }, Core { corners: &q, radius: 0 });
        q.corner(wrapped(corner.wrapping_add(self.shift), &q)).sub(p.corner(corner))
    }

    /// A corner, and the same with the directions that its sides will have.
    fn vertices(&self, corner: usize) -> [Option<Feature>; 2] {
        let of = |corner: usize| (corner as u16).wrapping_mul(5).wrapping_add(1);
        let count = self.solid.next().outline().len();
        let next = corner.wrapping_add(self.shift);
        let (here, there) = (
            self.solid.piece(of(corner)),
            self.solid.moved().piece(of(if next < count { next } else { next.wrapping_sub(count) })),
        );
        let turned = here.zip(there).map(|(here, mut there)| {
            if let (Geometry::Vertex { p, .. }, Geometry::Vertex { p: at, .. }) = (here.geometry, &mut there.geometry) {
                *at = p;
            }
            there
        });
        [here, turned]
    }

    /// The motion of the point that a body touches: of a face between those of its ends.
    pub(super) fn of_contact(&self, feature: &Feature, first: Raw, last: Raw) -> Raw {
        let corner = usize::from(feature.index / 5);
        let from = self.of_corner(corner);
        let Geometry::Face { a, dir, len, .. } = feature.geometry else { return from };
        if self.solid.motion().is_some() {
            return from;
        }
        let (a, b) = ends(Raw::of(a), dir, len);
        let corners = self.solid.shape().outline().len();
        let next = corner.wrapping_add(1);
        let to = self.of_corner(if next < corners { next } else { 0 });
        let (change, whole) = (to.sub(from), b.sub(a).len2());
        let part = |v: Raw, far: i64| Raw { x: part_of(v.x, far, whole), y: part_of(v.y, far, whole) };
        // From both ends, so that mirrored faces give mirrored bits.
        let at = |p: Raw| {
            let (before, after) = (b.sub(a).dot(p.sub(a)), b.sub(a).dot(b.sub(p)));
            from.add(part(change, before)).add(to.add(part(change.reversed(), after)))
        };
        // Each is below 2^29.
        let sum = at(first).add(at(last));
        Raw { x: sum.x / 4, y: sum.y / 4 }
    }

    /// The bound of a turn, if the body does not keep clear of it by `d`: the body stays in front
    /// of what was between the two.
    ///
    /// That is a face of the solid, which goes where its corners go, or the direction of a side of
    /// the body, in which a corner of the solid is first. Of several the one that leaves most room
    /// counts, and none if another one still is between them at the end.
    pub(super) fn held<B: Body>(&self, body: &B, d: Raw) -> Option<(Feature, HalfPlane, Press)> {
        let (shape, next) = (self.solid.shape(), self.solid.next());
        let (p, q) = (shape.outline(), next.outline());
        let (p, q) = (Core { corners: &p, radius: 0 }, Core { corners: &q, radius: 0 });
        let mut best: Option<(Rank, (Feature, HalfPlane, Press))> = None;
        let mut clear = false;
        let mut consider = |corner: usize, n: Axis, next_n: Axis, there: Raw, index: u16| {
            let here = p.corner(corner);
            let (foot, r) = body.toward(n.reversed());
            let gap = along(n, foot.sub(here));
            if gap < 0 || is_below(gap as u64, reach(r, n)) {
                return;
            }
            let to = there.sub(body.toward(next_n.reversed()).0);
            let gap_then = along(next_n, d.sub(to));
            clear |= gap_then >= 0 && !is_below(gap_then as u64, reach(r, next_n));
            let room = div_sqrt(gap as u64, n.length_squared()).saturating_sub(r.unsigned_abs());
            let rank = (room, index == 0, n.x.unsigned_abs(), n.y.unsigned_abs());
            if best.as_ref().is_some_and(|(kept, _)| *kept >= rank) {
                return;
            }
            // In front of the next plane by the radius.
            let out = if r == 0 { Raw::ZERO } else { toward(Raw { x: next_n.x, y: next_n.y }, r) };
            let out = out.add(Raw { x: out.x.signum(), y: out.y.signum() });
            let Some(feature) = self.solid.piece((corner as u16).wrapping_mul(5).wrapping_add(index)) else { return };
            let press = Press::of::<true>(self.solid.key(), self.of_corner(corner), next_n);
            best = Some((rank, (feature, HalfPlane { normal: next_n, at: to.add(out) }, press)));
        };
        // A direction, and the corner of the solid that is first in it, before and after.
        let mut beside = |n: Axis| {
            if !n.is_zero() {
                let ahead = n.perp().reversed();
                consider(p.facing(ahead).0, n, n, q.corner(q.facing(ahead).0), 1);
            }
        };
        for n in [Axis::X, Axis::NEG_X, Axis::Y, Axis::NEG_Y] {
            beside(n);
        }
        for i in 0..p.corners.len() {
            if B::ANGULAR {
                // The side that the corner would come through on a straight way, if the body stays,
                // or as it goes by `d`: with the corner's directions before the turn, and after it.
                let by = self.of_corner(i);
                for vertex in self.vertices(i).into_iter().flatten() {
                    for way in [by.reversed(), d.sub(by)] {
                        if let Some(entry) = body.sweep(way, &vertex) {
                            beside(entry.normal);
                        }
                    }
                }
            } else if B::MEETS_CORNERS {
                let (here, (lo, hi)) = (p.corner(i), body.core_box());
                let m = Raw { x: here.x.clamp(lo.x, hi.x), y: here.y.clamp(lo.y, hi.y) }.sub(here);
                beside(Axis::new(m.x, m.y));
            }
        }
        for i in 0..p.corners.len() {
            let there = wrapped(i.wrapping_add(self.shift), &q);
            consider(i, p.facing_normal(i).reversed(), q.facing_normal(there).reversed(), q.corner(there), 0);
        }
        if clear { None } else { best.map(|(_, bound)| bound) }
    }
}

/// How much room a direction leaves; of equal ones a face goes first, then by their normals.
type Rank = (u32, bool, u32, u32);

/// `v far / whole`, with `far` between 0 and `whole`, rounded toward zero.
fn part_of(v: i32, far: i64, whole: u64) -> i32 {
    let size = crate::num::mul_div_wide((far.max(0) as u64).min(whole), v.unsigned_abs(), whole) as i32;
    if v < 0 { size.wrapping_neg() } else { size }
}

fn wrapped(index: usize, core: &Core<'_>) -> usize {
    let count = core.corners.len();
    if index < count { index } else { index.wrapping_sub(count) }
}
