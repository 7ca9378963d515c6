//! Single frames that stopped a soak, each among the blocks that it needs. The exact judge of block
//! worlds checks them.

use tilesat::{Axis, Mover, Response};
use tilesat_judge::motion::body::Body;
use tilesat_judge::motion::judge::check;
use tilesat_judge::motion::level::Level;

const UP: Mover = Mover::platformer(Axis::NEG_Y);

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
