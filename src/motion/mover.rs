//! The movement loop: sweep, verify, commit, respond.

use super::body::{Body, is_by_lines};
use super::order::First;
use super::plane::may_be_askew;
use super::response::{Bounce, ByFlags, ByHit, Law, Plain, Response, Responses, Smooth, Surface};
use super::run::{Run, check_inside, is_free};
use super::search::{Around, CELLS, check_cells};
use super::slope_limit::SlopeLimit;
use super::{Hit, MoveError, Moved, StartInside, Stuck, Work};
use crate::num::{Axis, MOTION, Raw, Toi, Vec2, check_motion, mul_div};
use crate::world::{Feature, World};

/// How bodies move: the direction that is up, and the response to hits.
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias("KinematicBody", "kinematic"))]
pub struct Mover<S = Smooth> {
    pub(super) up: Option<Axis>,
    pub(super) response: Response,
    pub(super) bounce: Bounce,
    pub(super) limit: SlopeLimit,
    pub(super) drop_through: bool,
    pub(super) inside: StartInside,
    pub(super) surface: S,
}

impl Mover {
    /// The most pieces that one motion consists of.
    pub const ITERATIONS: u32 = 4;

    /// The most cells that one motion may visit, counted for each of its
    /// [pieces](Self::move_and_slide). A motion that visits more cells is refused. The limit is a
    /// square of 512 cells a side. A body of one cell, where a cell is a unit, may move 4096 units
    /// per call.
    pub const CELLS: u32 = CELLS;

    /// A mover without an "up", for top-down games: every hit is a wall.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            up: None,
            response: Response::Slide,
            bounce: Bounce::NONE,
            limit: SlopeLimit::DEFAULT,
            drop_through: false,
            inside: StartInside::Report,
            surface: Smooth,
        }
    }

    /// A mover that distinguishes floor, wall and ceiling. `up` may have any [length](Axis); zero
    /// means no up. On a screen whose y grows downward it is [`Axis::NEG_Y`].
    #[must_use]
    pub const fn platformer(up: Axis) -> Self {
        Self { up: if up.is_zero() { None } else { Some(up.with_opposite()) }, ..Self::new() }
    }
}

impl<S: Plain> Mover<S> {
    /// Adds friction and restitution. A mover without a surface links no code for them.
    ///
    /// Call this before [`with_responses`](Self::with_responses) or
    /// [`with_answers`](Self::with_answers): the mover that they return has no such method.
    ///
    /// Restitution acts only with [`Response::Bounce`], and a new mover slides: choose that
    /// response too. Friction acts with every response but [`Response::Touch`].
    ///
    /// The surface is a part of the mover, so you can choose it for each call. It may depend on the
    /// body, or on the flags of the tile on which the body stood.
    ///
    /// ```
    /// use tilesat::{Axis, Fx, Mover, Ratio, Response, Surface};
    /// const CRATE: Surface = Surface::new(Ratio::percent(20).unwrap(), Ratio::percent(60).unwrap()).resting_below(Fx::ONE);
    /// const MOVER: Mover<Surface> = Mover::platformer(Axis::NEG_Y).with_response(Response::Bounce).with_surface(CRATE);
    /// # let _ = MOVER;
    /// ```
    ///
    /// ```compile_fail
    /// use tilesat::{Mover, Surface, motion::Responses};
    /// let _ = Mover::new().with_responses(Responses::NONE).with_surface(Surface::SLICK); // the wrong order
    /// ```
    #[must_use]
    pub const fn with_surface(self, surface: Surface) -> Mover<Surface> {
        self.only_with(surface)
    }
}

impl<S: Law> Mover<S> {
    /// With a surface in place of the surface and all responses by hit.
    pub(crate) const fn only_with(self, surface: Surface) -> Mover<Surface> {
        let Self { up, response, bounce, limit, drop_through, inside, .. } = self;
        Mover { up, response, bounce, limit, drop_through, inside, surface }
    }

    /// Sets the responses to surfaces with flags.
    ///
    /// A mover without such a table links no code for it. If the mover has a surface, call
    /// [`with_surface`](Self::with_surface) first.
    ///
    /// ```
    /// use tilesat::{Aabb, Mover, MoveError, Response, TileKind, TileKinds, TileMap, Vec2, motion::Responses};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'w', TileKind::FULL.with_flags(1));
    /// let level = TileMap::from_ascii("..#\n..w", &KINDS)?; // stone above wood, at x = 32
    /// let arrow = Mover::new().with_responses(Responses::NONE.touching(1).otherwise(Response::Bounce));
    /// let shot = |y| -> Result<Vec2, MoveError> {
    ///     let at = Aabb::from_size(Vec2::from_ints(8, y), Vec2::from_ints(4, 2))?;
    ///     Ok(arrow.move_and_slide(&level, &at, Vec2::from_ints(40, 0))?.velocity)
    /// };
    /// assert_eq!((shot(4)?, shot(20)?), (Vec2::from_ints(-40, 0), Vec2::ZERO)); // it sticks in wood
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub const fn with_responses(self, responses: Responses) -> Mover<ByFlags<S>> {
        let Self { up, response, bounce, limit, drop_through, inside, surface } = self;
        let bounce = if responses.bounces() { Bounce::LINKED } else { bounce };
        Mover { up, response, bounce, limit, drop_through, inside, surface: ByFlags { surface, responses } }
    }

