//! Bodies that move through levels: the mover, the walker, moving solids, the way out of the solid.

use tilesat::motion::{Body, escape};
use tilesat::world::{Pushable, Solid, World};
use tilesat::{
    Aabb, Axis, Capsule, Circle, Fx, Mover, OrientedBox, Ratio, Response, SlopeSpeed, Surface, Vec2, Walker,
    motion::{StartInside, Support},
};

use super::VECTORS;
use super::family::Run;
use super::hash::{Encode, Hash};
use super::levels;
use super::random::{Class, Random, UNIT, any_motion};
use super::world::Vector;

const QUERIES: [&str; 7] = ["move_and_slide", "bounce_and_slide", "walk", "ride", "supported", "escape", "motion_work"];

/// The library does not push out capsules.
const OF_CAPSULES: [&str; 6] = ["move_and_slide", "bounce_and_slide", "walk", "ride", "supported", "motion_work"];

const RESPONSES: [Response; 4] = [Response::Slide, Response::Touch, Response::DropThrough, Response::Bounce];

/// A mover of each kind in turn.
fn mover(number: u32) -> Mover {
    let mover = if number.is_multiple_of(3) { Mover::new() } else { Mover::platformer(Axis::NEG_Y) };
    let response = if number.is_multiple_of(5) { RESPONSES[number as usize / 5 % 4] } else { Response::Slide };
    let inside = if number % 16 == 7 { StartInside::Ignore } else { StartInside::Report };
    mover.with_response(response).with_inside(inside).with_drop_through(number % 32 == 5)
}

/// The state from vector to vector: a body that continues from its last position.
#[derive(Clone, Copy, Debug)]
struct Trip<B> {
    body: B,
    velocity: Vec2,
    floor: Option<Support>,
}

impl<B: Body + Pushable + Encode> Trip<B> {
    fn escape(&mut self, level: &impl World, number: u32, frees: &mut Hash) {
        let free = escape(level, &self.body);
        frees.add(free);
        if let (Ok(free), true) = (free, number % 4 != 3) {
            self.body = free;
        }
    }
}

impl<B: Body + Encode> Trip<B> {
    fn new(body: B) -> Self {
        Self { body, velocity: Vec2::ZERO, floor: None }
    }

    fn ask(
        &mut self,
        level: &impl World,
        list: &[Solid],
        number: u32,
        by: Vec2,
        r: &mut Random,
        [slides, bounces, walks, rides, stands, work]: [&mut Hash; 6],
    ) {
        let mover = mover(number);
        stands.add(mover.supported(level, &self.body));
        let speed = [SlopeSpeed::Projected, SlopeSpeed::Constant][number as usize / 2 % 2];
        let walker = Walker::new(mover).with_slope_speed(speed);
        let walker = walker.with_step(Fx::from_bits(r.signed(19).abs())).unwrap_or(walker);
        let walker = walker.with_snap(Fx::from_bits(r.signed(19).abs())).unwrap_or(walker);
        let walked = walker.walk(level, &self.body, by, self.floor);
        walks.add(walked);
        let ridden = mover.ride(level, list, &self.body, Fx::from_bits(r.signed(17).abs()));
        rides.add(ridden);
        let surface = Surface::new(Ratio::from_raw(r.word() >> 2).unwrap_or(Ratio::ONE), Ratio::HALF);
        let bounced = mover.with_surface(surface).with_response(Response::Bounce).move_and_slide(level, &self.body, by);
        bounces.add(bounced);
        let moved = mover.move_and_slide(level, &self.body, by + self.velocity);
        slides.add(moved);
        if let Ok(ridden) = ridden {
            work.add(ridden.work);
        }
        if let Ok(walked) = walked {
            self.floor = walked.floor;
            work.add(walked.moved.work);
        }
        self.velocity = Vec2::ZERO;
        match moved {
            Ok(moved) => {
                self.body = moved.body;
                let (x, y) = moved.velocity.raw();
                // Keeps falling, but never so fast that it leaves the domain.
                self.velocity = Vec2::from_raw(x.clamp(-UNIT * 8, UNIT * 8), y.clamp(-UNIT * 8, UNIT * 8) + UNIT / 16);
                work.add(moved.work);
            }
            Err(_) => {}
        }
    }
}

