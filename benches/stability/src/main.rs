//! What long runs do to a ball and to a box: this library beside textbook code, parry2d and
//! rapier2d.
//!
//! ```text
//! cargo run --profile unlinked -p tilesat-stability                              all scenes, 10^5 frames: a minute on two cores
//! cargo run --profile unlinked -p tilesat-stability -- --full                    10^6 frames: ten minutes
//! cargo run --profile unlinked -p tilesat-stability --features rapier            rapier2d too
//! ... -- --scene gravity --column tilesat --frames 1000000                                      a part; --list tells the names
//! ```
//!
//! It prints Markdown tables, draws the energy of the elastic scenes (`stability/energy.svg` in the
//! target directory), and fails where this library misses what it promises: nothing lost, nothing
//! inside, no ghosts, rest in corners, and without gravity never faster than at the start with at
//! least 0.9 of the energy kept at restitution 1. The reviewed tables of 10^6 frames are in
//! `results.md`. Nothing is timed.
//!
//! # How to read it
//!
//! - A *ghost* is a frame on a flat floor that changed the sideways speed. A *pop* is a height
//!   above the floor.
//! - *Escape*: the centre is two radii beyond where it would touch; the run ends there. Ours also
//!   where the mover refuses to move.
//! - *Deepest*: how far the body was in a wall after a frame, in pixels (a raw unit is 1.5e-5),
//!   until it escaped. The judge is f64 on exact positions; below 1e-7 is 0.
//! - *Energy*: v^2 / 2 + g h, h above the lowest place that the centre can have. With gravity and
//!   restitution 1 it walks at random in every engine that gives gravity once per frame, because a
//!   bounce falls somewhere into a frame: the number format has no part in that. *Energy renewed*
//!   is our mover in a game that sets the speed from the height in frames with a hit.
//! - A run whose frame changed neither position nor velocity is over: nothing but these is
//!   remembered (rapier2d's runs are made to the end).
//!
//! # The columns
//!
//! | column | what |
//! |---|---|
//! | tilesat, tiles | `Mover` on a `TileMap`; bounces with a `Surface` and a `Speed`, at rest below gravity / (1 - restitution) |
//! | tilesat, segments | the same on a `SegmentMap` of the walls that all others have |
//! | tilesat, clipped in turn | our sweeps, but the velocity clipped at one plane after the other, as Quake did |
//! | naive Q16.16 | move, then push out of wall after wall by closest point, normal and depth; products cut to 32 bits at once |
//! | ... walls cut to 64 px | the same, spared the overflow of squares at 181 px |
//! | textbook f32 | the same in f32 |
//! | parry2d contact | the same with `query::contact` (parry2d 0.31.1, f32) instead of formulas |
//! | parry2d cast | `query::cast_shapes` to the first hit, respond, go on, four times; then the same push-out |
//! | rapier2d (CCD) | rapier2d 0.36.1, f32: length unit 32, 60 steps per second, rotation locked, no sleep, no friction |
//!
//! # Honest limits
//!
//! - Peers are called as a small game would, without their authors' advice: a skin around the cast,
//!   one polyline instead of segments, or contact filters would remove some of the ghosts. One
//!   body, one room, convex: what crowds and corners do is not here.
//! - The starts are not those of any published table; the numbers differ from it in their digits,
//!   not in what fails.
//! - Medians over 16 starts of a random walk are not means: with gravity read the ranges.

mod cases;
mod chart;
mod engine;
mod engines;
mod goals;
mod level;
mod options;
mod random;
mod room;
mod runs;
mod scene;
mod table;
mod watch;

use cases::{Case, Kind};
use engines::{COLUMNS, Column};
use options::{Options, chosen};
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    match options::parse(std::env::args().skip(1)) {
        Ok(Some(options)) => run(&options),
        Ok(None) => {
            cases::all().iter().for_each(|case| println!("scene   {}", case.scene.name));
            COLUMNS.iter().for_each(|column| println!("column  {}", column.name));
            ExitCode::SUCCESS
        }
        Err(text) => {
            eprintln!("{text}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> ExitCode {
    let mut cases: Vec<Case> = cases::all();
    cases.retain(|case| chosen(case.scene.name, &options.scenes));
    cases.iter_mut().for_each(|case| case.starts.truncate(options.starts));
    let columns: Vec<Column> = COLUMNS.iter().copied().filter(|column| chosen(column.name, &options.columns)).collect();
    let results = runs::all(&cases, &columns, options.frames, options.threads);
    println!("{} frames (bounces of the elastic rooms) a run.", options.frames);
    for kind in [Kind::Floor, Kind::Valley, Kind::Bounces, Kind::LongRun(256), Kind::LongRun(128)] {
        print!("{}", table::of(kind, &cases, &columns, &results));
    }
    let mut misses = Vec::new();
    for (case, row) in cases.iter().zip(&results) {
        // Clipping in turn is there to be seen failing.
        for (column, cell) in
            columns.iter().zip(row).filter(|(c, _)| c.name.starts_with("tilesat") && !c.name.contains("clip"))
        {
            misses.extend(goals::missed(case, column.name, cell));
        }
    }
    misses.iter().for_each(|line| eprintln!("MISSED {line}"));
    let file = picture();
    let svg = chart::svg(&cases, &columns, &results);
    if let Err(error) = file.parent().map_or(Ok(()), std::fs::create_dir_all).and_then(|()| std::fs::write(&file, svg))
    {
        eprintln!("{}: {error}", file.display());
        return ExitCode::FAILURE;
    }
    eprintln!("picture: {}", file.display());
    if misses.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Where the picture goes: the build's own directory.
fn picture() -> PathBuf {
    let own = || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../target"));
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(own, PathBuf::from).join("stability/energy.svg")
}
