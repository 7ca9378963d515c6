//! Fast bodies that others press against a wall slide along it, whatever the keys are, and rows of
//! them stay rows.

use super::kept_out::{ball, depth};
use super::steps::{Swept, step_with};
use core::num::NonZeroU8;
use tilesat::broad::{Handle, SortSweep};
use tilesat::scene::{Reply, SceneBody, SceneTag, Shape};
use tilesat::{Aabb, Circle, Fx, Scene, Surface, TileKind, TileKinds, TileMap, Vec2, fx};
use tilesat_judge::scenes::BODIES;
use tilesat_judge::{Random, cases};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);

/// The vector, or its mirror image with x and y exchanged.
fn turn(turned: bool, v: Vec2) -> Vec2 {
    if turned { Vec2::new(v.y, v.x) } else { v }
}

/// How far the one at the wall comes in 60 steps: pressed by `pressers` more in a file, with keys
/// that rise or fall from it. Turned, the walls are a ceiling and a floor.
fn slides(round: bool, pressers: i32, rising: bool, (turned, side): (bool, i32), gravity: Vec2, v: Vec2) -> Fx {
    let text =
        if turned { format!("########\n{}########\n", "........\n".repeat(11)) } else { "#...........#\n".repeat(8) };
    let level = TileMap::from_ascii(&text, &KINDS).unwrap();
    let mut scene = Scene::<SortSweep<BODIES, SceneTag>, BODIES>::new(SortSweep::new());
    let key = |at: i32| if rising { at } else { 9 - at } as u32;
    let mut bodies = Vec::new();
    for at in 0..=pressers {
        let x = if side > 0 { 178 - 14 * at } else { 16 + 14 * at } as i16;
        let crate_ = Aabb::from_size(turn(turned, Vec2::from_ints(x, 8)), Vec2::from_ints(14, 14)).unwrap();
        let ball = || Circle::new(crate_.min() + Vec2::from_ints(7, 7), fx!(7)).unwrap();
        let shape = if at > 0 || !round { Shape::Aabb(crate_) } else { Shape::Circle(ball()) };
        let body = SceneBody { fast: true, floats: gravity == Vec2::ZERO, ..SceneBody::of_shape(shape, key(at)) };
        bodies.push(scene.insert(&body).unwrap());
    }
    let along = |scene: &Scene<_, BODIES>| turn(turned, scene.body(bodies[0]).unwrap().shape.position()).y;
    let start = along(&scene);
    for _ in 0..60 {
        for (at, &body) in bodies.iter().enumerate() {
            let own = turn(turned, scene.body(body).unwrap().velocity).y;
            let y = if at > 0 {
                Fx::ZERO
            } else if gravity == Vec2::ZERO {
                v.y
            } else {
                own
            };
            scene.set_velocity(body, turn(turned, Vec2::new(v.x * side, y))).unwrap();
        }
        scene.step(&level, turn(turned, gravity), |_| {}).unwrap();
    }
    along(&scene) - start
}

#[test]
fn who_is_pressed_against_a_wall_slides_along_it() {
    let mut cases = 0;
    for round in [false, true] {
        for (pressers, rising) in
            [(1, true), (1, false), (2, true), (2, false), (4, true), (4, false), (6, true), (6, false)]
        {
            for wall in [(false, 1), (false, -1), (true, 1), (true, -1)] {
                for push in [fx!(0.5), fx!(1), fx!(2.3)] {
                    let what = format!("{round} {pressers} {rising} {wall:?} {push}");
                    let along = slides(round, pressers, rising, wall, Vec2::ZERO, Vec2::new(push, fx!(0.7)));
                    // Without friction, nothing but the rounding of the ways slows it down.
                    assert!(along > fx!(40), "{what}: {along}");
                    let weight = Vec2::from_raw(0, 1 << 14);
                    let falls = slides(round, pressers, rising, wall, weight, Vec2::new(push, fx!(0)));
                    assert!(falls > fx!(60), "{what}: falls by {falls}");
                    cases += 1;
                }
            }
        }
    }
    assert_eq!(cases, 192);
}

