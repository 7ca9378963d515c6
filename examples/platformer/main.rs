//! A character plays through a Tiled level, together with 32 boxes and balls.
//!
//! `cargo run --release --example platformer -- --help` lists the options. The game is
//! `tilesat_games::platformer::sim`, which runs unchanged on a microcontroller
//! (`examples/firmware.rs`). `tilesat_tools` reads the level, checks every body in every frame
//! (`tools/src/play`) and draws the picture. `tilesat play` does the same with any level.
#![allow(clippy::std_instead_of_core, reason = "this part runs on a desktop")]

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, io};

use tilesat_tools::cli::play::{self, Program};

fn main() -> ExitCode {
    let program = Program { name: "platformer", levels: ["meadow", "ninja"].map(own).to_vec(), picture: picture() };
    ExitCode::from(play::run(&program, env::args_os().skip(1), &mut io::stdout(), &mut io::stderr()))
}

/// A level beside this file, by its name.
fn own(name: &'static str) -> (&'static str, PathBuf) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("platformer/levels");
    (name, folder.join(name).with_extension("tmx"))
}

/// The default path of the picture: the target folder, three levels above the program.
fn picture() -> Option<PathBuf> {
    let exe = env::current_exe().ok()?;
    Some(exe.ancestors().nth(3)?.join("platformer.png"))
}
