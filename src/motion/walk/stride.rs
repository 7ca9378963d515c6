//! One frame on the ground: legs along the floor, turned where it bends, and steps.

use super::Support;
use super::ground::{CONTACT, Ground, Look, along, length};
use super::walker::{SlopeSpeed, Walker};
use crate::motion::body::Body;
use crate::motion::contact::touched;
use crate::motion::free_way::FreeWay;
use crate::motion::plane::{NEAR, Pipe, across, inward, lies_along, may_be_askew, project, tangent, tangential, way};
use crate::motion::response::Smooth;
use crate::motion::run::{Checkpoint, Run, check_inside};
use crate::motion::slope_limit::SurfaceRole;
use crate::motion::ways::Ways;
use crate::motion::{MoveError, Mover};
use crate::num::{Axis, Fx, Raw, Toi, Vec2, mul_div, umul};
use crate::query::cast::moment::ratio;
use crate::world::{Feature, Geometry, World};

pub(super) struct Stride<'a, 'm, W, B> {
    pub(super) walker: &'a Walker,
    pub(super) world: &'a W,
    pub(super) run: &'a mut Run<'m, B>,
    pub(super) up: Axis,
    /// The normal of the floor.
    pub(super) floor: Axis,
    /// The speed across "up", and whether it is against `up.perp()`.
    pub(super) speed: u32,
    against: bool,
    pub(super) stepped: Fx,
    snapped: Fx,
    /// The floor at the top of the last step climbed.
    pub(super) climbed: Option<Support>,
    /// The end of a leg that was taken back to where the ground bends, and the time left there.
    ahead: Option<(Checkpoint<B>, Toi)>,
    /// The start of the last leg. For a chord, that of the leg that led to it along its pipe.
    before: Checkpoint<B>,
    /// The centre and the quadrant of the pipe in which it moves by a chord.
    pipe: (Vec2, Axis),
    /// Whether it lands on level ground in this frame.
    lands: bool,
}

/// The floor at the end of a frame, and how far the body was raised by steps and pulled down.
pub(in crate::motion) struct Footing {
    pub(in crate::motion) floor: Option<Support>,
    pub(in crate::motion) met_floor: bool,
    pub(in crate::motion) stepped: Fx,
    pub(in crate::motion) snapped: Fx,
}

/// How a blocked body continues.
enum On {
    /// Along this floor.
    Free(Axis),
    /// By roundings, to a position that may have a free way.
    Creeps([Option<Raw>; 2]),
}

impl<'a, 'm, W: World, B: Body> Stride<'a, 'm, W, B> {
    /// How often a blocked body may move by roundings to a position with a free way. It goes down
    /// to its floor, along it, down again, and makes one final attempt.
    const CREEPS: u32 = 4;

    pub(super) fn new(walker: &'a Walker, world: &'a W, run: &'a mut Run<'m, B>, up: Axis, floor: Axis) -> Self {
        let speed = across(run.v, up);
        let lands = run.moved.floor && floor.perp_dot(up) == 0;
        Self {
            walker,
            world,
            up,
            floor,
            speed: tangential(speed, up),
            against: speed < 0,
            stepped: Fx::ZERO,
            snapped: Fx::ZERO,
            climbed: None,
            ahead: None,
            before: run.here(),
            pipe: (Vec2::ZERO, Axis::X),
            lands,
            run,
        }
    }

    /// Walks for the rest of the time.
    pub(super) fn walk(&mut self) -> Result<Footing, MoveError> {
        let mut legs = 0;
        let ground = loop {
            let d = self.leg();
            if d.is_zero() || legs == Mover::ITERATIONS {
                break if self.climbed.is_none() { self.look_down() } else { None };
            }
            self.climbed = None;
            check_inside(&self.run.moved.body.bounds(), d)?;
            legs += 1;
            if !(W::ROUND && self.run.on_chord) {
                self.before = self.run.here();
            }
            if let Some(hit) = self.run.look(self.world, d) {
                if self.turn(&hit) {
                    continue;
                }
                break self.look_down();
            }
            self.run.arrive(self.world, d);
            let ground = self.look_down();
            let bends = if W::ROUND && self.run.on_chord {
                self.leave_chord(ground.as_ref())
            } else {
                legs < Mover::ITERATIONS
                    && ground.is_some_and(|ground| {
                        let drop = ground.drop();
                        way(drop) > NEAR && self.follow(d, (self.run.rest, Toi::ZERO), drop, ground.entry.normal)
                    })
            };
            if !bends {
                break ground;
            }
        };
        Ok(self.settle(ground))
    }

