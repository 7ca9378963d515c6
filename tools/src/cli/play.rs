//! `tilesat play`: plays a level and draws the run. The example `platformer` does the same with
//! built-in levels.

use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};

use tilesat::{SegmentMap, TileShape};
use tilesat_games::platformer::sim::MAX_COINS;

use super::input::Input;
use super::program::Options;
pub use super::program::Program;
use super::tell::{list, status, tell, usage};
use crate::bake::{self, Outputs, Settings, reopen};
use crate::fail::{Fail, Result};
use crate::picture::{png, svg};
use crate::play::{self, Arena, constants};
use crate::rules::names;
use crate::rules::options::listed;

/// Runs the program. Returns the exit status.
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
        Some(options) => job(program, options, out, err),
    });
    status(program.name, result, err)
}

fn job(program: &Program, options: Options, out: &mut dyn Write, err: &mut dyn Write) -> Result<u8> {
    let path = options.file;
    let of_file = |fail: Fail| Fail::new(format!("{}: {fail}", path.display()));
    let (arena, files, notes) = arena(&path, options.input)?;
    describe(&path, &arena, out);
    list(out, "note", &notes);
    if let Some(stem) = &options.bake {
        if arena.segments.is_some() {
            return Err(of_file(Fail::new("this game plays only tiles; tilesat bake accepts polygons too")));
        }
        for file in constants::files(&arena.level, stem).write(&files)? {
            tell(out, &format!("wrote   {}", file.display()));
        }
        return Ok(0);
    }
    // Checked before the run: a long one must not end without its picture.
    for file in options.png.iter().chain(&options.svg) {
        Outputs::check(file, &files)?;
    }
    let run = play::play(&arena, options.frames, options.seed, err).map_err(of_file)?;
    if let Some((spawn, _)) = arena.spawn.as_ref().filter(|_| !run.at_spawn) {
        tell(out, &format!("note    {}: the player has no room there, and starts elsewhere", spawn.title));
    }
    let s = run.score;
    tell(
        out,
        &format!(
            "player  {} coins, {} deaths, {} wins, {} head bumps, {} one-way landings",
            s.coins, s.deaths, s.wins, s.bumps, s.landings
        ),
    );
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let scene = play::picture::scene(&arena, &run, &name, options.seed);
    let mut outputs = Outputs::default();
    if let Some(file) = options.png {
        outputs.add(file, png::bytes(&scene)?);
    }
    if let Some(file) = options.svg {
        outputs.add(file, svg::text(&scene).into_bytes());
    }
    for file in outputs.write(&files)? {
        tell(out, &format!("picture {}", file.display()));
    }
    if run.refused > 0 {
        tell(err, &format!("{}: the library refused {} motions", program.name, run.refused));
    }
    tell(out, &run.line());
    Ok(u8::from(run.overlaps + run.escaped + run.refused > 0))
}

/// A level, its files, and notes for the user.
type Drawn = (Arena, Vec<PathBuf>, Vec<String>);

/// The level in a file, drawn or baked.
fn arena(path: &Path, input: Input) -> Result<Drawn> {
    let of_file = |fail: Fail| Fail::new(format!("{}: {fail}", path.display()));
    if reopen::is_baked(path) {
        let levels = reopen::reopen(path)?;
        let names: Vec<&str> = levels.iter().map(|level| level.name.as_str()).collect();
        let wanted = input.level.as_deref().unwrap_or(names.first().copied().unwrap_or_default());
        let found = levels.iter().find(|level| level.name == wanted);
        let unknown = || Fail::new(format!("no level '{wanted}'; there are: {}", names.join(", ")));
        return Ok((
            found.ok_or_else(|| of_file(unknown())).and_then(|level| Arena::reopened(level).map_err(of_file))?,
            vec![path.to_owned()],
            Vec::new(),
        ));
    }
    let (levels, options) = input.load(path)?;
    let first = levels.maps.iter().find(|map| !listed(&options.ignored_levels, &map.name));
    let map = first.ok_or_else(|| of_file(Fail::new("every level is skipped: remove an --ignore-level")))?;
    let bundle = bake::bake(std::slice::from_ref(map), &Settings { options, cell: None }).map_err(of_file)?;
    let [baked] = &bundle.levels[..] else { return Err(of_file(Fail::new("no level"))) };
    let notes = baked.ground.notes.iter().chain(&bundle.warnings).cloned().collect();
    Ok((Arena::of(baked).map_err(of_file)?, levels.files, notes))
}

fn describe(path: &Path, arena: &Arena, out: &mut dyn Write) {
    let level = &arena.level;
    let count =
        |is: fn(TileShape) -> bool| level.tiles.iter().filter(|&&t| is(level.ids[usize::from(t)].shape)).count();
    let (width, height, tile) = (level.width, level.height, level.tile);
    tell(out, &format!("level   {}: {width}x{height} tiles of {tile} px", path.display()));
    let (solid, one_way) = (count(names::is_solid), count(names::is_one_way));
    tell(out, &format!("layer   {}: {solid} solid and {one_way} one-way tiles", level.layer));
    if let Some(map) = arena.segments.as_ref().and_then(|bytes| SegmentMap::from_bytes(bytes).ok()) {
        tell(out, &format!("objects {} segments", map.count()));
    }
    if let Some((spawn, others)) = &arena.spawn {
        let more = if *others > 0 { format!(", the first of {}", others + 1) } else { String::new() };
        tell(out, &format!("player  starts at {}{more}", spawn.title));
    }
    let flags: Vec<String> = level.flags.iter().enumerate().map(|(bit, name)| format!("{name} = bit {bit}")).collect();
    let flags = if flags.is_empty() { "none".to_owned() } else { flags.join(", ") };
    tell(out, &format!("flags   {flags}"));
    if play::coins(level).count() > MAX_COINS as usize {
        tell(out, &format!("note    only the first {MAX_COINS} coins can be taken"));
    }
}
