//! Frames of motion in random worlds. A judge checks each frame: no overlap, no solid on the way to
//! the first contact, and no gain of speed.

use crate::room::{FINE, Room};
use tilesat::{AllShapes, Axis, Mover, Response, Surface, TileMap};
use tilesat_judge::Random;
use tilesat_judge::broad::reference::DOMAIN;
use tilesat_judge::motion as blocks;
use tilesat_judge::rooms::body::{Body, Outcome};
use tilesat_judge::rooms::frames::any_capsule;
use tilesat_judge::rooms::{P, PX, len2, mosaic};
use tilesat_judge::shapes::level::Level;

const FRAMES_A_BODY: u64 = 250;
const BODIES_A_BATCH: u64 = 20;
const RESPONSES: [Response; 4] = [Response::Slide, Response::Bounce, Response::DropThrough, Response::Touch];
pub const UP: Axis = Axis::NEG_Y;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum World {
    /// 5 to 60 percent of the cells hold one of all 34 shapes or a one-way edge.
    Mosaic,
    /// 60 to 95 percent: gaps and dead ends, with bodies smaller than the cells.
    Dense,
    /// Blocks and one-way edges. The judge knows the moment and the side of every first hit, and
    /// the room that a body may not leave.
    Blocks,
}

pub const WORLDS: [(&str, World); 3] = [("mosaic", World::Mosaic), ("dense", World::Dense), ("blocks", World::Blocks)];

#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    pub frames: u64,
    pub hits: u64,
    /// Frames of circles.
    pub round: u64,
    /// Frames after which the body was at rest.
    pub rest: u64,
    /// Frames that used all iterations.
    pub all_iterations: u64,
}

impl Tally {
    pub fn add(&mut self, o: &Self) {
        let sum = self.numbers().iter().zip(o.numbers()).map(|(a, b)| a + b).collect::<Vec<_>>();
        *self = Self::from(&sum).unwrap_or_default();
    }

    pub fn numbers(&self) -> [u64; 5] {
        [self.frames, self.hits, self.round, self.rest, self.all_iterations]
    }

    pub fn from(numbers: &[u64]) -> Option<Self> {
        let &[frames, hits, round, rest, all_iterations] = numbers else { return None };
        Some(Self { frames, hits, round, rest, all_iterations })
    }

    fn count(&mut self, round: bool, hits: usize, iterations: u32, at_rest: bool) {
        self.frames += 1;
        self.hits += hits as u64;
        self.round += u64::from(round);
        self.rest += u64::from(at_rest);
        self.all_iterations += u64::from(iterations == Mover::ITERATIONS);
    }
}

/// Runs one batch of a kind of world. Equal numbers give equal batches. Panics with the input if a
/// frame is wrong.
pub fn batch(row: usize, seed: u64, number: u64) -> Tally {
    let mut r = Random::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (row as u64) << 57 ^ number);
    let mut tally = Tally::default();
    match WORLDS[row].1 {
        World::Blocks => in_blocks(number ^ seed << 32, &mut tally),
        kind => {
            let dense = kind == World::Dense;
            let cell = match r.below(3) {
                0 => 16 * PX,
                1 => 24 * PX,
                _ => 2 * 7 * 64 * r.within(2, 900),
            };
            let percent = if dense { r.within(60, 95) } else { r.within(5, 60) };
            let one_way = if r.one_in(2) { 0 } else { 5 };
            let level = mosaic(&mut r, (16, 12), cell, percent, one_way);
            let largest = if dense { cell } else { 3 * cell };
            for _ in 0..BODIES_A_BATCH {
                body(&mut r, &level, &level.all(), largest, &mut tally);
            }
        }
    }
    tally
}

/// Moves a body of any kind and size for some frames in a level, with a map of any origin.
pub fn body(r: &mut Random, level: &Level, map: &TileMap<AllShapes>, largest: i64, tally: &mut Tally) {
    let room = Room::new(level);
    let Some(mut body) = placed(r, level, &room, largest) else { return };
    // 60 px per frame in cells of 16.
    let fastest = (60 * level.cell / (16 * PX)).max(1);
    let response = RESPONSES[r.below(4) as usize];
    let mover = Mover::platformer(UP).with_response(response);
    let elastic = response == Response::Bounce && r.one_in(2);
    let touching = mover.with_response(Response::Touch);
    let gravity = if r.one_in(2) { PX / 4 } else { 0 };
    let mut v = any_velocity(r, fastest);
    for _ in 0..FRAMES_A_BODY {
        if len2(v) < 1 << 16 || r.one_in(20) || v.0.abs().max(v.1.abs()) > fastest * PX {
            v = any_velocity(r, fastest);
        }
        v.1 = (v.1 + gravity).min(fastest * PX);
        let fail = |what: &str| -> ! {
            let rows: Vec<_> = level.tiles.chunks(level.width as usize).collect();
            panic!("{what}: {body:?} by {v:?} {response:?}, elastic {elastic}, cell {}\n{rows:?}", level.cell)
        };
        let moved = if elastic {
            body.step_on(&mover.with_surface(Surface::ELASTIC), map, v)
        } else {
            body.step(&mover, map, v)
        };
        let Ok(out) = moved else {
            // In large cells, a fast body beyond the map comes to the end of the domain.
            if may_leave_domain(body, v) {
                return;
            }
            fail("refused")
        };
        if room.overlaps(out.body, (0, 0), 0) {
            fail("ends inside");
        }
        if len2(out.v) > len2(v) {
            fail("is faster");
        }
        if out.hits.len() as u32 > out.work.iterations || out.work.iterations > Mover::ITERATIONS {
            fail("too many iterations");
        }
        if out.hits.is_empty() && out.v != v {
            fail("lost velocity without a hit");
        }
        let Ok(touch) = body.step(&touching, map, v) else { fail("refused") };
        if !way_is_free(&room, body, v, &touch) {
            fail("passes through");
        }
        tally.count(matches!(body, Body::Disc(..)), out.hits.len(), out.work.iterations, out.v == (0, 0));
        (body, v) = (out.body, out.v);
    }
}

