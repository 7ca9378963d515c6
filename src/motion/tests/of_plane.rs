//! Projections onto slopes.

use super::{Axis, Raw, across, project_slope};
use tilesat_judge::{Random, cases};

/// Along the slopes of tiles: whole multiples, toward zero, also at multiples of the square.
#[test]
fn slopes_take_whole_multiples() {
    let mut random = Random::new(18);
    for _ in 0..cases(400_000) {
        let most = 1 << random.within(1, 28);
        let v = Raw { x: random.around(most) as i32, y: random.around(most) as i32 };
        for (x, y) in [(1, 1), (1, -2), (-2, 1), (2, 2), (-1, -1), (-2, 2)] {
            let n = Axis::new(x, y);
            let along = across(v, n);
            let k = (along / i64::from(x * x + y * y)) as i32;
            assert_eq!(project_slope(along, n), Raw { x: -y * k, y: x * k }, "{v:?} along {n:?}");
        }
    }
}
