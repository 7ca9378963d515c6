//! Bodies with a constant input in small levels. If one stays for good, no way of free positions
//! leads on (L6).

#![allow(clippy::cast_precision_loss, reason = "directions and lengths below 2^30")]

use std::collections::HashSet;
use tilesat::{Axis, Mover};
use tilesat_judge::Random;
use tilesat_judge::rooms::body::{Body, Outcome};
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::{P, mosaic};

const PLAYER: Mover = Mover::platformer(Axis::NEG_Y);
/// Small, so that a search raw unit by raw unit goes far.
const CELL: i64 = 256;

/// Whether free steps lead as far as `far` along the input: each of one raw unit along x, y or
/// both, a part of the input, and free all the way. A step from a free place to another may lead
/// through the corner of a tile that is one raw unit high.
fn leads_on(room: &Room, body: Body, v: P, far: i64) -> bool {
    let all = (-1..=1).flat_map(|x| (-1..=1).map(move |y| (x, y)));
    let steps: Vec<P> = all.filter(|&d| d.0 * v.0 + d.1 * v.1 > 0).collect();
    leads(room, body, &steps, v, far)
}

/// Whether these steps, free all the way, lead as far as `far` along `v`.
pub(super) fn leads(room: &Room, body: Body, steps: &[P], v: P, far: i64) -> bool {
    let along = |d: P| d.0 * v.0 + d.1 * v.1;
    let length = ((v.0 * v.0 + v.1 * v.1) as f64).sqrt();
    let (mut seen, mut open) = (HashSet::from([(0, 0)]), vec![(0, 0)]);
    while let Some(p) = open.pop() {
        if along(p) as f64 >= far as f64 * length {
            return true;
        }
        for d in steps {
            let q = (p.0 + d.0, p.1 + d.1);
            if !seen.contains(&q) && room.is_free(body.moved(p), *d, 8) && seen.insert(q) {
                open.push(q);
            }
        }
    }
    false
}

/// A body that is larger by so much on each side.
fn grown(body: Body, by: i64) -> Body {
    match body {
        Body::Rect(p, size) => Body::Rect((p.0 - by, p.1 - by), (size.0 + 2 * by, size.1 + 2 * by)),
        Body::Disc(c, r) => Body::Disc(c, r + by),
        Body::Pill(p, core, r) => Body::Pill(p, core, r + by),
    }
}

/// Whether the way leaves room: from a place just before the end of the body it is free for one
/// that is larger by two raw units on each side.
///
/// A mover counts both surfaces as touched that are within its rounding distance of 4 raw. Between
/// them it finds no way unless both are straight, and those are met where they are.
pub(super) fn leaves_room(room: &Room, end: Body, v: P, leads_on: impl Fn(Body) -> bool) -> bool {
    let larger = grown(end, 2);
    let places = (-3..=3).flat_map(|x| (-3..=3).map(move |y| (x, y))).filter(|p| p.0 * v.0 + p.1 * v.1 <= 0);
    places.map(|p| larger.moved(p)).any(|body| !room.overlaps(body, (0, 0), 0) && leads_on(body))
}

/// Whether the input is so square to all that it meets that it is no way along it.
///
/// A way is faster than the rounding distance: its longer component has at least 5 raw. A tangent
/// has at least `1 / sqrt 2` of its length in that, and is 2 raw shorter for its roundings:
/// `2 + 5 sqrt 2 < 10`.
fn is_square(out: &Outcome, v: P) -> bool {
    out.hits.iter().all(|hit| {
        let n = (f64::from(hit.axis.x), f64::from(hit.axis.y));
        (v.0 as f64 * n.1 - v.1 as f64 * n.0).abs() < 10.0 * n.0.hypot(n.1)
    })
}

/// The place where a body stays that is driven for many frames, if it does.
fn stays(map: &tilesat::TileMap<'_, tilesat::AllShapes>, mut body: Body, v: P) -> Option<Body> {
    let mut still = 0;
    for _ in 0..120 {
        let out = body.step(&PLAYER, map, v).ok()?;
        still = if out.body == body { still + 1 } else { 0 };
        if still == 3 {
            return Some(body);
        }
        body = out.body;
    }
    None
}

fn play(levels: u64) {
    let mut r = Random::new(5);
    let (mut runs, mut stayed, mut stuck) = (0, 0, Vec::new());
    for _ in 0..levels {
        let dense = [15, 30, 50][r.below(3) as usize];
        let level = mosaic(&mut r, (4, 4), CELL, dense, 0);
        let (map, room) = (level.all(), Room::new(&level));
        for _ in 0..8 {
            let half = [16, 31, 32, 63, 64, 100, 127, 128][r.below(8) as usize];
            let at = (r.within(half, 4 * CELL - half), r.within(half, 4 * CELL - half));
            let body = match r.below(3) {
                0 => Body::Disc(at, half),
                1 => Body::Rect((at.0 - half, at.1 - half), (2 * half, 2 * half)),
                _ => Body::Pill(at, [(half, 0), (0, -half), (CELL - 2 * half, 0)][r.below(3) as usize], half),
            };
            if room.overlaps(body, (0, 0), 0) {
                continue;
            }
            let speed = [200, 90, 40][r.below(3) as usize];
            let v = [(speed, 0), (speed, speed / 3), (speed, speed), (-speed, speed / 2), (0, speed), (-speed, -speed)]
                [r.below(6) as usize];
            runs += 1;
            let Some(end) = stays(&map, body, v) else { continue };
            stayed += 1;
            let straight = |out: &Outcome| out.hits.iter().all(|h| h.index < 4);
            let out = end.step(&PLAYER, &map, v).unwrap();
            let goes_on = |body| leads_on(&room, body, v, 16);
            if goes_on(end) && !is_square(&out, v) && (straight(&out) || leaves_room(&room, end, v, goes_on)) {
                stuck.push((level.tiles.clone(), body, end, v));
            }
        }
    }
    assert!(stayed > runs / 4, "{stayed} of {runs}");
    assert!(stuck.is_empty(), "{} of {stayed} bodies that stay, such as {:?}", stuck.len(), stuck[0]);
}

#[test]
fn what_stays_has_no_way_on() {
    play(tilesat_judge::cases(tilesat_judge::thorough(1_500, 100_000)));
}
