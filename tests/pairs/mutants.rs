//! Contacts that the streams and lattices of the other tests do not reach. Changes of the kernels
//! that none of those noticed led to them.

use tilesat::prelude::*;
use tilesat::{Axis, Circle, Fx, Segment, Vec2};

fn segment(a: (i32, i32), b: (i32, i32)) -> Segment {
    Segment::new(Vec2::from_raw(a.0, a.1), Vec2::from_raw(b.0, b.1)).expect("inside")
}

/// x before y before the smaller normal, whichever shape is A.
#[test]
fn equal_exits_of_crossing_segments() {
    let (level, upright, steep, flat) =
        (segment((-5, 0), (5, 0)), segment((0, -5), (0, 5)), segment((-3, -4), (3, 4)), segment((-4, -3), (4, 3)));
    for (a, b, is_x) in [(level, upright, true), (level, steep, false), (upright, flat, true)] {
        for (a, b) in [(a, b), (b, a)] {
            let contact = a.contact(&b).expect("they cross");
            assert!(contact.is_degenerate());
            let axis = contact.axis();
            assert!(if is_x { axis.y == 0 } else { axis.x == 0 }, "{axis:?}: {a:?} {b:?}");
        }
    }
}

/// Deepest points on a rim are to nearest: 0.707 and 7.778 raw are 1 and 8.
#[test]
fn deepest_points_are_to_nearest() {
    for (radius, part) in [(1, 1), (11, 8)] {
        for (x, y) in [(1, 1), (-1, 1), (1, -1), (-1, -1)] {
            let circle = |x, y| Circle::new(Vec2::from_raw(x, y), Fx::from_bits(radius)).expect("inside");
            let contact = circle(0, 0).contact(&circle(x, y)).expect("they overlap");
            assert_eq!(contact.axis(), Axis::new(x, y));
            assert_eq!(contact.point_on_a(), Vec2::from_raw(x * part, y * part));
            assert_eq!(contact.point_on_b(), Vec2::from_raw(x - x * part, y - y * part));
        }
    }
}
