//! What a mover does at a hit, where two solids pinch a body, and how a body that surfaces hold comes to rest.

use super::body::{Body, Entry};
use super::plane::{Bend, NEAR, Planes, Side, across, is_near, may_be_askew, project, reflect, way};
use super::response::{Law, Smooth};
use super::run::{Run, check_inside};
use super::{Mover, Response};
use crate::num::{Axis, Raw, Toi, leading_zeros64, umul};
use crate::world::{Feature, Geometry, World};

impl<S: Law> Mover<S> {
    pub(super) fn passes_one_way(&self) -> bool {
        self.drop_through || self.response == Response::Cross
    }

    /// What a surface with this normal is; without an up all are walls.
    pub(super) fn side(&self, normal: Axis) -> Side {
        self.up.map_or(Side::Wall, |up| self.limit.side(up, normal))
    }

    /// What a walker keeps of a velocity at a wall: it does not climb by what it has across "up".
    fn stopped<W: World, B: Body>(&self, v: Raw, normal: Axis) -> Raw {
        let Some(up) = self.up else { return v };
        let into = across(v, up).signum() * up.perp_dot(normal).signum();
        // Faces of blocks stop a body along x or y, as well as their walls need it.
        if into < 0 && may_be_askew::<B, W>() { project::<B, W, _>(v, up.perp(), &Smooth) } else { v }
    }

    /// Records a hit, up to which the motion has `used` so much of its time; what it is to a body that does not pass it.
    #[inline(never)]
    pub(super) fn meet<B: Body>(
        &self,
        run: &mut Run<'_, B>,
        used: u32,
        entry: &Entry,
        feature: &Feature,
    ) -> Option<Side> {
        let toi = Toi::ONE.raw() - run.rest.raw() + used;
        // A corner's time is a lower bound: behind a face that the body has passed exactly, it is not before that.
        let passed = if run.pass_one_way { run.moved.hits.iter().last() } else { None };
        let toi = passed.map_or(toi, |hit| toi.max(hit.toi.raw()));
        run.record(entry.normal, feature, Toi::clamped(toi));
        if feature.one_way && self.passes_one_way() {
            run.pass_one_way = true;
            return None;
        }
        let side = self.side(entry.normal);
        run.meet(side);
        Some(side)
    }

    /// Gives the velocity its direction after a hit: of a motion `d`, of which the displacement `made` led up to it.
    #[inline(never)]
    pub(super) fn respond<W: World, B: Body, const WALKS: bool>(
        &self,
        run: &mut Run<'_, B>,
        used: u32,
        (d, made): (Raw, Raw),
        side: Side,
        entry: &Entry,
        feature: &Feature,
    ) {
        let time = run.rest.raw() - run.after.raw();
        let bend = bend(entry, feature);
        if !made.is_zero() {
            let came = way(made) > NEAR;
            if !may_be_askew::<B, W>() || !run.planes.keep_touching(made) {
                run.planes = Planes::ahead(came && (!may_be_askew::<B, W>() || !is_hop(entry, bend)));
                run.before_planes = run.v;
            } else if came && run.planes.landed {
                run.before_planes = run.v;
            }
        }
        // floor(time (den - num) / den): what was used, rounded up where it is not exact, is not left.
        let part = u32::from(umul(used, entry.den) != umul(time, entry.num));
        run.rest = Toi::clamped(run.after.raw() + time - used - part);
        run.after = Toi::ZERO;
        run.motion = if W::ROUND && run.on_chord { run.made_in(run.rest) } else { d.sub(made) };
        run.on_chord = false;
        if WALKS {
            if side == Side::Floor {
                return;
            }
            if side == Side::Wall {
                run.before_planes = self.stopped::<W, B>(run.before_planes, entry.normal);
            }
        }
        match (self.response, self.bounce.0) {
            (Response::Touch, _) => run.v = Raw { x: 0, y: 0 },
            (Response::Bounce, Some(reply)) if !self.surface.surface().stops(run.v, entry.normal) => {
                run.turn::<W>(reflect::<B, W, S>(run.v, entry.normal, &self.surface, reply));
            }
            (Response::Slide | Response::Cross | Response::Bounce, _) => {
                let ends = W::ROUND && made.is_zero() && run.planes.close_pipe(entry.normal, bend);
                run.planes.push(entry.normal, bend);
                if ends {
                    run.turn::<W>(Raw::ZERO);
                } else if !(W::ROUND && run.roll(&feature.geometry, &self.surface)) {
                    run.turn::<W>(run.planes.slide_on::<B, W, S>(run.before_planes, &self.surface));
                }
                if may_be_askew::<B, W>() {
                    run.settle();
                }
            }
        }
    }

    /// A body that would only creep along what it has hit is held between that and what it is pushed against beside it.
    #[inline(never)]
    pub(super) fn wedge<W: World, B: Body>(&self, run: &mut Run<'_, B>, d: Raw, entry: &Entry, feature: &Feature) {
        let Some(start) = run.start else { return };
        let (made, ahead) = (run.made(&start), entry.displacement(d));
        // Less far for what has come some way: so that what was held here once, and starts without velocity, is held again.
        let limit = (2 * NEAR).saturating_sub(way(made));
        let crossed = feature.one_way && self.passes_one_way();
        if crossed || way(ahead) > AHEAD || !is_near(made.add(ahead), entry.normal, limit) {
            return;
        }
        run.record(entry.normal, feature, Toi::clamped(Toi::ONE.raw() - run.rest.raw()));
        run.meet(self.side(entry.normal));
        run.planes.push(entry.normal, bend(entry, feature));
        run.turn::<W>(run.planes.slide_on::<B, W, S>(run.before_planes, &self.surface));
        run.settle();
        run.creeps = false;
    }
}

