//! A mover's response to a hit: it finds the position and the ways from there, and takes one of
//! them.

use super::body::{Body, Entry, may_be_round};
use super::contact::{Bend, Came, Plane, came, touched};
use super::free_way::FreeWay;
use super::order::First;
use super::plane::{NEAR, across, into, long, may_be_askew, project, reflect, way};
use super::response::{Law, Smooth};
use super::run::{Run, check_inside, straightened};
use super::search::margin;
use super::slope_limit::SurfaceRole;
use super::ways::Ways;
use super::{Mover, Response};
use crate::num::{Axis, Raw, Toi, mul_div, umul};
use crate::world::{Feature, World};

impl<S: Law> Mover<S> {
    pub(super) fn passes_one_way(&self) -> bool {
        self.drop_through || self.response == Response::DropThrough
    }

    /// The role of a surface with this normal. Without an up all surfaces are walls.
    #[inline(never)]
    pub(super) fn side(&self, normal: Axis) -> SurfaceRole {
        self.up.map_or(SurfaceRole::Wall, |up| self.limit.side(up, normal))
    }

    /// The velocity that a walker keeps at a wall. Its part across "up" does not make it climb.
    fn stopped<W: World, B: Body>(&self, v: Raw, normal: Axis) -> Raw {
        let Some(up) = self.up else { return v };
        let into = across(v, up).signum() * up.perp_dot(normal).signum();
        // Faces of blocks stop a body along x or y, which is all that their walls need.
        if into < 0 && may_be_askew::<B, W>() { project::<B, W, _>(v, up.perp(), &Smooth) } else { v }
    }

    /// Records a hit, after the motion has `used` this much of its time. Returns the surface's
    /// role, or `None` if the body passes it.
    #[inline(never)]
    pub(super) fn meet<B: Body>(
        &self,
        run: &mut Run<'_, B>,
        used: u32,
        normal: Axis,
        feature: &Feature,
    ) -> Option<SurfaceRole> {
        let toi = Toi::ONE.raw() - run.rest.raw() + used;
        run.record(normal, feature, Toi::clamped(toi));
        if feature.one_way && self.passes_one_way() {
            run.pass_one_way = true;
            return None;
        }
        let side = self.side(normal);
        run.moved.meet(side);
        Some(side)
    }

    /// Gives the velocity its direction after a hit. The displacement `made` of the motion `d` led
    /// up to the hit. Returns whether to [choose](Self::go_along) one of the ways.
    #[inline(never)]
    pub(super) fn respond<W: World, B: Body, const WALKS: bool>(
        &self,
        run: &mut Run<'_, B>,
        used: u32,
        (d, made): (Raw, Raw),
        (side, entry, feature): (SurfaceRole, &Entry, &Feature),
    ) -> bool {
        let toi = Toi::clamped(Toi::ONE.raw() - run.rest.raw() + used);
        let time = run.rest.raw() - run.after.raw();
        // floor(time (den - num) / den): the used time is rounded up if it is not exact, and does
        // not remain.
        let part = u32::from(umul(used, entry.den) != umul(time, entry.num));
        run.rest = Toi::clamped(run.after.raw() + time - used - part);
        run.after = Toi::ZERO;
        run.motion = if W::ROUND && run.on_chord { run.made_in(run.rest) } else { d.sub(made) };
        run.on_chord = false;
        if WALKS && side == SurfaceRole::Floor && !run.falls {
            return false;
        }
        let response = self.response_to(entry.normal, feature, toi);
        let here = made.is_zero().then_some(&run.moved.hits);
        let bounces = || self.bounce.reply(self.surface.surface(), (run.v, entry.normal), here);
        if response == Response::Touch {
            run.v = Raw::ZERO;
        } else if let Some(reply) = (response == Response::Bounce).then(bounces).flatten() {
            run.turn(reflect::<B, W, S>(run.v, entry.normal, &self.surface, reply));
        } else if !may_be_askew::<B, W>() {
            run.turn(project::<B, W, S>(run.v, entry.normal, &self.surface));
        } else if is_plain(run, entry) {
            self.lose_component::<W, B>(run, made, entry, feature);
        } else {
            if WALKS && side == SurfaceRole::Wall {
                run.before = self.stopped::<W, B>(run.before, entry.normal);
            }
            return true;
        }
        false
    }