/// Sixteen vectors per trip, boxes and circles in turn.
fn trips<W: World>(run: &mut Run<'_>, of: &'static str, level: impl Fn(u32) -> Option<(W, Vec2)>) {
    let (mut ball, mut block) = (None, None);
    run.family(of, VECTORS / 3 + 1, QUERIES, |number, r, hashes| {
        let Some((level, at)) = level(number / 16) else { return };
        let v = Vector::draw(number, r, at, levels::SIZE);
        let class = Class::of(number / 16);
        if number.is_multiple_of(16) {
            (ball, block) = (Some(Trip::<Circle>::new(v.ball)), Some(Trip::<Aabb>::new(v.block)));
        }
        let by = match class {
            Class::Lattice | Class::Touch => Vec2::from_raw(r.small(2) * UNIT * 4, r.small(2) * UNIT * 4),
            Class::Domain => v.motion,
            _ => {
                let aim = Vec2::from_raw(r.signed(19), r.signed(19));
                any_motion(r, Class::Uniform, Vec2::ZERO, aim)
            }
        };
        let list = levels::solids(r, at);
        let list = if number.is_multiple_of(2) { &list[..] } else { &[] };
        let [slides, bounces, walks, rides, stands, frees, work] = hashes;
        let hashes = [slides, bounces, walks, rides, stands, work];
        match (&mut ball, &mut block) {
            (Some(ball), _) if number / 16 % 2 == 0 => {
                ball.escape(&level, number, frees);
                ball.ask(&level, list, number, by, r, hashes);
            }
            (_, Some(block)) => {
                block.escape(&level, number, frees);
                block.ask(&level, list, number, by, r, hashes);
            }
            _ => {}
        }
    });
}

/// Sixteen vectors per trip, upright and level capsules in turn. The mover refuses one that starts
/// in the solid, or is slanted.
pub(crate) fn run_capsules(run: &mut Run<'_>) {
    let mut trip = None;
    run.family("capsules", VECTORS / 3 + 1, OF_CAPSULES, |number, r, hashes| {
        let Some(level) = levels::shapes(number / 16 * 6) else { return };
        let v = Vector::draw(number, r, level.origin(), levels::SIZE);
        if number.is_multiple_of(16) {
            let (end, long) = (v.ball.centre(), r.signed(20));
            let core = match number / 16 % 8 {
                0 | 1 => Vec2::from_raw(long, 0),
                7 => Vec2::from_raw(long, 9),
                _ => Vec2::from_raw(0, long),
            };
            trip = Capsule::new(end, end + core, v.ball.radius()).ok().map(Trip::new);
        }
        let by = Vec2::from_raw(r.signed(19), r.signed(19));
        let list = levels::solids(r, level.origin());
        let list = if number.is_multiple_of(2) { &list[..] } else { &[] };
        if let Some(trip) = &mut trip {
            let [slides, bounces, walks, rides, stands, work] = hashes;
            trip.ask(&level, list, number, by, r, [slides, bounces, walks, rides, stands, work]);
        }
    });
}

/// Sixteen vectors a trip, boxes turned in any direction, sharp and round.
pub(crate) fn run_turned(run: &mut Run<'_>) {
    let mut trip = None;
    run.family("turned", VECTORS / 3 + 1, QUERIES, |number, r, hashes| {
        let Some(level) = levels::shapes(number / 16 * 6) else { return };
        let v = Vector::draw(number, r, level.origin(), levels::SIZE);
        if number.is_multiple_of(16) {
            let half = Vec2::from_raw(1 + r.signed(20).abs(), 1 + r.signed(19).abs());
            let direction = Axis::new(r.signed(28) | 1, r.signed(28));
            let sharp = OrientedBox::new(v.ball.centre(), half, direction);
            let radius = if number / 16 % 2 == 0 { Fx::ZERO } else { Fx::from_bits(r.signed(18).abs()) };
            trip = sharp.and_then(|sharp| sharp.with_radius(radius)).ok().map(Trip::new);
        }
        let by = Vec2::from_raw(r.signed(19), r.signed(19));
        let list = levels::solids(r, level.origin());
        let list = if number.is_multiple_of(2) { &list[..] } else { &[] };
        if let Some(trip) = &mut trip {
            let [slides, bounces, walks, rides, stands, frees, work] = hashes;
            trip.escape(&level, number, frees);
            trip.ask(&level, list, number, by, r, [slides, bounces, walks, rides, stands, work]);
        }
    });
}

/// A map, and where it is.
macro_rules! placed {
    ($map:path) => {
        |trip| $map(trip * 6).map(|map| (map, map.origin()))
    };
}

pub(crate) fn run_blocks(run: &mut Run<'_>) {
    trips(run, "blocks", placed!(levels::blocks));
}

pub(crate) fn run_shapes(run: &mut Run<'_>) {
    trips(run, "shapes", placed!(levels::shapes));
}

pub(crate) fn run_segments(run: &mut Run<'_>) {
    trips(run, "segments", |_| Some((*levels::segments(), Vec2::ZERO)));
}
