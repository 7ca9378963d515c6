//! Prints the costs of moving solids, and of planks that move and turn: what they do to a circle, a
//! circle that runs on one, and a ray at them.

#![no_std]
#![no_main]

mod solids;

use core::mem::MaybeUninit;
use tilesat::motion::{MoveError, Moved, Mover, Ridden, Ride};
use tilesat::world::{ConvexSolid, ConvexSolids, RayHit};
use tilesat::{Axis, Circle, Fx, Grid, Inside, Joined, OrientedBox, TileKinds, TileMap, Vec2};
use tilesat_chip::entry;
use tilesat_counts::inputs::{Random, UNIT, vec};
use tilesat_counts::measure::{Query, Table, load};
use tilesat_counts::shapes::{CELL, SIDE};

static KINDS: TileKinds = TileKinds::EMPTY;
/// Nothing but the planks.
static OPEN: [u8; SIDE * SIDE] = [0; SIDE * SIDE];

type Plank = ConvexSolid<OrientedBox>;
type Scene = (TileMap<'static>, [Plank; 4]);

fn shape(at: (i32, i32), rise: i32) -> Option<OrientedBox> {
    OrientedBox::new(vec(at), Vec2::from_ints(24, 4), Axis::new(64, rise)).ok()
}

/// A ball just over the middle of the first of four planks, which changes as told.
fn scene(
    r: &mut Random,
    map: TileMap<'static>,
    change: fn(Plank, (i32, i32)) -> Option<Plank>,
) -> Option<(Circle, Scene)> {
    let at = (r.raw(60, 300), r.raw(60, 400));
    let plank = |at: (i32, i32), key: u16| ConvexSolid::new(shape(at, 0)?, key).ok();
    let moving = change(plank(at, 1)?, at)?;
    let far = |y: i32, key: u16| plank((400 << 16, y << 16), key);
    let ball = Circle::new(vec((at.0 + r.raw(-10, 10), at.1 - (11 << 16))), Fx::from_bits(7 << 16)).ok()?;
    Some((ball, (map, [moving, far(60, 2)?, far(200, 3)?, far(440, 4)?])))
}

fn rows(table: &mut Table, map: TileMap<'static>) {
    let ride: Query<Circle, Scene, Result<Ridden<Circle>, MoveError>> =
        |body, scene| MaybeUninit::new(Mover::platformer(Axis::NEG_Y).ride_convex(&scene.0, &scene.1, body, Fx::ONE));
    let carried = |r: &Result<Ridden<Circle>, MoveError>| r.as_ref().is_ok_and(|r| r.ride == Ride::Carried);
    let pushed =
        |r: &Result<Ridden<Circle>, MoveError>| r.as_ref().is_ok_and(|r| matches!(r.ride, Ride::Pushed { .. }));
    let free = |r: &Result<Ridden<Circle>, MoveError>| r.as_ref().is_ok_and(|r| r.ride == Ride::Free);
    let moves: fn(Plank, (i32, i32)) -> Option<Plank> = |plank, _| plank.with_motion(Vec2::from_ints(2, -1)).ok();
    let turns: fn(Plank, (i32, i32)) -> Option<Plank> = |plank, at| plank.with_turn(shape(at, 4)?).ok();
    let far = move |r: &mut Random| {
        let (_, s) = scene(r, map, turns)?;
        Some((Circle::new(vec((20 << 16, 470 << 16)), Fx::from_bits(7 << 16)).ok()?, s))
    };
    table.row("ride_convex, circle, far from four planks", None, ride, |_, _| load::<_, _, _, 3, 0>, far, free);
    let next = move |r: &mut Random| scene(r, map, moves);
    table.row("ride_convex, circle is carried by a plank", None, ride, |_, _| load::<_, _, _, 3, 0>, next, carried);
    let next = move |r: &mut Random| scene(r, map, turns);
    table.row("ride_convex, circle on a plank that turns", None, ride, |_, _| load::<_, _, _, 3, 0>, next, carried);
    // One unit above it, and it rises by three.
    let above = move |r: &mut Random| {
        let (ball, s) = scene(r, map, |plank, _| plank.with_motion(Vec2::from_ints(0, -3)).ok())?;
        Some((ball.translated(Vec2::from_ints(0, -1)).ok()?, s))
    };
    table.row("ride_convex, circle is pushed by a plank", None, ride, |_, _| load::<_, _, _, 3, 0>, above, pushed);

    let walk: Query<Circle, Scene, Result<Moved<Circle>, MoveError>> = |body, scene| {
        let level = (&scene.0, ConvexSolids::new(&scene.1));
        let level = Joined::new(level.0, &level.1);
        MaybeUninit::new(Mover::platformer(Axis::NEG_Y).move_and_slide(&level, body, Vec2::from_ints(2, 1)))
    };
    let next = move |r: &mut Random| scene(r, map, moves);
    table.row(
        "move_and_slide, circle runs on one of four planks",
        None,
        walk,
        |_, _| load::<_, _, _, 3, 0>,
        next,
        |m| m.as_ref().is_ok_and(|m| m.floor),
    );

    let ray: Query<Circle, Scene, Option<RayHit>> = |body, scene| {
        let solids = ConvexSolids::new(&scene.1);
        let hit = solids.cast_ray(body.centre(), Vec2::from_ints(6, 90), Inside::Ignore);
        MaybeUninit::new(hit.ok().flatten())
    };
    let next = move |r: &mut Random| scene(r, map, moves);
    table.row("ray at four planks, hit", None, ray, |_, _| load::<_, _, _, 3, 0>, next, Option::is_some);
}

#[entry]
fn main() -> ! {
    let mut table = Table::start();
    solids::rows(&mut table);
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL * UNIT), Vec2::ZERO);
    match grid.ok().and_then(|grid| TileMap::<'static>::on_grid(&OPEN, grid, &KINDS).ok()) {
        Some(map) => rows(&mut table, map),
        None => table.wrong += 1,
    }
    table.end()
}
