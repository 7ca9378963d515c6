//! A game seen from above: no gravity, no "up", eight directions, doors that pull: `cargo run --release --example top_down [-- FILE.png]`.
//!
//! Two heroes get the same keys. One just slides along what it meets; the other one also slips around corners that it barely catches
//! (`hero.rs`). The picture shows where that leads: `target/top_down.png`.
#![allow(unreachable_pub, reason = "a program has no outside; `pub` marks what other files of it use")]
#![allow(
    clippy::std_instead_of_core,
    clippy::float_arithmetic,
    clippy::cast_precision_loss,
    reason = "drawing, on a desktop"
)]

#[allow(dead_code, reason = "its canvas is used here")]
#[path = "../platformer/main.rs"]
mod platformer;
#[allow(dead_code, reason = "shared by the small games")]
#[path = "../sketch/mod.rs"]
mod sketch;
#[path = "../sheet/solid.rs"]
mod solid;

mod hero;

use std::process::ExitCode;

use hero::Hero;
use platformer::fail::{Fail, Result};
use platformer::picture::ink::{BOUNCE, KILL};
use sketch::Sketch;
use tilesat::{TileKind, TileKinds, TileMap, Vec2};

/// Cells of 16 pixels; the doors are one cell wide, and so is a hero, almost.
const ROOMS: &str = "\
########################################
#.........#.............#..............#
#.........#.............#....##....##..#
#.........#....##.......#....##....##..#
#..............##.......#..............#
#.........#....................####....#
#.........#.............#......####....#
#####.#####.............#..............#
#.........#######.#######..............#
#.........#.............#######.########
#...###...#.............#..............#
#...###.................#..............#
#...###...#.....#.......#.....#..#.....#
#.........#.......................#....#
#.........#.............#..............#
########################################
";
static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);

/// Directions and for how many frames they are held.
const KEYS: [((i32, i32), u32); 13] = [
    ((1, 0), 60),
    ((1, 1), 34),
    ((1, 0), 70),
    ((0, 1), 12),
    ((1, 0), 130),
    ((1, 1), 36),
    ((1, 0), 22),
    ((0, 1), 60),
    ((-1, 1), 24),
    ((-1, 0), 100),
    ((-1, -1), 30),
    ((-1, 0), 16),
    ((0, -1), 80),
];

fn main() -> ExitCode {
    sketch::exit("top_down", play())
}

fn play() -> Result<()> {
    let level = TileMap::from_ascii(ROOMS, &KINDS).map_err(|e| Fail::new(e.to_string()))?;
    let mut sketch = Sketch::new(&level, (40 * 16, 16 * 16), 2);
    let mut lines = Vec::new();
    for (slip, ink, name) in
        [(0, KILL, "red: slides only"), (6, BOUNCE, "green: also slips around corners, up to 6 pixels")]
    {
        let start = Vec2::from_ints(24, 26);
        let mut hero = Hero::new(start, slip).map_err(|e| Fail::new(e.to_string()))?;
        let mut way = vec![hero.centre()];
        let mut blocked = 0;
        for (direction, frames) in KEYS {
            for frame in 0..frames {
                let from = hero.centre();
                hero.step(&level, direction).map_err(|e| Fail::new(format!("{name}, frame {frame}: {e}")))?;
                blocked += u32::from(hero.centre() == from);
                way.push(hero.centre());
                if frame % 10 == 0 {
                    sketch.ring(hero.centre(), 2.0, 1.5, ink.alpha(0.6));
                }
            }
        }
        sketch.way(&way, 2.0, ink);
        sketch.ring(hero.centre(), 6.0, 3.0, ink);
        lines.push(format!("{name}; blocked in {blocked} of {} frames", way.len() - 1));
    }
    for line in &lines {
        println!("{line}");
    }
    sketch.save("top_down.png", &lines)
}
