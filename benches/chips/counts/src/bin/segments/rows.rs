//! Rows of a level of free segments: hills and a wall. It is a quarter as large as the other
//! levels.

use core::mem::MaybeUninit;
use tilesat::motion::{MoveError, Moved, Mover};
use tilesat::{
    Axis, Circle, Fx, Inside, Path, PathKind, RangeError, RayHit, SegmentMap, Vec2,
    motion::BodyHit,
    world::{Near, OneWay},
};
use tilesat::{segment_map, world::WorldContact};
use tilesat_counts::inputs::{Random, UNIT, circle, vec};
use tilesat_counts::measure::{Query, Table, load};

/// A polygon with concave corners, and a wall above it.
const HILLS: [Vec2; 9] = [
    Vec2::from_ints(0, 384),
    Vec2::from_ints(0, 200),
    Vec2::from_ints(64, 256),
    Vec2::from_ints(128, 240),
    Vec2::from_ints(176, 300),
    Vec2::from_ints(230, 300),
    Vec2::from_ints(300, 220),
    Vec2::from_ints(384, 260),
    Vec2::from_ints(384, 384),
];
const WALL: [Vec2; 4] =
    [Vec2::from_ints(60, 60), Vec2::from_ints(180, 90), Vec2::from_ints(200, 150), Vec2::from_ints(330, 110)];

segment_map!(static LEVEL: [Path::new(PathKind::Solid, &HILLS), Path::new(PathKind::Wall, &WALL)], Fx::lit("32"));

type Map = &'static SegmentMap<'static>;

pub fn rows(table: &mut Table) {
    let loads = |_: &Circle, _: &Map| load::<_, _, _, 3, 0> as Query<Circle, Map, bool>;
    for (name, wanted) in [("segments: circle overlaps, hit", true), ("segments: circle overlaps, free", false)] {
        let next = move |r: &mut Random| ball(r).filter(|c| LEVEL.overlaps(c) == wanted).map(|c| (c, &LEVEL));
        table.row(name, None, |c, map| MaybeUninit::new(map.overlaps(c)), loads, next, |&hit| hit == wanted);
    }
    rays(table);
    surface(table);
    motion(table);
}

fn place(r: &mut Random) -> Vec2 {
    vec((r.raw(24, 360), r.raw(24, 320)))
}

fn ball(r: &mut Random) -> Option<Circle> {
    let centre = place(r);
    circle((centre.raw().0, centre.raw().1), 10 * UNIT)
}

fn rays(table: &mut Table) {
    let ray: Query<(Vec2, Vec2), Map, Result<Option<RayHit>, RangeError>> =
        |a, map| MaybeUninit::new(map.cast_ray(a.0, a.1, Inside::Ignore));
    let next = |r: &mut Random| {
        let (from, by) = (place(r), vec((r.raw(-384, 384), r.raw(-384, 384))));
        let hit = LEVEL.cast_ray(from, by, Inside::Hit).ok()??;
        (!hit.inside).then_some(((from, by), &LEVEL))
    };
    table.row("segments: ray, hit", None, ray, |_, _| load::<_, _, _, 4, 0>, next, |hit| matches!(hit, Ok(Some(_))));
    type Found = Result<Option<BodyHit<Circle>>, RangeError>;
    let cast: Query<(Circle, Vec2), Map, Found> = |a, map| MaybeUninit::new(map.cast_shape(&a.0, a.1, Inside::Ignore));
    let next = |r: &mut Random| {
        let by = vec((r.raw(-30, 30), r.raw(-30, 30)));
        Some(((ball(r).filter(|c| !LEVEL.overlaps(c))?, by), &LEVEL))
    };
    table.row(
        "segments: circle cast_shape, up to 30 units",
        None,
        cast,
        |_, _| load::<_, _, _, 5, 0>,
        next,
        Result::is_ok,
    );
}

fn surface(table: &mut Table) {
    let query: Query<Circle, Map, (bool, Option<WorldContact>)> = |c, map| {
        let mut out = tilesat::heapless::Vec::<_, 8>::new();
        let all = map.contacts(c, OneWay::Ignore, &mut out).is_ok();
        MaybeUninit::new((all, out.first().copied()))
    };
    let next = |r: &mut Random| ball(r).filter(|c| LEVEL.overlaps(c)).map(|c| (c, &LEVEL));
    table.row(
        "segments: circle contacts, overlapping",
        None,
        query,
        |_, _| load::<_, _, _, 3, 0>,
        next,
        |found| found.0,
    );
    let query: Query<Vec2, Map, Result<Option<Near>, RangeError>> =
        |p, map| MaybeUninit::new(map.closest_point(*p, Fx::from_bits(24 * UNIT), OneWay::Ignore));
    let next = |r: &mut Random| Some((place(r), &LEVEL));
    table.row("segments: closest point, within 24", None, query, |_, _| load::<_, _, _, 2, 0>, next, Result::is_ok);
}

fn motion(table: &mut Table) {
    let step: Query<(Circle, Vec2), Map, Result<Moved<Circle>, MoveError>> =
        |a, map| MaybeUninit::new(Mover::platformer(Axis::NEG_Y).move_and_slide(*map, &a.0, a.1));
    let next = |r: &mut Random| {
        let by = vec((r.raw(-4, 4), r.raw(-4, 4)));
        Some(((ball(r).filter(|c| !LEVEL.overlaps(c))?, by), &LEVEL))
    };
    table.row("segments: circle moves, <= 4 a frame", None, step, |_, _| load::<_, _, _, 5, 0>, next, Result::is_ok);
}
