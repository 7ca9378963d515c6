//! What a fast body overlaps pushes it out, also from below. Slow balls sink into others.

use super::steps::{Swept, open, step_with};
use tilesat::broad::SortSweep;
use tilesat::query::Contacts;
use tilesat::scene::{Reply, SceneBody, Shape};
use tilesat::{Aabb, Circle, Fx, Vec2, fx};

fn rect(x: Fx, y: Fx, w: i16, h: i16) -> Aabb {
    let min = Vec2::new(x, y);
    Aabb::new(min, min + Vec2::from_ints(w, h)).unwrap()
}

fn step(scene: &mut Swept, gravity: Vec2) {
    step_with(scene, &open(), gravity, &mut |_| Reply::Meet, &mut |_| ()).unwrap();
}

/// How deep two bodies are in each other.
fn depth(scene: &Swept) -> Fx {
    let shapes: Vec<_> = scene.bodies().map(|(_, body)| body.shape).collect();
    shapes[0].contact(&shapes[1]).map_or(Fx::ZERO, |contact| contact.depth())
}

/// For each direction of gravity, each side on which it may overlap a fixed body, and each depth.
#[test]
fn a_fast_body_leaves_what_it_overlaps_on_every_side() {
    let (zero, one) = (fx!(0), fx!(0.25));
    let pulls = [(zero, one), (zero, -one), (one, zero), (-one, zero), (zero, zero)];
    for (pull, side) in pulls.into_iter().flat_map(|pull| [(1, 0), (-1, 0), (0, 1), (0, -1)].map(|side| (pull, side))) {
        for deep in [Fx::DELTA, fx!(0.5), fx!(1), fx!(3)] {
            let away = fx!(20) - deep;
            let at = fx!(80);
            let (x, y) = (at + away * Fx::from_num(side.0), at + away * Fx::from_num(side.1));
            let shapes: [Shape; 2] = [
                rect(x, y, 20, 20).into(),
                Circle::new(Vec2::new(x, y) + Vec2::from_ints(10, 10), fx!(10)).unwrap().into(),
            ];
            for shape in shapes {
                let mut scene = Swept::new(SortSweep::new());
                scene.insert(&SceneBody::fixed(rect(at, at, 20, 20), 1)).unwrap();
                scene.insert(&SceneBody { fast: true, ..SceneBody::new(shape, 2) }).unwrap();
                for _ in 0..8 {
                    step(&mut scene, Vec2::new(pull.0, pull.1));
                }
                assert_eq!(depth(&scene), 0, "{shape:?} by {pull:?}");
            }
        }
    }
}

/// A lift that the game places after each step. If the game sets its velocity, the rider is behind
/// by at most what gravity adds in a step; else by a step of the lift.
#[test]
fn a_fast_body_rides_on_a_fixed_one() {
    for (told, behind) in [(true, fx!(0.25)), (false, fx!(1))] {
        let velocity = Vec2::from_ints(0, -1);
        let mut way = rect(fx!(60), fx!(150), 40, 6);
        let mut scene = Swept::new(SortSweep::new());
        let lift = SceneBody { velocity: if told { velocity } else { Vec2::ZERO }, ..SceneBody::fixed(way, 1) };
        let lift = scene.insert(&lift).unwrap();
        let rider = SceneBody { velocity, fast: true, ..SceneBody::new(rect(fx!(75), fx!(136), 10, 14), 2) };
        let rider = scene.insert(&rider).unwrap();
        for _ in 0..80 {
            step(&mut scene, Vec2::new(fx!(0), fx!(0.25)));
            way = rect(way.min().x, way.min().y - fx!(1), 40, 6);
            scene.place(lift, way).unwrap();
            let feet = scene.body(rider).unwrap().shape.aabb().max().y;
            assert!((way.min().y..=way.min().y + behind).contains(&feet), "{told}: {feet} {}", way.min().y);
        }
    }
}

/// The limits that the page of scenes states, for a ball on two others. Over a gap between fixed
/// bodies it hardly sinks. A fast ball keeps out of all.
#[test]
fn slow_balls_sink_as_documented() {
    let floor = SceneBody::fixed(rect(fx!(20), fx!(112), 120, 8), 90);
    let block = |x: i16, key| SceneBody::fixed(rect(Fx::from_num(x), fx!(80), 40, 16), key);
    let ball = |x: f64, y: f64, key| {
        SceneBody::new(Circle::new(Vec2::new(Fx::from_num(x), Fx::from_num(y)), fx!(8)).unwrap(), key)
    };
    // The upper ball, how deep it is at the end, and where its centre is if it keeps out.
    let scenes = [
        (
            vec![floor, ball(60.0, 104.0, 1), ball(76.0, 104.0, 2)],
            ball(68.0, 90.14, 3),
            fx!(0.06)..fx!(0.09),
            fx!(90.14),
        ),
        (vec![floor, block(20, 4), block(72, 5)], ball(66.0, 60.0, 3), fx!(0.02)..fx!(0.07), fx!(74.71)),
    ];
    for (others, upper, sinks, stays) in scenes {
        for fast in [false, true] {
            let mut scene = Swept::new(SortSweep::new());
            let others: Vec<_> = others.iter().map(|body| scene.insert(body).unwrap()).collect();
            let upper = scene.insert(&SceneBody { fast, ..upper }).unwrap();
            for _ in 0..400 {
                step(&mut scene, Vec2::new(fx!(0), fx!(0.25)));
            }
            let shape = scene.body(upper).unwrap().shape;
            let deep = |&other: &_| scene.body(other).unwrap().shape.contact(&shape).map_or(Fx::ZERO, |c| c.depth());
            let (deep, y) = (others.iter().map(deep).max().unwrap(), shape.position().y);
            let off = y - stays;
            assert!(scene.awake().is_empty(), "{stays}: it rests, fast {fast}");
            if fast {
                assert!(deep < fx!(0.01) && off.abs() < fx!(0.02), "{stays}: {deep} at {y}");
            } else {
                assert!(sinks.contains(&deep) && off > fx!(0.05), "{stays}: {deep} at {y}");
            }
        }
    }
}
