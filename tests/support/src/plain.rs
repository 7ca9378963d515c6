//! Raw pairs for the tests of responses, and the number of their cases.

use tilesat::Vec2;

pub type P = (i64, i64);

pub fn vec2(p: P) -> Vec2 {
    Vec2::from_raw(p.0 as i32, p.1 as i32)
}

pub fn raw(v: Vec2) -> P {
    (v.raw().0.into(), v.raw().1.into())
}

pub fn dot(a: P, b: P) -> i128 {
    i128::from(a.0) * i128::from(b.0) + i128::from(a.1) * i128::from(b.1)
}
