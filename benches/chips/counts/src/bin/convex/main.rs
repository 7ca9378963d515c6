//! Prints what oriented boxes, polygons and slanted capsules cost: in pairs, and in motion.

#![no_std]
#![no_main]

use core::cell::UnsafeCell;
use core::mem::MaybeUninit;
use tilesat::motion::{Body, MoveError, Moved, Mover};
use tilesat::prelude::*;
use tilesat::query::Separation;
use tilesat::shape::AnyShape;
use tilesat::{
    Axis, Capsule, ConvexPolygon, Fx, Grid, OrientedBox, Outside, TileKind, TileKinds, TileMap, Vec2, World,
};
use tilesat_chip::entry;
use tilesat_counts::inputs::{Random, UNIT, vec};
use tilesat_counts::measure::{Query, Table, load};
use tilesat_counts::shapes::{BLOCKS, CELL, SIDE, level, place};

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

type Quad = ConvexPolygon<4>;

fn direction(r: &mut Random) -> Axis {
    Axis::new(r.raw(-1, 1) | 1, r.raw(-1, 1))
}

/// 14 units by 20, as the boxes that move, around a place.
fn turned_at(r: &mut Random, at: (i32, i32)) -> Option<OrientedBox> {
    OrientedBox::new(vec(at), vec((7 * UNIT, 10 * UNIT)), direction(r)).ok()
}

fn quad_at(r: &mut Random, at: (i32, i32)) -> Option<Quad> {
    ConvexPolygon::new(&turned_at(r, at)?.corners()).ok()
}

/// The same size without parallel sides.
fn kite_at(r: &mut Random, at: (i32, i32)) -> Option<Quad> {
    let mut corners = turned_at(r, at)?.corners();
    for corner in &mut corners {
        *corner += Vec2::from_raw(r.raw(-3, 3), r.raw(-3, 3));
    }
    Quad::new(&corners).ok()
}

fn capsule_at(r: &mut Random, at: (i32, i32)) -> Option<Capsule> {
    let by = (r.raw(-8, 8), r.raw(-8, 8));
    Capsule::new(vec(at), vec((at.0 + by.0, at.1 + by.1)), Fx::from_bits(5 * UNIT)).ok()
}

/// Two places that are up to so many units apart on each axis.
fn beside(r: &mut Random, far: i32) -> ((i32, i32), (i32, i32)) {
    let a = (r.raw(-100, 100), r.raw(-100, 100));
    (a, (a.0 + r.raw(-far, far), a.1 + r.raw(-far, far)))
}

fn pairs<A: Copy + Overlaps<A> + OverlapsFrom<A> + Contacts<A>>(
    table: &mut Table,
    names: [&str; 4],
    make: fn(&mut Random, (i32, i32)) -> Option<A>,
) {
    let overlaps: Query<A, A, bool> = |a, b| MaybeUninit::new(a.overlaps(b));
    let loads = |_: &A, _: &A| -> Query<A, A, bool> { load::<_, _, _, 4, 4> };
    let pair = move |r: &mut Random, far: i32| {
        let (a, b) = beside(r, far);
        Some((make(r, a)?, make(r, b)?))
    };
    let hit = move |r: &mut Random| pair(r, 16).filter(|(a, b)| a.overlaps(b));
    let miss = move |r: &mut Random| pair(r, 60).filter(|(a, b)| !a.overlaps(b));
    table.row(names[0], None, overlaps, loads, hit, |&yes| yes);
    table.row(names[1], None, overlaps, loads, miss, |&yes| !yes);
    // With the side that separates them. A game keeps it with the pair and passes it by reference,
    // so a copy would not be part of the call.
    let hinted: Query<(A, UnsafeCell<Separation>), A, bool> = |a, b| {
        // SAFETY: nothing else refers to the hint while the query runs.
        let last = unsafe { &mut *a.1.get() };
        MaybeUninit::new(a.0.overlaps_from(b, last))
    };
    let known = move |r: &mut Random| {
        let (a, b) = miss(r)?;
        let mut last = Separation::default();
        let _ = a.overlaps_from(&b, &mut last);
        Some(((a, UnsafeCell::new(last)), b))
    };
    table.row(names[2], None, hinted, |_, _| load::<_, _, _, 4, 4>, known, |&yes| !yes);
    let contact: Query<A, A, Option<tilesat::Contact>> = |a, b| MaybeUninit::new(a.contact(b));
    table.row(names[3], None, contact, |_, _| load::<_, _, _, 4, 4>, hit, Option::is_some);
}

fn moves<W: World + Copy, B: Body>(
    table: &mut Table,
    map: W,
    name: &str,
    speed: i32,
    make: fn(&mut Random, (i32, i32)) -> Option<B>,
) {
    let step: Query<(B, Vec2), W, Result<Moved<B>, MoveError>> =
        |body, map| MaybeUninit::new(Mover::platformer(Axis::NEG_Y).move_and_slide(map, &body.0, body.1));
    let loads = |_: &(B, Vec2), _: &W| -> Query<_, _, _> { load::<_, _, _, 8, 0> };
    let next = move |r: &mut Random| {
        let at = place(r);
        let body = make(r, at)?;
        // What starts in the solid is refused.
        let _ = Mover::platformer(Axis::NEG_Y).move_and_slide(&map, &body, vec((1, 0))).ok()?;
        Some(((body, vec((r.raw(-speed, speed), r.raw(-speed, speed)))), map))
    };
    table.row(name, None, step, loads, next, Result::is_ok);
}

fn any_capsule(r: &mut Random, at: (i32, i32)) -> Option<AnyShape<4>> {
    capsule_at(r, at).map(AnyShape::from)
}

#[entry]
fn main() -> ! {
    let mut table = Table::start();
    pairs(
        &mut table,
        [
            "turned boxes overlap, hit",
            "turned boxes overlap, apart",
            "turned boxes overlap, apart by the last side",
            "turned boxes, contact",
        ],
        turned_at,
    );
    pairs(
        &mut table,
        ["quads overlap, hit", "quads overlap, apart", "quads overlap, apart by the last side", "quads, contact"],
        quad_at,
    );
    pairs(
        &mut table,
        ["kites overlap, hit", "kites overlap, apart", "kites overlap, apart by the last side", "kites, contact"],
        kite_at,
    );
    pairs(
        &mut table,
        [
            "capsules overlap, hit",
            "capsules overlap, apart",
            "capsules overlap, apart by the last side",
            "capsules, contact",
        ],
        capsule_at,
    );
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL * UNIT), Vec2::ZERO);
    let blocks = grid.ok().and_then(|grid| TileMap::<'static>::on_grid(&BLOCKS, grid, &KINDS).ok());
    if let (Some(blocks), Some(shapes)) = (blocks, level()) {
        let blocks = blocks.with_outside(Outside::Solid);
        moves(&mut table, blocks, "blocks: turned box moves, <= 4 a frame", 4, turned_at);
        moves(&mut table, shapes, "shapes: turned box moves, <= 4 a frame", 4, turned_at);
        moves(&mut table, shapes, "shapes: slanted capsule moves, <= 4 a frame", 4, any_capsule);
    } else {
        table.wrong += 1;
    }
    table.end()
}
