//! `tilesat bake`: a level in, what a firmware includes out.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use lexopt::Arg::{Long, Short, Value};
use lexopt::Parser;
use tilesat::Fx;

use super::args::{length, next, once, path, sides, text, unknown, value};
use super::tell::{status, tell, usage};
use crate::bake::{self, Baked, Settings};
use crate::fail::{Fail, Result};
use crate::picture::png;
use crate::read;

const USAGE: &str = "\
usage: tilesat bake LEVEL -o OUT.bin|OUT.rs [options]

Turns a level into what a firmware includes, and reports what it costs there.
LEVEL is a Tiled map (tile layers, and polygons, polylines and rectangles of
object layers; tilesat lint --help says how objects are named) or an LDtk project, whose
IntGrid values are named like shapes, with flags: SlopeTopLeft_Ice, Empty_Coin.

  -o OUT.bin     write bytes: those of SegmentMap::from_bytes for objects, one a
                 tile for tiles (with both: OUT.segments.bin and OUT.tiles.bin)
  -o OUT.rs      write Rust source: constants that the compiler builds the level of
  --cell PX      the side of the cells that objects are sorted into (default: a tile)
  --body WxH     the body that the report reckons with (default: a cell)
  --picture PNG  draw cells, segments with their normals, vertices, and rays
  --layer NAME   the tile layer that is solid (default: the one with most solid tiles)
  --level NAME   which level of an LDtk project (default: the first)
  --help         print this

Exit status: 0 written, 2 bad arguments or a level that is refused.
";

#[derive(Debug, Clone, Copy)]
enum Format {
    Bytes,
    Source,
}

struct Options {
    file: PathBuf,
    out: PathBuf,
    format: Format,
    settings: Settings,
    /// Raw.
    body: Option<(i32, i32)>,
    picture: Option<PathBuf>,
    level: Option<String>,
}

/// Runs the subcommand; returns the exit status.
pub(crate) fn run(args: impl Iterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let result = parse(args).and_then(|options| match options {
        None => {
            usage(out, USAGE);
            Ok(0)
        }
        Some(options) => job(&options, out),
    });
    status("tilesat bake", result, err)
}

/// `None` where help is asked for.
fn parse(args: impl Iterator<Item = OsString>) -> Result<Option<Options>> {
    let (mut file, mut out, mut cell, mut body) = (None, None, None, None);
    let (mut picture, mut layer, mut level) = (None, None, None);
    let mut parser = Parser::from_args(args);
    while let Some(arg) = next(&mut parser)? {
        match arg {
            Short('h') | Long("help") => return Ok(None),
            Short('o') => once(&mut out, "-o", PathBuf::from(value(&mut parser, "-o")?))?,
            Long("cell") => once(&mut cell, "--cell", length(&mut parser, "--cell")?)?,
            Long("body") => once(&mut body, "--body", sides(&mut parser, "--body")?)?,
            Long("picture") => once(&mut picture, "--picture", PathBuf::from(value(&mut parser, "--picture")?))?,
            Long("layer") => once(&mut layer, "--layer", text(&mut parser, "--layer")?)?,
            Long("level") => once(&mut level, "--level", text(&mut parser, "--level")?)?,
            Value(given) => once(&mut file, "LEVEL", path(given)?)?,
            other => return Err(unknown(&other)),
        }
    }
    let file = file.ok_or_else(|| Fail::new("no level given (see --help)"))?;
    let out: PathBuf = out.ok_or_else(|| Fail::new("no -o OUT.bin or -o OUT.rs given (see --help)"))?;
    let format = format(&out)?;
    let settings = Settings { layer, cell: cell.map(Fx::from_bits) };
    Ok(Some(Options { file, out, format, settings, body, picture, level }))
}

fn format(out: &Path) -> Result<Format> {
    match out.extension().and_then(OsStr::to_str) {
        Some("bin") => Ok(Format::Bytes),
        Some("rs") => Ok(Format::Source),
        _ => Err(Fail::new(format!("{} ends neither in .bin nor in .rs", out.display()))),
    }
}

fn job(options: &Options, out: &mut dyn Write) -> Result<u8> {
    let drawing = read::load(&options.file, options.level.as_deref())?;
    let of_file = |fail: Fail| Fail::new(format!("{}: {fail}", options.file.display()));
    let baked = bake::bake(&drawing, &options.settings).map_err(of_file)?;
    for left_out in drawing.left_out.iter().filter(|left_out| left_out.suspicious) {
        tell(out, &format!("left out {}: {}", left_out.title, left_out.why));
    }
    let lines = baked.report(options.body)?;
    for line in &lines {
        tell(out, line);
    }
    for (file, bytes) in files(&baked, options) {
        fs::write(&file, bytes).map_err(|e| Fail::new(format!("cannot write {}: {e}", file.display())))?;
        tell(out, &format!("wrote   {}", file.display()));
    }
    if let Some(file) = &options.picture {
        png::write(&baked.picture(&lines)?, file)?;
        tell(out, &format!("picture {}", file.display()));
    }
    Ok(0)
}

fn files(baked: &Baked, options: &Options) -> Vec<(PathBuf, Vec<u8>)> {
    let tiles = baked.tiles.as_ref().map(|level| level.tiles.clone());
    let objects = baked.objects.as_ref().map(|(_, bytes, _)| bytes.clone());
    match (options.format, tiles, objects) {
        (Format::Source, ..) => vec![(options.out.clone(), baked.source().into_bytes())],
        (Format::Bytes, Some(tiles), Some(objects)) => {
            let named = |what: &str| options.out.with_extension(format!("{what}.bin"));
            vec![(named("tiles"), tiles), (named("segments"), objects)]
        }
        (Format::Bytes, tiles, objects) => {
            tiles.or(objects).into_iter().map(|bytes| (options.out.clone(), bytes)).collect()
        }
    }
}
