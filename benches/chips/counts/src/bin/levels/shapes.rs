//! Rows of the queries on the level of all tile shapes.

use core::mem::MaybeUninit;
use tilesat::motion::{MoveError, Moved, Mover};
use tilesat::{
    Aabb, Axis, Circle, Fx, Inside, RangeError, RayHit, Vec2,
    motion::BodyHit,
    world::{Near, OneWay, WorldContact},
};
use tilesat_counts::inputs::{Random, UNIT, vec};
use tilesat_counts::measure::{Query, Table, load};
use tilesat_counts::shapes::{CELL, Map, SIDE, ball, crate_, level, place};

type Step<B> = Result<Moved<B>, MoveError>;
type Cast = Result<Option<RayHit>, RangeError>;
type Touched = (bool, Option<WorldContact>);
type Nearest = Result<Option<Near>, RangeError>;

pub fn rows(table: &mut Table) {
    let Some(map) = level() else {
        table.wrong += 1;
        return;
    };
    overlaps(table, map);
    surface(table, map);
    rays(table, map);
    motion(table, map);
    casts(table, map);
}

fn overlaps(table: &mut Table, map: Map) {
    let query: Query<Circle, Map, bool> = |c, map| MaybeUninit::new(map.overlaps(c));
    let loads = |_: &Circle, _: &Map| -> Query<_, _, _> { load::<_, _, _, 3, 0> };
    for (name, wanted) in [("shapes: circle overlaps, hit", true), ("shapes: circle overlaps, free", false)] {
        let next = move |r: &mut Random| ball(r).filter(|c| map.overlaps(c) == wanted).map(|c| (c, map));
        table.row(name, None, query, loads, next, |&hit| hit == wanted);
    }
    let query: Query<Aabb, Map, bool> = |b, map| MaybeUninit::new(map.overlaps(b));
    let loads = |_: &Aabb, _: &Map| -> Query<_, _, _> { load::<_, _, _, 4, 0> };
    for (name, wanted) in [("shapes: box overlaps, hit", true), ("shapes: box overlaps, free", false)] {
        let next = move |r: &mut Random| crate_(r).filter(|b| map.overlaps(b) == wanted).map(|b| (b, map));
        table.row(name, None, query, loads, next, |&hit| hit == wanted);
    }
}

fn surface(table: &mut Table, map: Map) {
    let query: Query<Circle, Map, Touched> = |c, map| {
        let mut out = tilesat::heapless::Vec::<_, 8>::new();
        let all = map.contacts(c, OneWay::Ignore, &mut out).is_ok();
        MaybeUninit::new((all, out.first().copied()))
    };
    let loads = |_: &Circle, _: &Map| -> Query<_, _, _> { load::<_, _, _, 3, 0> };
    let next = move |r: &mut Random| ball(r).filter(|c| map.overlaps(c)).map(|c| (c, map));
    table.row("shapes: circle contacts, overlapping", None, query, loads, next, |found| found.0);
    let query: Query<Vec2, Map, Nearest> =
        |p, map| MaybeUninit::new(map.closest_point(*p, Fx::from_bits(CELL * UNIT), OneWay::Ignore));
    let loads = |_: &Vec2, _: &Map| -> Query<_, _, _> { load::<_, _, _, 2, 0> };
    let next = move |r: &mut Random| Some((vec(place(r)), map));
    table.row("shapes: closest point, within a cell", None, query, loads, next, Result::is_ok);
}

fn rays(table: &mut Table, map: Map) {
    let cast: Query<(Vec2, Vec2), Map, Cast> = |ray, map| MaybeUninit::new(map.cast_ray(ray.0, ray.1, Inside::Ignore));
    let loads = |_: &(Vec2, Vec2), _: &Map| -> Query<_, _, _> { load::<_, _, _, 4, 0> };
    let next = move |r: &mut Random| {
        let last = SIDE as i32 * CELL;
        let ray = (vec(place(r)), vec((r.raw(-last, last), r.raw(-last, last))));
        let hit = map.cast_ray(ray.0, ray.1, Inside::Hit).ok()??;
        (!hit.inside).then_some((ray, map))
    };
    table.row("shapes: ray, hit", None, cast, loads, next, |hit| matches!(hit, Ok(Some(_))));
}

fn motion(table: &mut Table, map: Map) {
    let step: Query<(Circle, Vec2), Map, Step<Circle>> =
        |body, map| MaybeUninit::new(Mover::platformer(Axis::NEG_Y).move_and_slide(map, &body.0, body.1));
    let loads = |_: &(Circle, Vec2), _: &Map| -> Query<_, _, _> { load::<_, _, _, 5, 0> };
    for (name, speed) in [("shapes: circle moves, <= 4 a frame", 4), ("shapes: circle moves, <= 30 a frame", 30)] {
        let next = move |r: &mut Random| {
            let body = ball(r).filter(|c| !map.overlaps(c))?;
            Some(((body, vec((r.raw(-speed, speed), r.raw(-speed, speed)))), map))
        };
        table.row(name, None, step, loads, next, Result::is_ok);
    }
    let step: Query<(Aabb, Vec2), Map, Step<Aabb>> =
        |body, map| MaybeUninit::new(Mover::platformer(Axis::NEG_Y).move_and_slide(map, &body.0, body.1));
    let loads = |_: &(Aabb, Vec2), _: &Map| -> Query<_, _, _> { load::<_, _, _, 6, 0> };
    let next = move |r: &mut Random| {
        let body = crate_(r).filter(|b| !map.overlaps(b))?;
        Some(((body, vec((r.raw(-4, 4), r.raw(-4, 4)))), map))
    };
    table.row("shapes: box moves, <= 4 a frame", None, step, loads, next, Result::is_ok);
}

/// A ball of 10 units through the level of all shapes.
fn casts(table: &mut Table, map: Map) {
    type Found = Result<Option<BodyHit<Circle>>, RangeError>;
    let cast: Query<(Circle, Vec2), Map, Found> = |a, map| MaybeUninit::new(map.cast_shape(&a.0, a.1, Inside::Ignore));
    for (name, reach) in
        [("shapes: circle cast_shape, up to 30 units", 30), ("shapes: circle cast_shape, up to 300 units", 300)]
    {
        let next = |r: &mut Random| {
            let shape = ball(r).filter(|c| !map.overlaps(c))?;
            let by = vec((r.raw(-reach, reach), r.raw(-reach, reach)));
            Some(((shape, by), map))
        };
        table.row(name, None, cast, |_, _| load::<_, _, _, 5, 0>, next, Result::is_ok);
    }
}
