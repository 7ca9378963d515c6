//! The movement loop: sweep, verify, commit, respond.

use super::body::{Body, Entry};
use super::plane::{Planes, reflect};
use super::{Hit, Hits, MoveError, Moved, Placed, Stuck, Work};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, DOMAIN, MOTION, Raw, Toi, Vec2, check_motion, mul_div};
use crate::shape::Aabb;
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
    /// Is mirrored at the surface: exactly at a face; at a corner rounding may take up to 3 raw units of speed. It never gains any. For less
    /// bounce, scale the velocity that comes back.
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
    /// The body is swept, so no speed tunnels. It ends exactly on the faces that it hits, and what faces do to the motion is exact: a box
    /// that lands still goes on by its whole sideways motion. At a circle's corner contact it ends at most 2 raw early and never inside;
    /// wedged between two corners where no lattice point near the contact is free, it stays where that piece of its motion began.
    /// Sliding never lengthens the velocity and bouncing never raises its square.
    ///
    /// Mirrored scenes give mirrored bits, save where a circle meets two corners at the same moment and as squarely (+x goes first);
    /// translated scenes give the same bits; exchanging x and y does too, save for ties (x goes first) and a raw unit at corners.
    ///
    /// `placed` is for moving solids; there are none yet, pass `&[]`.
    ///
    /// Cost: at most [`Mover::ITERATIONS`] sweeps over the cells under the motion, enumerated in pieces as long as a cell or the body (that
    /// many look-ups also where a fast body is far from the map), and one or two exact overlap tests a sweep; [`Moved::work`] counts them. No division instruction; one square root per corner that is hit.
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
                    run.commit(world, &[d]);
                    run.motion = Raw { x: 0, y: 0 };
                }
                Some((entry, feature)) => self.respond(world, &mut run, d, &entry, &feature),
            }
            if run.v.is_zero() {
                break;
            }
        }
        run.moved.remaining = run.motion.vec2();
        run.moved.velocity = run.v.vec2();
        Ok(run.moved)
    }

    fn respond<W: World, B: Body>(&self, world: &W, run: &mut Run<B>, d: Raw, entry: &Entry, feature: &Feature) {
        let toi = Toi::ONE.raw() - run.rest.raw() + mul_div(run.rest.raw(), entry.num, entry.den);
        run.record(entry.normal, feature, Toi::clamped(toi));
        if feature.one_way && self.response == Response::Cross {
            run.pass_one_way = true;
            return;
        }
        run.classify(self.up, entry.normal);
        let made = run.advance(world, d, entry);
        if !made.is_zero() {
            run.planes = Planes::NONE;
            run.before_planes = run.v;
        }
        run.rest = Toi::clamped(mul_div(run.rest.raw(), entry.den - entry.num, entry.den));
        run.motion = d.sub(made);
        match self.response {
            Response::Slide | Response::Cross => {
                run.planes.push(entry.normal);
                run.turn(run.planes.slide::<B>(run.before_planes));
            }
            Response::Touch => run.v = Raw { x: 0, y: 0 },
            Response::Bounce => run.turn(reflect::<B>(run.v, entry.normal)),
        }
    }
}

/// The state of one call.
struct Run<B> {
    moved: Moved<B>,
    v: Raw,
    /// The motion that is left to make.
    motion: Raw,
    /// The part of the call's time that is left.
    rest: Toi,
    planes: Planes,
    /// The velocity that the body had when it came to this place.
    before_planes: Raw,
    pass_one_way: bool,
}

impl<B: Body> Run<B> {
    fn new(body: B, v: Raw) -> Self {
        let moved = Moved {
            body,
            velocity: Vec2::ZERO,
            remaining: Vec2::ZERO,
            hits: Hits::NONE,
            floor: false,
            wall: false,
            ceiling: false,
            flags: 0,
            work: Work::default(),
        };
        Self { moved, v, motion: v, rest: Toi::ONE, planes: Planes::NONE, before_planes: v, pass_one_way: false }
    }

    fn overlaps<W: World>(&mut self, world: &W, body: &B) -> bool {
        self.moved.work.checks += 1;
        body.overlaps_world(world)
    }

    /// The first hit of the motion. Cells are visited piece by piece so that the work is linear in the motion's length; the sweeps
    /// themselves always see the whole motion.
    fn first_hit<W: World>(&mut self, world: &W, d: Raw) -> Option<(Entry, Feature)> {
        let bounds = self.moved.body.bounds();
        let longest = d.x.unsigned_abs().max(d.y.unsigned_abs());
        // No shorter than the body either, or each piece would visit the body's own cells again.
        let side = Raw::of(bounds.size());
        let length = world.cell_size().max(side.x.max(side.y) as u32);
        let pieces = if longest <= length { 1 } else { mul_div(longest, 1, length) + 1 };
        let mut best: Option<(Entry, Feature)> = None;
        for piece in 0..pieces {
            let region = hull(&bounds, part(d, piece, pieces), part(d, piece + 1, pieces));
            for feature in world.features(&region) {
                self.moved.work.features += 1;
                if feature.one_way && self.pass_one_way {
                    continue;
                }
                let Some(entry) = self.moved.body.sweep(d, &feature) else { continue };
                match &mut best {
                    Some((first, of)) if entry.same_as(first) => merge(of, &feature),
                    Some((first, _)) if !entry.before(first, d) => {}
                    _ => best = Some((entry, feature)),
                }
            }
            // Later pieces hold only later hits.
            if best.is_some_and(|(e, _)| crate::num::umul(e.num, pieces) <= crate::num::umul(e.den, piece + 1)) {
                break;
            }
        }
        best
    }

