//! Exact checks of the way out of an overlap: the push and the unit vector along an axis of any
//! length.

use super::figure::{LIMIT, Point};
use super::int256::Int256;
use super::kernel::point;
use super::measure::Measure;
use super::sum::{Place, Sum, dot, orient};
use tilesat::{Axis, Contact};

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

/// The sign of `k - need`, where `need >= 0` is one component of the exact push out of the grown
/// sum along `u`.
fn compare_push(sum: &Sum, u: Point, component: i64, k: i64) -> i32 {
    // need = |c| / |u| * (support / |u| + radius), so that need * |u|^2 - |c| * support = |c| *
    // radius * |u|.
    let square = dot(u, u);
    let c = component.abs();
    let left = Int256::new(k) * square - Int256::new(c) * sum.support(u);
    compare_root(left, c * sum.radius, square)
}

/// Moving A by `push` leaves the sum along `u`: away from B, with each component at least the exact
/// one and at most `slack` more.
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

/// How much a component of a push may exceed the exact one: one raw more if the depth is beyond
/// half the domain.
pub fn slack(depth: i64) -> i64 {
    if depth > LIMIT { 5 } else { 4 }
}

/// Axis, depth, push and normal of a contact are those of the sum; the push.
pub fn verify(sum: &Sum, exact: &Measure, contact: &Contact, case: &str) -> Point {
    let Axis { x, y } = contact.axis();
    let axis = (i64::from(x), i64::from(y));
    assert!(axis != (0, 0), "zero axis {case}");
    assert!(exact.is_shortest_exit(sum, axis), "axis {axis:?} is not the least exit of {case}");
    let depth = i64::from(contact.depth().to_bits());
    assert!(depth >= 1 && exact.depth_is(depth), "depth {depth} of {case}");
    let push = point(contact.push_out());
    if let Err(why) = push_is(sum, axis, push, slack(depth)) {
        panic!("{why}: {push:?} along {axis:?} for {case}");
    }
    let normal = contact.normal().raw();
    assert_eq!(contact.depth_and_normal(), (contact.depth(), contact.normal()), "{contact:?}");
    assert!(is_unit(axis, (normal.0.into(), normal.1.into())), "normal {normal:?} of {axis:?}");
    push
}

/// The deepest points lie on their shapes' borders, opposite to each other, within the promised two
/// raw units per component. Each shape is its core relative to its point, and its radius.
pub fn verify_points(contact: &Contact, a: (&Sum, i64), b: (&Sum, i64), case: &str) {
    let Axis { x, y } = contact.axis();
    let u = (i64::from(x), i64::from(y));
    let (p, q) = (point(contact.point_on_a()), point(contact.point_on_b()));
    // Two raw units per component are less than three in all.
    let on_border = |(core, r): (&Sum, i64), u: Point| {
        let behind = -core.support(u);
        let square = Measure::of(core).square;
        (core.place() != Place::Outside || square.root_minus(r + 3) <= 0)
            && compare_root(behind, r - 3, dot(u, u)) >= 0
            && compare_root(behind, r + 3, dot(u, u)) <= 0
    };
    assert!(on_border(a, u), "point on A {p:?} along {u:?}: {case}");
    assert!(on_border(b, (-u.0, -u.1)), "point on B {q:?} along {u:?}: {case}");
    let across = orient((0, 0), u, (p.0 - q.0, p.1 - q.1));
    assert!(across.squared() <= Int256::new(36) * dot(u, u), "points {p:?} {q:?} are not opposite: {case}");
}
