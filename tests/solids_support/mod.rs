//! What the tests of moving solids share: scaled counts, boxes from raw numbers.

#![allow(dead_code, reason = "each test file uses its own part")]
#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "tests stop at the first surprise")]

#[path = "../oracle/random.rs"]
pub(crate) mod random;

pub(crate) mod judge;
pub(crate) mod twins;

use tilesat::{Aabb, Circle, Fx, Solid, Vec2};

pub(crate) fn cases(default: u64) -> u64 {
    std::env::var("TILESAT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(default)
}

/// A pair of raw coordinates.
pub(crate) type P = (i64, i64);

pub(crate) fn vec2(p: P) -> Vec2 {
    Vec2::from_raw(i32::try_from(p.0).unwrap(), i32::try_from(p.1).unwrap())
}

pub(crate) fn raw(v: Vec2) -> P {
    let (x, y) = v.raw();
    (i64::from(x), i64::from(y))
}

/// The box with two opposite corners.
pub(crate) fn rect(a: P, b: P) -> Aabb {
    Aabb::new(vec2((a.0.min(b.0), a.1.min(b.1))), vec2((a.0.max(b.0), a.1.max(b.1)))).unwrap()
}

pub(crate) fn disc(c: P, r: i64) -> Circle {
    Circle::new(vec2(c), Fx::from_bits(i32::try_from(r).unwrap())).unwrap()
}

/// A list in raw numbers.
pub(crate) fn show(list: &[Solid]) -> String {
    let one = |s: &Solid| {
        let (b, m, c) = (s.shape(), raw(s.motion()), raw(s.conveyor()));
        format!("{} {:?}..{:?} by {m:?} belt {c:?} {:?}\n", s.key(), raw(b.min()), raw(b.max()), s.one_way())
    };
    list.iter().map(one).collect()
}

pub(crate) fn solid(a: P, b: P, key: u16) -> Solid {
    Solid::new(rect(a, b), key).unwrap()
}
