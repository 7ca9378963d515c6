//! The program `tilesat`.

use std::process::ExitCode;
use std::{env, io};

fn main() -> ExitCode {
    ExitCode::from(tilesat_tools::cli::run(env::args_os().skip(1), &mut io::stdout(), &mut io::stderr()))
}
