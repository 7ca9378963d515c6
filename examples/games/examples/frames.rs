//! Runs some frames of the platformer's 33 bodies and prints the hash of their positions.
//! `.ci/miri` compares this line between this computer and the machines that Miri interprets.

use std::process::ExitCode;

use tilesat_games::platformer::flash;

const FRAMES: u32 = 12;

fn main() -> ExitCode {
    match flash::run(FRAMES, |_, _| {}) {
        Ok(outcome) => {
            println!("{outcome}");
            ExitCode::SUCCESS
        }
        Err(failure) => {
            eprintln!("no run: {failure:?}");
            ExitCode::FAILURE
        }
    }
}
