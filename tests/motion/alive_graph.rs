//! Bodies with a constant input in small levels. If one stays for good, no way of free positions
//! leads on (L6).

#![allow(clippy::cast_precision_loss, reason = "directions and lengths below 2^30")]

use std::collections::HashSet;
use tilesat::{Axis, Mover};
use tilesat_judge::Random;
use tilesat_judge::rooms::body::Body;
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::{P, mosaic};

const PLAYER: Mover = Mover::platformer(Axis::NEG_Y);
/// Small, so that a search raw unit by raw unit goes far.
const CELL: i64 = 256;

/// Whether free positions lead as far as `far` along the input, in steps of one raw unit that are
/// parts of it.
fn leads_on(room: &Room, body: Body, v: P, far: i64) -> bool {
    let along = |d: P| d.0 * v.0 + d.1 * v.1;
    let steps = (-1..=1).flat_map(|x| (-1..=1).map(move |y| (x, y))).filter(|&d| along(d) > 0);
    let steps: Vec<P> = steps.collect();
    let length = ((v.0 * v.0 + v.1 * v.1) as f64).sqrt();
    let (mut seen, mut open) = (HashSet::from([(0, 0)]), vec![(0, 0)]);
    while let Some(p) = open.pop() {
        if along(p) as f64 >= far as f64 * length {
            return true;
        }
        for d in &steps {
            let q = (p.0 + d.0, p.1 + d.1);
            if seen.insert(q) && !room.overlaps(body, q, 512) {
                open.push(q);
            }
        }
    }
    false
}

/// The position at which a body stays that is driven for many frames, if it stays.
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

#[test]
fn what_stays_has_no_way_on() {
    let mut r = Random::new(5);
    let (mut runs, mut stayed, mut stuck) = (0, 0, Vec::new());
    for _ in 0..tilesat_judge::cases(1_500) {
        let dense = [15, 30, 50][r.below(3) as usize];
        let level = mosaic(&mut r, (4, 4), CELL, dense, 0);
        let (map, room) = (level.all(), Room::new(&level));
        for _ in 0..8 {
            let half = [16, 31, 32, 63, 64, 100, 127, 128][r.below(8) as usize];
            let at = (r.within(half, 4 * CELL - half), r.within(half, 4 * CELL - half));
            let body = if r.one_in(2) {
                Body::Disc(at, half)
            } else {
                Body::Rect((at.0 - half, at.1 - half), (2 * half, 2 * half))
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
            if leads_on(&room, end, v, 16) {
                stuck.push((level.tiles.clone(), body, end, v));
            }
        }
    }
    assert!(stayed > runs / 4, "{stayed} of {runs}");
    // Two are known: boxes two raw units narrower than the gap between two tips of slopes. Only
    // steps of one raw unit aside lead through.
    assert!(stuck.len() <= 2, "{} of {stayed} bodies that stay, such as {:?}", stuck.len(), stuck[0]);
}
