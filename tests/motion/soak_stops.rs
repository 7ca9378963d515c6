//! Single frames that stopped a soak, each among the blocks that it needs. The exact judge of block
//! worlds checks them.

use tilesat::{Axis, Mover, Response};
use tilesat_judge::motion::P;
use tilesat_judge::motion::body::{Body, Outcome};
use tilesat_judge::motion::judge::{check, judge};
use tilesat_judge::motion::level::Level;

const UP: Mover = Mover::platformer(Axis::NEG_Y);

/// A ball falls onto the corner of a block, 5 163 raw beside its end. The projection on the tangent
/// is 0.65 raw, which leads nowhere. But the ball ends 0.8 raw before the corner, and from there
/// the way along the block's top is free for more than 128 raw. So it keeps that (seed 105).
#[test]
fn a_ball_meets_a_corner_head_on() {
    let level = Level::new(&["#"], 1 << 20).with_origin((7 << 20, 12 << 20));
    let (ball, v) = (Body::disc((7_334_739, 11_513_993), 1_042_615), (171, 34_400));
    let out = check(&level, UP, Response::Slide, &ball, v);
    assert_eq!((out.v, out.hits.len()), ((171, 0), 1));
    // The judge accepts no other part of the velocity, and only if its way is free: not for a ball
    // that meets the corner 1 000 raw farther aside, by a motion of the same kind.
    let says = |ball: &Body, v: P, change: Outcome| judge(&level, ball, v, Response::Slide, &change).unwrap_err();
    assert_eq!(says(&ball, v, Outcome { v: (100, 0), ..out }), "goes on by (100, 0), no part of (171, 34400)");
    assert_eq!(says(&ball, v, Outcome { v: (171, 20), ..out }), "goes on by (171, 20), no part of (171, 34400)");
    let (aside, v) = (ball.moved((-1000, 0)), (203, 34_400));
    let out = check(&level, UP, Response::Slide, &aside, v);
    assert_eq!(out.v, (0, 0));
    assert_eq!(says(&aside, v, Outcome { v: (203, 0), ..out }), "still moves into what it hit last");
}

/// A capsule goes in between two corners that are exactly as far apart as it is wide. 478 raw on,
/// it meets the second one, where only each fifth raw unit of the middle line is free. It advances
/// to the free place that it finds farther back, and does not stop (seed 31).
#[test]
fn a_capsule_between_two_corners() {
    const CELL: i64 = 3 << 19;
    let level = Level::new(&["..#", "...", "...", "#.."], CELL).with_origin((3 * CELL, 8 * CELL));
    let capsule = Body::Disc { c: (7_078_949, 15_205_147), core: (0, 1 << 20), r: 5 << 18 };
    for response in [Response::Slide, Response::DropThrough] {
        let v = (-66_782, -48_690);
        let out = check(&level, UP, response, &capsule, v);
        assert!(out.v.0 < -66_000 && out.body.position().0 < 7_078_500, "{out:?}");
    }
}

/// A ball lands on a floor, passes its end and runs into a notch, whose two corners it meets at one
/// moment. Each takes what the other leaves of the remaining velocity, so it stops. The time of the
/// second corner has the rounding of the first, and is reported one part of 2^30 later (seed 2027).
#[test]
fn a_ball_in_a_notch() {
    let level = Level::new(&["#...", "....", "#...", "...#"], 1 << 20).with_origin((11 << 20, 9 << 20));
    let ball = Body::disc((15_335_424, 10_354_688), 3 << 19);
    let out = check(&level, UP, Response::Slide, &ball, (-1_592_861, 1_609_245));
    assert_eq!((out.body.position(), out.v, out.hits.len()), ((14_065_823, 11_010_048), (0, 0), 3));
    let times: Vec<u32> = out.hits.iter().map(|hit| hit.toi.raw()).collect();
    assert_eq!(times[2] - times[1], 1);
}

/// A capsule goes up between two corners exactly as far apart as it is wide. Its last sweep ends 25
/// raw before the middle, with the velocity through the gap. 42 raw of it are against the normal of
/// the last hit, and still it enters neither corner. 20 raw on it enters a third one, which it does
/// not touch yet. That is a hit of the next call (seed 2029).
#[test]
fn a_capsule_below_a_third_corner() {
    const CELL: i64 = 3 << 19;
    let level = Level::new(&["#.#", "...", "...", "..#"], CELL).with_origin((12 * CELL, 10 * CELL));
    let capsule = Body::Disc { c: (21_233_490, 17_891_560), core: (0, 15 << 17), r: 15 << 16 };
    let v = (1_013_267, -1_334_638);
    for response in [Response::Slide, Response::DropThrough] {
        let out = check(&level, UP, response, &capsule, v);
        assert_eq!((out.v, out.work.iterations), ((3 * 335_133, -4 * 335_133), Mover::ITERATIONS));
        // The judge accepts no velocity that leads into the corner that it hit last, by however
        // little, and no position nearer than 4 raw to the third one. There the mover would see it.
        let says = |change: Outcome| judge(&level, &capsule, v, response, &change);
        let into = Err("still moves into what it hit last".to_owned());
        assert_eq!(says(Outcome { v: (out.v.0 + 1, out.v.1 + 1), ..out }), into);
        assert_eq!(says(Outcome { body: out.body.moved((12, -16)), ..out }), Ok(()), "4.8 raw off");
        assert_eq!(says(Outcome { body: out.body.moved((15, -20)), ..out }), into, "it touches");
    }
}
