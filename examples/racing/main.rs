//! A race seen from above, of shapes that turn. Run it with `cargo run --release --example racing
//! [-- FILE.png]`.
//!
//! `tilesat_games::racing` is the game. The car is an oriented box that steers with `motion::turn`
//! and shoves other oriented boxes. A marshal, who is a capsule, walks through a turnstile that
//! turns and pushes. After each frame nothing may overlap. At the end the car has made three laps,
//! the marshal its rounds. The picture, `target/racing.png`, shows both ways.
#![allow(clippy::std_instead_of_core, clippy::float_arithmetic, reason = "drawing, on a desktop")]

use std::process::ExitCode;

use tilesat::prelude::*;
use tilesat::{AllShapes, OrientedBox, TileMap};
use tilesat_games::racing::{Race, SIZE, track};
use tilesat_tools::fail::{Fail, Result};
use tilesat_tools::picture::ink::{BOUNCE, COIN, CROSS, Ink, KILL, SLIDE};
use tilesat_tools::picture::sketch::{self, Sketch};

const FRAMES: u32 = 1800;

fn main() -> ExitCode {
    sketch::exit("racing", play())
}

fn play() -> Result<()> {
    let level = track().map_err(|e| Fail::new(e.to_string()))?;
    let mut race = Race::new().map_err(|e| Fail::new(e.to_string()))?;
    let (start, mut sketch) = (race, Sketch::new(&level, SIZE, 3));
    let (mut car, mut marshal) = (Vec::new(), Vec::new());
    for frame in 0..FRAMES {
        race.step(&level).map_err(|e| Fail::new(format!("frame {frame}: {e}")))?;
        if let Some(fault) = fault(&race, &level) {
            return Err(Fail::new(format!("frame {frame}: {fault}")));
        }
        car.push(race.car.body.centre());
        marshal.push(race.marshal.a());
        if frame % 20 == 0 {
            outline(&mut sketch, &race.car.body, 1.0, BOUNCE.alpha(0.5));
        }
    }
    sketch.way(&car, 1.5, BOUNCE);
    sketch.way(&marshal, 1.5, SLIDE);
    outline(&mut sketch, &race.car.body, 3.0, BOUNCE);
    outline(&mut sketch, &race.plank, 3.0, CROSS);
    for end in [race.marshal.a(), race.marshal.b()] {
        sketch.ring(end, race.marshal.radius().to_num(), 2.0, SLIDE);
    }
    for (from, to) in start.crates.iter().zip(&race.crates) {
        outline(&mut sketch, from, 1.0, COIN.alpha(0.6));
        outline(&mut sketch, to, 3.0, KILL);
    }
    let shoved = start.crates.iter().zip(&race.crates).all(|(from, to)| from != to);
    let (marks, rounds, moved) = (race.car.marks, race.rounds, race.moved);
    let summary = format!("frames={FRAMES} marks={marks} shoves={} rounds={rounds} moved={moved}", race.car.shoves);
    println!("{summary}");
    if !shoved || marks < 12 || rounds < 10 || moved < 100 {
        return Err(Fail::new("expected three laps, ten rounds, a turnstile that pushes and three moved crates"));
    }
    sketch.save("racing.png", &[summary])
}

/// What is inside of the level or of another body.
fn fault(race: &Race, level: &TileMap<'_, AllShapes>) -> Option<&'static str> {
    let [a, b, c] = race.crates;
    let boxes = [race.car.body, race.plank, a, b, c];
    if boxes.iter().any(|b| level.overlaps(b)) || level.overlaps(&race.marshal) {
        return Some("a body is inside the level");
    }
    let meets = |(i, a): (usize, &OrientedBox)| boxes.iter().skip(i + 1).any(|b| a.overlaps(b));
    let inside = boxes.iter().enumerate().any(meets) || boxes.iter().any(|b| b.overlaps(&race.marshal));
    inside.then_some("two bodies overlap")
}

fn outline(sketch: &mut Sketch, body: &OrientedBox, width: f32, ink: Ink) {
    let [a, b, c, d] = body.corners();
    sketch.way(&[a, b, c, d, a], width, ink);
}
