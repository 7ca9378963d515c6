//! Shared checks of casts through levels.

use tilesat::{Aabb, Circle, Fx, Inside, Mover, Response, Vec2, World, motion::BodyHit, world::RayRules};

pub type P = (i64, i64);

/// One-way faces count.
pub const SEEN: RayRules = RayRules { inside: Inside::Hit, one_way: true };
/// They do not.
pub const PASSED: RayRules = RayRules { inside: Inside::Hit, one_way: false };

pub fn raw(p: P) -> Vec2 {
    Vec2::from_raw(p.0 as i32, p.1 as i32)
}

pub fn point(v: Vec2) -> P {
    let (x, y) = v.raw();
    (x.into(), y.into())
}

pub fn rect(lo: P, hi: P) -> Aabb {
    Aabb::new(raw(lo), raw(hi)).unwrap()
}

pub fn disc(c: P, r: i64) -> Circle {
    Circle::new(raw(c), Fx::from_bits(r as i32)).unwrap()
}

/// The same first hit and position as the mover that stops at it, with one-way faces.
pub fn as_the_mover<W: World, B: tilesat::Body + PartialEq + core::fmt::Debug>(
    world: &W,
    body: &B,
    d: Vec2,
    found: Option<&BodyHit<B>>,
) {
    let touch = Mover::new().with_response(Response::Touch).move_and_slide(world, body, d).unwrap();
    assert_eq!(found.map(|f| f.hit), touch.hits.first(), "{body:?} by {d:?}");
    if let Some(found) = found {
        assert_eq!((found.body, found.inside), (touch.body, false), "{body:?} by {d:?}");
        assert!(found.work.features >= 1 && found.work.iterations == 1);
    }
}
