//! `tilesat lint`: a level in, what is wrong with it out.

use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;

use lexopt::Arg::{Long, Short, Value};
use lexopt::Parser;

use super::args::{length, next, once, path, sides, text, unknown};
use super::tell::{status, tell, usage};
use crate::fail::{Fail, Result};
use crate::lint::{self, Body, Rules, Severity};
use crate::read;

const USAGE: &str = "\
usage: tilesat lint LEVEL [options]

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

struct Options {
    file: PathBuf,
    level: Option<String>,
    rules: Rules,
    strict: bool,
}

const BODY: &str = "a body (--body, --circle)";

/// Runs the subcommand; returns the exit status.
pub(crate) fn run(args: impl Iterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let result = parse(args).and_then(|options| match options {
        None => {
            usage(out, USAGE);
            Ok(0)
        }
        Some(options) => job(&options, out),
    });
    status("tilesat lint", result, err)
}

/// `None` where help is asked for.
fn parse(args: impl Iterator<Item = OsString>) -> Result<Option<Options>> {
    let (mut file, mut level, mut layer, mut body, mut small, mut strict) = (None, None, None, None, None, None);
    let mut parser = Parser::from_args(args);
    while let Some(arg) = next(&mut parser)? {
        match arg {
            Short('h') | Long("help") => return Ok(None),
            Long("body") => {
                let (width, height) = sides(&mut parser, "--body")?;
                once(&mut body, BODY, Body::Box { width: width.into(), height: height.into() })?;
            }
            Long("circle") => {
                let radius = length(&mut parser, "--circle")?;
                once(&mut body, BODY, Body::Circle { radius: radius.into() })?;
            }
            Long("small") => once(&mut small, "--small", length(&mut parser, "--small")?)?,
            Long("layer") => once(&mut layer, "--layer", text(&mut parser, "--layer")?)?,
            Long("level") => once(&mut level, "--level", text(&mut parser, "--level")?)?,
            Long("strict") => once(&mut strict, "--strict", true)?,
            Value(given) => once(&mut file, "LEVEL", path(given)?)?,
            other => return Err(unknown(&other)),
        }
    }
    let file = file.ok_or_else(|| Fail::new("no level given (see --help)"))?;
    let rules = Rules { body, small: small.map_or(1 << 16, i64::from), layer };
    Ok(Some(Options { file, level, rules, strict: strict.unwrap_or(false) }))
}

fn job(options: &Options, out: &mut dyn Write) -> Result<u8> {
    let drawing = read::load(&options.file, options.level.as_deref())?;
    let of_file = |fail: Fail| Fail::new(format!("{}: {fail}", options.file.display()));
    let findings = lint::check(&drawing, &options.rules).map_err(of_file)?;
    for line in findings.lines() {
        tell(out, &line);
    }
    let [errors, warnings, notes] = [Severity::Error, Severity::Warning, Severity::Note].map(|s| findings.count(s));
    let layers = drawing.tiles.layers.len();
    let outlines = drawing.outlines.len();
    tell(out, &format!("layers={layers} outlines={outlines} errors={errors} warnings={warnings} notes={notes}"));
    Ok(u8::from(errors > 0 || options.strict && warnings > 0))
}
