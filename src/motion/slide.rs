//! What a mover does at a hit: it finds the position, the ways on from there, and takes one of
//! them.

use super::body::{Body, Entry};
use super::contact::{Bend, Plane, touched};
use super::order::First;
use super::plane::{NEAR, SurfaceRole, across, into, long, may_be_askew, project, reflect, tangential, way};
use super::response::{Law, Smooth};
use super::run::{Run, check_inside, margin};
use super::ways::{Way, Ways};
use super::{Mover, Response};
use crate::num::{Axis, Raw, Toi, isqrt64, mul_div, umul, usqr};
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
        run.meet(side);
        Some(side)
    }

    /// Gives the velocity its direction after a hit. The displacement `made` of the motion `d` led
    /// up to the hit. Returns whether to [choose](Self::go_along) from the ways on.
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
        match (self.response_to(entry.normal, feature, toi), self.bounce.0) {
            (Response::Touch, _) => run.v = Raw::ZERO,
            (Response::Bounce, Some(reply)) if !self.surface.surface().stops(run.v, entry.normal) => {
                run.turn(reflect::<B, W, S>(run.v, entry.normal, &self.surface, reply));
            }
            (Response::Slide | Response::DropThrough | Response::Bounce, _) => {
                if !may_be_askew::<B, W>() {
                    run.turn(project::<B, W, S>(run.v, entry.normal, &self.surface));
                } else if is_plain(run, entry) {
                    self.lose_component::<W, B>(run, made, entry, feature);
                } else {
                    if WALKS && side == SurfaceRole::Wall {
                        run.before = self.stopped::<W, B>(run.before, entry.normal);
                    }
                    return true;
                }
            }
        }
        false
    }

    /// The short way for a [plain](is_plain) hit.
    fn lose_component<W: World, B: Body>(&self, run: &mut Run<'_, B>, made: Raw, entry: &Entry, feature: &Feature) {
        let (u, lay) = (run.before, run.is_first && lay_on::<W, B>(&run.moved.body, run.before, made, entry, feature));
        run.turn(project::<B, W, S>(run.v, entry.normal, &self.surface));
        if lay {
            (run.before, run.along) = (u, Some(Plane::flat(entry.normal)));
        }
    }

    /// Takes the longest free way on from the present position, after a displacement up to a hit,
    /// if there was one. If none is free, the body [creeps](Run::creeps), or it stops.
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
        let passes = run.pass_one_way || self.passes_one_way();
        let first = hit.is_some() && core::mem::take(&mut run.is_first);
        let mut of_hit = None;
        let mut ways = Ways::none();
        if let Some((entry, _)) = hit {
            run.came |= way(made) > NEAR;
            // The hit is passed on too: if the body had to stay back from it, it is not near.
            let bend = if entry.step.is_none() { Bend::Flat } else { Bend::Convex };
            of_hit = Some(Plane { normal: entry.normal, bend });
        }
        let keeps = first || hit.is_none();
        let mut kept = keeps || run.may_keep(made);
        let alone = loop {
            if !kept {
                run.before = run.v;
            }
            let alone = ways.read::<W, B>(world, &run.moved.body, (run.before, run.rest), of_hit, passes);
            kept = kept && (keeps || run.along.is_some_and(|plane| ways.keep(&plane)));
            if kept || run.before == run.v {
                break alone;
            }
        };
        if let (true, Some((entry, feature))) = (first || !kept, hit) {
            run.flew = !lay_on::<W, B>(&run.moved.body, run.before, made, entry, feature);
        }
        if alone {
            ways.free();
        }
        // Of a corner that meets the very end of a face, the ways beside the face are as good.
        let of_face = of_hit.filter(|_| !(B::ANGULAR && hit.is_some_and(|(entry, _)| entry.at_end)));
        let normal = of_face.map_or(Axis::new(0, 0), |plane| plane.normal);
        if let Some(way) = run.choose(world, &mut ways, normal, passes) {
            let v = run.follow_way::<W, S>(way, &self.surface);
            if run.flew {
                run.before = v;
            }
            return;
        }
        ways.settle_all(world, &run.moved.body, passes);
        // One look is reserved for the surface that binds it.
        let looks = run.moved.work.iterations;
        if looks + 1 < Mover::ITERATIONS && run.creep_along::<W>(&ways) {
            return;
        }
        // A body that comes farther with each call continues in the next one.
        if run.came && looks >= Mover::ITERATIONS && hit.is_some() {
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
            self.report_binding(world, run, &ways);
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
            if !run.moved.hits.tell_of(entry.normal, feature) {
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
            // rounded. A body that is still over a face that ends at the corner sees the corner
            // from no side of its own.
            let mut normal = entry.normal;
            touched::<W, B>(&run.moved.body, feature, &mut |plane| {
                let (n, m) = (plane.normal, entry.normal);
                if plane.bend == Bend::Convex && n.x.signum() == m.x.signum() && n.y.signum() == m.y.signum() {
                    normal = plane.normal;
                }
            });
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

/// Whether a body already lay on the surface that it hit: on its plane within the rounding
/// distance, wherever that is cut, or on a hop.
///
/// A body that flies to a convex corner or arc lay on it one call ago if it left along its own
/// tangent. Moving `s` along a tangent, it rises off a circle of radius `rho` by `s^2 / 2 rho`, for
/// s well below rho.
fn lay_on<W: World, B: Body>(body: &B, u: Raw, made: Raw, hit: &Entry, feature: &Feature) -> bool {
    let n = hit.normal;
    let rounding = umul(n.x.unsigned_abs(), NEAR).wrapping_add(umul(n.y.unsigned_abs(), NEAR));
    if into(made, n).unsigned_abs() <= rounding {
        return true;
    }
    if hit.step.is_none() {
        return false;
    }
    let mut hop = false;
    touched::<W, B>(body, feature, &mut |plane| hop |= is_hop(&plane, u, made));
    hop
}

fn is_hop(plane: &Plane, u: Raw, made: Raw) -> bool {
    let Plane { normal: n, bend: Bend::Convex } = *plane else { return false };
    let (m, along) = (Raw { x: n.x, y: n.y }, across(u, n));
    !is_no_hop(m, along, u, made) && hops(m, along, made)
}

/// Whether a body has moved from `m - made` to `m`, as seen from the centre, on a hop: `|m|` is
/// rho, `along / |m|` is s.
fn hops(m: Raw, along: i64, made: Raw) -> bool {
    let (rho, was) = (isqrt64(m.len2()), isqrt64(m.sub(made).len2()));
    let s = tangential(along, Axis::new(m.x, m.y));
    s <= rho >> 2 && umul(rho, was.saturating_sub(rho).saturating_sub(NEAR)) * 2 <= usqr(s)
}

/// Whether that is known to be none without a root, as it mostly is.
///
/// - s is well above a quarter of rho. It is `|along| / |m|` down to a raw unit, and `|m|` is at
///   most `sum`.
/// - The body was too far off. With the squares M of rho and W of the distance before, the gap
///   between their roots is `(W - M) / (sqrt W + sqrt M)`. For W up to 4 M that is at least
///   `(W - M) / 3 sqrt M`. Roundings and NEAR take less than 5 from it and 1 from rho. So
///   `2 rho gap` is at least `2 (W - M) / 3 - 12 sqrt M`, and `s^2` is at most `|u|^2`. For a
///   larger W the gap is about rho or more, and `s^2` at most a sixteenth of `rho^2`.
fn is_no_hop(m: Raw, along: i64, u: Raw, made: Raw) -> bool {
    let (size, sum) = (m.len2(), u64::from(m.x.unsigned_abs().wrapping_add(m.y.unsigned_abs())));
    if along.unsigned_abs() << 2 > size.wrapping_add(sum << 3) {
        return true;
    }
    let before = m.sub(made).len2();
    (size >= 64 && before >> 2 > size) || before > size.wrapping_add(u.len2() << 1).wrapping_add(sum << 5)
}

impl<B: Body> Run<'_, B> {
    /// Whether the body may still touch the surface that it has just run along. It touches a
    /// tangent while that turns by less than a quarter of its length. For faces the
    /// [ways](Ways::keep) decide.
    fn may_keep(&self, made: Raw) -> bool {
        self.along.is_some_and(|plane| match plane.bend {
            Bend::Convex => made.len2() << 4 <= plane.normal.length_squared(),
            Bend::Flat | Bend::End | Bend::Concave { .. } => true,
        })
    }

    /// Moves along a touched surface if all ways are bound, but not in the very last position.
    /// Returns whether there was a way left to try.
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
    /// binds those, any free way: the body may be beside the surface that it hit, at its end or by
    /// the rounding of its position. A body without area is beside nothing: it may stand where two
    /// surfaces touch and leave no face.
    fn choose<'w, W: World>(&self, world: &W, ways: &'w mut Ways, hit: Axis, passes: bool) -> Option<&'w Way> {
        let body = &self.moved.body;
        let is_shut = |way: &Way| self.shut.holds(way.probe());
        let leads_out = |way: &Way| into(way.v, hit) >= 0;
        let (thin, leads) = (margin(&body.bounds()) != 0, ways.iter().any(leads_out));
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
    fn follow_way<W: World, S: Law>(&mut self, way: &Way, surface: &S) -> Raw {
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

    /// The rest of the motion at a velocity along a plane. Along a slope of tiles it is exact to
    /// the last bit, and it enters no plane.
    ///
    /// A motion enters a plane only because it was rounded toward zero, by less than a raw unit on
    /// each axis. It is moved back that far.
    fn along_plane<W: World>(&self, v: Raw, along: Option<Plane>) -> Raw {
        let d = self.turned(v);
        let Some(Plane { normal: n, .. }) = along else { return d };
        if n.x == 0 || n.y == 0 {
            return d;
        }
        if n.x.unsigned_abs() <= 2 && n.y.unsigned_abs() <= 2 && !W::BLOCKS {
            return project::<B, W, _>(d, n, &Smooth);
        }
        if into(d, n) < 0 { d.add(Raw { x: n.x.signum(), y: n.y.signum() }) } else { d }
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Raw, across, hops, is_no_hop};
    use tilesat_judge::{Random, cases};

    /// What is said without roots agrees with them: at all scales, also beside the limits.
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
            let (hop, none) = (hops(m, along, made), is_no_hop(m, along, u, made));
            assert!(!(hop && none), "{m:?} by {made:?}, {u:?}");
            seen += u32::from(hop);
            told += u32::from(none);
        }
        assert!(seen > 100 && told > 1000, "{seen} hops, {told} told");
    }
}
