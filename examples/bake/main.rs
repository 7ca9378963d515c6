//! Turns a level into what a firmware includes, and says what it costs there.
//!
//! `cargo run --release --example bake -- --help` says what it takes.
#![allow(unreachable_pub, reason = "a program has no outside; `pub` marks what other files of it use")]
#![allow(clippy::std_instead_of_core, reason = "this part runs on a desktop")]
#![allow(clippy::indexing_slicing, reason = "indices are those of lists that were built together")]

pub(crate) mod args;
#[allow(dead_code, reason = "shared with other programs")]
#[path = "../level_io/mod.rs"]
pub(crate) mod level_io;
#[allow(dead_code, reason = "shared with other programs")]
mod picture;
mod report;
mod segments;
mod source;

use std::env;
use std::ffi::OsString;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use args::{Command, Format, Options};
use level_io::Drawing;
pub(crate) use level_io::fail;

use fail::{Fail, Result};
use level_io::level::Level;
use report::{Owner, Report};
use segments::Shapes;
use tilesat::{AllShapes, Fx, Grid, Inside, Joined, RangeError, RayHit, SegmentMap, TileKinds, TileMap, Vec2};

fn main() -> ExitCode {
    let args = env::args_os().skip(1);
    ExitCode::from(run(args, &mut io::stdout(), &mut io::stderr()))
}

/// The whole program but for the process around it; returns the exit status.
pub fn run(args: impl IntoIterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let result = args::parse(args).and_then(|command| match command {
        Command::Help => {
            tell(out, args::USAGE.trim_end());
            Ok(())
        }
        Command::Run(options) => job(&options, out),
    });
    match result {
        Ok(()) => 0,
        Err(fail) => {
            tell(err, &format!("bake: {fail}"));
            2
        }
    }
}

/// A level in the forms that the library takes.
struct Baked {
    tiles: Option<Level>,
    kinds: TileKinds,
    /// The objects, their bytes, and the side of a cell.
    objects: Option<(Shapes, Vec<u8>, Fx)>,
    flags: Vec<String>,
}

fn job(options: &Options, out: &mut dyn Write) -> Result<()> {
    let drawing = level_io::load(&options.file, options.level.as_deref())?;
    let of_file = |fail: Fail| Fail::new(format!("{}: {fail}", options.file.display()));
    let baked = bake(&drawing, options).map_err(of_file)?;
    for left_out in drawing.left_out.iter().filter(|left_out| left_out.suspicious) {
        tell(out, &format!("left out {}: {}", left_out.title, left_out.why));
    }
    let lines = describe(&baked, options)?;
    for line in &lines {
        tell(out, line);
    }
    for (file, bytes) in files(&baked, options) {
        fs::write(&file, bytes).map_err(|e| Fail::new(format!("cannot write {}: {e}", file.display())))?;
        tell(out, &format!("wrote   {}", file.display()));
    }
    if let Some(file) = &options.picture {
        draw(&baked, &lines, file)?;
        tell(out, &format!("picture {}", file.display()));
    }
    Ok(())
}

fn bake(drawing: &Drawing, options: &Options) -> Result<Baked> {
    let tiles = drawing.level(options.layer.as_deref())?;
    let mut flags = tiles.as_ref().map_or_else(Vec::new, |level| level.flags.clone());
    let mut objects = None;
    if !drawing.outlines.is_empty() {
        let cell = options.cell.map_or(Fx::from_num(drawing.tiles.tile), Fx::from_bits);
        let shapes = Shapes::of(&drawing.outlines, &mut flags)?;
        let bytes = shapes.build(&drawing.outlines, cell)?;
        objects = Some((shapes, bytes, cell));
    }
    if tiles.is_none() && objects.is_none() {
        return Err(Fail::new("there is nothing solid: no tile, no object"));
    }
    let kinds = tiles.as_ref().map_or(TileKinds::EMPTY, Level::kinds);
    Ok(Baked { tiles, kinds, objects, flags })
}

impl Baked {
    fn map(&self) -> Result<Option<(TileMap<'_, AllShapes>, Grid)>> {
        let Some(level) = &self.tiles else { return Ok(None) };
        let grid = Grid::new(level.width, level.height, Fx::from_num(level.tile), Vec2::ZERO);
        let map = grid.and_then(|grid| Ok((TileMap::<AllShapes>::of(&level.tiles, grid, &self.kinds)?, grid)));
        map.map(Some).map_err(|e| Fail::new(format!("layer '{}': {e}", level.layer)))
    }

