//! Motions that meet one surface and then nothing, as most that meet anything. The result is that
//! of [`follow`](Mover::follow), which takes two rounds and more work.

use super::body::{Body, Entry, is_by_lines, may_be_round};
use super::mover::Mover;
use super::plane::{FAR, NEAR, into, may_be_askew, project, way};
use super::response::{Law, Response, Smooth};
use super::run::{on_the_way, straightened, turned};
use super::search::{Around, hull, margin, piece_of};
use crate::num::{Axis, Raw, Toi, mul_div, umul};
use crate::query::cast::side::along;
use crate::shape::Aabb;
use crate::world::{Feature, Geometry, Tangent, World, ends};

/// A motion up to its only hit, the motion after it, and the velocity after it.
pub(super) struct OnlyHit {
    pub(super) toi: Toi,
    pub(super) made: Raw,
    pub(super) rest: Raw,
    pub(super) v: Raw,
}

impl<S: Law> Mover<S> {
    /// The motion of a body whose first hit this is, if it is known to meet nothing afterwards. A
    /// body that needs tests on its way (`known` is `None`) may only stay where it is.
    #[inline]
    pub(super) fn only_hit<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        d: Raw,
        (entry, feature): (&Entry, &Feature),
        known: Option<&Around>,
    ) -> Option<OnlyHit> {
        let normal = entry.normal;
        if feature.one_way && self.passes_one_way() {
            return None;
        }
        let toi = if entry.num == 0 { Toi::ZERO } else { Toi::clamped(mul_div(Toi::ONE.raw(), entry.num, entry.den)) };
        match self.response_to(normal, feature, toi) {
            Response::Touch => return None,
            Response::Bounce if self.bounce.reply(self.surface.surface(), (d, normal), None).is_some() => return None,
            Response::Slide | Response::DropThrough | Response::Bounce => {}
        }
        let is_askew = may_be_askew::<B, W>() && (entry.step.is_some() || (normal.x != 0 && normal.y != 0));
        let hit = if is_askew {
            if !W::GRID || B::ANGULAR || known.is_none() {
                return None;
            }
            self.along_tangent(world, body, d, (entry, feature), toi)?
        } else {
            self.along_face(world, body, d, (entry, feature), toi, known)?
        };
        for part in [hit.made, hit.rest] {
            if !part.is_zero() {
                world.made(part);
            }
        }
        Some(hit)
    }

    /// A face along x or y takes one component of the motion and leaves the other as it is, unless
    /// there is friction. If the rest leads through a region that is known to be empty, no surface
    /// nearby matters.
    #[inline]
    fn along_face<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        d: Raw,
        (entry, feature): (&Entry, &Feature),
        toi: Toi,
        known: Option<&Around>,
    ) -> Option<OnlyHit> {
        let normal = entry.normal;
        if entry.at_end {
            return None;
        }
        let v = if S::SMOOTH {
            if normal.x == 0 { Raw { x: d.x, y: 0 } } else { Raw { x: 0, y: d.y } }
        } else {
            project::<B, W, S>(d, normal, &self.surface)
        };
        let made = if entry.num == 0 { Raw::ZERO } else { entry.displacement_at(d, Some(toi.raw())) };
        let left = d.sub(made);
        let rest = if S::SMOOTH {
            Raw { x: if v.x == 0 { 0 } else { left.x }, y: if v.y == 0 { 0 } else { left.y } }
        } else {
            turned(left, d, v, after(toi, entry))
        };
        if !made.is_zero() || !rest.is_zero() {
            let (around, way) = (known?, piece_of(&body.shifted(made).bounds(), Raw::ZERO, rest, 1));
            let free = if is_by_lines::<W, B>() {
                rest.is_zero() || world.is_known_empty(&way)
            } else {
                around.is_free(&way) || is_before_face(world, body, &way, rest, (normal, feature))
            };
            if !free {
                return None;
            }
        }
        Some(OnlyHit { toi, made, rest, v })
    }

    /// Goes on along the tangent where a body meets a corner, an arc or a slope. It does so only if
    /// all that is near the body is behind that tangent.
    ///
    /// Such a way crosses no solid. Of all ways that do not cross the tangent, that is the one
    /// nearest to the velocity. So the projection on it is the longest. Other surfaces that the
    /// body touches add only shorter ones.
    #[inline(never)]
    fn along_tangent<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        d: Raw,
        (entry, feature): (&Entry, &Feature),
        toi: Toi,
    ) -> Option<OnlyHit> {
        let n = entry.normal;
        if n.x == 0 || n.y == 0 || into(d, n) >= 0 {
            return None;
        }
        let made = entry.displacement_at(d, Some(toi.raw()));
        let line = tangent_of::<W, _>(&body.shifted(made), n, feature)?;
        let smooth = project::<B, W, _>(d, n, &Smooth);
        if way(smooth) <= NEAR || on_the_way(made, d) != made {
            return None;
        }
        let v = if S::SMOOTH { smooth } else { project::<B, W, S>(d, n, &self.surface) };
        let rest = straightened::<B, W>(turned(d.sub(made), d, v, after(toi, entry)), n);
        let region = hull(&body.shifted(made).bounds(), Raw::ZERO, rest, FAR as i32 + 2);
        leads_along(world, body, &region, rest, &line).then_some(OnlyHit { toi, made, rest, v })
    }
}

