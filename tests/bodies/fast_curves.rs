//! Fast bodies on curves, in corridors and along walls, with another body in reach.

use core::num::NonZeroU8;
use tilesat::scene::{SceneBody, SortSweepScene};
use tilesat::{Aabb, AllShapes, Circle, Filter, Fx, Ratio, Surface, TileKind, TileKinds, TileMap, TileShape, Vec2, fx};
use tilesat_judge::scenes::BODIES;
use tilesat_judge::{Random, cases};

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b')', TileKind::of(TileShape::ConcaveBottomRight))
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight));

fn map(text: &'static str) -> TileMap<'static, AllShapes> {
    TileMap::of_ascii(text, &KINDS).unwrap()
}

fn ball(x: i16, y: i16, r: i16) -> Circle {
    Circle::new(Vec2::from_ints(x, y), Fx::from(r)).unwrap()
}

fn coin(x: i16, y: i16) -> SceneBody {
    let place = Aabb::from_size(Vec2::from_ints(x, y), Vec2::from_ints(8, 8)).unwrap();
    SceneBody { filter: Filter::default().with_sensor(true), ..SceneBody::fixed(place, 2) }
}

/// A wall leads into a quarter pipe without a bend. A body that falls along it goes through.
#[test]
fn fast_bodies_enter_quarter_pipes() {
    let level = map("#...#\n#...#\n#...#\n#..)#\n#####");
    for restitution in [Ratio::ZERO, Ratio::HALF, Ratio::ONE] {
        for height in 6..40 {
            let mut scene = SortSweepScene::<BODIES>::empty();
            let surface = Surface::new(restitution, Ratio::ZERO);
            let body = SceneBody { fast: true, surface, ..SceneBody::new(ball(59, height, 5), 1) };
            let handle = scene.insert(&body).unwrap();
            scene.insert(&coin(44, 40)).unwrap();
            let mut left = Fx::MAX;
            for _ in 0..80 {
                scene.step(&level, Vec2::new(Fx::ZERO, fx!(0.125)), |_| {}).unwrap();
                let now = scene.body(handle).unwrap();
                assert!(now.velocity.length() < fx!(4), "{restitution:?} from {height}: {now:?}");
                left = left.min(now.shape.position().x);
            }
            assert!(left < fx!(30), "{restitution:?} from {height}: no farther than {left}");
        }
    }
}

/// Between a floor and a ceiling that both touch it, a body only moves along them.
#[test]
fn fast_bodies_pass_tight_corridors() {
    let level = map("##########\n..........\n##########");
    for restitution in [Ratio::ZERO, Ratio::HALF, Ratio::ONE] {
        let mut scene = SortSweepScene::<BODIES>::empty();
        let surface = Surface::new(restitution, Ratio::ZERO);
        let velocity = Vec2::from_ints(1, 2);
        let body = SceneBody { fast: true, surface, velocity, ..SceneBody::new(ball(24, 24, 8), 1) };
        let handle = scene.insert(&body).unwrap();
        scene.insert(&coin(60, 20)).unwrap();
        for _ in 0..60 {
            scene.step(&level, Vec2::new(Fx::ZERO, fx!(0.125)), |_| {}).unwrap();
        }
        let now = scene.body(handle).unwrap();
        assert_eq!((now.shape.position(), now.velocity), (Vec2::from_ints(84, 24), Vec2::from_ints(1, 0)));
    }
}

/// Twice the energy of two bodies, in raw units.
fn energy(scene: &SortSweepScene<BODIES>) -> i128 {
    let of = |body: &SceneBody| {
        let (x, y) = body.velocity.raw();
        i128::from(body.mass.map_or(0, NonZeroU8::get)) * (i128::from(x).pow(2) + i128::from(y).pow(2))
    };
    scene.bodies().map(|(_, body)| of(body)).sum()
}

/// A ball presses a heavier one along a wall: the way of the heavy one is led, and its velocity is
/// only that of the hit.
#[test]
fn a_body_that_is_pressed_along_a_wall_gains_no_energy() {
    let level = map("#.......\n#.......\n#.......\n#.......\n#.......\n#.......\n#.......\n#.......");
    for fast in [true, false] {
        for aside in 0..12i16 {
            for (restitution, friction) in
                [(Ratio::ZERO, Ratio::ZERO), (Ratio::HALF, Ratio::HALF), (Ratio::ONE, Ratio::ZERO)]
            {
                let mut scene = SortSweepScene::<BODIES>::empty();
                let surface = Surface::new(restitution, friction);
                let velocity = Vec2::new(fx!(0.625), fx!(3.25));
                let place = Circle::new(Vec2::new(fx!(20) + Fx::from(aside) / 4, fx!(51.5)), fx!(4)).unwrap();
                let light = SceneBody { velocity, surface, floats: true, ..SceneBody::new(place, 1) };
                let mass = NonZeroU8::new(3);
                let heavy = SceneBody { mass, fast, floats: true, ..SceneBody::new(ball(20, 62, 4), 2) };
                scene.insert(&light).unwrap();
                scene.insert(&heavy).unwrap();
                let mut before = energy(&scene);
                for step in 0..20 {
                    scene.step(&level, Vec2::ZERO, |_| {}).unwrap();
                    let now = energy(&scene);
                    assert!(now <= before, "{aside} {restitution:?} {friction:?}, step {step}: {now} of {before}");
                    before = now;
                }
            }
        }
    }
}

/// Little of the step is left at the second surface. Its roundings are not those of the velocity.
#[test]
fn late_slides_keep_their_velocity() {
    let level = map("..........\n..........\n......../#\n##########");
    // From 64 units before the slope, and this many raw units nearer.
    for left in (1..200).chain((200..70_000).step_by(997)) {
        let mut scene = SortSweepScene::<BODIES>::empty();
        let (right, feet) = ((64 << 16) + left, (48 << 16) - (1 << 15));
        let (lo, hi) = (Vec2::from_raw(right - (4 << 16), feet - (4 << 16)), Vec2::from_raw(right, feet));
        let velocity = Vec2::from_ints(64, 1);
        let body = SceneBody { velocity, fast: true, floats: true, ..SceneBody::new(Aabb::new(lo, hi).unwrap(), 1) };
        let handle = scene.insert(&body).unwrap();
        scene.insert(&coin(100, 10)).unwrap();
        scene.step(&level, Vec2::ZERO, |_| {}).unwrap();
        let after = scene.body(handle).unwrap().velocity;
        assert!((after - Vec2::from_ints(32, -32)).length() < fx!(0.03), "{left}: {after:?}");
    }
}

/// A wedge between the ceiling and a round bumper that is a little too narrow for the ball: however
/// a ball flies into it, it comes out with its speed.
#[test]
fn elastic_bodies_leave_a_wedge_with_their_speed() {
    let level = TileMap::<AllShapes>::of_ascii("##############\n..............\n..............\n", &KINDS).unwrap();
    let surface = Surface::new(Ratio::ONE, Ratio::ZERO);
    for gap in [fx!(8), fx!(9), fx!(9.5), fx!(9.9), fx!(9.99)] {
        for case in 0..cases(400_u64) {
            let r = &mut Random::new(case);
            let mut between = |from: i64, to: i64| Fx::from_bits(((from << 16) + r.below((to - from) << 16)) as i32);
            let mut scene = SortSweepScene::<BODIES>::empty();
            let bumper = Circle::new(Vec2::new(fx!(120), fx!(24) + gap), fx!(8)).unwrap();
            scene.insert(&SceneBody { surface, ..SceneBody::fixed(bumper, 2) }).unwrap();
            let (start, aim) = (Vec2::new(fx!(50), between(22, 60)), Vec2::new(between(108, 118), between(18, 24)));
            let velocity = (aim - start).unit().scaled(between(1, 7));
            let body =
                SceneBody { fast: true, surface, velocity, ..SceneBody::new(Circle::new(start, fx!(5)).unwrap(), 1) };
            let ball = scene.insert(&body).unwrap();
            for _ in 0..300 {
                scene.step(&level, Vec2::ZERO, |_| {}).unwrap();
            }
            let (was, is) = (velocity.length(), scene.body(ball).unwrap().velocity.length());
            assert!(is > was * fx!(0.99), "gap {gap}, case {case}: {is} of {was} is left");
        }
    }
}