    /// The short cut for a [plain](is_plain) hit.
    fn lose_component<W: World, B: Body>(&self, run: &mut Run<'_, B>, made: Raw, entry: &Entry, feature: &Feature) {
        let u = run.before;
        let lay = run.is_first && came::<W, B>(&run.moved.body, u, made, entry, feature) == Came::Lay;
        run.turn(project::<B, W, S>(run.v, entry.normal, &self.surface));
        if lay {
            (run.before, run.along) = (u, Some(Plane::flat(entry.normal)));
        }
    }

    /// Takes the longest free way from the current position, after a displacement up to a hit, if
    /// there was one. If none is free, the body [creeps](Run::creeps), or it stops.
    #[inline(never)]
    pub(super) fn go_along<W: World, B: Body>(
        &self,
        world: &W,
        run: &mut Run<'_, B>,
        made: Raw,
        hit: Option<(&Entry, &Feature)>,
    ) {
        if made.is_zero() {
            run.shut.push(run.tried);
        } else {
            run.shut.clear();
        }
        run.came |= hit.is_some() && way(made) > NEAR;
        // The hit is passed on too: if the body had to stay back from it, it is not near.
        let of_hit = hit.map(|(entry, _)| {
            let bend = if entry.step.is_none() { Bend::Flat } else { Bend::Convex };
            Plane { normal: entry.normal, bend }
        });
        let passes = run.pass_one_way || self.passes_one_way();
        let mut ways = Ways::none();
        run.read_ways(world, &mut ways, (made, passes), hit.zip(of_hit.as_ref()));
        let normal = of_hit.map_or(Axis::new(0, 0), |plane| plane.normal);
        if let Some(way) = run.choose(world, &mut ways, normal, passes) {
            let v = run.follow_way::<W, S>(way, &self.surface);
            if run.flew {
                run.before = v;
            }
            return;
        }
        ways.settle_all(world, &run.moved.body, passes);
        self.end_bound(world, run, &ways, hit.map(|_| normal));
    }

    /// Ends a motion whose ways are all bound: it creeps on, continues in the next call, or stops.
    #[inline(always)]
    fn end_bound<W: World, B: Body>(&self, world: &W, run: &mut Run<'_, B>, ways: &Ways, hit: Option<Axis>) {
        // One look is reserved for the surface that binds it.
        let looks = run.moved.work.iterations;
        if looks + 1 < Mover::ITERATIONS && run.creep_along::<W>(ways) {
            return;
        }
        // A body that advances with each call continues in the next one.
        if let Some(normal) = hit.filter(|_| run.came && looks >= Mover::ITERATIONS) {
            let mut creeps = ways.iter().filter(|way| way.along.is_some() && way.can_creep());
            let v = creeps.find(|way| into(way.v, normal) >= 0).map_or(Raw::ZERO, |way| way.v);
            (run.motion, run.v) = (run.turned(v), v);
            return;
        }
        run.shut.clear();
        for way in ways.iter().filter(|way| way.along.is_some()) {
            run.shut.push(way.probe());
        }
        run.turn(Raw::ZERO);
        if looks < Mover::ITERATIONS {
            self.report_binding(world, run, ways);
        }
    }

    /// Continues after a creeping motion `d`: from the position at its hit, if it hit something.
    #[inline(never)]
    pub(super) fn creep<W: World, B: Body>(
        &self,
        world: &W,
        run: &mut Run<'_, B>,
        d: Raw,
        hit: Option<(&Entry, &Feature)>,
    ) -> Raw {
        run.creeps = false;
        let Some((entry, feature)) = hit.filter(|(_, met)| !(met.one_way && self.passes_one_way())) else {
            return Raw::ZERO;
        };
        let made = run.place(world, d, entry.displacement(d), run.before);
        if !made.is_zero() {
            if !run.moved.hits.already_lists(entry.normal, feature) {
                self.meet(run, 0, entry.normal, feature);
            }
            // Roundings take no time.
            if way(made) > NEAR {
                run.rest = Toi::clamped(mul_div(run.rest.raw(), entry.den - entry.num, entry.den));
            }
            run.motion = d.sub(made);
        }
        made
    }

