//! Fast bodies rest less than a raw unit from what holds them. They sleep and wake with it all the
//! same.

use core::num::NonZeroU8;
use tilesat::broad::SortSweep;
use tilesat::motion::Surface;
use tilesat::scene::{SceneBody, SceneTag};
use tilesat::{Aabb, Circle, Fx, Joined, Ratio, Scene, Solid, Solids, TileKind, TileKinds, TileMap, Vec2, fx};
use tilesat_judge::scenes::BODIES;

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
const GRAVITY: Vec2 = Vec2::from_raw(0, 1 << 14);

type Small = Scene<SortSweep<BODIES, SceneTag>, BODIES>;

fn aabb(x: i16, y: i16, width: i16, height: i16) -> Aabb {
    Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + width, y + height)).unwrap()
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Loss {
    Pushed,
    Sinks,
    Removed,
    FloorGone,
}

/// A fast ball leans on a wall and on another ball, on a lift. Both sleep, and the ball below goes.
#[test]
fn a_fast_ball_falls_when_what_it_leans_on_goes() {
    let text = "#..........\n".repeat(6);
    let level = TileMap::from_ascii(&text, &KINDS).unwrap();
    let rough = Surface::new(Ratio::ZERO, Ratio::percent(60).unwrap());
    for loss in [Loss::Pushed, Loss::Sinks, Loss::Removed, Loss::FloorGone] {
        let (mut leant, mut apart) = (0, 0);
        for i in 0..40 {
            let (low, high) = (Fx::from_bits((1 << 16) + i * 1511), Fx::from_bits((4 << 16) + i * 557));
            let mut lift = [Solid::new(aabb(10, 70, 50, 4), 1).unwrap()];
            let mut scene = Small::new(SortSweep::new());
            let at = Vec2::new(fx!(21) + Fx::from_bits(i * 3163), fx!(70) - low);
            let below = SceneBody {
                surface: rough,
                mass: NonZeroU8::new(255),
                ..SceneBody::new(Circle::new(at, low).unwrap(), 1)
            };
            let ball = Circle::new(Vec2::new(fx!(16) + high, fx!(55)), high).unwrap();
            let above = SceneBody { surface: rough, fast: true, ..SceneBody::new(ball, 2) };
            let (below, above) = (scene.insert(&below).unwrap(), scene.insert(&above).unwrap());
            let step = |scene: &mut Small, lift: &[Solid]| {
                scene.step(&Joined::new(&level, &Solids::new(lift)), GRAVITY, |_| {}).unwrap();
            };
            for _ in 0..400 {
                step(&mut scene, &lift);
            }
            assert!(scene.awake().is_empty());
            let rest = scene.body(above).unwrap().shape;
            if rest.aabb().max().y > fx!(69.9) {
                continue; // it rolled over, onto the lift
            }
            leant += 1;
            apart += u32::from(!tilesat::query::Touches::touches(&rest, &scene.body(below).unwrap().shape));
            match loss {
                Loss::Pushed => scene.set_velocity(below, Vec2::from((3, 0))).unwrap(),
                Loss::Removed => drop(scene.remove(below).unwrap()),
                Loss::FloorGone => scene.wake_region(&lift[0].shape()),
                Loss::Sinks => {}
            }
            for _ in 0..25 {
                if loss == Loss::Sinks {
                    lift[0].set_motion(Vec2::from((0, 1))).unwrap();
                    scene.ride(&level, &mut lift, GRAVITY, fx!(4), |_, _| {}).unwrap();
                }
                step(&mut scene, if loss == Loss::FloorGone { &[] } else { &lift });
            }
            assert!(scene.body(above).unwrap().shape.aabb().min().y > rest.aabb().min().y, "{loss:?} {i}");
        }
        assert!(leant > 20 && apart > 20, "{loss:?}: {leant} {apart}");
    }
}

/// A fast crate follows a body that sinks slowly, up to a raw unit above it, and does not fall
/// asleep alone.
#[test]
fn a_fast_crate_does_not_sleep_on_what_sinks_below_it() {
    let text = "............\n".repeat(10) + "############\n";
    let level = TileMap::from_ascii(&text, &KINDS).unwrap();
    for (mass, gap) in [(255, 0), (255, -1), (100, -1), (50, -2), (100, 0), (20, 1)] {
        for gravity in [Vec2::from_raw(0, 6554), GRAVITY] {
            let mut scene = Small::new(SortSweep::new());
            let top = aabb(40, 20, 20, 10).translated(Vec2::from_raw(0, gap)).unwrap();
            let balloon = SceneBody { floats: true, mass: NonZeroU8::new(mass), ..SceneBody::new(top, 1) };
            let crate_ = SceneBody { fast: true, ..SceneBody::new(aabb(44, 10, 10, 10), 2) };
            let (balloon, crate_) = (scene.insert(&balloon).unwrap(), scene.insert(&crate_).unwrap());
            for step in 0..600 {
                scene.step(&level, gravity, |_| {}).unwrap();
                let [upper, lower] = [crate_, balloon].map(|at| scene.body(at).unwrap().shape.aabb());
                let hangs = lower.min().y - upper.max().y > fx!(0.01);
                assert!(!(hangs && (step == 599 || !scene.is_awake(crate_).unwrap())), "{mass} {gap} {gravity} {step}");
            }
        }
    }
}

/// A fast crate on another one, both asleep: it falls when the game sends that away.
#[test]
fn a_fast_crate_wakes_with_what_carries_it() {
    let text = "............\n".repeat(4) + "############\n";
    let level = TileMap::from_ascii(&text, &KINDS).unwrap();
    for height in 0..40 {
        let mut scene = Small::new(SortSweep::new());
        let lower = scene.insert(&SceneBody::new(aabb(40, 54, 20, 10), 1)).unwrap();
        let drop = aabb(44, 30, 10, 10).translated(Vec2::from_raw(0, height * 7919)).unwrap();
        let upper = scene.insert(&SceneBody { fast: true, ..SceneBody::new(drop, 2) }).unwrap();
        for _ in 0..200 {
            scene.step(&level, GRAVITY, |_| {}).unwrap();
        }
        assert!(scene.awake().is_empty() && scene.is_supported(upper).unwrap(), "{height}");
        let rest = scene.body(upper).unwrap().shape.aabb();
        scene.set_velocity(lower, Vec2::from((4, 0))).unwrap();
        for _ in 0..30 {
            scene.step(&level, GRAVITY, |_| {}).unwrap();
        }
        assert!(scene.body(upper).unwrap().shape.aabb().max().y > rest.max().y, "{height}");
    }
}
