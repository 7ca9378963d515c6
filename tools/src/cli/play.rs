//! `tilesat play`: a level in, a run and its picture out. The example `platformer` is this with levels of its own.

use std::ffi::OsString;
use std::fs::File;
use std::io::Write;
use std::path::Path;

use tilesat::TileShape;
use tilesat_games::platformer::sim::MAX_COINS;

use super::program::Options;
pub use super::program::Program;
use super::tell::{status, tell, usage};
use crate::bake::level::{self, Level};
use crate::fail::{Fail, Result};
use crate::picture::{png, svg};
use crate::play::{self, constants};
use crate::read::tmx;

/// Runs the program; returns the exit status.
pub fn run(
    program: &Program,
    args: impl IntoIterator<Item = OsString>,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> u8 {
    let result = program.parse(args).and_then(|options| match options {
        None => {
            usage(out, &program.usage());
            Ok(0)
        }
        Some(options) => job(program, &options, out, err),
    });
    status(program.name, result, err)
}

fn job(program: &Program, options: &Options, out: &mut dyn Write, err: &mut dyn Write) -> Result<u8> {
    let path = &options.level;
    let of_file = |fail: Fail| Fail::new(format!("{}: {fail}", path.display()));
    let level = Level::bake(&tmx::load(path)?, options.layer.as_deref()).map_err(of_file)?;
    describe(path, &level, out);
    if let Some(stem) = &options.bake {
        for file in constants::write(&level, stem)? {
            tell(out, &format!("wrote   {}", file.display()));
        }
        return Ok(0);
    }
    // Before the run, so that a long one does not end without its picture.
    for file in options.png.iter().chain(&options.svg) {
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
    let scene = play::picture::scene(&level, &run, &name, options.seed);
    if let Some(file) = &options.png {
        png::write(&scene, file)?;
        tell(out, &format!("picture {}", file.display()));
    }
    if let Some(file) = &options.svg {
        svg::write(&scene, file)?;
        tell(out, &format!("picture {}", file.display()));
    }
    if run.refused > 0 {
        tell(err, &format!("{}: the library refused {} motions", program.name, run.refused));
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
    if play::coins(level).count() > MAX_COINS as usize {
        tell(out, &format!("note    only the first {MAX_COINS} coins can be taken"));
    }
}

fn writable(path: &Path) -> Result<()> {
    let file = File::options().write(true).create(true).truncate(false).open(path);
    file.map(drop).map_err(|e| Fail::new(format!("cannot write {}: {e}", path.display())))
}
