//! If a call moves without a sweep, its whole way is free. Convex sets that share nothing with the
//! library judge it.
//!
//! Every frame that did no work except a look is checked against the whole level. `TILESAT_FRAMES`
//! sets the number of frames (default 100 000).

use std::time::{Duration, Instant};
use tilesat::{Axis, Mover, TileShape, motion::Work};
use tilesat_judge::Random;
use tilesat_judge::rooms::body::Body;
use tilesat_judge::rooms::frames::{any_body, any_capsule, any_velocity};
use tilesat_judge::rooms::hull::meets;
use tilesat_judge::rooms::{P, drawn, mosaic};
use tilesat_judge::shapes::level::Level;
use tilesat_judge::shapes::region::Region;

/// A level's solid, and where a body may meet it.
struct Judge {
    solids: Vec<(Region, P, P)>,
}

impl Judge {
    fn new(level: &Level) -> Self {
        let corners = |r: &Region| match r {
            Region::Polygon(points) => points.clone(),
            Region::Arc { centre, far, .. } => vec![*centre, *far],
        };
        let bounded = |r: Region| {
            let points = corners(&r);
            let side = |f: fn(&(i128, i128)) -> i128| {
                let all = || points.iter().map(f);
                (all().min().unwrap() as i64, all().max().unwrap() as i64)
            };
            let ((x0, x1), (y0, y1)) = (side(|p| p.0), side(|p| p.1));
            (r, (x0, y0), (x1, y1))
        };
        Self { solids: level.pieces(1).into_iter().filter_map(|p| p.solid).map(bounded).collect() }
    }

    fn is_free(&self, body: Body, d: P) -> bool {
        let (lo, hi) = body.bounds();
        let (from, to) =
            ((lo.0 + d.0.min(0) - 2, lo.1 + d.1.min(0) - 2), (hi.0 + d.0.max(0) + 2, hi.1 + d.1.max(0) + 2));
        let near = |a: P, b: P| a.0 < to.0 && b.0 > from.0 && a.1 < to.1 && b.1 > from.1;
        !self.solids.iter().any(|(solid, a, b)| near(*a, *b) && meets(solid, body, d))
    }
}

/// The number of frames that did no work, and of free frames.
#[derive(Default, Debug)]
struct Tally {
    frames: u64,
    clear: u64,
    free: u64,
}

fn frame(level: &Level, judge: &Judge, body: Body, d: P, tally: &mut Tally) {
    let Ok(out) = body.step(&Mover::platformer(Axis::NEG_Y), &level.all(), d) else { return };
    tally.frames += 1;
    tally.free += u64::from(out.hits.is_empty());
    if out.work == (Work { iterations: 1, features: 0, checks: 0 }) {
        tally.clear += 1;
        assert!(judge.is_free(body, d), "taken for free: {body:?} by {d:?} in {level:?}");
    }
}

/// Random levels of all shapes. `clock` reports the progress.
fn worlds(seed: u64, frames: u64, fastest: i64, clock: bool) -> Tally {
    let (mut r, mut tally, mut told) = (Random::new(seed), Tally::default(), Instant::now());
    while tally.frames < frames {
        let cell = if r.one_in(2) { 16 << 16 } else { 2 * 7 * 64 * r.within(2, 900) };
        let (dense, one_way) = (r.within(10, 60), if r.one_in(2) { 0 } else { 8 });
        let level = mosaic(&mut r, (10, 8), cell, dense, one_way);
        let judge = Judge::new(&level);
        for _ in 0..400 {
            let at = (r.below(10 * cell), r.below(8 * cell));
            let at = if r.one_in(3) { (at.0 & !0xff, at.1 & !0xff) } else { at };
            let scale = |v: i64| v * cell / (16 << 16);
            let v = any_velocity(&mut r, fastest);
            frame(&level, &judge, any_body(&mut r, cell).at(at), (scale(v.0), scale(v.1)), &mut tally);
        }
        if clock && told.elapsed() > Duration::from_secs(10) {
            told = Instant::now();
            println!("{tally:?}");
        }
    }
    println!("{tally:?}");
    tally
}

