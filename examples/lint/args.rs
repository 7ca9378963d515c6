//! The command line.

use std::ffi::OsString;
use std::path::PathBuf;

use super::check::{Body, Rules};
use super::level_io::arguments::{length, once, sides, text, value};
use super::level_io::fail::{Fail, Result};

pub const USAGE: &str = "\
usage: lint LEVEL [options]

Looks for mistakes in a level before it is baked: a Tiled map (tile layers, and
polygons, polylines and rectangles of object layers) or an LDtk project (IntGrid).

  --body WxH     a box of this size moves through it: report what is too narrow
  --circle R     a circle of this radius does
  --small PX     edges shorter and polygons thinner than this are slivers (default: 1)
  --layer NAME   the tile layer that is solid (default: the one with most solid tiles)
  --level NAME   which level of an LDtk project (default: the first)
  --strict       warnings count as errors
  --help         print this

An object is solid, a hole, a wall (a chain that blocks from both sides) or
one-way (a chain that blocks from its left as drawn: draw floors to the right):
by its property kind, else its class or a true property of that name, else the
class of its layer. Without any, polygons are solid and polylines are walls;
objects of other classes are left out. All other names are flags.
Each finding is a line: severity, code, place in pixels, objects, what, why.
Exit status: 0 no error, 1 errors, 2 bad arguments or a bad file.
";

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Options {
    pub file: PathBuf,
    pub level: Option<String>,
    pub rules: Rules,
    pub strict: bool,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Command {
    Help,
    Run(Options),
}

const BODY: &str = "a body (--body, --circle)";

pub fn parse(args: impl IntoIterator<Item = OsString>) -> Result<Command> {
    let (mut file, mut level, mut layer, mut body, mut small, mut strict) = (None, None, None, None, None, None);
    let mut args = args.into_iter();
    while let Some(arg) = args.next() {
        let mut value = |name: &str| value(name, args.next());
        match arg.to_str() {
            Some("--help" | "-h") => return Ok(Command::Help),
            Some(name @ "--body") => {
                let (width, height) = sides(&value(name)?, name)?;
                once(&mut body, BODY, Body::Box { width: width.into(), height: height.into() })?;
            }
            Some(name @ "--circle") => {
                let radius = length(&value(name)?, name)?;
                once(&mut body, BODY, Body::Circle { radius: radius.into() })?;
            }
            Some(name @ "--small") => once(&mut small, name, length(&value(name)?, name)?)?,
            Some(name @ "--layer") => once(&mut layer, name, text(&value(name)?, name)?)?,
            Some(name @ "--level") => once(&mut level, name, text(&value(name)?, name)?)?,
            Some(name @ "--strict") => once(&mut strict, name, true)?,
            Some(name) if name.starts_with('-') => {
                return Err(Fail::new(format!("unknown argument {name} (see --help)")));
            }
            Some("") => return Err(Fail::new("an empty argument where a level was expected")),
            _ => once(&mut file, "LEVEL", PathBuf::from(arg))?,
        }
    }
    let file = file.ok_or_else(|| Fail::new("no level given (see --help)"))?;
    let rules = Rules { body, small: small.map_or(1 << 16, i64::from), layer };
    Ok(Command::Run(Options { file, level, rules, strict: strict.unwrap_or(false) }))
}
