//! Rows of casts of pairs.

use core::mem::MaybeUninit;
use tilesat::prelude::*;
use tilesat::{Aabb, CastHit, Circle, Inside, RangeError, Segment, Vec2};
use tilesat_counts::inputs::{Random, any_box, any_circle, any_segment, vec};
use tilesat_counts::measure::{Budget, Query, Table, load};

/// A shape and its motion, in the order in which the operands are loaded.
pub struct Moving<S> {
    shape: S,
    by: Vec2,
}

/// A shape that can be cast, and its centre.
trait Placed: Copy {
    fn any(r: &mut Random) -> Option<Self>;
}

impl Placed for Aabb {
    fn any(r: &mut Random) -> Option<Self> {
        any_box(r)
    }
}

impl Placed for Circle {
    fn any(r: &mut Random) -> Option<Self> {
        any_circle(r)
    }
}

impl Placed for Segment {
    fn any(r: &mut Random) -> Option<Self> {
        any_segment(r)
    }
}

/// Disjoint shapes in a 64 unit square, and a motion between any two points of it that hits or
/// misses.
fn pair<A: CastShape<B> + Overlaps<B> + Placed, B: Placed>(r: &mut Random, hits: bool) -> Option<(Moving<A>, B)> {
    let (a, b) = (A::any(r)?, B::any(r)?);
    let by = vec(r.point()) - vec(r.point());
    let found = a.would_hit(&b, by, Inside::Ignore).ok()?;
    (!a.overlaps(&b) && found == hits).then_some((Moving { shape: a, by }, b))
}

type Cast = Result<Option<CastHit>, RangeError>;

fn rows_of<A: CastShape<B> + Overlaps<B> + Placed, B: Placed, const NA: usize, const NB: usize>(
    table: &mut Table,
    names: [&str; 3],
    [miss, yes, whole]: [Budget; 3],
) {
    let would_hit: Query<Moving<A>, B, bool> =
        |a, b| MaybeUninit::new(matches!(a.shape.would_hit(b, a.by, Inside::Ignore), Ok(true)));
    let cast: Query<Moving<A>, B, Cast> = |a, b| MaybeUninit::new(a.shape.cast_shape(b, a.by, Inside::Ignore));
    let loads = |_: &Moving<A>, _: &B| load::<_, _, _, NA, NB> as Query<Moving<A>, B, bool>;
    table.row(names[0], miss, would_hit, loads, |r| pair(r, false), |&yes| !yes);
    table.row(names[1], yes, would_hit, loads, |r| pair(r, true), |&yes| yes);
    let loads = |_: &Moving<A>, _: &B| load::<_, _, _, NA, NB> as Query<Moving<A>, B, Cast>;
    table.row(names[2], whole, cast, loads, |r| pair(r, true), |hit| matches!(hit, Ok(Some(_))));
}

pub fn rows(table: &mut Table) {
    rows_of::<Aabb, Aabb, 6, 4>(
        table,
        ["AABB-AABB would_hit, miss", "AABB-AABB would_hit, hit", "AABB-AABB cast_shape, hit"],
        [None, Some((160, 60)), Some((410, 310))],
    );
    rows_of::<Circle, Circle, 5, 3>(
        table,
        ["circle-circle would_hit, miss", "circle-circle would_hit, hit", "circle-circle cast_shape, hit"],
        [Some((360, 100)), Some((360, 100)), Some((1350, 630))],
    );
    rows_of::<Circle, Aabb, 5, 4>(
        table,
        ["circle-AABB would_hit, miss", "circle-AABB would_hit, hit", "circle-AABB cast_shape, hit"],
        [None, None, None],
    );
    rows_of::<Circle, Segment, 5, 4>(
        table,
        ["circle-segment would_hit, miss", "circle-segment would_hit, hit", "circle-segment cast_shape, hit"],
        [None, None, None],
    );
    rows_of::<Aabb, Segment, 6, 4>(
        table,
        ["AABB-segment would_hit, miss", "AABB-segment would_hit, hit", "AABB-segment cast_shape, hit"],
        [None, None, None],
    );
    exact(table);
    rays(table);
}

fn exact(table: &mut Table) {
    table.row(
        "circle-circle exact_toi, hit",
        None,
        |a: &Moving<Circle>, b: &Circle| MaybeUninit::new(a.shape.exact_toi(b, a.by, Inside::Ignore)),
        |_, _| load::<_, _, _, 5, 3>,
        |r| pair(r, true),
        |toi| matches!(toi, Ok(Some(_))),
    );
}

fn rays(table: &mut Table) {
    fn hit<B: Placed>(r: &mut Random, cast: impl Fn(&B, Vec2, Vec2) -> Cast) -> Option<(Moving<Vec2>, B)> {
        let (from, b) = (vec(r.point()), B::any(r)?);
        let by = vec(r.point()) - from;
        matches!(cast(&b, from, by), Ok(Some(_))).then_some((Moving { shape: from, by }, b))
    }
    table.row(
        "ray-AABB cast_ray, hit",
        None,
        |a: &Moving<Vec2>, b: &Aabb| MaybeUninit::new(b.cast_ray(a.shape, a.by, Inside::Ignore)),
        |_, _| load::<_, _, _, 4, 4>,
        |r| hit(r, |b: &Aabb, o, d| b.cast_ray(o, d, Inside::Ignore)),
        |hit| matches!(hit, Ok(Some(_))),
    );
    table.row(
        "ray-circle cast_ray, hit",
        None,
        |a: &Moving<Vec2>, b: &Circle| MaybeUninit::new(b.cast_ray(a.shape, a.by, Inside::Ignore)),
        |_, _| load::<_, _, _, 4, 3>,
        |r| hit(r, |b: &Circle, o, d| b.cast_ray(o, d, Inside::Ignore)),
        |hit| matches!(hit, Ok(Some(_))),
    );
    table.row(
        "ray-segment cast_ray, hit",
        None,
        |a: &Moving<Vec2>, b: &Segment| MaybeUninit::new(b.cast_ray(a.shape, a.by)),
        |_, _| load::<_, _, _, 4, 4>,
        |r| hit(r, |b: &Segment, o, d| b.cast_ray(o, d)),
        |hit| matches!(hit, Ok(Some(_))),
    );
}
