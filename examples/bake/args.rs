//! The command line.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

use super::level_io::arguments::{length, once, sides, text, value};
use super::level_io::fail::{Fail, Result};

pub const USAGE: &str = "\
usage: bake LEVEL -o OUT.bin|OUT.rs [options]

Turns a level into what a firmware includes, and reports what it costs there.
LEVEL is a Tiled map (tile layers, and polygons, polylines and rectangles of
object layers; lint --help says how objects are named) or an LDtk project, whose
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

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    Bytes,
    Source,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Options {
    pub file: PathBuf,
    pub out: PathBuf,
    pub format: Format,
    /// Raw.
    pub cell: Option<i32>,
    /// Raw.
    pub body: Option<(i32, i32)>,
    pub picture: Option<PathBuf>,
    pub layer: Option<String>,
    pub level: Option<String>,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Command {
    Help,
    Run(Options),
}

pub fn parse(args: impl IntoIterator<Item = OsString>) -> Result<Command> {
    let (mut file, mut out, mut cell, mut body) = (None, None, None, None);
    let (mut picture, mut layer, mut level) = (None, None, None);
    let mut args = args.into_iter();
    while let Some(arg) = args.next() {
        let mut value = |name: &str| value(name, args.next());
        match arg.to_str() {
            Some("--help" | "-h") => return Ok(Command::Help),
            Some(name @ "-o") => once(&mut out, name, PathBuf::from(value(name)?))?,
            Some(name @ "--cell") => once(&mut cell, name, length(&value(name)?, name)?)?,
            Some(name @ "--body") => once(&mut body, name, sides(&value(name)?, name)?)?,
            Some(name @ "--picture") => once(&mut picture, name, PathBuf::from(value(name)?))?,
            Some(name @ "--layer") => once(&mut layer, name, text(&value(name)?, name)?)?,
            Some(name @ "--level") => once(&mut level, name, text(&value(name)?, name)?)?,
            Some(name) if name.starts_with('-') => {
                return Err(Fail::new(format!("unknown argument {name} (see --help)")));
            }
            Some("") => return Err(Fail::new("an empty argument where a level was expected")),
            _ => once(&mut file, "LEVEL", PathBuf::from(arg))?,
        }
    }
    let file = file.ok_or_else(|| Fail::new("no level given (see --help)"))?;
    let out: PathBuf = out.ok_or_else(|| Fail::new("no -o OUT.bin or -o OUT.rs given (see --help)"))?;
    let format = format(&out)?;
    Ok(Command::Run(Options { file, out, format, cell, body, picture, layer, level }))
}

fn format(out: &Path) -> Result<Format> {
    match out.extension().and_then(OsStr::to_str) {
        Some("bin") => Ok(Format::Bytes),
        Some("rs") => Ok(Format::Source),
        _ => Err(Fail::new(format!("{} ends neither in .bin nor in .rs", out.display()))),
    }
}
