//! Rows of the world queries and of motion.

use core::mem::MaybeUninit;
use tilesat::motion::{MoveError, Moved, Mover};
use tilesat::{Aabb, Axis, Circle, Fx, Grid, RangeError, Slopes, Vec2};
use tilesat::{Inside, RayHit, TileKind, TileKinds, TileMap, TileMapError};
use tilesat_counts::inputs::{Random, UNIT, circle, vec};
use tilesat_counts::measure::{Query, Table, load};

const SIDE: usize = 32;
const CELL: i32 = 16;

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

/// A room: walls around, a few blocks inside, and a floor above the lower wall.
static TILES: [u8; SIDE * SIDE] = room();

const fn room() -> [u8; SIDE * SIDE] {
    let mut tiles = [0; SIDE * SIDE];
    let mut i = 0;
    while i < SIDE * SIDE {
        let (x, y) = (i % SIDE, i / SIDE);
        let wall = x == 0 || y == 0 || x == SIDE - 1 || y == SIDE - 1;
        let block = x % 7 == 3 && y % 5 == 2;
        tiles[i] = (wall || block) as u8;
        i += 1;
    }
    tiles
}

/// The room, a start and a motion.
struct Ray {
    origin: Vec2,
    motion: Vec2,
}

type Cast = Result<Option<RayHit>, RangeError>;
type Step<B> = Result<Moved<B>, MoveError>;

pub fn rows(table: &mut Table) {
    let Ok(map) = TileMap::new(&TILES, SIDE as u16, SIDE as u16, &KINDS) else {
        table.wrong += 1;
        return;
    };
    door(table);
    rays(table, map);
    boxes(table, map);
    circles(table, map);
}

/// The map made again from its bytes, as after a door has opened.
fn door(table: &mut Table) {
    const GRID: Grid = match Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL * UNIT), Vec2::ZERO) {
        Ok(grid) => grid,
        Err(_) => panic!("the grid is wrong"),
    };
    type Made = Result<TileMap<'static, Slopes>, TileMapError>;
    let make: Query<&'static [u8], (), Made> = |tiles, ()| MaybeUninit::new(TileMap::of(tiles, GRID, &KINDS));
    let next = |_: &mut Random| Some((TILES.as_slice(), ()));
    table.row(
        "a map of a constant grid, made again",
        Some((40, 40)),
        make,
        |_, ()| load::<_, _, _, 2, 0>,
        next,
        Result::is_ok,
    );
}

fn rays(table: &mut Table, map: TileMap<'static>) {
    let cast: Query<Ray, TileMap<'static>, Cast> =
        |ray, map| MaybeUninit::new(map.cast_ray(ray.origin, ray.motion, Inside::Ignore));
    let any = move |r: &mut Random| {
        let last = SIDE as i32 * CELL;
        let origin = vec((r.raw(CELL, last - CELL), r.raw(CELL, last - CELL)));
        let motion = vec((r.raw(-last, last), r.raw(-last, last)));
        Some((Ray { origin, motion }, map))
    };
    let seventeen = move |r: &mut Random| {
        let (ray, map) = any(r)?;
        let hit = map.cast_ray(ray.origin, ray.motion, Inside::Ignore).ok()??;
        (hit.cells == 17 && !hit.inside).then_some((ray, map))
    };
    let free = move |r: &mut Random| {
        let (ray, map) = any(r)?;
        map.cast_ray(ray.origin, ray.motion, Inside::Ignore).ok()?.is_none().then_some((ray, map))
    };
    // Origin and motion are the operands. Reading the map is part of the walk.
    let loads = |_: &Ray, _: &TileMap<'static>| -> Query<Ray, TileMap<'static>, Cast> { load::<_, _, _, 4, 0> };
    table.row("ray, 17 cells, hit", Some((900, 590)), cast, loads, seventeen, |hit| matches!(hit, Ok(Some(_))));
    table.row("ray, no hit", None, cast, loads, free, |hit| matches!(hit, Ok(None)));
}

/// A running velocity: 3.37 units per frame, with a quarter unit of gravity.
fn run() -> Vec2 {
    vec((UNIT * 337 / 100, UNIT / 4))
}

/// A position on the floor, clear of blocks: the x of a body and the y of the floor.
fn on_the_floor(r: &mut Random) -> (i32, i32) {
    (r.raw(2 * CELL, (SIDE as i32 - 4) * CELL), (SIDE as i32 - 1) * CELL * UNIT)
}

fn boxes(table: &mut Table, map: TileMap<'static>) {
    let step: Query<(Aabb, Vec2), TileMap<'static>, Step<Aabb>> =
        |body, map| MaybeUninit::new(Mover::platformer(Axis::NEG_Y).move_and_slide(map, &body.0, body.1));
    let loads = |_: &(Aabb, Vec2), _: &TileMap<'static>| -> Query<_, _, _> { load::<_, _, _, 6, 0> };
    let floor = move |r: &mut Random| {
        let (x, y) = on_the_floor(r);
        let body = Aabb::new(vec((x, y - 14 * UNIT)), vec((x + 10 * UNIT, y))).ok()?;
        Some(((body, run()), map))
    };
    table.row("move_and_slide, box runs on a floor", None, step, loads, floor, |m| m.as_ref().is_ok_and(|m| m.floor));
    let air = move |r: &mut Random| {
        let (x, y) = (r.raw(CELL, 30 * CELL), r.raw(CELL, 30 * CELL));
        let body = Aabb::new(vec((x, y)), vec((x + 10 * UNIT, y + 14 * UNIT))).ok()?;
        let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&map, &body, run()).ok()?;
        moved.hits.is_empty().then_some(((body, run()), map))
    };
    table.row("move_and_slide, box in the air", None, step, loads, air, |m| m.as_ref().is_ok_and(|m| !m.floor));
}

fn circles(table: &mut Table, map: TileMap<'static>) {
    let step: Query<(Circle, Vec2), TileMap<'static>, Step<Circle>> =
        |body, map| MaybeUninit::new(Mover::platformer(Axis::NEG_Y).move_and_slide(map, &body.0, body.1));
    let loads = |_: &(Circle, Vec2), _: &TileMap<'static>| -> Query<_, _, _> { load::<_, _, _, 5, 0> };
    let floor = move |r: &mut Random| {
        let (x, y) = on_the_floor(r);
        Some(((circle((x, y - 6 * UNIT), 6 * UNIT)?, run()), map))
    };
    table
        .row("move_and_slide, circle runs on a floor", None, step, loads, floor, |m| m.as_ref().is_ok_and(|m| m.floor));
    let air = move |r: &mut Random| {
        let body = circle((r.raw(CELL, 30 * CELL), r.raw(CELL, 30 * CELL)), 6 * UNIT)?;
        let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&map, &body, run()).ok()?;
        moved.hits.is_empty().then_some(((body, run()), map))
    };
    table.row("move_and_slide, circle in the air", None, step, loads, air, |m| m.as_ref().is_ok_and(|m| !m.floor));
}