    /// The velocity along the floor for a part of the call's time.
    pub(super) fn velocity(&self, time: Toi) -> Raw {
        let speed = time.of_raw(self.speed as i32);
        match self.walker.speed {
            SlopeSpeed::Constant => lies_along::<B, W>(speed as u32, self.floor, self.against),
            SlopeSpeed::Projected => {
                project::<B, W, _>(tangent(speed as u32, self.up, self.against), self.floor, &Smooth)
            }
        }
    }

    /// A horizontal displacement ahead of this length; zero for a body that does not walk.
    pub(super) fn forward(&self, length: u32) -> Raw {
        tangent(if self.speed == 0 { 0 } else { length }, self.up, self.against)
    }

    /// The direction that it faces.
    pub(super) const fn facing(&self) -> Axis {
        if self.against { self.up.perp().reversed() } else { self.up.perp() }
    }

    /// The next displacement. After a landing on level ground this is the rest of the motion, to
    /// the last bit.
    fn leg(&mut self) -> Raw {
        if core::mem::take(&mut self.lands) {
            return project::<B, W, _>(self.run.motion, self.floor, &Smooth);
        }
        if W::ROUND && self.run.on_chord { self.run.motion } else { self.velocity(self.run.rest) }
    }

    /// The ground at most the walker's snap below. The look reaches one raw unit farther, because
    /// it does not meet a surface that it only touches.
    fn look_down(&mut self) -> Option<Ground> {
        let d = along(self.up, -(self.walker.snap + 1).max(CONTACT));
        self.run.look(self.world, d)
    }

    /// Handles a hit of the leg. Returns whether the body continues along the surface.
    fn turn(&mut self, hit: &Ground) -> bool {
        let Ground { d, entry, feature } = hit;
        let time = self.run.rest.raw() - self.run.after.raw();
        let toi = Toi::ONE.raw() - self.run.rest.raw() + mul_div(time, entry.num, entry.den);
        let side = self.walker.mover.side(entry.normal);
        let made = self.run.advance(self.world, *d, entry);
        let left = mul_div(time, entry.den - entry.num, entry.den);
        self.run.rest = Toi::clamped(self.run.after.raw() + left);
        let on_chord = W::ROUND && self.run.on_chord;
        (self.run.after, self.run.on_chord) = (Toi::ZERO, false);
        let climbs = side == SurfaceRole::Wall && self.climb();
        if side != SurfaceRole::Floor && !climbs && !on_chord && self.ducks(made, Toi::clamped(time - left)) {
            return true;
        }
        self.run.record(entry.normal, feature, Toi::clamped(toi));
        self.run.moved.meet(side);
        match side {
            SurfaceRole::Floor => {
                if let Some((end, left)) = self.ahead.take().filter(|_| way(made) <= NEAR) {
                    // It was a ledge, not a bend.
                    self.run.put_back(end);
                    self.run.rest = left;
                    return true;
                }
                self.floor = entry.normal;
                if W::ROUND {
                    // The way up to a pipe stays, even if its chord does not.
                    if !touched::<W, B>(self.before.body(), feature, &mut |_| ()) {
                        self.before = self.run.here();
                    }
                    self.enter(feature);
                }
                true
            }
            // It goes on: over the step now, or past a corner that roundings made it meet. The rest
            // of the frame meets the walls that still block.
            _ if climbs || self.squeeze() => {
                self.run.moved.wall = false;
                true
            }
            _ => {
                // A body that is blocked at once does not creep along by roundings, unless they
                // take it off its floor.
                let lower = |ground: Ground| way(ground.drop()) > NEAR;
                // Nor does a polygon end within a chord: mirrored, it would end a raw unit aside.
                let at_once = way(made) <= NEAR && (made.is_zero() || !self.look_down().is_none_or(lower));
                if at_once || (on_chord && (B::ANGULAR || way(made) <= NEAR)) {
                    self.run.put_back(self.before);
                }
                // A ceiling that ends the run counts as a wall.
                self.run.moved.wall = true;
                self.speed = 0;
                false
            }
        }
    }

