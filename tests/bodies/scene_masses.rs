//! Bodies of unequal masses: heavy ones rest on light ones, and those that touch fall like one.

use core::num::NonZeroU8;
use tilesat::broad::{Handle, SortSweep};
use tilesat::scene::{SceneBody, SceneTag, Shape};
use tilesat::{Aabb, Circle, Fx, Outside, Ratio, Scene, Surface, TileKind, TileKinds, TileMap, Vec2};
use tilesat_judge::Random;
use tilesat_judge::scenes::BODIES;

type Few = Scene<SortSweep<BODIES, SceneTag>, BODIES>;

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
const UNIT: i64 = 1 << 16;

fn raw(x: i64, y: i64) -> Vec2 {
    Vec2::from_raw(i32::try_from(x).unwrap(), i32::try_from(y).unwrap())
}

fn body(shape: impl Into<Shape>, mass: u8, restitution: u8, fast: bool, key: u32) -> SceneBody {
    let surface = Surface::new(Ratio::percent(restitution).unwrap(), Ratio::ZERO);
    SceneBody { mass: NonZeroU8::new(mass), surface, fast, ..SceneBody::new(shape, key) }
}

/// A crate of ten units at a height above the floor at y = 160.
fn over_floor(height: i64) -> Aabb {
    Aabb::from_size(raw(48 * UNIT, 150 * UNIT - height), Vec2::from_ints(10, 10)).unwrap()
}

/// A light crate that bounces on the floor meets a heavy one in every step. If it gave way each
/// time, the two would go on for ever: its bounce is all that the floor returns.
#[test]
fn heavy_crates_rest_on_light_ones() {
    let rows = "......\n".repeat(10) + "######";
    let level = TileMap::from_ascii(&rows, &KINDS).unwrap().with_outside(Outside::Solid);
    for fast in [false, true] {
        for masses in [[1, 2], [1, 4], [1, 10], [1, 50], [3, 255]] {
            for restitution in [10, 30, 40, 50] {
                for drop in [1, 3, 8] {
                    for gravity in [2000, 16_384, 40_000] {
                        let gravity = raw(0, gravity);
                        let mut scene = Few::new(SortSweep::new());
                        for (k, mass) in (0..).zip(masses) {
                            let at = over_floor(drop * UNIT + i64::from(k) * (10 + drop) * UNIT);
                            scene.insert(&body(at, mass, restitution, fast, k)).unwrap();
                        }
                        let rests = (0..1000).any(|_| {
                            scene.step(&level, gravity, |_| {}).unwrap();
                            scene.awake().is_empty()
                        });
                        assert!(rests, "fast {fast}, masses {masses:?}, {restitution} %, from {drop}, {gravity:?}");
                    }
                }
            }
        }
    }
}

/// Fast bodies on top of each other, some of which touch. None is slower than the slowest.
fn fall_together(case: u64) {
    let level = TileMap::from_ascii(".", &KINDS).unwrap();
    let mut r = Random::new(case);
    let mut scene = Few::new(SortSweep::new());
    let mut y = -6000 * UNIT;
    let bodies: Vec<Handle> = (0..r.within(2, 7))
        .map(|k| {
            let half = r.within(3 * UNIT, 9 * UNIT);
            let centre = raw(r.within(-6 * UNIT, 6 * UNIT), y - half);
            y -= 2 * half + [0, 0, 1, 5, UNIT][r.below(5) as usize];
            let shape: Shape = if r.one_in(3) {
                Circle::new(centre, Fx::from_bits(half as i32)).unwrap().into()
            } else {
                Aabb::from_centre(centre, raw(8 * UNIT, half)).unwrap().into()
            };
            let mass = [1, 1, 2, 4, 10, 50, 255][r.below(7) as usize];
            let speed = [0, 1, 5, 1000, UNIT][r.below(5) as usize];
            let velocity = raw(r.within(-speed, speed), r.within(-speed, speed));
            scene.insert(&SceneBody { velocity, ..body(shape, mass, 0, true, k as u32) }).unwrap()
        })
        .collect();
    let state = |scene: &Few| -> Vec<(i32, i32)> {
        let of = |at: &Handle| scene.body(*at).map(|body| (body.shape.position().raw().1, body.velocity.raw().1));
        bodies.iter().map(|at| of(at).unwrap()).collect()
    };
    let mut before = state(&scene);
    for frame in 0..200 {
        scene.step(&level, raw(0, 16_000), |_| {}).unwrap();
        let after = state(&scene);
        let slowest = after.iter().map(|(_, velocity)| *velocity).min().unwrap();
        for ((was, _), (is, velocity)) in before.iter().zip(&after) {
            let made = is - was;
            // Bodies that come apart from an overlap push each other.
            assert!(
                slowest < 1 << 16 || made >= slowest / 4 * 3,
                "case {case}, frame {frame}: {made} raw at {velocity}, the slowest at {slowest}"
            );
        }
        before = after;
    }
}

/// A speed of a raw unit is too low to be shared by masses of 1 and 2. Such bodies met each other
/// at the start of each step until they waited for the next one. They hung in the air.
#[test]
fn fast_bodies_that_touch_fall() {
    (0..200).for_each(fall_together);
}