    /// Sets a function that returns the response to each hit. It may use the flags of a tile, the
    /// [key](Hit::solid) of a solid, the normal, and whether the face is one-way. `None`
    /// means the mover's own response. A mover without such a function links no code for it.
    ///
    /// It must be a pure function of the hit. To learn what a body passed, see
    /// [`move_along`](Self::move_along). If the mover has a surface, call
    /// [`with_surface`](Self::with_surface) first.
    ///
    /// ```
    /// use tilesat::motion::{ByHit, Hit};
    /// use tilesat::{Aabb, Axis, Joined, Mover, Response, Solid, Solids, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// fn answer(hit: &Hit) -> Option<Response> {
    ///     let trampoline = hit.solid() == Some(7);
    ///     if trampoline { Some(Response::Bounce) } else { (hit.axis.y > 0).then_some(Response::Touch) }
    /// }
    /// const MOVER: Mover<ByHit<fn(&Hit) -> Option<Response>>> = Mover::platformer(Axis::NEG_Y).with_answers(answer);
    ///
    /// let level = TileMap::from_ascii("####\n....\n....\n####", &KINDS)?; // free from y = 16 to 48
    /// let trampoline = [Solid::new(Aabb::new(Vec2::from_ints(0, 44), Vec2::from_ints(16, 48))?, 7)?];
    /// let solids = Solids::new(&trampoline);
    /// let level = Joined::new(&level, &solids);
    /// let after = |x, v| {
    ///     let body = Aabb::new(Vec2::from_ints(x, 28), Vec2::from_ints(x + 8, 36)).unwrap();
    ///     MOVER.move_and_slide(&level, &body, v).map(|moved| moved.velocity)
    /// };
    /// assert_eq!(after(4, Vec2::from_ints(1, 12))?, Vec2::from_ints(1, -12)); // the trampoline
    /// assert_eq!(after(24, Vec2::from_ints(1, -14))?, Vec2::ZERO); // the ceiling
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[doc(alias("filter", "collision filter"))]
    pub const fn with_answers<F: Fn(&Hit) -> Option<Response> + Copy>(self, answers: F) -> Mover<ByHit<F, S>> {
        let Self { up, response, limit, drop_through, inside, surface, .. } = self;
        let surface = ByHit { surface, answers };
        Mover { up, response, bounce: Bounce::LINKED, limit, drop_through, inside, surface }
    }

    /// Sets the response to hits.
    #[must_use]
    pub const fn with_response(self, response: Response) -> Self {
        let bounce = if matches!(response, Response::Bounce) { Bounce::LINKED } else { self.bounce };
        Self { response, bounce, ..self }
    }

    /// Sets the limit between floor and wall. The steepest floor rises by `rise` over `run`; the
    /// default is 1 : 1 (45 degrees).
    ///
    /// Exact: a slope as steep as the limit is floor. A surface that faces down at most as steeply
    /// is ceiling, and the rest is wall. With `run` 0 every surface that faces up at all is floor.
    /// With `rise` 0 only level ground is.
    ///
    /// ```
    /// use tilesat::{Axis, Mover};
    /// let _goat = Mover::platformer(Axis::NEG_Y).with_slope_limit(2, 1); // the steep slopes of tiles, 63 degrees, are floor too
    /// ```
    #[must_use]
    #[doc(alias("floor_max_angle", "max_slope_climb_angle"))]
    pub const fn with_slope_limit(self, rise: u16, run: u16) -> Self {
        Self { limit: SlopeLimit { rise, run }, ..self }
    }

