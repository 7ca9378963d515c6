//! Boxes and balls in a level that has more than tiles. They fall, get pushes and bounce, as in the
//! game.

use tilesat::motion::{Mover, Response};
use tilesat::num::DOMAIN;
use tilesat::world::World;
use tilesat::{Aabb, Axis, Circle, Grid, Vec2};
use tilesat_games::platformer::sim::{Actor, BODIES, FrameReport, Shape};

/// Half extents, and radii in the first column, in sixteenths of a cell.
const SIZES: [(i32, i32); 8] = [(4, 4), (6, 5), (5, 7), (9, 6), (3, 8), (7, 7), (11, 11), (2, 3)];
const RESPONSES: [Response; 4] = [Response::Slide, Response::Touch, Response::DropThrough, Response::Bounce];
/// Positions to try for a body, before it becomes smaller.
const TRIES: u32 = 400;
/// Its final size, in sixteenths of a cell: a dot.
const SMALLEST: i32 = 1;

/// The bodies, and the state of the random generator.
#[derive(Debug)]
pub(super) struct Drift {
    actors: [Actor; BODIES],
    dice: Dice,
    frame: u32,
    hash: u32,
    cell: i32,
    end: (i32, i32),
}

#[derive(Debug)]
struct Dice(u64);

impl Dice {
    fn below(&mut self, end: i32) -> i32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % u64::from(end.max(1) as u32)) as i32
    }

    fn within(&mut self, most: i32) -> i32 {
        self.below(2 * most + 1) - most
    }
}

impl Drift {
    /// Puts the bodies into free space. `None` without free space.
    pub(super) fn new<W: World>(world: &W, grid: Grid, seed: u32) -> Option<Self> {
        let mut dice = Dice(u64::from(seed) << 16 | 1);
        let mut actors = Vec::new();
        for i in 0..BODIES {
            let cell = grid.cell().to_bits();
            let (w, h) = SIZES[i / 2 % SIZES.len()];
            let shape = place(world, grid, (cell * w / 16, cell * h / 16), i % 2 == 1, &mut dice)?;
            let response = if i == 0 { Response::Slide } else { RESPONSES[i / 2 % RESPONSES.len()] };
            actors.push(Actor::new(shape, response, i / 8 % 2 == 0));
        }
        let actors = actors.try_into().ok()?;
        let end = grid.end().raw();
        Some(Self { actors, dice, frame: 0, hash: 0x811c_9dc5, cell: grid.cell().to_bits(), end })
    }

    /// Puts the player's feet at a point. Returns whether there is room for it.
    pub(super) fn start_at<W: World>(&mut self, world: &W, feet: Vec2) -> bool {
        self.actors[0].stand_at(world, feet)
    }

    pub(super) fn bodies(&self) -> &[Actor; BODIES] {
        &self.actors
    }

    /// FNV-1a over positions and velocities after every frame.
    pub(super) fn hash(&self) -> u32 {
        self.hash
    }

    /// Moves every body by one frame.
    pub(super) fn step<W: World>(&mut self, world: &W) -> FrameReport {
        let mut report = FrameReport::default();
        for (i, actor) in self.actors.iter_mut().enumerate() {
            if self.frame.wrapping_add(i as u32 * 37).is_multiple_of(96) {
                let most = if self.dice.below(8) == 0 { 2 * self.cell } else { self.cell / 4 };
                actor.velocity = Vec2::from_raw(self.dice.within(most), self.dice.within(most));
            } else if actor.heavy {
                let (x, y) = actor.velocity.raw();
                actor.velocity = Vec2::from_raw(x, (y + self.cell / 64).min(self.cell * 3 / 4));
            }
            advance(world, actor, self.end, &mut report);
            let (position, velocity) = (actor.shape.position().raw(), actor.velocity.raw());
            for byte in [position.0, position.1, velocity.0, velocity.1].into_iter().flat_map(i32::to_le_bytes) {
                self.hash = (self.hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
            }
        }
        self.frame = self.frame.wrapping_add(1);
        report
    }
}

fn advance<W: World>(world: &W, actor: &mut Actor, end: (i32, i32), report: &mut FrameReport) {
    let mover = Mover::platformer(Axis::NEG_Y).with_response(actor.response);
    actor.asked = inside(actor.velocity, end);
    actor.hit = None;
    let moved = match actor.shape {
        Shape::Box(body) => mover
            .move_and_slide(world, &body, actor.asked)
            .map(|moved| (Shape::Box(moved.body), moved.velocity, moved.hits)),
        Shape::Ball(body) => mover
            .move_and_slide(world, &body, actor.asked)
            .map(|moved| (Shape::Ball(moved.body), moved.velocity, moved.hits)),
    };
    if let Ok((shape, velocity, hits)) = moved {
        report.contacts += hits.len() as u32;
        actor.hit = hits.first();
        (actor.shape, actor.velocity) = (shape, velocity);
    } else {
        report.refused += 1;
        actor.velocity = Vec2::ZERO;
    }
}

/// The greatest velocity at which no body can leave the domain. The library refuses faster ones,
/// even before a wall.
fn inside(velocity: Vec2, end: (i32, i32)) -> Vec2 {
    let room = (DOMAIN - 1 - end.0.abs().max(end.1.abs())).max(0) / 2;
    let (x, y) = velocity.raw();
    if x.abs() + y.abs() <= room {
        velocity
    } else {
        Vec2::from_raw(x.clamp(-room / 2, room / 2), y.clamp(-room / 2, room / 2))
    }
}

fn place<W: World>(world: &W, grid: Grid, half: (i32, i32), ball: bool, dice: &mut Dice) -> Option<Shape> {
    let (from, to) = (grid.origin().raw(), grid.end().raw());
    let mut half = half;
    while half.0 >= SMALLEST * grid.cell().to_bits() / 32 {
        let (hx, hy) = if ball { (half.0, half.0) } else { half };
        let room = (to.0 - from.0 - 2 * hx, to.1 - from.1 - 2 * hy);
        for _ in 0..if room.0 > 0 && room.1 > 0 { TRIES } else { 0 } {
            let at = Vec2::from_raw(from.0 + hx + dice.below(room.0), from.1 + hy + dice.below(room.1));
            if ball {
                let shape = Circle::new(at, tilesat::Fx::from_bits(hx)).ok()?;
                if !world.overlaps_circle(&shape) {
                    return Some(Shape::Ball(shape));
                }
            } else {
                let shape = Aabb::from_centre(at, Vec2::from_raw(hx, hy)).ok()?;
                if !world.overlaps_aabb(&shape) {
                    return Some(Shape::Box(shape));
                }
            }
        }
        half = (half.0 / 2, half.1 / 2);
    }
    None
}
