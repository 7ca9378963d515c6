//! Piles of any shapes in a scene.

use super::{Any, FRUSTUM, GRAVITY, HEXAGON, NOOKS, PIT, PLAIN, SLOPE, Table, V};
use super::{bodies, boxed, capsule, level, map, polygon, rough, turned};
use tilesat::broad::SortSweep;
use tilesat::scene::{SceneBody, SceneTag, Sleep};
use tilesat::{AllShapes, Scene, Surface, TileMap, Vec2};

const BODIES: usize = 12;
type Near = SortSweep<BODIES, SceneTag>;
type Plain = Scene<Near, BODIES, 0, Any>;
type Remembering = Scene<Near, BODIES, { BODIES + 16 }, Any>;

pub fn run(table: &mut Table) {
    let (pit, slope, v) = (level(&PIT), level(&SLOPE), level(&V));
    let (pit, slope, v) = (map(&pit), map(&slope), map(&v));
    for (surface, of) in [(Surface::SLICK, "slick"), (rough(), "rough")] {
        let mut pile = |name: &str, level: &TileMap<AllShapes>, shapes: &[Any]| {
            every(table, &format!("{name}, {of}"), level, shapes, surface);
        };
        let boxes: Vec<Any> = (0..8).map(|i| boxed(900 + 7 * i, 60 + 170 * i, 160 - 9 * i, 160).into()).collect();
        pile("8 boxes, a stack", &pit, &boxes);
        let flat: Vec<Any> = (0..6).map(|i| turned((1000 + 5 * i, 300 + 180 * i), (90, 70), (1, 0)).into()).collect();
        pile("6 turned boxes, a stack", &pit, &flat);
        let mixed: Vec<Any> = vec![
            capsule((940, 1300), (1060, 1300), 80).into(),
            boxed(900, 1000, 200, 120).into(),
            polygon((1000, 820), &FRUSTUM).into(),
            turned((1000, 600), (80, 60), (0, 1)).into(),
            polygon((1000, 400), &HEXAGON).into(),
        ];
        pile("a stack of five shapes", &pit, &mixed);
        pile("hexagon and box, V", &v, &[polygon((768, 300), &HEXAGON).into(), boxed(728, 60, 80, 80).into()]);
        for (nook, rows, y) in NOOKS {
            let drawn = level(rows);
            for (what, body) in bodies((768, y)) {
                pile(&format!("{what} in a scene, {nook}"), &map(&drawn), &[body]);
            }
        }
        let two = [turned((400, 1400), (120, 40), (4, 3)).into(), turned((1400, 1400), (90, 50), (-5, 12)).into()];
        pile("turned boxes on a floor", &pit, &two);
    }
    let capsules = [
        capsule((1024, 300), (1024, 420), 60).into(),
        Any::from(capsule((560, 640), (680, 580), 60)),
        turned((1500, 100), (90, 50), (3, -1)).into(),
    ];
    every(table, "two capsules and a turned box on a slope, rough", &slope, &capsules, rough());
}

fn every(table: &mut Table, name: &str, level: &TileMap<AllShapes>, shapes: &[Any], surface: Surface) {
    let awake = Plain::with_sleep(Near::new(), Sleep::NEVER);
    one(table, name, PLAIN, level, filled(awake, shapes, surface));
    let remembering = Remembering::remembering(Near::new(), Sleep::NEVER);
    one(table, name, "memory", level, filled(remembering, shapes, surface));
    one(table, name, "sleep", level, filled(Plain::new(Near::new()), shapes, surface));
}

fn filled<const M: usize>(
    mut scene: Scene<Near, BODIES, M, Any>,
    shapes: &[Any],
    surface: Surface,
) -> Scene<Near, BODIES, M, Any> {
    for (shape, key) in shapes.iter().zip(1..) {
        scene.insert(&SceneBody { surface, ..SceneBody::of(*shape, key) }).expect("room for all");
    }
    scene
}

fn one<const M: usize>(
    table: &mut Table,
    name: &str,
    way: &str,
    level: &TileMap<AllShapes>,
    mut scene: Scene<Near, BODIES, M, Any>,
) {
    let state = |scene: &Scene<Near, BODIES, M, Any>, all: &mut Vec<(Any, Vec2)>| {
        all.clear();
        all.extend(scene.bodies().map(|(_, body)| (body.shape, body.velocity)));
    };
    let mut start = Vec::new();
    state(&scene, &mut start);
    table.row(name, way, start, |all| {
        scene.step(level, GRAVITY, |_| ()).expect("inside the domain");
        state(&scene, all);
    });
}
