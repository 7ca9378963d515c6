//! Scenes: bodies that are not fast do not pass fixed bodies, nor sink into them. Units, y down.

use super::steps::{Swept, open, step_with};
use tilesat::broad::{Handle, SortSweep};
use tilesat::query::Contacts;
use tilesat::scene::{Reply, SceneBody, Shape};
use tilesat::{Aabb, Circle, Fx, Surface, Vec2, fx};
use tilesat_judge::{Random, cases};

fn rect(x: Fx, y: Fx, w: Fx, h: Fx) -> Aabb {
    let low = Vec2::new(x, y);
    Aabb::new(low, low + Vec2::new(w, h)).unwrap()
}

pub(super) fn ball(x: Fx, y: Fx, r: Fx) -> Circle {
    Circle::new(Vec2::new(x, y), r).unwrap()
}

fn step(scene: &mut Swept, gravity: Vec2) {
    step_with(scene, &open(), gravity, &mut |_| Reply::Meet, &mut |_| ()).unwrap();
}

/// A number from `from` to `to`.
fn between(r: &mut Random, from: Fx, to: Fx) -> Fx {
    from + Fx::from_bits(r.below((to - from).to_bits().into()) as i32)
}

/// How deep a body is in any other.
pub(super) fn depth(scene: &Swept, body: Handle) -> Fx {
    let shape = scene.body(body).unwrap().shape;
    let others = scene.bodies().filter(|(other, _)| *other != body);
    let depths = others.filter_map(|(_, it)| it.shape.contact(&shape)).map(|contact| contact.depth());
    depths.max().unwrap_or(Fx::ZERO)
}

/// What a gap is between, and what falls on it: 16 units wide.
#[derive(Clone, Copy, Debug)]
enum Gap {
    Ledges,
    Pegs,
}

/// Each falls slower than the half of its size per step that would make it fast.
#[test]
fn nothing_falls_through_a_gap_that_is_too_narrow() {
    let (middle, top) = (fx!(200), fx!(300));
    let (mut runs, mut rest) = (0, 0);
    for (kind, boxed) in [(Gap::Ledges, false), (Gap::Ledges, true), (Gap::Pegs, false), (Gap::Pegs, true)] {
        for case in 0..cases(500) {
            let r = &mut Random::new(case);
            let half = between(r, fx!(1), fx!(7.6));
            let gravity = between(r, fx!(0.02), fx!(0.4));
            let sides: [Shape; 2] = match kind {
                Gap::Ledges => [
                    rect(middle - half - fx!(40), top, fx!(40), fx!(16)).into(),
                    rect(middle + half, top, fx!(40), fx!(16)).into(),
                ],
                Gap::Pegs => [-half - fx!(10), half + fx!(10)].map(|x| ball(middle + x, top + fx!(10), fx!(10)).into()),
            };
            let mut scene = Swept::new(SortSweep::new());
            for (key, side) in (1..).zip(sides) {
                scene.insert(&SceneBody::fixed(side, key)).unwrap();
            }
            let (x, y) = (middle + between(r, fx!(-4), fx!(4)), top - between(r, fx!(9), fx!(40)));
            let shape: Shape =
                if boxed { rect(x - fx!(8), y - fx!(8), fx!(16), fx!(16)).into() } else { ball(x, y, fx!(8)).into() };
            let velocity = Vec2::new(between(r, fx!(-2), fx!(2)), between(r, fx!(0), fx!(7.5)));
            let body = scene.insert(&SceneBody { velocity, ..SceneBody::of(shape, 9) }).unwrap();
            let mut steps = 0;
            while steps < 400 && !scene.awake().is_empty() {
                let falls = scene.body(body).unwrap().velocity.y >= fx!(7.5);
                step(&mut scene, Vec2::new(fx!(0), if falls { fx!(0) } else { gravity }));
                steps += 1;
                let bounds = scene.body(body).unwrap().shape.aabb();
                let (low, high) = (bounds.min(), bounds.max());
                let run = format!("{kind:?} box {boxed}, case {case}, step {steps}: {bounds:?}");
                let deep = depth(&scene, body);
                // An eighth of its side if it lies on one.
                assert!(deep <= fx!(2), "{deep} deep, {run}");
                // Below the corners there is no room for its width.
                let between = low.x > middle - fx!(12) && high.x < middle + fx!(12);
                assert!(!between || low.y + fx!(8) < top + fx!(10), "{run}");
                if low.y > top + fx!(40) {
                    break; // it fell off an outer end
                }
            }
            (runs, rest) = (runs + 1, rest + u32::from(steps < 400));
        }
    }
    println!("{rest} of {runs} rest or are gone after 400 steps");
    assert!(rest * 50 >= runs * 49, "{rest} of {runs}");
}

