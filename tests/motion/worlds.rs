//! Random block worlds. Exact integer geometry that shares nothing with the library judges every
//! frame of every body.
//!
//! In each frame: no overlap, no gain of speed, the first hit at the exact moment and on the exact
//! side (circles at corners: never late). Free motions arrive, and no body ever leaves its room.
//! `TILESAT_FRAMES` sets the number of frames (default 300 000, or a million in long runs).

use tilesat::{Axis, Mover, Outside, Response};
use tilesat_judge::Random;
use tilesat_judge::motion::body::{Body, RESPONSES};
use tilesat_judge::motion::judge::check;
use tilesat_judge::motion::scene::{any_body, any_velocity, blocks, placed};
use tilesat_judge::motion::{P, len2};

const FRAMES_A_BODY: u64 = 200;

fn frames() -> u64 {
    tilesat_judge::frames(tilesat_judge::thorough(300_000, 1_000_000))
}

#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    frames: u64,
    hits: u64,
    corners: u64,
    one_ways: u64,
    free: u64,
    full_iterations: u64,
    at_rest: u64,
}

impl Tally {
    fn add(&mut self, o: &Self) {
        self.frames += o.frames;
        self.hits += o.hits;
        self.corners += o.corners;
        self.one_ways += o.one_ways;
        self.free += o.free;
        self.full_iterations += o.full_iterations;
        self.at_rest += o.at_rest;
    }
}

/// One body in one level.
fn run(r: &mut Random, size: P, fastest: i64, tally: &mut Tally) {
    let cell = if r.one_in(2) { 16 << 16 } else { 24 << 16 };
    let (solid, one_way) = (r.within(5, 60), r.within(0, 15));
    let level = blocks(r, size, cell, solid, one_way);
    let rooms = level.rooms();
    let largest = if r.one_in(4) { 60 } else { 16 };
    let kind = any_body(r, largest);
    let Some(mut body) = placed(r, &level, kind) else { return };
    let response = RESPONSES[r.below(4) as usize];
    let mover = Mover::platformer(Axis::NEG_Y);
    let gravity = if r.one_in(2) { 1 << 14 } else { 0 };
    let room = level.room_of(&rooms, &body);
    let mut v = any_velocity(r, fastest);
    for _ in 0..FRAMES_A_BODY {
        // A bounce off a corner keeps the length and may turn a component beyond the limit of one
        // call.
        if len2(v) < 1 << 16 || r.one_in(20) || v.0.abs().max(v.1.abs()) > fastest << 16 {
            v = any_velocity(r, fastest);
        }
        v.1 = (v.1 + gravity).min(fastest << 16);
        let out = check(&level, mover, response, &body, v);
        assert_eq!(level.room_of(&rooms, &out.body), room, "left its room: {body:?} by {v:?}");
        tally.frames += 1;
        tally.hits += out.hits.len() as u64;
        tally.corners += out.hits.iter().filter(|h| h.index >= 4).count() as u64;
        tally.one_ways += out.hits.iter().filter(|h| h.one_way).count() as u64;
        tally.free += u64::from(out.hits.is_empty());
        tally.full_iterations += u64::from(out.work.iterations == Mover::ITERATIONS);
        tally.at_rest += u64::from(out.v == (0, 0));
        if matches!(body, Body::Rect { .. }) {
            assert!(out.hits.iter().all(|h| h.index < 4), "a box hit a corner");
        }
        (body, v) = (out.body, out.v);
    }
}

fn worlds(seed: u64, frames: u64, size: P, fastest: i64) -> Tally {
    let threads: Vec<_> = (0..2)
        .map(|k| {
            std::thread::spawn(move || {
                let mut r = Random::new(seed + k);
                let mut tally = Tally::default();
                while tally.frames < frames / 2 {
                    run(&mut r, size, fastest, &mut tally);
                }
                tally
            })
        })
        .collect();
    let mut all = Tally::default();
    for thread in threads {
        all.add(&thread.join().unwrap());
    }
    println!("{all:?}");
    all
}

#[test]
fn random_worlds() {
    let tally = worlds(1, frames(), (20, 14), 60);
    assert!(tally.hits > tally.frames / 4 && tally.free > tally.frames / 20);
    assert!(tally.corners > tally.frames / 100 && tally.one_ways > tally.frames / 100);
}

#[test]
fn walking_speed() {
    let tally = worlds(100, frames() / 4, (20, 14), 4);
    assert!(tally.hits > tally.frames / 8);
}

