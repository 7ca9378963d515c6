//! Fast bodies that others press against a wall slide along it, whatever the keys are.

use tilesat::broad::SortSweep;
use tilesat::scene::{SceneBody, SceneTag, Shape};
use tilesat::{Aabb, Circle, Fx, Scene, TileKind, TileKinds, TileMap, Vec2, fx};
use tilesat_judge::scenes::BODIES;

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);

/// How far the one at the wall comes in 60 steps: pressed by `pressers` more in a file, with keys
/// that rise or fall from it.
fn slides(round: bool, pressers: i32, rising: bool, side: i32, gravity: Vec2, v: Vec2) -> Fx {
    let text = "#...........#\n".repeat(8);
    let level = TileMap::from_ascii(&text, &KINDS).unwrap();
    let mut scene = Scene::<SortSweep<BODIES, SceneTag>, BODIES>::new(SortSweep::new());
    let key = |at: i32| if rising { at } else { 9 - at } as u32;
    let mut bodies = Vec::new();
    for at in 0..=pressers {
        let x = if side > 0 { 178 - 14 * at } else { 16 + 14 * at } as i16;
        let crate_ = Aabb::from_size(Vec2::from_ints(x, 8), Vec2::from_ints(14, 14)).unwrap();
        let ball = || Circle::new(crate_.min() + Vec2::from_ints(7, 7), fx!(7)).unwrap();
        let shape = if at > 0 || !round { Shape::Aabb(crate_) } else { Shape::Circle(ball()) };
        let body = SceneBody { fast: true, floats: gravity == Vec2::ZERO, ..SceneBody::of_shape(shape, key(at)) };
        bodies.push(scene.insert(&body).unwrap());
    }
    let start = scene.body(bodies[0]).unwrap().shape.position().y;
    for _ in 0..60 {
        for (at, &body) in bodies.iter().enumerate() {
            let own = scene.body(body).unwrap().velocity.y;
            let y = if at > 0 {
                Fx::ZERO
            } else if gravity == Vec2::ZERO {
                v.y
            } else {
                own
            };
            scene.set_velocity(body, Vec2::new(v.x * side, y)).unwrap();
        }
        scene.step(&level, gravity, |_| {}).unwrap();
    }
    scene.body(bodies[0]).unwrap().shape.position().y - start
}

#[test]
fn who_is_pressed_against_a_wall_slides_along_it() {
    let mut cases = 0;
    for round in [false, true] {
        for (pressers, rising) in
            [(1, true), (1, false), (2, true), (2, false), (4, true), (4, false), (6, true), (6, false)]
        {
            for (side, push) in [1, -1].into_iter().flat_map(|side| [fx!(0.5), fx!(1), fx!(2.3)].map(|v| (side, v))) {
                let along = slides(round, pressers, rising, side, Vec2::ZERO, Vec2::new(push, fx!(0.7)));
                // Without friction, nothing but the rounding of the ways slows it down.
                assert!(along > fx!(40), "{round} {pressers} {rising} {side} {push}: {along}");
                let falls = slides(round, pressers, rising, side, Vec2::from_raw(0, 1 << 14), Vec2::new(push, fx!(0)));
                assert!(falls > fx!(60), "{round} {pressers} {rising} {side} {push}: falls by {falls}");
                cases += 1;
            }
        }
    }
    assert_eq!(cases, 96);
}