    fn segments(&self) -> Result<Option<SegmentMap<'_>>> {
        let Some((_, bytes, _)) = &self.objects else { return Ok(None) };
        SegmentMap::from_bytes(bytes).map(Some).map_err(|e| Fail::new(format!("the objects: {e}")))
    }
}

fn describe(baked: &Baked, options: &Options) -> Result<Vec<String>> {
    let mut lines = Vec::new();
    let body = |grid: &Grid| options.body.unwrap_or((grid.cell().to_bits(), grid.cell().to_bits()));
    if let (Some((map, grid)), Some(level)) = (baked.map()?, &baked.tiles) {
        let (width, height, side) = (level.width, level.height, level.tile);
        lines.push(format!("tiles   layer '{}': {width}x{height} of {side} px", level.layer));
        lines.push(format!("flash   {} bytes of tiles, {} of kinds", level.tiles.len(), size_of::<TileKinds>()));
        let report = Report::of(&map, grid, Owner::Tile, body(&grid));
        lines.extend(report.lines(body(&grid)));
    }
    if let (Some(map), Some((shapes, bytes, cell))) = (baked.segments()?, &baked.objects) {
        let (count, paths) = (map.count(), shapes.kinds.len());
        let (width, height) = (map.width(), map.height());
        lines.push(format!("objects {paths} in {count} segments, {width}x{height} cells of {cell} px"));
        lines.push(format!("flash   {} bytes", bytes.len()));
        let grid = map.grid();
        let report = Report::of(&map, grid, Owner::Square, body(&grid));
        lines.extend(report.lines(body(&grid)));
    }
    let flags: Vec<String> = baked.flags.iter().enumerate().map(|(bit, name)| format!("{name} = bit {bit}")).collect();
    if !flags.is_empty() {
        lines.push(format!("flags   {}", flags.join(", ")));
    }
    Ok(lines)
}

fn files(baked: &Baked, options: &Options) -> Vec<(PathBuf, Vec<u8>)> {
    let tiles = baked.tiles.as_ref().map(|level| level.tiles.clone());
    let objects = baked.objects.as_ref().map(|(_, bytes, _)| bytes.clone());
    match (options.format, tiles, objects) {
        (Format::Source, ..) => {
            let objects = baked.objects.as_ref().map(|(shapes, _, cell)| (shapes, *cell));
            let text = source::source(baked.tiles.as_ref(), objects, &baked.flags);
            vec![(options.out.clone(), text.into_bytes())]
        }
        (Format::Bytes, Some(tiles), Some(objects)) => {
            let named = |what: &str| options.out.with_extension(format!("{what}.bin"));
            vec![(named("tiles"), tiles), (named("segments"), objects)]
        }
        (Format::Bytes, tiles, objects) => {
            tiles.or(objects).into_iter().map(|bytes| (options.out.clone(), bytes)).collect()
        }
    }
}

fn draw(baked: &Baked, lines: &[String], file: &Path) -> Result<()> {
    let (tiles, segments) = (baked.map()?, baked.segments()?);
    let grids: Vec<Grid> = tiles.iter().map(|(_, grid)| *grid).chain(segments.iter().map(SegmentMap::grid)).collect();
    let (mut scene, origin) = picture::scene(&grids);
    if let Some((map, grid)) = &tiles {
        picture::cells(&mut scene, map, *grid, Owner::Tile);
    }
    if let Some(map) = &segments {
        picture::cells(&mut scene, map, map.grid(), Owner::Square);
    }
    let point = |hit: std::result::Result<Option<RayHit>, RangeError>| hit.ok().flatten().map(|hit| hit.point);
    match (&tiles, &segments) {
        (Some((a, grid)), Some(b)) => {
            let both = Joined::new(a, b);
            picture::faces(&mut scene, &both, &grids);
            picture::rays(&mut scene, &both, *grid, |from, motion| point(both.cast_ray(from, motion, Inside::Hit)));
        }
        (Some((map, grid)), None) => {
            picture::faces(&mut scene, map, &grids);
            picture::rays(&mut scene, map, *grid, |from, motion| point(map.cast_ray(from, motion, Inside::Hit)));
        }
        (None, Some(map)) => {
            picture::faces(&mut scene, map, &grids);
            picture::rays(&mut scene, map, map.grid(), |from, motion| point(map.cast_ray(from, motion, Inside::Hit)));
        }
        (None, None) => {}
    }
    picture::finish(&mut scene, origin, lines);
    picture::write(&scene, file)
}

/// One line; a closed pipe is no reason to stop.
fn tell(to: &mut dyn Write, line: &str) {
    let _ = writeln!(to, "{line}");
}