    /// Continues along lower ground, if a leg that a wall or a ceiling blocks had left its floor
    /// behind. Returns whether it does. The hit does not count, because no motion along the ground
    /// leads to it.
    ///
    /// In a tunnel that bends down, a straight leg passes the bend and meets the ceiling.
    #[inline(never)]
    fn ducks(&mut self, made: Raw, used: Toi) -> bool {
        if way(made) <= NEAR {
            return false;
        }
        let Some(Ground { d: down, entry, .. }) = self.look_down() else { return false };
        let (drop, n) = (entry.displacement(down), entry.normal);
        if way(drop) <= NEAR || self.walker.mover.side(n) != SurfaceRole::Floor {
            return false;
        }
        if self.follow(made, (used, self.run.rest), drop, n) {
            return true;
        }
        // No bend, but a ledge.
        self.snapped += length(self.run.advance(self.world, down, &entry));
        (self.floor, self.ahead) = (n, None);
        true
    }

    /// Continues from where a leg is blocked: by the longest free way along a floor, or level. The
    /// free directions at this position and the level speed bound it.
    ///
    /// At a joint of a ramp and a corridor, neither may be free from any lattice point in reach.
    /// Then the body moves up to a point at which one is.
    #[inline(never)]
    fn squeeze(&mut self) -> bool {
        if !may_be_askew::<B, W>() {
            return false;
        }
        let start = self.run.here();
        for _ in 0..Self::CREEPS {
            match self.way_on() {
                On::Free(floor) => {
                    self.floor = floor;
                    return true;
                }
                On::Creeps(probes) => {
                    let down = along(self.up, -CONTACT);
                    if !(self.creep(down) || probes.into_iter().flatten().any(|probe| self.creep(probe))) {
                        break;
                    }
                }
            }
        }
        self.run.put_back(start);
        false
    }

    /// A separate function: the list of ways is not on the stack while the body moves along them.
    #[inline(never)]
    fn way_on(&self) -> On {
        let (body, passes) = (&self.run.moved.body, self.run.pass_one_way);
        let mut ways = Ways::none();
        ways.read::<W, B>(self.world, body, (self.forward(self.speed), self.run.rest), None, passes);
        let is_floor = |way: &FreeWay| way.along.is_none_or(|p| self.walker.mover.side(p.normal) == SurfaceRole::Floor);
        if let Some(way) = ways.first_free(self.world, body, passes, &is_floor).and_then(|k| ways.way(k)) {
            return On::Free(way.along.map_or(self.up, |plane| plane.normal));
        }
        ways.settle_all(self.world, body, passes);
        let mut creeps = ways.iter().filter(|way| is_floor(way) && way.can_creep()).map(FreeWay::probe);
        On::Creeps([creeps.next(), creeps.next()])
    }

    /// Moves up to the first hit of a displacement. Returns whether the body moved.
    ///
    /// The time of a corner or an arc is a lower bound, less than a raw unit early. The next point
    /// may therefore be free too. It passes no face: a touched face is met before the corner, and
    /// the others are at least a raw unit away.
    fn creep(&mut self, d: Raw) -> bool {
        let Some(hit) = self.run.look(self.world, d) else { return false };
        let next = Raw { x: d.x.signum(), y: d.y.signum() };
        let round = hit.entry.step.is_some();
        !self.run.advance(self.world, hit.d, &hit.entry).is_zero()
            || (round && !self.run.commit(self.world, d, &[next]).is_zero())
    }

    /// Enters a quarter pipe by a chord: along its tangent it would hit the pipe again at once.
    fn enter(&mut self, feature: &Feature) {
        let Geometry::Arc { centre, radius, quadrant, convex: false } = feature.geometry else { return };
        let (at, r) = self.run.moved.body.toward(quadrant);
        let pipe = Pipe { m: at.sub(Raw::of(centre)), r: radius.wrapping_sub(r), quadrant };
        if let Some(chord) = pipe.chord(self.velocity(Toi::ONE), self.run.rest, &Smooth) {
            (self.run.motion, self.run.after, self.run.on_chord) = (chord.way, chord.after, true);
            self.pipe = (centre, quadrant);
        }
    }