/// Whether a way in a region leads along a line, in front of all solid. A body without area may
/// meet the end of what is behind the line, too. Longer ways are looked at in pieces, which costs
/// less.
#[inline]
fn leads_along<W: World, B: Body>(world: &W, body: &B, region: &Aabb, rest: Raw, line: &Tangent) -> bool {
    way(rest) >> 1 <= world.cell_size() && margin(body.extent()) == 0 && world.is_behind(region, body.rounding(), line)
}

/// Whether a way in a region leads along a face, in front of all solid. Blocks in front of a face
/// are in its way. Bodies with sides in any direction may be beside the face and reach behind its
/// line.
#[inline]
fn is_before_face<W: World, B: Body>(
    world: &W,
    body: &B,
    region: &Aabb,
    rest: Raw,
    (n, feature): (Axis, &Feature),
) -> bool {
    let Geometry::Face { a, .. } = feature.geometry else { return false };
    let line = Tangent::through(Raw::of(a), n, feature.cell);
    W::GRID && !W::BLOCKS && !B::ANGULAR && leads_along(world, body, region, rest, &line)
}

/// The tangent where a body meets a feature, if the cell's convex solid touches no more than that.
fn tangent_of<W: World, B: Body>(body: &B, n: Axis, feature: &Feature) -> Option<Tangent> {
    let cell = feature.cell;
    match feature.geometry {
        Geometry::Vertex { p, e_in, e_out } if may_be_round::<W, B>() => {
            // Both edges are behind the line, even if the normal is rounded.
            (W::BLOCKS || (e_in.dot(n) >= 0 && e_out.dot(n) <= 0)).then(|| Tangent::through(Raw::of(p), n, cell))
        }
        Geometry::Arc { centre, radius, convex: true, .. } if W::ARCS => {
            Some(Tangent::of_disc(Raw::of(centre), radius, n, cell))
        }
        Geometry::Face { a, dir, len, .. } if !W::BLOCKS => {
            // Near an end of a face there is a corner with other tangents.
            let (a, end) = ends(Raw::of(a), dir, len);
            let (c, _) = body.toward(n.reversed());
            let over = |way: Raw| along(dir, way) > i64::from(4 * FAR);
            (over(c.sub(a)) && over(end.sub(c))).then(|| Tangent::through(a, n, cell))
        }
        _ => None,
    }
}

/// The time after a hit: `toi` is the time before it, rounded down. The result is rounded down,
/// too.
fn after(toi: Toi, entry: &Entry) -> Toi {
    // The time of a corner or an arc is in parts of 2^30 already.
    let is_exact = entry.den == Toi::ONE.raw() || umul(toi.raw(), entry.den) == umul(Toi::ONE.raw(), entry.num);
    let part = u32::from(!is_exact);
    Toi::clamped(Toi::ONE.raw().wrapping_sub(toi.raw()).wrapping_sub(part))
}
