//! Rows of the pair queries.

use core::mem::MaybeUninit;
use tilesat::prelude::*;
use tilesat::{Aabb, Circle, Contact, Fx, Segment, Vec2};
use tilesat_counts::inputs::{
    Boxes, Random, any_box, any_circle, any_segment, boxes, near_box, near_circles, near_segment, touching_box,
    touching_circles, touching_segment,
};
use tilesat_counts::measure::{Budget, Query, Table, load};

/// A query in the form that the table needs.
macro_rules! query {
    (|$a:ident: $A:ty, $b:ident: $B:ty| $call:expr) => {
        |$a: &$A, $b: &$B| MaybeUninit::new($call)
    };
}

pub fn rows(table: &mut Table) {
    boxes_with_boxes(table);
    circles_with_circles(table);
    circles_with_boxes(table);
    circles_with_segments(table);
    contacts(table);
    lengths(table);
}

fn boxes_with_boxes(table: &mut Table) {
    let overlaps: Query<Aabb, Aabb, bool> = query!(|a: Aabb, b: Aabb| a.overlaps(b));
    let pair = |r: &mut Random| Some((any_box(r)?, any_box(r)?));
    let apart = |axis: Boxes, a_first: bool| {
        move |r: &mut Random| {
            let (a, b) = pair(r)?;
            let (lo, hi) = if a_first { (&a, &b) } else { (&b, &a) };
            let ordered = if axis == Boxes::ApartInX { lo.max().x <= hi.min().x } else { lo.max().y <= hi.min().y };
            (boxes(&a, &b) == axis && ordered).then_some((a, b))
        }
    };
    let hit = |r: &mut Random| pair(r).filter(|(a, b)| boxes(a, b) == Boxes::Overlap);
    table.row("AABB-AABB overlaps, hit", Some((20, 18)), overlaps, |_, _| load::<_, _, _, 4, 4>, hit, |&yes| yes);
    // The tests run in the library's order. The first one has the budget of the first reject.
    let rejects: [(&str, Budget, Boxes, bool); 4] = [
        ("AABB-AABB overlaps, first reject (A right)", Some((10, 10)), Boxes::ApartInX, false),
        ("AABB-AABB overlaps, second reject (A left)", None, Boxes::ApartInX, true),
        ("AABB-AABB overlaps, third reject (A beyond)", None, Boxes::ApartInY, false),
        ("AABB-AABB overlaps, last reject (A before)", None, Boxes::ApartInY, true),
    ];
    for (name, budget, axis, a_first) in rejects {
        table.row(name, budget, overlaps, |_, _| load::<_, _, _, 1, 1>, apart(axis, a_first), |&yes| !yes);
    }
}

fn circles_with_circles(table: &mut Table) {
    let overlaps: Query<Circle, Circle, bool> = query!(|a: Circle, b: Circle| a.overlaps(b));
    // Circles that are apart in x need no y.
    let loads = |a: &Circle, b: &Circle| -> Query<Circle, Circle, bool> {
        if boxes(&a.aabb(), &b.aabb()) == Boxes::ApartInX { load::<_, _, _, 2, 2> } else { load::<_, _, _, 3, 3> }
    };
    let any = |r: &mut Random| Some((any_circle(r)?, any_circle(r)?));
    let far = |r: &mut Random| any(r).filter(|(a, b)| boxes(&a.aabb(), &b.aabb()) != Boxes::Overlap);
    table.row("circle-circle overlaps, far", Some((30, 20)), overlaps, loads, far, |&yes| !yes);
    table.row("circle-circle overlaps, uniform", Some((30, 20)), overlaps, loads, any, |_| true);
    table.row("circle-circle overlaps, near", Some((55, 33)), overlaps, loads, near_circles, |_| true);
    table.row("circle-circle overlaps, touching", Some((105, 46)), overlaps, loads, touching_circles, |_| true);
}

fn circles_with_boxes(table: &mut Table) {
    let overlaps: Query<Circle, Aabb, bool> = query!(|a: Circle, b: Aabb| a.overlaps(b));
    let loads = |a: &Circle, b: &Aabb| -> Query<Circle, Aabb, bool> {
        if boxes(&a.aabb(), b) == Boxes::ApartInX { load::<_, _, _, 2, 2> } else { load::<_, _, _, 3, 4> }
    };
    let any = |r: &mut Random| Some((any_circle(r)?, any_box(r)?));
    let far = |r: &mut Random| any(r).filter(|(a, b)| boxes(&a.aabb(), b) != Boxes::Overlap);
    let budget = Some((40, 27));
    table.row("circle-AABB overlaps, far", budget, overlaps, loads, far, |&yes| !yes);
    table.row("circle-AABB overlaps, uniform", budget, overlaps, loads, any, |_| true);
    table.row("circle-AABB overlaps, near", budget, overlaps, loads, near_box, |_| true);
    table.row("circle-AABB overlaps, touching a corner", None, overlaps, loads, touching_box, |_| true);
}

fn circles_with_segments(table: &mut Table) {
    let overlaps: Query<Circle, Segment, bool> = query!(|a: Circle, b: Segment| a.overlaps(b));
    let loads = |a: &Circle, b: &Segment| -> Query<Circle, Segment, bool> {
        if boxes(&a.aabb(), &b.aabb()) == Boxes::ApartInX { load::<_, _, _, 2, 3> } else { load::<_, _, _, 3, 4> }
    };
    let any = |r: &mut Random| Some((any_circle(r)?, any_segment(r)?));
    let far = |r: &mut Random| any(r).filter(|(a, b)| boxes(&a.aabb(), &b.aabb()) != Boxes::Overlap);
    table.row("circle-segment overlaps, far", Some((110, 60)), overlaps, loads, far, |&yes| !yes);
    table.row("circle-segment overlaps, uniform", None, overlaps, loads, any, |_| true);
    table.row("circle-segment overlaps, near", Some((520, 118)), overlaps, loads, near_segment, |_| true);
    table.row("circle-segment overlaps, touching", Some((520, 118)), overlaps, loads, touching_segment, |_| true);
}