    /// After a whole chord: whether time is left for the ground beyond it. If the chord ends where
    /// the pipe is too steep, it is not made, nor is the leg in the pipe that led to it. Otherwise
    /// the body would creep to the limit, and over it by a rounding.
    fn leave_chord(&mut self, ground: Option<&Ground>) -> bool {
        (self.run.rest, self.run.after, self.run.on_chord) = (self.run.after, Toi::ZERO, false);
        let (centre, quadrant) = self.pipe;
        let floor = match ground.map(|ground| (ground.entry.normal, ground.feature.geometry)) {
            Some((normal, _)) if self.walker.mover.side(normal) == SurfaceRole::Floor => Some(normal),
            Some((_, Geometry::Arc { centre: of, convex: false, .. })) if of == centre => None,
            // Where the pipe ends there is no ground, or other ground that is too steep, such as
            // another pipe that falls away there. The body leaves it along its tangent.
            _ => Some(inward(self.run.moved.body.toward(quadrant).0.sub(Raw::of(centre)))),
        };
        if let Some(floor) = floor {
            self.floor = floor;
            return self.run.rest != Toi::ZERO;
        }
        self.run.put_back(self.before);
        self.run.moved.wall = true;
        (self.speed, self.run.rest) = (0, Toi::ZERO);
        true
    }

    /// After a leg: whether the ground under it bent down. Then a part of the leg follows the new
    /// floor, and its time is added to the time `left`.
    ///
    /// ```text
    ///   o--->X----> d       The line of the leg meets the line of the ground at its end, `drop` below, in X.
    ///  ______  `.  |drop    The part of the leg beyond X is  -(drop . n) / (d . n)  with the ground's normal n.
    ///        `.  `.v
    ///          `.  o
    /// ```
    #[inline(never)]
    fn follow(&mut self, d: Raw, (used, left): (Toi, Toi), drop: Raw, n: Axis) -> bool {
        let (depth, away) = (n.dot(Axis::new(drop.x, drop.y)).wrapping_neg(), n.dot(Axis::new(d.x, d.y)));
        if depth <= 0 || away <= 0 || self.walker.mover.side(n) != SurfaceRole::Floor {
            return false;
        }
        // Two raw units beyond it: before it, the new floor's direction would lead into the old
        // one.
        let beyond = mul_div(2, Toi::ONE.raw(), way(d));
        let part = Toi::clamped(ratio(depth as u64, away as u64).raw().saturating_sub(beyond));
        let end = self.run.here();
        let back = Raw { x: part.of_raw(d.x).wrapping_neg(), y: part.of_raw(d.y).wrapping_neg() };
        // A raw unit higher, in case rounding led into the floor that it comes back to.
        let higher = back.add(Raw { x: self.up.x.signum(), y: self.up.y.signum() });
        if self.run.commit(self.world, d.reversed(), &[back, higher]).is_zero() {
            return false;
        }
        self.run.rest = Toi::clamped(left.raw() + (umul(used.raw(), part.raw()) >> 30) as u32);
        (self.floor, self.ahead) = (n, Some((end, left)));
        true
    }

    /// Takes a blocked body down along a wall that leans on it from below, to a floor within the
    /// snap. Over a dome a leg ends a little higher than the floor beside such a wall.
    #[inline(never)]
    fn slip(&mut self, wall: &Ground) -> Option<Support> {
        if self.speed != 0 || wall.entry.step.is_some() {
            return None;
        }
        let down = project::<B, W, _>(along(self.up, -self.walker.snap), wall.entry.normal, &Smooth);
        let floor = self.run.look(self.world, down)?;
        let support = self.walker.mover.support(&floor)?;
        self.snapped += length(self.run.advance(self.world, floor.d, &floor.entry));
        Some(support)
    }

    /// Puts the body on the ground, or lets it leave the ground.
    fn settle(&mut self, ground: Option<Ground>) -> Footing {
        let mut support = self.climbed.or_else(|| ground.as_ref().and_then(|ground| self.footing(ground)));
        if let (None, Some(ground)) = (support, &ground) {
            let near = self.run.floor_near(self.world, &self.walker.mover, self.up);
            support = if near.is_some() || !may_be_askew::<B, W>() { near } else { self.slip(ground) };
        }
        self.run.v =
            if support.is_some() { tangent(self.speed, self.up, self.against) } else { self.velocity(Toi::ONE) };
        self.run.motion = self.velocity(self.run.rest);
        self.run.moved.floor |= support.is_some();
        if let (Some(ground), Some(_)) = (ground, support) {
            // Roundings do not pull down a body that does not walk, either.
            if way(ground.drop()) > NEAR || self.speed != 0 {
                let made = self.run.advance(self.world, ground.d, &ground.entry);
                self.snapped += if way(made) > NEAR { length(made) } else { Fx::ZERO };
            }
        }
        Footing { floor: support, met_floor: true, stepped: self.stepped, snapped: self.snapped }
    }
}
