//! What a mover does at a hit: records it, and gives the velocity its direction.

use super::body::{Body, Entry};
use super::facing::Side;
use super::plane::{Bend, NEAR, Planes, across, is_near, may_be_askew, project, reflect, way};
use super::response::{Law, Smooth};
use super::rest::AHEAD;
use super::run::Run;
use super::{Mover, Response};
use crate::num::{Axis, Raw, Toi, umul};
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
