//! Long runs of a ball and of a box, with this library, textbook code, parry2d and rapier2d.
//!
//! ```text
//! cargo run --profile unlinked -p tilesat-stability                              all scenes, 10^5 frames: a minute on two cores
//! cargo run --profile unlinked -p tilesat-stability -- --full                    10^6 frames: ten minutes
//! cargo run --profile unlinked -p tilesat-stability --features rapier            rapier2d too
//! ... -- --scene gravity --column tilesat --frames 1000000                                      a part; --list tells the names
//! ```
//!
//! It prints Markdown tables and draws the energy of the elastic scenes (`stability/energy.svg` in
//! the target directory). It fails if this library misses a promise: nothing lost, nothing inside,
//! no ghosts, rest in corners. Without gravity a body is never faster than at the start, and keeps
//! at least 0.9 of its energy at restitution 1. `results.md` has the reviewed tables of 10^6
//! frames. Nothing is timed.
//!
//! # How to read it
//!
//! - A *ghost* is a frame on a flat floor that changed the sideways speed. A *pop* is a height
//!   above the floor.
//! - *Escape*: the centre is two radii beyond the contact position. The run ends there. Ours also
//!   counts a refusal of the mover.
//! - *Deepest*: how far the body was in a wall after a frame, in pixels (a raw unit is 1.5e-5),
//!   until it escaped. The judge uses f64 on exact positions. Below 1e-7 it prints 0.
//! - *Energy*: v^2 / 2 + g h, with h above the lowest position of the centre. With gravity and
//!   restitution 1 it walks at random in every engine that applies gravity once per frame: a bounce
//!   falls at some moment of a frame. The number format does not matter there. *Energy renewed* is
//!   our mover in a game that sets the speed from the height in frames with a hit.
//! - A run ends after a frame that changed neither position nor velocity, because the engine has no
//!   other state. Runs of rapier2d always go to the end.
//!
//! # The columns
//!
//! | column | engine |
//! |---|---|
//! | tilesat, tiles | `Mover` on a `TileMap`; bounces with a `Surface` and a `Speed` |
//! | tilesat, segments | the same on a `SegmentMap` of the walls that all others have |
//! | tilesat, clipped in turn | our sweeps; clips the velocity at one plane after the other |
//! | naive Q16.16 | moves, then pushes out of each wall; cuts products to 32 bits at once |
//! | ... walls cut to 64 px | the same; avoids the overflow of squares at 181 px |
//! | textbook f32 | the same in f32 |
//! | parry2d contact | the same with `query::contact` (parry2d 0.31.1, f32) instead of formulas |
//! | parry2d cast | `query::cast_shapes`, respond, go on, four times; then the same push-out |
//! | rapier2d (CCD) | rapier2d 0.36.1, f32: length unit 32, 60 steps per second |
//!
//! # Honest limits
//!
//! - Peers run as a small game would call them, without their authors' advice. A skin around the
//!   cast, one polyline instead of segments, or contact filters would remove some of the ghosts.
//!   The scenes have one body in one convex room, and no crowds or inner corners.
//! - The starts are not those of any published table. So the digits differ from it, but the same
//!   engines fail.
//! - A median over 16 starts of a random walk is not a mean. With gravity, read the ranges.

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
    println!("{} frames (bounces of the elastic rooms) per run.", options.frames);
    for kind in [Kind::Floor, Kind::Valley, Kind::Bounces, Kind::LongRun(256), Kind::LongRun(128)] {
        print!("{}", table::of(kind, &cases, &columns, &results));
    }
    let mut misses = Vec::new();
    for (case, row) in cases.iter().zip(&results) {
        // Clipping in turn is here to fail visibly.
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

/// The picture goes into the build's own directory.
fn picture() -> PathBuf {
    let own = || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../target"));
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(own, PathBuf::from).join("stability/energy.svg")
}
