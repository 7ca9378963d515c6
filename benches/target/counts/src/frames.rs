//! Rows of many random frames in a level of all shapes: not the mean of a few but the far end of all.

use crate::counter::{Counter, elapsed, now};
use crate::inputs::{Random, UNIT, circle, vec};
use crate::measure::{CORE, Table};
use crate::shapes::{Map, SIDE, ball, crate_, level, on, tiles};
use core::hint::black_box;
use semihosting::println;
use tilesat::motion::{Body, Mover};
use tilesat::{Axis, Vec2};

/// How many frames a row is.
const FRAMES: usize = 4000;
/// Those that are above the 99.9th percentile, and the first that is not.
const ABOVE: usize = FRAMES / 1000 + 1;

pub fn rows(table: &mut Table) {
    let Some(map) = level() else {
        table.wrong += 1;
        return;
    };
    let counter = &table.counter;
    for (name, speed) in [("circle moves, <= 4 a frame", 4), ("circle moves, <= 30 a frame", 30)] {
        row(counter, name, &map, |r| Some((ball(r).filter(|c| !map.overlaps(c))?, velocity(r, speed))));
    }
    for (name, speed) in [("box moves, <= 4 a frame", 4), ("box moves, <= 30 a frame", 30)] {
        row(counter, name, &map, |r| Some((crate_(r).filter(|b| !map.overlaps(b))?, velocity(r, speed))));
    }
    missed(table);
    worst(table);
}

fn velocity(r: &mut Random, speed: i32) -> Vec2 {
    vec((r.raw(-speed, speed), r.raw(-speed, speed)))
}

/// The 99.9th percentile in the place of the kernel, the most in the place of the API.
fn row<B: Body>(counter: &Counter, name: &str, map: &Map, next: impl Fn(&mut Random) -> Option<(B, Vec2)>) {
    let (mut random, mut largest, mut made) = (Random::new(7), [0; ABOVE], 0);
    while made < FRAMES {
        let Some(frame) = next(&mut random) else { continue };
        made += 1;
        let mut count = instructions(counter, map, &frame);
        // The largest so far, the most first.
        for kept in &mut largest {
            if count > *kept {
                (count, *kept) = (*kept, count);
            }
        }
    }
    println!("{CORE}|shapes: {name}, 99.9 % of {FRAMES} and most|{}|{}|0", largest[ABOVE - 1], largest[0]);
}

/// What a block costs whose cell a ball's bounds reach and which it does not meet: between two blocks, less the same beside one. It has a side
/// and a corner there that the motion leaves, or passes.
fn missed(table: &mut Table) {
    static TWO: [u8; 12] = [0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0];
    static ONE: [u8; 12] = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0];
    // Corners at (48, 24) and (48, 48), 15.6 units away.
    let (Some(two), Some(one), Some(ball)) =
        (on(&TWO, 4, 3), on(&ONE, 4, 3), circle((38 * UNIT, 36 * UNIT), 14 * UNIT))
    else {
        table.wrong += 1;
        return;
    };
    for (name, x) in [("behind", -UNIT), ("passed", UNIT / 4)] {
        let counts = [&two, &one].map(|map| instructions(&table.counter, map, &(ball, vec((x, 0)))));
        println!("{CORE}|shapes: a block {name}, one of two|{}|{}|0", counts[0] - counts[1], counts[0]);
    }
}

/// The frame that took most of 110 000 in maps of 25, 40 and 60 % by up to 60 units: down a pit of two slopes, a corner and an arc.
fn worst(table: &mut Table) {
    static DENSE: [u8; SIDE * SIDE] = tiles(102);
    let (Some(map), Some(ball)) = (on(&DENSE, SIDE as u16, SIDE as u16), circle((5_416_021, 20_534_139), 10 * UNIT))
    else {
        table.wrong += 1;
        return;
    };
    let count = instructions(&table.counter, &map, &(ball, vec((-2_276_117, 3_544_802))));
    println!("{CORE}|shapes: circle moves, the worst frame found|{count}|{count}|0");
}

/// Instructions of one call by reference.
fn instructions<B: Body>(counter: &Counter, map: &Map, frame: &(B, Vec2)) -> u32 {
    let (from, to) = timed(map, frame, true);
    let (before, after) = timed(map, frame, false);
    counter.instructions(elapsed(from, to)) - counter.instructions(elapsed(before, after))
}

/// The readings around a call, or around none.
#[inline(never)]
fn timed<B: Body>(map: &Map, frame: &(B, Vec2), calls: bool) -> (u32, u32) {
    let (map, frame, calls) = black_box((map, frame, calls));
    let from = now();
    if calls {
        let _ = black_box(Mover::platformer(Axis::NEG_Y).move_and_slide(map, &frame.0, frame.1));
    }
    (from, now())
}
