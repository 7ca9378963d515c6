//! Looks for mistakes in a level before it is baked.
//!
//! `cargo run --release --example lint -- --help` says what it takes.
#![allow(unreachable_pub, reason = "a program has no outside; `pub` marks what other files of it use")]
#![allow(clippy::std_instead_of_core, reason = "this part runs on a desktop")]
#![allow(clippy::indexing_slicing, reason = "indices are those of lists that were built together")]

pub(crate) mod args;
pub(crate) mod check;
mod crossings;
mod edges;
pub(crate) mod finding;
pub(crate) mod geometry;
mod index;
#[allow(dead_code, reason = "shared with other programs")]
#[path = "../level_io/mod.rs"]
pub(crate) mod level_io;
mod nesting;
mod outlines;
mod pockets;
mod reach;
mod surface;

use std::env;
use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;

use args::{Command, Options};
use finding::Severity;
use level_io::fail::{Fail, Result};

fn main() -> ExitCode {
    let args = env::args_os().skip(1);
    ExitCode::from(run(args, &mut io::stdout(), &mut io::stderr()))
}

/// The whole program but for the process around it; returns the exit status.
pub fn run(args: impl IntoIterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let result = args::parse(args).and_then(|command| match command {
        Command::Help => {
            tell(out, args::USAGE.trim_end());
            Ok(0)
        }
        Command::Run(options) => job(&options, out),
    });
    result.unwrap_or_else(|fail| {
        tell(err, &format!("lint: {fail}"));
        2
    })
}

fn job(options: &Options, out: &mut dyn Write) -> Result<u8> {
    let drawing = level_io::load(&options.file, options.level.as_deref())?;
    let of_file = |fail: Fail| Fail::new(format!("{}: {fail}", options.file.display()));
    let findings = check::check(&drawing, &options.rules).map_err(of_file)?;
    for finding in &findings {
        tell(out, &finding.to_string());
    }
    let count = |severity| findings.iter().filter(|finding| finding.severity == severity).count();
    let (errors, warnings, notes) = (count(Severity::Error), count(Severity::Warning), count(Severity::Note));
    let layers = drawing.tiles.layers.len();
    let outlines = drawing.outlines.len();
    tell(out, &format!("layers={layers} outlines={outlines} errors={errors} warnings={warnings} notes={notes}"));
    Ok(u8::from(errors > 0 || options.strict && warnings > 0))
}

/// One line; a closed pipe is no reason to stop.
fn tell(to: &mut dyn Write, line: &str) {
    let _ = writeln!(to, "{line}");
}
