//! Rows of moving solids: four platforms in a room of blocks. One is under the body or beside it.

use core::mem::MaybeUninit;
use tilesat::motion::{Body, MoveError, Mover, Ridden, Ride};
use tilesat::{Aabb, Axis, Circle, Fx, Joined, Moved, Solid, Solids, TileKind, TileKinds, TileMap, Vec2};
use tilesat_counts::inputs::{Random, circle, vec};
use tilesat_counts::measure::{Query, Table, load};

const SIDE: usize = 32;

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

/// Walls around.
static TILES: [u8; SIDE * SIDE] = {
    let mut tiles = [0; SIDE * SIDE];
    let mut i = 0;
    while i < SIDE * SIDE {
        let (x, y) = (i % SIDE, i / SIDE);
        tiles[i] = (x == 0 || y == 0 || x == SIDE - 1 || y == SIDE - 1) as u8;
        i += 1;
    }
    tiles
};

type Scene = (TileMap<'static>, [Solid; 4]);

pub fn rows(table: &mut Table) {
    let Ok(map) = TileMap::new(&TILES, SIDE as u16, SIDE as u16, &KINDS) else {
        table.wrong += 1;
        return;
    };
    of_body(
        table,
        map,
        [
            "ride, box, far from four solids",
            "ride, box stands on one of four",
            "ride, box is carried",
            "ride, box is pushed",
        ],
        boxed,
    );
    of_body(
        table,
        map,
        [
            "ride, circle, far from four solids",
            "ride, circle stands on one of four",
            "ride, circle is carried",
            "ride, circle is pushed",
        ],
        ball,
    );
    let walk: Query<Aabb, Scene, Result<Moved<Aabb>, MoveError>> = |body, scene| {
        let solids = Solids::new(&scene.1);
        let level = Joined::new(&scene.0, &solids);
        MaybeUninit::new(Mover::platformer(Axis::NEG_Y).move_and_slide(&level, body, Vec2::from_ints(2, 1)))
    };
    let loads = |_: &Aabb, _: &Scene| -> Query<_, _, _> { load::<_, _, _, 4, 0> };
    let next = move |r: &mut Random| scene(r, map, (0, 0), boxed);
    table.row("move_and_slide, box runs on one of four solids", None, walk, loads, next, |m| {
        m.as_ref().is_ok_and(|m| m.floor)
    });
}

fn boxed(x: i32, y: i32) -> Option<Aabb> {
    Aabb::new(vec((x, y)), vec((x + (10 << 16), y + (14 << 16)))).ok()
}

fn ball(x: i32, y: i32) -> Option<Circle> {
    circle((x + (7 << 16), y + (7 << 16)), 7 << 16)
}

/// A body on the first of four platforms, which moves by this many units.
fn scene<B>(
    r: &mut Random,
    map: TileMap<'static>,
    by: (i16, i16),
    body: fn(i32, i32) -> Option<B>,
) -> Option<(B, Scene)> {
    let at = (r.raw(60, 300), r.raw(60, 400));
    let solid = |x: i32, y: i32, key: u16| {
        let max = Vec2::from_raw(x + (48 << 16), y + (8 << 16));
        Solid::new(Aabb::new(vec((x, y)), max).ok()?, key).ok()
    };
    let moving = solid(at.0, at.1, 1)?.with_motion(Vec2::from_ints(by.0, by.1)).ok()?;
    let list =
        [moving, solid(400 << 16, 60 << 16, 2)?, solid(400 << 16, 200 << 16, 3)?, solid(400 << 16, 440 << 16, 4)?];
    Some((body(at.0 + r.raw(0, 30), at.1 - (14 << 16))?, (map, list)))
}

fn of_body<B: Body>(table: &mut Table, map: TileMap<'static>, names: [&str; 4], body: fn(i32, i32) -> Option<B>) {
    let ride: Query<B, Scene, Result<Ridden<B>, MoveError>> =
        |body, scene| MaybeUninit::new(Mover::platformer(Axis::NEG_Y).ride(&scene.0, &scene.1, body, Fx::ONE));
    let loads = |_: &B, _: &Scene| -> Query<_, _, _> { load::<_, _, _, 3, 0> };
    let [far, stands, carried, pushed] = names;
    let is = |want: Ride| move |r: &Result<Ridden<B>, MoveError>| r.as_ref().is_ok_and(|r| r.ride == want);
    let away = move |r: &mut Random| {
        let (_, s) = scene(r, map, (0, 0), body)?;
        Some((body(20 << 16, 470 << 16)?, s))
    };
    table.row(far, None, ride, loads, away, is(Ride::Free));
    table.row(stands, None, ride, loads, move |r| scene(r, map, (0, 0), body), is(Ride::Carried));
    table.row(carried, None, ride, loads, move |r| scene(r, map, (2, -1), body), is(Ride::Carried));
    // One unit above it, and it rises by three.
    let above = move |r: &mut Random| {
        let (_, s) = scene(r, map, (0, -3), body)?;
        let min = s.1.first()?.shape().min().raw();
        Some((body(min.0 + r.raw(0, 30), min.1 - (15 << 16))?, s))
    };
    table.row(pushed, None, ride, loads, above, is(Ride::Pushed { by: 1, normal: Axis::NEG_Y }));
}
