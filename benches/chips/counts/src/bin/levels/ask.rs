//! Rows of the other queries on a level of all shapes, and of motion that is more than a slide.

use core::mem::MaybeUninit;
use tilesat::motion::{MoveError, Mover, Stuck, Support, Walked, Walker, escape};
use tilesat::{Aabb, Axis, Circle, Fx, Inside, RangeError, Vec2, motion::BodyHit};
use tilesat_counts::inputs::{Random, UNIT, vec};
use tilesat_counts::measure::{Query, Table, load};
use tilesat_counts::shapes::{CELL, Map, SIDE, ball, crate_, level, place};

pub fn rows(table: &mut Table) {
    let Some(map) = level() else {
        table.wrong += 1;
        return;
    };
    flags(table, map);
    lines(table, map);
    casts(table, map);
    motion(table, map);
}

fn speed(r: &mut Random, most: i32) -> Vec2 {
    vec((r.raw(-most, most), r.raw(-most, most)))
}

fn flags(table: &mut Table, map: Map) {
    let loads = |_: &Circle, _: &Map| load::<_, _, _, 3, 0> as Query<Circle, Map, u8>;
    let free = move |r: &mut Random| Some((ball(r)?, map));
    table.row(
        "shapes: circle flags_touched",
        None,
        |c, map| MaybeUninit::new(map.flags_touched(c)),
        loads,
        free,
        |_| true,
    );
    let swept: Query<(Circle, Vec2), Map, Result<u8, RangeError>> =
        |a, map| MaybeUninit::new(map.flags_swept(&a.0, a.1));
    let moving = move |r: &mut Random| Some(((ball(r)?, speed(r, 4)), map));
    table.row("shapes: circle flags_swept, <= 4", None, swept, |_, _| load::<_, _, _, 5, 0>, moving, Result::is_ok);
    let loads = |_: &Aabb, _: &Map| load::<_, _, _, 4, 0> as Query<Aabb, Map, usize>;
    let area = move |r: &mut Random| Some((crate_(r)?, map));
    table.row(
        "shapes: tiles_in a box, counted",
        None,
        |b, map| MaybeUninit::new(map.tiles_in(b).count()),
        loads,
        area,
        |_| true,
    );
    let loads = |_: &Circle, _: &Map| load::<_, _, _, 3, 0> as Query<Circle, Map, bool>;
    let near = move |r: &mut Random| Some((ball(r)?, map));
    table.row("shapes: circle touches", None, |c, map| MaybeUninit::new(map.touches(c)), loads, near, |_| true);
}

fn lines(table: &mut Table, map: Map) {
    let sight: Query<(Vec2, Vec2), Map, Result<bool, RangeError>> =
        |a, map| MaybeUninit::new(map.line_of_sight(a.0, a.1));
    let pair = move |r: &mut Random| Some(((vec(place(r)), vec(place(r))), map));
    table.row("shapes: line_of_sight", None, sight, |_, _| load::<_, _, _, 4, 0>, pair, Result::is_ok);
    let all: Query<(Vec2, Vec2), Map, Result<usize, RangeError>> =
        |a, map| MaybeUninit::new(map.cast_ray_all(a.0, a.1, Inside::Ignore).map(Iterator::count));
    let last = SIDE as i32 * CELL;
    let ray = move |r: &mut Random| Some(((vec(place(r)), speed(r, last / 4)), map));
    table.row("shapes: ray, all hits", None, all, |_, _| load::<_, _, _, 4, 0>, ray, Result::is_ok);
}

fn casts(table: &mut Table, map: Map) {
    type Found = Result<Option<BodyHit<Aabb>>, RangeError>;
    let cast: Query<(Aabb, Vec2), Map, Found> = |a, map| MaybeUninit::new(map.cast_shape(&a.0, a.1, Inside::Ignore));
    let next = move |r: &mut Random| Some(((crate_(r).filter(|b| !map.overlaps(b))?, speed(r, 30)), map));
    table.row("shapes: box cast_shape, up to 30 units", None, cast, |_, _| load::<_, _, _, 6, 0>, next, Result::is_ok);
}

fn motion(table: &mut Table, map: Map) {
    let walk: Query<(Aabb, Vec2), Map, Result<Walked<Aabb>, MoveError>> = |a, map| {
        let walker = Walker::new(Mover::platformer(Axis::NEG_Y));
        MaybeUninit::new(walker.with_snap(Fx::ONE).map_err(MoveError::from).and_then(|w| w.walk(map, &a.0, a.1, None)))
    };
    let next = move |r: &mut Random| Some(((crate_(r).filter(|b| !map.overlaps(b))?, speed(r, 4)), map));
    table.row("shapes: box walks, <= 4 a frame", None, walk, |_, _| load::<_, _, _, 6, 0>, next, Result::is_ok);
    let under: Query<Circle, Map, Result<Option<Support>, RangeError>> =
        |c, map| MaybeUninit::new(Mover::platformer(Axis::NEG_Y).supported(map, c));
    let landed = move |r: &mut Random| {
        let fall = Mover::platformer(Axis::NEG_Y).move_and_slide(&map, &ball(r)?, vec((0, 99 * UNIT))).ok()?;
        fall.floor.then_some((fall.body, map))
    };
    table.row("shapes: circle supported", None, under, |_, _| load::<_, _, _, 3, 0>, landed, Result::is_ok);
    let out: Query<Circle, Map, Result<Circle, Stuck>> = |c, map| MaybeUninit::new(escape(map, c));
    let inside = move |r: &mut Random| {
        let body = ball(r).filter(|c| map.overlaps(c))?;
        escape(&map, &body).is_ok().then_some((body, map))
    };
    table.row("shapes: circle escapes", None, out, |_, _| load::<_, _, _, 3, 0>, inside, Result::is_ok);
}
