//! Bodies of a scene that overlap come apart: fast ones on a floor, rows, and heavy ones at light
//! ones that the level holds.

use core::num::NonZeroU8;
use tilesat::broad::{Handle, SortSweep};
use tilesat::scene::{SceneBody, SceneTag};
use tilesat::{Aabb, Fx, Outside, Scene, TileKind, TileKinds, TileMap, Vec2, fx};
use tilesat_judge::scenes::BODIES;

type Crates = Scene<SortSweep<BODIES, SceneTag>, BODIES>;

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// Free from x = 16 to 112, above the floor at y = 32.
const ROWS: &str = "#......#\n#......#\n########";
const GRAVITY: [Vec2; 2] = [Vec2::ZERO, Vec2::new(Fx::ZERO, fx!(0.1))];

fn level() -> TileMap<'static> {
    TileMap::from_ascii(ROWS, &KINDS).unwrap().with_outside(Outside::Solid)
}

/// A crate of ten units on the floor.
fn on_floor(x: i16, mass: u8, fast: bool, key: u32) -> SceneBody {
    let shape = Aabb::from_size(Vec2::from_ints(x, 22), Vec2::from_ints(10, 10)).unwrap();
    SceneBody { mass: NonZeroU8::new(mass), fast, ..SceneBody::new(shape, key) }
}

fn left(scene: &Crates, at: Handle) -> Fx {
    scene.body(at).unwrap().shape.aabb().min().x
}

/// How deep the second of two crates is in the first.
fn overlap(scene: &Crates, a: Handle, b: Handle) -> Fx {
    left(scene, a) + fx!(10) - left(scene, b)
}

#[test]
fn fast_crates_on_a_floor_part_in_a_step() {
    for gravity in GRAVITY {
        for fast in [[true, true], [true, false], [false, true], [false, false]] {
            for shift in [3, 7, 9] {
                let mut scene = Crates::new(SortSweep::new());
                let a = scene.insert(&on_floor(50, 1, fast[0], 1)).unwrap();
                let b = scene.insert(&on_floor(50 + shift, 1, fast[1], 2)).unwrap();
                scene.step(&level(), gravity, |_| {}).unwrap();
                let depth = overlap(&scene, a, b);
                assert!(depth <= 0 && depth > fx!(-0.001), "{gravity:?} {fast:?} {shift}: {depth}");
            }
        }
    }
}

/// A body that is placed a unit farther in each step, as a walking hero is, pushes crates to the
/// wall, and there it goes no farther.
#[test]
fn nobody_is_pushed_through_a_row() {
    for fast in [false, true] {
        for (mass, of_crate) in [(1, 1), (10, 1), (255, 1), (4, 2)] {
            for crates in 1..=3_i16 {
                let what = format!("fast {fast}, masses {mass} and {of_crate}, {crates} crates");
                let mut scene = Crates::new(SortSweep::new());
                let hero = SceneBody { floats: true, ..on_floor(18, mass, fast, 1) };
                let hero = scene.insert(&hero).unwrap();
                let row = |k: i16| on_floor(40 + 14 * k, of_crate, fast, 2 + k.unsigned_abs() as u32);
                let row: Vec<_> = (0..crates).map(|k| scene.insert(&row(k)).unwrap()).collect();
                for _ in 0..400 {
                    let x = left(&scene, hero) + Fx::ONE;
                    let wall = fx!(112) - fx!(10);
                    let shape = Aabb::from_size(Vec2::new(x.min(wall), fx!(22)), Vec2::from_ints(10, 10)).unwrap();
                    scene.place(hero, shape).unwrap();
                    scene.step(&level(), GRAVITY[1], |_| {}).unwrap();
                    scene.set_velocity(hero, Vec2::ZERO).unwrap();
                    for pair in row.windows(2) {
                        assert!(left(&scene, pair[0]) < left(&scene, pair[1]), "{what}: order");
                    }
                    let depth = overlap(&scene, hero, row[0]);
                    assert!(depth < 3, "{what}: {depth} units in the first crate");
                }
                // Each of three receives a third of the correction.
                let end = left(&scene, *row.last().unwrap());
                assert!(end > if crates < 3 { 100 } else { 80 }, "{what}: the last is at {end}");
            }
        }
    }
}

/// How deep a heavy crate comes into a light one at a wall, and that it leaves it.
#[test]
fn heavy_crates_stay_out_of_light_ones_at_a_wall() {
    for gravity in GRAVITY {
        for mass in [1, 2, 4, 10, 50, 255] {
            for speed in [fx!(0.25), fx!(0.5), fx!(1), fx!(2)] {
                let what = format!("mass {mass}, speed {speed}, {gravity:?}");
                let mut scene = Crates::new(SortSweep::new());
                let heavy = SceneBody { velocity: Vec2::new(speed, Fx::ZERO), ..on_floor(70, mass, false, 1) };
                let heavy = scene.insert(&heavy).unwrap();
                let light = scene.insert(&on_floor(102, 1, false, 2)).unwrap();
                let mut slept = false;
                for _ in 0..2000 {
                    scene.step(&level(), gravity, |_| {}).unwrap();
                    let depth = overlap(&scene, heavy, light);
                    assert!(depth <= speed * 2, "{what}: {depth} deep");
                    slept |= scene.awake().is_empty();
                }
                let depth = overlap(&scene, heavy, light);
                let most = if gravity == Vec2::ZERO { fx!(0.03125) } else { speed * 2 };
                assert!(slept && depth <= most, "{what}: asleep {slept}, {depth} deep at the end");
            }
        }
    }
}
