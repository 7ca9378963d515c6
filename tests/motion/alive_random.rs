//! Random levels of all shapes: a call that ends without velocity ends only if there is no way on
//! (L1).

#![allow(clippy::cast_precision_loss, reason = "directions and lengths below 2^30")]

use tilesat::{Axis, Cell, Mover};
use tilesat_judge::Random;
use tilesat_judge::rooms::body::{Body, Outcome};
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::{P, PX, len2, mosaic};
use tilesat_judge::shapes::level::Level;

const PLAYER: Mover = Mover::platformer(Axis::NEG_Y);

/// Whether slightly more than a unit is free in a direction, by sets of points, with a raw unit and
/// a half to spare across it.
///
/// The tangent of a corner or an arc is rounded to the lattice and may graze its own surface. So a
/// way must be free from two positions, the body's own and those two raw units beside it. A passage
/// exactly as wide as the body counts only for slides along flat floors: if all hits are straight,
/// a straight way needs no margin.
fn is_free(room: &Room, body: Body, d: P, all_straight: bool) -> bool {
    let length = (len2(d) as f64).sqrt();
    let times = (PX as f64 * 1.01 / length).ceil() as i64;
    // Tangents of the slopes of tiles are small, and exact.
    let unit = |c: i64| if times > PX / 4 { c * times } else { (c as f64 / length * PX as f64 * 1.01) as i64 };
    let way = (unit(d.0), unit(d.1));
    if all_straight && is_straight(d) {
        return room.is_free(body, way, 64);
    }
    let free = BESIDE.iter().filter(|&&by| room.is_free(body.moved(by), way, 64));
    let across: Vec<_> = free.map(|by| (by.0 * d.1 - by.1 * d.0) as f64 / length).collect();
    across.iter().any(|a| across.iter().any(|b| a - b >= 1.5))
}

const BESIDE: [P; 9] = [(0, 0), (2, 0), (2, 2), (0, 2), (-2, 2), (-2, 0), (-2, -2), (0, -2), (2, -2)];

fn is_straight(d: P) -> bool {
    d.0 == 0 || d.1 == 0
}

/// The velocity with which the body reached its last position: the remains of each earlier hit
/// along its surface.
fn before_last(v: P, out: &Outcome) -> (f64, f64) {
    let hits: Vec<_> = out.hits.iter().map(|h| (h.toi.raw(), f64::from(h.axis.x), f64::from(h.axis.y))).collect();
    // Hits within eight raw units of way have one position, except on a straight face: those are
    // not rounded.
    let (last, eight) = (hits.last().unwrap().0, (8.0 * f64::from(1 << 30) / (len2(v) as f64).sqrt()) as u32);
    let within = |h: &(u32, f64, f64)| if h.1 == 0.0 || h.2 == 0.0 { 0 } else { eight };
    hits.iter().filter(|h| h.0 + within(h) < last).fold((v.0 as f64, v.1 as f64), |v, n| {
        let into = (v.0 * n.1 + v.1 * n.2).min(0.0) / (n.1 * n.1 + n.2 * n.2);
        (v.0 - into * n.1, v.1 - into * n.2)
    })
}

/// A direction that is free for a unit and along which the velocity has more than a unit. For a
/// call that ended without velocity and has hardly moved.
///
/// Both the velocity before the last hit and the velocity of the call must have it. The call's
/// velocity presses a resting body against its surface all the time. A flying body has only what
/// that surface left.
///
/// A quarter pipe on the way turns the velocity. No hit shows the rest.
fn way_on(room: &Room, level: &Level, before: Body, v: P, out: &Outcome) -> Option<P> {
    let last = out.hits.len().saturating_sub(1);
    if out.hits.iter().take(last).any(|hit| hit.index == 8 && is_pipe(level, hit.cell)) {
        return None;
    }
    let made = (out.body.position().0 - before.position().0, out.body.position().1 - before.position().1);
    if out.v != (0, 0) || 100 * len2(made) >= len2(v) || len2(v) <= 4 * len2((PX, 0)) {
        return None;
    }
    let u = before_last(v, out);
    let along = out.hits.iter().map(|h| (i64::from(h.axis.x), i64::from(h.axis.y)));
    let (x, y) = (u.0 as i64, u.1 as i64);
    let ways = along.flat_map(|n| [(-n.1, n.0), (n.1, -n.0)]).chain([(x, y), (x, 0), (0, y)]);
    let along = |u: (f64, f64), d: P| u.0 * d.0 as f64 + u.1 * d.1 as f64 > PX as f64 * (len2(d) as f64).sqrt();
    let has = |d: P| along(u, d) && along((v.0 as f64, v.1 as f64), d);
    let all_straight = out.hits.iter().all(|h| h.axis.x == 0 || h.axis.y == 0);
    ways.filter(|&d| d != (0, 0) && has(d)).find(|&d| is_free(room, out.body, d, all_straight))
}