    /// Records what else holds a body that stops: the hit of the longest way that led nowhere.
    #[inline(never)]
    fn report_binding<W: World, B: Body>(&self, world: &W, run: &mut Run<'_, B>, ways: &Ways) {
        run.moved.work.iterations += 1;
        for probe in run.shut.iter() {
            let mut first = First::none();
            ways.binding(world, &run.moved.body, probe, &run.moved.hits, &mut first);
            let Some((entry, feature)) = first.hit::<B, W>(&run.moved.body, probe) else { continue };
            // At the body's position, from which mirrored bodies look alike. The probe's end is
            // rounded. For a body that is still over a face that ends at the corner, the corner has
            // no side.
            let mut normal = entry.normal;
            if may_be_round::<W, B>() {
                touched::<W, B>(&run.moved.body, feature, &mut |plane| {
                    let (n, m) = (plane.normal, entry.normal);
                    if plane.bend == Bend::Convex && n.x.signum() == m.x.signum() && n.y.signum() == m.y.signum() {
                        normal = plane.normal;
                    }
                });
            }
            self.meet(run, 0, normal, feature);
            return;
        }
    }
}

/// Whether a hit takes one component of the velocity and leaves the other, whatever else is near.
/// That is a face along x or y which the body does not meet at its end. The following sweep meets
/// the other surfaces that the body touches.
///
/// A body that runs along another such face stops: both components are bound.
fn is_plain<B: Body>(run: &Run<'_, B>, entry: &Entry) -> bool {
    let straight = |n: Axis| n.x == 0 || n.y == 0;
    entry.step.is_none()
        && straight(entry.normal)
        && !entry.at_end
        && (run.v == run.before || run.along.is_some_and(|p| straight(p.normal) && p.bend == Bend::Flat))
}

/// The sign of [`across`]. One copy of a sign of 64 bits.
#[inline(never)]
fn turn_of(v: Raw, n: Axis) -> i32 {
    across(v, n).signum() as i32
}

/// Whether two surfaces hold a velocity together: it is between the reverses of their normals. Its
/// projection on each of them then leads into the other.
fn hold(u: Raw, n: Axis, m: Axis) -> bool {
    let turn = turn_of(Raw { x: m.x, y: m.y }, n);
    turn != 0 && turn_of(u, m) == turn && turn_of(u, n) == turn.wrapping_neg()
}

