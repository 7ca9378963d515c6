//! A run of hours: 10^9 frames and 10^10 answers, each judged exactly, that can be stopped at any
//! time and goes on where it was.
//!
//! ```text
//! cargo run --profile checked -p tilesat-soak                               all of it, on two cores
//! cargo run --profile checked -p tilesat-soak -- --minutes 15 --threads 1   a quarter of an hour of it
//! ... -- --class tiny --queries 1e8 --frames 0 --levels 0 --state /tmp/tiny.txt             a part; --list tells the names
//! ```
//!
//! Every few seconds one line tells what is done, how fast, and when it will be over; the counters
//! are saved with it. At the end a Markdown table follows. The first wrong answer is printed with
//! its input, and the command fails; so does a judge that disagrees with big rationals.
//!
//! # What is asked
//!
//! - **Pairs**: each pair of shapes in nine classes, every number then moved by up to 2 raw seven
//!   times. `overlaps` and `touches` in both orders, `contact` (depth exactly the ceiling, free
//!   after the push), `distance` (exactly the floor), `would_hit` and `cast_shape` by a motion
//!   through, from or to the place. The judge ([`quick`]) answers in 128-bit integers. One pair and
//!   cast in 256 goes to the judges of the tests as well, which know axes, points, the exact floor
//!   of the time and places.
//! - **Frames**: circles and boxes up to 60 px a frame (in cells of 16) in random worlds of all 34
//!   shapes and one-way edges, all responses, elastic ones too: no overlap after a frame, never
//!   faster, and the way to the first contact free at each sixteenth of the motion. Block worlds
//!   are judged by the tests' judge: exact first moments and sides, and a body never leaves its
//!   room.
//! - **Levels**: random TMX files through the reader of the level tools, compared tile by tile and
//!   played in.
//!
//! # Honest limits
//!
//! Legs after the first contact are judged by their ends in levels of all shapes, and by rooms in
//! levels of blocks. Tiles at the moment of a sixteenth only; what is thinner than that and missed
//! between two of them would have to be thinner than a sixteenth of a frame's motion.

mod frames;
mod options;
mod queries;
mod quick;
mod report;
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

/// How often the counters are saved and told.
const TELL: Duration = Duration::from_secs(10);

fn run(options: &Options) -> Result<ExitCode, String> {
    // A wrong answer is told with its input; where the judge asked is of no interest.
    std::panic::set_hook(Box::new(|what| eprintln!("{what}")));
    selftest::judge(options.seed)?;
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