    /// Moves up to the hit; returns the displacement made.
    fn advance<W: World>(&mut self, world: &W, d: Raw, entry: &Entry) -> Raw {
        let q = entry.displacement(d);
        if q.is_zero() {
            return q;
        }
        // Corners: rounding away from one corner may graze another. Lattice neighbours toward the start, then aside, then two back.
        let (sx, sy) = (d.x.signum(), d.y.signum());
        let at = |x: i32, y: i32| Raw { x: q.x.wrapping_add(x), y: q.y.wrapping_add(y) };
        self.commit(world, &[q, at(-sx, -sy), at(sx, 0), at(0, sy), at(-sx, 0), at(0, -sy), at(-2 * sx, -2 * sy)])
    }

    /// Takes the first displacement that the exact overlap test accepts, else stays; returns the displacement made.
    fn commit<W: World>(&mut self, world: &W, displacements: &[Raw]) -> Raw {
        for &d in displacements {
            let candidate = self.moved.body.shifted(d);
            if !self.overlaps(world, &candidate) {
                self.moved.body = candidate;
                return d;
            }
        }
        Raw { x: 0, y: 0 }
    }

    /// Gives the velocity another direction, and the rest of the motion with it.
    ///
    /// A component that is kept, dropped or reversed (all that faces along the axes do) acts on the rest of the motion exactly, so nothing is
    /// lost by rounding; any other is the new velocity times the time that is left.
    fn turn(&mut self, to: Raw) {
        let rest = self.rest;
        let component = |left: i32, was: i32, now: i32| {
            if now == was {
                left
            } else if now == 0 {
                0
            } else if now == was.wrapping_neg() {
                left.wrapping_neg()
            } else {
                rest.of_raw(now)
            }
        };
        self.motion = Raw { x: component(self.motion.x, self.v.x, to.x), y: component(self.motion.y, self.v.y, to.y) };
        self.v = to;
    }

    /// Up to 45 degrees from up is floor: n.up >= |n x up|, exact.
    fn classify(&mut self, up: Option<Axis>, normal: Axis) {
        let (along, across) = up.map_or((0, 1), |up| (normal.dot(up), normal.perp_dot(up).abs()));
        if along >= across {
            self.moved.floor = true;
        } else if -along >= across {
            self.moved.ceiling = true;
        } else {
            self.moved.wall = true;
        }
    }

    fn record(&mut self, normal: Axis, feature: &Feature, toi: Toi) {
        self.moved.flags |= feature.flags;
        self.moved.hits.push(Hit {
            toi,
            axis: normal,
            cell: feature.cell,
            index: feature.index,
            flags: feature.flags,
            one_way: feature.one_way,
        });
    }
}

/// Two features that are one surface at the moment of the hit: the solid one stands for both, with the flags of both.
fn merge(into: &mut Feature, other: &Feature) {
    let flags = into.flags | other.flags;
    if into.one_way && !other.one_way {
        *into = *other;
    }
    into.flags = flags;
}

/// Refuses a motion that would leave the domain.
fn check_inside(bounds: &Aabb, d: Raw) -> Result<(), RangeError> {
    let (lo, hi) = (bounds.lo().add(d), bounds.hi().add(d));
    for (what, low, high) in [(Quantity::X, lo.x, hi.x), (Quantity::Y, lo.y, hi.y)] {
        let value = if d.x < 0 && what == Quantity::X || d.y < 0 && what == Quantity::Y { low } else { high };
        if low <= -DOMAIN || high >= DOMAIN {
            return Err(RangeError { what, value });
        }
    }
    Ok(())
}

/// `d * k / n`, rounded toward zero; all of `d` for k = n.
fn part(d: Raw, k: u32, n: u32) -> Raw {
    if k == n {
        return d;
    }
    let of = |c: i32| {
        let size = mul_div(c.unsigned_abs(), k, n) as i32;
        if c < 0 { size.wrapping_neg() } else { size }
    };
    Raw { x: of(d.x), y: of(d.y) }
}

/// What the bounds cover between two displacements, one raw unit larger on every side because the displacements are rounded.
fn hull(bounds: &Aabb, from: Raw, to: Raw) -> Aabb {
    let (a, b) = (bounds.lo(), bounds.hi());
    let lo = Raw { x: a.x + from.x.min(to.x) - 1, y: a.y + from.y.min(to.y) - 1 };
    let hi = Raw { x: b.x + from.x.max(to.x) + 1, y: b.y + from.y.max(to.y) + 1 };
    Aabb::from_raw_unchecked(lo, hi)
}