    /// Sets whether the mover passes one-way faces, with any response. Use it while a player drops
    /// through a platform. Hits report the faces as with [`Response::DropThrough`].
    ///
    /// Gravity must act in that frame: the body passes only what it moves into. A body that stands
    /// without a downward velocity stays on the platform. One frame is enough if it moves into the
    /// face by a raw unit or more. The body is then no longer entirely in front of it. One-way
    /// [`Solid`](crate::Solid)s do not carry a mover that drops through, either.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Mover, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'-', TileKind::ONE_WAY_UP);
    /// let level = TileMap::from_ascii("..\n--", &KINDS)?; // the platform is at y = 16
    /// let (mover, gravity) = (Mover::platformer(Axis::NEG_Y), Vec2::from_ints(0, 1));
    /// let body = Aabb::new(Vec2::from_ints(4, 6), Vec2::from_ints(14, 16))?;
    /// assert!(mover.move_and_slide(&level, &body, gravity)?.floor);
    /// let drops = mover.with_drop_through(true).move_and_slide(&level, &body, gravity)?;
    /// assert_eq!((drops.floor, drops.position()), (false, Vec2::from_ints(4, 7)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[doc(alias("one way platform", "jump-through", "fall-through"))]
    pub const fn with_drop_through(self, drop_through: bool) -> Self {
        Self { drop_through, ..self }
    }

