//! Crates on a floor that a hero pushes: a row at a wall yields little more than one step of the
//! hero, nothing passes a crate there, and a row that is free moves on.

use super::steps::{Swept, step_with};
use core::num::NonZeroU8;
use tilesat::broad::{Handle, SortSweep};
use tilesat::scene::{Reply, SceneBody};
use tilesat::{Aabb, Fx, Ratio, Surface, TileKind, TileKinds, TileMap, Vec2, fx};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
const SIDE: i16 = 16;
/// The floor is at y = 48, the wall at x = 400.
const FLOOR: i16 = 48;
const WALL: i16 = 400;
const LEVEL: &str = concat!(
    "#........................#\n",
    "#........................#\n",
    "#........................#\n",
    "##########################",
);

fn level() -> TileMap<'static> {
    TileMap::from_ascii(LEVEL, &KINDS).unwrap()
}

fn on_floor(x: Fx) -> Aabb {
    Aabb::from_size(Vec2::new(x, Fx::from(FLOOR - SIDE)), Vec2::from_ints(SIDE, SIDE)).unwrap()
}

/// How the hero moves.
#[derive(Clone, Copy, Debug, PartialEq)]
enum By {
    /// The game sets its velocity in each step.
    Velocity,
    /// The game places it, as it does with the body of a `Character`.
    Place,
}

/// A hero and a row of crates to the right of it. The hero is the first.
struct Row {
    scene: Swept,
    all: Vec<Handle>,
    what: String,
}

impl Row {
    /// A hero of this place and mass, and crates of these masses from a first place on.
    fn new((at, hero): (i16, u8), (first, gap): (i16, i16), crates: &[u8], friction: u8) -> Self {
        let surface = Surface::new(Ratio::ZERO, Ratio::percent(friction).unwrap());
        let mut scene = Swept::new(SortSweep::new());
        let body =
            |x: i16, mass, key| SceneBody { mass: NonZeroU8::new(mass), ..SceneBody::new(on_floor(x.into()), key) };
        let mut all = vec![scene.insert(&body(at, hero, 1)).unwrap()];
        for (&mass, k) in crates.iter().zip(0_i16..) {
            let body = SceneBody { surface, ..body(first + k * (SIDE + gap), mass, 2 + k as u32) };
            all.push(scene.insert(&body).unwrap());
        }
        Self { scene, all, what: format!("hero {hero}, crates {crates:?}, friction {friction}, gap {gap}") }
    }

    fn left(&self, at: usize) -> Fx {
        self.scene.body(self.all[at]).unwrap().shape.position().x
    }

    /// Returns how far the hero comes.
    fn step(&mut self, level: &TileMap<'_>, by: By, speed: Fx, gravity: Fx) -> Fx {
        let (hero, x) = (self.all[0], self.left(0));
        let down = self.scene.body(hero).unwrap().velocity.y;
        if by == By::Place {
            self.scene.place(hero, on_floor(x + speed)).unwrap();
        }
        let along = if by == By::Place { Fx::ZERO } else { speed };
        self.scene.set_velocity(hero, Vec2::new(along, down)).unwrap();
        let gravity = Vec2::new(Fx::ZERO, gravity);
        step_with(&mut self.scene, level, gravity, &mut |_| Reply::Meet, &mut |_| ()).unwrap();
        self.left(0) - x
    }

    /// The deepest overlap of two neighbours. They must be in order.
    fn deepest(&self) -> Fx {
        let depth = |at: usize| self.left(at) + Fx::from(SIDE) - self.left(at + 1);
        let deepest = (0..self.all.len() - 1).map(depth).max().unwrap();
        assert!(deepest < Fx::from(SIDE), "{}: one has passed another", self.what);
        deepest
    }
}

#[test]
fn a_row_at_a_wall_yields_little_more_than_a_step() {
    let level = level();
    for gravity in [fx!(0.05), fx!(0.25), fx!(0.6)] {
        for mass in [1, 20, 255] {
            for speed in [fx!(0.5), fx!(1), fx!(2), fx!(4)] {
                // At a quarter of a crate per step, rows of eight yield two steps.
                for crates in if speed < 4 { [1, 2, 3, 5, 8].as_slice() } else { &[1, 2, 3, 5] } {
                    let first = WALL - SIDE * *crates as i16;
                    let mut row = Row::new((first - 40, mass), (first, 0), &[1].repeat(*crates), 0);
                    let mut late = Fx::ZERO;
                    for step in 0..400 {
                        row.step(&level, By::Velocity, speed, gravity);
                        let depth = row.deepest();
                        late = if step < 300 { late } else { late.max(depth) };
                    }
                    assert!(late <= speed * 5 / 4, "{}, speed {speed}, gravity {gravity}: {late} deep", row.what);
                }
            }
        }
    }
}

/// A heavy crate between light ones stays between them.
#[test]
fn nothing_passes_a_crate_at_a_wall() {
    let level = level();
    let rows: [&[u8]; 9] = [
        &[1, 6, 1],
        &[1, 20, 1],
        &[1, 50, 1],
        &[1, 255, 1],
        &[2, 10, 2],
        &[50, 255, 50],
        &[1, 10, 10, 1],
        &[1, 10, 1, 1],
        &[10, 1, 10, 1],
    ];
    for masses in rows {
        for hero in [1, 4, 20, 255] {
            for speed in [fx!(0.5), fx!(1), fx!(3)] {
                for by in [By::Velocity, By::Place] {
                    let first = WALL - SIDE * masses.len() as i16;
                    let mut row = Row::new((first - 40, hero), (first, 0), masses, 0);
                    row.what = format!("{}, speed {speed} by {by:?}", row.what);
                    for _ in 0..400 {
                        row.step(&level, by, speed, fx!(0.25));
                        row.deepest();
                    }
                }
            }
        }
    }
}

#[test]
fn a_row_on_a_free_floor_moves_without_a_halt() {
    let level = level();
    for gravity in [fx!(0.1), fx!(0.25), fx!(0.6)] {
        for mass in [1, 10, 255] {
            for speed in [fx!(0.6), fx!(1.5), fx!(4)] {
                for (crates, gap) in [(1, 0), (3, 0), (3, 9), (6, 0)] {
                    let mut row = Row::new((20, mass), (40, gap), &[1].repeat(crates), 0);
                    row.what = format!("{}, speed {speed}, gravity {gravity}", row.what);
                    let mut halts = 0;
                    while row.left(crates) < fx!(380) {
                        halts += u32::from(row.step(&level, By::Place, speed, gravity) <= 0);
                        assert!(row.deepest() <= speed * 2, "{}", row.what);
                    }
                    // Only when the hero meets the row.
                    assert!(halts <= 1, "{}: {halts} halts", row.what);
                }
            }
        }
    }
}

/// Friction slows a row down, and does not stop it.
#[test]
fn a_row_with_friction_moves_on() {
    let level = level();
    for (crates, friction, gravity, least) in [
        (1, 100, fx!(0.25), 95),
        (2, 100, fx!(0.25), 95),
        (2, 50, fx!(0.25), 50),
        (2, 20, fx!(0.25), 75),
        (3, 20, fx!(0.25), 65),
        (3, 20, fx!(0.6), 50),
        (5, 20, fx!(0.25), 65),
    ] {
        let mut row = Row::new((50, 255), (80, 0), &[1].repeat(crates), friction);
        let way: Vec<Fx> = (0..200).map(|_| row.step(&level, By::Velocity, Fx::ONE, gravity)).collect();
        let late: Fx = way[100..].iter().sum();
        assert!(late > least, "{}: {late} units in 100 steps", row.what);
    }
}
