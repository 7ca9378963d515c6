//! Rows of many random frames in a level of all shapes. They show the far end of all frames, not
//! the mean of a few.

use core::mem::MaybeUninit;
use tilesat::motion::{Body, MoveError, Moved, Mover};
use tilesat::{Axis, Vec2};
use tilesat_counts::clock::Short;
use tilesat_counts::counter::Counter;
use tilesat_counts::inputs::{Random, UNIT, circle, vec};
use tilesat_counts::measure::{Query, Table, nothing, sample, tell};
use tilesat_counts::shapes::{Map, SIDE, ball, crate_, level, on, tiles};

/// Frames per row.
const FRAMES: usize = 4000;
/// The frames above the 99.9th percentile, and the first one below.
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

/// The mean, the 99.9th percentile and the maximum.
fn row<B: Body>(counter: &Counter<Short>, name: &str, map: &Map, next: impl Fn(&mut Random) -> Option<(B, Vec2)>) {
    let (mut random, mut largest, mut made, mut sum) = (Random::new(7), [0; ABOVE], 0, 0);
    while made < FRAMES {
        let Some(frame) = next(&mut random) else { continue };
        made += 1;
        let mut count = instructions(counter, map, &frame);
        sum += count;
        // The largest so far, in descending order.
        for kept in &mut largest {
            if count > *kept {
                (count, *kept) = (*kept, count);
            }
        }
    }
    tell("frames", format_args!("{name}, mean of {FRAMES}"), sum / FRAMES as u32, None);
    tell("frames", format_args!("{name}, 99.9 % of {FRAMES}"), largest[ABOVE - 1], None);
    tell("frames", format_args!("{name}, most of {FRAMES}"), largest[0], None);
}

/// The cost of a block whose cell a ball's bounds reach, but which the ball does not meet. It is
/// the cost between two blocks minus the cost beside one. The motion leaves, or passes, a side and
/// a corner there.
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
        tell("frames", format_args!("a block {name}, its part"), counts[0] - counts[1], None);
        tell("frames", format_args!("a block {name}, the frame"), counts[0], None);
    }
}

/// The most expensive of 110 000 frames, in maps of 25, 40 and 60 % by up to 60 units. It goes down
/// a pit of two slopes, a corner and an arc.
fn worst(table: &mut Table) {
    static DENSE: [u8; SIDE * SIDE] = tiles(102);
    let (Some(map), Some(ball)) = (on(&DENSE, SIDE as u16, SIDE as u16), circle((5_416_021, 20_534_139), 10 * UNIT))
    else {
        table.wrong += 1;
        return;
    };
    let count = instructions(&table.counter, &map, &(ball, vec((-2_276_117, 3_544_802))));
    tell("frames", "circle moves, the worst frame found", count, None);
}

/// Instructions of one call by reference.
fn instructions<B: Body>(counter: &Counter<Short>, map: &Map, frame: &(B, Vec2)) -> u32 {
    let query: Query<(B, Vec2), Map, Result<Moved<B>, MoveError>> =
        |body, map| MaybeUninit::new(Mover::platformer(Axis::NEG_Y).move_and_slide(map, &body.0, body.1));
    sample(counter, query, nothing, frame, map).1
}