    /// Sets the treatment of bodies that already overlap the level.
    ///
    /// ```
    /// use tilesat::{Aabb, Mover, TileKind, TileKinds, TileMap, Vec2, motion::StartInside};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("#...", &KINDS)?; // solid up to x = 16
    /// let (body, right) = (Aabb::new(Vec2::from_ints(12, 2), Vec2::from_ints(22, 12))?, Vec2::from_ints(8, 0));
    /// assert!(Mover::new().move_and_slide(&level, &body, right).is_err());
    /// let leaves = Mover::new().with_inside(StartInside::Ignore).move_and_slide(&level, &body, right)?;
    /// assert_eq!(leaves.position(), Vec2::from_ints(20, 2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub const fn with_inside(self, inside: StartInside) -> Self {
        Self { inside, ..self }
    }

    /// Moves a body by its velocity (units per call) through a level.
    ///
    /// The body is swept, so no speed tunnels. It ends exactly on the faces along x and y that it
    /// hits, and they change the motion exactly. So a box that lands still makes its whole sideways
    /// motion. At a slope, a corner or an arc it ends at most 2 raw early, and never inside. If it
    /// is wedged and no lattice point near the contact is free, it ends 4, 8, 16 raw or so early.
    /// The gap decides how far. If none is free there either, it ends where that piece of its
    /// motion began.
    ///
    /// The remaining velocity is the longest projection of the velocity that no surface blocks.
    /// Only surfaces that the body touches *at that position* count. Surfaces that it has left do
    /// not. Along the slopes of tiles the direction is exact: the velocity is a multiple of the
    /// slope's direction, less than one multiple short. Through a quarter pipe the body moves by
    /// one chord per call. It leaves as fast as it entered, less about 3 raw per call. No response
    /// raises the square of the velocity (with a [`Speed`](super::Speed), not above that).
    ///
    /// A body that gravity presses between surfaces (a V, a bowl, two domes, a slope and a wall)
    /// stops. This holds for gravities up to a twentieth of a tile per call squared. Each
    /// displacement is a fraction of its velocity, so the body does not jitter. Without friction a
    /// half pipe swings a body for ever, up to 216 units higher in 40 000 calls. A friction of 0.5
    /// % ends both.
    ///
    /// With zero velocity the call returns at once. It does not look at the level, and does not
    /// report a body inside the solid. Use `overlaps` of the level to test for that.
    ///
    /// Mirrored scenes give mirrored bits, with two exceptions. A circle that meets two corners,
    /// slopes or arcs at once and equally squarely takes the one toward +x first. If a corner of a
    /// polygon or oriented box meets a corner, it may end a raw unit off, or bounce off the other
    /// side. That happens in 1 of 100 000 motions. Translated scenes give the same bits. So do
    /// scenes with x and y exchanged, except for ties (x wins) and a raw unit at corners.
    ///
    /// The corner between two slanted tiles has the flags of one of them, in a mirrored level those
    /// of the other one. A round body that rests on it has those flags.
    ///
    /// Cost: one look at each cell under the motion, if all are empty. Otherwise at most
    /// [`Mover::ITERATIONS`] sweeps over these cells, in pieces as long as a cell or the body. A
    /// fast body needs as many look-ups even far from the map. Each sweep needs one or two exact
    /// overlap tests, and in a gap that closes slowly up to 196; [`Moved::work`] counts them. No
    /// division instruction; one square root for each slope (circles), corner and arc that is hit.
    ///
    /// # Errors
    /// - [`MoveError::Range`] if a velocity component or a half extent is not below 2^28 raw (4096
    ///   units). A velocity of less than 4096 units is accepted in every direction.
    /// - [`MoveError::Range`] if the motion would leave the domain, unobstructed or with a new
    ///   direction after a hit, or if it visits more than [`Mover::CELLS`] cells.
    /// - [`MoveError::Range`] at any velocity, even zero, for a body that cannot move: a slanted
    ///   capsule, one without radius, or an [`AnyShape`](crate::shape::AnyShape) without an area.
    /// - [`MoveError::Stuck`] if the body moves, already overlaps the level, and the mover
    ///   [reports](StartInside) that.
    #[inline(never)]
    #[doc(alias("moveAndCollide", "move_and_collide", "moveAndSlide", "world:move"))]
    pub fn move_and_slide<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        velocity: Vec2,
    ) -> Result<Moved<B>, MoveError> {
        check_motion(velocity, MOTION)?;
        body.check_size()?;
        let (d, mut around) = (Raw::of(velocity), Around::nothing());
        // One copy of the result for bodies that fly and bodies that rest.
        let moves = !d.is_zero();
        let pieces = if moves { around.begin(world, body, d, true)? } else { 0 };
        if pieces == 0 {
            world.made(d);
            return Ok(Moved::freely(body.shifted(d), velocity, moves.into()));
        }
        if is_by_lines::<W, B>() {
            // Nothing has been looked at. Made here, the state costs nothing if the body flies: 11
            // of 325 instructions on a Cortex-M0.
            around = Around::nothing();
        }
        self.run_into(world, body, velocity, pieces, &mut around)
    }

    /// The response to a hit of this feature.
    pub(super) fn response_to(&self, normal: Axis, feature: &Feature, toi: Toi) -> Response {
        self.surface.response_to(&Hit::of(normal, feature, toi)).unwrap_or(self.response)
    }

    pub(super) fn start<'m, W: World, B: Body>(
        &self,
        world: &W,
        moved: &'m mut Moved<B>,
        around: &'m mut Around,
    ) -> Result<Run<'m, B>, MoveError> {
        check_motion(moved.velocity, MOTION)?;
        moved.body.check_size()?;
        check_cells(world, moved.body.extent(), Raw::of(moved.velocity))?;
        let free = is_free(around, &moved.body);
        let inside = !free && self.is_inside(world, &moved.body, &mut moved.work)?;
        let mut run = Run::new(moved, around);
        run.inside = inside;
        Ok(run)
    }

    /// Whether the body overlaps the level, if the mover ignores that.
    pub(super) fn is_inside<W: World, B: Body>(&self, world: &W, body: &B, work: &mut Work) -> Result<bool, Stuck> {
        work.checks += 1;
        let inside = body.overlaps_world(world);
        self.check_start(body, inside).map(|()| inside)
    }

    /// Refuses a body that starts inside the solid, if the mover reports that.
    pub(super) fn check_start<B: Body>(&self, body: &B, inside: bool) -> Result<(), Stuck> {
        let stuck = inside && self.inside == StartInside::Report;
        if stuck { Err(Stuck { at: body.position().raw() }) } else { Ok(()) }
    }

    /// Makes the motion. With `WALKS`, it ends at the first floor.
    pub(super) fn slide<W: World, B: Body, const WALKS: bool>(
        &self,
        world: &W,
        run: &mut Run<'_, B>,
        first: &mut First,
    ) -> Result<(), MoveError> {
        while !run.motion.is_zero() && run.moved.work.iterations < Mover::ITERATIONS {
            let d = run.motion;
            check_inside(&run.moved.body.bounds(), d)?;
            run.moved.work.iterations += 1;
            *first = First::none();
            run.find_first(world, d, first);
            if self.follow::<W, B, WALKS>(world, run, d, first) {
                break;
            }
        }
        Ok(())
    }

    /// Makes a motion up to its first hit. Returns whether the motion is complete.
    #[inline(never)]
    pub(super) fn follow<W: World, B: Body, const WALKS: bool>(
        &self,
        world: &W,
        run: &mut Run<'_, B>,
        d: Raw,
        first: &First,
    ) -> bool {
        let mut hit = first.hit::<B, W>(&run.moved.body, d);
        // Whether to choose among the free directions, and the motion made so far.
        let (mut chooses, mut made) = (false, Raw::ZERO);
        if may_be_askew::<B, W>() && run.creeps {
            (chooses, made) = (true, self.creep::<W, B>(world, run, d, hit.take()));
        } else if let Some((entry, feature)) = hit {
            let time = run.rest.raw() - run.after.raw();
            let used = mul_div(time, entry.num, entry.den);
            if let Some(side) = self.meet(run, used, entry.normal, feature) {
                let known = (time == Toi::ONE.raw()).then_some(used);
                made = run.place(world, d, entry.displacement_at(d, known), run.course::<W>(d));
                chooses = self.respond::<W, B, WALKS>(run, used, (d, made), (side, entry, feature));
            }
        } else {
            run.arrive(world, d);
            run.motion = Raw::ZERO;
            if W::ROUND {
                run.follow();
            }
        }
        if chooses {
            self.go_along(world, run, made, hit);
        }
        run.v.is_zero() || (WALKS && run.moved.floor && !run.falls)
    }
}
