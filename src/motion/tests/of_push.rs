//! Positions beside a corner.

use super::{Axis, Clearance, Raw, off};

/// Without room along one axis, a corner of 45 degrees pushes along the other one, by both
/// parts of the motion into it.
#[test]
fn beside_a_wall_a_corner_pushes_along_it() {
    for (x, y) in [(1, 1), (-1, 1), (1, -1), (-1, -1)] {
        let (n, made) = (Axis::new(x, y), Raw { x: 40 * x, y: 7 * y });
        let rest = Raw { x: -30 * x, y: -20 * y };
        let mut wall = Clearance::ALL;
        if x > 0 {
            wall.hi.x = made.x;
        } else {
            wall.lo.x = made.x;
        }
        assert_eq!(off(rest, made, n, &wall), Raw { x: 0, y: 50 * y });
        let mut floor = Clearance::ALL;
        if y > 0 {
            floor.hi.y = made.y;
        } else {
            floor.lo.y = made.y;
        }
        assert_eq!(off(rest, made, n, &floor), Raw { x: 50 * x, y: 0 });
    }
}
