//! Exact checks of the way out of an overlap: the push and the unit vector along an axis of any length.

use super::figure::Point;
use super::int256::Int256;
use super::sum::{Sum, dot};

/// The sign of `s - k sqrt(square)`.
pub fn compare_root(s: Int256, k: i64, square: Int256) -> i32 {
    let root = Int256::product(k, k) * square;
    match (s.signum() >= 0, k >= 0) {
        (true, true) => (s.squared() - root).signum(),
        (true, false) => 1,
        (false, true) => -1,
        (false, false) => (root - s.squared()).signum(),
    }
}

/// The sign of `k - need`, where `need >= 0` is one component of the exact push out of the grown sum along `u`.
fn compare_push(sum: &Sum, u: Point, component: i64, k: i64) -> i32 {
    // need = |c| / |u| * (support / |u| + radius), so that need * |u|^2 - |c| * support = |c| * radius * |u|.
    let square = dot(u, u);
    let c = component.abs();
    let left = Int256::new(k) * square - Int256::new(c) * sum.support(u);
    compare_root(left, c * sum.radius, square)
}

/// Moving A by `push` leaves the sum along `u`: away from B, each component at least the exact one and at most `slack` more.
pub fn push_is(sum: &Sum, u: Point, push: Point, slack: i64) -> Result<(), &'static str> {
    for (component, moved) in [(u.0, push.0), (u.1, push.1)] {
        if component * moved > 0 || (component == 0 && moved != 0) {
            return Err("push is not against the axis");
        }
        let k = moved.abs();
        if component != 0 && compare_push(sum, u, component, k) < 0 {
            return Err("push falls short");
        }
        if component != 0 && compare_push(sum, u, component, k - slack) > 0 {
            return Err("push is too long");
        }
    }
    Ok(())
}

/// Each component of `n` (2^30 is one) is within 1.5 of `u / |u|`.
pub fn is_unit(u: Point, n: Point) -> bool {
    let square = dot(u, u);
    [(u.0, n.0), (u.1, n.1)].into_iter().all(|(u, n)| {
        let sign = n == 0 || n.signum() == u.signum();
        // Twice the exact component is 2^31 * |u| / sqrt(square).
        let exact = Int256::product(u.abs(), 1 << 31).squared();
        let bound = |twice: i64| Int256::product(twice, twice) * square;
        let k = 2 * n.abs();
        sign && exact <= bound(k + 3) && (k < 3 || exact >= bound(k - 3))
    })
}
