//! A character plays through a Tiled level, together with 32 boxes and balls.
//!
//! `cargo run --release --example platformer -- --help` says what it takes. The folder `sim` is
//! what a game would hold, and runs unchanged on a microcontroller (`examples/firmware.rs`);
//! everything else reads the level, checks the result and draws the picture.
#![allow(unreachable_pub, reason = "a program has no outside; `pub` marks what other files of it use")]
#![allow(clippy::std_instead_of_core, reason = "this part runs on a desktop")]
#![allow(clippy::indexing_slicing, reason = "indices are cells of layers and tables that were built together")]

pub(crate) mod args;
pub(crate) mod bake;
pub(crate) mod check;
pub(crate) mod fail;
pub(crate) mod guard;
pub(crate) mod level;
pub(crate) mod meets;
pub(crate) mod names;
pub(crate) mod outline;
pub(crate) mod picture;
pub(crate) mod play;
pub(crate) mod sim;
pub(crate) mod tmx;
pub(crate) mod trail;
pub(crate) mod traits;
pub(crate) mod unpack;
pub(crate) mod xml;

use std::env;
use std::ffi::OsString;
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use args::{Command, Options};
use fail::{Fail, Result};
use level::Level;
use tilesat::TileShape;

fn main() -> ExitCode {
    let args = env::args_os().skip(1);
    ExitCode::from(run(args, &mut io::stdout(), &mut io::stderr()))
}

/// The whole program but for the process around it; returns the exit status.
pub fn run(args: impl IntoIterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let result = args::parse(args).and_then(|command| match command {
        Command::Help => {
            let _ = out.write_all(args::USAGE.as_bytes());
            Ok(0)
        }
        Command::Run(options) => job(&options, out, err),
    });
    result.unwrap_or_else(|fail| {
        tell(err, &format!("platformer: {fail}"));
        2
    })
}

fn job(options: &Options, out: &mut dyn Write, err: &mut dyn Write) -> Result<u8> {
    let path = options.level.clone().unwrap_or_else(|| own("meadow"));
    let of_file = |fail: Fail| Fail::new(format!("{}: {fail}", path.display()));
    let level = Level::bake(&tmx::load(&path)?, options.layer.as_deref()).map_err(of_file)?;
    describe(&path, &level, out);
    if let Some(stem) = &options.bake {
        for file in bake::write(&level, stem)? {
            tell(out, &format!("wrote   {}", file.display()));
        }
        return Ok(0);
    }
    // Before the run, so that a long one does not end without its picture.
    let (png, svg) = pictures(options);
    for file in png.iter().chain(&svg) {
        writable(file)?;
    }
    let run = play::play(&level, options.frames, options.seed, err).map_err(of_file)?;
    let s = run.score;
    tell(
        out,
        &format!(
            "player  {} coins, {} deaths, {} wins, {} head bumps, {} one-way landings",
            s.coins, s.deaths, s.wins, s.bumps, s.landings
        ),
    );
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let scene = picture::scene(&level, &run, &name, options.seed);
    if let Some(file) = &png {
        picture::write_png(&scene, file)?;
        tell(out, &format!("picture {}", file.display()));
    }
    if let Some(file) = &svg {
        picture::write_svg(&scene, file)?;
        tell(out, &format!("picture {}", file.display()));
    }
    if run.refused > 0 {
        tell(err, &format!("platformer: the library refused {} motions", run.refused));
    }
    tell(out, &run.line());
    Ok(u8::from(run.overlaps + run.escaped + run.refused > 0))
}

fn describe(path: &Path, level: &Level, out: &mut dyn Write) {
    let count =
        |is: fn(TileShape) -> bool| level.tiles.iter().filter(|&&t| is(level.ids[usize::from(t)].shape)).count();
    let (width, height, tile) = (level.width, level.height, level.tile);
    tell(out, &format!("level   {}: {width}x{height} tiles of {tile} px", path.display()));
    let (solid, one_way) = (count(level::is_solid), count(|shape| shape as u8 >= TileShape::OneWayUp as u8));
    tell(out, &format!("layer   {}: {solid} solid and {one_way} one-way tiles", level.layer));
    let flags: Vec<String> = level.flags.iter().enumerate().map(|(bit, name)| format!("{name} = bit {bit}")).collect();
    let flags = if flags.is_empty() { "none".to_owned() } else { flags.join(", ") };
    tell(out, &format!("flags   {flags}"));
    if level.coins().count() > sim::MAX_COINS as usize {
        tell(out, &format!("note    only the first {} coins can be taken", sim::MAX_COINS));
    }
}

/// Where a level of this example lies.
#[must_use]
pub fn own(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/platformer/levels").join(name).with_extension("tmx")
}

/// The pictures asked for; without any, one in the target folder, three levels above the program.
fn pictures(options: &Options) -> (Option<PathBuf>, Option<PathBuf>) {
    let default = || {
        let exe = env::current_exe().ok()?;
        Some(exe.ancestors().nth(3)?.join("platformer.png"))
    };
    let none = options.png.is_none() && options.svg.is_none();
    let png = if none { default() } else { options.png.clone() };
    (png, options.svg.clone())
}

fn writable(path: &Path) -> Result<()> {
    let file = File::options().write(true).create(true).truncate(false).open(path);
    file.map(drop).map_err(|e| Fail::new(format!("cannot write {}: {e}", path.display())))
}

/// One line; a closed pipe is no reason to stop.
fn tell(to: &mut dyn Write, line: &str) {
    let _ = writeln!(to, "{}", fail::one_line(line));
}