fn is_pipe(level: &Level, cell: Cell) -> bool {
    let (x, y) = (i64::from(cell.x), i64::from(cell.y));
    let inside = (0..level.width).contains(&x) && (0..level.height).contains(&y);
    inside && (14..=17).contains(&level.tiles[(y * level.width + x) as usize])
}

fn play(levels: u64, seed: u64) {
    let mut r = Random::new(seed);
    let (mut frames, mut stops, mut dead) = (0, 0, Vec::new());
    for _ in 0..levels {
        let cell = [24 * PX, 16 * PX, 8 * PX, 2 * 54_321, 12 * PX][r.below(5) as usize];
        let dense = [20, 40, 60][r.below(3) as usize];
        let mut level = mosaic(&mut r, (9, 9), cell, dense, 0);
        if r.one_in(4) {
            // A corridor of one cell under blocks, half domes and slopes.
            for x in 0..9 {
                level.tiles[36 + x] = 0;
                if r.one_in(2) {
                    level.tiles[27 + x] = [1, 4, 8, 9, 16, 17][r.below(6) as usize];
                }
            }
        }
        let (map, room) = (level.all(), Room::new(&level));
        for _ in 0..6 {
            let sizes = [cell / 2, cell / 2 - 1, cell / 4, cell / 4 - 1, cell / 8, cell * 3 / 16, cell / 3];
            let (hx, hy) = (sizes[r.below(7) as usize], sizes[r.below(7) as usize]);
            let at = (r.within(0, 18) * cell / 2, r.within(0, 18) * cell / 2);
            let aside = [(0, 0), (hx, 0), (0, hy), (hx, hy), (-hx, -hy)][r.below(5) as usize];
            let at = (at.0 + aside.0, at.1 + aside.1);
            let k = [2 * cell, cell, cell / 2, cell / 8, 6 * cell][r.below(5) as usize];
            let mut v = [(r.around(k), 0), (0, r.around(k)), (k, -k), (r.around(k), r.around(k))][r.below(4) as usize];
            let gravity = [0, cell / 40, cell / 20][r.below(3) as usize];
            let push = (r.around(cell / 4), r.around(cell / 4));
            let mut body = match r.below(3) {
                0 => Body::Disc(at, hx),
                1 => Body::Rect((at.0 - hx, at.1 - hy), (2 * hx, 2 * hy)),
                _ => Body::Pill(at, if r.one_in(2) { (hy, 0) } else { (0, -hy) }, hx),
            };
            if room.overlaps(body, (0, 0), 0) {
                continue;
            }
            for _ in 0..12 {
                v.1 += gravity;
                if r.one_in(2) {
                    v = (v.0 + push.0, v.1 + push.1);
                }
                let out = body.step(&PLAYER, &map, v).unwrap();
                frames += 1;
                stops += u32::from(out.v == (0, 0));
                if let Some(way) = way_on(&room, &level, body, v, &out) {
                    dead.push((
                        cell,
                        level.tiles.clone(),
                        body,
                        v,
                        out.body,
                        way,
                        out.hits
                            .iter()
                            .map(|h| (h.toi.raw(), h.axis.x, h.axis.y, h.cell.x, h.cell.y, h.index))
                            .collect::<Vec<_>>(),
                    ));
                }
                (body, v) = (out.body, out.v);
            }
        }
    }
    assert!(stops > 0);
    assert!(
        dead.is_empty(),
        "{} dead stops of {stops} in {frames} frames, such as {:?}",
        dead.len(),
        &dead[..3.min(dead.len())]
    );
}

#[test]
fn no_dead_stops() {
    play(tilesat_judge::cases(3_000), 1);
}

#[test]
#[ignore = "half a minute"]
fn no_dead_stops_in_ten_million_frames() {
    play(330_000, 2);
}