/// Pairs that overlap, and the contact of each.
fn overlapping<A: Contacts<B>, B>(
    mut near: impl FnMut(&mut Random) -> Option<(A, B)>,
) -> impl FnMut(&mut Random) -> Option<(Contact, ())> {
    move |r| {
        let (a, b) = near(r)?;
        Some((a.contact(&b)?, ()))
    }
}

fn contacts(table: &mut Table) {
    let near_aabb = |r: &mut Random| {
        let (a, b) = (any_box(r)?, any_box(r)?);
        a.overlaps(&b).then_some((a, b))
    };
    let circles = |r: &mut Random| near_circles(r).filter(|(a, b)| a.overlaps(b));
    let corner = |r: &mut Random| near_box(r).filter(|(a, b)| a.overlaps(b));
    let beside = |r: &mut Random| near_segment(r).filter(|(a, b)| a.overlaps(b));
    table.row(
        "AABB-AABB contact",
        None,
        query!(|a: Aabb, b: Aabb| a.contact(b)),
        |_, _| load::<_, _, _, 4, 4>,
        near_aabb,
        Option::is_some,
    );
    table.row(
        "circle-circle contact",
        None,
        query!(|a: Circle, b: Circle| a.contact(b)),
        |_, _| load::<_, _, _, 3, 3>,
        circles,
        Option::is_some,
    );
    table.row(
        "circle-AABB contact",
        None,
        query!(|a: Circle, b: Aabb| a.contact(b)),
        |_, _| load::<_, _, _, 3, 4>,
        corner,
        Option::is_some,
    );
    table.row(
        "circle-segment contact",
        None,
        query!(|a: Circle, b: Segment| a.contact(b)),
        |_, _| load::<_, _, _, 3, 4>,
        beside,
        Option::is_some,
    );

    // Two words hold the axis, from which both are made.
    let normal = query!(|c: Contact, _b: ()| c.normal());
    table.row(
        "unit normal, circle-circle",
        Some((270, 100)),
        normal,
        |_, _| load::<_, _, _, 2, 0>,
        overlapping(circles),
        |_| true,
    );
    table.row(
        "unit normal, circle-segment",
        Some((270, 100)),
        normal,
        |_, _| load::<_, _, _, 2, 0>,
        overlapping(beside),
        |_| true,
    );
    let push = query!(|c: Contact, _b: ()| c.push_out());
    table.row(
        "push-out, circle-circle",
        Some((350, 115)),
        push,
        |_, _| load::<_, _, _, 3, 0>,
        overlapping(circles),
        |_| true,
    );
    table.row(
        "push-out, circle-AABB",
        Some((350, 115)),
        push,
        |_, _| load::<_, _, _, 3, 0>,
        overlapping(corner),
        |_| true,
    );
    table.row("push-out, circle-segment", None, push, |_, _| load::<_, _, _, 3, 0>, overlapping(beside), |_| true);
    table.row("push-out, AABB-AABB", None, push, |_, _| load::<_, _, _, 3, 0>, overlapping(near_aabb), |_| true);
}

fn lengths(table: &mut Table) {
    let point = |r: &mut Random| tilesat_counts::inputs::vec(r.point());
    let positive = |d: &Fx| *d >= Fx::ZERO;
    table.row(
        "circle-circle distance",
        None,
        query!(|a: Circle, b: Circle| a.distance(b)),
        |_, _| load::<_, _, _, 3, 3>,
        |r| Some((any_circle(r)?, any_circle(r)?)),
        positive,
    );
    table.row(
        "circle-AABB distance",
        None,
        query!(|a: Circle, b: Aabb| a.distance(b)),
        |_, _| load::<_, _, _, 3, 4>,
        |r| Some((any_circle(r)?, any_box(r)?)),
        positive,
    );
    table.row(
        "circle-segment distance",
        None,
        query!(|a: Circle, b: Segment| a.distance(b)),
        |_, _| load::<_, _, _, 3, 4>,
        |r| Some((any_circle(r)?, any_segment(r)?)),
        positive,
    );
    table.row(
        "AABB-AABB distance",
        None,
        query!(|a: Aabb, b: Aabb| a.distance(b)),
        |_, _| load::<_, _, _, 4, 4>,
        |r| Some((any_box(r)?, any_box(r)?)),
        positive,
    );
    table.row(
        "circle closest_point",
        None,
        query!(|a: Circle, p: Vec2| a.closest_point(*p)),
        |_, _| load::<_, _, _, 3, 2>,
        move |r| Some((any_circle(r)?, point(r))),
        |_| true,
    );
    table.row(
        "AABB closest_point",
        None,
        query!(|a: Aabb, p: Vec2| a.closest_point(*p)),
        |_, _| load::<_, _, _, 4, 2>,
        move |r| Some((any_box(r)?, point(r))),
        |_| true,
    );
    table.row(
        "segment closest_point",
        None,
        query!(|a: Segment, p: Vec2| a.closest_point(*p)),
        |_, _| load::<_, _, _, 4, 2>,
        move |r| Some((any_segment(r)?, point(r))),
        |_| true,
    );
}
