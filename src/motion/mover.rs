//! The movement loop: sweep, verify, commit, respond.

use super::around::Around;
use super::body::{Body, Entry};
use super::facing::{Side, SlopeLimit};
use super::order::First;
use super::plane::{Bend, NEAR, Planes, across, is_near, may_be_askew, project, reflect, way};
use super::response::{Law, Smooth, Surface};
use super::rest::AHEAD;
use super::run::{Run, check_inside, piece_of, pieces};
use super::sweep_vertex::is_square;
use super::{MoveError, Moved, StartInside, Stuck};
use crate::num::{Axis, MOTION, Raw, Toi, Vec2, check_motion, mul_div};
use crate::shape::Aabb;
use crate::world::{Feature, Geometry, World};

/// What a body does when it runs into something. The words are bump.lua's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Response {
    /// Goes on along the surface.
    #[default]
    Slide,
    /// Stops at the first contact; its velocity is then zero, and [`Moved::remaining`] is the motion not made.
    Touch,
    /// Passes one-way faces, to drop through a platform; slides along the solid. The first one-way face that it passes in a call is reported
    /// among the hits, and is neither floor, wall nor ceiling.
    Cross,
    /// Is mirrored at the surface: exactly at a face along x or y; elsewhere rounding may take up to 2 raw units of speed. It never gains any.
    /// For less bounce, and for bounces that do not lose those either, see [`Mover::with_surface`].
    Bounce,
}

/// How bodies move: the direction that is up, and the response to what they hit.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Axis, Mover, TileKind, TileKinds, TileMap, Vec2};
///
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let map = TileMap::from_ascii("    \n    \n####\n", &KINDS)?;        // cells of 16 units: the floor is at y = 32
/// let player = Aabb::new(Vec2::from_ints(10, 20), Vec2::from_ints(18, 30))?;
///
/// let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&map, &player, Vec2::from_ints(3, 4))?;
/// assert_eq!(moved.position(), Vec2::from_ints(13, 22));              // slid along the floor
/// assert_eq!(moved.velocity, Vec2::from_ints(3, 0));
/// assert!(moved.floor && !moved.wall);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mover<S = Smooth> {
    pub(super) up: Option<Axis>,
    response: Response,
    limit: SlopeLimit,
    drop_through: bool,
    inside: StartInside,
    surface: S,
}

impl Mover {
    /// The most pieces that one motion is made of.
    pub const ITERATIONS: u32 = 4;

    /// A mover without an "up", for games that are seen from above: every hit is a wall.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            up: None,
            response: Response::Slide,
            limit: SlopeLimit::DEFAULT,
            drop_through: false,
            inside: StartInside::Report,
            surface: Smooth,
        }
    }

    /// A mover that tells floor, wall and ceiling apart; `up` may have any length (zero is no up). On a screen whose y grows downward it is [`Axis::NEG_Y`].
    #[must_use]
    pub const fn platformer(up: Axis) -> Self {
        Self { up: if up.is_zero() { None } else { Some(up) }, ..Self::new() }
    }
}

impl<S: Law> Mover<S> {
    /// The same mover for bodies with friction and restitution. Movers without link no code for them.
    ///
    /// Restitution acts with [`Response::Bounce`] alone, and that response has to be chosen too: at first a mover slides. Friction acts with all but
    /// [`Response::Touch`].
    ///
    /// They are part of the mover, so they may differ from call to call: by the body, or by the flags of the tile that it stood on.
    ///
    /// ```
    /// use tilesat::{Axis, Fx, Mover, Ratio, Response, Surface};
    /// const CRATE: Surface = Surface::new(Ratio::percent(20).unwrap(), Ratio::percent(60).unwrap()).resting_below(Fx::ONE);
    /// const MOVER: Mover<Surface> = Mover::platformer(Axis::NEG_Y).with_response(Response::Bounce).with_surface(CRATE);
    /// # let _ = MOVER;
    /// ```
    #[must_use]
    pub const fn with_surface(self, surface: Surface) -> Mover<Surface> {
        let Self { up, response, limit, drop_through, inside, .. } = self;
        Mover { up, response, limit, drop_through, inside, surface }
    }

    /// The same mover with another response.
    #[must_use]
    pub const fn with_response(self, response: Response) -> Self {
        Self { response, ..self }
    }

