//! Rows of motion in levels of blocks, and of a body at rest. A quarter of the cells are full, at
//! random, in a closed room.

use core::mem::MaybeUninit;
use tilesat::motion::{Body, Memo, MoveError, Moved, Mover};
use tilesat::{Aabb, Axis, Circle, Fx, Grid, Outside, TileKind, TileKinds, TileMap, Vec2};
use tilesat_counts::inputs::{Random, UNIT, circle, vec};
use tilesat_counts::measure::{Query, Table, load};
use tilesat_counts::shapes::{BLOCKS, CELL, SIDE};

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

type Map = TileMap<'static>;
type Step<B> = Result<Moved<B>, MoveError>;

pub fn rows(table: &mut Table) {
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL * UNIT), Vec2::ZERO);
    let Some(map) = grid.ok().and_then(|grid| Map::on_grid(&BLOCKS, grid, &KINDS).ok()) else {
        table.wrong += 1;
        return;
    };
    let map = map.with_outside(Outside::Solid);
    for (speed, names) in [
        (4, ("blocks: circle moves, <= 4 a frame", "blocks: box moves, <= 4 a frame")),
        (30, ("blocks: circle moves, <= 30 a frame", "blocks: box moves, <= 30 a frame")),
    ] {
        moves(table, map, names.0, speed, ball);
        moves(table, map, names.1, speed, player);
    }
    let circle = ("blocks: circle rests on a floor", "blocks: circle rests, memo", "blocks: circle, velocity zero");
    let boxed = ("blocks: box rests on a floor", "blocks: box rests, memo", "blocks: box, velocity zero");
    at_rest(table, map, circle, ball);
    at_rest(table, map, boxed, player);
}

/// A point of the map, a cell away from its border.
fn place(r: &mut Random) -> (i32, i32) {
    let last = (SIDE as i32 - 1) * CELL;
    (r.raw(CELL, last), r.raw(CELL, last))
}

fn ball(r: &mut Random, map: &Map) -> Option<Circle> {
    circle(place(r), 10 * UNIT).filter(|c| !map.overlaps(c))
}

fn player(r: &mut Random, map: &Map) -> Option<Aabb> {
    let (x, y) = place(r);
    Aabb::new(vec((x, y)), vec((x + 14 * UNIT, y + 20 * UNIT))).ok().filter(|b| !map.overlaps(b))
}

fn step<B: Body>(input: &(B, Vec2), map: &Map) -> MaybeUninit<Step<B>> {
    MaybeUninit::new(Mover::platformer(Axis::NEG_Y).move_and_slide(map, &input.0, input.1))
}

fn loads<B>(_: &(B, Vec2), _: &Map) -> Query<(B, Vec2), Map, Step<B>> {
    load::<_, _, _, 5, 0>
}

/// Anywhere, in any direction: free flights, landings, walls and corners at random.
fn moves<B: Body>(table: &mut Table, map: Map, name: &str, speed: i32, body: fn(&mut Random, &Map) -> Option<B>) {
    let next = move |r: &mut Random| {
        let body = body(r, &map)?;
        Some(((body, vec((r.raw(-speed, speed), r.raw(-speed, speed)))), map))
    };
    table.row(name, None, step, loads, next, Result::is_ok);
}

/// The memo's copy is counted too.
fn again<B: Body + PartialEq>((body, velocity): &(B, Vec2), (map, memo): &(Map, Memo<B>)) -> MaybeUninit<Step<B>> {
    let (mover, mut memo) = (Mover::platformer(Axis::NEG_Y), *memo);
    MaybeUninit::new(memo.move_and_slide(&mover, map, 0, body, *velocity))
}

/// On a floor after a fall: with a quarter unit of gravity, with a memo of that, and without
/// gravity.
fn at_rest<B: Body + PartialEq>(
    table: &mut Table,
    map: Map,
    (rests, remembers, asleep): (&str, &str, &str),
    body: fn(&mut Random, &Map) -> Option<B>,
) {
    let mover = Mover::platformer(Axis::NEG_Y);
    let landed = move |r: &mut Random| {
        let fall = mover.move_and_slide(&map, &body(r, &map)?, vec((0, 99 * UNIT))).ok()?;
        (fall.floor && fall.hits.len() == 1 && fall.velocity == Vec2::ZERO).then_some(fall.body)
    };
    let gravity = vec((0, UNIT / 4));
    let rested = |m: &Step<B>| m.as_ref().is_ok_and(|m| m.floor && m.velocity == Vec2::ZERO);
    table.row(rests, None, step, loads, move |r| Some(((landed(r)?, gravity), map)), rested);
    let remembered = move |r: &mut Random| {
        let (body, mut memo) = (landed(r)?, Memo::new());
        let _ = memo.move_and_slide(&mover, &map, 0, &body, gravity).ok()?;
        Some(((body, gravity), (map, memo)))
    };
    table.row(remembers, None, again, |_, _| load::<_, _, _, 5, 0>, remembered, rested);
    table.row(asleep, None, step, loads, move |r| Some(((landed(r)?, Vec2::ZERO), map)), Result::is_ok);
}
