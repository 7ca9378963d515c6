//! Rows of the pair queries other than overlap, contact, distance and cast.

use core::mem::MaybeUninit;
use tilesat::prelude::*;
use tilesat::{Aabb, Circle, Contact, Segment, Vec2};
use tilesat_counts::inputs::{Random, any_box, any_segment, near_box, near_circles, near_segment, vec};
use tilesat_counts::measure::{Query, Table, load};

type Points = Option<(Vec2, Vec2)>;

pub fn rows(table: &mut Table) {
    touches(table);
    contains(table);
    boxes_and_segments(table);
    points(table);
}

fn touches(table: &mut Table) {
    let query: Query<Circle, Circle, bool> = |a, b| MaybeUninit::new(a.touches(b));
    table.row("circle-circle touches, near", None, query, |_, _| load::<_, _, _, 3, 3>, near_circles, |_| true);
    let query: Query<Circle, Aabb, bool> = |a, b| MaybeUninit::new(a.touches(b));
    table.row("circle-AABB touches, near", None, query, |_, _| load::<_, _, _, 3, 4>, near_box, |_| true);
    let query: Query<Circle, Segment, bool> = |a, b| MaybeUninit::new(a.touches(b));
    table.row("circle-segment touches, near", None, query, |_, _| load::<_, _, _, 3, 4>, near_segment, |_| true);
}

fn contains(table: &mut Table) {
    let query: Query<Circle, Aabb, bool> = |a, b| MaybeUninit::new(a.contains(b));
    table.row("circle contains AABB, near", None, query, |_, _| load::<_, _, _, 3, 4>, near_box, |_| true);
    let query: Query<Circle, Vec2, bool> = |a, p| MaybeUninit::new(a.contains(p));
    let near = |r: &mut Random| near_circles(r).map(|(a, b)| (a, b.centre()));
    table.row("circle contains point, near", None, query, |_, _| load::<_, _, _, 3, 2>, near, |_| true);
}

fn boxes_and_segments(table: &mut Table) {
    let loads = |_: &Aabb, _: &Segment| -> Query<_, _, bool> { load::<_, _, _, 4, 4> };
    let any = |r: &mut Random| Some((any_box(r)?, any_segment(r)?));
    let query: Query<Aabb, Segment, bool> = |a, b| MaybeUninit::new(a.overlaps(b));
    table.row("AABB-segment overlaps, uniform", None, query, loads, any, |_| true);
    let query: Query<Aabb, Segment, Option<Contact>> = |a, b| MaybeUninit::new(a.contact(b));
    let hit = move |r: &mut Random| any(r).filter(|(a, b)| a.overlaps(b));
    table.row("AABB-segment contact", None, query, |_, _| load::<_, _, _, 4, 4>, hit, Option::is_some);
    let query: Query<Segment, Segment, bool> = |a, b| MaybeUninit::new(a.overlaps(b));
    let pair = |r: &mut Random| Some((any_segment(r)?, any_segment(r)?));
    table.row("segment-segment overlaps, uniform", None, query, |_, _| load::<_, _, _, 4, 4>, pair, |_| true);
}

fn points(table: &mut Table) {
    let query: Query<Circle, Segment, Points> = |a, b| MaybeUninit::new(a.closest_points(b));
    let apart = |r: &mut Random| near_segment(r).filter(|(a, b)| !a.overlaps(b));
    table.row("circle-segment closest_points", None, query, |_, _| load::<_, _, _, 3, 4>, apart, |_| true);
    let touched = |r: &mut Random| {
        let (a, b) = near_segment(r)?;
        Some((a.contact(&b)?, ()))
    };
    let query: Query<Contact, (), Vec2> = |c, ()| MaybeUninit::new(c.point_on_b());
    table.row(
        "contact point, circle-segment",
        None,
        query,
        |_, _| load::<_, _, _, 8, 0>,
        touched,
        |p| *p != vec((0, 0)),
    );
}
