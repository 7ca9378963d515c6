//! A run of hours: 10^9 frames and 10^10 answers, each judged exactly. You can stop it at any time,
//! and it continues from there.
//!
//! ```text
//! cargo run --profile checked -p tilesat-soak                               all of it, on two cores
//! cargo run --profile checked -p tilesat-soak -- --minutes 15 --threads 1   a quarter of an hour of it
//! ... -- --class tiny --queries 1e8 --frames 0 --levels 0 --pairs 0 --state /tmp/tiny.txt   a part; --list tells the names
//! ... -- --pairs 1e7 --queries 0 --frames 0 --levels 0                                      all pairs of the six shapes
//! ... -- --lattice quads5                        instead: all pairs of quadrangles of a lattice of 5 by 5 points
//! ... -- --rest 1e6                              instead: bodies and piles at rest, a million frames of each
//! ```
//!
//! Every few seconds it prints a line with progress, speed and the time left, and saves the
//! counters. At the end it prints a Markdown table. At the first wrong answer it prints the input,
//! and the command fails. It also fails if a judge disagrees with big rationals.
//!
//! # What it checks
//!
//! - **Pairs**: each pair of shapes in nine classes, then seven times with every number moved by up
//!   to 2 raw. It checks `overlaps` and `touches` in both orders, `contact` (depth exactly the
//!   ceiling, free after the push) and `distance` (exactly the floor). It checks `would_hit` and
//!   `cast_shape` with a motion through, from or to the position. The judge ([`quick`]) answers in
//!   128-bit integers. The judges of the tests check one pair and cast in 256 as well. They know
//!   axes, points, positions and the exact floor of the time.
//! - **Pairs of all six shapes** ([`convex`]), also of capsules, oriented boxes and polygons, in
//!   ten classes, then three times with every number moved by up to a raw unit. It checks the same
//!   answers, and `overlaps_from` with the hint of the last pair. The 256-bit judge of the tests
//!   checks one in a thousand, with manifolds and closest points too.
//! - **Lattices** ([`lattice`]): every pair of triangles or quadrangles of a lattice.
//! - **Rest** ([`rest`]): no body at rest ever moves again.
//! - **Frames**: circles and boxes at up to 60 px per frame, in cells of 16. They move in random
//!   worlds of all 34 shapes and one-way edges, with all responses, elastic ones too. No overlap
//!   after a frame, no gain of speed, and a free way to the first contact at each sixteenth of the
//!   motion. The tests' judge checks block worlds: exact first moments and sides, and a body never
//!   leaves its room.
//! - **Levels**: random TMX files through the reader of the level tools. It compares them tile by
//!   tile, and bodies move in them.
//!
//! # Honest limits
//!
//! In levels of all shapes the judge checks only the ends of legs after the first contact. In
//! levels of blocks it checks the room. It looks at tiles only at each sixteenth. It could miss
//! something thinner than a sixteenth of a frame's motion.

mod convex;
mod frames;
mod lattice;
mod options;
mod queries;
mod quick;
mod report;
mod rest;
mod room;
mod selftest;
mod state;
mod tmx;
mod work;

use options::Options;
use state::State;
use std::process::ExitCode;
use std::time::{Duration, Instant};

fn main() -> ExitCode {
    match options::parse(std::env::args().skip(1)) {
        Ok(Some(options)) => run(&options).unwrap_or_else(|why| {
            eprintln!("{why}");
            ExitCode::FAILURE
        }),
        Ok(None) => {
            report::names();
            ExitCode::SUCCESS
        }
        Err(text) => {
            eprintln!("{text}");
            ExitCode::FAILURE
        }
    }
}

/// How often it saves and prints the counters.
const TELL: Duration = Duration::from_secs(10);

fn run(options: &Options) -> Result<ExitCode, String> {
    // A wrong answer is printed with its input. The judge's own position in the code is of no
    // interest.
    std::panic::set_hook(Box::new(|what| eprintln!("{what}")));
    selftest::judge(options.seed)?;
    if let Some(name) = &options.lattice {
        return lattice::run(name).map(|()| ExitCode::SUCCESS);
    }
    if options.rest > 0 {
        return Ok(if rest::run(options.rest) { ExitCode::SUCCESS } else { ExitCode::FAILURE });
    }
    let mut state = if options.fresh { State::new(options.seed) } else { State::load(&options.state, options.seed)? };
    let scratch = options::target().join("soak");
    std::fs::create_dir_all(&scratch).map_err(|e| format!("{}: {e}", scratch.display()))?;
    let plan = work::Plan::new(options, &scratch);
    let (began, before) = (Instant::now(), state.clone());
    let mut told = began;
    loop {
        let saved = state.clone();
        let jobs = plan.round(options, &mut state);
        let late = options.minutes > 0 && began.elapsed() >= Duration::from_secs(60 * options.minutes);
        if jobs.is_empty() || late {
            state = saved;
            break;
        }
        if let Err(job) = plan.run(options, &mut state, &jobs) {
            eprintln!("WRONG in {job:?} of seed {}: see the input above", options.seed);
            saved.save(&options.state)?;
            return Ok(ExitCode::FAILURE);
        }
        state.seconds = before.seconds + began.elapsed().as_secs_f64();
        if told.elapsed() >= TELL {
            told = Instant::now();
            report::progress(options, &before, &state, began.elapsed().as_secs_f64());
            state.save(&options.state)?;
        }
    }
    state.save(&options.state)?;
    report::progress(options, &before, &state, began.elapsed().as_secs_f64());
    report::table(&state);
    Ok(ExitCode::SUCCESS)
}
