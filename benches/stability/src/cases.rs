//! The scenes: those of the stability table, and the long runs.

use crate::random::starts;
use crate::scene::{Order, PX, Point, Scene, Shape, Start, Tiles};

/// What the cells of a table show for a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Runs on a flat floor: ghosts, speed, pops.
    Floor,
    /// Falls into a corner: does it come to rest?
    Valley,
    /// A number of elastic bounces: the energy after them.
    Bounces,
    /// Bounces with this restitution in 1/256: escapes, energy, depth.
    LongRun(i32),
}

pub struct Case {
    pub kind: Kind,
    pub scene: Scene,
    pub starts: Vec<Start>,
}

/// 1/6 pixel per frame per frame.
const GRAVITY: i32 = 10922;

pub fn all() -> Vec<Case> {
    let mut cases = vec![floor(Order::Forward, false), floor(Order::Backward, false)];
    cases.extend([floor(Order::Forward, true), floor(Order::Backward, true)]);
    cases.extend([mild(), even(), polygon(), boxes()]);
    for bounce in [256, 128] {
        cases.extend([box_room("box slow, no gravity", 0, 2, bounce), box_room("box fast, no gravity", 0, 12, bounce)]);
        cases.extend([box_room("box, gravity", GRAVITY, 2, bounce), valley(bounce)]);
    }
    cases
}

fn px(corners: &[Point]) -> Vec<Point> {
    corners.iter().map(|p| p.map(|c| c * PX)).collect()
}

/// 3.37 pixels per frame over an endless floor of 24-pixel pieces, or of tiles.
fn floor(order: Order, walker: bool) -> Case {
    const ROWS: &str = include_str!("levels/floor.txt");
    let backward = order == Order::Backward;
    let name = match (walker, backward) {
        (false, false) => "ball on a floor, pieces left to right",
        (false, true) => "ball on a floor, pieces right to left",
        (true, false) => "box on a floor, tiles left to right",
        (true, true) => "box on a floor, tiles right to left",
    };
    let scene = Scene {
        name,
        room: px(&[[-576, 0], [576, 0], [576, -240], [-576, -240]]),
        piece: 24 * PX,
        order,
        tiles: Some(Tiles { rows: ROWS, cell: 24 * PX, origin: [-576 * PX, -48 * PX] }),
        shape: if walker { Shape::Box([10 * PX; 2]) } else { Shape::Ball(10 * PX) },
        bounce: 0,
        gravity: GRAVITY,
        period: 240 * PX,
        lowest: -10.0,
    };
    Case { kind: Kind::Floor, scene, starts: vec![Start { centre: [0, -10 * PX], velocity: [220_856, 0] }] }
}

/// 45 degrees on both sides. 16 balls fall in.
fn even() -> Case {
    const ROWS: &str = include_str!("levels/even.txt");
    let scene = Scene {
        name: "ball in a V of 45/45 degrees",
        room: px(&[[-96, -96], [96, -96], [0, 0]]),
        piece: i32::MAX,
        order: Order::Forward,
        tiles: Some(Tiles { rows: ROWS, cell: 24 * PX, origin: [-120 * PX; 2] }),
        shape: Shape::Ball(10 * PX),
        bounce: 0,
        gravity: GRAVITY,
        period: 0,
        lowest: -10.0 * 2.0_f64.sqrt(),
    };
    Case { kind: Kind::Valley, starts: starts(&scene, 0x5145, 16, -96 * PX, 4 * PX), scene }
}

/// 45 degrees on the left, 26.57 on the right.
fn mild() -> Case {
    const ROWS: &str = include_str!("levels/mild.txt");
    let scene = Scene {
        name: "ball in a V of 45/26.57 degrees",
        room: px(&[[-96, -96], [192, -96], [0, 0]]),
        piece: i32::MAX,
        order: Order::Forward,
        tiles: Some(Tiles { rows: ROWS, cell: 24 * PX, origin: [-120 * PX; 2] }),
        shape: Shape::Ball(10 * PX),
        bounce: 0,
        gravity: GRAVITY,
        period: 0,
        // Ten from both: x - y = 10 sqrt 2 and -x - 2 y = 10 sqrt 5.
        lowest: -10.0 * (2.0_f64.sqrt() + 5.0_f64.sqrt()) / 3.0,
    };
    Case { kind: Kind::Valley, starts: starts(&scene, 0x5126, 16, -96 * PX, 4 * PX), scene }
}

/// Elastic bounces in a room of 24 walls. No wall follows a lattice direction.
fn polygon() -> Case {
    let corner = |i: i32| {
        let angle = (f64::from(i) + 0.37) / 24.0 * std::f64::consts::TAU;
        [angle.cos(), angle.sin()].map(|c| (c * 64.0 * f64::from(PX)) as i32)
    };
    let scene = Scene {
        name: "ball, elastic, room of 24 walls",
        room: (0..24).map(corner).collect(),
        piece: i32::MAX,
        order: Order::Forward,
        tiles: None,
        shape: Shape::Ball(10 * PX),
        bounce: 256,
        gravity: 0,
        period: 0,
        lowest: 0.0,
    };
    Case { kind: Kind::Bounces, starts: starts(&scene, 0x5124, 2, i32::MIN, 7 * PX), scene }
}

/// Elastic bounces of a box between tiles.
fn boxes() -> Case {
    let Case { mut scene, .. } = box_room("box, elastic, room of tiles", 0, 7, 256);
    scene.shape = Shape::Box([8 * PX, 11 * PX]);
    Case { kind: Kind::Bounces, starts: starts(&scene, 0x51b0, 2, 0, 7 * PX), scene }
}

/// A ball of 8 pixels in a room of 256 by 256.
fn box_room(name: &'static str, gravity: i32, speed: i32, bounce: i32) -> Case {
    const ROWS: &str = include_str!("levels/room.txt");
    let scene = Scene {
        name,
        room: px(&[[0, 0], [256, 0], [256, 256], [0, 256]]),
        piece: i32::MAX,
        order: Order::Forward,
        tiles: Some(Tiles { rows: ROWS, cell: 16 * PX, origin: [-16 * PX; 2] }),
        shape: Shape::Ball(8 * PX),
        bounce,
        gravity,
        period: 0,
        lowest: 248.0,
    };
    let seed = 0xe000 + 0x10 * u64::from(gravity > 0) + speed as u64;
    Case { kind: Kind::LongRun(bounce), starts: starts(&scene, seed, 16, 0, speed * PX), scene }
}

/// The same ball in a valley of 45 degrees whose arms are 256 pixels long, under a lid.
fn valley(bounce: i32) -> Case {
    const ROWS: &str = include_str!("levels/valley.txt");
    // 256 / sqrt 2, made a multiple of 8 even cells: 3 raw less.
    const CELL: i32 = 1_482_910;
    const LEG: i32 = 8 * CELL;
    let scene = Scene {
        name: "45-degree valley, gravity",
        room: vec![[-LEG, -LEG], [LEG, -LEG], [0, 0]],
        piece: i32::MAX,
        order: Order::Forward,
        tiles: Some(Tiles { rows: ROWS, cell: CELL, origin: [-LEG - CELL, -LEG - CELL] }),
        shape: Shape::Ball(8 * PX),
        bounce,
        gravity: GRAVITY,
        period: 0,
        lowest: -8.0 * 2.0_f64.sqrt(),
    };
    Case { kind: Kind::LongRun(bounce), starts: starts(&scene, 0xe045, 16, i32::MIN, 2 * PX), scene }
}