    /// The same mover with another limit between floor and wall: the steepest floor rises by `rise` over `run`, 1 : 1 (45 degrees) at first.
    ///
    /// Exact: a slope as steep as the limit is floor. What faces down up to as steeply is ceiling, the rest is wall. With `run` 0 all
    /// that faces up at all is floor, with `rise` 0 only what is level.
    ///
    /// ```
    /// use tilesat::{Axis, Mover};
    /// let goat = Mover::platformer(Axis::NEG_Y).with_slope_limit(2, 1); // the steep slopes of tiles, 63 degrees, are floor too
    /// # let _ = goat;
    /// ```
    #[must_use]
    pub const fn with_slope_limit(self, rise: u16, run: u16) -> Self {
        Self { limit: SlopeLimit { rise, run }, ..self }
    }

    /// The same mover that passes one-way faces, or no longer does: for the frames in which a player asks to drop through a platform, with
    /// any response. They are reported as by [`Response::Cross`].
    ///
    /// Gravity must act in that frame: the body passes what it moves into, and one that stands and has no velocity down stands on. One frame is
    /// enough where it leads into the face by a raw unit or more, for then the body is no longer entirely in front of it. A mover that drops through is
    /// not carried by one-way [`Solid`](crate::Solid)s either.
    #[must_use]
    pub const fn with_drop_through(self, drop_through: bool) -> Self {
        Self { drop_through, ..self }
    }

    /// The same mover with another answer to bodies that overlap the level already.
    #[must_use]
    pub const fn with_inside(self, inside: StartInside) -> Self {
        Self { inside, ..self }
    }