/// In a room of fixed walls that are elastic, no component of a velocity ever changes its size: in
/// a corner, each wall changes its own.
#[test]
fn walls_of_a_room_each_turn_their_own_component() {
    let walls = [(0, 0, 216, 16), (0, 184, 216, 16), (0, 0, 16, 200), (200, 0, 16, 200)];
    for boxed in [false, true] {
        for case in 0..cases(60) {
            let r = &mut Random::new(case);
            let mut scene = Swept::new(SortSweep::new());
            let surface = Surface::ELASTIC;
            for (key, (x, y, w, h)) in (1..).zip(walls) {
                let [x, y, w, h] = [x, y, w, h].map(Fx::from_num::<i32>);
                scene.insert(&SceneBody { surface, ..SceneBody::fixed(rect(x, y, w, h), key) }).unwrap();
            }
            // Every other one goes into a corner.
            let speed = between(r, fx!(0.5), fx!(3.9));
            let (velocity, at) = if case % 2 == 0 {
                (Vec2::new(-speed, -speed), fx!(60))
            } else {
                (Vec2::new(between(r, fx!(-3.9), fx!(3.9)), speed), between(r, fx!(30), fx!(170)))
            };
            let shape: Shape = if boxed { rect(at, at, fx!(8), fx!(8)).into() } else { ball(at, at, fx!(4)).into() };
            let body = SceneBody { surface, velocity, floats: true, ..SceneBody::of(shape, 9) };
            let body = scene.insert(&body).unwrap();
            for frame in 0..600 {
                step(&mut scene, Vec2::ZERO);
                let now = scene.body(body).unwrap().velocity;
                assert_eq!(
                    (now.x.abs(), now.y.abs()),
                    (velocity.x.abs(), velocity.y.abs()),
                    "box {boxed}, case {case}, frame {frame}"
                );
                assert!(depth(&scene, body) < fx!(0.1), "box {boxed}, case {case}, frame {frame}");
            }
        }
    }
}

/// A crowd among pegs, in a bin of fixed walls. Others may press down a body that lies on a peg;
/// the next step brings it out.
#[test]
fn a_crowd_does_not_press_a_body_into_a_fixed_one() {
    let mut deepest = Fx::ZERO;
    for case in 0..cases(24) {
        let r = &mut Random::new(case);
        let gravity = between(r, fx!(0.05), fx!(0.4));
        let mut scene = Swept::new(SortSweep::new());
        for (key, (x, y, w, h)) in (100..).zip([(0, 0, 20, 300), (100, 0, 20, 300), (0, 280, 120, 20)]) {
            let [x, y, w, h] = [x, y, w, h].map(Fx::from_num::<i32>);
            scene.insert(&SceneBody::fixed(rect(x, y, w, h), key)).unwrap();
        }
        for (key, (x, y)) in (200..).zip([(44, 200), (76, 200), (60, 230), (32, 240), (88, 240)]) {
            let peg = ball(Fx::from_num(x) + between(r, fx!(-3), fx!(3)), Fx::from_num(y), fx!(4));
            scene.insert(&SceneBody::fixed(peg, key)).unwrap();
        }
        let bodies: Vec<_> = (0..12)
            .map(|k| {
                let (x, y) = (fx!(34) + fx!(26) * (k % 3), fx!(170) - fx!(20) * (k / 3));
                let shape: Shape = if k % 4 == 3 {
                    rect(x - fx!(6), y - fx!(6), fx!(12), fx!(12)).into()
                } else {
                    ball(x, y, fx!(6)).into()
                };
                let velocity = Vec2::new(between(r, fx!(-3), fx!(3)), between(r, fx!(0), fx!(5)));
                scene.insert(&SceneBody { velocity, ..SceneBody::of(shape, k as u32) }).unwrap()
            })
            .collect();
        for frame in 0..300 {
            step(&mut scene, Vec2::new(fx!(0), gravity));
            for &body in &bodies {
                let shape = scene.body(body).unwrap().shape;
                let fixed = scene.bodies().filter(|(_, it)| it.mass.is_none());
                let deep = fixed.filter_map(|(_, it)| it.shape.contact(&shape)).map(|it| it.depth()).max();
                let deep = deep.unwrap_or(Fx::ZERO);
                assert!(deep < fx!(1.6), "case {case}, frame {frame}: {deep} deep, {shape:?}");
                deepest = deepest.max(deep);
            }
        }
    }
    println!("at most {deepest} deep");
}

