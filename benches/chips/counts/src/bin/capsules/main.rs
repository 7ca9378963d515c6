//! Prints the costs of capsules in motion. Circles and boxes are in another program: one chip's
//! flash does not hold both.

#![no_std]
#![no_main]

use core::mem::MaybeUninit;
use tilesat::motion::{MoveError, Moved, Mover};
use tilesat::{Axis, Capsule, Fx, Grid, Outside, TileKind, TileKinds, TileMap, Vec2, World};
use tilesat_chip::entry;
use tilesat_counts::inputs::{Random, UNIT, vec};
use tilesat_counts::measure::{Query, Table, load};
use tilesat_counts::shapes::{BLOCKS, CELL, SIDE, level, place};

type Step = Result<Moved<Capsule>, MoveError>;

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

/// As wide and as high as the boxes: 14 units by 20.
fn upright(r: &mut Random) -> Option<Capsule> {
    let (x, y) = place(r);
    Capsule::new(vec((x, y)), vec((x, y - 6 * UNIT)), Fx::from_bits(7 * UNIT)).ok()
}

fn moves<W: World + Copy>(table: &mut Table, map: W, name: &str, speed: i32) {
    let step: Query<(Capsule, Vec2), W, Step> =
        |body, map| MaybeUninit::new(Mover::platformer(Axis::NEG_Y).move_and_slide(map, &body.0, body.1));
    let loads = |_: &(Capsule, Vec2), _: &W| -> Query<_, _, _> { load::<_, _, _, 5, 0> };
    let next = move |r: &mut Random| {
        let body = upright(r)?;
        // The mover refuses a body that starts in the solid.
        let _ = Mover::platformer(Axis::NEG_Y).move_and_slide(&map, &body, vec((1, 0))).ok()?;
        Some(((body, vec((r.raw(-speed, speed), r.raw(-speed, speed)))), map))
    };
    table.row(name, None, step, loads, next, Result::is_ok);
}

#[entry]
fn main() -> ! {
    let mut table = Table::start();
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL * UNIT), Vec2::ZERO);
    let blocks = grid.ok().and_then(|grid| TileMap::<'static>::on_grid(&BLOCKS, grid, &KINDS).ok());
    if let (Some(blocks), Some(shapes)) = (blocks, level()) {
        let blocks = blocks.with_outside(Outside::Solid);
        moves(&mut table, blocks, "blocks: capsule moves, <= 4 a frame", 4);
        moves(&mut table, blocks, "blocks: capsule moves, <= 30 a frame", 30);
        moves(&mut table, shapes, "shapes: capsule moves, <= 4 a frame", 4);
        moves(&mut table, shapes, "shapes: capsule moves, <= 30 a frame", 30);
    } else {
        table.wrong += 1;
    }
    table.end()
}
