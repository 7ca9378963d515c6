//! What threads add: 10 000 bodies in one level, which all threads share.
//!
//! Each thread moves a part of the bodies, in a loop of plain calls. Times are CPU times: with as
//! many free cores as threads, the work takes the largest time of a thread.

use crate::rays::level::{CELL, Level, Map, SIDE};
use crate::run::{cpu_time, steady};
use std::fmt::Write;
use std::hint::black_box;
use tilesat::{Axis, Circle, Fx, Grid, Inside, Mover, TileKind, TileKinds, TileMap, Vec2};
use tilesat_judge::Random;
use tilesat_judge::oracle::generate::UNIT;

const BODIES: usize = 10_000;
const PASSES: usize = 15;

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

type Body = (Circle, Vec2);
type Call = fn(&TileMap<'_>, &Body);

/// A table of nanoseconds of CPU time per call: the mean of all threads, and the thread that took
/// longest, as if it had taken all bodies of the pass.
pub fn table() -> String {
    let cells = Level::new(Map::Platformer).cells;
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL as i32), Vec2::ZERO).expect("a legal grid");
    let map = TileMap::on_grid(&cells, grid, &KINDS).expect("a legal map");
    let mut out = String::from(
        "| 10 000 in one level, ns per call | threads | mean | of the slowest thread |\n|---|--:|--:|--:|\n",
    );
    let moves: Call = |map, (body, by)| {
        let _ = black_box(Mover::platformer(Axis::NEG_Y).move_and_slide(map, body, *by));
    };
    let casts: Call = |map, (body, by)| {
        let _ = black_box(map.cast_shape(body, *by, Inside::Hit));
    };
    for (name, most, call) in [("circle moves, <= 4 px", 4, moves), ("circle casts, <= 128 px", 128, casts)] {
        let bodies = bodies(&map, most * UNIT);
        for threads in [1, 2, 4] {
            let passes = (0..PASSES).map(|_| pass(&map, &bodies, threads, call));
            let (mean, slowest): (Vec<f64>, Vec<f64>) = passes.unzip();
            let cell = |times| steady(times).map_or("strays".to_owned(), |ns| format!("{ns:.0}"));
            let _ = writeln!(out, "| {name} | {threads} | {} | {} |", cell(mean), cell(slowest));
        }
    }
    out
}

/// Free circles and their motions.
fn bodies(map: &TileMap<'_>, most: i64) -> Vec<Body> {
    let (mut r, side) = (Random::new(0x7e4d), SIDE as i64 * CELL);
    let raw = |x: i64, y: i64| Vec2::from_raw(x as i32, y as i32);
    let mut bodies = Vec::with_capacity(BODIES);
    while bodies.len() < BODIES {
        let radius = Fx::from_bits(r.within(2 * UNIT, 16 * UNIT) as i32);
        let body = Circle::new(raw(r.within(0, side), r.within(0, side)), radius).expect("inside the domain");
        if !map.overlaps(&body) {
            bodies.push((body, raw(r.around(most), r.around(most))));
        }
    }
    bodies
}

/// Nanoseconds per call: of all threads, and of the slowest for its part.
fn pass(map: &TileMap<'_>, bodies: &[Body], threads: usize, call: Call) -> (f64, f64) {
    let times: Vec<(u64, usize)> = std::thread::scope(|scope| {
        let parts = bodies.chunks(bodies.len().div_ceil(threads));
        let running: Vec<_> = parts
            .map(|part| {
                scope.spawn(move || {
                    let start = cpu_time();
                    part.iter().for_each(|body| call(map, body));
                    (cpu_time() - start, part.len())
                })
            })
            .collect();
        running.into_iter().map(|thread| thread.join().expect("no call panics")).collect()
    });
    let mean = times.iter().map(|t| t.0).sum::<u64>() as f64 / bodies.len() as f64;
    let slowest = times.iter().map(|&(ns, n)| ns as f64 / n as f64).fold(0.0, f64::max);
    (mean, slowest)
}
