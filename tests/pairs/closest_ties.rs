//! Nearest points whose coordinates are exactly halves. They are rounded so that the foot stays on
//! the side of the query's point.

use tilesat::{Segment, Vec2};

#[test]
fn halves_stay_with_the_point() {
    for (sx, sy) in [(1, 1), (-1, 1), (1, -1), (-1, -1)] {
        let at = |x: i32, y: i32| Vec2::from_raw(sx * x, sy * y);
        // The feet are at (1/2, 1/2) and (3/2, 3/2) of the diagonal.
        let diagonal = Segment::new(at(0, 0), at(4, 4)).expect("inside");
        for p in [at(1, 0), at(0, 1), at(1, 2), at(2, 1)] {
            assert_eq!(diagonal.closest_point(p), p);
        }
        // A raw unit farther the quotient is whole.
        assert_eq!(diagonal.closest_point(at(2, 0)), at(1, 1));
        assert_eq!(diagonal.closest_point(at(3, 0)).raw(), at(2, 1).raw());
    }
}
