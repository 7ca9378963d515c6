//! Hops of a body over an edge.

use super::{Axis, Came, Raw, across, hops, is_no_hop};
use tilesat_judge::{Random, cases, enough};

/// The answers without roots agree with those by roots: at all scales, also beside the limits.
#[test]
fn no_hop_is_told_without_roots() {
    let (mut random, mut seen, mut told) = (Random::new(17), 0u32, 0u32);
    for _ in 0..cases(400_000) {
        let (size, speed, far) = (random.within(1, 26), random.within(1, 26), random.within(1, 26));
        let mut part = |bits: i64| {
            let most = 1 << bits;
            random.around(most) as i32
        };
        let m = Raw { x: part(size), y: part(size) };
        let u = Raw { x: part(speed), y: part(speed) };
        let made = Raw { x: part(far), y: part(far) };
        if m.is_zero() {
            continue;
        }
        let along = across(u, Axis::new(m.x, m.y));
        let (hop, none) = (hops(m, along, made) != Came::Flew, is_no_hop(m, u, made));
        assert!(!(hop && none), "{m:?} by {made:?}, {u:?}");
        seen += u32::from(hop);
        told += u32::from(none);
    }
    assert!(enough(seen > 100 && told > 1000), "{seen} hops, {told} told");
}
