//! A game seen from above: no gravity, no "up", eight directions, and doors that pull. Run it with
//! `cargo run --release --example top_down [-- FILE.png]`.
//!
//! Two heroes get the same keys. One only slides along walls. The other also slips around corners
//! that it barely catches (`tilesat_games::top_down`). The picture, `target/top_down.png`, shows
//! both ways.
#![allow(unreachable_pub, reason = "a program has no public interface; `pub` marks items that its other files use")]
#![allow(
    clippy::std_instead_of_core,
    clippy::float_arithmetic,
    clippy::cast_precision_loss,
    reason = "drawing, on a desktop"
)]

use std::process::ExitCode;

use tilesat_games::top_down::{Hero, KEYS, SIZE, START, rooms};
use tilesat_tools::fail::{Fail, Result};
use tilesat_tools::picture::ink::{BOUNCE, KILL};
use tilesat_tools::picture::sketch::{self, Sketch};

fn main() -> ExitCode {
    sketch::exit("top_down", play())
}

fn play() -> Result<()> {
    let level = rooms().map_err(|e| Fail::new(e.to_string()))?;
    let mut sketch = Sketch::new(&level, SIZE, 2);
    let mut lines = Vec::new();
    for (slip, ink, name) in
        [(0, KILL, "red: slides only"), (6, BOUNCE, "green: also slips around corners, up to 6 pixels")]
    {
        let mut hero = Hero::new(START, slip).map_err(|e| Fail::new(e.to_string()))?;
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