/// A driver that gets its velocity again in each step presses a row of fast bodies of any sizes and
/// masses against a wall: crates on a floor, or crates and balls seen from above.
#[test]
fn rows_that_are_pressed_against_a_wall_stay_rows() {
    let text = "#...........#\n".repeat(3) + "#############";
    let level = TileMap::from_ascii(&text, &KINDS).unwrap();
    let (mut runs, mut pressed) = (0, 0);
    for case in 0..cases(tilesat_judge::thorough(150, 600)) {
        let r = &mut Random::new(case);
        let gravity = if r.one_in(2) { Fx::ZERO } else { Fx::from_bits(r.below(1 << 15) as i32) };
        let mut scene = Swept::new(SortSweep::new());
        let (mut row, mut right, mut side, mut whole) = (Vec::new(), fx!(192), Fx::MAX, Fx::ZERO);
        let first_key = r.below(2) as u32 * 100;
        for at in 0..2 + r.below(5) as u32 {
            let half = fx!(4) + Fx::from_bits(r.below(6 << 16) as i32);
            let y = if gravity == Fx::ZERO { fx!(24) } else { fx!(48) - half };
            let centre = Vec2::new(right - half, y);
            let crate_ = || Aabb::from_centre(centre, Vec2::new(half, half)).unwrap();
            let round = gravity == Fx::ZERO && r.one_in(2);
            let shape = if round { ball(centre.x, centre.y, half).into() } else { Shape::Aabb(crate_()) };
            let mass = NonZeroU8::new(1 + r.below(255) as u8);
            let body = SceneBody { mass, fast: true, ..SceneBody::of_shape(shape, first_key.abs_diff(at)) };
            row.push(scene.insert(&body).unwrap());
            right -= half + half + Fx::from_bits(r.below(2 << 16) as i32);
            (side, whole) = (side.min(half + half), whole + half + half);
        }
        let driver = *row.last().unwrap();
        let speed = fx!(0.1) + Fx::from_bits(r.below(side.to_bits().into()) as i32);
        let x = |scene: &Swept, at: Handle| scene.body(at).unwrap().shape.position().x;
        let mut deepest = Fx::ZERO;
        for _ in 0..200 {
            let own = scene.body(driver).unwrap().velocity;
            scene.set_velocity(driver, Vec2::new(speed, own.y)).unwrap();
            step_with(&mut scene, &level, Vec2::new(Fx::ZERO, gravity), &mut |_| Reply::Meet, &mut |_| ()).unwrap();
            deepest = row.iter().map(|&body| depth(&scene, body)).fold(deepest, Fx::max);
            let in_order = row.windows(2).all(|two| x(&scene, two[1]) < x(&scene, two[0]));
            assert!(in_order, "case {case}: one has passed another");
        }
        let length = fx!(192) - scene.body(driver).unwrap().shape.aabb().min().x;
        assert!(deepest < fx!(0.02), "case {case}: {deepest} deep");
        (runs, pressed) = (runs + 1, pressed + u64::from(length < whole + fx!(0.1)));
    }
    // A light driver may need longer to bring heavy bodies together.
    assert!(pressed * 10 > runs * 9, "{pressed} of {runs}");
}

/// A heavy ball presses a light box against a tile. Its direction is nearly up: in one image the
/// box took it for the tile's, in the other one not.
#[test]
fn what_presses_a_box_up_has_a_mirror_image() {
    let ended = |shift: i32, mirrored: bool| {
        let text = if mirrored { "...#........." } else { ".........#..." };
        let origin = Vec2::from_ints(if mirrored { -208 } else { 0 }, 0);
        let level = TileMap::from_ascii(text, &KINDS).unwrap().with_origin(origin).unwrap();
        let seen = |x: i32, y: i32| Vec2::from_raw(if mirrored { -x } else { x }, y);
        let (a, b) = (seen(9_092_958, 1 << 20), seen(9_816_815, 1_459_495));
        let crate_ = Aabb::new(Vec2::new(a.x.min(b.x), a.y), Vec2::new(a.x.max(b.x), b.y)).unwrap();
        let centre = seen(9_830_844 + shift, 1_898_899);
        let heavy = SceneBody {
            velocity: seen(-44_481, -122_129),
            mass: NonZeroU8::new(97),
            surface: Surface::ELASTIC,
            ..SceneBody::new(ball(centre.x, centre.y, Fx::from_bits(443_718)), 20)
        };
        let mut scene = Swept::new(SortSweep::new());
        scene.insert(&heavy).unwrap();
        let light = scene.insert(&SceneBody::new(crate_, 18)).unwrap();
        scene.step(&level, Vec2::ZERO, |_| {}).unwrap();
        let body = scene.body(light).unwrap();
        let middle = body.shape.aabb().min() + body.shape.aabb().max();
        (seen(middle.x.to_bits(), middle.y.to_bits()), seen(body.velocity.raw().0, body.velocity.raw().1))
    };
    for shift in (-20_000..20_000).step_by(50) {
        assert_eq!(ended(shift, false), ended(shift, true), "{shift}");
    }
}