/// Stones of one height, side by side: neither gravity nor a push into them stops a body there.
#[test]
fn a_body_slides_over_the_seams_of_fixed_bodies() {
    for (vx, gravity, width) in [0.1, 0.3, 1.0, 2.3, 3.7, 7.0].into_iter().flat_map(|vx| {
        let gravities = [0.05, 0.25, 0.6, 1.0, 2.0].into_iter();
        gravities.flat_map(move |g| [3, 7, 16, 40].map(|width| (Fx::from_num(vx), Fx::from_num(g), width)))
    }) {
        let mut scene = Swept::new(SortSweep::new());
        for k in 0..30 {
            let stone = rect(Fx::from_num(k * width), fx!(200), Fx::from_num(width), fx!(16));
            scene.insert(&SceneBody::fixed(stone, k as u32)).unwrap();
        }
        let box_ = SceneBody {
            velocity: Vec2::new(vx, fx!(0)),
            ..SceneBody::new(rect(fx!(2), fx!(184), fx!(16), fx!(16)), 99)
        };
        let body = scene.insert(&box_).unwrap();
        let frames = (Fx::from_num(30 * width - 20) / vx).to_num::<i32>().min(120);
        for _ in 0..frames {
            step(&mut scene, Vec2::new(fx!(0), gravity));
        }
        let way = scene.body(body).unwrap().shape.position().x - fx!(2);
        assert_eq!(way, vx * frames, "{vx} by {gravity} on stones of {width}");
    }
}

/// As a hero that is steered diagonally into a wall.
#[test]
fn a_push_into_a_wall_costs_no_speed_along_it() {
    for (vx, push, gravity) in [(1, 1, 0), (3, 2, 0), (1, 4, 0), (1, 3, 1), (3, 7, 1)] {
        for width in [16, 200] {
            let mut scene = Swept::new(SortSweep::new());
            for k in 0..30 {
                let stone = rect(Fx::from_num(k * width), fx!(200), Fx::from_num(width), fx!(16));
                scene.insert(&SceneBody::fixed(stone, k as u32)).unwrap();
            }
            let box_ = rect(fx!(2), fx!(184), fx!(16), fx!(16));
            let body = scene.insert(&SceneBody { floats: gravity == 0, ..SceneBody::new(box_, 99) }).unwrap();
            for _ in 0..100 {
                scene.set_velocity(body, Vec2::from_ints(vx, push)).unwrap();
                step(&mut scene, Vec2::new(fx!(0), Fx::from_num(gravity) / 4));
            }
            let way = scene.body(body).unwrap().shape.position().x - fx!(2);
            assert!(way > Fx::from_num(100 * vx) - fx!(1), "{vx} and {push} on stones of {width}: {way}");
        }
    }
}

/// A lift that the game places lower after each step, without a velocity.
#[test]
fn what_recedes_does_not_charge_a_body_with_speed() {
    for (down, gravity) in [(fx!(0.1), fx!(0.05)), (fx!(1), fx!(0.25)), (fx!(0.5), fx!(0.25))] {
        let mut scene = Swept::new(SortSweep::new());
        let mut y = fx!(200);
        let lift = scene.insert(&SceneBody::fixed(rect(fx!(0), y, fx!(100), fx!(8)), 1)).unwrap();
        let body = scene.insert(&SceneBody::new(rect(fx!(40), fx!(184), fx!(16), fx!(16)), 2)).unwrap();
        for frame in 0..400 {
            step(&mut scene, Vec2::new(fx!(0), gravity));
            y += down;
            scene.place(lift, rect(fx!(0), y, fx!(100), fx!(8))).unwrap();
            let speed = scene.body(body).unwrap().velocity.y;
            assert!(speed < down * 2 + gravity * 2, "{down} by {gravity}, frame {frame}: {speed}");
        }
    }
}
