//! Crates on a floor that a hero pushes: a row at a wall yields no more than one step of the hero,
//! and a row that is free moves without a halt.

use super::steps::{Swept, step_with};
use core::num::NonZeroU8;
use tilesat::broad::{Handle, SortSweep};
use tilesat::scene::{Reply, SceneBody};
use tilesat::{Aabb, Fx, TileKind, TileKinds, TileMap, Vec2, fx};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
const SIDE: i16 = 16;
/// The floor is at y = 48, the wall at x = 400.
const FLOOR: i16 = 48;
const WALL: i16 = 400;

fn level(text: &str) -> TileMap<'_> {
    TileMap::from_ascii(text, &KINDS).unwrap()
}

fn text() -> String {
    format!("#{}#\n", ".".repeat(24)).repeat(3) + &"#".repeat(26)
}

/// A hero at `x` of this mass, and a row of crates of mass 1 to the right of it. The first is the
/// hero.
fn row(scene: &mut Swept, (x, mass): (i16, u8), first: i16, crates: usize, gap: i16) -> Vec<Handle> {
    let at = |x| Aabb::from_size(Vec2::from_ints(x, FLOOR - SIDE), Vec2::from_ints(SIDE, SIDE)).unwrap();
    let hero = SceneBody { mass: NonZeroU8::new(mass), ..SceneBody::new(at(x), 1) };
    let mut all = vec![scene.insert(&hero).unwrap()];
    for k in 0..crates as i16 {
        let body = SceneBody::new(at(first + k * (SIDE + gap)), k as u32 + 2);
        all.push(scene.insert(&body).unwrap());
    }
    all
}

fn left(scene: &Swept, at: Handle) -> Fx {
    scene.body(at).unwrap().shape.position().x
}

/// The deepest overlap of two neighbours. They must be in order.
fn deepest(scene: &Swept, row: &[Handle], what: &str) -> Fx {
    let depth = |two: &[Handle]| left(scene, two[0]) + Fx::from(SIDE) - left(scene, two[1]);
    let deepest = row.windows(2).map(depth).max().unwrap();
    assert!(deepest < Fx::from(SIDE), "{what}: one has passed another");
    deepest
}

#[test]
fn a_row_at_a_wall_yields_no_more_than_a_step() {
    let text = text();
    let level = level(&text);
    for gravity in [fx!(0.05), fx!(0.25), fx!(0.6)] {
        for mass in [1, 20, 255] {
            for speed in [fx!(0.5), fx!(1), fx!(2), fx!(4), fx!(7)] {
                for crates in [1, 2, 3, 5, 8] {
                    let what = format!("gravity {gravity}, mass {mass}, speed {speed}, {crates} crates");
                    let mut scene = Swept::new(SortSweep::new());
                    let first = WALL - SIDE * crates as i16;
                    let row = row(&mut scene, (first - 40, mass), first, crates, 0);
                    let mut late = Fx::ZERO;
                    for step in 0..400 {
                        let own = scene.body(row[0]).unwrap().velocity;
                        scene.set_velocity(row[0], Vec2::new(speed, own.y)).unwrap();
                        let down = Vec2::new(Fx::ZERO, gravity);
                        step_with(&mut scene, &level, down, &mut |_| Reply::Meet, &mut |_| ()).unwrap();
                        let depth = deepest(&scene, &row, &what);
                        late = if step < 300 { late } else { late.max(depth) };
                    }
                    // What a crate tries comes on top.
                    assert!(late <= speed + speed / 64, "{what}: {late} deep");
                }
            }
        }
    }
}

/// The hero is placed in each step, as a `Character` with a position of its own is.
#[test]
fn a_row_on_a_free_floor_moves_without_a_halt() {
    let text = text();
    let level = level(&text);
    for gravity in [fx!(0.1), fx!(0.25), fx!(0.6)] {
        for mass in [1, 10, 255] {
            for speed in [fx!(0.6), fx!(1.5), fx!(4)] {
                for (crates, gap) in [(1, 0), (3, 0), (3, 9), (6, 0)] {
                    let what = format!("gravity {gravity}, mass {mass}, speed {speed}, {crates} crates, gap {gap}");
                    let mut scene = Swept::new(SortSweep::new());
                    let row = row(&mut scene, (20, mass), 40, crates, gap);
                    let mut halts = 0;
                    while left(&scene, row[crates]) < fx!(380) {
                        let (x, own) = (left(&scene, row[0]), scene.body(row[0]).unwrap().velocity);
                        let to = Vec2::new(x + speed, Fx::from(FLOOR - SIDE));
                        scene.place(row[0], Aabb::from_size(to, Vec2::from_ints(SIDE, SIDE)).unwrap()).unwrap();
                        scene.set_velocity(row[0], Vec2::new(Fx::ZERO, own.y)).unwrap();
                        let down = Vec2::new(Fx::ZERO, gravity);
                        step_with(&mut scene, &level, down, &mut |_| Reply::Meet, &mut |_| ()).unwrap();
                        let made = left(&scene, row[0]) - x;
                        halts += u32::from(made <= 0);
                        assert!(deepest(&scene, &row, &what) <= speed * 2, "{what}");
                    }
                    // Only when the hero meets the row.
                    assert!(halts <= 1, "{what}: {halts} halts");
                }
            }
        }
    }
}
