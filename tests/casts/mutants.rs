//! Casts that the streams and lattices of the other tests do not reach. Changes of the kernels that
//! none of those noticed led to them.

use tilesat::{Axis, Inside};
use tilesat_judge::Random;
use tilesat_judge::casts::ask::{Case, cast, check};
use tilesat_judge::oracle::figure::Figure;
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::oracle::kernel::vec2;

fn circle(x: i64, y: i64, radius: i64) -> Figure {
    Figure::Circle { centre: (x, y), radius }
}

/// Boxes that touch with a corner before a motion meet both sides at its start.
#[test]
fn corner_on_corner_from_the_start() {
    let a = Figure::Aabb { min: (0, 0), max: (10, 10) };
    for (sx, sy) in [(1, 1), (-1, 1), (1, -1), (-1, -1)] {
        let b = a.moved((sx * 10, sy * 10));
        for (d, axis) in [((30, 10), (1, 0)), ((10, 30), (0, 1)), ((20, 20), (1, 0))] {
            let hit = cast(&a, &b, (sx * d.0, sy * d.1), Inside::Ignore).expect("in range").hit.expect("moves in");
            assert_eq!(hit.axis, Axis::new((-sx * axis.0) as i32, (-sy * axis.1) as i32), "{d:?} {sx} {sy}");
            assert_eq!(hit.toi.raw(), 0);
        }
    }
}

/// A circle that comes to a side level with its end has met the side, at a fractional time, not the
/// corner.
#[test]
fn at_the_end_of_a_side() {
    for (sx, sy) in [(1, 1), (-1, 1), (1, -1), (-1, -1)] {
        for exchange in [false, true] {
            let view = |x: i64, y: i64| if exchange { (sy * y, sx * x) } else { (sx * x, sy * y) };
            let (p, q) = (view(0, 0), view(500, 700));
            let b = Figure::Aabb { min: (p.0.min(q.0), p.1.min(q.1)), max: (p.0.max(q.0), p.1.max(q.1)) };
            for (end, climb) in [(0, 7), (700, -7), (0, 311), (700, -311)] {
                // Level with the end after a third of the motion.
                let centre = view(-1_050, end - climb);
                let a = Figure::Circle { centre, radius: 50 };
                assert_eq!(check::<i128>(&a, &b, view(3_000, 3 * climb), 2), Case::Hit);
                let hit =
                    cast(&a, &b, view(3_000, 3 * climb), Inside::Ignore).expect("in range").hit.expect("moves in");
                let (normal, way) = (view(-1, 0), view(1_000, climb));
                assert_eq!(hit.toi.raw(), (1 << 30) / 3);
                assert_eq!(hit.axis, Axis::new(normal.0 as i32, normal.1 as i32));
                assert_eq!(hit.displacement, vec2(way));
            }
        }
    }
}

/// Points overlap no point, whichever way they pass.
#[test]
fn points_pass_through_points() {
    for d in [(8, 0), (0, 8), (4, 0), (6, 4), (1000, 0), (1 << 27, 0)] {
        assert_eq!(check::<i128>(&circle(-d.0 / 2, -d.1 / 2, 0), &circle(0, 0, 0), d, 2), Case::Miss, "{d:?}");
    }
}

/// Ways through less of a disc than a step of the time: in and out again between two steps.
#[test]
fn grazes_shorter_than_a_step_of_time() {
    let mut hits = 0;
    for r in [1, 2, 3, 1000, 1 << 16, (1 << 20) + 7] {
        for x in [1 << 27, (1 << 27) - 2, (1 << 26) + 4098, 1 << 20] {
            for (above, climb) in [(1, 2), (2, 4), (3, 6), (0, 2), (2, 6)] {
                for part in [2, 4, 8] {
                    // Level with the top of the disc where it is above its centre.
                    let a = circle(-x / part, r - above * 2 / part, 0);
                    hits += u32::from(check::<Int256>(&a, &circle(0, 0, r), (x, climb), 4) == Case::Hit);
                }
            }
        }
    }
    assert!(hits > 40, "{hits}");
}

/// Slopes nearly parallel to x or y: one small component does not make the other small.
#[test]
fn steep_slopes() {
    let (mut r, mut hits) = (Random::new(0x57ee), 0);
    while hits < 60 {
        let (x, y) = (r.within(1, 2) * r.sign(), r.within(1 << 20, 1 << 26));
        let radius = r.within(1 << 10, 1 << 20);
        let (at, d) = ((r.within(radius, 1 << 21), r.around(y)), (-r.within(1 << 18, 1 << 23), r.around(1 << 23)));
        let view = |p: (i64, i64)| if hits % 2 == 0 { p } else { (p.1, p.0) };
        let slope = Figure::Segment { a: view((-x, -y)), b: view((x, y)) };
        let a = Figure::Circle { centre: view(at), radius };
        hits += u32::from(check::<Int256>(&a, &slope, view(d), 4) == Case::Hit);
    }
}

/// Long slopes and large circles. The comparison at a moment needs all of its 128 bits.
#[test]
fn large_circles_on_long_slopes() {
    let (mut r, mut hits) = (Random::new(0x510e), 0);
    while hits < 400 {
        let (x, y) = (r.within(1 << 26, (1 << 29) - 1), r.around((1 << 29) - 1));
        let slope = Figure::Segment { a: (-x, -y), b: (x, y) };
        let at = (r.around(1 << 26), r.within(1 << 27, 3 << 27));
        let a = circle(at.0, at.1 - at.1 / 4, r.within(1 << 25, 3 << 26));
        let d = (r.around(1 << 27), -r.within(1 << 24, (1 << 28) - 1));
        if a.in_domain() && slope.in_domain() {
            hits += u32::from(check::<Int256>(&a, &slope, d, 4) == Case::Hit);
        }
    }
}
