//! The movement loop: sweep, verify, commit, respond.

use super::body::{Body, Entry};
use super::plane::{NEAR, Planes, reflect, way};
use super::run::{Run, check_inside};
use super::{MoveError, Moved, Placed, Stuck};
use crate::num::{Axis, MOTION, Raw, Toi, Vec2, check_motion, mul_div};
use crate::world::{Feature, World};

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
    /// Is mirrored at the surface: exactly at a face along x or y; elsewhere rounding may take up to 3 raw units of speed. It never gains any.
    /// For less bounce, scale the velocity that comes back.
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
/// let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&map, &[], &player, Vec2::from_ints(3, 4))?;
/// assert_eq!(moved.position(), Vec2::from_ints(13, 22));              // slid along the floor
/// assert_eq!(moved.velocity, Vec2::from_ints(3, 0));
/// assert!(moved.floor && !moved.wall);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mover {
    up: Option<Axis>,
    response: Response,
}

impl Mover {
    /// The most pieces that one motion is made of.
    pub const ITERATIONS: u32 = 4;

    /// A mover without an "up", for games that are seen from above: every hit is a wall.
    #[must_use]
    pub const fn new() -> Self {
        Self { up: None, response: Response::Slide }
    }

    /// A mover that tells floor, wall and ceiling apart; `up` may have any length (zero is no up). On a screen whose y grows downward it is [`Axis::NEG_Y`].
    #[must_use]
    pub const fn platformer(up: Axis) -> Self {
        Self { up: if up.is_zero() { None } else { Some(up) }, response: Response::Slide }
    }

    /// The same mover with another response.
    #[must_use]
    pub const fn with_response(self, response: Response) -> Self {
        Self { up: self.up, response }
    }

    /// Moves a body by its velocity (units per call) through a level.
    ///
    /// The body is swept, so no speed tunnels. It ends exactly on the faces along x and y that it hits, and what they do to the motion is
    /// exact: a box that lands still goes on by its whole sideways motion. At a slope, a corner or an arc it ends at most 2 raw early
    /// and never inside; wedged where no lattice point near the contact is free, it stays where that piece of its motion began.
    /// Along the slopes of tiles it goes exactly: the velocity is a multiple of the slope's direction, less than one multiple short. Through a
    /// quarter pipe it goes by one chord a call and comes out as fast as it went in, less some 3 raw a call.
    /// Sliding never lengthens the velocity and bouncing never raises its square.
    ///
    /// Mirrored scenes give mirrored bits, save where a circle meets two corners or slopes at the same moment and as squarely (+x goes first);
    /// translated scenes give the same bits; exchanging x and y does too, save for ties (x goes first) and a raw unit at corners.
    ///
    /// `placed` is for moving solids; there are none yet, pass `&[]`.
    ///
    /// Cost: at most [`Mover::ITERATIONS`] sweeps over the cells under the motion, enumerated in pieces as long as a cell or the body (that
    /// many look-ups also where a fast body is far from the map), and one or two exact overlap tests a sweep; [`Moved::work`] counts them. No division
    /// instruction; one square root for each slope (circles), corner and arc that is hit.
    ///
    /// # Errors
    /// [`MoveError::Range`] where a velocity component or a half extent is not below 2^28 raw (4096 units; a velocity whose length is below
    /// that stays acceptable however it is turned) or the motion would leave the domain; [`MoveError::Stuck`] where the body overlaps
    /// the level already.
    pub fn move_and_slide<W: World, B: Body>(
        &self,
        world: &W,
        placed: &[Placed<'_>],
        body: &B,
        velocity: Vec2,
    ) -> Result<Moved<B>, MoveError> {
        // No value of `Placed` exists, so there is nothing to sweep against.
        let _ = placed;
        check_motion(velocity, MOTION)?;
        body.check_size()?;
        let mut run = Run::new(*body, Raw::of(velocity));
        if run.overlaps(world, body) {
            return Err(MoveError::Stuck(Stuck { at: body.position().raw() }));
        }
        while !run.motion.is_zero() && run.moved.work.iterations < Self::ITERATIONS {
            let d = run.motion;
            check_inside(&run.moved.body.bounds(), d)?;
            run.moved.work.iterations += 1;
            match run.first_hit(world, d) {
                None => {
                    run.commit(world, d, &[d]);
                    run.motion = Raw { x: 0, y: 0 };
                    if W::ROUND {
                        run.follow();
                    }
                }
                Some((entry, feature)) => self.respond(world, &mut run, d, &entry, &feature),
            }
            if run.v.is_zero() {
                break;
            }
        }
        let remaining = if W::ROUND { run.motion.add(run.made_in(run.after)) } else { run.motion };
        run.moved.remaining = remaining.vec2();
        run.moved.velocity = run.v.vec2();
        Ok(run.moved)
    }

    fn respond<W: World, B: Body>(&self, world: &W, run: &mut Run<B>, d: Raw, entry: &Entry, feature: &Feature) {
        let time = run.rest.raw() - run.after.raw();
        let toi = Toi::ONE.raw() - run.rest.raw() + mul_div(time, entry.num, entry.den);
        run.record(entry.normal, feature, Toi::clamped(toi));
        if feature.one_way && self.response == Response::Cross {
            run.pass_one_way = true;
            return;
        }
        run.classify(self.up, entry.normal);
        let made = run.advance(world, d, entry);
        if !made.is_zero() {
            let came = way(made) > NEAR;
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
        match self.response {
            Response::Slide | Response::Cross => {
                run.planes.push(entry.normal, entry.step.is_none());
                if !(W::ROUND && run.roll(&feature.geometry)) {
                    run.turn::<W>(run.planes.slide::<B, W>(run.before_planes));
                }
            }
            Response::Touch => run.v = Raw { x: 0, y: 0 },
            Response::Bounce => run.turn::<W>(reflect::<B, W>(run.v, entry.normal)),
        }
    }
}
