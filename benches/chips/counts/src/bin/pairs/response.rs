//! Rows of the response toolkit.

use core::mem::MaybeUninit;
use tilesat::motion::response::{Split, Stick, exchange, separate, split};
use tilesat::prelude::*;
use tilesat::{
    Axis, Circle, Contact, Fx, RangeError, Ratio, Surface, Vec2,
    motion::{Acceleration, Carry, Masses, Speed},
};
use tilesat_counts::inputs::{Random, UNIT, near_circles, vec};
use tilesat_counts::measure::{Query, Table, load};

type Reply = Result<Vec2, RangeError>;
type Pair = (Vec2, Vec2);

pub fn rows(table: &mut Table) {
    replies(table);
    pairs(table);
    points(table);
}

/// A velocity of up to 8 units per frame into a surface, and the surface's normal: from centre to
/// centre of two circles.
fn askew(r: &mut Random) -> Option<(Vec2, Axis)> {
    let n = near_circles(r)?.0.centre();
    let n = Axis::new(n.raw().0 - 32 * UNIT, n.raw().1 - 32 * UNIT);
    let v = vec((r.raw(-8, 8), r.raw(-8, 8)));
    (n.dot_vec(v) < 0 && n.x != 0 && n.y != 0).then_some((v, n))
}

fn straight(r: &mut Random) -> Option<(Vec2, Axis)> {
    let (v, _) = askew(r)?;
    Some((v, if v.raw().1 > 0 { Axis::NEG_Y } else { Axis::Y }))
}

const RUBBER: Surface = Surface::new(Ratio::HALF, Ratio::HALF);
const SPEED: Speed = Speed::of(Vec2::from_ints(12, 0));

fn replies(table: &mut Table) {
    let loads = |_: &Vec2, _: &Axis| -> Query<Vec2, Axis, Reply> { load::<_, _, _, 2, 2> };
    let slide: Query<Vec2, Axis, Reply> = |v, n| MaybeUninit::new(Surface::SLICK.respond(*v, *n));
    let bounce: Query<Vec2, Axis, Reply> = |v, n| MaybeUninit::new(Surface::ELASTIC.respond(*v, *n));
    let rubber: Query<Vec2, Axis, Reply> = |v, n| MaybeUninit::new(RUBBER.respond(*v, *n));
    let speed: Query<Vec2, Axis, Reply> = |v, n| MaybeUninit::new(SPEED.bounce(*v, *n));
    let ok = |reply: &Reply| reply.is_ok();
    table.row("respond, along y", None, rubber, loads, straight, ok);
    table.row("respond, slide, askew", None, slide, loads, askew, ok);
    table.row("respond, bounce, askew", None, bounce, loads, askew, ok);
    table.row("respond, friction, askew", None, rubber, loads, askew, ok);
    table.row("bounce at a reference speed, askew", None, speed, loads, askew, ok);
    let parts: Query<Vec2, Axis, Result<Split, RangeError>> = |v, n| MaybeUninit::new(split(*v, *n));
    let loads = |_: &Vec2, _: &Axis| -> Query<Vec2, Axis, _> { load::<_, _, _, 2, 2> };
    table.row("split, askew", None, parts, loads, askew, Result::is_ok);
}

fn pairs(table: &mut Table) {
    let half: Query<Contact, Ratio, Pair> = |contact, share| MaybeUninit::new(separate(contact, *share));
    let loads = |_: &Contact, _: &Ratio| -> Query<_, _, _> { load::<_, _, _, 8, 1> };
    let circles = |r: &mut Random| {
        let (a, b): (Circle, Circle) = near_circles(r)?;
        Some((a.contact(&b)?, Ratio::HALF))
    };
    table.row("separate, circle-circle", None, half, loads, circles, |_| true);
    let boxes = |r: &mut Random| {
        let (a, b): (Circle, Circle) = near_circles(r)?;
        Some((a.aabb().contact(&b.aabb())?, Ratio::HALF))
    };
    table.row("separate, AABB-AABB", None, half, loads, boxes, |_| true);

    let meet: Query<Pair, Axis, Result<Pair, RangeError>> =
        |v, n| MaybeUninit::new(exchange(v.0, v.1, *n, Masses::EQUAL, &Surface::ELASTIC));
    let loads = |_: &Pair, _: &Axis| -> Query<_, _, _> { load::<_, _, _, 4, 2> };
    let toward = |(v, n): (Vec2, Axis)| Some(((v, Vec2::ZERO), n.reversed()));
    let ok = |pair: &Result<Pair, RangeError>| pair.is_ok();
    table.row("exchange, along y", None, meet, loads, move |r| straight(r).and_then(toward), ok);
    table.row("exchange, askew", None, meet, loads, move |r| askew(r).and_then(toward), ok);
}

const GRAVITY: Option<Acceleration> = Acceleration::new(Vec2::from_raw(0, 1000), 60);

fn points(table: &mut Table) {
    let act: Query<Vec2, Carry, (Vec2, Carry)> = |v, carry| {
        let Some(gravity) = GRAVITY else { return MaybeUninit::new((*v, *carry)) };
        MaybeUninit::new(gravity.act(*v, *carry))
    };
    let loads = |_: &Vec2, _: &Carry| -> Query<_, _, _> { load::<_, _, _, 2, 2> };
    table.row("acceleration, one frame", None, act, loads, |r| Some((vec(r.point()), Carry::ZERO)), |_| true);

    let Ok(stick) = Stick::new(Fx::from_bits(20 * UNIT)) else { return };
    let pull: Query<Pair, Stick, Pair> = |ends, stick| MaybeUninit::new(stick.pull(ends.0, ends.1));
    let loads = |_: &Pair, _: &Stick| -> Query<_, _, _> { load::<_, _, _, 4, 2> };
    let apart = move |r: &mut Random| Some(((vec(r.point()), vec(r.point())), stick));
    table.row("stick, corrected", None, pull, loads, apart, |by| by.0 != Vec2::ZERO);
    let kept = move |r: &mut Random| {
        let (a, b) = (vec(r.point()), vec(r.point()));
        let (by_a, by_b) = stick.pull(a, b);
        Some(((a + by_a, b + by_b), stick)).filter(|((a, b), stick)| stick.pull(*a, *b).0 == Vec2::ZERO)
    };
    table.row("stick, kept", None, pull, loads, kept, |by| by.0 == Vec2::ZERO);
}
