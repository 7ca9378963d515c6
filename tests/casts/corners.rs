//! Boxes that meet corner to corner. The side that opposes the motion more is reported, x on a tie.

use tilesat::prelude::*;
use tilesat::{Aabb, Axis, Inside, Vec2};

#[test]
fn the_more_opposed_side_of_two_is_told() {
    for (sx, sy) in [(1, 1), (-1, 1), (1, -1), (-1, -1)] {
        let square = |x: i32, y: i32| {
            let (p, q) = (Vec2::from_raw(sx * x, sy * y), Vec2::from_raw(sx * (x + 10), sy * (y + 10)));
            Aabb::new(p.min(q), p.max(q)).expect("inside")
        };
        let (x, y) = (Axis::new(-sx, 0), Axis::new(0, -sy));
        for (gap, axis) in [((30, 10), x), ((10, 30), y), ((20, 20), x), ((21, 20), x), ((20, 21), y)] {
            let motion = Vec2::from_raw(sx * gap.0 * 2, sy * gap.1 * 2);
            let hit = square(0, 0).cast_shape(&square(10 + gap.0, 10 + gap.1), motion, Inside::Ignore);
            let hit = hit.expect("in range").expect("corner to corner and on");
            assert_eq!((hit.toi.raw(), hit.axis), (1 << 29, axis), "{gap:?} {sx} {sy}");
            assert_eq!(hit.displacement, Vec2::from_raw(sx * gap.0, sy * gap.1));
        }
    }
}