/// A motion of thousands of units crosses the whole map.
#[test]
fn at_four_thousand_units_a_frame() {
    let tally = worlds(200, frames() / 200, (24, 16), 4000);
    assert!(tally.hits > tally.frames / 4);
}

/// The other policies for the outside, with bodies that go there and come back.
#[test]
fn outside_of_the_map() {
    let mut r = Random::new(7);
    for outside in [Outside::Empty, Outside::Edge] {
        for _ in 0..frames() / 8000 {
            let cell = if r.one_in(2) { 16 << 16 } else { 24 << 16 };
            let (solid, one_way) = (r.within(5, 60), r.within(0, 15));
            let level = blocks(&mut r, (8, 6), cell, solid, one_way).with_outside(outside);
            let kind = any_body(&mut r, 30);
            let Some(mut body) = placed(&mut r, &level, kind) else { continue };
            let response = RESPONSES[r.below(4) as usize];
            for _ in 0..200 {
                let at = body.middle();
                // Mostly back toward the map.
                let home = ((4 << 20) - at.0, (3 << 20) - at.1);
                let v = any_velocity(&mut r, 40);
                let v = if r.one_in(3) { v } else { (v.0 + home.0 / 4, v.1 + home.1 / 4) };
                body = check(&level, Mover::platformer(Axis::NEG_Y), response, &body, v).body;
            }
        }
    }
}

/// Small cells and large bodies, down to cells and bodies of a few raw units.
#[test]
fn other_scales() {
    let mut r = Random::new(8);
    for _ in 0..frames() / 4000 {
        let cell = 256 + 2 * r.magnitude(4096);
        let (solid, one_way) = (r.within(5, 50), r.within(0, 10));
        let level = blocks(&mut r, (16, 12), cell, solid, one_way);
        let size = |r: &mut Random| 2 + r.magnitude(3 * cell);
        let kind = if r.one_in(2) {
            Body::rect((0, 0), (size(&mut r), size(&mut r)))
        } else {
            Body::disc((0, 0), size(&mut r) / 2)
        };
        let rooms = level.rooms();
        let Some(mut body) = (0..100).find_map(|_| {
            let there = kind.moved((r.below(16 * cell), r.below(12 * cell)));
            (!level.overlaps(&there)).then_some(there)
        }) else {
            continue;
        };
        let room = level.room_of(&rooms, &body);
        let response = RESPONSES[r.below(4) as usize];
        for _ in 0..200 {
            let speed = |r: &mut Random| r.sign() * r.magnitude(4 * cell);
            let v = (speed(&mut r), speed(&mut r));
            body = check(&level, Mover::platformer(Axis::NEG_Y), response, &body, v).body;
            assert_eq!(level.room_of(&rooms, &body), room, "left its room");
        }
    }
}

/// Work is limited by the cells under the motion: each piece of at most a cell visits the cells
/// that the body and the piece cover.
#[test]
fn work_is_bounded() {
    let mut r = Random::new(9);
    let mut largest = 0;
    for _ in 0..frames() / 50 {
        let level = blocks(&mut r, (20, 14), 16 << 16, 30, 10);
        let kind = any_body(&mut r, 40);
        let Some(body) = placed(&mut r, &level, kind) else { continue };
        let fastest = if r.one_in(4) { 4000 } else { 60 };
        let v = any_velocity(&mut r, fastest);
        let out = body.step(&Mover::new().with_response(Response::Bounce), &level.map(), v).unwrap();
        let (lo, hi) = body.bounds();
        let across = |size: i64| (size + (1 << 20) + 2) / (16 << 16) + 2;
        let pieces = v.0.abs().max(v.1.abs()) / (16 << 16) + 1;
        // Two faces and three corners of a cell's eight features can face a motion. Bouncing
        // changes the direction but not the length, so the longer component grows by at most
        // sqrt(2).
        let bound =
            across(hi.0 - lo.0) * across(hi.1 - lo.1) * 5 * (pieces * 3 / 2 + 1) * i64::from(out.work.iterations);
        largest = largest.max(i64::from(out.work.features) * 100 / bound.max(1));
        assert!(
            i64::from(out.work.features) <= bound,
            "{} features, bound {bound}: {body:?} by {v:?}",
            out.work.features
        );
        assert!(out.work.checks <= 1 + 7 * out.work.iterations, "{} checks", out.work.checks);
    }
    assert!(largest > 2, "the bound is too loose to say anything: {largest} %");
}