#[test]
fn what_is_not_swept_is_free() {
    for (seed, fastest) in [(1, 4), (2, 30), (3, 200)] {
        let tally = worlds(seed, tilesat_judge::frames(100_000) / 3, fastest, false);
        assert!(tally.clear > tally.free / 2, "{tally:?}");
    }
}

/// Around each shape, on a lattice and just off it: bodies touch, pass by a raw unit, or are within
/// one.
#[test]
fn around_each_shape() {
    const CELL: i64 = 256;
    let mut tally = Tally::default();
    let mut r = Random::new(5);
    for id in 1..34 {
        let level = drawn(&["....", ".a..", "...."], CELL, &[('a', id)]);
        assert!(usize::from(id) < TileShape::ALL.len());
        let judge = Judge::new(&level);
        for _ in 0..tilesat_judge::frames(100_000) / 20 {
            let near = |r: &mut Random| 32 * r.below(32) + if r.one_in(2) { 0 } else { r.within(-2, 2) };
            let size = |r: &mut Random| if r.one_in(8) { 0 } else { 32 * r.below(8) + r.within(1, 3) };
            let at = (near(&mut r), near(&mut r));
            let body = match r.below(3) {
                0 => Body::Disc(at, size(&mut r)),
                1 => Body::Rect(at, (size(&mut r), size(&mut r))),
                _ => {
                    let long = size(&mut r);
                    Body::Pill(at, if r.one_in(2) { (long, 0) } else { (0, -long) }, size(&mut r).max(1))
                }
            };
            let d = (16 * r.within(-12, 12) + r.within(-1, 1), 16 * r.within(-12, 12) + r.within(-1, 1));
            frame(&level, &judge, body, d, &mut tally);
        }
    }
    println!("{tally:?}");
    assert!(tally.clear > tally.free / 2 && tally.free < tally.frames * 9 / 10, "{tally:?}");
}

/// Halves the gap between a free way and a blocked one down to a raw unit. So it finds bounds that
/// are too large by any part of a body.
#[test]
fn within_a_raw_unit_of_each_shape() {
    let (mut r, mut tally) = (Random::new(6), Tally::default());
    for id in 2..34 {
        for cell in [16 << 16, 24 << 16, 256, 100_002] {
            let level = drawn(&[".....", ".....", "..a..", ".....", "....."], cell, &[('a', id)]);
            let judge = Judge::new(&level);
            for _ in 0..tilesat_judge::frames(100_000) / 2000 {
                let size = |r: &mut Random| if r.one_in(8) { r.below(4) } else { r.within(1, cell) };
                let body = match r.below(4) {
                    0 => Body::Rect((0, 0), (size(&mut r), size(&mut r))),
                    1 => any_capsule(&mut r, cell),
                    _ => Body::Disc((0, 0), size(&mut r)),
                };
                let short = |r: &mut Random| if r.one_in(2) { r.within(-1, 1) } else { r.around(cell / 2) };
                let d = (short(&mut r), short(&mut r));
                let place = |r: &mut Random| (r.within(cell, 4 * cell), r.within(cell, 4 * cell));
                let (mut free, mut met) = (place(&mut r), place(&mut r));
                if !judge.is_free(body.at(free), d) || judge.is_free(body.at(met), d) {
                    continue;
                }
                while (free.0 - met.0).abs().max((free.1 - met.1).abs()) > 1 {
                    let middle = (i64::midpoint(free.0, met.0), i64::midpoint(free.1, met.1));
                    if judge.is_free(body.at(middle), d) { free = middle } else { met = middle }
                }
                for (x, y) in [(0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)] {
                    frame(&level, &judge, body.at((met.0 + x, met.1 + y)), d, &mut tally);
                }
            }
        }
    }
    println!("{tally:?}");
    assert!(tally.clear > 100, "{tally:?}");
}

/// As many frames as `TILESAT_FRAMES` says, by default 10^7: `cargo test --test motion clear --
/// --ignored --nocapture`.
#[test]
#[ignore = "minutes"]
fn in_ten_million_frames() {
    for (seed, fastest) in [(11, 4), (12, 30), (13, 100), (14, 1000)] {
        worlds(seed, tilesat_judge::frames(10_000_000) / 4, fastest, true);
    }
}
