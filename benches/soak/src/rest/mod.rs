//! Long rests: capsules on slopes, polygons in nooks, oriented boxes, and piles of any shapes.
//!
//! Each run plays a million frames, without sleep and memory, and again with them. Once a frame has
//! returned its own bodies and velocities, every later frame must do the same: period 1, nothing
//! moves and nothing gains.

mod alone;
mod piles;

use std::fmt::Debug;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::time::Instant;
use tilesat::shape::AnyShape;
use tilesat::{Aabb, AllShapes, Axis, Capsule, ConvexPolygon, Fx, Mover, OrientedBox, Ratio, Surface, TileMap, Vec2};
use tilesat_judge::convex::shape::MOST;
use tilesat_judge::rooms::drawn;
use tilesat_judge::shapes::level::Level;

type Any = AnyShape<MOST>;

const UP: Mover = Mover::platformer(Axis::NEG_Y);
/// A raw gravity, of a tenth of a unit per frame squared.
const GRAVITY: Vec2 = Vec2::from_raw(0, 6_554);
/// Everything is at rest before this frame.
const LATEST: u64 = 4_000;

/// What a run found.
struct Found {
    /// The first frame that returned its own state.
    from: Option<u64>,
    /// Later frames that did not.
    moves: u64,
    hash: u64,
}

/// Plays `frames` frames of a state that `step` changes.
fn play<T: Clone + PartialEq + Debug>(frames: u64, mut state: T, mut step: impl FnMut(&mut T)) -> Found {
    let mut next = state.clone();
    let mut found = Found { from: None, moves: 0, hash: 0 };
    for frame in 0..frames {
        step(&mut next);
        if next == state {
            found.from = found.from.or(Some(frame));
            continue;
        }
        found.moves += u64::from(found.from.is_some() || frame >= LATEST);
        if found.moves == 1 {
            eprintln!("frame {frame}: {state:?} to {next:?}");
        }
        state.clone_from(&next);
    }
    let mut hasher = DefaultHasher::new();
    format!("{state:?}").hash(&mut hasher);
    found.hash = hasher.finish();
    found
}

/// The rows of the table, and whether all are right.
struct Table {
    frames: u64,
    right: bool,
    /// The hash of the last run without sleep and memory.
    plain: u64,
}

impl Table {
    /// Plays a run and prints its row. Its end must be that of the first way of the same `name`.
    fn row<T: Clone + PartialEq + Debug>(&mut self, name: &str, way: &str, state: T, step: impl FnMut(&mut T)) {
        let began = Instant::now();
        let found = play(self.frames, state, step);
        if way == PLAIN {
            self.plain = found.hash;
        }
        let right = found.from.is_some_and(|from| from < LATEST) && found.moves == 0 && found.hash == self.plain;
        self.right &= right;
        let from = found.from.map_or("never".into(), |from| from.to_string());
        println!(
            "| {name} | {way} | {} | {from} | {} | {:016x} | {:.0} |{}",
            self.frames,
            found.moves,
            found.hash,
            began.elapsed().as_secs_f64(),
            if right { "" } else { " WRONG" }
        );
    }
}

const PLAIN: &str = "off";

/// All runs. Returns whether everything stayed at rest.
pub fn run(frames: u64) -> bool {
    let mut table = Table { frames, right: true, plain: 0 };
    println!(
        "| at rest | sleep and memory | frames | from frame | moves after it | hash | seconds |\n|---|---|---|---|---|---|---|"
    );
    alone::run(&mut table);
    piles::run(&mut table);
    table.right
}

const SHAPES: [(char, u8); 8] = [('/', 8), ('\\', 9), ('l', 20), ('h', 24), ('L', 21), ('H', 25), ('s', 29), ('S', 33)];

/// The whole slope rises by one in two, to the right.
const SLOPE: [&str; 7] = ["........", "........", "........", "......lh", "....lh##", "..lh####", "lh######"];
const V: [&str; 6] = ["......", "......", r"\..../", r"#\../#", r"##\/##", "######"];
const UNEVEN_V: [&str; 6] = ["......", "......", "......", r"\...lh", r"#\lh##", "######"];
const STEEP_V: [&str; 7] = ["......", "......", "......", ".S..s.", ".#Ss#.", ".####.", "######"];
/// Their names, and a height over them.
const NOOKS: [(&str, &[&str], i32); 3] =
    [("V", V.as_slice(), 240), ("uneven V", UNEVEN_V.as_slice(), 300), ("steep V", STEEP_V.as_slice(), 300)];
const PIT: [&str; 7] = ["#......#", "#......#", "#......#", "#......#", "#......#", "#......#", "########"];

fn level(rows: &[&str]) -> Level {
    drawn(rows, 16 << 16, &SHAPES)
}

fn map(level: &Level) -> TileMap<'_, AllShapes> {
    level.all()
}

fn at(x: i32, y: i32) -> Vec2 {
    Vec2::from_raw(x << 12, y << 12)
}

/// Coordinates are in sixteenths of a unit here, and in the next two.
fn capsule(a: (i32, i32), b: (i32, i32), radius: i32) -> Capsule {
    Capsule::new(at(a.0, a.1), at(b.0, b.1), Fx::from_bits(radius << 12)).expect("small")
}

fn turned(centre: (i32, i32), half: (i32, i32), direction: (i32, i32)) -> OrientedBox {
    OrientedBox::new(at(centre.0, centre.1), at(half.0, half.1), Axis::new(direction.0, direction.1)).expect("small")
}

fn polygon(centre: (i32, i32), corners: &[(i32, i32)]) -> ConvexPolygon<MOST> {
    let corners: Vec<_> = corners.iter().map(|p| at(centre.0 + p.0, centre.1 + p.1)).collect();
    ConvexPolygon::hull(&corners).expect("small")
}

fn boxed(left: i32, top: i32, width: i32, height: i32) -> Aabb {
    Aabb::new(at(left, top), at(left + width, top + height)).expect("small")
}

/// Friction of seven tenths: bodies rest on a slope of one in two.
fn rough() -> Surface {
    Surface::new(Ratio::ZERO, Ratio::percent(70).expect("below one"))
}

const HEXAGON: [(i32, i32); 6] = [(-80, 0), (-40, -70), (40, -70), (80, 0), (40, 70), (-40, 70)];
const ODD: [(i32, i32); 5] = [(-77, 5), (-31, -66), (52, -49), (83, 20), (3, 71)];
const TRIANGLE: [(i32, i32); 3] = [(-90, -50), (90, -61), (7, 83)];
const FRUSTUM: [(i32, i32); 4] = [(-60, -50), (60, -50), (90, 50), (-90, 50)];

/// One of each kind around a point.
fn bodies(at: (i32, i32)) -> [(&'static str, Any); 6] {
    let round = polygon(at, &ODD).with_radius(Fx::from_bits(20 << 12)).expect("small");
    [
        ("hexagon", polygon(at, &HEXAGON).into()),
        ("polygon", polygon(at, &ODD).into()),
        ("triangle", polygon(at, &TRIANGLE).into()),
        ("round polygon", round.into()),
        ("turned box", turned(at, (90, 50), (4, 3)).into()),
        ("capsule", capsule((at.0 - 48, at.1), (at.0 + 32, at.1), 60).into()),
    ]
}
