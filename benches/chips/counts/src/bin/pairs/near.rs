//! Rows of the queries on a broad phase of 64 bodies, in a room of 512 x 512.

use core::mem::MaybeUninit;
use tilesat::broad::{BroadHit, BroadPhase, Handle, Nearest, QueryError, SortSweep, SpatialHash};
use tilesat::heapless::Vec;
use tilesat::{Aabb, Fx, RangeError, Vec2};
use tilesat_chip::eprintln;
use tilesat_counts::inputs::{Random, vec};
use tilesat_counts::measure::{Query, Table, load};

const BODIES: usize = 64;
type Hits = (Result<(), QueryError>, Option<BroadHit>);

pub fn rows(table: &mut Table) {
    let mut sweep = SortSweep::<BODIES>::new();
    fill(&mut sweep);
    of(table, "sweep of 64", &sweep);
    let Ok(mut hash) = SpatialHash::<BODIES, BODIES>::new(Fx::lit("32")) else {
        eprintln!("no hash");
        table.wrong += 1;
        return;
    };
    fill(&mut hash);
    of(table, "hash of 64", &hash);
}

fn point(r: &mut Random) -> Vec2 {
    vec((r.raw(0, 512), r.raw(0, 512)))
}

/// A box of 6 to 24 units.
fn body(r: &mut Random) -> Option<Aabb> {
    let (x, y) = point(r).raw();
    Aabb::new(vec((x, y)), vec((x + r.raw(6, 24), y + r.raw(6, 24)))).ok()
}

fn fill(near: &mut impl BroadPhase<Tag = ()>) {
    let r = &mut Random::new(3);
    while near.len() < BODIES {
        let _ = body(r).map(|bounds| near.insert(&bounds, ()));
    }
    // In order, as after a frame.
    near.pairs(|_| {});
}

fn of<B: BroadPhase<Tag = ()>>(table: &mut Table, which: &str, near: &B) {
    let mut name = tilesat::heapless::String::<48>::new();
    let mut named = |what: &str| {
        name.clear();
        let _ = core::fmt::Write::write_fmt(&mut name, format_args!("{which}: {what}"));
        name.clone()
    };
    let region: Query<Aabb, &B, u32> = |area, near| {
        let mut found = 0;
        near.in_region(area, |_| found += 1);
        MaybeUninit::new(found)
    };
    let next = |r: &mut Random| Some((body(r)?, near));
    table.row(&named("in_region, a body's box"), None, region, |_, _| load::<_, _, _, 4, 0>, next, |_| true);
    let at: Query<Vec2, &B, Option<Handle>> = |p, near| {
        let mut found = None;
        near.at_point(*p, |body| found = Some(body));
        MaybeUninit::new(found)
    };
    table.row(&named("at_point"), None, at, |_, _| load::<_, _, _, 2, 0>, |r| Some((point(r), near)), |_| true);
    let nearest: Query<Vec2, &B, Result<Option<Nearest>, RangeError>> =
        |p, near| MaybeUninit::new(near.nearest(*p, Fx::lit("64"), |_, ()| true));
    table.row(
        &named("nearest within 64"),
        None,
        nearest,
        |_, _| load::<_, _, _, 2, 0>,
        |r| Some((point(r), near)),
        Result::is_ok,
    );
    let ray: Query<(Vec2, Vec2), &B, Hits> = |a, near| {
        let mut out = Vec::<_, 8>::new();
        let done = near.cast_ray(a.0, a.1, |_, ()| true, &mut out);
        MaybeUninit::new((done, out.first().copied()))
    };
    let next = |r: &mut Random| Some(((point(r), vec((r.raw(-128, 128), r.raw(-128, 128)))), near));
    table.row(&named("ray, up to 181 units"), None, ray, |_, _| load::<_, _, _, 4, 0>, next, |hits| hits.0.is_ok());
    let cast: Query<(Aabb, Vec2), &B, Hits> = |a, near| {
        let mut out = Vec::<_, 8>::new();
        let done = near.cast_shape(&a.0, a.1, |_, ()| true, &mut out);
        MaybeUninit::new((done, out.first().copied()))
    };
    let next = |r: &mut Random| Some(((body(r)?, vec((r.raw(-32, 32), r.raw(-32, 32)))), near));
    table.row(
        &named("box cast, up to 45 units"),
        None,
        cast,
        |_, _| load::<_, _, _, 6, 0>,
        next,
        |hits| hits.0.is_ok(),
    );
}