impl<B: Body> Run<'_, B> {
    /// Reads the ways at the current position. They project the velocity from before the surfaces
    /// that the body still touches. If it has left those, they project what is left of it.
    #[inline(always)]
    fn read_ways<W: World>(
        &mut self,
        world: &W,
        ways: &mut Ways,
        (made, passes): (Raw, bool),
        hit: Option<((&Entry, &Feature), &Plane)>,
    ) {
        let of_hit = hit.map(|(_, plane)| *plane);
        let first = hit.is_some() && core::mem::take(&mut self.is_first);
        let is_new = first || hit.is_none();
        let mut kept = is_new || self.may_keep::<W>(made);
        self.end_hop::<W>(of_hit.filter(|_| kept).map(|plane| plane.normal));
        let alone = loop {
            if !kept {
                self.before = self.v;
            }
            let alone = ways.read::<W, B>(world, &self.moved.body, (self.before, self.rest), of_hit, passes);
            kept = kept && (is_new || self.along.as_ref().is_some_and(|plane| ways.keep::<B>(plane)));
            if kept || self.before == self.v {
                break alone;
            }
        };
        if let (true, Some(((entry, feature), _))) = (first || !kept, hit) {
            let came = came::<W, B>(&self.moved.body, self.before, made, entry, feature);
            self.flew = came != Came::Lay;
            self.hopped = (first && came == Came::Hopped).then_some(self.before);
        }
        if alone {
            ways.free();
        }
    }

    /// After a hop, at the next hit: `normal` is that of the hit, if the body still touches the
    /// surface from which it hopped. If both together hold the velocity of the call, the body meets
    /// both with it, as a body does that lay on the first. Otherwise each call would throw it up
    /// from the second, and gravity would pull it back: it would hop on the spot for ever.
    fn end_hop<W: World>(&mut self, normal: Option<Axis>) {
        if !may_be_round::<W, B>() {
            return;
        }
        let hopped = self.hopped.take().zip(self.along.filter(|plane| plane.bend == Bend::Convex));
        let Some(((u, plane), normal)) = hopped.zip(normal) else { return };
        if hold(u, plane.normal, normal) {
            (self.before, self.flew) = (u, false);
        }
    }

    /// Whether the body may still touch the surface that it has just run along. It touches a
    /// tangent while that turns by less than a quarter of its length. For faces the
    /// [ways](Ways::keep) decide.
    fn may_keep<W: World>(&self, made: Raw) -> bool {
        self.along.is_some_and(|plane| match plane.bend {
            Bend::Convex if may_be_round::<W, B>() => made.len2() << 4 <= plane.normal.length_squared(),
            _ => true,
        })
    }

    /// Moves along a touched surface if all ways are bound, but not in the very last position.
    /// Returns whether a way was left to try.
    fn creep_along<W: World>(&mut self, ways: &Ways) -> bool {
        for on in ways.iter().filter(|on| on.along.is_some_and(|p| p.pipe().is_none()) && on.can_creep()) {
            let d = self.along_plane::<W>(on.v, on.along);
            if !self.shut.holds(on.probe()) && !d.is_zero() && check_inside(&self.moved.body.bounds(), d).is_ok() {
                (self.creeps, self.motion, self.v, self.tried) = (true, d, on.v, on.probe());
                return true;
            }
        }
        false
    }

    /// The longest free way that does not lead into the plane of the hit surface. If something else
    /// binds those, any free way. The body may then be beside the surface that it hit, at its end
    /// or by the rounding of its position.
    ///
    /// If there are none, because they are slower than the rounding, any free way along a surface.
    /// A ball that meets a corner head on goes along the face that ends there, if the corner does
    /// not bind that. A body without area is beside nothing: it may stand where two surfaces touch
    /// and leave no face.
    fn choose<'w, W: World>(&self, world: &W, ways: &'w mut Ways, hit: Axis, passes: bool) -> Option<&'w FreeWay> {
        let body = &self.moved.body;
        let is_shut = |way: &FreeWay| self.shut.holds(way.probe());
        let leads_out = |way: &FreeWay| into(way.v, hit) >= 0;
        let (thin, leads) = (margin(body.extent()) != 0, ways.iter().any(leads_out));
        let out = ways.first_free(world, body, passes, &|way| leads_out(way) && !is_shut(way));
        let free = if out.is_some() || thin {
            out
        } else {
            ways.first_free(world, body, passes, &|way| (leads || way.along.is_some()) && !is_shut(way))
        };
        ways.way(free?)
    }

    /// Gives the velocity another direction, and the rest of the motion with it.
    pub(super) fn turn(&mut self, to: Raw) {
        (self.motion, self.v, self.before, self.along) = (self.turned(to), to, to, None);
        self.tried = long(to);
        self.is_first = false;
    }

    /// Takes a way. Returns the velocity at its start.
    fn follow_way<W: World, S: Law>(&mut self, way: &FreeWay, surface: &S) -> Raw {
        (self.along, self.tried) = (way.along, way.probe());
        let Some(plane) = way.along else {
            (self.motion, self.v) = (self.turned(way.v), way.v);
            return way.v;
        };
        if let Some(pipe) = if W::ROUND { plane.pipe() } else { None } {
            if let Some(chord) = pipe.chord(self.before, self.rest, surface) {
                (self.v, self.motion, self.after) = (chord.velocity, chord.way, chord.after);
                self.on_chord = !self.motion.is_zero();
                if !self.on_chord {
                    // Already at the end of the pipe.
                    self.follow();
                }
            } else {
                (self.motion, self.v) = (Raw::ZERO, Raw::ZERO);
            }
            return way.v;
        }
        let v = if S::SMOOTH { way.v } else { project::<B, W, S>(self.before, plane.normal, surface) };
        (self.motion, self.v) = (self.along_plane::<W>(v, way.along), v);
        v
    }

    /// The rest of the motion at a velocity along a plane.
    fn along_plane<W: World>(&self, v: Raw, along: Option<Plane>) -> Raw {
        let d = self.turned(v);
        along.map_or(d, |plane| straightened::<B, W>(d, plane.normal))
    }
}
