//! A round ninja runs up slopes and quarter pipes, slides down walls and jumps from them, until a
//! mine goes off below it. Run it with `cargo run --release --example ninja [-- FILE.png]`.
//!
//! `tilesat_games::ninja` is the game: one circle, a few numbers, and `Mover::move_and_slide`. It
//! also has the level and the player's keys. The ragdoll and the rope over a corner are points
//! joined by sticks. This file draws the way to `target/ninja.png`.
#![allow(unreachable_pub, reason = "a program has no public interface; `pub` marks items that its other files use")]
#![allow(
    clippy::std_instead_of_core,
    clippy::float_arithmetic,
    clippy::cast_precision_loss,
    reason = "drawing, on a desktop"
)]

use std::process::ExitCode;

use tilesat::{Circle, RangeError, World};
use tilesat_games::ninja::{Ninja, Script, State, Sticks, level, ragdoll, rope};
use tilesat_tools::fail::{Fail, Result};
use tilesat_tools::picture::ink::{BOUNCE, COIN, CONTACT, CROSS, Ink, PLAYER, SLIDE, TOUCH};
use tilesat_tools::picture::sketch::{self, Sketch};

/// A minute is enough for every script.
const FRAMES: u32 = 3600;

fn main() -> ExitCode {
    sketch::exit("ninja", play())
}

fn play() -> Result<()> {
    let level = level::map().map_err(|e| Fail::new(e.to_string()))?;
    let mut ninja = Ninja::new(level::START).map_err(|e| Fail::new(e.to_string()))?;
    let mut script = Script::new();
    let mut sketch = Sketch::new(&level, level::SIZE, 2);
    let (mut way, mut fastest, mut frame) = (vec![ninja.body.centre()], 0, 0);
    while let Some(keys) = script.keys(&ninja)
        && frame < FRAMES
    {
        let was = (ninja.state, ninja.jumps);
        ninja.step(&level, keys).map_err(|e| Fail::new(format!("frame {frame}: {e}")))?;
        if level.overlaps_circle(&ninja.body) {
            return Err(Fail::new(format!("frame {frame}: inside the level")));
        }
        fastest = fastest.max(ninja.velocity.length().to_bits());
        frame += 1;
        way.push(ninja.body.centre());
        if ninja.state != was.0 {
            sketch.way(&way, 2.5, ink(was.0));
            way.drain(..way.len() - 1);
        }
        if ninja.jumps != was.1 {
            sketch.dot(ninja.body.centre(), COIN);
        }
        if frame % 8 == 0 {
            sketch.ring(ninja.body.centre(), 6.0, 1.0, ink(ninja.state).alpha(0.45));
        }
    }
    sketch.way(&way, 2.5, ink(ninja.state));
    sketch.ring(ninja.body.centre(), 6.0, 3.0, PLAYER);
    let fell = settle(&level, ragdoll(&ninja), FRAMES, &mut sketch)?;
    let swung = settle(&level, rope(level::NAIL), 60, &mut sketch)?;
    let summary = format!(
        "frames={frame} jumps={} wall_jumps={} fastest={:.2} done={} ragdoll_at_rest_after={fell} rope_after={swung}",
        ninja.jumps,
        ninja.wall_jumps,
        f64::from(fastest) / 65536.0,
        script.is_done()
    );
    println!("{summary}");
    let legend = "green: on a floor; blue: along a wall; violet: in the air; yellow dots: jumps; a ring every 8 frames; white: limbs every 10 frames, and a rope";
    sketch.save("ninja.png", &[summary, legend.to_owned()])?;
    if script.is_done() { Ok(()) } else { Err(Fail::new("the script did not end")) }
}

/// Moves points until they lie still. Draws the first frames and the last. Returns the number of
/// frames.
fn settle<const N: usize, const L: usize>(
    level: &impl World,
    points: std::result::Result<Sticks<N, L>, RangeError>,
    drawn: u32,
    sketch: &mut Sketch,
) -> Result<u32> {
    let mut points = points.map_err(|e| Fail::new(e.to_string()))?;
    for frame in 0..FRAMES {
        let lies = points.step(level).map_err(|e| Fail::new(format!("frame {frame} of points: {e}")))?;
        let mut discs = points.points.iter().filter_map(|point| Circle::new(point.position, points.radius).ok());
        if discs.any(|disc| level.overlaps_circle(&disc)) {
            return Err(Fail::new(format!("frame {frame}: a point is inside the level")));
        }
        if lies || frame % 10 == 0 && frame < drawn {
            let (width, ink) = if lies { (3.0, CONTACT) } else { (1.2, CONTACT.alpha(0.4)) };
            for link in &points.links {
                let ends = [link.a, link.b].map(|k| points.points[usize::from(k)].position);
                sketch.way(&ends, width, ink);
            }
        }
        if lies {
            return Ok(frame);
        }
    }
    Err(Fail::new("points do not come to rest"))
}

fn ink(state: State) -> Ink {
    match state {
        State::Floor => BOUNCE,
        State::Wall => SLIDE,
        State::Ceiling => TOUCH,
        State::Air => CROSS,
    }
}
