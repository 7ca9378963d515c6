//! The 32 boxes and balls that move in the level.

use tilesat::Vec2;
use tilesat::motion::Response;
use tilesat::world::{ShapeSet, TileMap};

use super::FrameReport;
use super::actor::Actor;
use super::rng::Rng;
use super::start::place;

/// Half extents of boxes and, first column, radii of balls, in sixteenths of a cell.
const SIZES: [(i32, i32); 8] = [(4, 4), (6, 5), (5, 7), (9, 6), (3, 8), (7, 7), (11, 11), (2, 3)];

const RESPONSES: [Response; 4] = [Response::Slide, Response::Touch, Response::DropThrough, Response::Bounce];

/// Body `i`: boxes and balls alternate. Each response goes to four of either kind, half of them
/// heavy.
pub(super) fn start<S: ShapeSet>(map: &TileMap<'_, S>, i: usize, rng: &mut Rng) -> Option<Actor> {
    let cell = map.cell().to_bits();
    let pick = |n: usize| i.wrapping_sub(1) / n;
    let size = SIZES.get(pick(2) % 8).copied().unwrap_or((4, 4));
    let half = (cell * size.0 / 16, cell * size.1 / 16);
    let response = RESPONSES.get(pick(2) % 4).copied().unwrap_or(Response::Slide);
    let shape = place(map, half, i.is_multiple_of(2), 0, rng)?;
    let mut actor = Actor::new(shape, response, pick(8) % 2 == 0);
    actor.velocity = kick(cell, actor.heavy, rng);
    Some(actor)
}

/// Falls, gets a push every 128 frames, and moves.
pub(super) fn step<S: ShapeSet>(
    map: &TileMap<'_, S>,
    actor: &mut Actor,
    i: usize,
    frame: u32,
    rng: &mut Rng,
    report: &mut FrameReport,
) {
    let cell = map.cell().to_bits();
    if frame.wrapping_add(i as u32 * 37).is_multiple_of(128) {
        actor.velocity = kick(cell, actor.heavy, rng);
    } else if actor.heavy {
        let (x, y) = actor.velocity.raw();
        actor.velocity = Vec2::from_raw(x, (y + cell / 64).min(cell * 3 / 4));
    }
    actor.advance(map, report);
}

/// A random velocity. Once in eight times it is up to two cells per frame, which would cross walls
/// without the sweep.
fn kick(cell: i32, heavy: bool, rng: &mut Rng) -> Vec2 {
    if rng.once_in(8) {
        Vec2::from_raw(rng.within(2 * cell), rng.within(2 * cell))
    } else if heavy {
        Vec2::from_raw(rng.within(cell / 8), -rng.within(cell / 4).abs())
    } else {
        Vec2::from_raw(rng.within(cell / 8), rng.within(cell / 8))
    }
}