/// Whether a hit is that of a body which has left a rounded surface along its tangent, and falls back on it.
fn is_hop(entry: &Entry, bend: Bend) -> bool {
    matches!(bend, Bend::Convex) && entry.num <= entry.den >> 8
}

/// What a hit is the tangent of.
fn bend(entry: &Entry, feature: &Feature) -> Bend {
    match feature.geometry {
        _ if entry.step.is_none() => Bend::Flat,
        Geometry::Arc { convex: false, .. } => Bend::Concave,
        _ => Bend::Convex,
    }
}

impl<B: Body> Run<'_, B> {
    /// Another hit instead of one at the end of a face that the body touches, where that stops it for good though it could slide.
    ///
    /// Corner to corner neither axis alone leads into the solid that is ahead, only both do, so either side of the corner could be what is hit. One of
    /// the two may be hidden by a second solid that ends in the same point, and no feature of the first tells that. So both ways along are tried:
    /// where the one along the side that was hit is blocked at once, by what leaves nothing of the velocity, and the other is not, the other side is the
    /// one to slide along. The sweep that
    /// follows proves the way as it proves every other.
    ///
    /// ```text
    ///       |###/     the box moves up and to the right; the underside of the upper tip opposes it most, but along it
    ///       |##/      the lower solid is in the way: it slides up along the left side
    ///       |#/
    ///   +---*
    ///   |box|\
    ///   +---+##\
    /// ```
    #[inline(never)]
    pub(super) fn past_pinch<W: World>(&mut self, world: &W, d: Raw, entry: &Entry) -> Option<(Entry, Feature)> {
        if !entry.at_end || entry.num != 0 || entry.step.is_some() || d.x == 0 || d.y == 0 {
            return None;
        }
        let (along_x, along_y) = (Raw { x: d.x, y: 0 }, Raw { x: 0, y: d.y });
        let (along, across, normal) = match entry.normal {
            Axis { x: 0, .. } => (along_x, along_y, Axis::new(d.x.signum().wrapping_neg(), 0)),
            Axis { y: 0, .. } => (along_y, along_x, Axis::new(0, d.y.signum().wrapping_neg())),
            _ => return None,
        };
        let (second, feature) = self.first_hit(world, along).filter(|(hit, _)| hit.num == 0)?;
        let mut both = self.planes;
        both.push(entry.normal, Bend::Flat);
        both.push(second.normal, Bend::Flat);
        if !both.slide::<B, W>(self.before_planes).is_zero() {
            return None;
        }
        let other = self.first_hit(world, across).is_some_and(|(hit, _)| hit.num == 0);
        (!other).then_some((Entry { normal, ..*entry }, feature))
    }
}

/// How far along what it touches a creeping body looks for what holds it, in raw units.
pub(super) const AHEAD: u32 = 255;

impl<B: Body> Run<'_, B> {
    /// Between surfaces that are not all of blocks a body has found its place when nothing is left of its velocity; roundings to and fro
    /// around it do not move it any more. Where it creeps, what holds it may be less than a rounding away.
    pub(super) fn settle(&mut self) {
        const SLOW: u32 = 64;
        let Some(start) = self.start.filter(|start| self.planes.are_near(self.made(start))) else { return };
        if !self.v.is_zero() {
            self.creeps = way(self.v) <= SLOW && check_inside(&self.moved.body.bounds(), self.ahead()).is_ok();
        } else if self.planes.are_wedge() {
            self.moved.body = start;
        }
    }

    /// The way of a creeping body, at a length of 256 to 511 raw.
    pub(super) fn ahead(&self) -> Raw {
        const BITS: u32 = 9;
        let bits = 64 - leading_zeros64(way(self.v).into());
        Raw { x: self.v.x << (BITS - bits), y: self.v.y << (BITS - bits) }
    }

    /// The displacement since the start of the call.
    pub(super) fn made(&self, start: &B) -> Raw {
        Raw::of(self.moved.body.position()).sub(Raw::of(start.position()))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test")]

    use super::way;
    use crate::motion::Moved;
    use crate::motion::run::Run;
    use crate::motion::search::Around;
    use crate::num::{Fx, Raw, Vec2};
    use crate::shape::Circle;

    #[test]
    fn a_creeping_body_looks_ahead_in_its_direction() {
        let body = Circle::new(Vec2::ZERO, Fx::ONE).unwrap();
        for v in (-64..=64).flat_map(|x| (-64..=64).map(move |y| Raw { x, y })).filter(|v| !v.is_zero()) {
            let (mut moved, mut around) = (Moved::freely(body, v.vec2(), 0), Around::NOTHING);
            let ahead = Run::new(&mut moved, &mut around).ahead();
            assert!((256..512).contains(&way(ahead)), "{v:?} {ahead:?}");
            assert!(v.cross(ahead) == 0 && v.dot(ahead) > 0, "{v:?} {ahead:?}");
        }
    }
}
