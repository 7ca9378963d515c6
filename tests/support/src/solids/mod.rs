//! Shared code of the tests of moving solids: scaled counts, boxes from raw numbers.

pub mod convex;
pub mod judge;
pub mod shapes;
pub mod ticks;
pub mod twins;

use tilesat::{Aabb, Circle, Fx, Solid, Vec2};

/// A pair of raw coordinates.
pub type P = (i64, i64);

pub fn vec2(p: P) -> Vec2 {
    Vec2::from_raw(i32::try_from(p.0).unwrap(), i32::try_from(p.1).unwrap())
}

pub fn raw(v: Vec2) -> P {
    let (x, y) = v.raw();
    (i64::from(x), i64::from(y))
}

/// The box with two opposite corners.
pub fn rect(a: P, b: P) -> Aabb {
    Aabb::new(vec2((a.0.min(b.0), a.1.min(b.1))), vec2((a.0.max(b.0), a.1.max(b.1)))).unwrap()
}

pub fn disc(c: P, r: i64) -> Circle {
    Circle::new(vec2(c), Fx::from_bits(i32::try_from(r).unwrap())).unwrap()
}

/// A list in raw numbers.
pub fn show(list: &[Solid]) -> String {
    let one = |s: &Solid| {
        let (b, m, c) = (s.shape(), raw(s.motion()), raw(s.conveyor()));
        format!("{} {:?}..{:?} by {m:?} belt {c:?} {:?}\n", s.key(), raw(b.min()), raw(b.max()), s.one_way())
    };
    list.iter().map(one).collect()
}

pub fn solid(a: P, b: P, key: u16) -> Solid {
    Solid::new(rect(a, b), key).unwrap()
}