    /// Moves a body by its velocity (units per call) through a level.
    ///
    /// The body is swept, so no speed tunnels. It ends exactly on the faces along x and y that it hits, and what they do to the motion is
    /// exact: a box that lands still goes on by its whole sideways motion. At a slope, a corner or an arc it ends at most 2 raw early
    /// and never inside; wedged where no lattice point near the contact is free, it stays where that piece of its motion began.
    /// Along the slopes of tiles it goes exactly: the velocity is a multiple of the slope's direction, less than one multiple short. Through a
    /// quarter pipe it goes by one chord a call and comes out as fast as it went in, less some 3 raw a call.
    /// Sliding never lengthens the velocity and bouncing never raises its square (with a [`Speed`](super::Speed), not above that).
    ///
    /// A body that gravity presses between surfaces (a V, a bowl, two domes, a slope and a wall) comes to rest, for gravities up to an eighth of a
    /// tile a call: within 4 raw of all of them a call that leaves no velocity leaves the place as it was too, so nothing hums.
    ///
    /// A body without velocity stays where it is, and nothing is asked of the level, not even whether the body is in the solid: nothing that
    /// could lead into it is done. `overlaps` of the level tells.
    ///
    /// Mirrored scenes give mirrored bits, save where a circle meets two corners or slopes at the same moment and as squarely (+x goes first);
    /// translated scenes give the same bits; exchanging x and y does too, save for ties (x goes first) and a raw unit at corners.
    ///
    /// Cost: where no cell that the motion passes over holds anything, one look at each. Else at most [`Mover::ITERATIONS`] sweeps over the cells under the motion, enumerated in pieces as long as a cell or the body (that
    /// many look-ups also where a fast body is far from the map), and one or two exact overlap tests a sweep; [`Moved::work`] counts them. No division
    /// instruction; one square root for each slope (circles), corner and arc that is hit.
    ///
    /// # Errors
    /// [`MoveError::Range`] where a velocity component or a half extent is not below 2^28 raw (4096 units; a velocity whose length is below
    /// that stays acceptable however it is turned) or the motion would leave the domain; [`MoveError::Stuck`] where the body overlaps
    /// the level already, it is to move, and the mover [reports](StartInside) that; without a velocity nothing is asked of the level.
    #[inline(never)]
    pub fn move_and_slide<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        velocity: Vec2,
    ) -> Result<Moved<B>, MoveError> {
        check_motion(velocity, MOTION)?;
        body.check_size()?;
        let (d, mut around) = (Raw::of(velocity), Around::NOTHING);
        if d.is_zero() || flies(world, &body.bounds(), d, &mut around) {
            return Ok(Moved::freely(body.shifted(d), velocity, u32::from(!d.is_zero())));
        }
        let mut moved = Moved::freely(*body, velocity, 0);
        let mut run = Run::new(&mut moved, &mut around);
        self.begin(world, &mut run)?;
        self.slide::<W, B, false>(world, &mut run)?;
        run.end::<W>();
        Ok(moved)
    }

    pub(super) fn start<'m, W: World, B: Body>(
        &self,
        world: &W,
        moved: &'m mut Moved<B>,
        around: &'m mut Around,
    ) -> Result<Run<'m, B>, MoveError> {
        check_motion(moved.velocity, MOTION)?;
        moved.body.check_size()?;
        let mut run = Run::new(moved, around);
        self.begin(world, &mut run)?;
        Ok(run)
    }

    fn begin<W: World, B: Body>(&self, world: &W, run: &mut Run<'_, B>) -> Result<(), Stuck> {
        run.inside = run.is_stuck(world);
        if run.inside && self.inside == StartInside::Report {
            return Err(Stuck { at: run.moved.body.position().raw() });
        }
        run.start = if W::BLOCKS || run.inside { None } else { Some(run.moved.body) };
        Ok(())
    }

    /// Makes the motion; where it `WALKS` up to the first floor.
    pub(super) fn slide<W: World, B: Body, const WALKS: bool>(
        &self,
        world: &W,
        run: &mut Run<'_, B>,
    ) -> Result<(), MoveError> {
        while (run.creeps || !run.motion.is_zero()) && run.moved.work.iterations < Mover::ITERATIONS {
            let d = if !W::BLOCKS && run.creeps { run.ahead() } else { run.motion };
            check_inside(&run.moved.body.bounds(), d)?;
            run.moved.work.iterations += 1;
            let mut first = First::none();
            run.find_first(world, d, &mut first);
            let hit = first.hit::<B, W>(&run.moved.body, d);
            if !W::BLOCKS && run.creeps {
                run.creeps = false;
                if let Some((entry, feature)) = hit {
                    self.wedge::<W, B>(run, d, entry, feature);
                }
            } else if let Some((entry, feature)) = hit {
                if let Some(side) = self.meet(run, entry, feature) {
                    let made = run.advance(world, d, entry);
                    self.respond::<W, B, WALKS>(run, (d, made), side, entry, feature);
                }
            } else {
                run.arrive(world, d);
                run.motion = Raw::ZERO;
                if W::ROUND {
                    run.follow();
                }
            }
            if run.v.is_zero() || (WALKS && run.moved.floor) {
                break;
            }
        }
        Ok(())
    }

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

    /// Records a hit; what it is to a body that does not pass it.
    #[inline(never)]
    fn meet<B: Body>(&self, run: &mut Run<'_, B>, entry: &Entry, feature: &Feature) -> Option<Side> {
        let time = run.rest.raw() - run.after.raw();
        let toi = Toi::ONE.raw() - run.rest.raw() + mul_div(time, entry.num, entry.den);
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
    fn respond<W: World, B: Body, const WALKS: bool>(
        &self,
        run: &mut Run<'_, B>,
        (d, made): (Raw, Raw),
        side: Side,
        entry: &Entry,
        feature: &Feature,
    ) {
        let time = run.rest.raw() - run.after.raw();
        let bend = bend(entry, feature);
        if !made.is_zero() {
            let came = way(made) > NEAR && (W::BLOCKS || !is_hop(entry, bend));
            if W::BLOCKS || !run.planes.keep_touching(made) {
                run.planes = Planes::ahead(came);
                run.before_planes = run.v;
            } else if came && run.planes.landed {
                run.before_planes = run.v;
            }
        }
        run.rest = Toi::clamped(run.after.raw() + mul_div(time, entry.den - entry.num, entry.den));
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
        match self.response {
            Response::Touch => run.v = Raw { x: 0, y: 0 },
            Response::Bounce if !self.surface.surface().stops(run.v, entry.normal) => {
                run.turn::<W>(reflect::<B, W, S>(run.v, entry.normal, &self.surface));
            }
            Response::Slide | Response::Cross | Response::Bounce => {
                run.planes.push(entry.normal, bend);
                if !(W::ROUND && run.roll(&feature.geometry, &self.surface)) {
                    run.turn::<W>(run.planes.slide_on::<B, W, S>(run.before_planes, &self.surface));
                }
                if !W::BLOCKS {
                    run.settle();
                }
            }
        }
    }

    /// A body that would only creep along what it has hit is held between that and what it is pushed against beside it.
    #[inline(never)]
    fn wedge<W: World, B: Body>(&self, run: &mut Run<'_, B>, d: Raw, entry: &Entry, feature: &Feature) {
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

/// Whether a body flies, as most do: where all that its motion comes to is seen to be empty, no more is asked.
#[inline]
fn flies<W: World>(world: &W, bounds: &Aabb, d: Raw, around: &mut Around) -> bool {
    let pieces = pieces(world, bounds, d);
    let first = if pieces == 1 { d } else { Raw::ZERO };
    around.look(world, &piece_of(bounds, Raw::ZERO, first, pieces));
    pieces == 1 && around.is_empty() && check_inside(bounds, d).is_ok()
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
        Geometry::Vertex { e_in, e_out, .. } if is_square(e_in, e_out) => Bend::Corner,
        _ => Bend::Convex,
    }
}
