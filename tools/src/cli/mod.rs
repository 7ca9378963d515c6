//! The program `tilesat`: its subcommands, their arguments and their output.

mod args;
mod bake;
mod input;
mod lint;
pub mod play;
mod program;
mod rooms;
mod rules;
mod sheet;
mod tell;

use std::ffi::OsString;
use std::io::Write;

const USAGE: &str = "\
usage: tilesat COMMAND ...

Checks, bakes and plays levels of Tiled and LDtk for the crate tilesat.

  bake     turn a level into bytes or Rust source for a firmware
  rooms    cut a world of any size into rooms for a firmware
  lint     look for mistakes in a level
  play     play a level with a scripted player, boxes and balls
  sheet    draw every shape of a tile with its faces, corners and arcs

tilesat COMMAND --help lists the arguments of each. tilesat help rules prints what is
solid in a level, and why. tilesat --version prints the version.
";

const COMMANDS: [&str; 5] = ["bake", "rooms", "lint", "play", "sheet"];

/// The whole program except for the process around it. Returns the exit status.
pub fn run(args: impl IntoIterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let mut out = tell::Checked::new(out);
    let status = command(args.into_iter(), &mut out, err);
    out.status(status, err)
}

fn command(mut args: impl Iterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let command = args.next();
    match command.as_ref().map(|command| command.to_string_lossy()).as_deref() {
        Some("bake") => bake::run(args, out, err),
        Some("lint") => lint::run(args, out, err),
        Some("play") => play::run(&play::Program::default(), args, out, err),
        Some("rooms") => rooms::run(args, out, err),
        Some("sheet") => sheet::run(args, out, err),
        Some("help") => help(args, out, err),
        Some("--version" | "-V") => {
            tell::tell(out, concat!("tilesat ", env!("CARGO_PKG_VERSION")));
            0
        }
        Some("--help" | "-h") => {
            tell::usage(out, USAGE);
            0
        }
        Some(other) => {
            tell::tell(err, &format!("tilesat: no command is called {other}; there are: {}", COMMANDS.join(", ")));
            2
        }
        None => {
            tell::tell(err, "tilesat: no command given (see --help)");
            2
        }
    }
}

/// A topic, or the usage of a command.
fn help(mut args: impl Iterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let topic = args.next().map(|topic| topic.to_string_lossy().into_owned());
    match topic.as_deref() {
        None => tell::usage(out, USAGE),
        Some("rules") => tell::usage(out, rules::RULES),
        Some(name) if COMMANDS.contains(&name) => {
            return command([name, "--help"].map(OsString::from).into_iter(), out, err);
        }
        Some(other) => {
            let topics = format!("there is help about: rules, {}", COMMANDS.join(", "));
            tell::tell(err, &format!("tilesat help: no topic is called {other}; {topics}"));
            return 2;
        }
    }
    0
}
