//! Rows of queries to a scene of 64 bodies: rays, casts, regions and points anywhere in the level.

use core::mem::MaybeUninit;
use tilesat::scene::{FirstHit, SceneCast, SceneHit};
use tilesat::world::RayHit;
use tilesat::{Circle, Inside, RangeError, Vec2};
use tilesat_counts::bodies::Bodies;
use tilesat_counts::inputs::{Random, UNIT, circle, vec};
use tilesat_counts::measure::{Query, Table, load};
use tilesat_counts::shapes::{Map, ball, place};

/// A scene that does not change while it is asked.
type Asked = *const Bodies<0>;
type Both = (Asked, *const Map);
type First = Result<Option<SceneHit>, RangeError>;
type RayFirst = Result<Option<FirstHit<RayHit>>, RangeError>;
type CastFirst = Result<Option<SceneCast>, RangeError>;

pub fn rows(table: &mut Table, scene: &Bodies<0>, map: &Map) {
    let scene: Asked = scene;
    // SAFETY of all six: nothing changes the scene or the level while the references live.
    let ray: Query<(Vec2, Vec2), Asked, First> =
        |a, scene| MaybeUninit::new(unsafe { &**scene }.cast_ray(a.0, a.1, Inside::Hit, |_, _| true));
    let cast: Query<(Circle, Vec2), Asked, First> =
        |a, scene| MaybeUninit::new(unsafe { &**scene }.cast_shape(&a.0, a.1, Inside::Hit, |_, _| true));
    let ray_in: Query<(Vec2, Vec2), Both, RayFirst> = |a, (scene, map)| {
        MaybeUninit::new(unsafe { (**scene).cast_ray_in(&**map, a.0, a.1, Inside::Hit, |_, _| true) })
    };
    let cast_in: Query<(Circle, Vec2), Both, CastFirst> = |a, (scene, map)| {
        MaybeUninit::new(unsafe { (**scene).cast_shape_in(&**map, a.0, a.1, Inside::Hit, |_, _| true) })
    };
    let blast: Query<Circle, Asked, u32> = |circle, scene| {
        let mut met = 0;
        unsafe { &**scene }.overlapping(circle, |_, _| met += 1);
        MaybeUninit::new(met)
    };
    let point: Query<Vec2, Asked, u32> = |point, scene| {
        let mut met = 0;
        unsafe { &**scene }.at_point(*point, |_, _| met += 1);
        MaybeUninit::new(met)
    };
    let start = |r: &mut Random| vec(place(r));
    let way = |r: &mut Random| vec((r.raw(-200, 200), r.raw(-200, 200)));
    let name = "64 bodies: a ray up to 200 units";
    table.row(name, None, ray, |_, _| load::<_, _, _, 4, 0>, |r| Some(((start(r), way(r)), scene)), Result::is_ok);
    let short = |r: &mut Random| vec((r.raw(-30, 30), r.raw(-30, 30)));
    let name = "64 bodies: a circle cast up to 30 units";
    table.row(name, None, cast, |_, _| load::<_, _, _, 5, 0>, |r| Some(((ball(r)?, short(r)), scene)), Result::is_ok);
    let both: Both = (scene, map);
    let name = "64 bodies and the level: a ray up to 200 units";
    table.row(name, None, ray_in, |_, _| load::<_, _, _, 4, 0>, |r| Some(((start(r), way(r)), both)), Result::is_ok);
    let name = "64 bodies and the level: a circle up to 30 units";
    table.row(name, None, cast_in, |_, _| load::<_, _, _, 5, 0>, |r| Some(((ball(r)?, short(r)), both)), Result::is_ok);
    let wide = |r: &mut Random| circle(place(r), 40 * UNIT);
    let name = "64 bodies: a circle of 40 units, all that overlap";
    table.row(name, None, blast, |_, _| load::<_, _, _, 3, 0>, |r| Some((wide(r)?, scene)), |_| true);
    let name = "64 bodies: all at a point";
    table.row(name, None, point, |_, _| load::<_, _, _, 2, 0>, |r| Some((start(r), scene)), |_| true);
}
