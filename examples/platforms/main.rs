//! A character among moving platforms. Run it with `cargo run --release --example platforms [--
//! FILE.png]`.
//!
//! It walks over steps and slopes, rides a conveyor over a pit, waits for a crusher and takes a
//! lift. It jumps through a one-way lift, rides up and drops through the ledge there.
//! `tilesat_games::platforms` is the game with its level and script. This file draws the picture,
//! `target/platforms.png`.
#![allow(unreachable_pub, reason = "a program has no public interface; `pub` marks items that its other files use")]
#![allow(
    clippy::std_instead_of_core,
    clippy::float_arithmetic,
    clippy::cast_precision_loss,
    clippy::indexing_slicing,
    reason = "drawing, on a desktop"
)]

use std::process::ExitCode;

use tilesat::{Vec2, World, motion::Ride};
use tilesat_games::platforms::{Game, MACHINES, SCRIPT, level};
use tilesat_tools::fail::{Fail, Result};
use tilesat_tools::picture::ink::{BOUNCE, COIN, CROSS, EDGE, PLANK, SLIDE};
use tilesat_tools::picture::sketch::{self, Sketch};

/// A minute is enough.
const FRAMES: u32 = 3600;

fn main() -> ExitCode {
    sketch::exit("platforms", play())
}

fn play() -> Result<()> {
    let map = level::map().map_err(|e| Fail::new(e.to_string()))?;
    let mut game = Game::new(map, level::START).map_err(|e| Fail::new(e.to_string()))?;
    let mut sketch = Sketch::new(&game.level, level::SIZE, 2);
    for machine in &MACHINES {
        for (y, ink) in [(machine.way, EDGE.alpha(0.25)), (0, PLANK.alpha(0.8))] {
            let [x0, y0, x1, y1] = machine.at;
            let (min, max) = (sketch.spot(Vec2::from_ints(x0, y0 + y)), sketch.spot(Vec2::from_ints(x1, y1 + y)));
            sketch.scene.rect(min, (max.0 - min.0, max.1 - min.1), ink);
        }
    }
    let (mut frame, mut done, mut dropped) = (0, 0, 0);
    while let Some((keys, until)) = SCRIPT.get(done)
        && frame < FRAMES
    {
        let (from, stepped) = (game.at(), game.stepped);
        let ride = game.step(*keys).map_err(|e| Fail::new(format!("frame {frame}: {e}")))?;
        if matches!(ride, Ride::Squashed { .. }) || game.level.overlaps_aabb(&game.body) {
            return Err(Fail::new(format!("frame {frame}: squashed")));
        }
        frame += 1;
        dropped += u32::from(keys.drop);
        let at = game.at();
        let walks = if game.floor.is_some() { BOUNCE } else { CROSS };
        let ink = if ride == Ride::Carried { SLIDE } else { walks };
        sketch.way(&[from, at], 2.5, ink);
        if game.stepped != stepped {
            sketch.dot(at, COIN);
        }
        if frame % 16 == 0 {
            let (lo, hi) = (game.body.min(), game.body.max());
            sketch.way(&[lo, Vec2::new(hi.x, lo.y), hi, Vec2::new(lo.x, hi.y), lo], 1.0, ink.alpha(0.5));
        }
        done += usize::from(until(&game));
    }
    let all = done == SCRIPT.len();
    let summary = format!(
        "frames={frame} stepped={:.1} carried={} dropped={dropped} done={all}",
        game.stepped.to_num::<f32>(),
        game.carried
    );
    println!("{summary}");
    let legend =
        "green: walks; blue: is carried; violet: in the air; yellow: steps; brown: machines, and where they go";
    sketch.save("platforms.png", &[summary, legend.to_owned()])?;
    if all { Ok(()) } else { Err(Fail::new(format!("the script stopped in stretch {done}"))) }
}
