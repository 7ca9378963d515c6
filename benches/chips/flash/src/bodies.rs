//! Shared code of the scene programs: 30 bodies that fall, and lifts.

use super::port;
use tilesat::broad::SortSweep;
use tilesat::scene::{SceneBody, SceneTag};
use tilesat::world::ConvexSolid;
use tilesat::{Aabb, Axis, Circle, OrientedBox, Scene, Solid, Vec2, fx};

/// A scene of 30 bodies.
pub type Bodies = Scene<SortSweep<30, SceneTag>, 30>;

/// Per step.
pub const GRAVITY: Vec2 = Vec2::new(fx!(0), fx!(0.1));

/// Adds balls and boxes where the port says.
#[inline(always)]
pub fn fill(scene: &mut Bodies) {
    for key in 0..30 {
        let at = Vec2::from_raw(port() as i32, port() as i32);
        let ball = Circle::new(at, fx!(4)).map(|ball| SceneBody::new(ball, key));
        let box_ = Aabb::new(at, at + Vec2::from_ints(8, 8)).map(|box_| SceneBody::new(box_, key));
        if let Ok(body) = if port() & 1 == 0 { ball } else { box_ } {
            let _ = core::hint::black_box(scene.insert(&body));
        }
    }
}

const fn solid(x: i16, key: u16) -> Solid {
    match Aabb::from_size(Vec2::from_ints(x, 40), Vec2::from_ints(32, 8)) {
        Ok(shape) => match Solid::new(shape, key) {
            Ok(solid) => solid,
            Err(_) => panic!("a lift"),
        },
        Err(_) => panic!("a lift"),
    }
}

/// Two lifts.
pub const LIFTS: [Solid; 2] = [solid(16, 1), solid(64, 2)];

/// A plank of two cells, which rises by so much to the right.
#[inline(always)]
pub fn plank(x: i16, rise: i32) -> Option<OrientedBox> {
    OrientedBox::new(Vec2::from_ints(x, 44), Vec2::from_ints(16, 3), Axis::new(32, rise)).ok()
}

const fn flat(x: i16, key: u16) -> ConvexSolid<OrientedBox> {
    match OrientedBox::new(Vec2::from_ints(x, 44), Vec2::from_ints(16, 3), Axis::X) {
        Ok(shape) => match shape.convex_solid(key) {
            Ok(solid) => solid,
            Err(_) => panic!("a plank"),
        },
        Err(_) => panic!("a plank"),
    }
}

/// Two planks.
pub const PLANKS: [ConvexSolid<OrientedBox>; 2] = [flat(32, 1), flat(80, 2)];

/// The motion of a lift: up while the port says so, else down.
#[inline(always)]
pub fn way() -> Vec2 {
    Vec2::from_ints(0, if port() & 16 == 0 { 1 } else { -1 })
}