/// A hit may turn the motion in any direction. It makes it no longer.
fn may_leave_domain(body: Body, v: P) -> bool {
    let (((x0, y0), (x1, y1)), reach) = (body.bounds(), v.0.abs() + v.1.abs());
    x0.min(y0) - reach <= -DOMAIN || x1.max(y1) + reach >= DOMAIN
}

/// The way to the first contact is free at every sixteenth of the motion, and so is its end.
fn way_is_free(room: &Room, body: Body, v: P, touch: &Outcome) -> bool {
    let until = touch.hits.first().map_or(FINE, |h| i64::from(h.toi.raw()) >> 26);
    !room.overlaps(touch.body, (0, 0), 0) && (1..=until).all(|k| !room.overlaps(body, v, k))
}

fn placed(r: &mut Random, level: &Level, room: &Room, largest: i64) -> Option<Body> {
    let size = |r: &mut Random| match r.below(4) {
        0 => (20 * PX).min(largest),
        1 => 2 + r.magnitude(level.cell),
        2 => level.cell,
        _ => 2 + r.below(largest),
    };
    let kind = match r.below(3) {
        0 => Body::Rect((0, 0), (size(r), size(r))),
        1 => Body::Disc((0, 0), size(r) / 2),
        _ => any_capsule(r, level.cell),
    };
    (0..100).find_map(|_| {
        let at = (level.x + r.below(level.width * level.cell), level.y + r.below(level.height * level.cell));
        let there = kind.at(if r.one_in(2) { at } else { (at.0 & !0xffff, at.1 & !0xffff) });
        (!room.overlaps(there, (0, 0), 0)).then_some(there)
    })
}

fn any_velocity(r: &mut Random, fastest: i64) -> P {
    let raw = fastest * PX;
    match r.below(6) {
        0 => (r.around(fastest) * PX, r.around(fastest) * PX),
        1 => (r.around(raw), 0),
        2 => (0, r.around(raw)),
        3 => {
            let v = r.around(raw);
            (v, v * r.sign())
        }
        4 => (r.sign() * r.magnitude(raw), r.sign() * r.magnitude(raw)),
        _ => (r.around(raw), r.around(raw)),
    }
}

fn in_blocks(seed: u64, tally: &mut Tally) {
    let mut r = tilesat_judge::Random::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let (solid, one_way) = (r.within(5, 60), r.within(0, 15));
    let cell = if r.one_in(2) { 16 << 16 } else { 24 << 16 };
    let level = blocks::scene::blocks(&mut r, (20, 14), cell, solid, one_way);
    let rooms = level.rooms();
    for _ in 0..BODIES_A_BATCH {
        let largest = if r.one_in(4) { 60 } else { 16 };
        let kind = blocks::scene::any_body(&mut r, largest);
        let Some(mut body) = blocks::scene::placed(&mut r, &level, kind) else { continue };
        let response = blocks::body::RESPONSES[r.below(4) as usize];
        let gravity = if r.one_in(2) { 1 << 14 } else { 0 };
        let room = level.room_of(&rooms, &body);
        let mut v = blocks::scene::any_velocity(&mut r, 60);
        for _ in 0..FRAMES_A_BODY {
            if blocks::len2(v) < 1 << 16 || r.one_in(20) || v.0.abs().max(v.1.abs()) > 60 << 16 {
                v = blocks::scene::any_velocity(&mut r, 60);
            }
            v.1 = (v.1 + gravity).min(60 << 16);
            let out = blocks::judge::check(&level, Mover::platformer(UP), response, &body, v);
            assert_eq!(level.room_of(&rooms, &out.body), room, "left its room: {body:?} by {v:?}");
            let round = matches!(body, blocks::body::Body::Disc { .. });
            tally.count(round, out.hits.len(), out.work.iterations, out.v == (0, 0));
            (body, v) = (out.body, out.v);
        }
    }
}
